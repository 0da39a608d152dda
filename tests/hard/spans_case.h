/* SPDX-License-Identifier: MIT */
/* A triangle's pixels by the renderer's spans, counted, and by definition. Include after cmocka.h. */
#ifndef SPANS_CASE_H
#define SPANS_CASE_H

#include "exact.h"
#include "raster/edges.h"

#include <string.h>

#define SPANS_MOST 32 /* rows asked for at a time */

/* The corners as the renderer has them: from `first` on, clockwise or (step -1) not. */
static inline const int16_t *const *spans_places(const struct exact_triangle *t, int first, int step)
{
    static int16_t xy[3][2];
    static const int16_t *const p[3] = {xy[0], xy[1], xy[2]};
    for (int k = 0; k < 3; k++) {
        const struct cover_point *from = &t->p[(first + 3 + step * k) % 3];
        xy[k][0] = (int16_t)from->x;
        xy[k][1] = (int16_t)from->y;
    }
    return p;
}

/* Adds 1 to each pixel of the edges' spans; returns how many there were. */
static inline int spans_add(struct edges *e, unsigned width, uint8_t *count)
{
    struct span span[SPANS_MOST];
    int pixels = 0;
    for (int y = e->row; e->row < e->last;) {
        const int rows = edges_spans(e, (int)width, span, SPANS_MOST);
        assert_in_range(rows, 1, SPANS_MOST);
        for (int i = 0; i < rows; i++, y++)
            for (int x = span[i].x0; x < span[i].x1; x++, pixels++)
                count[(size_t)y * width + (size_t)x]++;
    }
    return pixels;
}

static inline int spans_count(const struct exact_triangle *t, int first, uint8_t *count)
{
    struct edges e;
    if (!edges_setup(&e, spans_places(t, first, 1), t->width, t->height, 0, (int)t->height))
        return 0;
    return spans_add(&e, t->width, count);
}

static inline void spans_complain(const struct exact_triangle *t, int x, int y, const char *what)
{
    fail_msg("(%d, %d) (%d, %d) (%d, %d)/16 px in %u x %u: pixel (%d, %d) %s", t->p[0].x, t->p[0].y, t->p[1].x,
             t->p[1].y, t->p[2].x, t->p[2].y, t->width, t->height, x, y, what);
}

/* Fails unless a clockwise triangle covers what it should, whichever corner comes first; returns its pixels. */
static inline int spans_check(const struct exact_triangle *t)
{
    static uint8_t count[64 * 64];
    int pixels = 0;
    memset(count, 0, (size_t)t->width * t->height);
    for (int first = 0; first < 3; first++)
        spans_count(t, first, count);
    for (int y = 0; y < (int)t->height; y++)
        for (int x = 0; x < (int)t->width; x++) {
            const int covered = exact_covers(t, x, y);
            if (count[(unsigned)y * t->width + (unsigned)x] != 3 * covered)
                spans_complain(t, x, y, covered ? "is left out" : "is drawn");
            pixels += covered;
        }
    return pixels;
}

/* Turns it clockwise; 0 if it has no area. */
static inline int spans_clockwise(struct exact_triangle *t)
{
    const struct cover_point other = t->p[1];
    if (exact_area(t) < 0) {
        t->p[1] = t->p[2];
        t->p[2] = other;
    }
    return exact_area(t) != 0;
}

#endif
