/* SPDX-License-Identifier: MIT */
/*
 * The wires between a machine and a panel: a serial bus with a data/command line, a reset line and a backlight. A panel
 * (panels/) knows its commands and nothing of the machine; a machine (lm3s/, rp2040/, linux/) knows its pins and
 * nothing of the panel. Each function returns 0 or HAL_E_IO; on a write-only bus a missing panel is not seen.
 */
#ifndef HAL_BUS_H
#define HAL_BUS_H

#include <stdint.h>

struct hal_bus;

enum hal_bus_kind { HAL_BUS_COMMAND, HAL_BUS_DATA }; /* the level of D/C: low, high */

struct hal_bus_ops {
    /* Sends bytes with D/C at that level, and returns when they are on the wire. */
    int (*write)(struct hal_bus *, enum hal_bus_kind, const uint8_t *bytes, uint32_t count);
    /* Sends pixels as data. `word` is 1 (bytes) or 2 (16-bit words in the CPU's order, high byte first on the wire);
     * `rows` rows of `count` words, each `stride` bytes after the one before. May return while they are on their way;
     * the next call of any function waits for them. */
    int (*pixels)(struct hal_bus *, const void *pixels, unsigned word, uint32_t count, uint32_t rows, uint32_t stride);
    /* Returns when all is on the wire. */
    int (*wait)(struct hal_bus *);
    /* Reset line, 0: held in reset. Null where there is none. */
    void (*reset)(struct hal_bus *, int level);
    /* Backlight, 0..255. Null where there is none. */
    void (*backlight)(struct hal_bus *, unsigned level);
    /* Waits for the panel's tearing signal, at most one picture long. Null where there is none. */
    void (*tearing)(struct hal_bus *);
};

/* The first member of every machine's own struct. */
struct hal_bus {
    const struct hal_bus_ops *ops;
};

#endif
