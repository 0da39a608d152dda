/* SPDX-License-Identifier: MIT */
/* The triangle that exact_triangles.c has in hand: what was counted of such, which pixels it covers, and its spans. */
#ifndef EXACT_COVERED_H
#define EXACT_COVERED_H

#include "exact_bounds.h"
#include "raster/edges.h"

#include <stdio.h>
#include <stdlib.h>

#define SIDE 24 /* of the largest picture of which each pixel is looked at */

static struct counts {
    long triangles, pixels, slivers, slim, refused, rectangles, depth_off[4];
    double closest[4]; /* of the bounds: linear, quadratic, in 64 bits, corner values */
    double worst[2];   /* values' errors in display units: linear, quadratic */
} counts;

static struct exact_triangle triangle;

static void fail(const char *what, int x, int y)
{
    const struct cover_point *p = triangle.p;
    printf("FAIL %s: (%d, %d) (%d, %d) (%d, %d)/16 px in %u x %u, pixel (%d, %d)\n", what, p[0].x, p[0].y, p[1].x,
           p[1].y, p[2].x, p[2].y, triangle.width, triangle.height, x, y);
    exit(1);
}

static void near(int kind, double off, double bound, const char *what, int x, int y)
{
    if (!(fabs(off) <= bound))
        fail(what, x, y);
    const double part = bound > 0 ? fabs(off) / bound : 0;
    if (part > counts.closest[kind])
        counts.closest[kind] = part;
}

/* Corners as the renderer has them, from `first` on. */
static const int16_t *const *places(int first, int step)
{
    static int16_t xy[3][2];
    static const int16_t *const p[3] = {xy[0], xy[1], xy[2]};
    for (int k = 0; k < 3; k++) {
        const struct cover_point *from = &triangle.p[(first + 3 + step * k) % 3];
        xy[k][0] = (int16_t)from->x;
        xy[k][1] = (int16_t)from->y;
    }
    return p;
}

/* Which pixels of each row it covers, one by one. */
static struct span wanted[SIDE];
static int area_of_picture;

static void find_wanted(void)
{
    area_of_picture = 0;
    for (int y = 0; y < (int)triangle.height; y++) {
        struct span row = {0, 0};
        int runs = 0, before = 0;
        for (int x = 0; x < (int)triangle.width; x++) {
            const int now = exact_covers(&triangle, x, y);
            if (now && !before) {
                row.x0 = (int16_t)x;
                runs++;
            }
            if (now)
                row.x1 = (int16_t)(x + 1);
            area_of_picture += now;
            before = now;
        }
        if (runs > 1)
            fail("the definition is not convex", 0, y);
        wanted[y] = row;
    }
}

/* The spans of rows [from, to), `most` at a time, are those of the definition, whose first row and column are (left,
 * top) of the picture's. */
static void check_spans(const int16_t *const *p, int width, int height, int from, int to, int most, int left, int top)
{
    struct edges e;
    struct span got[SIDE];
    int y = from;
    if (edges_setup(&e, p, (unsigned)width, (unsigned)height, from, to)) {
        for (; y < e.row; y++)
            if (wanted[y + top].x1 > left && wanted[y + top].x0 < left + width &&
                wanted[y + top].x1 > wanted[y + top].x0)
                fail("a row is left out", left, y + top);
        while (e.row < e.last) {
            const int count = edges_spans(&e, width, got, most);
            if (count < 1 || count > most || e.row != y + count)
                fail("a count of rows", count, y);
            for (int i = 0; i < count; i++, y++) {
                int x0 = wanted[y + top].x0 - left, x1 = wanted[y + top].x1 - left;
                x0 = x0 < 0 ? 0 : x0;
                x1 = x1 > width ? width : x1;
                const int none = x1 <= x0, nothing = got[i].x1 <= got[i].x0;
                if (none != nothing || (!none && (got[i].x0 != x0 || got[i].x1 != x1)))
                    fail("a span", got[i].x0 + left, y + top);
            }
        }
    }
    for (; y < to; y++)
        if (wanted[y + top].x1 > wanted[y + top].x0 && wanted[y + top].x1 > left && wanted[y + top].x0 < left + width)
            fail("a row is left out below", left, y + top);
}

#endif
