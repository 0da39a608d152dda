/* SPDX-License-Identifier: MIT */
/*
 * raster/draw_highlight.c: triangles split at a highlight, wherever its summit is and however their edges are halved.
 * What shades, tests and draws is any here.
 *
 *   proves: brightness differs is_short halve draw_fan point_of find_summit draw choose
 *   assumes: part_place part_weights part_shade part_whole part_between summit_find highlighted_signs
 *   lemmas: highlight part_corners
 *   options: -eva-precision 0 -eva-min-loop-unroll 3 -eva-slevel 300 -eva-split-return full
 */
#include "proof.h"

#include "plan/summit.h"
#include "shade/part.h"

/*@ requires weights: corner->weight[0] + corner->weight[1] <= 0x8000;
    assigns \result \from *corner, *(in->place[0 .. 2] + (0 .. 1));
    ensures box: -0x20000000 <= \result.x <= 0x20000000 && -0x20000000 <= \result.y <= 0x20000000; */
struct part_place part_place(const struct shade_input *in, const struct part_corner *corner);

/*@ requires weights: corner->weight[0] + corner->weight[1] <= 0x8000;
    assigns weight[0 .. 2] \from corner->weight[0 .. 1], in->weight[0 .. 2][0 .. 2];
    ensures set: \initialized(weight) && \initialized(weight + 1) && \initialized(weight + 2);
    ensures each: weight[0] <= 0x8000 && weight[1] <= 0x8000 && weight[2] <= 0x8000;
    ensures whole: weight[0] + weight[1] + weight[2] == 0x8000; */
void part_weights(const struct shade_input *in, const struct part_corner *corner, uint16_t weight[3]);

/*@ requires weights: corner->weight[0] + corner->weight[1] <= 0x8000;
    requires there: \valid(corner);
    assigns corner->colour[0 .. 2] \from corner->weight[0 .. 1];
    ensures set: \initialized(&corner->colour[0]);
    ensures rgb: in->surface->channels == 1 || (\initialized(&corner->colour[1]) && \initialized(&corner->colour[2]));
 */
void part_shade(const struct shade_input *in, struct part_corner *corner);

/*@ requires one: 0 <= k <= 2;
    requires there: \valid(corner);
    assigns *corner \from k;
    ensures at: \initialized(&corner->weight[0]) && \initialized(&corner->weight[1]);
    ensures set: \initialized(&corner->colour[0]);
    ensures rgb: in->surface->channels == 1 || (\initialized(&corner->colour[1]) && \initialized(&corner->colour[2]));
 */
void part_whole(const struct shade_input *in, int k, struct part_corner *corner);

/*@ requires there: \valid(out) && \valid_read(a) && \valid_read(b);
    assigns *out \from *a, *b;
    ensures at: \initialized(&out->weight[0]) && \initialized(&out->weight[1]);
    ensures set: \initialized(&out->colour[0]);
    ensures rgb: in->surface->channels == 1 || (\initialized(&out->colour[1]) && \initialized(&out->colour[2])); */
void part_between(const struct shade_input *in, const struct part_corner *a, const struct part_corner *b,
                  struct part_corner *out);

/*@ requires light: light < 8;
    requires places: \forall integer k, i; 0 <= k < 3 && 0 <= i < 3 ==> -0x8000 <= corner[k].place[i] <= 0x7fff;
    requires normals: \forall integer k, i; 0 <= k < 3 && 0 <= i < 3 ==> -16386 <= corner[k].normal[i] <= 16386;
    requires there: \valid_read(corner + (0 .. 2)) && \valid(weight + (0 .. 2)) && \valid(opposite);
    assigns \result, weight[0 .. 2], *opposite \from corner[0 .. 2], light;
    ensures place: SUMMIT_NONE <= \result <= SUMMIT_EDGE;
    ensures set: \initialized(weight) && \initialized(weight + 1) && \initialized(weight + 2);
    ensures each: weight[0] <= 0x400 && weight[1] <= 0x400 && weight[2] <= 0x400;
    ensures opposite: 0 <= *opposite <= 2; */
enum summit_place summit_find(const struct object_state *object, unsigned light,
                              const struct highlighted_point corner[3], uint16_t weight[3], int *opposite);

/*@ requires there: \valid_read(point);
    assigns \result \from *point; */
struct highlighted_signs highlighted_signs(const struct object_state *object, unsigned lights,
                                           const struct highlighted_point *point);

#include "firmware/raster/draw_highlight.c"

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

uint32_t draw_gouraud(struct raster *r, struct edges *e)
{
    return any_u32(0, 4 << 20);
}

void shade_gouraud(struct shade_setup *setup, const struct shade_input *in) {}

void prove(void)
{
    struct raster *r = &raster;
    static int16_t place[3][3], record[2 * SCENE_MAX_LIGHTS + SHADE_VERTEX_WORDS];
    static struct scene_vertex vertex[3];
    static struct object_state object;
    struct scene_triangle triangle = {.corner = {any_u32(0, 2), any_u32(0, 2), any_u32(0, 2)}};
    struct edges e;
    any_bytes(record, sizeof record);
    any_bytes(vertex, sizeof vertex);
    any_bytes(&r->setup, sizeof r->setup);
    r->split.threshold = any_u32(0, 255);
    r->surface.lights = any_u32(0, SCENE_MAX_LIGHTS);
    r->input.surface = &r->surface;
    r->input.object = &object;
    r->input.vertices = vertex;
    r->input.triangle = &triangle;
    for (int k = 0; k < 3; k++) {
        r->input.lights[k] = record;
        r->input.place[k] = place[k];
        r->palette.top[k] = any_u32(15, 255);
        for (int i = 0; i < 3; i++)
            vertex[k].normal[i] = any_s32(-16386, 16386);
    }
    //@ loop unroll 2;
    for (int grey = 0; grey < 2; grey++) {
        r->surface.channels = r->palette.channels = grey ? 1 : 3;
        sink = draw(r, &e);
    }
    choose(r);
}
