/* SPDX-License-Identifier: MIT */
/* A serial line. One implementation is linked: the machine's. */
#ifndef HAL_SERIAL_H
#define HAL_SERIAL_H

#include <stdint.h>

/* Bytes that can wait to be read: at 115,200 baud, 44 ms of a line that never pauses. */
#define SERIAL_WAITING 512u

/* Sends bytes; returns when the transmitter has them all. */
void serial_write(const void *bytes, uint32_t count);

/* Takes what has come, at most `size` bytes: how many. Does not wait: an interrupt has collected them. */
uint32_t serial_read(void *bytes, uint32_t size);

/* Bytes lost since start: nobody read for too long, or they were damaged on the line. */
uint32_t serial_lost(void);

#endif
