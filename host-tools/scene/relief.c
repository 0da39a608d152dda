/* SPDX-License-Identifier: MIT */
#include "scene/relief.h"

#include "scene/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void set_size(struct model_texture *texture, unsigned width, unsigned height)
{
    texture->width = width;
    texture->height = height;
    texture->normals = model_alloc((size_t)width * height * sizeof *texture->normals);
}

/* The neighbour of texel i of `count`, before or after it. */
static size_t beside(unsigned i, int step, unsigned count, bool clamp)
{
    const int at = (int)i + step, n = (int)count;
    return (size_t)(clamp ? (at < 0 ? 0 : at < n ? at : n - 1) : (at + n) % n);
}

void relief_from_heights(struct model_texture *texture, const double *heights, unsigned width, unsigned height,
                         double across, double down, double steepness)
{
    double steepest = 0;
    set_size(texture, width, height);
    for (unsigned y = 0; y < height; y++)
        for (unsigned x = 0; x < width; x++) {
            const double *row = heights + (size_t)y * width;
            double *n = texture->normals[(size_t)y * width + x];
            const size_t left = beside(x, -1, width, texture->clamp[0]), right = beside(x, 1, width, texture->clamp[0]);
            const size_t up = beside(y, -1, height, texture->clamp[1]), under = beside(y, 1, height, texture->clamp[1]);
            n[0] = (row[left] - row[right]) * across;
            n[1] = (heights[under * width + x] - heights[up * width + x]) * down;
            steepest = fmax(steepest, hypot(n[0], n[1]));
        }
    for (size_t i = 0; i < (size_t)width * height; i++) {
        double *n = texture->normals[i];
        for (int k = 0; k < 2; k++)
            n[k] *= steepest > 0 ? steepness / steepest : 0;
        n[2] = 1;
        vec_normalise(n);
    }
}

void relief_from_normals(struct model_texture *texture, const uint8_t *rgb, unsigned width, unsigned height)
{
    set_size(texture, width, height);
    for (size_t i = 0; i < (size_t)width * height; i++) {
        double *n = texture->normals[i];
        for (size_t k = 0; k < 3; k++)
            n[k] = rgb[3 * i + k] / 127.5 - 1;
        if (n[2] <= 0 || !vec_normalise(n))
            memcpy(n, (double[]){0, 0, 1}, 3 * sizeof *n);
    }
}

/* Perlin's hash of whole numbers, here by a mixer (Wellons) in place of a table, and one of eight directions. */
static double corner(unsigned x, unsigned y, double dx, double dy)
{
    uint32_t h = x * 0x9e3779b9u ^ (y * 0x85ebca6bu + 0x7f4a7c15u);
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    h ^= h >> 16;
    const double angle = (h & 7) * M_PI / 4;
    return cos(angle) * dx + sin(angle) * dy;
}

static double fade(double t)
{
    return t * t * t * (t * (t * 6 - 15) + 10);
}

/* Repeats after px, py cells. */
static double noise(double u, double v, unsigned px, unsigned py)
{
    const double x = floor(u), y = floor(v), dx = u - x, dy = v - y, a = fade(dx), b = fade(dy);
    const unsigned x0 = (unsigned)x % px, y0 = (unsigned)y % py, x1 = (x0 + 1) % px, y1 = (y0 + 1) % py;
    const double low = corner(x0, y0, dx, dy) * (1 - a) + corner(x1, y0, dx - 1, dy) * a;
    const double high = corner(x0, y1, dx, dy - 1) * (1 - a) + corner(x1, y1, dx - 1, dy - 1) * a;
    return low * (1 - b) + high * b;
}

/* At u, v in cells. */
static double height_at(enum relief_kind kind, double u, double v, const unsigned cells[2])
{
    double sum = 0;
    if (kind == RELIEF_WAVES)
        return cos(2 * M_PI * u) / (2 * M_PI);
    if (kind == RELIEF_BUMPS) {
        const double x = u - floor(u) - .5, y = v - floor(v) - .5, r = (x * x + y * y) / (.45 * .45);
        return r < 1 ? (1 - r) * (1 - r) : 0;
    }
    for (unsigned octave = 0; octave < 4; octave++)
        sum += noise(u * (1 << octave), v * (1 << octave), cells[0] << octave, cells[1] << octave) / (1 << octave);
    return sum;
}

void relief_make(struct model_texture *texture, enum relief_kind kind, const unsigned size[2], const unsigned cells[2],
                 double steepness)
{
    double *heights = model_alloc((size_t)size[0] * size[1] * sizeof *heights);
    for (unsigned y = 0; y < size[1]; y++)
        for (unsigned x = 0; x < size[0]; x++)
            heights[(size_t)y * size[0] + x] =
                height_at(kind, (x + .5) * cells[0] / size[0], (size[1] - y - .5) * cells[1] / size[1], cells);
    relief_from_heights(texture, heights, size[0], size[1], (double)size[0] / cells[0], (double)size[1] / cells[1],
                        steepness);
    free(heights);
}
