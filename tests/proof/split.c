/* SPDX-License-Identifier: MIT */
/*
 * raster/split.c, with what shade/uv.c and plan/texture.c tell it: any triangle whose texture coordinates are split,
 * down to any part. What draws a part, fine_setup() and effects_draw(), is any here.
 *
 *   proves: find_corners find_terms take_corners errs set_part take_places shows part_of split_begin find_piece
 *           split_draw uv_ratio range_of uv_spread texture_spread texture_quadratic
 *   assumes: part_place part_height part_channel fx_recip_norm plane_setup_quadratic plane_linear plane_linear_wide
 *            plane_quadratic_wide
 *   lemmas: split part_corners
 *   options: -eva-precision 0 -eva-min-loop-unroll 4 -eva-slevel 60
 */
#include "proof.h"

#include "contracts.h"
#include "parts.h"

/*@ requires \valid(plane);
    assigns plane->thin, plane->slim, plane->far, plane->r2 \from *plane; */
void plane_setup_quadratic(struct plane *plane);

/*@ requires \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid(channel);
    assigns *channel \from *plane, value[0 .. 2]; */
void plane_linear(const struct plane *plane, const int32_t value[3], struct channel *channel);

/*@ requires \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid(channel);
    assigns *channel \from *plane, value[0 .. 2]; */
void plane_linear_wide(const struct plane *plane, const int32_t value[3], struct channel *channel);

/*@ requires \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid_read(bulge + (0 .. 2)) && \valid(channel);
    assigns *channel \from *plane, value[0 .. 2], bulge[0 .. 2]; */
void plane_quadratic_wide(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                          struct channel *channel);

#define part_of part_of_worth
#include "firmware/plan/texture.c"
#undef part_of
#include "firmware/shade/uv.c"

#include "firmware/raster/split.c"

static struct raster raster;

int fine_setup(struct edges *e, const struct part_place p[3], unsigned width, unsigned height, int32_t from, int32_t to)
{
    e->last = ANY_S32;
    return any_flag();
}

uint32_t effects_draw(struct raster *r, struct edges *e, runs_shade *shade)
{
    return any_u32(0, 4 << 20);
}

void prove(void)
{
    struct raster *r = &raster;
    static struct scene_texture texture;
    static int16_t place[3][3];
    struct uv_corners uv;
    struct edges e;
    any_bytes(&r->setup, sizeof r->setup);
    any_bytes(place, sizeof place);
    any_bytes(&uv, sizeof uv);
    texture.log2_width = any_u32(0, 10);
    texture.log2_height = any_u32(0, 10);
    texture.contrast = any_u32(0, 65535);
    r->surface.texture.head = &texture;
    r->surface.texture.lit = any_u32(0, 65536);
    r->width = any_u32(1, 2048);
    r->height = any_u32(1, 2048);
    r->y0 = any_u32(0, 2047);
    r->y1 = any_u32(1, 2048);
    r->budget = any_u32(0, 65535);
    for (int k = 0; k < 3; k++) {
        r->input.place[k] = place[k];
        place[k][0] = any_s32(-16384, 16384);
        place[k][1] = any_s32(-16384, 16384);
        uv.s[k] = any_u32(1, 65535);
    }
    uv.distant = any_flag();
    uv_spread(&uv, &r->surface.texture);
    if (split_begin(r, &uv))
        split_draw(r, &e, 0);
}
