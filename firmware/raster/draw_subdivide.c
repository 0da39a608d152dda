/* SPDX-License-Identifier: MIT */
/* Triangles split into 4, and each of those again: by size, or by the error at the centre. */
#include "plan/highlighted.h"
#include "raster/adaptive.h"
#include "raster/parts.h"

/* The 4 parts of a split one, by its 6 corners; in the parent's turn. */
static const uint8_t part_of[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};

static void find_middles(const struct shade_input *in, struct part_corner corner[6])
{
    for (int k = 0; k < 3; k++)
        part_between(in, &corner[k], &corner[k == 2 ? 0 : k + 1], &corner[3 + k]);
}

/* Sub-pixels: what is lower is not split, so that its parts, half as high, have polynomials: from half a pixel on. */
#define SPLIT_LEAST 16

static int32_t height_of(const struct raster *r, const struct part_corner corner[3])
{
    const struct part_place p[3] = {part_place(&r->input, &corner[0]), part_place(&r->input, &corner[1]),
                                    part_place(&r->input, &corner[2])};
    return part_height(p);
}

/* How often the triangle is to be split for parts of at most r->split.area pixels. */
static unsigned depth_of(const struct raster *r, const struct part_corner corner[3])
{
    uint32_t area = r->setup.plane.det; /* 512 a pixel: sub-pixels' squares, twice */
    int32_t height = height_of(r, corner);
    unsigned depth = 0;
    for (; depth < PART_DEPTH && area > fx_u32(r->split.area) << 9 && height >= SPLIT_LEAST; depth++) {
        area >>= 2;
        height >>= 1;
    }
    return depth;
}

static int beyond(const struct raster *r, unsigned c, int32_t estimate, int32_t is)
{
    const int32_t top = r->palette.top[c] << 8;
    estimate = estimate < 0 ? 0 : estimate > top ? top : estimate; /* as it is drawn */
    const int32_t error = estimate - is;
    return (error < 0 ? -error : error) * 255 > r->split.tolerance * top; /* at most 2^16 * 255 */
}

/* Whether the quadratic's value at the centre, (4 (I01 + I12 + I20) - (I0 + I1 + I2)) / 9, is off by more than the
 * tolerance. */
static int errs_at_centre(const struct raster *r, const struct part_corner corner[6])
{
    struct part_corner centre;
    for (int i = 0; i < 2; i++) /* three of at most 2^15; a third, rounded down, leaves the rest at least 0 */
        centre.weight[i] = fx_u16((fx_u32(corner[0].weight[i]) + corner[1].weight[i] + corner[2].weight[i]) / 3);
    part_shade(&r->input, &centre);
    for (unsigned c = 0; c < raster_channels(r); c++) {
        int32_t estimate = 0;
        for (int k = 0; k < 3; k++)
            estimate += 4 * corner[3 + k].colour[c] - corner[k].colour[c];
        if (beyond(r, c, estimate / 9, centre.colour[c]))
            return 1;
    }
    return 0;
}

/*
 * Draws the triangle, whose corners are at the bottom of the stack, in parts. Parts are split until they are `depth` <=
 * PART_DEPTH deep; with `centre`, while they err there, and are quadratic. What is not in the band's rows is left out,
 * which changes no part that is.
 */
static uint32_t split(struct raster *r, struct edges *e, unsigned depth, int centre)
{
    struct part_split *const bottom = r->setup.parts.split, *top = bottom;
    uint32_t drawn = 0;
    for (;;) {
        struct part_corner *part = top->corner;
        const struct part_corner *const corner[3] = {&part[0], &part[1], &part[2]};
        int more = 0;
        if (parts_shows(r, corner)) {
            more = fx_u32(top - bottom) < depth;
            if (more || centre)
                find_middles(&r->input, part);
            if (centre)
                more = more && height_of(r, part) >= SPLIT_LEAST && errs_at_centre(r, part);
            if (!more)
                drawn += centre ? parts_quadratic(r, e, corner, &part[3]) : parts_linear(r, e, corner);
        }
        top->next = more ? 0 : 4;
        for (; top->next == 4; top--)
            if (top == bottom)
                return drawn;
        for (int k = 0; k < 3; k++)
            top[1].corner[k] = top->corner[part_of[top->next][k]];
        top->next++;
        top++;
    }
}

/* Puts the triangle's corners at the bottom of the stack. */
static struct part_corner *take_whole(struct raster *r)
{
    struct part_corner *corner = r->setup.parts.split[0].corner;
    for (int k = 0; k < 3; k++)
        part_whole(&r->input, k, &corner[k]);
    return corner;
}

static uint32_t draw_by_size(struct raster *r, struct edges *e)
{
    const unsigned depth = depth_of(r, take_whole(r));
    return depth ? split(r, e, depth, 0) : draw_gouraud(r, e);
}

static uint32_t draw_by_centre(struct raster *r, struct edges *e)
{
    if (height_of(r, take_whole(r)) >= SPLIT_LEAST)
        return split(r, e, PART_DEPTH, 1);
    shade_color6(&r->setup, &r->input); /* exact at each pixel of what is that low */
    return draw_color6(r, e);
}

static void nothing(struct shade_setup *setup, const struct shade_input *in)
{
    (void)setup;
    (void)in;
}

const struct glint_method glint_subdivide_recursive = {
    .id = GLINT_SUBDIVIDE, .vertex_words = COLOUR_WORDS, .setup = shade_gouraud, .draw = draw_by_size};
const struct glint_method glint_subdivide_centre = {
    .id = GLINT_SUBDIVIDE, .vertex_words = COLOUR_WORDS, .setup = nothing, .draw = draw_by_centre};

/* What the adaptive one splits. */
static const struct glint_method split_by_size = {.id = GLINT_SUBDIVIDE, .setup = shade_gouraud, .draw = draw_by_size};

static const struct glint_method *choose(struct raster *r)
{
    return adaptive_treats(&r->input) ? &split_by_size : &glint_gouraud;
}

const struct glint_method glint_subdivide_regular = {.id = GLINT_SUBDIVIDE,
                                                     .vertex_words = ADAPTIVE_WORDS,
                                                     .setup = shade_gouraud,
                                                     .draw = draw_by_size,
                                                     .object = highlighted_mark,
                                                     .choose = choose};
