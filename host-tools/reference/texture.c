/* SPDX-License-Identifier: MIT */
#include "reference/texture.h"

#include "scene/texel.h"

#include <math.h>

/* A row or column: beyond the texture it begins again, or its border goes on. */
static uint32_t texture_index(double at, unsigned log2, bool clamp)
{
    const double size = ldexp(1, (int)log2);
    at = clamp ? fmin(fmax(at, 0), size - 1) : at - size * floor(at / size);
    return (uint32_t)at & ((1u << log2) - 1);
}

uint32_t texture_nearest(const struct decode_texture *texture, double column, double row)
{
    const struct scene_texture *head = texture->head;
    const uint32_t x = texture_index(floor(column), head->log2_width, head->flags & TEXTURE_CLAMP_U);
    const uint32_t y = texture_index(floor(row), head->log2_height, head->flags & TEXTURE_CLAMP_V);
    return texel_at(texture->scene, head, y << head->log2_width | x);
}

static void texture_texel(const struct decode_texture *texture, double column, double row, double weight, double rgb[3])
{
    const uint32_t texel = texture_nearest(texture, column, row);
    const bool fields = texture->head->format == TEXTURE_RGB565; /* the first 5 or 6 bits, not rounded to 8 */
    for (int c = 0; c < 3; c++) {
        const unsigned lost = !fields ? 0 : c == 1 ? 2 : 3, value = texel >> (16 - 8 * c) & 0xff;
        rgb[c] += weight * (value >> lost) / (255 >> lost);
    }
}

void texture_sample(const struct decode_texture *texture, double u, double v, double rgb[3])
{
    const struct scene_texture *head = texture->head;
    double x = ldexp(u, head->log2_width), y = ldexp(v, head->log2_height);
    rgb[0] = rgb[1] = rgb[2] = 0;
    if (!(head->flags & TEXTURE_BILINEAR)) {
        texture_texel(texture, x + texture->nudge[0], y + texture->nudge[1], 1, rgb);
        return;
    }
    x -= .5;
    y -= .5;
    const double column = floor(x), row = floor(y), right = x - column, up = y - row;
    texture_texel(texture, column, row, (1 - right) * (1 - up), rgb);
    texture_texel(texture, column + 1, row, right * (1 - up), rgb);
    texture_texel(texture, column, row + 1, (1 - right) * up, rgb);
    texture_texel(texture, column + 1, row + 1, right * up, rgb);
}

void texture_factors(const struct decode_material *material, const double uv[2], unsigned channels, double factor[3])
{
    factor[0] = factor[1] = factor[2] = 1;
    if (!material->texture.head)
        return;
    texture_sample(&material->texture, uv[0], uv[1], factor);
    if (channels == 1) /* exact under lights without a hue; and what a grey picture of a texture means under others */
        factor[0] = material->grey[0] * factor[0] + material->grey[1] * factor[1] + material->grey[2] * factor[2];
}

bool texture_multiplies_all(const struct method *method)
{
    return method->pixel == colour_pixel || method->pixel == subdivide_pixel_size ||
           method->pixel == subdivide_pixel_centre || method->pixel == subdivide_pixel_highlight;
}
