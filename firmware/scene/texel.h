/* SPDX-License-Identifier: MIT */
/* Texels of a scene's textures, as 8-bit colours. */
#ifndef GLINT_TEXEL_H
#define GLINT_TEXEL_H

#include "scene/scene.h"

/* 565 as 0x00RRGGBB: a field's first bits are repeated below it, which is within .5 of what it stands for in 1/255. */
static inline uint32_t texel_expand(uint32_t texel)
{
    const uint32_t red_blue = (texel & 0xf800) << 5 | (texel & 0x1f), green = texel & 0x07e0;
    return red_blue << 3 | ((red_blue >> 2) & 0x70007) | green << 5 | ((green >> 1) & 0x300);
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
