/* SPDX-License-Identifier: MIT */
/* The display that a path asks for, with messages for what goes wrong. */
#ifndef OUTPUT_H
#define OUTPUT_H

#include "host/displays.h"

#include <stdbool.h>

struct output {
    struct host_display host;
    bool animates; /* it shows time, so that an animation is meant */
    bool open;
};

/* Names for --output-format, for help texts. */
#define OUTPUT_FORMATS "png apng ppm y4m raw"

/*
 * Sets `output` up for a path by `format` (one of OUTPUT_FORMATS) or, if that is null, by the path's ending; a path
 * that ends in '/' is a folder of PNG files, "-" standard output. Nothing is opened yet. Returns an exit code, as all
 * here do; after an error, one line has been printed on stderr.
 */
int output_choose(struct output *output, const char *command, const char *path, const char *format);

/* From here on signals are caught (cli.h), so that close can take back what was written. */
int output_open(struct output *output, uint16_t width, uint16_t height, enum hal_pixel_format format, uint32_t frames,
                uint32_t rate);

/* A step of hal/display.h; `result` is what it returned. After an error only output_close(keep = false) is left. */
int output_step(struct output *output, int result);

/* A whole picture at once. */
int output_picture(struct output *output, uint32_t index, uint32_t delay_ms, const void *pixels, uint32_t stride);

/* Nothing is kept after a signal. Harmless when not open. */
int output_close(struct output *output, bool keep);

#endif
