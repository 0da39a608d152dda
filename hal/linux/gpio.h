/* SPDX-License-Identifier: MIT */
/*
 * What is needed of libgpiod, the same over both of its interfaces: gpio_v1.c (1.6) or gpio_v2.c (2.x) is linked, as
 * pkg-config says. A `struct gpio` is a chip and the lines that were taken of it together. Functions return 0 or more,
 * or a negative errno. pins.h finds chips and explains errors.
 */
#ifndef HAL_LINUX_GPIO_H
#define HAL_LINUX_GPIO_H

#include <stdint.h>

#define GPIO_LINES    16
#define GPIO_CONSUMER "glint" /* as gpioinfo shows who has a line */

struct gpio {
    char label[48];     /* of the chip */
    unsigned available; /* its lines */
    unsigned count;     /* the lines that were taken, and their offsets in the chip */
    unsigned offset[GPIO_LINES];

    /* the library's */
    void *chip, *request, *events;
    void *line[GPIO_LINES];
    unsigned pending, at;
};

/* Opens a chip by its path: chip, label and available. */
int gpio_open(struct gpio *gpio, const char *path);

/* The offset of the line of that name: -ENOENT if there is none. */
int gpio_find(struct gpio *gpio, const char *name);

/* Writes who has a line to `text`: 0 if nobody has. */
int gpio_holder(struct gpio *gpio, unsigned offset, char *text, unsigned size);

/* Takes gpio->count lines at gpio->offset[], all or none: as outputs with these levels (bit i: line i), or as inputs
 * pulled up, or down, where the chip can, whose edges are noted. */
enum gpio_use { GPIO_OUTPUTS, GPIO_PULLED_UP, GPIO_PULLED_DOWN };
int gpio_take(struct gpio *gpio, enum gpio_use use, uint32_t levels);

int gpio_set(struct gpio *gpio, uint32_t levels);
int gpio_get(struct gpio *gpio, uint32_t *levels);

/* The next edge that was noted, if there is one, without waiting: 1, the line's index and its level after the edge. */
int gpio_edge(struct gpio *gpio, unsigned *index, int *level);

/* Gives everything back; also after a failed gpio_open() or gpio_take(), and twice. Outputs keep their level only if
 * the chip's driver lets them. */
void gpio_close(struct gpio *gpio);

#endif
