/* SPDX-License-Identifier: MIT */
/*
 * The stream of a device on USB, by libusb. It may come and go: a port that is open waits for it. All happens in the
 * functions of the port, in the caller's thread; a callback only notes what has come.
 */
#ifndef VIEW_USB_H
#define VIEW_USB_H

#include "view/port.h"

/* The device of that serial number, or with null the first that is free, and from then on that one. It need not be
 * there yet. An exit code, with a message. */
int usb_open(struct port *port, const char *serial);

#endif
