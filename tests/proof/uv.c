/* SPDX-License-Identifier: MIT */
/*
 * shade/uv.c: texture coordinates of any triangle and piece, in perspective and not, by every kind. What sets channels
 * up and weighs a piece's corners is proven elsewhere, or named as not proven: any values here.
 *
 *   proves: uv_corners uv_ratio uv_bulge quadratic range_of uv_spread uv_setup_corners uv_setup
 *   assumes: fx_recip_norm
 *   options: -eva-precision 0 -eva-slevel 100 -eva-min-loop-unroll 3 -eva-split-return full
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"

#include "firmware/shade/uv.c"

/* In place of shade/plane.c, piece.c, perspective.c and plan/texture.c. */
void plane_setup_quadratic(struct plane *plane)
{
    plane->thin = any_flag();
}
void plane_linear(const struct plane *plane, const int32_t value[3], struct channel *channel)
{
    channel->p.d = ANY_U32;
}
void plane_linear_wide(const struct plane *plane, const int32_t value[3], struct channel *channel)
{
    channel->p.d = ANY_U32;
}
void plane_quadratic_wide(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                          struct channel *channel)
{
    channel->p.d = ANY_U32;
}
void piece_linear(const uint16_t (*w)[3], int32_t value[3])
{
    for (int k = 0; k < 3; k++)
        value[k] = any_s32(-32768, 32767);
}
int perspective_setup(struct perspective *p, const struct shade_input *in)
{
    for (int k = 0; k < 3; k++)
        p->s[k] = any_u32(1, 65535);
    p->up = any_u32(0, 15);
    return any_flag();
}
struct texture_spread texture_spread(const struct scene_texture *texture, const uint32_t d[2], int32_t ratio_q15,
                                     uint32_t lit_q8)
{
    const struct texture_spread spread = {d[0], d[1], ratio_q15};
    return spread;
}

volatile int32_t sink;

static void triangles(const struct shade_input *in)
{
    static const unsigned kinds[] = {GLINT_TEXTURE_AFFINE, GLINT_TEXTURE_QUADRATIC, GLINT_TEXTURE_PERSPECTIVE};
    struct shade_setup setup;
    struct surface_texture texture;
    struct uv_corners uv;
    any_bytes(&setup, sizeof setup);
    any_bytes(&texture, sizeof texture);
    uv_corners(&uv, in);
    sink = uv_spread(&uv, &texture).ratio;
    //@ loop unroll 3;
    for (int i = 0; i < 3; i++)
        uv_setup_corners(&setup, &uv, kinds[i]);
    uv_setup(&setup, in, any_u32(0, 5));
}

void prove(void)
{
    static int16_t uvs[3][2];
    static const uint16_t weight[3][3];
    const struct scene_triangle triangle = {.corner = {any_u32(0, 2), any_u32(0, 2), any_u32(0, 2)}};
    struct shade_input in = {.triangle = &triangle, .uvs = uvs};
    any_bytes(uvs, sizeof uvs);
    triangles(&in);
    in.weight = weight;
    triangles(&in);
}
