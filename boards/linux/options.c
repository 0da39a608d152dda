/* SPDX-License-Identifier: MIT */
#include "boards/linux/options.h"
#include "boards/linux/values.h"

#include <stdio.h>
#include <string.h>

const struct settings_panel settings_panels[] = {{"st7789", &panel_st7789, 240, 240},
                                                 {"ili9341", &panel_ili9341, 240, 320},
                                                 {"ssd1351", &panel_ssd1351, 128, 128},
                                                 {"ssd0323", &panel_ssd0323, 128, 64},
                                                 {"none", NULL, 240, 240},
                                                 {0}};

const struct option_text options_text[OPTIONS] = {
    {"board", "FILE", "the file with the options of a board, default " SETTINGS_BOARD},
    {"panel", "NAME", "st7789, ili9341, ssd1351 or ssd0323; or none: no pins are touched, with --stream"},
    {"size", "WxH", "the glass, in pixels before rotation; default 240x240, 240x320, 128x128, 128x64, 240x240"},
    {"rotate", "DEG", "0, 90, 180 or 270: the panel is turned clockwise, the picture stays upright"},
    {"bgr", NULL, "red and blue are exchanged"},
    {"invert", NULL, "light and dark are exchanged"},
    {"offset-x", "N", "where the glass begins in the panel's memory, before rotation: 0..319"},
    {"offset-y", "N", "the same, down: 0..319"},
    {"whole", NULL, "send every row of every picture, not only those that changed"},
    {"refresh", "N", "all registers anew every N pictures, 0..65535; 0: only at the start. Default 600"},
    {"spi", "DEVICE", "as /dev/spidev0.0; or gpio: --sck, --mosi and --cs are lines of the chip"},
    {"spi-mode", "N", "0..3; a module without chip select wants 3. Default 0"},
    {"speed", "HZ", "of the SPI device, as 62.5M or 500k. Default 32M"},
    {"chip", "NAME", "GPIO chip: a label, gpiochip0 or a path; of several with commas between, the first there is"},
    {"dc", "LINE", "data/command: offset or name of the line; with ! before it, high and low exchanged"},
    {"reset", "LINE", "reset, or none"},
    {"backlight", "LINE", "backlight, or none"},
    {"sck", "LINE", "clock, with --spi gpio"},
    {"mosi", "LINE", "data, with --spi gpio"},
    {"cs", "LINE", "chip select, with --spi gpio, or none"},
    {"keys", "LIST", "buttons, as up=6,down=19,left=5,right=26,a=13,b=21,x=20,y=16; or none"},
    {"keys-high", NULL, "a pressed button is high, not low"},
    {"stream", "usb", "every picture goes to a USB host too, which sees it with glint-view; wants root"},
    {"udc", "NAME", "for --stream usb: which USB device controller; default the first there is"},
    {"usb-serial", "TEXT", "the serial number that the host is told; default the machine's"},
    {"scene", "NAME", "to begin with: see --list"},
    {"method", "NAME", "to begin with: see --list; default x"},
    {"budget", "N", "how far a pixel may be off, 1..255 in 1/255"},
    {"dither", NULL, "ordered dither. Default on where there are 16 greys, else off"},
    {"fps", "N", "pictures a second at the most, 1..1000. Default 60"},
    {"figures", NULL, "figures on the picture. Default on"},
    {"still", NULL, "the animation stands"},
    {"time", "MS", "the moment to begin at"},
    {"step", "MS", "from each picture to the next, 1..60000, however long it took"},
    {"frames", "N", "end after so many pictures, 1..1000000"},
    {"test-pattern", NULL, "colour bars with a white edge, until stopped"},
    {"off", NULL, "panel dark and in reset: what a crash may have left undone"},
    {"list", NULL, "panels, scenes, methods, and this machine's GPIO chips, SPI devices and USB device controllers"},
    {"help", NULL, "this"},
};

static int options_panel(struct settings *settings, const char *name)
{
    const struct settings_panel *panel = settings_panels;
    while (panel->name && strcmp(panel->name, name) != 0)
        panel++;
    settings->controller = panel->controller;
    settings->bare = panel->name && !panel->controller;
    return panel->name != NULL;
}

static int options_rotate(struct settings *settings, const char *text)
{
    return values_short(text, 0, 270, &settings->rotation) && settings->rotation % 90 == 0;
}

static int options_task(struct settings *settings, enum settings_task task, const char *text)
{
    uint8_t on;
    if (!values_switch(text, &on))
        return 0;
    if (on)
        settings->task = task;
    return 1;
}

static int options_number(const char *text, uint32_t low, uint32_t high, uint8_t *value)
{
    uint32_t number = 0;
    int good = values_number(text, low, high, &number);
    *value = (uint8_t)number;
    return good;
}

/* Lines of the chip when bits are sent by it: never inverted. */
static int options_line(char *text, const char **line)
{
    struct wires_pin pin;
    if (!values_pin(text, &pin) || pin.inverted)
        return 0;
    *line = pin.line;
    return 1;
}

/* How the panel is wired. */
static int options_wiring(struct settings *settings, enum option_id option, char *text)
{
    struct wires_config *wires = &settings->wires;
    switch (option) {
    case OPTION_SPI:
        wires->spi = strcmp(text, "gpio") == 0 ? NULL : text;
        return *text != 0;
    case OPTION_SPI_MODE:
        return options_number(text, 0, 3, &wires->mode);
    case OPTION_SPEED:
        return values_hertz(text, &wires->speed);
    case OPTION_CHIP:
        wires->chip = settings->keys.chip = text;
        return *text != 0;
    case OPTION_DC:
        return values_pin(text, &wires->dc);
    case OPTION_RESET:
        return values_pin(text, &wires->reset);
    case OPTION_BACKLIGHT:
        return values_pin(text, &wires->backlight);
    case OPTION_SCK:
        return options_line(text, &wires->sck);
    case OPTION_MOSI:
        return options_line(text, &wires->mosi);
    case OPTION_CS:
        return options_line(text, &wires->cs);
    case OPTION_KEYS:
        return values_keys(text, &settings->keys);
    default: /* OPTION_KEYS_HIGH */
        return values_switch(text, &settings->keys.high);
    }
}

static int options_scene(const char *name, uint16_t *index)
{
    for (unsigned i = 0; i < program_scene_count; i++)
        if (strcmp(program_scenes[i].name, name) == 0) {
            *index = (uint16_t)i;
            return 1;
        }
    return 0;
}

static int options_method(const char *name, uint16_t *index)
{
    for (unsigned i = 0; i < glint_choice_count; i++)
        if (strcmp(glint_choices[i].name, name) == 0) {
            *index = (uint16_t)i;
            return 1;
        }
    return 0;
}

/* What is shown. */
static int options_show(struct settings *settings, enum option_id option, char *text)
{
    struct app_start *start = &settings->start;
    struct control *control = &start->control;
    uint32_t number;
    uint8_t on;
    switch (option) {
    case OPTION_SCENE:
        return options_scene(text, &control->scene);
    case OPTION_METHOD:
        return options_method(text, &control->method);
    case OPTION_BUDGET:
        return options_number(text, 1, 255, &control->budget);
    case OPTION_DITHER:
        settings->dithers = 1;
        return values_switch(text, &settings->dither);
    case OPTION_FPS:
        return values_number(text, 1, 1000, &number) && (start->period_us = 1000000 / number);
    case OPTION_FIGURES:
        return values_switch(text, &control->figures);
    case OPTION_STILL:
        return values_switch(text, &on) && (control->running = !on, 1);
    case OPTION_TIME:
        return values_number(text, 0, UINT32_MAX, &control->moment_ms);
    case OPTION_STEP:
        return values_number(text, 1, 60000, &number) && (start->step_us = 1000 * number);
    case OPTION_FRAMES:
        return values_number(text, 1, 1000000, &start->pictures);
    case OPTION_TEST_PATTERN:
        return options_task(settings, SETTINGS_PATTERN, text);
    case OPTION_OFF:
        return options_task(settings, SETTINGS_OFF, text);
    case OPTION_LIST:
        return options_task(settings, SETTINGS_LIST, text);
    default: /* OPTION_HELP: read before */
        return 1;
    }
}

/* Printable ASCII, as USB's strings are told to the kernel. */
static int options_name(const char *text, size_t most, const char **name)
{
    size_t length = 0;
    while (text[length] > ' ' && text[length] < 0x7F)
        length++;
    *name = text;
    return length > 0 && length <= most && !text[length];
}

/* Where pictures go beside the panel. */
static int options_stream(struct settings *settings, enum option_id option, const char *text)
{
    switch (option) {
    case OPTION_STREAM:
        settings->usb = 1;
        return strcmp(text, "usb") == 0;
    case OPTION_UDC:
        return options_name(text, GADGET_NAME - 1, &settings->udc) && !strchr(text, '/');
    default: /* OPTION_USB_SERIAL */
        return options_name(text, SETTINGS_SERIAL, &settings->serial);
    }
}

/* 1, or 0 if `text` is no value of the option. */
int options_set(struct settings *settings, enum option_id option, char *text)
{
    switch (option) {
    case OPTION_BOARD:
        return 1; /* read before */
    case OPTION_PANEL:
        return options_panel(settings, text);
    case OPTION_SIZE:
        return values_size(text, &settings->width, &settings->height);
    case OPTION_ROTATE:
        return options_rotate(settings, text);
    case OPTION_BGR:
        return values_switch(text, &settings->bgr);
    case OPTION_INVERT:
        return values_switch(text, &settings->invert);
    case OPTION_OFFSET_X:
        return values_short(text, 0, 319, &settings->offset_x);
    case OPTION_OFFSET_Y:
        return values_short(text, 0, 319, &settings->offset_y);
    case OPTION_WHOLE:
        return values_switch(text, &settings->whole);
    case OPTION_REFRESH:
        return values_short(text, 0, 65535, &settings->refresh);
    default:
        return option < OPTION_STREAM  ? options_wiring(settings, option, text)
               : option < OPTION_SCENE ? options_stream(settings, option, text)
                                       : options_show(settings, option, text);
    }
}

void settings_help(void)
{
    printf("usage: glint-device [OPTION]...\n\n"
           "Plays scenes on an SPI panel. A board file has the same options, one a line, without the dashes.\n\n");
    for (int i = 0; i < OPTIONS; i++) {
        const struct option_text *option = options_text + i;
        int width = printf("  --%s%s%s", option->name, option->value ? " " : "", option->value ? option->value : "");
        printf("%*s%s\n", width < 20 ? 20 - width : 1, "", option->help);
    }
    printf("\nSwitches take =on or =off. SIGINT and SIGTERM end the program, panel dark and in reset.\n"
           "Exit: 0 done, 1 bad board file, 2 bad usage, 3 device.\n");
}
