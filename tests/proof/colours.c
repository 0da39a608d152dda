/* SPDX-License-Identifier: MIT */
/*
 * shade/gouraud.c, color6.c, flat.c and turn.c: finished colours over triangles and pieces of them, in every format;
 * one value a triangle; backs, of any material and any mesh.
 *
 *   proves: shade_gouraud shade_color6 middle_colours shade_flat opposite
 *   assumes: fx_power plane_linear plane_setup_quadratic dots_sample dots_length_factor dots_quadratic piece_quadratic
 *   lemmas: colours
 *   options: -eva-precision 0 -eva-min-loop-unroll 16 -eva-slevel 40 -eva-split-return full
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "shade/dots.h"
#include "shade/piece.h"

/*@ requires \valid_read(table);
    assigns \result \from *table, s;
    ensures \result <= 0x8000; */
static inline uint32_t fx_power(const struct fx_power *table, q30_t s);

/*@ requires differences: -65535 <= value[1] - value[0] <= 65535 && -65535 <= value[2] - value[0] <= 65535;
    requires there: \valid(channel);
    assigns *channel \from *plane, value[0 .. 2]; */
void plane_linear(const struct plane *plane, const int32_t value[3], struct channel *channel);

/*@ requires \valid(plane);
    assigns plane->thin, plane->slim, plane->far, plane->r2 \from *plane; */
void plane_setup_quadratic(struct plane *plane);

/*@ requires light: light < 8;
    requires there: \valid(samples);
    assigns samples->corner[0 .. 1][0 .. 2], samples->middle[0 .. 1][0 .. 2] \from light;
    ensures set: \initialized(&samples->middle[0][0]) && \initialized(&samples->middle[0][1]) &&
                 \initialized(&samples->middle[0][2]) && \initialized(&samples->middle[1][0]) &&
                 \initialized(&samples->middle[1][1]) && \initialized(&samples->middle[1][2]); */
void dots_sample(const struct shade_input *in, unsigned light, struct dots_samples *samples);

/*@ requires bend: bend <= 65535;
    assigns \result \from bend;
    ensures factor: 0x10000 <= \result <= 0x100000; */
uint32_t dots_length_factor(uint32_t bend);

/*@ requires values: \forall integer k; 0 <= k < 3 ==> -32768 <= value[k] <= 32767;
    requires bulges: \forall integer k; 0 <= k < 3 ==> -0x7fffffff <= bulge[k] <= 0x7fffffff;
    assigns value[0 .. 2], bulge[0 .. 2] \from value[0 .. 2], bulge[0 .. 2]; */
void piece_quadratic(const uint16_t (*w)[3], int32_t value[3], int32_t bulge[3]);

/*@ requires there: \valid(channel) && \valid_read(value + (0 .. 2)) && \valid_read(bulge + (0 .. 2));
    assigns *channel \from value[0 .. 2], bulge[0 .. 2]; */
void dots_quadratic(struct shade_setup *setup, const int32_t value[3], const int32_t bulge[3], struct channel *channel);

#include "firmware/shade/color6.c"
#include "firmware/shade/colour.c"
#include "firmware/shade/flat.c"
#include "firmware/shade/gouraud.c"
#include "firmware/shade/surface.c"
#include "firmware/shade/turn.c"

static struct shade_setup setup;
static struct surface surface;
static struct object_state object;
static struct scene_mesh mesh;
static struct scene_vertex vertex[3];
static struct scene_triangle triangle;
static struct scene_tangent tangent[3];
static int16_t record[3][2 * SCENE_MAX_LIGHTS + SHADE_VERTEX_WORDS], uvs[3][2], place[3][3];
static uint16_t weight[3][3], colours[3][COLOUR_WORDS];

static struct shade_input any_input(void)
{
    struct shade_input in = {.place = {place[0], place[1], place[2]},
                             .lights = {record[0], record[1], record[2]},
                             .triangle = &triangle,
                             .vertices = vertex,
                             .uvs = uvs,
                             .tangents = tangent,
                             .object = &object,
                             .surface = &surface};
    any_bytes(record, sizeof record);
    any_bytes(vertex, sizeof vertex);
    any_bytes(tangent, sizeof tangent);
    any_bytes(uvs, sizeof uvs);
    any_bytes(&triangle, sizeof triangle);
    for (int k = 0; k < 3; k++) {
        triangle.corner[k] = any_u32(0, 2);
        for (int i = 0; i < 3; i++) {
            vertex[k].normal[i] = any_s32(-16386, 16386);
            tangent[k].tangent[i] = any_s32(-16386, 16386);
            weight[k][i] = any_u32(0, 1 << 15);
        }
        tangent[k].sign = any_flag() ? 1 : -1;
    }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2 * SCENE_MAX_LIGHTS; i++)
            record[k][i] = any_s32(-16384, 16383);
    object.mesh = &mesh;
    mesh.uvs = any_flag();
    mesh.tangents = any_flag();
    return in;
}

static void shade(unsigned channels, unsigned red, unsigned green, unsigned blue)
{
    struct shade_input in = any_input();
    any_bytes(&surface, sizeof surface);
    static struct fx_power power;
    surface.power = &power;
    surface.form = 0;
    surface.channels = channels;
    surface.top[0] = red << 15;
    surface.top[1] = green << 15;
    surface.top[2] = blue << 15;
    in.colours = colours;
    //@ loop unroll 9;
    for (unsigned lights = 0; lights <= SCENE_MAX_LIGHTS; lights++) {
        surface.lights = lights;
        in.weight = 0;
        shade_flat(&setup, &in);
        shade_gouraud(&setup, &in);
        shade_color6(&setup, &in);
        in.weight = weight;
        shade_gouraud(&setup, &in);
        shade_color6(&setup, &in);
    }
}

void prove(void)
{
    static struct shade_turned turned;
    shade(1, 255, 0, 0);
    shade(1, 15, 0, 0);
    shade(3, 31, 63, 31);
    shade(3, 255, 255, 255);
    //@ loop unroll 3;
    for (unsigned words = 0; words < 3; words++) {
        struct shade_input in = any_input();
        surface.lights = any_u32(0, SCENE_MAX_LIGHTS);
        shade_turn(&turned, &in, words == 2 ? SHADE_VERTEX_WORDS : words == 1 ? COLOUR_WORDS : 0);
    }
}
