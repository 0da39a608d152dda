/* SPDX-License-Identifier: MIT */
/*
 * raster/runs.c: any run of any row, any depths, in a band of 17 x 3 depths that fills its memory; any span.
 *
 *   proves: raster_divisors raster_lengths test_values test_steps raster_visible runs_draw_by perspective_divisor
 *   assumes: fx_recip_norm fx_rsqrt_norm
 *   options: -eva-precision 0 -eva-slevel 1000 -eva-split-return full -eva-slevel-merge-after-loop @all
 *            -eva-min-loop-unroll 17
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"

#include "firmware/raster/runs.c"

#define WIDTH 17
#define ROWS  3

static struct raster raster;
static uint16_t depth[WIDTH * ROWS];
static struct span next;

void plane_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out)
{
    for (int i = 0; i < n; i++)
        out[i] = ANY_S32;
}

int edges_spans(struct edges *e, int width, struct span *out, int most)
{
    //@ assert width == WIDTH && most == SPANS;
    for (int i = 0; i < ROWS; i++)
        out[i] = next;
    e->row += ROWS;
    return ROWS;
}

static void shade(struct raster *r, int x, int y, int n)
{
    //@ assert 0 <= x && 1 <= n <= RUN && x + n <= WIDTH;
    r->sum[n - 1][2] = ANY_U32;
}

static void write(struct raster *r, int x, int y, uint32_t mask)
{
    //@ assert 0 < mask < 1 << RUN;
    (void)r;
}

static void run(int n)
{
    struct raster *r = &raster;
    any_bytes(depth, sizeof depth);
    any_bytes(&r->setup.depth, sizeof r->setup.depth);
    r->setup.perspective = any_u32(1, 16);
    r->setup.plane.ox = any_s32(0, 2047);
    r->setup.plane.oy = any_s32(0, 2047);
    raster_divisors(r, 0, 0, n);
    raster_lengths(r, 0, 0, n);
    //@ loop unroll 17;
    for (int x = 0; x + n <= WIDTH; x += WIDTH - n > 0 ? WIDTH - n : 1)
        //@ loop unroll 3;
        for (int y = 2; y < 2 + ROWS; y++)
            raster_visible(r, x, y, n);
}

void prove(void)
{
    struct edges e = {.row = 2, .last = 2 + ROWS};
    raster.width = WIDTH;
    raster.y0 = 2;
    raster.y1 = 2 + ROWS;
    raster.depth = depth;
    //@ loop unroll 16;
    for (int n = 1; n <= RUN; n++)
        run(n);
    //@ loop unroll 18;
    for (int x0 = 0; x0 <= WIDTH; x0++)
        //@ loop unroll 18;
        for (int x1 = 0; x1 <= WIDTH; x1++) {
            e.row = 2;
            next = (struct span){x0, x1};
            runs_draw_by(&raster, &e, shade, write);
        }
}
