/* SPDX-License-Identifier: MIT */
/* Lines of a chip as a user names them. */
#ifndef HAL_LINUX_PINS_H
#define HAL_LINUX_PINS_H

#include "linux/gpio.h"
#include "linux/problem.h"

#define PINS_CHIPS 64 /* /dev/gpiochip0 .. 63 are looked at */

/* Opens the chip and takes its lines; HAL_E_IO and the problem, with nothing taken, if that fails. `chip` is a label
 * (as gpiodetect shows in brackets), a name as gpiochip0 or a path, or several with commas between: the first that
 * there is. A line is an offset, or a name as gpioinfo shows. gpio_close() gives them back. */
int pins_take(struct gpio *gpio, const char *chip, const char *const lines[], unsigned count, enum gpio_use use,
              uint32_t levels, struct problem *problem);

/* Calls `each` for every chip that can be opened. */
void pins_chips(void (*each)(const char *path, const struct gpio *gpio, void *context), void *context);

#endif
