/* SPDX-License-Identifier: MIT */
/* Any plane that plane_setup() may leave (shade/plane.h), of one scale and one size of determinant. */
#ifndef PLANES_H
#define PLANES_H

#include "shade/plane.h"

#include "proof.h"

/*@ requires \valid(channel) && \valid_read(value + (0 .. 2));
    requires bulge == \null || \valid_read(bulge + (0 .. 2));
    assigns channel->corner \from value[0 .. 2], bulge[0 .. 2]; */
void plane_keep_corners(struct channel *channel, const int32_t value[3], const int32_t bulge[3]);

/*@ requires \valid_read(plane) && \valid_read(channel) && \valid(out + (0 .. n - 1));
    assigns out[0 .. n - 1] \from *plane, *channel, x, y; */
void plane_exact_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out);

/*@ requires \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid_read(bulge + (0 .. 2)) && \valid(channel);
    assigns *channel \from *plane, value[0 .. 2], bulge[0 .. 2]; */
void plane_quadratic_large(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                           struct channel *channel);

/* Of a determinant with `up` leading zeros and corners less than 2^(14 - scale) apart, `scale` as there, by the largest
 * difference or by all differences' bits; 0 if there is none. */
static inline int any_plane(struct plane *p, int scale, int up)
{
    const int32_t side = scale == -2 ? 32768 : (1 << (14 - scale)) - 1;
    const int32_t scaled = scale < 0 ? 16383 + (scale == -2) : side << scale;
    const uint32_t least = 1u << (31 - up), most = (uint32_t)(side + 1) * (uint32_t)(side + 1) * (scale > -2 ? 1 : 0);
    if (scale > -2 && least > most)
        return 0;
    *p = (struct plane){.whole_x1 = any_s32(-side, side),
                        .whole_y1 = any_s32(-side, side),
                        .whole_x2 = any_s32(-side, side),
                        .whole_y2 = any_s32(-side, side),
                        .x1 = any_s32(-scaled, scaled),
                        .y1 = any_s32(-scaled, scaled),
                        .x2 = any_s32(-scaled, scaled),
                        .y2 = any_s32(-scaled, scaled),
                        .scale = scale,
                        .up = up,
                        .det = any_u32(least, up == 1 ? least : 2 * least - 1),
                        .r = any_u32(0x80000000u, UINT32_MAX),
                        .half = any_s32(0x40000000, INT32_MAX),
                        .shift = up - scale - 14,
                        .ox = any_s32(0, 2047),
                        .oy = any_s32(0, 2047),
                        .fx = any_s32(-32768, 32768),
                        .fy = any_s32(-32768, 32768),
                        .sliver = up - 2 * scale > 15};
    return 1;
}

#endif
