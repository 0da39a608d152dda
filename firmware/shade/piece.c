/* SPDX-License-Identifier: MIT */
#include "shade/piece.h"

void piece_linear(const uint16_t (*w)[3], int32_t value[3])
{
    int32_t v[3];
    for (int k = 0; k < 3; k++) { /* |sum| <= 2^30 */
        int32_t sum = 0;
        for (int i = 0; i < 3; i++)
            sum += value[i] * w[k][i];
        v[k] = sum >> 15;
    }
    for (int k = 0; k < 3; k++)
        value[k] = v[k];
}

/*
 * Along an edge with difference d of weights the second derivative is -2 sum aij di dj, so the piece's bulge is
 * -sum aij di dj: as the di sum to 0 and |di| <= 1, sum |di dj| <= 5/4, by which it may pass 2^31. sum wi wj <= 1/3.
 */
void piece_quadratic(const uint16_t (*w)[3], int32_t value[3], int32_t bulge[3])
{
    int32_t v[3], a[3];
    for (int k = 0; k < 3; k++) {
        int32_t linear = 0, bend = 0;
        for (int i = 0; i < 3; i++) { /* weights sum to 2^15: |linear| <= 2^30, |bend| <= 2^29 / 3 */
            int j = i == 2 ? 0 : i + 1;
            linear += value[i] * w[k][i];
            bend += fx_mulhi_s32(bulge[i], fx_s32(fx_u32(w[k][i]) * w[k][j])); /* Q28 * Q30: Q26; product <= 2^30 */
        }
        v[k] = (linear >> 15) - (bend >> 12);
        int next = k == 2 ? 0 : k + 1;
        int32_t d[3], sum = 0;
        for (int i = 0; i < 3; i++)
            d[i] = fx_s32(w[next][i]) - w[k][i]; /* |d| <= 2^15 */
        for (int i = 0; i < 3; i++)
            sum += fx_mulhi_s32(bulge[i], d[i] * d[i == 2 ? 0 : i + 1]);
        const int32_t most = INT32_MAX / 4; /* |sum| <= 5/4 * 2^29 */
        a[k] = (sum > most ? -most : sum < -most ? most : -sum) * 4;
    }
    for (int k = 0; k < 3; k++) {
        value[k] = v[k];
        bulge[k] = a[k];
    }
}

static void component(const struct shade_input *in, const int16_t *const corner[3], int axis, int32_t value[3])
{
    for (int k = 0; k < 3; k++)
        value[k] = corner[k][axis];
    if (shade_weight(in))
        piece_linear(shade_weight(in), value);
}

void piece_vectors(struct shade_setup *setup, const struct shade_input *in, const int16_t *const corner[3],
                   struct channel *out)
{
    for (int axis = 0; axis < 3; axis++) {
        int32_t value[3];
        component(in, corner, axis, value);
        plane_linear(&setup->plane, value, &out[axis]);
    }
}

void piece_vectors_perspective(struct shade_setup *setup, const struct shade_input *in,
                               const struct perspective *perspective, const int16_t *const corner[3],
                               struct channel *out)
{
    for (int axis = 0; axis < 3; axis++) {
        int32_t value[3];
        component(in, corner, axis, value);
        perspective_linear(perspective, &setup->plane, value, &out[axis]);
    }
}

static void find_places(const struct shade_input *in, const int16_t *place[3])
{
    for (int k = 0; k < 3; k++)
        place[k] = in->vertices[in->triangle->corner[SHADE_TURN(k)]].position;
}

void piece_place(struct shade_setup *setup, const struct shade_input *in)
{
    const int16_t *place[3];
    if (!object_local(in->object))
        return;
    find_places(in, place);
    piece_vectors(setup, in, place, setup->channel + 3);
}

/* Numerators of half the place, of no fraction of which anything is lost: |value| <= 2^30 in Q15, s < 2^16. */
void piece_place_perspective(struct shade_setup *setup, const struct shade_input *in,
                             const struct perspective *perspective)
{
    const int16_t *place[3];
    if (!object_local(in->object))
        return;
    find_places(in, place);
    for (int axis = 0; axis < 3; axis++) {
        int32_t numerator[3];
        for (int k = 0; k < 3; k++) {
            int32_t value = place[k][axis] * (1 << 15);
            if (in->weight) { /* |finer| <= 2^7, of the source's first two corners; 2 * 2^16 * 2^7 */
                const int8_t *const finer = in->piece->finer[SHADE_TURN(k)];
                const int32_t last = place[SHADE_TURN(2)][axis];
                value = place[0][axis] * in->weight[k][0] + place[1][axis] * in->weight[k][1] +
                        place[2][axis] * in->weight[k][2] +
                        (((place[0][axis] - last) * finer[0] + (place[SHADE_TURN(1)][axis] - last) * finer[1]) >> 8);
            }
            numerator[k] = fx_s32(fx_s64(value) * perspective->s[k] >> 16);
        }
        plane_linear_wide(&setup->plane, numerator, &setup->channel[3 + axis]);
    }
    perspective_linear(perspective, &setup->plane, (const int32_t[3]){Q14(1, 1), Q14(1, 1), Q14(1, 1)},
                       &setup->channel[SHADE_WEIGHT]);
}
