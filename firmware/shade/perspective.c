/* SPDX-License-Identifier: MIT */
#include "shade/perspective.h"

int perspective_setup(struct perspective *p, const struct shade_input *in)
{
    uint32_t closeness[3], most = 1;
    if (!USES(USES_PERSPECTIVE) || !in->divides)
        return 0;
    for (int k = 0; k < 3; k++) {
        uint32_t depth = fx_wrap_u16(in->place[k][VERTEX_DEPTH]);
        closeness[k] = depth > DEPTH_FAR ? depth - DEPTH_FAR : 1;
        most |= closeness[k];
    }
    if (closeness[0] == closeness[1] && closeness[1] == closeness[2])
        return 0;
    p->up = fx_u8(fx_clz(most) - 16);
    p->quadratic = perspective_quadratic;
    for (int k = 0; k < 3; k++)
        p->s[k] = fx_u16(closeness[k] << p->up);
    return 1;
}

void perspective_linear(const struct perspective *p, const struct plane *plane, const int32_t value[3],
                        struct channel *channel)
{
    int32_t numerator[3];
    for (int k = 0; k < 3; k++)
        numerator[k] = value[k] * p->s[k]; /* |v| <= 2^15, s < 2^16 */
    plane_linear_wide(plane, numerator, channel);
}

/* sum Vi li (sum li) - sum Bij li lj has Vi + Vj - Bij before li lj: Vi = Ii si^2, Bij = Vi + Vj - (Ii + Ij - aij) si
 * sj.
 */
void perspective_numerator(const struct perspective *p, const int32_t value[3], const int32_t bulge[3], int32_t v[3],
                           int32_t b[3])
{
    for (int k = 0; k < 3; k++) { /* Q14 * Q32 */
        uint32_t square = fx_u32(p->s[k]) * p->s[k];
        v[k] = fx_s32((fx_s64(value[k]) * square) >> 16);
    }
    /* |Ii + Ij - aij| < 2^3 in Q28, times Q32: below 2^63. With si >= sj and |I| <= 2^29, |aij| <= 2^31 in Q28, |Bij|
     * is below (si^2 - sj^2) 2^29 + si sj 2^31, which sj = si has most of: less than 2^31 - 2^15. */
    for (int k = 0; k < 3; k++) {
        int j = k == 2 ? 0 : k + 1;
        int64_t middle = fx_s64(value[k] + value[j]) * (1 << 14) - bulge[k];
        uint32_t product = fx_u32(p->s[k]) * p->s[j];
        b[k] = fx_s32(((fx_s64(v[k]) + v[j]) >> 2) - fx_s64((middle * fx_s64(product >> 1)) >> 31));
    }
}

void perspective_quadratic(const struct perspective *p, const struct plane *plane, const int32_t value[3],
                           const int32_t bulge[3], struct channel *channel)
{
    int32_t v[3], b[3];
    perspective_numerator(p, value, bulge, v, b);
    plane_quadratic_wide(plane, v, b, channel);
}
