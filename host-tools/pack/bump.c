/* SPDX-License-Identifier: MIT */
#include "pack/bump.h"

#include "scene/texel.h"
#include "scene/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The sum of the normals of column or row i of `to` in those of `from`, each by its share. */
static void add_shares(const double (*in)[3], unsigned i, unsigned from, unsigned to, size_t stride, double out[3])
{
    const double low = (double)i * from / to, high = (double)(i + 1) * from / to;
    for (unsigned k = (unsigned)low; k < from && k < high; k++) {
        const double share = fmin(high, k + 1) - fmax(low, k);
        for (int axis = 0; axis < 3; axis++)
            out[axis] += share * in[k * stride][axis];
    }
}

/* The normals in the texture's size, the lowest row first, unit. */
static void resample(const struct model_texture *in, unsigned width, unsigned height, double (*out)[3])
{
    double(*rows)[3] = model_alloc((size_t)width * in->height * sizeof *rows);
    for (size_t y = 0; y < in->height; y++)
        for (unsigned x = 0; x < width; x++)
            add_shares((const double(*)[3])in->normals + y * in->width, x, in->width, width, 1, rows[y * width + x]);
    for (unsigned y = 0; y < height; y++)
        for (unsigned x = 0; x < width; x++) {
            double *n = out[(size_t)(height - 1 - y) * width + x];
            memset(n, 0, 3 * sizeof *n);
            add_shares((const double(*)[3])rows + x, y, in->height, height, width, n);
            if (!vec_normalise(n))
                n[2] = 1;
        }
    free(rows);
}

void bump_pack(const struct model_texture *in, struct texture_packed *out, struct pack_texture_report *report)
{
    const unsigned log2[2] = {texture_log2(in->width), texture_log2(in->height)};
    const size_t texels = (size_t)1 << (log2[0] + log2[1]);
    double(*normal)[3] = model_alloc(texels * sizeof *normal), steepest = 0, error = 0;
    int8_t *texel = model_alloc(2 * texels);
    resample(in, 1u << log2[0], 1u << log2[1], normal);
    for (size_t i = 0; i < texels; i++)
        steepest = fmax(steepest, fmax(fabs(normal[i][0]), fabs(normal[i][1])));
    *out = (struct texture_packed){.texels = texel, .size = 2 * texels};
    out->head = (struct scene_texture){.log2_width = (uint8_t)log2[0],
                                       .log2_height = (uint8_t)log2[1],
                                       .format = TEXTURE_BUMP8,
                                       .flags = (uint8_t)((in->bilinear ? TEXTURE_BILINEAR : 0) |
                                                          (in->clamp[0] ? TEXTURE_CLAMP_U : 0) |
                                                          (in->clamp[1] ? TEXTURE_CLAMP_V : 0))};
    out->head.steepness = (uint16_t)fmax(1, fmin(TEXTURE_UNIT, ceil(steepest * TEXTURE_UNIT * 128 / 127)));
    const double unit = (double)out->head.steepness / (TEXTURE_UNIT * 128);
    out->rises = model_alloc(TEXTURE_RISES * sizeof *out->rises);
    for (uint32_t i = 0; i < TEXTURE_RISES; i++)
        out->rises[i] = texel_rise(out->head.steepness, i);
    for (size_t i = 0; i < texels; i++) {
        double is[3], square = 0;
        for (int k = 0; k < 2; k++) {
            texel[2 * i + (size_t)k] = (int8_t)fmax(-127, fmin(127, round(normal[i][k] / unit)));
            is[k] = texel[2 * i + (size_t)k];
            square += is[k] * is[k];
            is[k] *= unit;
        }
        is[2] = out->rises[(unsigned)square / 128] / (double)TEXTURE_UNIT;
        for (int k = 0; k < 3; k++)
            error += (is[k] - normal[i][k]) * (is[k] - normal[i][k]);
    }
    *report = (struct pack_texture_report){.name = model_copy(in->name),
                                           .read = {in->width, in->height},
                                           .size = {1u << log2[0], 1u << log2[1]},
                                           .normals = true,
                                           .error = 255 * sqrt(error / (double)texels)};
    free(normal);
}
