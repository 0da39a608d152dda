/* SPDX-License-Identifier: MIT */
/*
 * raster/parts.c: any part in any picture and band, its colours linear or quadratic, in any format, dithered or not,
 * with effects or without. What draws spans and finds rows is any here; runs are of any length.
 *
 *   proves: shade_part places parts_shows parts_linear parts_quadratic
 *   assumes: part_place part_linear part_quadratic
 *   lemmas: parts part_corners
 *   options: -eva-precision 0 -eva-min-loop-unroll 3 -eva-slevel 40
 */
#include "proof.h"

#include "parts.h"

/*@ requires fine: fine == 0 || fine == 1;
    assigns \result, setup->channel[0 .. 2] \from setup->plane, *corner[0 .. 2], fine; */
int part_linear(struct shade_setup *setup, const struct shade_input *in, const struct part_corner *const corner[3],
                int fine);

/*@ requires there: \valid_read(middle + (0 .. 2));
    assigns \result, setup->channel[0 .. 2] \from setup->plane, *corner[0 .. 2], middle[0 .. 2]; */
int part_quadratic(struct shade_setup *setup, const struct shade_input *in, const struct part_corner *const corner[3],
                   const struct part_corner middle[3]);

#include "firmware/raster/parts.c"

static struct raster raster;
volatile int32_t sink;

int fine_setup(struct edges *e, const struct part_place p[3], unsigned width, unsigned height, int32_t from, int32_t to)
{
    //@ assert -0x20000000 <= p[0].y <= 0x20000000;
    e->last = any_s32(1, 2048);
    return any_flag();
}

void plane_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out)
{
    //@ assert 1 <= n <= RUN;
    //@ loop unroll 16;
    for (int i = 0; i < n; i++)
        out[i] = ANY_S32;
}

void raster_write(struct raster *r, int x, int y, uint32_t mask) {}

uint32_t runs_draw_by(struct raster *r, struct edges *e, runs_shade *shade, runs_write *write)
{
    shade(r, any_s32(0, 2047), any_s32(0, 2047), any_s32(1, RUN));
    return any_u32(0, 4 << 20);
}

uint32_t effects_draw(struct raster *r, struct edges *e, runs_shade *shade)
{
    return runs_draw_by(r, e, shade, raster_write);
}

uint32_t draw_gouraud(struct raster *r, struct edges *e)
{
    return any_u32(0, 4 << 20);
}

void prove(void)
{
    static struct part_corner part[3], middle[3];
    static int16_t place[3][3];
    const struct part_corner *const corner[3] = {&part[0], &part[1], &part[2]};
    struct raster *r = &raster;
    struct edges e;
    any_bytes(&r->setup, sizeof r->setup);
    any_bytes(part, sizeof part);
    any_bytes(middle, sizeof middle);
    r->width = any_u32(1, 2048);
    r->height = any_u32(1, 2048);
    r->y0 = any_u32(0, 2047);
    r->y1 = any_u32(1, 2048);
    r->dither = any_flag();
    r->effects = any_flag() ? USES_FOG : 0;
    for (int k = 0; k < 3; k++) {
        r->input.place[k] = place[k];
        place[k][0] = any_s32(-16384, 16384);
        place[k][1] = any_s32(-16384, 16384);
        for (int i = 0; i < 2; i++)
            part[k].weight[i] = any_u32(0, PART_ONE);
    }
    //@ loop unroll 4;
    for (unsigned format = 0; format <= GLINT_GREY4; format++) {
        r->format = format;
        r->palette.channels = any_flag() ? 1 : 3;
        sink = parts_shows(r, corner);
        sink = parts_linear(r, &e, corner);
        sink = parts_quadratic(r, &e, corner, middle);
    }
}
