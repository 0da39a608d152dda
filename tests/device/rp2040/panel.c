/* SPDX-License-Identifier: MIT */
/*
 * Draws a frame for the drawing alone, then to the panel, and says on the UART when each begins and ends.
 * The line "SCENE METHOD TABLES ROWS" on the UART says what.
 */
#include "bus.h"
#include "clock.h"
#include "cortexm/machine.h"
#include "rp2040/rp2040.h"
#include "tests/device/program.h"

#define SIZE       240u
#define MEMORY     (160u * 1024u)
#define BAND       (SIZE * 24u) /* pixels */
#define WAIT_US    50000u
#define LINE_BYTES 33u

static uint32_t panel_memory[MEMORY / 4];
static uint16_t panel_bands[2][BAND];

int main(void);

void program_write(const char *text)
{
    machine_write(text);
}

/* Commands of the ST7789, each with its number of parameters and the wait after it in ms. */
static const uint8_t panel_init[] = {
    0x01, 0, 150, 0x36, 1, 0, 0x04, 0x3A, 1, 0, 0x05, 0x21, 0, 0, 0x11, 0, 120, 0x29, 0, 1,
};

static void panel_command(struct hal_bus *bus, uint8_t command, const uint8_t *parameters, uint32_t count)
{
    bus->ops->write(bus, HAL_BUS_COMMAND, &command, 1);
    if (count)
        bus->ops->write(bus, HAL_BUS_DATA, parameters, count);
}

static void panel_start(struct hal_bus *bus)
{
    bus->ops->reset(bus, 0);
    clock_wait_us(100);
    bus->ops->reset(bus, 1);
    clock_wait_us(150000);
    for (const uint8_t *p = panel_init; p < panel_init + sizeof panel_init; p += 3 + p[1]) {
        uint32_t wait = p[2];
        panel_command(bus, p[0], p + 3, p[1]);
        clock_wait_us(wait * 1000);
    }
}

static void panel_window(struct hal_bus *bus, uint16_t y, uint16_t rows)
{
    const uint8_t columns[4] = {0, 0, 0, SIZE - 1};
    const uint8_t lines[4] = {0, (uint8_t)y, 0, (uint8_t)(y + rows - 1)};
    panel_command(bus, 0x2A, columns, sizeof columns);
    panel_command(bus, 0x2B, lines, sizeof lines);
    panel_command(bus, 0x2C, 0, 0);
}

/* A frame, sent where there is a bus: while a band is on its way, the next is drawn into the other buffer. */
static int panel_frame(struct glint_frame *frame, const void *scene, struct hal_bus *bus)
{
    struct glint_band band;
    int error = glint_frame_begin(frame, scene, 0);
    while (error == 0 && glint_frame_next_band(frame, &band)) {
        if (!bus)
            continue;
        panel_window(bus, band.y, band.rows);
        bus->ops->pixels(bus, band.pixels, 2, SIZE, band.rows, band.stride);
    }
    if (bus)
        bus->ops->wait(bus);
    return error;
}

static int panel_run(const struct program_scene *scene, const struct glint_method *method, unsigned tables,
                     unsigned rows)
{
    struct glint_config config = {.width = SIZE, .height = SIZE, .format = GLINT_RGB565};
    struct glint_frame frame;
    struct hal_bus *bus = rp2040_bus();
    if (rows > BAND / SIZE || glint_scene_check(scene->blob, *scene->length) != 0)
        return 2;
    glint_fit_stores(&config, scene->blob);
    config.band_rows = (uint16_t)rows;
    config.method = method;
    config.tables = (uint8_t)tables;
    config.band[0] = panel_bands[0];
    config.band[1] = panel_bands[1];
    config.memory = panel_memory;
    config.memory_bytes = sizeof panel_memory;
    if (glint_init(&frame, &config) != 0)
        return 2;
    panel_start(bus);
    if (panel_frame(&frame, scene->blob, 0) != 0) /* makes the colour tables */
        return 2;
    program_write("draw\n");
    if (panel_frame(&frame, scene->blob, 0) != 0)
        return 2;
    program_write("drawn\nshow\n");
    if (panel_frame(&frame, scene->blob, bus) != 0)
        return 2;
    program_write("shown\n");
    bus->ops->backlight(bus, 255);
    return frame.stats.dropped ? 1 : 0;
}

/* The next word of the line, which it ends. */
static char *panel_word(char **at)
{
    char *word = *at;
    while (**at && **at != ' ')
        ++*at;
    if (**at)
        *(*at)++ = 0;
    return word;
}

int main(void)
{
    char line[LINE_BYTES], *at = line;
    rp2040_start();
    clock_wait_us(WAIT_US); /* for the line to come */
    if (machine_command_line(line, sizeof line) != 0)
        return 2;
    const char *scene = panel_word(&at), *method = panel_word(&at);
    unsigned tables = text_number(panel_word(&at)), rows = text_number(panel_word(&at));
    for (unsigned s = 0; s < program_scene_count; s++)
        for (unsigned m = 0; m < glint_choice_count; m++)
            if (text_equal(scene, program_scenes[s].name) && text_equal(method, glint_choices[m].name))
                return panel_run(&program_scenes[s], glint_choices[m].method, tables, rows);
    program_write("error: no such scene or method\n");
    return 2;
}
