/* SPDX-License-Identifier: MIT */
/* Bytes out over GPIO lines, two calls of the kernel a bit: for small panels where there is no SPI. */
#ifndef HAL_LINUX_BITBANG_H
#define HAL_LINUX_BITBANG_H

#include "linux/pins.h"

struct bitbang {
    struct gpio gpio;
    unsigned mode;
    uint8_t selects; /* there is a chip select */
};

/* Takes the lines; cs may be null. 0, or HAL_E_IO and the problem. Mode 0..3. */
int bitbang_open(struct bitbang *bitbang, const char *chip, const char *sck, const char *mosi, const char *cs,
                 unsigned mode, struct problem *problem);
int bitbang_send(struct bitbang *bitbang, const uint8_t *bytes, uint32_t count, struct problem *problem);
void bitbang_close(struct bitbang *bitbang);

#endif
