/* SPDX-License-Identifier: MIT */
/* Duff's pixels: one reciprocal square root each, for all lights. */
#include "raster/dots.h"
#include "raster/runs.h"
#include "raster/spans.h"

static void divide_by_length(struct raster *r, int n)
{
    for (int i = 0; i < n; i++)
        r->value[0][i] = perspective_divide(r->value[0][i], r->divisor[i]);
}

/* The quotient of what passes `reach`, up to +-2 in Q30. */
FX_COLD static int32_t overshoot(int32_t p, struct perspective_divisor by)
{
    int64_t quotient = (fx_s64(p) * by.half >> 30) * (INT64_C(1) << by.up); /* |p| < 2^31, half <= 2^30, up <= 9 */
    return quotient > INT32_MAX ? INT32_MAX : quotient < -INT32_MAX ? -INT32_MAX : fx_s32(quotient);
}

/* A dot product over the normal's length. Of linear numerators it is at most 1 and roundings, but a quadratic through
 * the samples of a near light can pass the length by far. */
static int32_t over_length(int32_t p, struct perspective_divisor by)
{
    if (!fx_within(p, fx_u32(INT32_MAX) >> by.up))
        return overshoot(p, by);
    return perspective_divide(p, by);
}

static void divide_near(struct raster *r, int n)
{
    for (int i = 0; i < n; i++)
        r->value[0][i] = over_length(r->value[0][i], r->divisor[i]);
}

static void shade_run(struct raster *r, int x, int y, int n)
{
    raster_lengths(r, x, y, n);
    dots_shade(r, x, y, n, object_local(r->input.object) ? divide_near : divide_by_length);
}

uint32_t draw_duff(struct raster *r, struct edges *e)
{
    if (USES(USES_GREY8) && r->setup.length)
        return spans_grey8_lengths(r, e);
    return runs_draw(r, e, shade_run);
}

const struct glint_method glint_duff = {.id = GLINT_DUFF,
                                        .uses_tables = 1,
                                        .setup = shade_duff,
                                        .draw = draw_duff,
                                        .run = shade_run,
                                        .colours = COLOURS_OF_DOTS};
