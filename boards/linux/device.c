/* SPDX-License-Identifier: MIT */
#include "boards/linux/device.h"
#include "boards/linux/name.h"
#include "boards/linux/settings.h"
#include "clock.h"
#include "host/displays.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>

#define MEMORY (8u << 20) /* for the renderer: 60,000 triangles; what is not used is not there */
#define BANDS  4u         /* a picture: one is sent while the next is drawn */
/* Bytes of a stream beside a picture's pixels: of a hello, a line of report, and what stream.h says of a frame. */
#define MESSAGE (STREAM_HEADER + STREAM_CHECK)
#define BESIDE  (MESSAGE + STREAM_MAX_NAMES + MESSAGE + sizeof(struct text_line) + BANDS * MESSAGE + 116u)

struct device {
    struct settings settings;
    struct wires wires;
    struct panel panel;
    struct hal_display none; /* instead of the panel */
    struct usb_stream usb;
    struct board board;
    void *memory;
    uint8_t *queue; /* of the stream, and the longest frame in it */
    uint32_t frame_most;
};

static void device_print_chip(const char *path, const struct gpio *gpio, void *context)
{
    (void)context;
    printf("  %s [%s] %u lines\n", path, gpio->label, gpio->available);
}

static void device_list_paths(const char *pattern)
{
    glob_t found;
    if (glob(pattern, 0, NULL, &found) != 0)
        return;
    for (size_t i = 0; i < found.gl_pathc; i++)
        printf("  %s\n", found.gl_pathv[i]);
    globfree(&found);
}

static void device_list(void)
{
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
    device_list_paths("/dev/spidev*");
    printf("USB device controllers:\n");
    device_list_paths("/sys/class/udc/*");
}

static const char *device_name(const struct settings *settings)
{
    const struct settings_panel *panel = settings_panels;
    while (panel->controller != settings->controller)
        panel++;
    return settings->bare ? "linux" : panel->name;
}

static struct panel device_panel(const struct settings *settings)
{
    return (struct panel){.display.ops = &panel_display,
                          .controller = settings->controller,
                          .width = settings->width,
                          .height = settings->height,
                          .offset_x = settings->offset_x,
                          .offset_y = settings->offset_y,
                          .rotation = settings->rotation,
                          .bgr = settings->bgr,
                          .invert = settings->invert,
                          .refresh = settings->refresh};
}

/* A part of a block, aligned. */
static void *device_part(uint8_t **free, size_t size)
{
    uint8_t *part = *free;
    *free += (size + 7) & ~(size_t)7;
    return part;
}

/* One block: the renderer's memory, the last picture on the panel and in the stream, two bands, the stream's queue. */
static int device_make(struct device *device)
{
    const struct settings *settings = &device->settings;
    int quarter = settings->rotation / 90 & 1, grey = settings->controller && settings->controller->format == HAL_GREY4;
    uint16_t width = quarter ? settings->height : settings->width,
             height = quarter ? settings->width : settings->height;
    /* even: what an SSD0323 takes at quarter turns */
    uint16_t rows = (uint16_t)(((height + BANDS - 1) / BANDS + 1) & ~1u);
    rows = rows < height ? rows : height;
    size_t picture = (size_t)2 * width * height, band = (size_t)2 * width * rows, frame = picture + BESIDE;
    uint8_t *memory = device->memory = calloc(1, MEMORY + 2 * picture + 2 * band + 2 * frame + 8 * 8);
    if (!memory) {
        fprintf(stderr, "glint-device: out of memory\n");
        return -1;
    }
    device->board = (struct board){.name = device_name(settings),
                                   .display = settings->bare ? &device->none : &device->panel.display,
                                   .width = width,
                                   .height = height,
                                   .band_rows = rows,
                                   .format = grey ? HAL_GREY4 : HAL_RGB565,
                                   .pack = grey ? &pack_grey4 : &pack_rgb565,
                                   .dither = settings->dithers ? settings->dither : (uint8_t)grey,
                                   .memory = device_part(&memory, MEMORY),
                                   .memory_bytes = MEMORY};
    device->board.band[0] = device_part(&memory, band);
    device->board.band[1] = device_part(&memory, band);
    device->none.ops = &null_display;
    device->panel = device_panel(settings);
    device->panel.bus = &device->wires.bus;
    device->panel.memory_size = settings->whole ? 0 : (uint32_t)picture;
    device->panel.memory = settings->whole ? NULL : device_part(&memory, picture);
    if (settings->usb) {
        device->board.link = &device->usb.link;
        device->board.last = device_part(&memory, picture);
        device->board.log = stream_log;
        device->queue = device_part(&memory, 2 * frame);
        device->frame_most = (uint32_t)frame;
    }
    return 0;
}

/* Pictures go to a USB host too, from here on. */
static int device_plug(struct device *device)
{
    const struct settings *settings = &device->settings;
    char product[64], serial[SETTINGS_SERIAL + 1];
    name_serial(serial, sizeof serial);
    snprintf(product, sizeof product, "Glint %s", device->board.name);
    return usb_stream_open(
        &device->usb,
        &(struct usb_stream_config){.gadget = {settings->udc, product, settings->serial ? settings->serial : serial},
                                    .queue = device->queue,
                                    .frame_most = device->frame_most});
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
    const struct settings *settings = &device->settings;
    if (keys_open(&settings->keys, &device->wires.problem) != 0)
        return SETTINGS_DEVICE;
    if (settings->task == SETTINGS_PATTERN)
        return device_pattern(device) == 0 ? SETTINGS_DONE : SETTINGS_DEVICE;
    if (settings->usb && device_plug(device) != 0)
        return SETTINGS_DEVICE;
    int code = app_run(&device->board, &settings->start);
    usb_stream_close(&device->usb);
    return code;
}

static int device_with_panel(struct device *device)
{
    if (wires_open(&device->wires, &device->settings.wires) != 0)
        return SETTINGS_DEVICE;
    int code = device->settings.task == SETTINGS_OFF ? SETTINGS_DONE : device_play(device);
    keys_close();
    return wires_close(&device->wires) == 0 ? code : SETTINGS_DEVICE;
}

static int device_without_panel(struct device *device)
{
    int code = device_play(device);
    keys_close();
    return code;
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
        code = device_make(&device) != 0 ? SETTINGS_DEVICE
               : device.settings.bare    ? device_without_panel(&device)
                                         : device_with_panel(&device);
    }
    free(device.memory);
    free(device.settings.text);
    device.memory = device.settings.text = NULL;
    return code;
}
