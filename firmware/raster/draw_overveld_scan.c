/* SPDX-License-Identifier: MIT */
/*
 * Van Overveld and Wyvill's pixels in two levels: where a row of pixel centres enters and leaves the triangle, the
 * normal is the edge's quadratic; between, one quadratic more, set up for each row (sections 2 and 2.4 of Lee and Jen
 * 2001). A row is the triangle's alone: neither the band nor a run has a part in it.
 */
#include "raster/normals.h"
#include "raster/runs.h"

enum { LEFT, RIGHT };

static inline int32_t times_q30(int32_t x, q30_t y)
{
    return fx_mulhi_s32(x, y) * 4;
}

/* Where edge e is t from its first corner. */
static void cross_edge(const struct raster *r, struct shade_row_end *end, int e, q30_t t)
{
    const struct shade_rows *rows = &r->setup.rows;
    const int a = e, b = e == 2 ? 0 : e + 1;
    const int32_t xa = r->input.place[a][VERTEX_X], xb = r->input.place[b][VERTEX_X];
    const q30_t bow = times_q30(t, Q30(1, 1) - t);         /* t (1 - t), at most 1/4 */
    end->x = xa * 256 + fx_mulhi_s32((xb - xa) * 1024, t); /* |xb - xa| <= 2^15 */
    for (int i = 0; i < 3; i++) {
        const int32_t *n = rows->normal.value[i], *p = rows->place[i];
        /* Q28: |n| <= 7/6; |p| <= 2^15 */
        end->normal[i] =
            n[a] * (1 << 14) + times_q30((n[b] - n[a]) * (1 << 14), t) - times_q30(rows->normal.bulge[i][e], bow);
        end->place[i] = p[a] * (1 << 12) + fx_mulhi_s32((p[b] - p[a]) * (1 << 14), t);
    }
}

/* Both ends of a row whose centre is at `y`, 28.4 from the picture's. Corners stand clockwise: edges go down on the
 * right, up on the left. At a corner between two edges either will do. */
static void find_ends(struct raster *r, int32_t y)
{
    for (int e = 0; e < 3; e++) {
        const int32_t from = r->input.place[e][VERTEX_Y], to = r->input.place[e == 2 ? 0 : e + 1][VERTEX_Y];
        const int side = from < to ? RIGHT : LEFT;
        const int32_t rise = side == RIGHT ? to - from : from - to, way = side == RIGHT ? y - from : from - y;
        if (rise == 0 || way < 0 || way > rise)
            continue;
        const unsigned up = fx_clz(fx_u32(rise));
        /* way / rise in Q31, halved */
        const uint32_t t = fx_mulhi_u32(fx_u32(way) << up, fx_recip_norm(fx_u32(rise) << up)) >> 1;
        cross_edge(r, &r->setup.rows.end[side], e, fx_s32(t));
    }
}

/* b = 3 (n0 + n1, D) / |D|^2 D between the row's ends: |n0 + n1| <= 7/3, so that b is at most 7, in
 * Q28. */
static void bend_row(struct shade_rows *rows)
{
    const struct shade_row_end *left = &rows->end[LEFT], *right = &rows->end[RIGHT];
    int32_t d[3], sum = 0, any = 0;
    for (int i = 0; i < 3; i++)
        any |= d[i] = right->place[i] - left->place[i]; /* Q12 of a position unit, at most 2^28 */
    vector_normalise(d, d);
    for (int i = 0; i < 3; i++)
        sum += fx_mulhi_s32(left->normal[i] + right->normal[i], d[i]); /* Q26 */
    for (int i = 0; i < 3; i++)
        rows->bulge[i] = any ? times_q30(12 * sum, d[i]) : 0;
}

static void start_row(struct raster *r, int y)
{
    struct shade_rows *rows = &r->setup.rows;
    rows->y = y;
    find_ends(r, 16 * y + 8 - 8 * r->height);
    bend_row(rows);
    const int32_t width = rows->end[RIGHT].x - rows->end[LEFT].x; /* 2^-8 sub-pixels, at most 2^23 */
    rows->width = width > 0 ? fx_u32(width) : 1;
    rows->up = fx_clz(rows->width);
    rows->inverse = fx_recip_norm(rows->width << rows->up);
}

static void shade_run(struct raster *r, int x, int y, int n)
{
    struct shade_rows *rows = &r->setup.rows;
    if (rows->y != y)
        start_row(r, y);
    const struct shade_row_end *left = &rows->end[LEFT], *right = &rows->end[RIGHT];
    for (int i = 0; i < n; i++) {
        const int32_t at = (16 * (x + i) + 8 - 8 * r->width) * 256 - left->x;
        const uint32_t part = fx_u32(at) > rows->width ? rows->width : fx_u32(at);
        const q30_t s = fx_s32(fx_mulhi_u32(part << rows->up, rows->inverse) >> 1);
        const q30_t bow = times_q30(s, Q30(1, 1) - s);
        for (int c = 0; c < 3; c++) /* Q28: at most (7/6)^2 */
            r->value[c][i] =
                left->normal[c] + times_q30(right->normal[c] - left->normal[c], s) - times_q30(rows->bulge[c], bow);
    }
    normals_shade(r, x, y, n);
}

static uint32_t draw(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, shade_run);
}

const struct glint_method glint_overveld_scan = {
    .id = GLINT_OVERVELD, .setup = shade_overveld_scan, .draw = draw, .run = shade_run, .colours = COLOURS_OF_NORMALS};
