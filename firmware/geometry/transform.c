/* SPDX-License-Identifier: MIT */
#include "geometry/transform.h"

/* Bits of a positive number. */
FX_COLD static int bits(uint64_t x)
{
    int n = 0;
    for (; x; x >>= 1)
        n++;
    return n;
}

static int64_t magnitude(int64_t x)
{
    return x < 0 ? -x : x;
}

/* x * 2^-down, rounded to nearest; down < 0 multiplies. |down| <= 62. */
FX_COLD static int64_t scaled(int64_t x, int down)
{
    if (down <= 0)
        return x * (INT64_C(1) << -down);
    return (x + (INT64_C(1) << (down - 1))) >> down;
}

/* x * m * 2^-down where that product would not fit: of m's upper and its lower `cut` bits, each rounded. */
FX_COLD static int64_t long_product(int64_t x, int32_t m, int cut, int down)
{
    return scaled(x * (m >> cut), down - cut) + scaled(x * (m & ((1 << cut) - 1)), down);
}

void view_setup(struct view *view, const struct scene_header *scene, uint16_t width, uint16_t height)
{
    const struct scene_camera *camera = &scene->camera;
    for (int i = 0; i < 4; i++)
        view->rotation.q[i] = camera->rotation[i];
    view->matrix = rotation_matrix(&view->rotation);
    for (int i = 0; i < 3; i++)
        view->position[i] = camera->position[i];
    view->near_plane = camera->near_plane;
    view->far_plane = camera->far_plane;
    view->kind = camera->kind;

    /* f * min(w / rw, h / rh): focal < 2^30 (Q16), times at most 2^11, in Q36 with 16 sub-pixels: below 2^62. */
    uint32_t numerator = width, denominator = camera->reference_width;
    if (fx_u32(height) * camera->reference_width < fx_u32(width) * camera->reference_height) {
        numerator = height;
        denominator = camera->reference_height;
    }
    uint64_t focal = ((fx_u64(fx_u32(camera->focal)) * numerator) << 20); /* 16 f in Q32, times the denominator */
    focal = fx_divide_u64(focal, denominator);
    int size = bits(focal);
    view->focal = fx_u32(size > 31 ? focal >> (size - 31) : focal << (31 - size));
    view->focal_exponent = 32 - (size - 31);
}

/* A row of coefficients c (real value c * 2^-c_exponent a position unit) and an offset, both brought to `exponent`. */
static void axis_setup(struct axis *row, const int64_t c[3], int c_exponent, int64_t t, int t_exponent, int exponent)
{
    for (int i = 0; i < 3; i++) {
        int64_t m = scaled(c[i], c_exponent - exponent - 14);
        row->hi[i] = fx_s32(m >> 14);
        row->lo[i] = fx_s32(m & 0x3fff);
    }
    row->t = fx_s32(scaled(t, t_exponent - exponent));
}

static void depth_setup(struct transform *t, const struct view *view, int z_exponent)
{
    if (transform_divides(
            t)) { /* near / z * span: near exactly, whatever the units of z, so that all objects have one depth */
        unsigned up = fx_clz(fx_u32(view->near_plane));
        t->depth_scale = fx_u32(view->near_plane) << up;
        t->depth_shift = fx_s32(up) + 16 - z_exponent;
        return;
    }
    /* (far - z) * scale >> 32 with scale = span * 2^(32 - up) / range; range is first shifted so that the scale fits.
     */
    uint32_t range = t->range ? t->range : 1;
    unsigned up = fx_clz(range);
    t->depth_scale = fx_u32(fx_divide_u64(fx_u64(DEPTH_NEAR - DEPTH_FAR) << 47, fx_u64(range) << up));
    t->depth_shift = fx_s32(47 - up); /* depth = (far - z) * depth_scale >> depth_shift */
}

int transform_setup(struct transform *out, const struct view *view, const struct scene_mesh *mesh,
                    const struct pose *pose, struct matrix *to_eye)
{
    struct rotation rotation = rotation_product(&view->rotation, &pose->rotation);
    struct matrix world = rotation_matrix(&pose->rotation);
    *to_eye = rotation_matrix(&rotation);

    /* Offset of the mesh's centre in the eye's frame. Positions are below 2^14 units, the centre below 2^14 * 2^8: the
     * sum in Q16 is below 2^39, times Q30 below 2^63 only after a reduction to Q24 of the matrix. */
    int64_t offset[3], eye[3];
    for (int i = 0; i < 3; i++) {
        int64_t centre = 0;
        for (int j = 0; j < 3; j++)
            centre += fx_s64(world.m[i][j]) * mesh->centre[j]; /* Q46, below 2^62 */
        centre = scaled(centre, 22);                           /* Q24 */
        offset[i] = long_product(centre, pose->scale, 8, 16) + /* scale in Q16 */
                    (fx_s64(pose->position[i]) - view->position[i]) * 256;
    }
    for (int i = 0; i < 3; i++) {
        eye[i] = 0;
        for (int j = 0; j < 3; j++) /* offset < 2^47 in Q24; the matrix in Q14 + Q16 halves */
            eye[i] += long_product(offset[j], view->matrix.m[i][j], 16, 30);
    }

    /* One position unit is extent * scale / 32768 long: Q16 * Q16 / 2^15. */
    int64_t extent = fx_s64(mesh->extent) * pose->scale; /* below 2^54 */
    int unit_exponent = 32 + 15;
    while (extent >= INT64_C(1) << 31) { /* 31 bits are more than a vertex's 16 can show */
        extent = (extent + 1) >> 1;
        unit_exponent--;
    }
    int64_t radius = scaled(fx_s64(mesh->radius) * pose->scale, 8) + 1; /* Q24 */
    int64_t ahead = -eye[2];
    if (ahead + radius < fx_s64(view->near_plane) * 256 || ahead - radius > fx_s64(view->far_plane) * 256)
        return 0;

    /* z: |value| < 2^29 over the whole sphere. */
    int64_t largest_z = magnitude(ahead) + radius;
    int z_exponent = 29 - (bits(fx_u64(largest_z)) - 24);
    /* An orthographic depth is measured from the far plane, which must be in range as well. */
    int far_exponent = 30 - (bits(fx_u64(view->far_plane)) - 16);
    if (USES(USES_ORTHOGRAPHIC) && view->kind == CAMERA_ORTHOGRAPHIC && z_exponent > far_exponent)
        z_exponent = far_exponent;
    /* x and y: times 16 f, which has 31 bits and its exponent. */
    int64_t side = magnitude(eye[0]) > magnitude(eye[1]) ? magnitude(eye[0]) : magnitude(eye[1]);
    int side_bits = bits(fx_u64(side + radius)) - 24 + 31 - view->focal_exponent;
    int xy_exponent = 29 - side_bits;
    struct axis *const row[3] = {&out->x, &out->y, &out->z};
    for (int i = 0;; i++) {
        int64_t coefficient[3], sign = i ? -1 : 1; /* y grows downwards on the screen, z away from the eye */
        for (int j = 0; j < 3; j++) {              /* Q30 * 31 bits: 2^61 */
            int64_t c = scaled(fx_s64(to_eye->m[i][j]) * extent, i < 2 ? 31 : 30);
            if (i < 2)
                c = scaled(c * view->focal, 16); /* below 2^30, in unit_exponent - 1 */
            coefficient[j] = sign * c;
        }
        if (i == 2) {
            axis_setup(row[i], coefficient, unit_exponent, ahead, 24, z_exponent);
            break;
        }
        /* eye below 2^48 in Q24: a 31-bit focal length fits after it is reduced to 40 bits. */
        int spare = bits(fx_u64(magnitude(eye[i]))) - 31;
        spare = spare > 0 ? spare : 0;
        axis_setup(row[i], coefficient, unit_exponent - 1 + view->focal_exponent - 16,
                   sign * (scaled(eye[i], spare) * view->focal), 24 - spare + view->focal_exponent, xy_exponent);
    }
    /* The planes may lie far outside the sphere: then they cut nothing, and are held inside the row's range. */
    const int64_t limit = (INT64_C(1) << 30) - 1;
    int64_t near_z = scaled(fx_s64(view->near_plane), 16 - z_exponent);
    int64_t far_z =
        bits(fx_u64(view->far_plane)) + z_exponent - 16 > 30 ? limit : scaled(fx_s64(view->far_plane), 16 - z_exponent);
    out->near_z = fx_s32(near_z < 1 ? 1 : near_z > limit ? limit : near_z);
    out->far_z = fx_s32(far_z);
    out->far_z += !out->far_z; /* as near_z, where both planes are nearer than a step of z */
    out->range = fx_u32(out->far_z - out->near_z);

    out->divide = view->kind == CAMERA_PERSPECTIVE;
    out->shift = transform_divides(out) ? 30 + xy_exponent - z_exponent : xy_exponent;
    depth_setup(out, view, z_exponent);
    return 1;
}
