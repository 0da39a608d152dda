/* SPDX-License-Identifier: MIT */
#include "tests/choices/wraps.h"

#include "raster/edges.h"
#include "shade/shade.h"

#include <math.h>
#include <stddef.h>

struct wraps wraps;

void wraps_begin(void)
{
    wraps = (struct wraps){.fraction = WRAPS_FRACTION_OWN,
                           .subpixel = WRAPS_SUBPIXEL_OWN,
                           .reciprocal = parts_reciprocals[PARTS_RECIPROCAL_OWN].run,
                           .root = parts_roots[PARTS_ROOT_OWN].run};
}

/* --- reciprocal and root ---------------------------------------------------------------------------------------- */

uint32_t __wrap_fx_recip_norm(uint32_t m);
uint32_t __wrap_fx_rsqrt_norm(uint32_t m);

uint32_t __wrap_fx_recip_norm(uint32_t m)
{
    wraps.reciprocals++;
    return wraps.reciprocal(m);
}

uint32_t __wrap_fx_rsqrt_norm(uint32_t m)
{
    wraps.roots++;
    return wraps.root(m);
}

/* --- corners ---------------------------------------------------------------------------------------------------- */

int __real_plane_setup(struct plane *plane, const int16_t *const p[3], unsigned width, unsigned height);
int __wrap_plane_setup(struct plane *plane, const int16_t *const p[3], unsigned width, unsigned height);
int __real_edges_setup(struct edges *e, const int16_t *const p[3], unsigned width, unsigned height, int32_t from,
                       int32_t to);
int __wrap_edges_setup(struct edges *e, const int16_t *const p[3], unsigned width, unsigned height, int32_t from,
                       int32_t to);

struct corners {
    int16_t place[3][3];
    const int16_t *p[3];
};

static void wraps_corners(struct corners *out, const int16_t *const p[3])
{
    const int down = wraps.subpixel < WRAPS_SUBPIXEL_OWN ? (int)(WRAPS_SUBPIXEL_OWN - wraps.subpixel) : 0;
    const int shift = wraps.subpixel > WRAPS_SUBPIXEL_OWN ? (8 << (wraps.subpixel - WRAPS_SUBPIXEL_OWN)) - 8 : 0;
    for (int k = 0; k < 3; k++) {
        for (int axis = 0; axis < 2; axis++)
            out->place[k][axis] = (int16_t)((((p[k][axis] + (1 << down >> 1)) >> down) * (1 << down)) - shift);
        out->place[k][2] = p[k][2];
        out->p[k] = out->place[k];
    }
}

int __wrap_plane_setup(struct plane *plane, const int16_t *const p[3], unsigned width, unsigned height)
{
    struct corners corners;
    wraps_corners(&corners, p);
    return __real_plane_setup(plane, corners.p, width, height);
}

int __wrap_edges_setup(struct edges *e, const int16_t *const p[3], unsigned width, unsigned height, int32_t from,
                       int32_t to)
{
    struct corners corners;
    wraps_corners(&corners, p);
    return __real_edges_setup(e, corners.p, width, height, from, to);
}

/* --- fraction bits ---------------------------------------------------------------------------------------------- */

typedef void quadratic_setup(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                             struct channel *channel);
typedef void linear_setup(const struct plane *plane, const int32_t value[3], struct channel *channel);
quadratic_setup __real_plane_quadratic, __wrap_plane_quadratic, __real_plane_quadratic_large,
    __wrap_plane_quadratic_large;
linear_setup __real_plane_linear, __wrap_plane_linear;

static void wraps_round(struct channel *channel)
{
    if (wraps.fraction >= WRAPS_FRACTION_OWN || channel->exact)
        return;
    const uint32_t half = 1u << (WRAPS_FRACTION_OWN - wraps.fraction) >> 1, keep = ~(2 * half - 1);
    uint32_t *coefficient[] = {&channel->p.f, &channel->p.d, &channel->p.e,
                               &channel->p.a, &channel->p.b, &channel->p.c};
    for (int i = 0; i < 6; i++)
        *coefficient[i] = (*coefficient[i] + half) & keep;
}

/* The quadratic of eq. 32 at pixel (i, j) from the origin. */
static double wraps_value(const struct plane *plane, const int32_t value[3], const int32_t bulge[3], double i, double j)
{
    const double x = 16 * i + plane->fx, y = 16 * j + plane->fy, det = plane->det;
    const double u = (x * plane->whole_y2 - y * plane->whole_x2) / det,
                 v = (y * plane->whole_x1 - x * plane->whole_y1) / det, w = 1 - u - v;
    return (value[0] * w + value[1] * u + value[2] * v) / 16384 -
           (bulge[0] * w * u + bulge[1] * u * v + bulge[2] * v * w) / 268435456;
}

static bool wraps_inside(const struct plane *plane, int i, int j)
{
    const double x = 16 * i + plane->fx, y = 16 * j + plane->fy;
    const double u = x * plane->whole_y2 - y * plane->whole_x2, v = y * plane->whole_x1 - x * plane->whole_y1;
    return u >= 0 && v >= 0 && u + v <= plane->det;
}

static int wraps_least(int a, int b)
{
    return (a < b ? a < 0 ? a : 0 : b < 0 ? b : 0) / 16 - 1;
}
static int wraps_most(int a, int b)
{
    return (a > b ? a > 0 ? a : 0 : b > 0 ? b : 0) / 16 + 1;
}

static void wraps_model(const struct plane *plane, const int32_t value[3], const int32_t bulge[3])
{
    double v[3][3]; /* at -1, 0, 1 */
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++)
            v[j][i] = wraps_value(plane, value, bulge, i - 1, j - 1);
    const double exact[6] = {v[1][1],
                             (v[1][2] - v[1][0]) / 2,
                             (v[2][1] - v[0][1]) / 2,
                             (v[1][2] + v[1][0]) / 2 - v[1][1],
                             (v[2][1] + v[0][1]) / 2 - v[1][1],
                             (v[2][2] - v[2][0] - v[0][2] + v[0][0]) / 4};
    double off[WRAPS_FRACTION_MOST + 1][6];
    for (int bits = WRAPS_FRACTION_LEAST; bits <= WRAPS_FRACTION_MOST; bits++)
        for (int k = 0; k < 6; k++)
            off[bits][k] = ldexp(nearbyint(ldexp(exact[k], bits + 8)), -bits - 8) - exact[k];
    for (int j = wraps_least(plane->whole_y1, plane->whole_y2); j <= wraps_most(plane->whole_y1, plane->whole_y2); j++)
        for (int i = wraps_least(plane->whole_x1, plane->whole_x2); i <= wraps_most(plane->whole_x1, plane->whole_x2);
             i++) {
            if (!wraps_inside(plane, i, j))
                continue;
            wraps.largest = fmax(wraps.largest, fabs(wraps_value(plane, value, bulge, i, j)));
            for (int bits = WRAPS_FRACTION_LEAST; bits <= WRAPS_FRACTION_MOST; bits++) {
                const double *o = off[bits];
                double error = o[0] + o[1] * i + o[2] * j + o[3] * i * i + o[4] * j * j + o[5] * i * j;
                wraps.error[bits] = fmax(wraps.error[bits], 255 * fabs(error));
            }
        }
}

void __wrap_plane_quadratic(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                            struct channel *channel)
{
    __real_plane_quadratic(plane, value, bulge, channel);
    if (wraps.model && !channel->exact)
        wraps_model(plane, value, bulge);
    wraps_round(channel);
}

void __wrap_plane_quadratic_large(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                                  struct channel *channel)
{
    __real_plane_quadratic_large(plane, value, bulge, channel);
    wraps_round(channel);
}

void __wrap_plane_linear(const struct plane *plane, const int32_t value[3], struct channel *channel)
{
    __real_plane_linear(plane, value, channel);
    /* depth has 16 bits of its own */
    if ((const char *)channel - (const char *)plane !=
        (ptrdiff_t)(offsetof(struct shade_setup, depth) - offsetof(struct shade_setup, plane)))
        wraps_round(channel);
}
