/* SPDX-License-Identifier: MIT */
/*
 * The machine as a USB device: a gadget of the kernel's configfs with one function, whose files (FunctionFS) are
 * mounted for ffs.h. There is one of its name on a machine; what a crash left of it is cleared away.
 */
#ifndef HAL_LINUX_GADGET_H
#define HAL_LINUX_GADGET_H

#include "linux/problem.h"

#define GADGET_FILES "/dev/glint-usb" /* where the function's files are while it is open */
#define GADGET_NAME  128u

struct gadget_config {
    const char *udc;     /* device controller; null: the first in /sys/class/udc */
    const char *product; /* strings that a host is told, ASCII */
    const char *serial;
};

/* All zeros at first. */
struct gadget {
    char udc[GADGET_NAME];
    unsigned made; /* how far it has come */
};

/* Makes all but the plug: 0, or HAL_E_IO and the problem, with nothing left behind. */
int gadget_open(struct gadget *gadget, const struct gadget_config *config, struct problem *problem);

/* Plugs it in, when somebody holds the function's files: the same. */
int gadget_plug(struct gadget *gadget, struct problem *problem);

/* Takes it from the bus. Harmless when it is not there. */
void gadget_unplug(struct gadget *gadget);

/* Removes it all, after the function's files were closed. Harmless when not open. */
void gadget_close(struct gadget *gadget);

#endif
