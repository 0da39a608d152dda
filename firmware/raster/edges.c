/* SPDX-License-Identifier: MIT */
#include "raster/edges.h"

/* The edge from (x, y), down by (dx, dy), dy > 0, at a row that it crosses. x is moved so that a column's centre is at
 * 16 * column. |x| <= 2^15, 0 <= y' <= dy <= 2^15, |dx| <= 2^15, and the crossing x + dx y'/dy lies between the ends:
 * x dy + dx y' is at most 2^15 dy <= 2^30 in size, though one product alone may be that large too. */
static inline void edge_setup(struct edge *e, int32_t x, int32_t y, int32_t dx, int32_t dy, int32_t row_centre)
{
    int32_t den = dy << 4;
    int32_t num = x * dy + (row_centre - y) * dx;
    e->den = den;
    fx_divmod_floor(num + den - 1, den, &e->column, &e->rest);
    fx_divmod_floor(dx, dy, &e->column_step, &e->rest_step);
    e->rest_step <<= 4;
}

int edges_setup(struct edges *e, const int16_t *const p[3], unsigned width, unsigned height, int32_t from, int32_t to)
{
    int32_t hw = 8 * (int32_t)width - 8, hh = 8 * (int32_t)height - 8; /* centres at 16 i */
    int32_t x[3], y[3];
    for (int i = 0; i < 3; i++) {
        x[i] = p[i][0] + hw;
        y[i] = p[i][1] + hh;
    }
    /* Corners in the order of y, keeping which way round they go. */
    int a = y[0] <= y[1] ? (y[0] <= y[2] ? 0 : 2) : (y[1] <= y[2] ? 1 : 2);
    int b = a == 2 ? 0 : a + 1, c = a == 0 ? 2 : a - 1;
    int mid_is_right = y[b] < y[c]; /* clockwise: b follows the top corner on the right side */
    int mid = mid_is_right ? b : c, bottom = mid_is_right ? c : b;

    int32_t first = (y[a] + 15) >> 4;
    e->middle = (y[mid] + 15) >> 4;
    e->last = (y[bottom] + 15) >> 4;
    e->row = first > from ? first : from;
    if (e->last > to)
        e->last = to;
    if (e->row >= e->last)
        return 0;

    struct edge *longer = mid_is_right ? &e->left : &e->right, *shorter = mid_is_right ? &e->right : &e->left;
    int32_t centre = e->row << 4;
    e->lower_is_left = !mid_is_right;
    e->lower_x = x[mid];
    e->lower_y = y[mid];
    e->lower_dx = x[bottom] - x[mid];
    e->lower_dy = y[bottom] - y[mid];
    edge_setup(longer, x[a], y[a], x[bottom] - x[a], y[bottom] - y[a], centre);
    e->turned = 0;
    int32_t w = 16 * (int32_t)width - 8; /* the last column's centre, and a little */
    e->cut = x[0] < 0 || x[1] < 0 || x[2] < 0 || x[0] > w || x[1] > w || x[2] > w;
    if (e->row < e->middle)
        edge_setup(shorter, x[a], y[a], x[mid] - x[a], y[mid] - y[a], centre);
    return 1;
}

/* One row further. */
static inline void step(int32_t *column, int32_t *rest, const struct edge *e)
{
    *column += e->column_step;
    *rest += e->rest_step;
    if (*rest >= e->den) {
        *rest -= e->den;
        ++*column;
    }
}

/* Spans of the rows to `stop`, in which neither side turns. A side is stepped once past its end, which nothing reads. */
static inline void rows(struct edges *e, struct span *out, int32_t stop)
{
    const struct edge left = e->left, right = e->right;
    int32_t x0 = left.column, rest0 = left.rest, x1 = right.column, rest1 = right.rest;
    struct span *end = out + (stop - e->row);
    do {
        out->x0 = (int16_t)x0;
        out->x1 = (int16_t)x1;
        step(&x0, &rest0, &left);
        step(&x1, &rest1, &right);
    } while (++out < end);
    e->left.column = x0;
    e->left.rest = rest0;
    e->right.column = x1;
    e->right.rest = rest1;
    e->row = stop;
}

int edges_spans(struct edges *e, int width, struct span *out, int most)
{
    int32_t first = e->row, count = e->last - first < most ? e->last - first : most, end = first + count;
    if (first < e->middle)
        rows(e, out, e->middle < end ? e->middle : end);
    if (e->row < end) {
        if (!e->turned) {
            edge_setup(e->lower_is_left ? &e->left : &e->right, e->lower_x, e->lower_y, e->lower_dx, e->lower_dy,
                       e->row << 4);
            e->turned = 1;
        }
        rows(e, out + (e->row - first), end);
    }
    if (e->cut)
        for (int32_t i = 0; i < count; i++) {
            out[i].x0 = out[i].x0 < 0 ? 0 : out[i].x0;
            out[i].x1 = out[i].x1 > width ? (int16_t)width : out[i].x1;
        }
    return count;
}
