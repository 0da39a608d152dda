/* SPDX-License-Identifier: MIT */
/* Perspective-correct pixels of X-shading and of the six-sample quadratic: one reciprocal each. */
#include "raster/dots.h"
#include "raster/runs.h"

static void divide_twice(struct raster *r, int n)
{
    for (int i = 0; i < n; i++)
        r->value[0][i] = perspective_divide_twice(r->value[0][i], r->divisor[i]);
}

static void shade_run(struct raster *r, int x, int y, int n)
{
    raster_divisors(r, x, y, n);
    dots_shade(r, x, y, n, divide_twice);
}

static uint32_t draw(struct raster *r, struct edges *e)
{
    return r->setup.perspective ? runs_draw(r, e, shade_run) : raster_draw_dots(r, e);
}

static void run(struct raster *r, int x, int y, int n)
{
    (r->setup.perspective ? shade_run : dots_run)(r, x, y, n);
}

const struct glint_method glint_x_perspective = {.id = GLINT_X,
                                                 .uses_tables = 1,
                                                 .setup = shade_x_perspective,
                                                 .draw = draw,
                                                 .run = run,
                                                 .colours = COLOURS_OF_DOTS};
const struct glint_method glint_six_perspective = {.id = GLINT_SIX,
                                                   .uses_tables = 1,
                                                   .setup = shade_six_perspective,
                                                   .draw = draw,
                                                   .run = run,
                                                   .colours = COLOURS_OF_DOTS};
