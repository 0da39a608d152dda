/* SPDX-License-Identifier: MIT */
/*
 * The function of a USB gadget: one interface of a vendor's class, 47 01, with a bulk endpoint either way, at full,
 * high and super speed. Windows binds WinUSB to it by itself (Microsoft OS descriptors 1.0; a BOS, which 2.0 wants, is
 * the kernel's own and not to be extended).
 */
#ifndef HAL_LINUX_FFS_H
#define HAL_LINUX_FFS_H

#include "linux/problem.h"

#include <stdint.h>

#define FFS_PACKET 64u /* bytes: of full speed, and a divisor of the others' 512 and 1024 */

enum ffs_event {
    FFS_NOTHING, /* that concerns the stream */
    FFS_COMES,   /* a host has configured it, anew if there was one */
    FFS_GOES,
    FFS_STOPPED, /* by ffs_stop() */
    FFS_BROKEN,  /* the kernel does not say */
};

/* Descriptors of files, -1: not open. */
struct ffs {
    int control, in, out; /* in: to the host, as USB has it */
    int stop;
};

/* Tells the kernel what the function is, and opens its files in `folder`: 0, or HAL_E_IO and the problem, with nothing
 * held. */
int ffs_open(struct ffs *ffs, const char *folder, struct problem *problem);

/* Waits for the next event; requests that a host may make beside are refused, as USB has it. */
enum ffs_event ffs_next(struct ffs *ffs);

/* Ends the wait, now or next. */
void ffs_stop(struct ffs *ffs);

/* How many bytes went, or came; a negative errno. Both wait for the host; without one the answer is -EAGAIN or
 * -ESHUTDOWN at once. */
long ffs_send(struct ffs *ffs, const void *bytes, uint32_t count);
long ffs_receive(struct ffs *ffs, void *bytes, uint32_t count);

void ffs_close(struct ffs *ffs);

#endif
