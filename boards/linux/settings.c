/* SPDX-License-Identifier: MIT */
#include "boards/linux/settings.h"
#include "boards/linux/options.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ARGUMENTS 64 /* options on a command line */

/* --- the board file -------------------------------------------------------------------------------------------------
 */

static int settings_load(struct settings *settings, const char *path)
{
    FILE *file = fopen(path, "rb");
    long size = 0;
    int good = file && fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0 && fseek(file, 0, SEEK_SET) == 0;
    settings->text = good ? calloc(1, (size_t)size + 1) : NULL;
    good = settings->text && fread(settings->text, 1, (size_t)size, file) == (size_t)size;
    int reason = errno;
    if (file)
        fclose(file);
    if (good)
        return -1;
    fprintf(stderr, "%s: %s\n", path, strerror(reason));
    return SETTINGS_DEVICE;
}

/* A line of the file: `name`, `name value`; # begins a comment. Null, or what is wrong. */
static const char *settings_line(struct settings *settings, char *line, const struct option_text **option)
{
    line[strcspn(line, "#")] = 0;
    char *name = line + strspn(line, " \t\r"), *value = name + strcspn(name, " \t\r");
    if (!*name)
        return NULL;
    if (*value)
        *value++ = 0;
    value += strspn(value, " \t\r");
    for (size_t end = strlen(value); end && strchr(" \t\r", value[end - 1]);)
        value[--end] = 0;
    for (int i = 0; i < OPTIONS; i++)
        if (strcmp(options_text[i].name, name) == 0) {
            *option = options_text + i;
            if (i == OPTION_BOARD)
                return "a board file names no other";
            if (!*value && options_text[i].value)
                return "a value is needed";
            return options_set(settings, (enum option_id)i, *value ? value : NULL) ? NULL : "this will not do";
        }
    return "there is no such option; `glint-device --help` has them";
}

static int settings_file(struct settings *settings, const char *path)
{
    int code = settings_load(settings, path), number = 1;
    char *next;
    if (code >= 0)
        return code;
    for (char *line = settings->text; *line; line = next, number++) {
        const struct option_text *option = NULL;
        next = line + strcspn(line, "\n");
        if (*next)
            *next++ = 0;
        const char *wrong = settings_line(settings, line, &option);
        if (wrong) {
            fprintf(stderr, "%s:%d: %s%s%s\n", path, number, wrong, option ? ": " : "", option ? option->help : "");
            return SETTINGS_BAD_DATA;
        }
    }
    return -1;
}

/* --- the command line -----------------------------------------------------------------------------------------------
 */

static int settings_refuse(const struct option_text *option, const char *text)
{
    fprintf(stderr, "glint-device: '%s' will not do for --%s: %s\n", text ? text : "", option->name, option->help);
    return SETTINGS_BAD_USAGE;
}

static int settings_missing(const char *what)
{
    fprintf(stderr, "glint-device: %s is needed: give it, or --board FILE; try 'glint-device --help'\n", what);
    return SETTINGS_BAD_USAGE;
}

static void settings_glass(struct settings *settings)
{
    for (const struct settings_panel *panel = settings_panels; panel->name && !settings->width; panel++)
        if (panel->controller == settings->controller) { /* null: none */
            settings->width = panel->width;
            settings->height = panel->height;
        }
}

/* What panel.h asks for, told before a line is touched. */
static int settings_fits(const struct settings *settings)
{
    const struct panel_controller *controller = settings->controller;
    int grey = controller->format == HAL_GREY4;
    const char *wrong = NULL;
    if (settings->offset_x + settings->width > controller->columns ||
        settings->offset_y + settings->height > controller->rows)
        wrong = "--size and --offset-x, --offset-y reach beyond the panel's memory of";
    else if (grey && ((settings->width | settings->height | settings->offset_x) & 1))
        wrong = "--size and --offset-x have to be even with a panel of two pixels a byte:";
    else if (settings->bgr && !controller->bgr)
        wrong = "--bgr, and no colours, on a panel of";
    if (wrong)
        fprintf(stderr, "glint-device: %s %ux%u\n", wrong, controller->columns, controller->rows);
    return !wrong;
}

/* Without a panel. */
static int settings_bare(struct settings *settings)
{
    if (settings->task != SETTINGS_PLAY) {
        fprintf(stderr, "glint-device: --test-pattern and --off want a panel\n");
        return SETTINGS_BAD_USAGE;
    }
    if (!settings->usb)
        return settings_missing("with --panel none, --stream usb");
    settings->keys.count = 0; /* pins too: a board's file may name them */
    return -1;
}

/* What has to be known to play. */
static int settings_complete(struct settings *settings)
{
    struct wires_config *wires = &settings->wires;
    if (settings->task == SETTINGS_LIST || settings->task == SETTINGS_HELP)
        return -1;
    settings_glass(settings);
    if (settings->bare)
        return settings_bare(settings);
    if (!settings->controller)
        return settings_missing("--panel");
    if (!wires->chip)
        return settings_missing("--chip");
    if (!wires->dc.line)
        return settings_missing("--dc");
    if (!wires->spi && (!wires->sck || !wires->mosi))
        return settings_missing("--spi DEVICE, or --sck and --mosi,");
    return settings_fits(settings) ? -1 : SETTINGS_BAD_USAGE;
}

int settings_read(struct settings *settings, int argc, char **argv)
{
    struct option options[OPTIONS + 1] = {0};
    struct {
        int option;
        char *text;
    } given[ARGUMENTS];
    int count = 0, found, index, code = -1;
    const char *board = NULL;
    *settings = (struct settings){.refresh = 600, .wires.speed = 32000000};
    app_usual(&settings->start);
    settings->start.period_us = 1000000 / 60;
    for (int i = 0; i < OPTIONS; i++)
        options[i] = (struct option){options_text[i].name,
                                     options_text[i].value ? required_argument : optional_argument, NULL, i + 1};
    optind = 0;
    while ((found = getopt_long(argc, argv, "h", options, &index)) != -1) {
        found = found == 'h' ? OPTION_HELP : found - 1;
        if (found < 0 || found >= OPTIONS || count == ARGUMENTS)
            return SETTINGS_BAD_USAGE;
        if (found == OPTION_HELP) { /* whatever the board file is like */
            settings->task = SETTINGS_HELP;
            return -1;
        }
        given[count].option = found;
        given[count++].text = optarg;
        if (found == OPTION_BOARD)
            board = optarg;
    }
    if (optind < argc) {
        fprintf(stderr, "glint-device: '%s' is no option; try 'glint-device --help'\n", argv[optind]);
        return SETTINGS_BAD_USAGE;
    }
    /* Without --board, no board file is no mistake. */
    FILE *usual = board ? NULL : fopen(SETTINGS_BOARD, "rb");
    if (usual)
        fclose(usual);
    if (board || usual)
        code = settings_file(settings, board ? board : SETTINGS_BOARD);
    for (int i = 0; i < count && code < 0; i++)
        if (!options_set(settings, (enum option_id)given[i].option, given[i].text))
            code = settings_refuse(options_text + given[i].option, given[i].text);
    return code < 0 ? settings_complete(settings) : code;
}
