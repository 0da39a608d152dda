/* SPDX-License-Identifier: MIT */
/*
 * raster/draw_subdivide.c: triangles split by size and by their centre, the stack of parts at every depth and in every
 * order. Which parts show, and how high they are, is any here, and what shades and draws them.
 *
 *   proves: find_middles height_of depth_of beyond errs_at_centre split take_whole draw_by_size draw_by_centre nothing
 *           choose
 *   assumes: part_place part_height part_shade part_whole part_between
 *   lemmas: subdivide part_corners
 *   options: -eva-precision 0 -eva-min-loop-unroll 3 -eva-slevel 10
 */
#include "proof.h"

#include "shade/part.h"

/*@ requires weights: corner->weight[0] + corner->weight[1] <= 0x8000;
    assigns \result \from *corner, *(in->place[0 .. 2] + (0 .. 1));
    ensures box: -0x20000000 <= \result.x <= 0x20000000 && -0x20000000 <= \result.y <= 0x20000000; */
struct part_place part_place(const struct shade_input *in, const struct part_corner *corner);

/*@ requires box: \forall integer k; 0 <= k < 3 ==>
             -0x20000000 <= p[k].x <= 0x20000000 && -0x20000000 <= p[k].y <= 0x20000000;
    assigns \result \from p[0 .. 2];
    ensures range: 0 <= \result <= 0x3ffff; */
int32_t part_height(const struct part_place p[3]);

/*@ requires weights: corner->weight[0] + corner->weight[1] <= 0x8000;
    requires there: \valid(corner);
    assigns corner->colour[0 .. 2] \from corner->weight[0 .. 1];
    ensures set: \initialized(&corner->colour[0]) && \initialized(&corner->colour[1]) &&
                 \initialized(&corner->colour[2]); */
void part_shade(const struct shade_input *in, struct part_corner *corner);

/*@ requires one: 0 <= k <= 2;
    requires there: \valid(corner);
    assigns *corner \from k;
    ensures set: \initialized(corner); */
void part_whole(const struct shade_input *in, int k, struct part_corner *corner);

/*@ requires there: \valid(out) && \valid_read(a) && \valid_read(b);
    assigns *out \from *a, *b;
    ensures set: \initialized(out); */
void part_between(const struct shade_input *in, const struct part_corner *a, const struct part_corner *b,
                  struct part_corner *out);

#include "firmware/raster/draw_subdivide.c"

static struct raster raster;
volatile uint32_t sink;

int parts_shows(const struct raster *r, const struct part_corner *const corner[3])
{
    return any_flag();
}

uint32_t parts_linear(struct raster *r, struct edges *e, const struct part_corner *const corner[3])
{
    //@ assert \valid_read(corner[0]) && \valid_read(corner[1]) && \valid_read(corner[2]);
    return any_u32(0, 4 << 20);
}

uint32_t parts_quadratic(struct raster *r, struct edges *e, const struct part_corner *const corner[3],
                         const struct part_corner middle[3])
{
    //@ assert \valid_read(middle + (0 .. 2));
    return any_u32(0, 4 << 20);
}

uint32_t draw_gouraud(struct raster *r, struct edges *e)
{
    return any_u32(0, 4 << 20);
}

uint32_t draw_color6(struct raster *r, struct edges *e)
{
    return any_u32(0, 4 << 20);
}

void shade_color6(struct shade_setup *setup, const struct shade_input *in) {}

void shade_gouraud(struct shade_setup *setup, const struct shade_input *in) {}

void prove(void)
{
    struct raster *r = &raster;
    static int16_t place[3][3];
    static int16_t record[2 * SCENE_MAX_LIGHTS + SHADE_VERTEX_WORDS];
    struct edges e;
    any_bytes(record, sizeof record);
    any_bytes(&r->setup, sizeof r->setup);
    r->setup.plane.det = any_u32(1, 1 << 30);
    r->split.area = any_u32(0, 65535);
    r->split.tolerance = any_u32(0, 255);
    r->surface.lights = any_u32(0, SCENE_MAX_LIGHTS);
    r->input.surface = &r->surface;
    r->input.lights[0] = r->input.lights[1] = r->input.lights[2] = record;
    for (int k = 0; k < 3; k++)
        r->input.place[k] = place[k];
    for (int c = 0; c < 3; c++)
        r->palette.top[c] = any_u32(15, 255);
    r->palette.channels = any_flag() ? 1 : 3;
    sink = draw_by_size(r, &e);
    sink = draw_by_centre(r, &e);
    nothing(&r->setup, &r->input);
    choose(r);
}
