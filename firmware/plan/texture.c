/* SPDX-License-Identifier: MIT */
#include "plan/texture.h"

#include "glint.h"

#define MOST_RATIO  (3 << 13) /* 3/4: beyond, the quadratic's bound is not known */
#define MOST_NEARER 4u        /* 2^-6 of a texel, Q8 */

struct texture_spread texture_spread(const struct scene_texture *texture, const uint32_t d[2], int32_t ratio_q15,
                                     uint32_t lit_q8)
{
    struct texture_spread spread = {0, 0, ratio_q15};
    /* Q28 turns to Q8 texels: 2^32 by 2^10 / 2^20 in each */
    spread.texels = (d[0] >> 10 >> (10 - texture->log2_width)) + (d[1] >> 10 >> (10 - texture->log2_height)) + 2;
    const uint64_t worth = fx_u64(spread.texels) * texture->contrast * lit_q8 >> 16; /* 2^23.1 * 2^16 * 2^16 */
    spread.worth = worth < 1u << 24 ? fx_u32(worth) : 1u << 24;
    return spread;
}

uint32_t texture_affine(int32_t q)
{
    const uint32_t square = fx_u32(q * q) >> 15; /* q <= 2^15; rounded down, which enlarges the divisor by 2^-15 */
    return (fx_u32(q) << 16) / (2 * 32768u - square - 1) + 1;
}

uint32_t texture_quadratic(int32_t q)
{
    const uint32_t x = fx_u32(q), square = (x * x >> 15) + 1;                       /* Q15 */
    const uint32_t slope = 6316 + ((x * 3277) >> 15) + ((square * 6554) >> 15) + 3; /* .1927 + .1 q + .2 q^2, Q15 */
    return (square * slope >> 14) + 1;
}

/* A part in Q16 of what there is at most 2^24 of, rounded up; saturated. */
static uint32_t part_of(uint32_t whole, uint32_t part)
{
    const uint64_t product = (fx_u64(whole) * part >> 16) + 1;
    return product < 0xffff ? fx_u32(product) : 0xffff;
}

uint32_t texture_error(const struct texture_spread *spread, unsigned kind)
{
    if (spread->ratio == 0)
        return 0;
    if (kind == GLINT_TEXTURE_AFFINE)
        return part_of(spread->worth, texture_affine(spread->ratio));
    if (kind == GLINT_TEXTURE_QUADRATIC)
        return spread->ratio > MOST_RATIO ? 0xffff : part_of(spread->worth, texture_quadratic(spread->ratio));
    return 0;
}

/* Whether the coordinates of a kind are good enough. */
static int fits(const struct scene_texture *texture, const struct texture_spread *spread, unsigned kind,
                uint32_t allowed)
{
    struct texture_spread columns = {0, spread->texels, spread->ratio};
    if (!(texture->flags & TEXTURE_BILINEAR) && texture_error(&columns, kind) > MOST_NEARER)
        return 0;
    return texture_error(spread, kind) <= allowed;
}

unsigned texture_choose(const struct scene_texture *texture, const struct texture_spread *spread, uint32_t allowed,
                        uint32_t *error)
{
    for (unsigned kind = GLINT_TEXTURE_AFFINE; kind <= GLINT_TEXTURE_QUADRATIC; kind++)
        if (fits(texture, spread, kind, allowed)) {
            *error = texture_error(spread, kind);
            return kind;
        }
    *error = 0;
    return GLINT_TEXTURE_PERSPECTIVE;
}
