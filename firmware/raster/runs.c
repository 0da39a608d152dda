/* SPDX-License-Identifier: MIT */
#include "raster/runs.h"

void raster_divisors(struct raster *r, int x, int y, int n)
{
    const unsigned up = r->setup.perspective - 1u;
    plane_values(&r->setup.plane, &r->setup.depth, x, y, n, r->value[0]);
    for (int i = 0; i < n; i++)
        r->divisor[i] = perspective_divisor(fx_wrap_u32(r->value[0][i]), up);
}

/* Squares in Q30, at most 1 and a rounding; a normal shorter than 2^-9 (of opposite corners) is taken for that long. */
void raster_lengths(struct raster *r, int x, int y, int n)
{
    const int32_t least = 1 << 12;
    plane_values(&r->setup.plane, &r->setup.channel[SHADE_SQUARE], x, y, n, r->value[0]);
    for (int i = 0; i < n; i++) {
        uint32_t square = fx_u32(r->value[0][i] > least ? r->value[0][i] : least);
        unsigned up = fx_clz(square) & ~1u; /* square 2^up = v 2^30, v in [1, 4) */
        r->divisor[i] = (struct perspective_divisor){fx_s32(fx_rsqrt_norm(square << up) >> 1), up / 2};
    }
}

/* Tests and writes the depth of the pixels left of `end`: a bit for each that is nearer than what was there. */
static inline uint32_t test_values(const int32_t *value, uint16_t *depth, const uint16_t *end)
{
    uint32_t mask = 0;
    for (uint32_t bit = 1; depth != end; bit <<= 1, depth++) {
        uint32_t z = fx_wrap_u32(*value++) >> 16;
        if (z > *depth) {
            *depth = fx_u16(z);
            mask |= bit;
        }
    }
    return mask;
}

/* The same with depths of a first value and a step. */
static inline uint32_t test_steps(uint32_t value, uint32_t step, uint16_t *depth, const uint16_t *end)
{
    uint32_t mask = 0;
    for (uint32_t bit = 1; depth != end; bit <<= 1, depth++, fx_wrap_inc(&value, step)) {
        uint32_t z = value >> 16;
        if (z > *depth) {
            *depth = fx_u16(z);
            mask |= bit;
        }
    }
    return mask;
}

uint32_t raster_visible(struct raster *r, int x, int y, int n)
{
    const struct channel *channel = &r->setup.depth;
    uint16_t *depth = r->depth + fx_u32(y - r->y0) * r->width + x;
    if (channel->exact) {
        plane_values(&r->setup.plane, channel, x, y, n, r->value[0]);
        return test_values(r->value[0], depth, depth + n);
    }
    const struct polynomial *p = &channel->p;
    uint32_t i = fx_wrap_u32(x - r->setup.plane.ox), j = fx_wrap_u32(y - r->setup.plane.oy);
    return test_steps(fx_wrap_add(fx_wrap_add(p->f, fx_wrap_mul(p->e, j)), fx_wrap_mul(p->d, i)), p->d, depth,
                      depth + n);
}

uint32_t runs_draw_by(struct raster *r, struct edges *e, runs_shade *shade, runs_write *write)
{
    uint32_t drawn = 0;
    int y = e->row;
    do {
        const struct span *span = r->span, *last = span + raster_spans(r, e);
        for (; span != last; span++, y++) {
            for (int x = span->x0; x < span->x1; x += RUN) {
                int n = span->x1 - x < RUN ? span->x1 - x : RUN;
                uint32_t mask = raster_visible(r, x, y, n);
                if (!mask)
                    continue;
                drawn += fx_u32(n);
                for (uint32_t hidden = ~mask & ((1u << n) - 1); hidden; hidden &= hidden - 1)
                    drawn--;
                shade(r, x, y, n);
                write(r, x, y, mask);
            }
        }
    } while (e->row < e->last);
    return drawn;
}
