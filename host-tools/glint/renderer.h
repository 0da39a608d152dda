/* SPDX-License-Identifier: MIT */
/* The integer renderer with memory from the heap: what a board's firmware does with arrays. */
#ifndef RENDERER_H
#define RENDERER_H

#include "display.h"
#include "glint.h"
#include "scene/scene.h"

struct renderer {
    const struct glint_choice *choice; /* the method: set before opening */
    struct glint_config config; /* width, height, format, flags, band_rows, power and tables: set before opening */
    struct glint_frame frame;
    const struct scene_header *scene;
    void *band[2];
    void *memory;
    uint32_t dropped; /* triangles for which a frame had no room: the most of any */
};

/* Forms of the highlight's power, by the names of --power; the table's is null. */
enum { RENDERER_POWERS = 5 };
extern const char *const renderer_power_names[RENDERER_POWERS];
extern const struct glint_power *const renderer_powers[RENDERER_POWERS];

/* The method of that name, or null. */
const struct glint_choice *renderer_find(const char *name);

/* Prepares to draw a checked scene; the rest of config is filled in. A message and an exit code. */
int renderer_open(struct renderer *renderer, const struct scene_header *scene);

/* One picture. `display`, if not null, receives its bands and its errors are returned (HAL_E...). `crc`, if not null,
 * continues over the bands' bytes in order; `milliseconds` grows by the time taken, without the display's. */
int renderer_draw(struct renderer *renderer, uint32_t time_ms, struct hal_display *display, uint32_t *crc,
                  double *milliseconds);

/* Says on stderr if triangles of the scene `path` were dropped. */
void renderer_warn(const struct renderer *renderer, const char *path);

/* Harmless on one that is all zeros. */
void renderer_close(struct renderer *renderer);

#endif
