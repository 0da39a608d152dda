/* SPDX-License-Identifier: MIT */
/* Bytes out by the kernel's SPI. Chip select is the kernel's too. */
#ifndef HAL_LINUX_SPIDEV_H
#define HAL_LINUX_SPIDEV_H

#include "linux/problem.h"

#include <stdint.h>

struct spidev {
    const char *path;
    int descriptor;
    uint32_t speed, chunk; /* Hz; bytes the kernel takes at a time */
};

/* 0, or HAL_E_IO and the problem. Mode 0..3. */
int spidev_open(struct spidev *spi, const char *path, unsigned mode, uint32_t speed, struct problem *problem);
int spidev_send(struct spidev *spi, const uint8_t *bytes, uint32_t count, struct problem *problem);
void spidev_close(struct spidev *spi);

#endif
