/* SPDX-License-Identifier: MIT */
/* The pixels of X-shading and of the six-sample quadratic. */
#include "raster/dots.h"
#include "raster/runs.h"
#include "raster/spans.h"

/* Grey under one light: both dot products stepped, and summed at once. A template; the bits are those of dots_shade().
 */
static inline __attribute__((always_inline)) void shade_grey(struct raster *r, int x, int y, int n, int highlight)
{
    const struct surface *s = &r->surface;
    const struct shade_setup *setup = &r->setup;
    const struct polynomial *pl = &setup->channel[0].p, *ph = &setup->channel[1].p;
    const uint32_t i = fx_wrap_u32(x - setup->plane.ox), j = fx_wrap_u32(y - setup->plane.oy);
    const uint32_t al = fx_wrap_shl(pl->a, 1), ah = fx_wrap_shl(ph->a, 1), base = s->base[0];
    uint32_t dl, dh = 0, vl = spans_start(pl, i, j, &dl, 1), vh = 0, *sum = r->sum[0];
    const uint16_t diffuse = s->light[0].diffuse[0], specular = s->light[0].specular[0];
    if (highlight)
        vh = spans_start(ph, i, j, &dh, 1);
    for (const uint32_t *end = sum + 3 * n; sum != end; sum += 3) {
        uint32_t value = base;
        if (fx_wrap_s32(vl) > 0)
            value += surface_diffuse(vl >> 15, diffuse);
        if (highlight) {
            uint32_t power = fx_power(s->power, fx_wrap_s32(vh));
            if (power)
                value += surface_diffuse(power, specular);
            fx_wrap_inc(&vh, dh);
            fx_wrap_inc(&dh, ah);
        }
        *sum = value;
        fx_wrap_inc(&vl, dl);
        fx_wrap_inc(&dl, al);
    }
}

RUNS_APART static void shade_run(struct raster *r, int x, int y, int n)
{
    const struct shade_setup *setup = &r->setup;
    if (surface_channels(&r->surface) != 1 || !shade_alone(setup) || setup->runs_only || surface_form(&r->surface) ||
        !setup->diffuse_lights)
        dots_shade(r, x, y, n, 0);
    else if (shade_specular(setup))
        shade_grey(r, x, y, n, 1);
    else
        shade_grey(r, x, y, n, 0);
}

/* What no polynomial holds, from a table too: N.L and N.H of a run, and its colours. */
RUNS_APART static void table_values(struct raster *r, int x, int y, int n)
{
    const struct shade_setup *setup = &r->setup;
    for (int which = 0; which < 2; which++) {
        if ((which ? shade_specular(setup) : setup->diffuse_lights) != 0)
            plane_values(&setup->plane, &setup->channel[which], x, y, n, r->value[which]);
        else
            for (int i = 0; i < n; i++)
                r->value[which][i] = 0;
    }
}

RUNS_APART static void table_write(struct raster *r, int x, int y, uint32_t mask)
{
    const int octave = r->surface.power->octave;
    const int32_t half = 1 << 23, foot = (1 << 30) - (1 << (30 - octave)), *value = r->value[0];
    uint16_t *pixel = (uint16_t *)(void *)(r->pixels + fx_u32(y - r->y0) * r->stride) + x;
    for (; mask; mask >>= 1, value++, pixel++) {
        if (!(mask & 1))
            continue;
        const int32_t h = value[RUN] < foot ? 0 : (value[RUN] - foot) >> (23 - octave);
        *pixel = r->surface_table->entry[fx_saturated(fx_u32(h), 7, 0) * TABLE_DIFFUSE +
                                         fx_saturated(fx_wrap_u32(value[0] + half), 6, 24)];
    }
}

RUNS_APART static uint32_t draw_table_runs(struct raster *r, struct edges *e)
{
    return runs_draw_by(r, e, table_values, table_write);
}

RUNS_APART static uint32_t draw_runs(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, shade_run);
}

/* What no polynomial holds, N.L counting in steps. */
RUNS_APART static void shade_steps(struct raster *r, int x, int y, int n)
{
    const struct surface *s = &r->surface;
    const struct shade_setup *setup = &r->setup;
    for (int i = 0; i < n; i++)
        r->sum[i][0] = s->base[0];
    if (setup->diffuse_lights) {
        plane_values(&setup->plane, &setup->channel[0], x, y, n, r->value[0]);
        for (int i = 0; i < n; i++)
            if (r->value[0][i] > 0)
                r->sum[i][0] += fx_u32(r->value[0][i]) >> 7;
    }
    if (shade_specular(setup)) {
        plane_values(&setup->plane, &setup->channel[1], x, y, n, r->value[0]);
        for (int i = 0; i < n; i++)
            r->sum[i][0] += surface_diffuse(fx_power(s->power, r->value[0][i]), s->light[0].specular[0]);
    }
}

RUNS_APART static uint32_t draw_steps(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, shade_steps);
}

uint32_t raster_draw_dots(struct raster *r, struct edges *e)
{
    const struct shade_setup *setup = &r->setup;
    if (!shade_alone(setup))
        return draw_runs(r, e);
    if (surface_fold(&r->surface))
        return setup->runs_only ? draw_steps(r, e) : spans_grey8_dots(r, e);
    if (!r->surface_table)
        return draw_runs(r, e);
    if (raster_is(r, GLINT_RGB565))
        return setup->runs_only ? draw_table_runs(r, e) : spans_rgb565_dots(r, e);
    if (raster_is(r, GLINT_RGB888) && !setup->runs_only)
        return spans_rgb888_dots(r, e);
    return draw_runs(r, e);
}

const struct glint_method glint_x = {.id = GLINT_X,
                                     .uses_tables = 1,
                                     .setup = shade_x,
                                     .draw = raster_draw_dots,
                                     .run = dots_run,
                                     .colours = COLOURS_OF_DOTS};
const struct glint_method glint_six = {.id = GLINT_SIX,
                                       .uses_tables = 1,
                                       .setup = shade_six,
                                       .draw = raster_draw_dots,
                                       .run = dots_run,
                                       .colours = COLOURS_OF_DOTS};
