/* SPDX-License-Identifier: MIT */
#include "raster/bump.h"

#include "raster/texture.h"

/* The texel's number under a coordinate in Q28. */
static inline uint32_t texel_of(int32_t q28, unsigned log2, int clamp)
{
    const int32_t at = q28 >> (28 - log2), last = (1 << log2) - 1;
    if (clamp)
        return fx_u32(at < 0 ? 0 : at > last ? last : at);
    return fx_wrap_u32(at) & fx_u32(last);
}

static void nearest(struct raster *r, int n)
{
    const struct surface_bump *map = &r->surface.bump;
    for (int i = 0; i < n; i++) {
        const uint32_t column = texel_of(r->uv[0][i], map->log2_width, map->flags & TEXTURE_CLAMP_U);
        const uint32_t row = texel_of(r->uv[1][i], map->log2_height, map->flags & TEXTURE_CLAMP_V);
        const int8_t *texel = map->texel[row << map->log2_width | column];
        r->value[3][i] = (texel[0] * map->steepness + (1 << 6)) >> 7;
        r->value[4][i] = (texel[1] * map->steepness + (1 << 6)) >> 7;
        r->value[5][i] = bump_rise(map->rise, texel[0], texel[1]);
    }
}

/* The columns or rows on either side, and how far the place is from the first to the second, Q11. */
struct beside {
    uint32_t first, second;
    int32_t part;
};

FX_WRAPS static struct beside beside_of(int32_t q28, unsigned log2, int clamp)
{
    if (clamp) /* first: -8 turns less half a texel would be 8 */
        q28 = q28 < 0 ? 0 : q28 > 1 << 28 ? 1 << 28 : q28;
    const int32_t from = fx_wrap_s32(fx_wrap_u32(q28) - ((1u << 27) >> log2));
    const int32_t next = fx_wrap_s32(fx_wrap_u32(from) + ((1u << 28) >> log2));
    return (struct beside){texel_of(from, log2, clamp), texel_of(next, log2, clamp),
                           fx_s32(fx_wrap_u32(from) << log2 << 4 >> 21)};
}

/* Of one component, Q22: |x| <= 2^7 times 2^11 twice. */
static inline int32_t blend(const int8_t *a, const int8_t *b, const int8_t *c, const int8_t *d, int k, int32_t right,
                            int32_t up)
{
    const int32_t low = a[k] * 2048 + (b[k] - a[k]) * right, high = c[k] * 2048 + (d[k] - c[k]) * right;
    return low * 2048 + (high - low) * up;
}

/* Linear between the middles of four texels; z of the x and y that come of it, linear between its entries, which are
 * for the middles of their steps. */
static void bilinear(struct raster *r, int n)
{
    const struct surface_bump *map = &r->surface.bump;
    for (int i = 0; i < n; i++) {
        const struct beside column = beside_of(r->uv[0][i], map->log2_width, map->flags & TEXTURE_CLAMP_U),
                            row = beside_of(r->uv[1][i], map->log2_height, map->flags & TEXTURE_CLAMP_V);
        const int8_t(*low)[2] = map->texel + (row.first << map->log2_width);
        const int8_t(*high)[2] = map->texel + (row.second << map->log2_width);
        int32_t xy[2];
        for (int k = 0; k < 2; k++)
            xy[k] = blend(low[column.first], low[column.second], high[column.first], high[column.second], k,
                          column.part, row.part) >>
                    13; /* Q9, at most 2^16 */
        const int32_t x = xy[0] >> 1, y = xy[1] >> 1;
        const uint32_t square = fx_u32(x * x) + fx_u32(y * y), middle = 64u << 16;
        const uint32_t at = square > middle ? square - middle : 0; /* Q16: below 2^31 */
        const uint16_t *rise = map->rise + (at >> 23);
        r->value[3][i] = (xy[0] * map->steepness + (1 << 15)) >> 16;
        r->value[4][i] = (xy[1] * map->steepness + (1 << 15)) >> 16;
        r->value[5][i] = rise[0] + (((rise[1] - rise[0]) * fx_s32(at >> 9 & 0x3fff) + (1 << 13)) >> 14);
    }
}

void bump_normals(struct raster *r, int x, int y, int n)
{
    texture_coordinates(r, x, y, n);
    if (r->surface.bump.flags & TEXTURE_BILINEAR)
        bilinear(r, n);
    else
        nearest(r, n);
}
