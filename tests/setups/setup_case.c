/* SPDX-License-Identifier: MIT */
/* The triangles of the measurements, made of integers alone, so that every machine has the same. */
#include "tests/setups/setup.h"

/* A hash of n and place, in [low, high). */
FX_WRAPS static int32_t pick(uint32_t n, uint32_t place, int32_t low, int32_t high)
{
    uint32_t x = n * 0x9e3779b9u + place * 0x85ebca6bu + 1;
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    x ^= x >> 16;
    return low + (int32_t)fx_mulhi_u32(x, (uint32_t)(high - low));
}

/* v, each component below 2^14, to length 1 in Q14. */
static void normalise(const int32_t v[3], int16_t out[3])
{
    const uint32_t square = (uint32_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); /* < 3 * 2^28 */
    const unsigned up = fx_clz(square) & ~1u;
    const int32_t scale = (int32_t)(fx_rsqrt_norm(square << up) >> 1); /* 2^45 / (2^(up/2) length) */
    for (int i = 0; i < 3; i++) {
        const int32_t q = fx_mulhi_s32(v[i] * (1 << 17), scale); /* v 2^30 / (2^(up/2) length) */
        out[i] = (int16_t)((q + (1 << (15 - up / 2))) >> (16 - up / 2));
    }
}

static int32_t dot(const int16_t a[3], const int16_t b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void make_normals(struct setup_case *c, uint32_t n)
{
    /* Towards the viewer; the tilt of each normal from that of the first, at most tan 22 degrees of its z. */
    const int32_t base[3] = {pick(n, 0, -6000, 6000), pick(n, 1, -6000, 6000), 8000};
    for (uint32_t k = 0; k < 3; k++) {
        int32_t v[3];
        for (uint32_t i = 0; i < 3; i++)
            v[i] = base[i] + pick(n, 2 + 3 * k + i, -1800, 1800);
        normalise(v, c->normal[k]);
    }
    const int32_t towards[3] = {pick(n, 11, -8000, 8000), pick(n, 12, -8000, 8000), pick(n, 13, 2000, 8000)};
    normalise(towards, c->light);
    for (int k = 0; k < 3; k++) {
        const int32_t bend = ((1 << 28) + (1 << 12) - dot(c->normal[k], c->normal[(k + 1) % 3])) >> 13;
        c->bend[k] = (uint16_t)(bend < 0 ? 0 : bend);
        c->lights[k][0] = (int16_t)((dot(c->light, c->normal[k]) + (1 << 13)) >> 14);
        c->lights[k][1] = 0;
    }
}

void setup_case_make(struct setup_case *c, uint32_t n)
{
    const int32_t size = 128 << pick(n, 20, 0, 5); /* sub-pixels: the triangle's height */
    const int32_t x = pick(n, 21, -4000, 4000), y = pick(n, 22, -4000, 4000);
    /* Corner 0 on top, corner 1 at the right between a fourth and three fourths of the height, corner 2 below. */
    const int32_t place[3][2] = {{x, y},
                                 {x + pick(n, 23, 3 * size / 4, size), y + pick(n, 24, size / 4, 3 * size / 4)},
                                 {x + pick(n, 25, -size / 2, size / 4), y + size}};
    for (int k = 0; k < 3; k++) {
        c->place[k][0] = (int16_t)place[k][0];
        c->place[k][1] = (int16_t)place[k][1];
    }
    make_normals(c, n);
}
