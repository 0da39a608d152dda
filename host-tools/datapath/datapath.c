/* SPDX-License-Identifier: MIT */
#include "datapath/datapath.h"

#include <assert.h>

/* What an edge's adder and its comparator with the denominator give: the next column and remainder, and the carry. */
static int edge_next(struct edge *e)
{
    e->column += e->column_step;
    e->rest += e->rest_step;
    int carry = e->rest >= e->den;
    e->rest -= carry ? e->den : 0;
    e->column += carry;
    return carry;
}

/* The S inputs of the edge registers. */
FX_WRAPS static struct datapath_part edge_clock(const struct datapath_part *now)
{
    struct datapath_part next = *now;
    next.y++;
    next.rows--;
    edge_next(&next.end);
    int carry = edge_next(&next.start);
    next.i_start += now->di_start + (carry ? now->di_line + now->di_line_step[0] : 0);
    next.di_start += now->di_start_step[carry];
    next.di_line += now->di_line_step[carry];
    return next;
}

FX_WRAPS struct datapath_pixel datapath_clock(struct datapath *d, const struct datapath_part *load)
{
    const struct datapath now = *d; /* every input is an output of before the clock */
    const int more = now.edge.rows != 0, line_end = now.x + 1 >= now.x_end;
    assert(!load || !more);

    if (line_end) { /* L */
        d->x = now.edge.start.column;
        d->x_end = more ? now.edge.end.column : now.edge.start.column;
        d->y = now.edge.y;
        d->i = now.edge.i_start;
        d->di = now.edge.di_line;
        d->ddi = now.edge.ddi;
    } else { /* S */
        d->x = now.x + 1;
        d->i = now.i + now.di;
        d->di = now.di + now.ddi;
    }
    if (load)
        d->edge = *load;
    else if (line_end && more)
        d->edge = edge_clock(&now.edge);
    return (struct datapath_pixel){now.x < now.x_end, now.x, now.y, now.i};
}

/* 28.4, moved so that the centre of column or row i is at 16 i. */
struct corner {
    int64_t x, y;
};

static struct edge edge_at(struct corner from, struct corner to, int32_t row)
{
    const int64_t dx = to.x - from.x, dy = to.y - from.y, den = 16 * dy;
    const int64_t up = from.x * dy + dx * (16 * row - from.y) + den - 1; /* the ceiling's numerator; < 2^31 den */
    struct edge e = {.den = (int32_t)den};
    int64_t rest = up % den, more = dx % dy;
    rest += rest < 0 ? den : 0;
    more += more < 0 ? dy : 0;
    e.column = (int32_t)((up - rest) / den);
    e.rest = (int32_t)rest;
    e.column_step = (int32_t)((dx - more) / dy);
    e.rest_step = (int32_t)(16 * more);
    return e;
}

/* The value and its steps where the start edge crosses the first row, and the constants. */
FX_WRAPS static void set_values(struct datapath_part *part, const struct plane *plane, const struct polynomial *p)
{
    const uint32_t i = (uint32_t)(part->start.column - plane->ox), j = (uint32_t)(part->y - plane->oy);
    const uint32_t q = (uint32_t)part->start.column_step;
    const uint32_t t5 = p->a, t4 = p->c, t3 = p->b, t2 = p->d, t1 = p->e;
    part->i_start = p->f + (t1 + t3 * j) * j + (t2 + t4 * j + t5 * i) * i;
    part->di_line = 2 * t5 * i + t4 * j + t5 + t2;
    part->di_start = t5 * q * q + (2 * t5 * i + t4 * j + t4 + t2) * q + t4 * i + 2 * t3 * j + t3 + t1;
    part->ddi = 2 * t5;
    part->di_line_step[0] = 2 * t5 * q + t4;
    part->di_line_step[1] = part->di_line_step[0] + 2 * t5;
    part->di_start_step[0] = 2 * (t5 * q * q + t4 * q + t3);
    part->di_start_step[1] = part->di_start_step[0] + part->di_line_step[0];
}

int datapath_parts(const int16_t *const p[3], unsigned width, unsigned height, const struct plane *plane,
                   const struct polynomial *polynomial, struct datapath_part part[2])
{
    struct corner c[3];
    int top = 0, count = 0;
    for (int k = 0; k < 3; k++) {
        c[k] = (struct corner){p[k][0] + 8 * (int64_t)width - 8, p[k][1] + 8 * (int64_t)height - 8};
        if (c[k].y < c[top].y)
            top = k;
    }
    /* Clockwise: the corner after the top one is on the right. */
    const struct corner a = c[top], right = c[(top + 1) % 3], left = c[(top + 2) % 3];
    const int left_is_lower = left.y > right.y;
    const struct corner middle = left_is_lower ? right : left, last = left_is_lower ? left : right;
    const int32_t row[3] = {(int32_t)(a.y + 15) >> 4, (int32_t)(middle.y + 15) >> 4, (int32_t)(last.y + 15) >> 4};
    for (int k = 0; k < 2; k++) {
        if (row[k] == row[k + 1])
            continue;
        struct datapath_part *out = &part[count++];
        out->y = row[k];
        out->rows = row[k + 1] - row[k];
        /* the side of the middle corner is two edges, the other one */
        const struct edge turning = k ? edge_at(middle, last, row[k]) : edge_at(a, middle, row[k]);
        const struct edge straight = edge_at(a, last, row[k]);
        out->start = left_is_lower ? straight : turning;
        out->end = left_is_lower ? turning : straight;
        set_values(out, plane, polynomial);
    }
    return count;
}
