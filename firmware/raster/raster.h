/* SPDX-License-Identifier: MIT */
/*
 * From a set-up triangle to pixels of a band. Three ways lead there:
 *   spans.h    loops that go straight into the band, one for each format and kind of pixel: under one light N.L and
 * N.H, linear or quadratic, or over the length of the normal, and finished colours effects.h  runs of RUN pixels
 * through stages of effects, for surfaces that have some runs.h     the general one, runs again: depth test to a mask,
 * shading into sums, conversion to the output's format
 *
 * A new kind of pixel is a bit of enum spans_kind, what it makes of the channels in spans_grey(), spans_rgb565() or
 * spans_rgb888(), and a SPANS_CASE in the format's file beside the condition that it is drawn by; whatever else it
 * steps goes into struct spans_values. The constant kind leaves each case what it uses.
 */
#ifndef GLINT_RASTER_H
#define GLINT_RASTER_H

#include "geometry/clip.h"
#include "glint.h"
#include "plan/fog.h"
#include "raster/edges.h"
#include "shade/uv.h"

#define RUN                16 /* pixels; a mask bit each */
#define RASTER_NO_MATERIAL 0xffffu

#define SPANS 32 /* rows scan-converted at a time */

/*
 * What one material is under the first light, see table.c. RGB565: colours [highlight step][diffuse step],
 * TABLE_HIGHLIGHT by TABLE_DIFFUSE. GREY8, RGB888: ambient part and highlight by highlight step, 2^TABLE_BITS entries
 * of 1 or 4 (r, g, b, none) numbers. Row or entry 0 has no highlight.
 */
#define TABLE_DIFFUSE   64
#define TABLE_HIGHLIGHT 128
#define TABLE_BITS      10
struct table {
    uint32_t base[3]; /* what it was made for: see struct surface */
    uint16_t diffuse[3], specular[3];
    uint16_t exponent; /* 0: not made */
    uint16_t reserved;
    uint16_t entry[];
};

/* Defaults of what follows; the first and last are the paper's (Cho et al. 1996). */
#define SPLIT_AREA      32
#define SPLIT_TOLERANCE 4
#define SPLIT_THRESHOLD 77 /* .3 */

/* When the subdividing methods split, from the configuration. */
struct split_limits {
    uint16_t area;     /* pixels */
    uint8_t threshold; /* of the colour, 1/256 */
    uint8_t tolerance; /* 1/255 of full intensity */
};

struct raster {
    /* the picture and the band in hand */
    uint16_t width, height;
    uint16_t y0, y1;
    uint8_t format, dither, tables;
    uint32_t stride;
    struct split_limits split;
    uint8_t *pixels;
    uint16_t *depth;  /* of the band, width a row */
    struct fog fog;   /* its kind is asked for of each triangle: near the beginning, as `effects` */
    uint32_t effects; /* what the triangle in hand asks for at each pixel besides lighting: USES_TEXTURE, USES_FOG */
    uint32_t surface_effects; /* what its surface does: USES_TEXTURE */
    struct palette palette;
    uint16_t fog_colour[3]; /* Q8 steps */
    uint16_t fog_allowed;   /* error that may be added, Q16 of full intensity */
    uint8_t fog_planned;    /* by auto: it is part of input.plan */
    uint16_t plan_budget;   /* what surface.plan has without fog */
    struct surface surface;
    uint16_t budget;                   /* of auto, Q8 of 1/255 */
    uint16_t surface_material;         /* which one `surface` holds; 0xffff: none */
    const struct table *surface_table; /* made for `surface`; null: none, or not looked for yet */
    uint16_t fold;                     /* the surface's, of triangles without fog */
    const struct table *plan_table;    /* auto: the surface's, which a triangle takes where the budget has room for */
    uint16_t table_off;                /* what it is off by, Q8 of 1/255 */
    void *table;                       /* one for each of the first r->tables materials, table_bytes() each */
    /* the triangle in hand */
    struct shade_input input;
    struct fog_plan fog_plan;
    union {
        struct shade_setup setup;
        struct { /* while the frame begins: all triangles are listed before the first is set up */
            struct view view;
            struct transform transform;
            struct clip_polygon polygon[2];
            int16_t place[CLIP_MAX_CORNERS][3];
        } begin;
    };
    struct uv_corners corners; /* of a triangle whose texture coordinates are split: split.h */
    uint16_t weight[3][3];
    struct shade_turned turned;
    uint16_t colours[3][COLOUR_WORDS];
    _Alignas(uint32_t) struct span span[SPANS]; /* read as a word each */
    /* the run in hand */
    int32_t value[6][RUN];
    struct perspective_divisor divisor[RUN];
    uint32_t sum[RUN][3];
    uint32_t *gloss; /* where lights add highlights: to `sum`, or apart from what a texture multiplies */
    uint32_t apart[USES(USES_TEXTURE) ? RUN : 1][3];
    int32_t uv[2][USES(USES_TEXTURE | USES_BUMP) ? RUN : 1]; /* texture coordinates, Q28 */
};

/* Effects at pixels of the triangle in hand: 0 where the program has none. */
static inline uint32_t raster_effects(const struct raster *r)
{
    return USES(USES_TEXTURE | USES_FOG) ? r->effects : 0;
}

/* Where lights add highlights. */
static inline uint32_t *raster_gloss(struct raster *r)
{
    return USES(USES_TEXTURE) ? r->gloss : r->sum[0];
}

struct triangle_ref;

/* The picture's format, dither and channels; constants where the program has no others. */
static inline int raster_is(const struct raster *r, enum glint_format format)
{
    return uses_format(r->format, format);
}
static inline int raster_dithers(const struct raster *r)
{
    return USES(USES_DITHER) && r->dither;
}
static inline unsigned raster_channels(const struct raster *r)
{
    return uses_channels(r->palette.channels);
}

/* The largest value of an output channel. */
static inline uint8_t raster_top(unsigned format, unsigned channel)
{
    switch (format) {
    case GLINT_RGB565:
        return channel == 1 ? 63 : 31;
    case GLINT_GREY4:
        return 15;
    default:
        return 255;
    }
}

/* What lies in r->sum after a method's run of pixels: finished colours, or with highlights apart in r->gloss where they
 * can reach the triangle (setup.specular_lights), or anywhere. */
enum method_colours { COLOURS_FINISHED, COLOURS_OF_DOTS, COLOURS_OF_NORMALS };

/* Fills r->sum for n pixels from (x, y), Q15 steps, unclamped; adds highlights to r->gloss. */
typedef void raster_run(struct raster *r, int x, int y, int n);

/* A method: how a triangle is set up, and its pixels. */
struct glint_method {
    uint8_t id;           /* enum glint_method_id */
    uint8_t uses_tables;  /* draws from tables where it can */
    uint8_t vertex_words; /* int16_t that it keeps in a vertex record behind the lights; the last is 0 at first */
    void (*setup)(struct shade_setup *setup, const struct shade_input *in);
    /* Draws the set-up triangle over the band; returns the pixels that passed the depth test. */
    uint32_t (*draw)(struct raster *r, struct edges *e);
    /* Null, or called when a frame begins with each object's vertex records, `stride` int16_t apart, placed and lit. */
    void (*object)(const struct object_state *object, const struct scene_header *scene, int16_t *records,
                   unsigned stride, struct glint_stats *stats);
    /* Null, or which method the triangle in hand is drawn by, which it is counted under: this one or a plainer. */
    const struct glint_method *(*choose)(struct raster *r);
    /* Its lighting, for what is drawn with effects at pixels (effects.h). Null: `draw` looks at them. */
    raster_run *run;
    uint8_t colours; /* enum method_colours of `run` */
};

/* These methods' draw. flat's is of r->setup.flat. */
uint32_t draw_flat(struct raster *r, struct edges *e);
uint32_t draw_gouraud(struct raster *r, struct edges *e);
uint32_t draw_duff(struct raster *r, struct edges *e);
uint32_t draw_color6(struct raster *r, struct edges *e);

/* 1 / W of n pixels, and the reciprocal length of their normals (SHADE_SQUARE), into r->divisor. */
void raster_divisors(struct raster *r, int x, int y, int n);
void raster_lengths(struct raster *r, int x, int y, int n);

/* What methods with channels of N.L and N.H draw with. */
uint32_t raster_draw_dots(struct raster *r, struct edges *e);

/* Writes the pixels of a mask from r->sum. */
void raster_write(struct raster *r, int x, int y, uint32_t mask);

/* A colour in Q15 steps as the format has it. */
uint32_t raster_colour(const struct raster *r, const uint32_t sum[3]);

/* The next spans of the triangle, into r->span: how many, at least 1 while e->row < e->last. */
static inline int raster_spans(struct raster *r, struct edges *e)
{
    return edges_spans(e, r->width, r->span, SPANS);
}

/* Fills the band with the background and its depth with the far end. */
void raster_clear(struct raster *r, const struct scene_header *scene);

/* Bytes of a table for this format, a multiple of 4; 0: it has none. */
uint32_t table_bytes(unsigned format);

/* Empties r->tables tables. */
void table_clear(struct raster *r);

/* What r->surface_table costs in accuracy at most, Q8 of 1/255, roundings of the output apart (see table.c); 0 if null.
 */
uint16_t table_error(const struct raster *r);

/* Sets r->surface_table to the table of the surface in hand, made anew if it was another's; null if it has none: GREY4,
 * dither, no light, outside RGB565 another form of the power, or a material beyond the tables. Table i is material
 * i's, so that a picture does not depend on what was drawn before. */
void table_find(struct raster *r);

#endif
