/* SPDX-License-Identifier: MIT */
/*
 * shade/part.c and shade/colour.c: colours at corners of parts, of any triangle, cut or whole, under any lights, near
 * and far. object_light_at() and object_unit() are any vectors within 2^-12 of unit ones here, of what they are asked.
 *
 *   proves: part_shade part_whole part_between colour_finished colour_corner
 *   assumes: part_weights surface_shade
 *   lemmas: part_shade part_corners
 *   options: -eva-precision 0 -eva-min-loop-unroll 3 -eva-slevel 60
 */
#include "proof.h"

#include "parts.h"

/*@ requires \valid_read(surface) && \valid_read(lights_q14 + (0 .. 2 * surface->lights - 1));
    requires \valid(out + (0 .. surface->channels - 1));
    assigns out[0 .. surface->channels - 1] \from *surface, lights_q14[0 .. 2 * surface->lights - 1];
    ensures set: \initialized(out + (0 .. surface->channels - 1)); */
void surface_shade(const struct surface *surface, const int16_t *lights_q14, uint32_t *out);

#include "firmware/shade/colour.c"

static void unit(q14_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = any_s32(-16388, 16388);
}

void object_unit(const int32_t v[3], q14_t out[3])
{
    for (int i = 0; i < 3; i++) {
        //@ assert -0x40000000 < v[i] < 0x40000000;
    }
    unit(out);
}

void object_light_at(const struct object_state *object, unsigned light, const int32_t place[3], q14_t towards[3],
                     q14_t half[3])
{
    //@ assert light < SCENE_MAX_LIGHTS;
    for (int i = 0; i < 3; i++) {
        //@ assert -0x8000 <= place[i] <= 0x7fff;
    }
    unit(towards);
    unit(half);
}

static struct surface surface;
static struct object_state object;
static struct scene_vertex vertex[3];
static int16_t record[3][2 * SCENE_MAX_LIGHTS + COLOUR_WORDS];

void prove(void)
{
    static uint16_t weight[3][3], colours[3][COLOUR_WORDS];
    struct scene_triangle triangle = {.corner = {any_u32(0, 2), any_u32(0, 2), any_u32(0, 2)},
                                      .material = any_u32(0, 255)};
    struct shade_input in = {.lights = {record[0], record[1], record[2]},
                             .triangle = &triangle,
                             .vertices = vertex,
                             .object = &object,
                             .surface = &surface};
    struct part_corner a, b, out;
    any_bytes(&surface, sizeof surface);
    any_bytes(&object, sizeof object);
    any_bytes(vertex, sizeof vertex);
    any_bytes(record, sizeof record);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            vertex[k].normal[i] = any_s32(-16386, 16386);
            weight[k][i] = any_u32(0, PART_ONE);
        }
    for (int i = 0; i < 2; i++) {
        a.weight[i] = any_u32(0, PART_ONE);
        b.weight[i] = any_u32(0, PART_ONE);
    }
    //@ loop unroll 2;
    for (int grey = 0; grey < 2; grey++)
        //@ loop unroll 9;
        for (unsigned lights = 0; lights <= SCENE_MAX_LIGHTS; lights++) {
            surface.channels = grey ? 1 : 3;
            surface.lights = lights;
            in.weight = 0;
            in.colours = 0;
            part_shade(&in, &a);
            part_between(&in, &a, &b, &out);
            part_whole(&in, any_s32(0, 2), &out);
            in.colours = colours;
            part_whole(&in, any_s32(0, 2), &out);
            in.weight = weight;
            part_shade(&in, &a);
            part_whole(&in, any_s32(0, 2), &out);
        }
}
