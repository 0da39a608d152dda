/* SPDX-License-Identifier: MIT */
#include "raster/edges.h"

/*
 * The edge from (x, y), down by (dx, dy), dy > 0, at a row that it crosses: its first column is
 * ceil((x + dx (centre - y) / dy) / 16), x being moved so that a column's centre is at 16 * column.
 *
 * |x| <= 2^15, 0 <= y' = centre - y <= dy <= 2^15, |dx| <= 2^15. The crossing lies between the ends, so x dy + dx y' is
 * at most 2^15 dy <= 2^30 in size, though either product alone may be that large.
 */
static inline void edge_setup(struct edge *e, int32_t x, int32_t y, int32_t dx, int32_t dy, int32_t centre)
{
    int32_t den = dy << 4, down = centre - y, slope, more;
    fx_divmod_floor(dx, dy, &slope, &more);
    e->den = den;
    e->column_step = slope;
    e->rest_step = more << 4;
    if (down < 16) {
        /* dx = slope dy + more, so x + slope down whole sub-pixels and more down / dy < 16: the second division is a
         * comparison or two. rest = (that & 15) dy + more down - 1 + den, in [den - 1, 3 den). */
        int32_t whole = x + slope * down;
        int32_t rest = (whole & 15) * dy + more * down - 1;
        e->column = (whole >> 4) + 1;
        if (rest < 0) {
            rest += den;
            e->column--;
        } else if (rest >= den) {
            rest -= den;
            e->column++;
        }
        e->rest = rest;
        return;
    }
    fx_divmod_floor(x * dy + down * dx + den - 1, den, &e->column, &e->rest);
}

int edges_setup(struct edges *e, const int16_t *const p[3], unsigned width, unsigned height, int32_t from, int32_t to)
{
    /* The top corner, and those that follow it: b clockwise, on the right, c on the left. */
    const int16_t *a = p[0], *b = p[1], *c = p[2], *spare = a;
    if (b[1] < a[1] && b[1] <= c[1]) {
        a = b;
        b = c;
        c = spare;
    } else if (c[1] < a[1]) {
        a = c;
        c = b;
        b = spare;
    }
    const int32_t hw = 8 * fx_s32(width) - 8, hh = 8 * fx_s32(height) - 8; /* centres at 16 i */
    const int32_t ax = a[0] + hw, ay = a[1] + hh, bx = b[0] + hw, by = b[1] + hh, cx = c[0] + hw, cy = c[1] + hh;
    const int right_turns = by < cy;
    const int32_t first = (ay + 15) >> 4, middle = ((right_turns ? by : cy) + 15) >> 4;
    int32_t last = ((right_turns ? cy : by) + 15) >> 4;
    const int32_t row = first > from ? first : from;
    last = last < to ? last : to;
    if (row >= last)
        return 0;
    e->row = row;
    e->middle = middle;
    e->last = last;
    e->lower_is_left = !right_turns;
    e->turned = 0;
    const int32_t w = 16 * fx_s32(width) - 16; /* the last column's centre */
    e->cut = ax < 0 || bx < 0 || cx < 0 || ax > w || bx > w || cx > w;
    e->lower_x = right_turns ? bx : cx;
    e->lower_y = right_turns ? by : cy;
    e->lower_dx = right_turns ? cx - bx : bx - cx;
    e->lower_dy = right_turns ? cy - by : by - cy;
    if (right_turns || row < middle)
        edge_setup(&e->left, ax, ay, cx - ax, cy - ay, row << 4);
    if (!right_turns || row < middle)
        edge_setup(&e->right, ax, ay, bx - ax, by - ay, row << 4);
    return 1;
}

/* One row further. What is left over is kept less the divisor, in [-den, 0): its sign tells. */
FX_WRAPS static inline void step(uint32_t *column, uint32_t *rest, const struct edge *e)
{
    fx_step(column, fx_wrap_u32(e->column_step));
    fx_step(rest, fx_u32(e->rest_step));
    if (fx_wrap_s32(*rest) >= 0) {
        *rest -= fx_u32(e->den);
        ++*column;
    }
}

/* Spans of the rows to `stop`, in which neither side turns. A side is stepped once past its end, which nothing reads.
 */
static inline void rows(struct edges *e, struct span *out, int32_t stop)
{
    const struct edge left = e->left, right = e->right;
    uint32_t x0 = fx_wrap_u32(left.column), rest0 = fx_wrap_u32(left.rest - left.den);
    uint32_t x1 = fx_wrap_u32(right.column), rest1 = fx_wrap_u32(right.rest - right.den);
    struct span *end = out + (stop - e->row);
#if defined(__ARM_ARCH_7M__) || defined(__ARM_ARCH_7EM__)
    /* As below; what is left over carries into the column when it passes 0. 11 or 12 instructions a row, compiled 17.
     */
    __asm__ volatile("1: strh %[x0], [%[out]], #2\n\t"
                     "strh %[x1], [%[out]], #2\n\t"
                     "adds %[rest0], %[rest0], %[more0]\n\t"
                     "adc %[x0], %[x0], %[step0]\n\t"
                     "it cs\n\t"
                     "subcs %[rest0], %[rest0], %[den0]\n\t"
                     "adds %[rest1], %[rest1], %[more1]\n\t"
                     "adc %[x1], %[x1], %[step1]\n\t"
                     "it cs\n\t"
                     "subcs %[rest1], %[rest1], %[den1]\n\t"
                     "cmp %[out], %[end]\n\t"
                     "bne 1b"
                     : [out] "+r"(out), [x0] "+r"(x0), [rest0] "+r"(rest0), [x1] "+r"(x1), [rest1] "+r"(rest1)
                     : [end] "r"(end), [step0] "r"(left.column_step), [more0] "r"(left.rest_step), [den0] "r"(left.den),
                       [step1] "r"(right.column_step), [more1] "r"(right.rest_step), [den1] "r"(right.den)
                     : "cc", "memory");
#else
    do {
        out->x0 = fx_s16(fx_wrap_s32(x0));
        out->x1 = fx_s16(fx_wrap_s32(x1));
        step(&x0, &rest0, &left);
        step(&x1, &rest1, &right);
    } while (++out < end);
#endif
    e->left.column = fx_wrap_s32(x0);
    e->left.rest = fx_wrap_s32(rest0) + left.den;
    e->right.column = fx_wrap_s32(x1);
    e->right.rest = fx_wrap_s32(rest1) + right.den;
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
            out[i].x1 = out[i].x1 > width ? fx_s16(width) : out[i].x1;
        }
    return count;
}
