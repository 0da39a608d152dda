/* SPDX-License-Identifier: MIT */
/*
 * shade/plane.c and plane_wide.c: channels over any plane that shade/part.c makes. Parts are lower than what
 * plane_setup_quadratic() takes for 32 bits, and may be smaller than a pixel; they are no
 * slivers, though, so that of plane_linear() and plane_quadratic() not all is met here (but in plane.c).
 *
 *   proves: slope_wide slope_near slope_of gradient shifted form curve_of curve_shift second_difference
 *           product narrowed find_gradient finish plane_quadratic_large
 *   assumes: plane_keep_corners
 *   options: -eva-precision 2 -eva-slevel 100
 */
#include "proof.h"

#include "part_planes.h"

/*@ requires \valid(channel) && \valid_read(value + (0 .. 2));
    requires bulge == \null || \valid_read(bulge + (0 .. 2));
    assigns channel->corner \from value[0 .. 2], bulge[0 .. 2]; */
void plane_keep_corners(struct channel *channel, const int32_t value[3], const int32_t bulge[3]);

#include "firmware/shade/plane.c"
#include "firmware/shade/plane_wide.c"

static struct plane any_part(int scale)
{
    const int32_t most = scale == -1 ? 32767 : 32768;
    return (struct plane){.whole_x1 = any_s32(-32768, most),
                          .whole_y1 = any_s32(-32768, most),
                          .whole_x2 = any_s32(-32768, most),
                          .whole_y2 = any_s32(-32768, most),
                          .x1 = any_s32(-16383, 16383),
                          .y1 = any_s32(-16383, 16383),
                          .x2 = any_s32(-16383, 16383),
                          .y2 = any_s32(-16383, 16383),
                          .scale = scale,
                          .det = ANY_U32,
                          .r = any_u32(0x80000000u, UINT32_MAX),
                          .half = any_s32(0x40000000, INT32_MAX),
                          .r2 = any_s32(0x20000000, INT32_MAX),
                          .ox = ANY_S32,
                          .oy = ANY_S32,
                          .fx = any_s32(-8, 8),
                          .fy = any_s32(-8, 8)};
}

static int32_t any_value(void)
{
    return any_s32(-(1 << 14) - (1 << 11), (1 << 14) + (1 << 11));
}

static int32_t any_bulge(void)
{
    return any_s32(-(1 << 28), 1 << 28);
}

void prove(void)
{
    struct channel channel;
    //@ loop unroll 16;
    for (int scale = -2; scale <= 13; scale++) {
        struct plane plane = any_part(scale);
        const int32_t linear[3] = {any_s32(0, 65535), any_s32(0, 65535), any_s32(0, 65535)};
        const int32_t value[3] = {any_value(), any_value(), any_value()};
        const int32_t bulge[3] = {any_bulge(), any_s32(-(1 << 29), 1 << 29), any_bulge()};
        //@ loop unroll 31;
        for (plane.shift = -13; plane.shift <= 17; plane.shift++)
            plane_linear(&plane, linear, &channel);
        plane.far = scale < 0 ? 1 : any_flag();
        //@ loop unroll 7;
        for (int zeros = 3; zeros <= 9; zeros++) {
            plane.up = zeros + 2 * scale;
            plane.shift = plane.up - scale - 14;
            plane_quadratic(&plane, value, bulge, &channel);
        }
    }
}
