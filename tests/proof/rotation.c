/* SPDX-License-Identifier: MIT */
/*
 * geometry/rotation: products of rotations whose components are within 2^-16 of [-1, 1], and any vector turned.
 *
 *   proves: round_q60 rotation_product rotation_matrix matrix_apply matrix_apply_transposed
 *   options: -eva-precision 2
 */
#include "proof.h"

#include "firmware/geometry/rotation.c"

static void any_components(q30_t *q, int count)
{
    const int32_t most = (1 << 30) + (1 << 14);
    //@ loop unroll 9;
    for (int i = 0; i < count; i++)
        q[i] = any_s32(-most, most);
}

void prove(void)
{
    struct rotation a, b;
    struct matrix m;
    int32_t out[3];
    const int32_t v[3] = {ANY_S32, ANY_S32, ANY_S32};
    any_components(a.q, 4);
    any_components(b.q, 4);
    rotation_product(&a, &b);
    rotation_matrix(&a);
    any_components(&m.m[0][0], 3);
    any_components(&m.m[1][0], 3);
    any_components(&m.m[2][0], 3);
    matrix_apply(&m, v, out);
    matrix_apply_transposed(&m, v, out);
}
