/* SPDX-License-Identifier: MIT */
#include "shade/uv.h"

#include "shade/piece.h"

void uv_corners(struct uv_corners *uv, const struct shade_input *in)
{
    struct perspective perspective;
    for (int axis = 0; axis < 2; axis++) {
        int32_t *value = uv->value[axis];
        for (int k = 0; k < 3; k++)
            value[k] = in->uvs[in->triangle->corner[SHADE_TURN(k)]][axis];
        if (shade_weight(in))
            piece_linear(shade_weight(in), value);
        for (int k = 0; k < 3; k++)
            value[k] *= 1 << 16; /* Q12 of 16 bits */
    }
    uv->distant = !perspective_setup(&perspective, in);
    uv->up = uv->distant ? 0 : perspective.up;
    for (int k = 0; k < 3; k++)
        uv->s[k] = uv->distant ? 0x8000 : perspective.s[k];
}

int32_t uv_ratio(uint32_t si, uint32_t sj)
{
    const uint32_t sum = si + sj, difference = si > sj ? si - sj : sj - si; /* sum below 2^17 and not 0 */
    const unsigned up = fx_clz(sum);
    const int32_t ratio = fx_s32(fx_mulhi_u32(difference << up, fx_recip_norm(sum << up)) >> 1);
    return si > sj ? ratio : -ratio;
}

static void quadratic(struct shade_setup *setup, const struct uv_corners *uv)
{
    int32_t ratio[3];
    for (int k = 0; k < 3; k++)
        ratio[k] = uv_ratio(uv->s[k], uv->s[k == 2 ? 0 : k + 1]);
    for (int axis = 0; axis < 2; axis++) {
        const int32_t *value = uv->value[axis];
        int32_t bulge[3];
        for (int k = 0; k < 3; k++)
            bulge[k] = uv_bulge(fx_s64(value[k]) - value[k == 2 ? 0 : k + 1], ratio[k]);
        plane_quadratic_wide(&setup->plane, value, bulge, &setup->uv[axis]);
    }
}

static uint32_t range_of(const int32_t value[3])
{
    int32_t low = value[0], high = value[0];
    for (int k = 1; k < 3; k++) {
        low = value[k] < low ? value[k] : low;
        high = value[k] > high ? value[k] : high;
    }
    return fx_u32(fx_s64(high) - low);
}

struct texture_spread uv_spread(const struct uv_corners *uv, const struct surface_texture *texture)
{
    const uint32_t d[2] = {range_of(uv->value[0]), range_of(uv->value[1])};
    const int32_t s[3] = {uv->s[0], uv->s[1], uv->s[2]};
    int32_t least = s[0], most = s[0];
    for (int k = 1; k < 3; k++) {
        least = s[k] < least ? s[k] : least;
        most = s[k] > most ? s[k] : most;
    }
    const int32_t ratio = uv_ratio(fx_u32(most), fx_u32(least)) >> 15;
    return texture_spread(texture->head, d, uv->distant ? 0 : ratio + 1, texture->lit);
}

void uv_setup_corners(struct shade_setup *setup, const struct uv_corners *uv, unsigned kind)
{
    if (uv->distant)
        kind = GLINT_TEXTURE_AFFINE;
    if (kind == GLINT_TEXTURE_QUADRATIC)
        plane_setup_quadratic(&setup->plane);
    if (kind != GLINT_TEXTURE_AFFINE && (kind != GLINT_TEXTURE_QUADRATIC || setup->plane.thin))
        kind = GLINT_TEXTURE_PERSPECTIVE;
    setup->uv_kind = fx_u8(kind);
    setup->uv_up = uv->up;
    if (kind == GLINT_TEXTURE_QUADRATIC) {
        quadratic(setup, uv);
        return;
    }
    for (int axis = 0; axis < 2; axis++) {
        int32_t value[3];
        for (int k = 0; k < 3; k++) { /* Q12; |v| <= 2^15, s < 2^16 */
            value[k] = uv->value[axis][k] >> 16;
            value[k] *= kind == GLINT_TEXTURE_PERSPECTIVE ? uv->s[k] : 1;
        }
        (kind == GLINT_TEXTURE_PERSPECTIVE ? plane_linear_wide : plane_linear)(&setup->plane, value, &setup->uv[axis]);
    }
}

void uv_setup(struct shade_setup *setup, const struct shade_input *in, unsigned kind)
{
    struct uv_corners uv;
    uv_corners(&uv, in);
    uv_setup_corners(setup, &uv, kind);
}
