/* SPDX-License-Identifier: MIT */
#include "raster/parts.h"
#include "raster/effects.h"

/* Channels are signed Q22 steps; the top is clamped when they are written. */
static void shade_part(struct raster *r, int x, int y, int n)
{
    for (unsigned c = 0; c < raster_channels(r); c++) {
        plane_values(&r->setup.plane, &r->setup.channel[c], x, y, n, r->value[0]);
        for (int i = 0; i < n; i++)
            r->sum[i][c] = r->value[0][i] < 0 ? 0 : fx_u32(r->value[0][i]) >> 7;
    }
}

static void places(const struct raster *r, const struct part_corner *const corner[3], struct part_place p[3])
{
    for (int k = 0; k < 3; k++)
        p[k] = part_place(&r->input, corner[k]);
}

int parts_shows(const struct raster *r, const struct part_corner *const corner[3])
{
    struct part_place p[3];
    places(r, corner, p);
    int32_t top = p[0].y < p[1].y ? p[0].y : p[1].y, bottom = p[0].y > p[1].y ? p[0].y : p[1].y;
    top = p[2].y < top ? p[2].y : top;
    bottom = p[2].y > bottom ? p[2].y : bottom;
    return fine_row(bottom, r->height) > r->y0 && fine_row(top, r->height) < r->y1;
}

uint32_t parts_linear(struct raster *r, struct edges *e, const struct part_corner *const corner[3])
{
    struct part_place p[3];
    places(r, corner, p);
    if (!fine_setup(e, p, r->width, r->height, r->y0, r->y1))
        return 0;
    const int fast = raster_is(r, GLINT_RGB565) && !raster_dithers(r) && !raster_effects(r) &&
                     part_linear(&r->setup, &r->input, corner, 1);
    uint32_t drawn = 0;
    if (!fast)
        part_linear(&r->setup, &r->input, corner, 0);
    do
        drawn += fast ? draw_gouraud(r, e) : effects_runs(r, e, shade_part);
    while (fine_setup(e, p, r->width, r->height, e->last, r->y1));
    return drawn;
}

uint32_t parts_quadratic(struct raster *r, struct edges *e, const struct part_corner *const corner[3],
                         const struct part_corner middle[3])
{
    struct part_place p[3];
    places(r, corner, p);
    if (!fine_setup(e, p, r->width, r->height, r->y0, r->y1))
        return 0;
    uint32_t drawn = 0;
    if (!part_quadratic(&r->setup, &r->input, corner, middle))
        part_linear(&r->setup, &r->input, corner, 0);
    do
        drawn += effects_runs(r, e, shade_part);
    while (fine_setup(e, p, r->width, r->height, e->last, r->y1));
    return drawn;
}
