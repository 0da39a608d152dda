/* SPDX-License-Identifier: MIT */
/* Texels of a scene's textures, as 8-bit colours. */
#ifndef GLINT_TEXEL_H
#define GLINT_TEXEL_H

#include "scene/scene.h"

/* 565 as 0x00RRGGBB, each field rounded to the nearest 1/255: 527/64 is 255/31 and 259/64 is 255/63, near enough. */
static inline uint32_t texel_expand(uint32_t texel)
{
    const uint32_t red = (texel >> 11) * 527 + 23, green = (texel >> 5 & 63) * 259 + 33, blue = (texel & 31) * 527 + 23;
    return red >> 6 << 16 | green >> 6 << 8 | blue >> 6;
}

/* Texel `index` of a checked texture of colours, 0x00RRGGBB, rounded; of normals, 0x0000XXYY, each 128 more than it is.
 */
uint32_t texel_at(const struct scene_header *scene, const struct scene_texture *texture, uint32_t index);

/* The least scene_texture.contrast that is true. Repeating ones have their other end's texels beside the last. */
uint16_t texel_contrast(const struct scene_header *scene, const struct scene_texture *texture);

/* A bump map's z in Q14 for x^2 + y^2 in the middle of 128 i .. 128 i + 127, x and y as texels: that of a unit vector.
 */
uint16_t texel_rise(uint16_t steepness, uint32_t i);

#endif
