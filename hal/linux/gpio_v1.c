/* SPDX-License-Identifier: MIT */
/* libgpiod 1.6. */
#include "linux/gpio.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <time.h>

static struct gpiod_line_bulk gpio_bulk(const struct gpio *gpio)
{
    struct gpiod_line_bulk bulk = {.num_lines = gpio->count};
    for (unsigned i = 0; i < gpio->count; i++)
        bulk.lines[i] = gpio->line[i];
    return bulk;
}

static void gpio_levels(const struct gpio *gpio, uint32_t levels, int values[GPIO_LINES])
{
    for (unsigned i = 0; i < gpio->count; i++)
        values[i] = levels >> i & 1;
}

int gpio_open(struct gpio *gpio, const char *path)
{
    *gpio = (struct gpio){.chip = gpiod_chip_open(path)};
    if (!gpio->chip)
        return -errno;
    snprintf(gpio->label, sizeof gpio->label, "%s", gpiod_chip_label(gpio->chip));
    gpio->available = gpiod_chip_num_lines(gpio->chip);
    return 0;
}

int gpio_find(struct gpio *gpio, const char *name)
{
    struct gpiod_line *line = gpiod_chip_find_line(gpio->chip, name);
    return line ? (int)gpiod_line_offset(line) : -errno;
}

int gpio_holder(struct gpio *gpio, unsigned offset, char *text, unsigned size)
{
    struct gpiod_line *line = gpiod_chip_get_line(gpio->chip, offset);
    if (!line || !gpiod_line_is_used(line))
        return 0;
    const char *consumer = gpiod_line_consumer(line);
    snprintf(text, size, "%s", consumer ? consumer : "the kernel");
    return 1;
}

int gpio_take(struct gpio *gpio, enum gpio_use use, uint32_t levels)
{
    struct gpiod_line_request_config config = {.consumer = GPIO_CONSUMER};
    int values[GPIO_LINES];
    for (unsigned i = 0; i < gpio->count; i++)
        if (!(gpio->line[i] = gpiod_chip_get_line(gpio->chip, gpio->offset[i])))
            return -errno;
    struct gpiod_line_bulk bulk = gpio_bulk(gpio);
    gpio_levels(gpio, levels, values);
    config.request_type =
        use == GPIO_OUTPUTS ? GPIOD_LINE_REQUEST_DIRECTION_OUTPUT : GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES;
    if (use != GPIO_OUTPUTS)
        config.flags =
            use == GPIO_PULLED_UP ? GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP : GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN;
    return gpiod_line_request_bulk(&bulk, &config, use == GPIO_OUTPUTS ? values : NULL) == 0 ? 0 : -errno;
}

int gpio_set(struct gpio *gpio, uint32_t levels)
{
    struct gpiod_line_bulk bulk = gpio_bulk(gpio);
    int values[GPIO_LINES];
    gpio_levels(gpio, levels, values);
    return gpiod_line_set_value_bulk(&bulk, values) == 0 ? 0 : -errno;
}

/* Line by line: lines that note edges have a descriptor each. */
int gpio_get(struct gpio *gpio, uint32_t *levels)
{
    uint32_t found = 0;
    for (unsigned i = 0; i < gpio->count; i++) {
        int value = gpiod_line_get_value(gpio->line[i]);
        if (value < 0)
            return -errno;
        found |= (uint32_t)value << i;
    }
    *levels = found;
    return 0;
}

int gpio_edge(struct gpio *gpio, unsigned *index, int *level)
{
    struct gpiod_line_bulk bulk = gpio_bulk(gpio), ready = {0};
    struct gpiod_line_event event;
    int result = gpiod_line_event_wait_bulk(&bulk, &(const struct timespec){0}, &ready);
    if (result <= 0)
        return result < 0 ? -errno : 0;
    if (gpiod_line_event_read(ready.lines[0], &event) != 0)
        return -errno;
    for (*index = 0; gpio->line[*index] != ready.lines[0];)
        ++*index;
    *level = event.event_type == GPIOD_LINE_EVENT_RISING_EDGE;
    return 1;
}

void gpio_close(struct gpio *gpio)
{
    if (gpio->chip)
        gpiod_chip_close(gpio->chip); /* and with it its lines */
    *gpio = (struct gpio){0};
}
