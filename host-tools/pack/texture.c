/* SPDX-License-Identifier: MIT */
#include "pack/texture.h"

#include "pack/bump.h"
#include "pack/palette.h"
#include "scene/texel.h"

#include <math.h>
#include <stdlib.h>

uint8_t texture_log2(unsigned size)
{
    uint8_t log2 = 0;
    while (1u << log2 < TEXTURE_MOST && size > (1u << log2) * M_SQRT2)
        log2++;
    return log2;
}

/*
 * One axis of resampling, `from` samples of three values to `to`, samples `stride` values apart in either
 * line: a tent as wide as the wider of the two grids, which is linear interpolation upwards, and nothing where both
 * are the same.
 */
static void resample_line(const double *in, unsigned from, double *out, unsigned to, size_t stride, bool clamp)
{
    const double scale = (double)from / to, width = fmax(scale, 1);
    for (unsigned i = 0; i < to; i++) {
        const double middle = (i + .5) * scale - .5;
        double sum[3] = {0, 0, 0}, weights = 0;
        for (int k = (int)ceil(middle - width); k <= (int)floor(middle + width); k++) {
            const double weight = 1 - fabs(k - middle) / width;
            /* NOLINTNEXTLINE(clang-analyzer-core.DivideZero): n is at least 1 */
            const int n = (int)from, at = clamp ? (k < 0 ? 0 : k < n ? k : n - 1) : ((k % n) + n) % n;
            weights += weight;
            for (int c = 0; c < 3; c++)
                sum[c] += weight * in[(size_t)at * stride + (size_t)c];
        }
        for (int c = 0; c < 3; c++)
            out[i * stride + (size_t)c] = sum[c] / weights;
    }
}

/* The picture in the texture's size, its lowest row first, as 0x00RRGGBB. */
static uint32_t *resample(const struct model_texture *in, unsigned width, unsigned height)
{
    const size_t across = 3 * (size_t)width;
    double *line = model_alloc(3 * (size_t)in->width * sizeof *line);
    double *rows = model_alloc(across * in->height * sizeof *rows);
    double *out = model_alloc(across * height * sizeof *out);
    uint32_t *rgb = model_alloc((size_t)width * height * sizeof *rgb);
    for (unsigned y = 0; y < in->height; y++) {
        for (size_t i = 0; i < 3 * (size_t)in->width; i++)
            line[i] = in->rgb[3 * (size_t)in->width * (in->height - 1 - y) + i];
        resample_line(line, in->width, rows + across * y, width, 3, in->clamp[0]);
    }
    for (unsigned x = 0; x < width; x++)
        resample_line(rows + 3 * (size_t)x, in->height, out + 3 * (size_t)x, height, across, in->clamp[1]);
    for (size_t i = 0; i < across * height; i++)
        rgb[i / 3] = rgb[i / 3] << 8 | (uint32_t)lround(out[i]);
    free(line);
    free(rows);
    free(out);
    return rgb;
}

/* Rounded to nearest as fields of 565 with repeated bits. */
static uint16_t to_565(uint32_t rgb)
{
    const uint32_t r = rgb >> 16, g = rgb >> 8 & 0xff, b = rgb & 0xff;
    return (uint16_t)(((r * 31 + 127) / 255) << 11 | ((g * 63 + 127) / 255) << 5 | (b * 31 + 127) / 255);
}

static double squares(uint32_t a, uint32_t b)
{
    double sum = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        const double d = (double)(a >> shift & 0xff) - (double)(b >> shift & 0xff);
        sum += d * d;
    }
    return sum;
}

void texture_pack(const struct model_texture *in, struct texture_packed *out, struct pack_texture_report *report)
{
    if (in->format == TEXTURE_BUMP8) {
        bump_pack(in, out, report);
        return;
    }
    const uint8_t log2[2] = {texture_log2(in->width), texture_log2(in->height)};
    const size_t texels = (size_t)1 << (log2[0] + log2[1]);
    uint32_t *rgb = resample(in, 1u << log2[0], 1u << log2[1]);
    double error = 0;
    *out = (struct texture_packed){.head = {.log2_width = log2[0], .log2_height = log2[1]}};
    out->head.format = (uint8_t)in->format;
    out->head.flags = (uint8_t)((in->bilinear ? TEXTURE_BILINEAR : 0) | (in->clamp[0] ? TEXTURE_CLAMP_U : 0) |
                                (in->clamp[1] ? TEXTURE_CLAMP_V : 0));
    *report = (struct pack_texture_report){
        .name = model_copy(in->name), .read = {in->width, in->height}, .size = {1u << log2[0], 1u << log2[1]}};
    if (in->format == TEXTURE_PALETTE8) {
        uint8_t *index = out->texels = model_alloc(out->size = texels);
        out->palette = model_alloc(PALETTE_MOST * sizeof *out->palette);
        out->head.colours = (uint16_t)palette_make(rgb, texels, index, out->palette, &report->colours_read);
        for (size_t i = 0; i < texels; i++)
            error += squares(rgb[i], out->palette[index[i]]);
    } else {
        uint16_t *fields = out->texels = model_alloc(out->size = texels * sizeof *fields);
        for (size_t i = 0; i < texels; i++) {
            fields[i] = to_565(rgb[i]);
            error += squares(rgb[i], texel_expand(fields[i]));
        }
    }
    report->error = sqrt(error / (3 * (double)texels));
    free(rgb);
}

void texture_free(struct texture_packed *texture)
{
    free(texture->texels);
    free(texture->palette);
    free(texture->rises);
    *texture = (struct texture_packed){0};
}
