/* SPDX-License-Identifier: MIT */
/* As much of libgpiod 1.6 as hal/linux/gpio_v1.c takes, on the machine of a test. */
#ifndef GPIOD_V1_H
#define GPIOD_V1_H

#include "../linux_machine.h"

#include <stdbool.h>
#include <time.h>

#define GPIOD_LINE_BULK_MAX_LINES 64

struct gpiod_chip {
    int open;
    uint32_t mine; /* lines taken by it */
};
struct gpiod_line {
    struct gpiod_chip *chip;
    unsigned offset;
};
struct gpiod_line_bulk {
    struct gpiod_line *lines[GPIOD_LINE_BULK_MAX_LINES];
    unsigned int num_lines;
};
enum {
    GPIOD_LINE_REQUEST_DIRECTION_OUTPUT = 3,
    GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES = 6,
    GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN = 16,
    GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP = 32,
};
enum { GPIOD_LINE_EVENT_RISING_EDGE = 1, GPIOD_LINE_EVENT_FALLING_EDGE };
struct gpiod_line_request_config {
    const char *consumer;
    int request_type, flags;
};
struct gpiod_line_event {
    struct timespec ts;
    int event_type;
};

static struct gpiod_chip gpiod_chips[4];
static struct gpiod_line gpiod_lines[4][MACHINE_LINES];

static struct gpiod_chip *gpiod_chip_open(const char *path)
{
    unsigned i = 0;
    if (machine_open(path) != 0)
        return NULL;
    while (gpiod_chips[i].open)
        i++;
    gpiod_chips[i] = (struct gpiod_chip){.open = 1};
    return gpiod_chips + i;
}

static void gpiod_chip_close(struct gpiod_chip *chip)
{
    machine.taken &= ~(int)chip->mine;
    machine.chips--;
    chip->open = 0;
}

static const char *gpiod_chip_label(struct gpiod_chip *chip)
{
    (void)chip;
    return MACHINE_LABEL;
}

static unsigned gpiod_chip_num_lines(struct gpiod_chip *chip)
{
    (void)chip;
    return MACHINE_LINES;
}

static struct gpiod_line *gpiod_chip_get_line(struct gpiod_chip *chip, unsigned offset)
{
    if (machine_fails())
        return NULL;
    struct gpiod_line *line = &gpiod_lines[chip - gpiod_chips][offset];
    *line = (struct gpiod_line){chip, offset};
    return line;
}

static struct gpiod_line *gpiod_chip_find_line(struct gpiod_chip *chip, const char *name)
{
    int offset = machine_name(name);
    return offset < 0 ? NULL : gpiod_chip_get_line(chip, (unsigned)offset);
}

static unsigned gpiod_line_offset(struct gpiod_line *line)
{
    return line->offset;
}

static bool gpiod_line_is_used(struct gpiod_line *line)
{
    return machine.holder[line->offset] || machine.taken >> line->offset & 1;
}

static const char *gpiod_line_consumer(struct gpiod_line *line)
{
    return machine.holder[line->offset];
}

static uint32_t gpiod_bits(const struct gpiod_line_bulk *bulk, const int *values)
{
    uint32_t bits = 0;
    for (unsigned i = 0; i < bulk->num_lines; i++)
        bits |= (!values || values[i] ? 1u : 0u) << bulk->lines[i]->offset;
    return bits;
}

static int gpiod_line_request_bulk(struct gpiod_line_bulk *bulk, const struct gpiod_line_request_config *config,
                                   const int *values)
{
    uint32_t lines = gpiod_bits(bulk, NULL);
    if (machine_take(lines) != 0)
        return -1;
    bulk->lines[0]->chip->mine |= lines;
    if (config->request_type == GPIOD_LINE_REQUEST_DIRECTION_OUTPUT)
        machine_drive(lines, gpiod_bits(bulk, values));
    return 0;
}

static int gpiod_line_set_value_bulk(struct gpiod_line_bulk *bulk, const int *values)
{
    if (machine_fails())
        return -1;
    machine_drive(gpiod_bits(bulk, NULL), gpiod_bits(bulk, values));
    return 0;
}

static int gpiod_line_get_value(struct gpiod_line *line)
{
    return machine_fails() ? -1 : (int)(machine.levels >> line->offset & 1);
}

static int gpiod_line_event_wait_bulk(struct gpiod_line_bulk *bulk, const struct timespec *timeout,
                                      struct gpiod_line_bulk *ready)
{
    (void)timeout;
    if (machine_fails())
        return -1;
    int place = machine_edge(gpiod_bits(bulk, NULL));
    if (place < 0)
        return 0;
    ready->num_lines = 1;
    for (unsigned i = 0; i < bulk->num_lines; i++)
        if (bulk->lines[i]->offset == machine.edges[place].line)
            ready->lines[0] = bulk->lines[i];
    return 1;
}

static int gpiod_line_event_read(struct gpiod_line *line, struct gpiod_line_event *event)
{
    if (machine_fails())
        return -1;
    int place = machine_edge(1u << line->offset);
    event->event_type = machine.edges[place].level ? GPIOD_LINE_EVENT_RISING_EDGE : GPIOD_LINE_EVENT_FALLING_EDGE;
    machine_edge_read(place);
    return 0;
}

#endif
