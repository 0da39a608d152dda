/* SPDX-License-Identifier: MIT */
#include "raster/bump.h"

#include "raster/texture.h"

/* The texel's number under a coordinate in Q28. */
static inline uint32_t texel_of(int32_t q28, unsigned log2, int clamp)
{
    const int32_t at = q28 >> (28 - log2), last = (1 << log2) - 1;
    if (clamp)
        return (uint32_t)(at < 0 ? 0 : at > last ? last : at);
    return (uint32_t)at & (uint32_t)last;
}

void bump_normals(struct raster *r, int x, int y, int n)
{
    const struct surface_bump *map = &r->surface.bump;
    texture_coordinates(r, x, y, n);
    for (int i = 0; i < n; i++) {
        const uint32_t column = texel_of(r->uv[0][i], map->log2_width, map->flags & TEXTURE_CLAMP_U);
        const uint32_t row = texel_of(r->uv[1][i], map->log2_height, map->flags & TEXTURE_CLAMP_V);
        const int8_t *texel = map->texel[row << map->log2_width | column];
        r->value[3][i] = texel[0] * map->steepness >> 7;
        r->value[4][i] = texel[1] * map->steepness >> 7;
        r->value[5][i] = bump_rise(map->rise, texel[0], texel[1]);
    }
}
