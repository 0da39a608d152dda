/* SPDX-License-Identifier: MIT */
#include "raster/fine.h"

#define FINE_BITS 19
#define FINE_ONE  (1 << FINE_BITS)

/*
 * floor(n / d) for |n / d| <= 2^12 and 0 < d <= 2^30, and what is left. A division of the leading 18 bits is off by at
 * most one: its divisor is too small by less than 2^-17 of itself, which makes 2^-5, and its dividend by less than one.
 */
static int32_t divide(int64_t n, int32_t d, int32_t *rest)
{
    int down = 14 - fx_s32(fx_clz(fx_u32(d)));
    int32_t q, unused;
    down = down < 0 ? 0 : down;
    fx_divmod_floor(fx_s32(n >> down), d >> down, &q, &unused); /* |n| >> down <= 2^12 * (2^18 + 1) */
    int64_t left = n - fx_s64(q) * d;
    for (; left < 0; left += d)
        q--;
    for (; left >= d; left -= d)
        q++;
    *rest = fx_s32(left);
    return q;
}

/*
 * The edge from (x, y), down by (dx, dy), at the row whose centre is `centre`, which it crosses: as in edges.c, centres
 * of columns standing at whole pixels. The first column whose centre is not left of the crossing is
 * ceil((x dy + dx (centre - y)) / (dy FINE_ONE)). Steps from row to row are multiples of 1 / dy, so of the remainder
 * only the part in those counts. All coordinates are at most 2^30 in size, the sum too after division by dy.
 */
static void edge_setup(struct edge *e, int32_t x, int32_t y, int32_t dx, int32_t dy, int32_t centre)
{
    int64_t crossing = (fx_s64(x) * dy + fx_s64(dx) * (centre - y) - 1) >> FINE_BITS;
    e->column = divide(crossing, dy, &e->rest) + 1;
    fx_divmod_floor(dx, dy, &e->column_step, &e->rest_step);
    e->den = dy; /* rest + rest_step < 2^31 */
}

/* The first row whose centre, at whole pixels, is not above y. */
static int32_t centre_after(int32_t y)
{
    return (y + FINE_ONE - 1) >> FINE_BITS;
}

static void side(struct edge *e, const struct part_place *from, const struct part_place *to, int32_t row)
{
    edge_setup(e, from->x, from->y, to->x - from->x, to->y - from->y, row * FINE_ONE);
}

int fine_setup(struct edges *e, const struct part_place p[3], unsigned width, unsigned height, int32_t from, int32_t to)
{
    /* Centres at whole pixels. */
    const int32_t hw = (8 * fx_s32(width) - 8) * (FINE_ONE / 16), hh = (8 * fx_s32(height) - 8) * (FINE_ONE / 16);
    int top = p[1].y < p[0].y ? 1 : 0;
    top = p[2].y < p[top].y ? 2 : top;
    struct part_place corner[3]; /* the top one, and clockwise on; at most 2^29 + 2^29 */
    for (int i = 0; i < 3; i++) {
        const struct part_place *at = &p[top + i < 3 ? top + i : top + i - 3];
        corner[i] = (struct part_place){at->x + hw, at->y + hh};
    }
    const struct part_place *const a = &corner[0], *const b = &corner[1], *const c = &corner[2];
    const int right_turns = b->y < c->y;
    const int32_t middle = centre_after(right_turns ? b->y : c->y), bottom = centre_after(right_turns ? c->y : b->y);
    const int32_t first = centre_after(a->y), row = first > from ? first : from;
    int32_t last = bottom < to ? bottom : to;
    if (row >= last)
        return 0;
    const int upper = row < middle;
    last = upper && middle < last ? middle : last;
    side(&e->left, upper || right_turns ? a : c, upper || right_turns ? c : b, row);
    side(&e->right, upper || !right_turns ? a : b, upper || !right_turns ? b : c, row);
    const int32_t w = (fx_s32(width) - 1) * FINE_ONE;
    e->cut = a->x < 0 || b->x < 0 || c->x < 0 || a->x > w || b->x > w || c->x > w;
    e->row = row;
    e->middle = e->last = last;
    e->turned = 1;
    return 1;
}
