/* SPDX-License-Identifier: MIT */
/* glint-device: the handheld's program on Linux. */
#ifndef BOARDS_LINUX_DEVICE_H
#define BOARDS_LINUX_DEVICE_H

/* The whole program: its exit code. */
int device_run(int argc, char **argv);

#endif
