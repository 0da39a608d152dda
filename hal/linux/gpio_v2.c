/* SPDX-License-Identifier: MIT */
/* libgpiod 2. */
#include "linux/gpio.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>

int gpio_open(struct gpio *gpio, const char *path)
{
    *gpio = (struct gpio){.chip = gpiod_chip_open(path)};
    struct gpiod_chip_info *info = gpio->chip ? gpiod_chip_get_info(gpio->chip) : NULL;
    if (!info)
        return -errno;
    snprintf(gpio->label, sizeof gpio->label, "%s", gpiod_chip_info_get_label(info));
    gpio->available = (unsigned)gpiod_chip_info_get_num_lines(info);
    gpiod_chip_info_free(info);
    return 0;
}

int gpio_find(struct gpio *gpio, const char *name)
{
    int offset = gpiod_chip_get_line_offset_from_name(gpio->chip, name);
    return offset < 0 ? -errno : offset;
}

int gpio_holder(struct gpio *gpio, unsigned offset, char *text, unsigned size)
{
    struct gpiod_line_info *info = gpiod_chip_get_line_info(gpio->chip, offset);
    int used = info && gpiod_line_info_is_used(info);
    if (used) {
        const char *consumer = gpiod_line_info_get_consumer(info);
        snprintf(text, size, "%s", consumer ? consumer : "the kernel");
    }
    if (info)
        gpiod_line_info_free(info);
    return used;
}

static enum gpiod_line_value gpio_value(uint32_t levels, unsigned line)
{
    return levels >> line & 1 ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
}

/* How the lines are to be: all alike, but for the level of outputs. */
static int gpio_configure(struct gpio *gpio, struct gpiod_line_config *config, struct gpiod_line_settings *settings,
                          enum gpio_use use, uint32_t levels)
{
    int result = gpiod_line_settings_set_direction(settings, use == GPIO_OUTPUTS ? GPIOD_LINE_DIRECTION_OUTPUT
                                                                                 : GPIOD_LINE_DIRECTION_INPUT);
    if (!result && use != GPIO_OUTPUTS)
        result = gpiod_line_settings_set_edge_detection(settings, GPIOD_LINE_EDGE_BOTH);
    if (!result && use != GPIO_OUTPUTS)
        result = gpiod_line_settings_set_bias(settings, use == GPIO_PULLED_UP ? GPIOD_LINE_BIAS_PULL_UP
                                                                              : GPIOD_LINE_BIAS_PULL_DOWN);
    for (unsigned i = 0; i < gpio->count && !result; i++) {
        if (use == GPIO_OUTPUTS)
            result = gpiod_line_settings_set_output_value(settings, gpio_value(levels, i));
        if (!result)
            result = gpiod_line_config_add_line_settings(config, gpio->offset + i, 1, settings);
    }
    return result;
}

int gpio_take(struct gpio *gpio, enum gpio_use use, uint32_t levels)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    struct gpiod_line_config *config = settings ? gpiod_line_config_new() : NULL;
    struct gpiod_request_config *request = config ? gpiod_request_config_new() : NULL;
    if (request && gpio_configure(gpio, config, settings, use, levels) == 0) {
        gpiod_request_config_set_consumer(request, GPIO_CONSUMER);
        gpio->request = gpiod_chip_request_lines(gpio->chip, request, config);
        if (gpio->request && use != GPIO_OUTPUTS)
            gpio->events = gpiod_edge_event_buffer_new(GPIO_LINES);
    }
    int reason = gpio->request && (gpio->events || use == GPIO_OUTPUTS) ? 0 : -errno;
    if (request)
        gpiod_request_config_free(request);
    if (config)
        gpiod_line_config_free(config);
    if (settings)
        gpiod_line_settings_free(settings);
    return reason;
}

int gpio_set(struct gpio *gpio, uint32_t levels)
{
    enum gpiod_line_value values[GPIO_LINES];
    for (unsigned i = 0; i < gpio->count; i++)
        values[i] = gpio_value(levels, i);
    return gpiod_line_request_set_values_subset(gpio->request, gpio->count, gpio->offset, values) == 0 ? 0 : -errno;
}

int gpio_get(struct gpio *gpio, uint32_t *levels)
{
    enum gpiod_line_value values[GPIO_LINES];
    uint32_t found = 0;
    if (gpiod_line_request_get_values_subset(gpio->request, gpio->count, gpio->offset, values) != 0)
        return -errno;
    for (unsigned i = 0; i < gpio->count; i++)
        found |= (values[i] == GPIOD_LINE_VALUE_ACTIVE ? 1u : 0) << i;
    *levels = found;
    return 0;
}

int gpio_edge(struct gpio *gpio, unsigned *index, int *level)
{
    if (gpio->at == gpio->pending) {
        int result = gpiod_line_request_wait_edge_events(gpio->request, 0);
        if (result > 0)
            result = gpiod_line_request_read_edge_events(gpio->request, gpio->events, GPIO_LINES);
        if (result <= 0)
            return result < 0 ? -errno : 0;
        gpio->pending = (unsigned)result;
        gpio->at = 0;
    }
    struct gpiod_edge_event *event = gpiod_edge_event_buffer_get_event(gpio->events, gpio->at++);
    unsigned offset = gpiod_edge_event_get_line_offset(event);
    for (*index = 0; gpio->offset[*index] != offset;)
        ++*index;
    *level = gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE;
    return 1;
}

void gpio_close(struct gpio *gpio)
{
    if (gpio->request)
        gpiod_line_request_release(gpio->request);
    if (gpio->events)
        gpiod_edge_event_buffer_free(gpio->events);
    if (gpio->chip)
        gpiod_chip_close(gpio->chip);
    *gpio = (struct gpio){0};
}
