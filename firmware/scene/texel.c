/* SPDX-License-Identifier: MIT */
#include "scene/texel.h"

uint32_t texel_at(const struct scene_header *scene, const struct scene_texture *texture, uint32_t index)
{
    const uint16_t *wide = scene_at(scene, texture->texels);
    const uint8_t *narrow = scene_at(scene, texture->texels);
    const uint32_t *palette = scene_at(scene, texture->palette);
    switch (texture->format) {
    case TEXTURE_RGB565:
        return texel_expand(wide[index]);
    case TEXTURE_PALETTE8:
        return palette[narrow[index]];
    default:
        return (narrow[2 * index] ^ 0x80u) << 8 | (narrow[2 * index + 1] ^ 0x80u);
    }
}

/* The largest difference of a channel. */
static uint32_t difference(uint32_t a, uint32_t b)
{
    uint32_t most = 0;
    /*@ loop invariant 0 <= shift <= 24 && shift % 8 == 0 && most <= 255;
        loop assigns shift, most;
        loop variant 24 - shift; */
    for (int shift = 0; shift < 24; shift += 8) {
        int32_t d = (int32_t)(a >> shift & 0xff) - (int32_t)(b >> shift & 0xff);
        uint32_t size = (uint32_t)(d < 0 ? -d : d);
        most = size > most ? size : most;
    }
    return most;
}

uint16_t texel_contrast(const struct scene_header *scene, const struct scene_texture *texture)
{
    const uint32_t width = 1u << texture->log2_width, height = 1u << texture->log2_height;
    uint32_t most = 0;
    /*@ loop invariant 0 <= v <= height && most <= 255;
        loop assigns v, most;
        loop variant height - v; */
    for (uint32_t v = 0; v < height; v++)
        /*@ loop invariant 0 <= u <= width && most <= 255;
            loop assigns u, most;
            loop variant width - u; */
        for (uint32_t u = 0; u < width; u++) {
            const uint32_t here = texel_at(scene, texture, v * width + u);
            const uint32_t right = u + 1 < width ? u + 1 : texture->flags & TEXTURE_CLAMP_U ? u : 0;
            const uint32_t above = v + 1 < height ? v + 1 : texture->flags & TEXTURE_CLAMP_V ? v : 0;
            uint32_t d = difference(here, texel_at(scene, texture, v * width + right));
            most = d > most ? d : most;
            d = difference(here, texel_at(scene, texture, above * width + u));
            most = d > most ? d : most;
        }
    /* fields of 565 have been rounded by up to .5 each */
    return (uint16_t)(most && texture->format == TEXTURE_RGB565 && most < 255 ? (most + 1) << 8 : most << 8);
}

uint16_t texel_rise(uint16_t steepness, uint32_t i)
{
    /* (128 i + 64) steepness^2 / 2^14 in Q28: of q < 2^15 and 2^28, below 2^29 */
    const uint32_t level = (uint32_t)((128u * i + 64) * (uint64_t)((uint32_t)steepness * steepness) >> 14);
    return level < 1u << 28 ? (uint16_t)fx_root((1u << 28) - level) : 0;
}
