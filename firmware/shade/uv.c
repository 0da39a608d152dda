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
        if (in->weight)
            piece_linear(in->weight, value);
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
    const int32_t ratio = (int32_t)(fx_mulhi_u32(difference << up, fx_recip_norm(sum << up)) >> 1);
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
            bulge[k] = uv_bulge((int64_t)value[k] - value[k == 2 ? 0 : k + 1], ratio[k]);
        plane_quadratic_wide(&setup->plane, value, bulge, &setup->uv[axis]);
    }
}

void uv_setup(struct shade_setup *setup, const struct shade_input *in, unsigned kind)
{
    struct uv_corners uv;
    if (setup->uv_kind)
        return;
    uv_corners(&uv, in);
    if (kind == GLINT_TEXTURE_QUADRATIC)
        plane_setup_quadratic(&setup->plane);
    if (uv.distant)
        kind = GLINT_TEXTURE_AFFINE;
    else if (kind == GLINT_TEXTURE_SPLIT || (kind == GLINT_TEXTURE_QUADRATIC && setup->plane.thin))
        kind = GLINT_TEXTURE_PERSPECTIVE;
    setup->uv_kind = (uint8_t)kind;
    setup->uv_up = uv.up;
    if (kind == GLINT_TEXTURE_QUADRATIC) {
        quadratic(setup, &uv);
        return;
    }
    for (int axis = 0; axis < 2; axis++) {
        int32_t value[3];
        for (int k = 0; k < 3; k++)
            value[k] = uv.value[axis][k] >> 16;
        for (int k = 0; k < 3 && kind == GLINT_TEXTURE_PERSPECTIVE; k++)
            value[k] *= uv.s[k]; /* |v| <= 2^15, s < 2^16 */
        if (kind == GLINT_TEXTURE_PERSPECTIVE)
            plane_linear_wide(&setup->plane, value, &setup->uv[axis]);
        else
            plane_linear(&setup->plane, value, &setup->uv[axis]);
    }
}
