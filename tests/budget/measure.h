/* SPDX-License-Identifier: MIT */
/*
 * The largest difference of the integer renderer's pixels from the truth: per-pixel Phong in double precision,
 * perspective-correct, with the scene's effects. Each pixel is compared with the truth of the surface that was drawn
 * there (drawn.h), so that all that differs is shading; the truth is not rounded, so that half a step is the output's.
 * Of textures without filter and of bump maps a pixel may have any texel that its coordinates are within 1/64 of.
 */
#ifndef BUDGET_MEASURE_H
#define BUDGET_MEASURE_H

#include "drawn.h"
#include "picture.h"

#include <math.h>

#define MEASURE_TRUTHS 9
#define MEASURE_NUDGE  (1 / 64.) /* of a texel */

struct measure {
    const struct scene_header *scene;
    unsigned width, height;
    uint8_t format;
    struct drawn_scene from;
    struct budget_picture visible; /* draws numbers of triangles */
    uint32_t *drawn;
    int16_t (*placed)[2];
    struct budget_view view;
    unsigned truths;
    struct reference_image truth[MEASURE_TRUTHS]; /* of the view in hand; the first as it is, the others nudged */
    unsigned long missed;                         /* pixels drawn where the truth has nothing of that triangle */
};

/* Where it is and what it is, in 1/255 of full intensity. */
struct measure_worst {
    double error, truth;
    unsigned x, y, channel;
    uint32_t triangle;
};

/* Something is sampled without filter. */
static inline int measure_has_texels(const struct scene_header *scene)
{
    int has = 0;
    for (unsigned i = 0; i < scene->texture_count; i++)
        has |= !(scene_textures(scene)[i].flags & TEXTURE_BILINEAR);
    return has;
}

static inline void measure_open(struct measure *m, const struct scene_header *scene, unsigned width, unsigned height,
                                uint8_t format)
{
    const size_t pixels = (size_t)width * height;
    size_t vertices = 0;
    *m = (struct measure){.scene = scene, .width = width, .height = height, .format = format};
    m->truths = measure_has_texels(scene) ? MEASURE_TRUTHS : 1;
    drawn_open(&m->from, scene);
    for (unsigned o = 0; o < scene->object_count; o++)
        vertices += scene_meshes(m->from.scene)[o].vertex_count;
    m->visible.config = (struct glint_config){
        .width = (uint16_t)width, .height = (uint16_t)height, .format = GLINT_GREY8, .method = &drawn_method};
    budget_open(&m->visible, m->from.scene);
    m->drawn = budget_alloc(pixels * sizeof *m->drawn);
    m->placed = budget_alloc(vertices * sizeof *m->placed);
}

static inline void measure_close(struct measure *m)
{
    for (unsigned t = 0; t < m->truths; t++)
        reference_free(&m->truth[t]);
    budget_close(&m->visible);
    drawn_close(&m->from);
    free(m->drawn);
    free(m->placed);
}

/* The renderer's places of the vertices, counted through all objects: of one that it left out, none. */
static inline void measure_places(struct measure *m)
{
    const struct glint_frame *f = &m->visible.frame;
    int16_t(*to)[2] = m->placed;
    unsigned next = 0; /* object of the frame */
    for (unsigned o = 0; o < m->scene->object_count; o++) {
        const struct scene_mesh *mesh = scene_meshes(m->from.scene) + o;
        const int here = next < f->object_count && f->objects[next].mesh == mesh;
        const int16_t *record = here ? f->vertices + f->objects[next].first_vertex * f->vertex_stride : NULL;
        for (uint32_t v = 0; v < mesh->vertex_count; v++, to++) {
            (*to)[0] = here ? record[v * f->vertex_stride + VERTEX_X] : VERTEX_UNPLACED;
            (*to)[1] = here ? record[v * f->vertex_stride + VERTEX_Y] : 0;
        }
        next += here;
    }
}

/* Draws the truth of a view. */
static inline void measure_view(struct measure *m, struct budget_view view)
{
    const size_t pixels = (size_t)m->width * m->height;
    memset(m->drawn, 0xff, pixels * sizeof *m->drawn);
    drawn_from = &m->from;
    drawn_to = m->drawn;
    budget_draw(&m->visible, m->from.scene, view);
    measure_places(m);
    for (unsigned t = 0; t < m->truths; t++) {
        const struct reference_options options = {
            .width = m->width,
            .height = m->height,
            .time_ms = view.time_ms,
            .yaw = view.yaw,
            .pitch = view.pitch,
            .grey = m->format == GLINT_GREY8,
            .drawn = m->drawn,
            .placed = (const int16_t(*)[2])m->placed,
            .nudge = {MEASURE_NUDGE * ((t + 1) % 3 - 1.), MEASURE_NUDGE * ((t + 3) / 3 % 3 - 1.)}};
        reference_free(&m->truth[t]);
        if (!reference_render(m->scene, &options, &m->truth[t])) {
            perror("budget");
            exit(3);
        }
    }
    m->view = view;
    for (size_t i = 0; i < pixels; i++)
        m->missed += (m->drawn[i] != REFERENCE_NOTHING) != m->truth[0].covered[i];
}

/* A channel of a pixel, in steps, and how many steps full intensity has. */
static inline int measure_level(const uint8_t *pixels, unsigned format, size_t i, unsigned channel, int *full)
{
    static const int shift[] = {11, 5, 0}, top[] = {31, 63, 31};
    *full = 255;
    if (format == GLINT_GREY8)
        return pixels[i];
    if (format == GLINT_RGB888)
        return pixels[3 * i + channel];
    *full = top[channel];
    return ((const uint16_t *)(const void *)pixels)[i] >> shift[channel] & top[channel];
}

/* Half a step of a channel of the format, in 1/255. */
static inline double measure_half_step(unsigned format, unsigned channel)
{
    return format != GLINT_RGB565 ? .5 : 127.5 / (channel == 1 ? 63 : 31);
}

/* The largest difference of a picture of the view in hand, beyond half a step of the output. */
static inline struct measure_worst measure_picture(const struct measure *m, const uint8_t *pixels)
{
    struct measure_worst worst = {0};
    const unsigned channels = m->truth[0].channels;
    for (size_t i = 0; i < (size_t)m->width * m->height; i++)
        for (unsigned c = 0; m->truth[0].covered[i] && c < channels; c++) {
            int full, level = measure_level(pixels, m->format, i, c, &full);
            double error = INFINITY;
            for (unsigned t = 0; t < m->truths; t++)
                error = fmin(error, fabs(255. * level / full - 255 * m->truth[t].value[i * channels + c]));
            error -= measure_half_step(m->format, c);
            if (error > worst.error)
                worst = (struct measure_worst){error,
                                               255 * m->truth[0].value[i * channels + c],
                                               (unsigned)(i % m->width),
                                               (unsigned)(i / m->width),
                                               c,
                                               m->drawn[i]};
        }
    return worst;
}

#endif
