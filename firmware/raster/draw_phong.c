/* SPDX-License-Identifier: MIT */
/* Phong's pixels: the interpolated normal, normalised at each, in the object's axes. */
#include "raster/raster.h"

/* Scales the run's normals to unit length: Q30 in, Q15 out. Components are at most 2^14 in Q14, 1 + 2^-13 for corners
 * that were rounded; an interpolated normal shorter than 2^-6 (opposite corners) counts as its direction's zero. */
static void normalise(struct raster *r, int n)
{
    for (int i = 0; i < n; i++) {
        int32_t x = r->value[0][i] >> 15, y = r->value[1][i] >> 15, z = r->value[2][i] >> 15; /* Q15 */
        uint32_t squared = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);         /* Q30, below 2^31 */
        if (squared < 1u << 18) {
            r->value[0][i] = r->value[1][i] = r->value[2][i] = 0;
            continue;
        }
        unsigned up = fx_clz(squared) & ~1u;                            /* to [2^30, 2^32) by a square's factor */
        int32_t inverse = (int32_t)(fx_rsqrt_norm(squared << up) >> 1); /* Q30, at most 2^30 */
        /* |v| 2^(up / 2) < 2^16; Q15 * Q30 / 2^32 and 2 bits more: Q15 */
        unsigned half = up / 2 + 2;
        r->value[0][i] = fx_mulhi_s32(x * (1 << half), inverse);
        r->value[1][i] = fx_mulhi_s32(y * (1 << half), inverse);
        r->value[2][i] = fx_mulhi_s32(z * (1 << half), inverse);
    }
}

/* n . v, Q15 and Q14 to Q15, at most 1 + 2^-12. */
static inline int32_t dot(const struct raster *r, int i, const q14_t v[3])
{
    return (r->value[0][i] * v[0] + r->value[1][i] * v[1] + r->value[2][i] * v[2] + (1 << 13)) >> 14;
}

/* Adds a light at one pixel. */
static inline void add_light(struct raster *r, int i, unsigned l, const q14_t towards[3], const q14_t half[3])
{
    const struct surface *s = &r->surface;
    int32_t diffuse = dot(r, i, towards);
    diffuse = diffuse < 0 ? 0 : diffuse;
    for (unsigned c = 0; c < s->channels; c++)
        r->sum[i][c] += surface_diffuse((uint32_t)diffuse, s->light[l].diffuse[c]);
    int32_t highlight = s->highlights ? dot(r, i, half) : 0;
    if (highlight <= 0)
        return;
    uint32_t power = fx_power(s->power, (q30_t)((uint32_t)highlight << 15));
    for (unsigned c = 0; c < s->channels; c++)
        r->sum[i][c] += surface_diffuse(power, s->light[l].specular[c]);
}

static void shade_run(struct raster *r, int x, int y, int n)
{
    const struct surface *s = &r->surface;
    const struct object_state *object = r->input.object;
    int channels = object->local ? 6 : 3;
    q14_t towards[3], half[3];
    for (int c = 0; c < channels; c++)
        plane_values(&r->setup.plane, &r->setup.channel[c], x, y, n, r->value[c]);
    normalise(r, n);
    for (int i = 0; i < n; i++)
        for (unsigned c = 0; c < s->channels; c++)
            r->sum[i][c] = s->base[c];
    for (unsigned l = 0; l < s->lights; l++) {
        if (!object->local)
            object_light_at(object, l, 0, towards, half);
        for (int i = 0; i < n; i++) {
            if (object->local) {
                int32_t place[3] = {r->value[3][i] >> 16, r->value[4][i] >> 16, r->value[5][i] >> 16};
                object_light_at(object, l, place, towards, half);
            }
            add_light(r, i, l, towards, half);
        }
    }
}

static uint32_t draw(struct raster *r, struct edges *e)
{
    return raster_runs(r, e, shade_run);
}

const struct glint_method glint_phong = {GLINT_PHONG, 0, 0, shade_phong, draw};
