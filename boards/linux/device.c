/* SPDX-License-Identifier: MIT */
#include "boards/linux/device.h"
#include "boards/linux/settings.h"
#include "clock.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>

#define MEMORY (8u << 20) /* for the renderer: 60,000 triangles; what is not used is not there */
#define BANDS  4u         /* a picture: one is sent while the next is drawn */

struct device {
    struct settings settings;
    struct wires wires;
    struct panel panel;
    struct board board;
    void *memory;
};

static void device_print_chip(const char *path, const struct gpio *gpio, void *context)
{
    (void)context;
    printf("  %s [%s] %u lines\n", path, gpio->label, gpio->available);
}

static void device_list(void)
{
    glob_t found;
    printf("panels:\n");
    for (const struct settings_panel *panel = settings_panels; panel->name; panel++)
        printf("  %s\n", panel->name);
    printf("scenes:\n");
    for (unsigned i = 0; i < program_scene_count; i++)
        printf("  %s\n", program_scenes[i].name);
    printf("methods:\n");
    for (unsigned i = 0; i < glint_choice_count; i++)
        printf("  %s\n", glint_choices[i].name);
    printf("GPIO chips:\n");
    pins_chips(device_print_chip, NULL);
    printf("SPI devices:\n");
    if (glob("/dev/spidev*", 0, NULL, &found) == 0) {
        for (size_t i = 0; i < found.gl_pathc; i++)
            printf("  %s\n", found.gl_pathv[i]);
        globfree(&found);
    }
}

static const char *device_panel_name(const struct panel_controller *controller)
{
    const struct settings_panel *panel = settings_panels;
    while (panel->controller != controller)
        panel++;
    return panel->name;
}

/* One block: the renderer's memory, the last picture, two bands. */
static int device_make(struct device *device)
{
    const struct settings *settings = &device->settings;
    int quarter = settings->rotation / 90 & 1;
    uint16_t width = quarter ? settings->height : settings->width,
             height = quarter ? settings->width : settings->height;
    /* even: what an SSD0323 takes at quarter turns */
    uint16_t rows = (uint16_t)(((height + BANDS - 1) / BANDS + 1) & ~1u);
    rows = rows < height ? rows : height;
    size_t picture = ((size_t)2 * width * height + 7) & ~(size_t)7, band = ((size_t)2 * width * rows + 7) & ~(size_t)7;
    uint8_t *memory = device->memory = calloc(1, MEMORY + picture + 2 * band);
    if (!memory) {
        fprintf(stderr, "glint-device: out of memory\n");
        return -1;
    }
    device->panel = (struct panel){.display.ops = &panel_display,
                                   .controller = settings->controller,
                                   .bus = &device->wires.bus,
                                   .width = settings->width,
                                   .height = settings->height,
                                   .offset_x = settings->offset_x,
                                   .offset_y = settings->offset_y,
                                   .rotation = settings->rotation,
                                   .bgr = settings->bgr,
                                   .invert = settings->invert,
                                   .refresh = settings->refresh,
                                   .memory = settings->whole ? NULL : memory + MEMORY,
                                   .memory_size = settings->whole ? 0 : (uint32_t)picture};
    device->board = (struct board){.name = device_panel_name(settings->controller),
                                   .display = &device->panel.display,
                                   .width = width,
                                   .height = height,
                                   .band_rows = rows,
                                   .format = settings->controller->format,
                                   .pack = settings->controller->format == HAL_GREY4 ? &pack_grey4 : &pack_rgb565,
                                   .dither = settings->controller->format == HAL_GREY4,
                                   .band = {memory + MEMORY + picture, memory + MEMORY + picture + band},
                                   .memory = memory,
                                   .memory_bytes = MEMORY};
    return 0;
}

/* Colour bars until somebody ends it: 0, or a HAL_E code. */
static int device_pattern(struct device *device)
{
    const struct board *board = &device->board;
    struct hal_display *display = &device->panel.display;
    int error = display->ops->open(display, board->width, board->height, (enum hal_pixel_format)board->format);
    if (error)
        return error;
    error = panel_bars(&device->panel, board->band[0]);
    while (!error && !(input_buttons() & HAL_QUIT))
        clock_idle();
    int closed = display->ops->close(display, 1);
    return error ? error : closed;
}

static int device_play(struct device *device)
{
    if (keys_open(&device->settings.keys, &device->wires.problem) != 0)
        return SETTINGS_DEVICE;
    if (device->settings.task == SETTINGS_PATTERN)
        return device_pattern(device) == 0 ? SETTINGS_DONE : SETTINGS_DEVICE;
    return app_run(&device->board, &device->settings.start);
}

static int device_with_panel(struct device *device)
{
    if (wires_open(&device->wires, &device->settings.wires) != 0)
        return SETTINGS_DEVICE;
    int code = device->settings.task == SETTINGS_OFF ? SETTINGS_DONE : device_play(device);
    keys_close();
    return wires_close(&device->wires) == 0 ? code : SETTINGS_DEVICE;
}

int device_run(int argc, char **argv)
{
    static struct device device;
    int code = settings_read(&device.settings, argc, argv);
    if (code < 0 && device.settings.task == SETTINGS_HELP) {
        settings_help();
        code = SETTINGS_DONE;
    }
    if (code < 0 && device.settings.task == SETTINGS_LIST) {
        device_list();
        code = SETTINGS_DONE;
    }
    if (code < 0) {
        keys_catch_signals();
        code = device_make(&device) == 0 ? device_with_panel(&device) : SETTINGS_DEVICE;
    }
    free(device.memory);
    free(device.settings.text);
    device.memory = device.settings.text = NULL;
    return code;
}
