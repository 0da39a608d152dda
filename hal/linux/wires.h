/* SPDX-License-Identifier: MIT */
/*
 * The bus of a panel on Linux: bytes by spidev or over GPIO lines, D/C, reset and backlight by GPIO lines. Pixels are
 * copied and sent by a thread, so that the next band is drawn meanwhile.
 *
 * A line's level is kept while its chip is held. wires_close() leaves the backlight off and the panel in reset before
 * it gives the lines back; what they do then is the chip's driver's affair (on a Raspberry Pi they become inputs, which
 * the Pi or the module pulls; newer kernels keep them). After a crash or SIGKILL the kernel gives them back as they
 * are: `glint-device --off` mends that.
 */
#ifndef HAL_LINUX_WIRES_H
#define HAL_LINUX_WIRES_H

#include "bus.h"
#include "linux/bitbang.h"
#include "linux/spidev.h"

#include <pthread.h>

#define WIRES_BUFFER 32768u /* bytes: a band of 240x60 RGB565 in one piece */

struct wires_pin {
    const char *line; /* null: there is none */
    uint8_t inverted; /* 1: low is on */
};

struct wires_config {
    const char *chip;
    const char *spi; /* a device's path; null: sck, mosi and cs, which may be null, are lines of the chip */
    const char *sck, *mosi, *cs;
    struct wires_pin dc, reset, backlight; /* reset: inverted means that high resets */
    uint32_t speed;                        /* Hz, of spidev */
    uint8_t mode;
};

struct wires {
    struct hal_bus bus; /* first: to be given to a panel */
    struct hal_bus_ops ops;
    struct problem problem; /* why an operation failed, until one succeeds */

    /* its own */
    struct spidev spi;
    struct bitbang bitbang;
    struct gpio control;
    uint32_t levels, inverted;   /* of the control lines */
    int8_t dc, reset, backlight; /* their bits; -1: none */
    uint8_t banged, taken, threaded;

    pthread_t thread;
    pthread_mutex_t mutex;
    pthread_cond_t change;
    uint32_t waiting; /* bytes of buffer[sending] that the thread is to send; 0: it is idle */
    uint8_t sending, stop;
    int failed;
    uint8_t buffer[2][WIRES_BUFFER];
};

/* 0, or HAL_E_IO and wires->problem, with nothing held. The backlight is off, the panel in reset. */
int wires_open(struct wires *wires, const struct wires_config *config);

/* Backlight off, panel in reset, all given back. 0, or HAL_E_IO and the problem: it is all given back nevertheless. */
int wires_close(struct wires *wires);

#endif
