/* SPDX-License-Identifier: MIT */
/*
 * raster/texture.c: runs of any coordinates over textures of 1 and 8 by 1 and 4 texels that fill their memory; either
 * format, nearest and bilinear, repeated and clamped, one channel and three.
 * texture_coordinates() is without alarm as well: that this program divides is a constant, one branch is never taken.
 *
 *   proves: clamp lookup_of factor_of multiply texel nearest blend from_middle bilinear
 *           nearest_565 nearest_565_grey nearest_palette nearest_palette_grey bilinear_565 bilinear_565_grey
 *           bilinear_palette bilinear_palette_grey multiply_run texture_stage perspective_divisor perspective_divide
 *   assumes: fx_recip_norm
 *   options: -eva-precision 0 -eva-slevel 60 -eva-slevel-function texture_coordinates:1000
 *            -eva-split-return full -eva-slevel-merge-after-loop @all
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"

#include "firmware/raster/texture.c"

#define LOG2_WIDTH  3
#define LOG2_HEIGHT 2

static struct raster raster;
static struct scene_texture head;
static uint16_t texels[1 << LOG2_WIDTH << LOG2_HEIGHT];
static uint32_t palette[256];

void plane_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out)
{
    for (int i = 0; i < n; i++)
        out[i] = ANY_S32;
}

static void stage(unsigned log2_width, unsigned log2_height, unsigned format, unsigned flags, unsigned channels)
{
    struct raster *r = &raster;
    const unsigned count = 1u << log2_width << log2_height, bytes = format == TEXTURE_PALETTE8 ? count : 2 * count;
    any_bytes(texels, sizeof texels);
    any_bytes(r->sum, sizeof r->sum);
    any_bytes(r->apart, sizeof r->apart);
    any_bytes(r->uv, sizeof r->uv);
    head.log2_width = log2_width;
    head.log2_height = log2_height;
    head.format = format;
    head.flags = flags;
    r->surface.channels = channels;
    r->surface.texture.head = &head;
    r->surface.texture.texels = (const uint8_t *)texels + (sizeof texels - bytes);
    r->surface.texture.palette = palette;
    for (int i = 0; i < 3; i++)
        r->surface.texture.grey[i] = any_u32(0, 256);
    r->gloss = any_flag() ? r->sum[0] : r->apart[0];
    texture_stage(r, RUN);
}

void prove(void)
{
    for (int i = 0; i < 256; i++)
        palette[i] = any_u32(0, 0xffffff);
    //@ loop unroll 2;
    for (unsigned format = TEXTURE_RGB565; format <= TEXTURE_PALETTE8; format++)
        //@ loop unroll 8;
        for (unsigned flags = 0; flags < 8; flags++)
            //@ loop unroll 4;
            for (unsigned width = 0; width <= LOG2_WIDTH; width += LOG2_WIDTH)
                //@ loop unroll 3;
                for (unsigned height = 0; height <= LOG2_HEIGHT; height += LOG2_HEIGHT) {
                    stage(width, height, format, flags, 1);
                    stage(width, height, format, flags, 3);
                }
    raster.setup.uv_kind = any_flag() ? GLINT_TEXTURE_PERSPECTIVE : GLINT_TEXTURE_AFFINE;
    raster.setup.uv_up = any_u32(0, 15);
    texture_coordinates(&raster, 0, 0, RUN);
}
