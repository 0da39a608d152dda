/* SPDX-License-Identifier: MIT */
/* What a USB host is told of this machine. */
#ifndef BOARDS_LINUX_NAME_H
#define BOARDS_LINUX_NAME_H

#include <stddef.h>

/* A serial number that stays: the device tree's, as every Raspberry Pi has one, else a sum of the installation's id,
 * which is not to be told to others, else "0". */
void name_serial(char *serial, size_t size);

#endif
