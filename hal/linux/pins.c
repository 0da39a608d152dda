/* SPDX-License-Identifier: MIT */
#include "linux/pins.h"
#include "display.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PATH_SIZE 64

static int pins_is(const char *wanted, size_t length, const char *name)
{
    return strlen(name) == length && strncmp(wanted, name, length) == 0;
}

/* Opens the chip of this path, name or label: 0 or a negative errno. -EACCES if one could not be looked at. */
static int pins_open(struct gpio *gpio, const char *wanted, size_t length)
{
    char path[PATH_SIZE];
    int reason = -ENODEV;
    for (unsigned i = 0; i < PINS_CHIPS; i++) {
        snprintf(path, sizeof path, "/dev/gpiochip%u", i);
        int result = gpio_open(gpio, path);
        if (!result && (pins_is(wanted, length, path) || pins_is(wanted, length, path + strlen("/dev/")) ||
                        pins_is(wanted, length, gpio->label)))
            return 0;
        gpio_close(gpio);
        if (result && result != -ENOENT)
            reason = result;
    }
    return reason;
}

static int pins_chip(struct gpio *gpio, const char *chip, struct problem *problem)
{
    int result = -ENODEV, reason = -ENODEV;
    for (const char *at = chip; result; at++) {
        size_t length = strcspn(at, ",");
        result = pins_open(gpio, at, length);
        if (result != -ENODEV)
            reason = result;
        at += length;
        if (!*at)
            break;
    }
    if (!result)
        return 0;
    if (reason == -ENODEV)
        return problem_set(problem, "there is no GPIO chip '%s'; --list shows those there are", chip);
    if (reason == -EACCES || reason == -EPERM)
        return problem_set(problem, "GPIO chip '%s': %s; /dev/gpiochip* want root, or the group that owns them (gpio)",
                           chip, strerror(-reason));
    return problem_set(problem, "GPIO chip '%s': %s", chip, strerror(-reason));
}

static int pins_line(struct gpio *gpio, const char *line, struct problem *problem)
{
    char *end;
    unsigned long offset = strtoul(line, &end, 10);
    if (*line >= '0' && *line <= '9' && !*end) {
        if (offset >= gpio->available)
            return problem_set(problem, "GPIO chip '%s' has no line %s, only 0 to %u", gpio->label, line,
                               gpio->available - 1);
    } else {
        int found = gpio_find(gpio, line);
        if (found == -ENOENT)
            return problem_set(problem, "GPIO chip '%s' has no line '%s'; --list shows their names", gpio->label, line);
        if (found < 0)
            return problem_set(problem, "GPIO line '%s' of '%s': %s", line, gpio->label, strerror(-found));
        offset = (unsigned long)found;
    }
    for (unsigned i = 0; i < gpio->count; i++)
        if (gpio->offset[i] == offset)
            return problem_set(problem, "GPIO line %s is to be two things", line);
    gpio->offset[gpio->count++] = (unsigned)offset;
    return 0;
}

/* A request for several lines does not say which of them it was. */
static int pins_refused(struct gpio *gpio, int reason, struct problem *problem)
{
    char holder[64];
    for (unsigned i = 0; i < gpio->count && reason == -EBUSY; i++)
        if (gpio_holder(gpio, gpio->offset[i], holder, sizeof holder))
            return problem_set(problem, "GPIO line %u of '%s' is taken by '%s'", gpio->offset[i], gpio->label, holder);
    return problem_set(problem, "GPIO lines of '%s': %s", gpio->label, strerror(-reason));
}

int pins_take(struct gpio *gpio, const char *chip, const char *const lines[], unsigned count, enum gpio_use use,
              uint32_t levels, struct problem *problem)
{
    int error = pins_chip(gpio, chip, problem);
    for (unsigned i = 0; i < count && !error; i++)
        error = pins_line(gpio, lines[i], problem);
    if (!error) {
        int result = gpio_take(gpio, use, levels);
        error = result ? pins_refused(gpio, result, problem) : 0;
    }
    if (error)
        gpio_close(gpio);
    return error;
}

void pins_chips(void (*each)(const char *path, const struct gpio *gpio, void *context), void *context)
{
    struct gpio gpio;
    char path[PATH_SIZE];
    for (unsigned i = 0; i < PINS_CHIPS; i++) {
        snprintf(path, sizeof path, "/dev/gpiochip%u", i);
        if (gpio_open(&gpio, path) == 0)
            each(path, &gpio, context);
        gpio_close(&gpio);
    }
}
