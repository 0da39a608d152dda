/* SPDX-License-Identifier: MIT */
/* A renderer in memory of exactly the size it asks for, with sentinels on either side. Include after cmocka.h. */
#ifndef FRAME_CASE_H
#define FRAME_CASE_H

#include "glint.h"

#include <stdlib.h>
#include <string.h>

#define FRAME_SENTINELS 64 /* bytes before and after each block */

struct frame_case {
    struct glint_config config; /* size, format, method and stores: set before opening */
    struct glint_frame frame;
    uint8_t *block[3];
    size_t block_bytes[3];
    uint8_t *picture; /* all rows, one after the other */
    size_t picture_bytes;
};

static inline void *frame_case_block(struct frame_case *f, int i, size_t bytes)
{
    f->block_bytes[i] = bytes;
    f->block[i] = malloc(bytes + 2 * FRAME_SENTINELS);
    assert_non_null(f->block[i]);
    memset(f->block[i], 0xA5, bytes + 2 * FRAME_SENTINELS);
    return f->block[i] + FRAME_SENTINELS;
}

/* Nothing has been written beside the memory and the bands. */
static inline void frame_case_guards(const struct frame_case *f)
{
    for (int i = 0; i < 3; i++)
        for (size_t j = 0; f->block[i] && j < FRAME_SENTINELS; j++) {
            assert_int_equal(f->block[i][j], 0xA5);
            assert_int_equal(f->block[i][FRAME_SENTINELS + f->block_bytes[i] + j], 0xA5);
        }
}

/* As config stands; band_rows 0 is all rows, max_lights is given. */
static inline void frame_case_open(struct frame_case *f)
{
    struct glint_config *c = &f->config;
    c->band_rows = c->band_rows ? c->band_rows : c->height;
    c->memory_bytes = glint_memory_needed(c);
    assert_true(c->memory_bytes > 0);
    c->memory = frame_case_block(f, 0, c->memory_bytes);
    c->band[0] = frame_case_block(f, 1, glint_band_bytes(c));
    c->band[1] = frame_case_block(f, 2, glint_band_bytes(c));
    f->picture_bytes = glint_row_bytes(c) * c->height;
    f->picture = malloc(f->picture_bytes);
    assert_non_null(f->picture);
    assert_int_equal(glint_init(&f->frame, c), 0);
}

/* With stores that fit the scene. */
static inline void frame_case_open_for(struct frame_case *f, const void *scene)
{
    glint_fit_stores(&f->config, scene);
    frame_case_open(f);
}

/* The next band, copied to the picture: 0 after the last. */
static inline int frame_case_band(struct frame_case *f)
{
    struct glint_band band;
    size_t row_bytes = glint_row_bytes(&f->config);
    int more = glint_frame_next_band(&f->frame, &band);
    assert_true(more == 0 || more == 1);
    for (unsigned row = 0; more && row < band.rows; row++)
        memcpy(f->picture + (band.y + row) * row_bytes, (uint8_t *)band.pixels + row * band.stride, row_bytes);
    return more;
}

static inline void frame_case_draw(struct frame_case *f, const void *scene, uint32_t time_ms)
{
    memset(f->picture, 0x5A, f->picture_bytes);
    assert_int_equal(glint_frame_begin(&f->frame, scene, time_ms), 0);
    while (frame_case_band(f))
        ;
    frame_case_guards(f);
}

static inline uint32_t frame_case_drawn(const struct frame_case *f)
{
    uint32_t drawn = 0;
    for (int id = 0; id < GLINT_METHODS; id++)
        drawn += f->frame.stats.drawn[id];
    return drawn;
}

/* Every triangle of a scene that needs no clipping is counted once. */
static inline void frame_case_sums(const struct frame_case *f)
{
    const struct glint_stats *s = &f->frame.stats;
    assert_int_equal(s->triangles, s->culled + s->rejected + s->dropped + frame_case_drawn(f));
}

static inline void frame_case_close(struct frame_case *f)
{
    for (int i = 0; i < 3; i++)
        free(f->block[i]);
    free(f->picture);
    memset(f, 0, sizeof *f);
}

/* A configuration of this size, whole, by X. */
static inline struct frame_case frame_case_small(unsigned width, unsigned height, enum glint_format format)
{
    return (struct frame_case){
        .config = {
            .width = (uint16_t)width, .height = (uint16_t)height, .format = (uint8_t)format, .method = &glint_x}};
}

/* A picture by a renderer of its own, to be freed; `stats` may be null. */
static inline uint8_t *frame_case_picture(struct frame_case f, const void *scene, uint32_t time_ms,
                                          struct glint_stats *stats)
{
    frame_case_open_for(&f, scene);
    frame_case_draw(&f, scene, time_ms);
    if (stats)
        *stats = f.frame.stats;
    uint8_t *picture = f.picture;
    f.picture = NULL;
    frame_case_close(&f);
    return picture;
}

/* Fails unless the picture that `whole` made is the same in bands of so many rows and with flags added. */
static inline void frame_case_same(const struct frame_case *whole, const uint8_t *wanted, const void *scene,
                                   unsigned rows, unsigned flags, const char *name)
{
    struct frame_case other = *whole;
    other.config.band_rows = (uint16_t)rows;
    other.config.flags |= (uint8_t)flags;
    uint8_t *picture = frame_case_picture(other, scene, 0, NULL);
    if (memcmp(picture, wanted, glint_row_bytes(&whole->config) * whole->config.height) != 0)
        fail_msg("%s: format %d, flags %d differs in bands of %u with flags %u", name, whole->config.format,
                 whole->config.flags, rows, flags);
    free(picture);
}

#endif
