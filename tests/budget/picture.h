/* SPDX-License-Identifier: MIT */
/* One renderer, and a picture of a scene in one piece. */
#ifndef BUDGET_PICTURE_H
#define BUDGET_PICTURE_H

#include "glint.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

struct budget_view {
    uint16_t yaw, pitch;
    uint32_t time_ms;
};

struct budget_picture {
    struct glint_config config; /* width, height, format, method ...: set before opening */
    struct glint_frame frame;
    uint8_t *pixels;
};

static inline void *budget_alloc(size_t bytes)
{
    void *p = malloc(bytes ? bytes : 1);
    if (!p) {
        perror("budget");
        exit(3);
    }
    return p;
}

static inline void budget_open(struct budget_picture *p, const void *scene)
{
    struct glint_config *c = &p->config;
    c->band_rows = c->height;
    glint_fit_stores(c, scene);
    c->memory_bytes = glint_memory_needed(c);
    c->memory = budget_alloc(c->memory_bytes);
    c->band[0] = p->pixels = budget_alloc(glint_band_bytes(c));
    c->band[1] = NULL;
    if (glint_init(&p->frame, c) != 0) {
        fprintf(stderr, "budget: the renderer does not take the configuration\n");
        exit(1);
    }
}

static inline void budget_draw(struct budget_picture *p, const void *scene, struct budget_view view)
{
    struct glint_band band;
    glint_turn(&p->frame, view.yaw, view.pitch);
    if (glint_frame_begin(&p->frame, scene, view.time_ms) != 0 || glint_frame_next_band(&p->frame, &band) != 1) {
        fprintf(stderr, "budget: the renderer does not take the scene\n");
        exit(1);
    }
}

static inline void budget_close(struct budget_picture *p)
{
    free(p->config.memory);
    free(p->pixels);
}

#endif
