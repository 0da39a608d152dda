/* SPDX-License-Identifier: MIT */
/* As much of libgpiod 2 as hal/linux/gpio_v2.c takes, on the machine of a test. What is allocated is counted as lines
 * that are held: a leak shows. */
#ifndef GPIOD_V2_H
#define GPIOD_V2_H

#include "../linux_machine.h"

#include <stdbool.h>

struct gpiod_chip {
    int open;
};
struct gpiod_chip_info {
    int open;
};
struct gpiod_line_info {
    unsigned offset;
};
struct gpiod_line_settings {
    int direction, edge, bias, value;
};
struct gpiod_line_config {
    uint32_t lines, outputs, levels;
};
struct gpiod_request_config {
    const char *consumer;
};
struct gpiod_line_request {
    uint32_t lines;
};
struct gpiod_edge_event {
    unsigned line;
    int level;
};
struct gpiod_edge_event_buffer {
    struct gpiod_edge_event event[MACHINE_EDGES];
};
enum gpiod_line_value { GPIOD_LINE_VALUE_ERROR = -1, GPIOD_LINE_VALUE_INACTIVE, GPIOD_LINE_VALUE_ACTIVE };
enum gpiod_line_direction { GPIOD_LINE_DIRECTION_INPUT = 2, GPIOD_LINE_DIRECTION_OUTPUT };
enum gpiod_line_edge { GPIOD_LINE_EDGE_BOTH = 4 };
enum gpiod_line_bias { GPIOD_LINE_BIAS_PULL_UP = 4, GPIOD_LINE_BIAS_PULL_DOWN };
enum gpiod_edge_event_type { GPIOD_EDGE_EVENT_RISING_EDGE = 1, GPIOD_EDGE_EVENT_FALLING_EDGE };

static void *gpiod_new(size_t size)
{
    void *made = machine_fails() ? NULL : calloc(1, size);
    machine.chips += made != NULL;
    return made;
}

static void gpiod_free(void *made)
{
    machine.chips--;
    free(made);
}

static struct gpiod_chip *gpiod_chip_open(const char *path)
{
    return machine_open(path) == 0 ? calloc(1, sizeof(struct gpiod_chip)) : NULL;
}

static void gpiod_chip_close(struct gpiod_chip *chip)
{
    gpiod_free(chip);
}

static struct gpiod_chip_info *gpiod_chip_get_info(struct gpiod_chip *chip)
{
    (void)chip;
    return gpiod_new(sizeof(struct gpiod_chip_info));
}

static const char *gpiod_chip_info_get_label(struct gpiod_chip_info *info)
{
    (void)info;
    return MACHINE_LABEL;
}

static size_t gpiod_chip_info_get_num_lines(struct gpiod_chip_info *info)
{
    (void)info;
    return MACHINE_LINES;
}

static void gpiod_chip_info_free(struct gpiod_chip_info *info)
{
    gpiod_free(info);
}

static int gpiod_chip_get_line_offset_from_name(struct gpiod_chip *chip, const char *name)
{
    (void)chip;
    return machine_fails() ? -1 : machine_name(name);
}

static struct gpiod_line_info *gpiod_chip_get_line_info(struct gpiod_chip *chip, unsigned offset)
{
    (void)chip;
    struct gpiod_line_info *info = gpiod_new(sizeof *info);
    if (info)
        info->offset = offset;
    return info;
}

static bool gpiod_line_info_is_used(struct gpiod_line_info *info)
{
    return machine.holder[info->offset] || machine.taken >> info->offset & 1;
}

static const char *gpiod_line_info_get_consumer(struct gpiod_line_info *info)
{
    return machine.holder[info->offset];
}

static void gpiod_line_info_free(struct gpiod_line_info *info)
{
    gpiod_free(info);
}

static struct gpiod_line_settings *gpiod_line_settings_new(void)
{
    return gpiod_new(sizeof(struct gpiod_line_settings));
}

static void gpiod_line_settings_free(struct gpiod_line_settings *settings)
{
    gpiod_free(settings);
}

static int gpiod_set(int *member, int value)
{
    *member = value;
    return machine_fails() ? -1 : 0;
}

static int gpiod_line_settings_set_direction(struct gpiod_line_settings *settings, enum gpiod_line_direction direction)
{
    return gpiod_set(&settings->direction, direction);
}

static int gpiod_line_settings_set_edge_detection(struct gpiod_line_settings *settings, enum gpiod_line_edge edge)
{
    return gpiod_set(&settings->edge, edge);
}

static int gpiod_line_settings_set_bias(struct gpiod_line_settings *settings, enum gpiod_line_bias bias)
{
    return gpiod_set(&settings->bias, bias);
}

static int gpiod_line_settings_set_output_value(struct gpiod_line_settings *settings, enum gpiod_line_value value)
{
    return gpiod_set(&settings->value, value);
}

static struct gpiod_line_config *gpiod_line_config_new(void)
{
    return gpiod_new(sizeof(struct gpiod_line_config));
}

static void gpiod_line_config_free(struct gpiod_line_config *config)
{
    gpiod_free(config);
}

static int gpiod_line_config_add_line_settings(struct gpiod_line_config *config, const unsigned *offsets, size_t count,
                                               struct gpiod_line_settings *settings)
{
    for (size_t i = 0; i < count; i++) {
        config->lines |= 1u << offsets[i];
        config->outputs |= (settings->direction == GPIOD_LINE_DIRECTION_OUTPUT ? 1u : 0) << offsets[i];
        config->levels |= (settings->value ? 1u : 0) << offsets[i];
    }
    return machine_fails() ? -1 : 0;
}

static struct gpiod_request_config *gpiod_request_config_new(void)
{
    return gpiod_new(sizeof(struct gpiod_request_config));
}

static void gpiod_request_config_free(struct gpiod_request_config *config)
{
    gpiod_free(config);
}

static void gpiod_request_config_set_consumer(struct gpiod_request_config *config, const char *consumer)
{
    config->consumer = consumer;
}

static struct gpiod_line_request *gpiod_chip_request_lines(struct gpiod_chip *chip,
                                                           struct gpiod_request_config *request,
                                                           struct gpiod_line_config *config)
{
    (void)chip, (void)request;
    if (machine_take(config->lines) != 0)
        return NULL;
    struct gpiod_line_request *made = calloc(1, sizeof *made);
    machine.chips++;
    made->lines = config->lines;
    machine_drive(config->outputs, config->levels);
    return made;
}

static void gpiod_line_request_release(struct gpiod_line_request *request)
{
    machine.taken &= ~(int)request->lines;
    gpiod_free(request);
}

static int gpiod_line_request_set_values_subset(struct gpiod_line_request *request, size_t count,
                                                const unsigned *offsets, const enum gpiod_line_value *values)
{
    uint32_t lines = 0, levels = 0;
    (void)request;
    if (machine_fails())
        return -1;
    for (size_t i = 0; i < count; i++) {
        lines |= 1u << offsets[i];
        levels |= (values[i] == GPIOD_LINE_VALUE_ACTIVE ? 1u : 0) << offsets[i];
    }
    machine_drive(lines, levels);
    return 0;
}

static int gpiod_line_request_get_values_subset(struct gpiod_line_request *request, size_t count,
                                                const unsigned *offsets, enum gpiod_line_value *values)
{
    (void)request;
    for (size_t i = 0; i < count; i++)
        values[i] = machine.levels >> offsets[i] & 1 ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
    return machine_fails() ? -1 : 0;
}

static struct gpiod_edge_event_buffer *gpiod_edge_event_buffer_new(size_t capacity)
{
    (void)capacity;
    return gpiod_new(sizeof(struct gpiod_edge_event_buffer));
}

static void gpiod_edge_event_buffer_free(struct gpiod_edge_event_buffer *buffer)
{
    gpiod_free(buffer);
}

static int gpiod_line_request_wait_edge_events(struct gpiod_line_request *request, int64_t timeout_ns)
{
    (void)timeout_ns;
    return machine_fails() ? -1 : machine_edge(request->lines) >= 0;
}

static int gpiod_line_request_read_edge_events(struct gpiod_line_request *request,
                                               struct gpiod_edge_event_buffer *buffer, size_t most)
{
    int count = 0, place;
    if (machine_fails())
        return -1;
    while (count < (int)most && (place = machine_edge(request->lines)) >= 0) {
        buffer->event[count].line = machine.edges[place].line;
        buffer->event[count++].level = machine.edges[place].level;
        machine_edge_read(place);
    }
    return count;
}

static struct gpiod_edge_event *gpiod_edge_event_buffer_get_event(struct gpiod_edge_event_buffer *buffer,
                                                                  unsigned long index)
{
    return buffer->event + index;
}

static unsigned gpiod_edge_event_get_line_offset(struct gpiod_edge_event *event)
{
    return event->line;
}

static enum gpiod_edge_event_type gpiod_edge_event_get_event_type(struct gpiod_edge_event *event)
{
    return event->level ? GPIOD_EDGE_EVENT_RISING_EDGE : GPIOD_EDGE_EVENT_FALLING_EDGE;
}

#endif
