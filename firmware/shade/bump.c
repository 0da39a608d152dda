/* SPDX-License-Identifier: MIT */
#include "shade/bump.h"

#include "shade/dots.h"
#include "shade/piece.h"
#include "shade/uv.h"

/* A unit vector's product with another, both within 2^-10 of it: at most 2^14 (1 + 2^-8). */
static int32_t dot(const q14_t a[3], const q14_t b[3])
{
    return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + (1 << 13)) >> 14;
}

void bump_turn(const struct bump_frame *frame, const q14_t v[3], int16_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = fx_s16(dot(frame->axis[i], v));
}

void bump_make_frame(const q14_t tangent[3], int sign, const q14_t normal[3], struct bump_frame *out)
{
    for (int i = 0; i < 3; i++) {
        const int j = i == 2 ? 0 : i + 1, k = j == 2 ? 0 : j + 1;
        const int32_t cross = (normal[j] * tangent[k] - normal[k] * tangent[j] + (1 << 13)) >> 14; /* 2^29 at most */
        out->axis[0][i] = tangent[i];
        out->axis[1][i] = fx_s16(sign < 0 ? -cross : cross);
        out->axis[2][i] = normal[i];
    }
}

/* With S = a + b and m = 2 / |S| the middle is m S / 2, and the bulge 2 S - 2 m S. */
void bump_average(const int16_t a[3], const int16_t b[3], int32_t bulge[3])
{
    int32_t sum[3], quarter = 0; /* of |S|^2, which is 1 for equal ends: Q28 */
    for (int i = 0; i < 3; i++) {
        sum[i] = a[i] + b[i]; /* |sum| <= 2^15 (1 + 2^-8): halves' squares sum to 2^28 (1 + 2^-7) */
        quarter += (sum[i] >> 1) * (sum[i] >> 1);
    }
    const int32_t square = (quarter + (1 << 11)) >> 12, one = 1 << 16;
    /* m >= 1 but for roundings; |S| m <= 2 (1 + 2^-8): |S (m - 1)| < 2^31 in Q30, half of it fits */
    const int32_t longer = fx_s32(dots_length_factor(square < one ? fx_u32(one - square) : 0)) - one;
    for (int i = 0; i < 3; i++)
        bulge[i] = -(sum[i] * (longer >> 1));
}

/* The triangle's corners as bump mapping sees them. */
struct corners {
    struct bump_frame frame[3];
    const struct scene_vertex *vertex[3];
};

static void find_corners(const struct shade_input *in, struct corners *out)
{
    for (int k = 0; k < 3; k++) {
        const struct scene_tangent *t = &in->tangents[in->triangle->corner[SHADE_TURN(k)]];
        out->vertex[k] = &in->vertices[in->triangle->corner[SHADE_TURN(k)]];
        bump_make_frame(t->tangent, t->sign, out->vertex[k]->normal, &out->frame[k]);
    }
}

/* L' and H' of a light, [which][corner or edge][axis]. */
struct samples {
    int16_t corner[2][3][3];
    int32_t bulge[2][3][3];
};

static void directions(const struct shade_input *in, unsigned light, const int16_t *position, q14_t out[2][3])
{
    const int32_t place[3] = {position[0], position[1], position[2]};
    const struct object_light *far = &in->object->light[light];
    if (USES(USES_POINT_LIGHT | USES_LOCAL_VIEWER) && in->object->local) {
        object_light_at(in->object, light, place, out[0], out[1]);
        return;
    }
    for (int i = 0; i < 3; i++) {
        out[0][i] = far->towards[i];
        out[1][i] = far->half[i];
    }
}

/* A unit vector half-way between two. */
static void half_way(const q14_t a[3], const q14_t b[3], q14_t out[3])
{
    const int32_t sum[3] = {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    object_unit(sum, out);
}

/* L' and H' in a frame of the edge's middle (the paper's way), and their bulges. */
static void rebuild(const struct shade_input *in, const struct corners *corners, unsigned light, int a, int b,
                    int upright, struct samples *samples)
{
    const struct scene_vertex *va = corners->vertex[a], *vb = corners->vertex[b];
    struct bump_frame frame;
    q14_t normal[3], tangent[3], towards[2][3];
    int16_t position[3];
    half_way(va->normal, vb->normal, normal);
    half_way(corners->frame[a].axis[0], corners->frame[b].axis[0], tangent);
    if (upright) {
        const int32_t lean = dot(normal, tangent);
        int32_t v[3];
        for (int i = 0; i < 3; i++)
            v[i] = tangent[i] * (1 << 14) - lean * normal[i]; /* below 2^30 */
        object_unit(v, tangent);
    }
    bump_make_frame(tangent, in->tangents[in->triangle->corner[SHADE_TURN(a)]].sign, normal, &frame);
    for (int i = 0; i < 3; i++)
        position[i] = fx_s16((va->position[i] + vb->position[i]) >> 1);
    directions(in, light, position, towards);
    for (int which = 0; which < 2; which++) {
        int16_t middle[3];
        bump_turn(&frame, towards[which], middle);
        for (int i = 0; i < 3; i++) /* 2 (Ia + Ib) - 4 I: below 2^31 */
            samples->bulge[which][a][i] =
                (samples->corner[which][a][i] + samples->corner[which][b][i] - 2 * middle[i]) * (1 << 15);
    }
}

/* A template: `quadratic` and `middle` are constant; without the first there are no bulges. */
static inline __attribute__((always_inline)) void sample(const struct shade_input *in, const struct corners *corners,
                                                         unsigned light, int quadratic, enum bump_middle middle,
                                                         struct samples *samples)
{
    for (int k = 0; k < 3; k++) {
        q14_t towards[2][3];
        directions(in, light, corners->vertex[k]->position, towards);
        for (int which = 0; which < 2; which++)
            bump_turn(&corners->frame[k], towards[which], samples->corner[which][k]);
    }
    for (int k = 0; quadratic && k < 3; k++) {
        const int next = k == 2 ? 0 : k + 1;
        if (middle != BUMP_AVERAGE)
            rebuild(in, corners, light, k, next, middle == BUMP_UPRIGHT, samples);
        for (int which = 0; middle == BUMP_AVERAGE && which < 2; which++)
            bump_average(samples->corner[which][k], samples->corner[which][next], samples->bulge[which][k]);
    }
}

/* Whether the triangle is drawn straight into 8-bit grey (raster/bump_grey.c), which shifts coordinates of 32 bits down
 * to those of texels: not of a map one texel wide. */
static int is_straight(const struct shade_setup *setup, const struct shade_input *in, int quadratic)
{
    const struct surface *s = in->surface;
    return surface_fold(s) && surface_lights(s) == 1 && in->grey_table && !setup->plane.sliver &&
           (!quadratic || !setup->plane.slim) && setup->uv_kind == GLINT_TEXTURE_AFFINE && !s->bump.flags &&
           s->bump.log2_width;
}

/* For that, L' times the material's diffuse light, and x and y of L' and H' times the map's steepness; Q15 factors. */
static void fold(const struct surface *s, struct samples *samples, int quadratic)
{
    for (int which = 0; which < 2; which++)
        for (int axis = 0; axis < 3; axis++) {
            const uint32_t light = which ? 1u << 15 : surface_fold(s) >> 1;
            const int32_t factor = fx_s32(axis < 2 ? light * s->bump.steepness >> 14 : light); /* at most 2^15 */
            for (int k = 0; k < 3; k++) {
                int16_t *value = &samples->corner[which][k][axis];
                *value = fx_s16((*value * factor + (1 << 14)) >> 15);
                if (quadratic)
                    samples->bulge[which][k][axis] = fx_mulhi_s32(samples->bulge[which][k][axis], factor << 15) * 4;
            }
        }
}

/* The three components as quadratic channels. */
static void quadratic_vector(struct shade_setup *setup, const struct shade_input *in, const int16_t (*corner)[3],
                             const int32_t (*edge)[3], struct channel *out)
{
    for (int axis = 0; axis < 3; axis++) {
        int32_t value[3], bulge[3];
        for (int k = 0; k < 3; k++) {
            value[k] = corner[k][axis];
            bulge[k] = edge[k][axis];
        }
        if (shade_weight(in))
            piece_quadratic(shade_weight(in), value, bulge);
        dots_quadratic(setup, value, bulge, &out[axis]);
    }
}

/* |sum Vi li|^2 = 1 - sum aij li lj of unit vectors, aij = |Vi - Vj|^2 = 4 kij: corner values 1, bulges aij (Duff's
 * denominator: eq. 36-42 with f = C.C). Returns the largest of them, Q28. */
static int32_t square_bulges(const int16_t (*corner)[3], int32_t bulge[3])
{
    int32_t most = 0;
    for (int k = 0; k < 3; k++) {
        const int16_t *a = corner[k], *b = corner[k == 2 ? 0 : k + 1];
        bulge[k] = 0;
        for (int i = 0; i < 3; i++) /* at most 4 (1 + 2^-7) in all */
            bulge[k] += (a[i] - b[i]) * (a[i] - b[i]);
        most = bulge[k] > most ? bulge[k] : most;
    }
    return most;
}

void bump_bends(const struct shade_input *in, uint16_t bend[SCENE_MAX_LIGHTS][2][3])
{
    struct corners corners;
    find_corners(in, &corners);
    for (unsigned i = 0; i < surface_lights(in->surface); i++) {
        struct samples samples;
        int32_t difference[3]; /* 4 k */
        sample(in, &corners, i, 0, BUMP_AVERAGE, &samples);
        for (int which = 0; which < 2; which++) {
            square_bulges((const int16_t(*)[3])samples.corner[which], difference);
            for (int k = 0; k < 3; k++) { /* a rounding of the corners more */
                const uint32_t rounded = (fx_u32(difference[k]) >> 14) + 4;
                bend[i][which][k] = fx_u16(rounded < 65535 ? rounded : 65535);
            }
        }
    }
}

/* 1 less the square: for a table of reciprocal lengths. */
static void square_channel(struct shade_setup *setup, const struct shade_input *in, int32_t bulge[3],
                           struct channel *out)
{
    int32_t value[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++)
        /* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): there are bulges where `length` is set */
        bulge[k] = -bulge[k];
    if (shade_weight(in))
        piece_quadratic(shade_weight(in), value, bulge);
    dots_quadratic(setup, value, bulge, out);
}

/* Linear, or quadratic through middles of a kind: templates. */
static inline __attribute__((always_inline)) void setup_lights(struct shade_setup *setup, const struct shade_input *in,
                                                               int quadratic, enum bump_middle middle)
{
    struct corners corners;
    const struct surface *s = in->surface;
    find_corners(in, &corners);
    uv_setup(setup, in, in->texture);
    if (quadratic)
        plane_setup_quadratic(&setup->plane);
    setup->quadratic = fx_u8(quadratic);
    setup->in_steps = fx_u8(is_straight(setup, in, quadratic));
    for (unsigned i = 0; i < surface_lights(s); i++) {
        struct samples samples;
        struct channel *channel = setup->bump + BUMP_CHANNELS * i;
        sample(in, &corners, i, quadratic, middle, &samples);
        if (setup->in_steps)
            fold(s, &samples, quadratic);
        setup->diffuse_lights |= fx_u8(1u << i);
        setup->specular_lights |= fx_u8(fx_u32(surface_highlights(s)) << i);
        for (int which = 0; which < (surface_highlights(s) ? 2 : 1); which++, channel += BUMP_HALF) {
            const int16_t(*corner)[3] = (const int16_t(*)[3])samples.corner[which];
            if (quadratic)
                quadratic_vector(setup, in, corner, (const int32_t(*)[3])samples.bulge[which], channel);
            else
                piece_vectors(setup, in, (const int16_t *const[]){corner[0], corner[1], corner[2]}, channel);
        }
    }
}

void shade_bump_linear(struct shade_setup *setup, const struct shade_input *in)
{
    setup_lights(setup, in, 0, BUMP_AVERAGE);
}

void shade_bump_quadratic(struct shade_setup *setup, const struct shade_input *in)
{
    setup_lights(setup, in, 1, BUMP_AVERAGE);
}

void shade_bump_frames(struct shade_setup *setup, const struct shade_input *in)
{
    setup_lights(setup, in, 1, BUMP_FRAME);
}

void shade_bump_upright(struct shade_setup *setup, const struct shade_input *in)
{
    setup_lights(setup, in, 1, BUMP_UPRIGHT);
}

/* 1 - |V|^2 = sum aij li lj, sum li lj <= 1/3, must stay below 1/4 for the table of reciprocal lengths, roundings too.
 */
#define MOST_BULGE (fx_s32((1u << 28) * 3 / 4 - (1u << 20)))

void shade_bump_normalised(struct shade_setup *setup, const struct shade_input *in)
{
    struct corners corners;
    struct perspective correct;
    const struct perspective *perspective = USES(USES_PERSPECTIVE) && perspective_setup(&correct, in) ? &correct : 0;
    const struct surface *s = in->surface;
    const int count = surface_highlights(s) ? 2 : 1;
    find_corners(in, &corners);
    uv_setup(setup, in, in->texture);
    plane_setup_quadratic(&setup->plane);
    for (unsigned i = 0; i < surface_lights(s); i++) {
        struct samples samples;
        int32_t bulge[2][3], most = 0;
        struct channel *channel = setup->bump + BUMP_CHANNELS * i;
        sample(in, &corners, i, 0, BUMP_AVERAGE, &samples);
        setup->diffuse_lights |= fx_u8(1u << i);
        setup->specular_lights |= fx_u8((count == 2) << i);
        if (!perspective && is_straight(setup, in, 1)) { /* there is one light */
            for (int which = 0; which < count; which++) {
                const int32_t largest = square_bulges((const int16_t(*)[3])samples.corner[which], bulge[which]);
                most = largest > most ? largest : most;
            }
            setup->in_steps = setup->length = most <= MOST_BULGE;
        }
        for (int which = 0; which < count && setup->length; which++)
            square_channel(setup, in, bulge[which], setup->bump + BUMP_SQUARE + which);
        if (setup->in_steps)
            fold(s, &samples, 0);
        for (int which = 0; which < count; which++, channel += BUMP_HALF) {
            const int16_t(*corner)[3] = (const int16_t(*)[3])samples.corner[which];
            const int16_t *const ends[3] = {corner[0], corner[1], corner[2]};
            if (perspective)
                piece_vectors_perspective(setup, in, perspective, ends, channel);
            else
                piece_vectors(setup, in, ends, channel);
        }
    }
}
