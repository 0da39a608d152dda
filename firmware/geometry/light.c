/* SPDX-License-Identifier: MIT */
/* Lights and the eye in an object's axes. */
#include "geometry/object.h"

#define FARTHEST (INT64_C(1) << 28)

/* A unit vector of the eye's axes in the object's own, as something far. */
static void far_point(const struct matrix *to_eye, const q30_t v[3], struct object_point *out)
{
    q30_t turned[3];
    matrix_apply_transposed(to_eye, v, turned);
    for (int i = 0; i < 3; i++)
        out->at[i] = turned[i] >> 2; /* |turned| <= 2^30 (1 + 2^-16) */
    out->near = 0;
    out->shift = 14;
}

/* A place of the world in the mesh's position units. */
static void near_point(const q16_t world[3], const struct scene_mesh *mesh, const struct pose *pose,
                       struct object_point *out)
{
    struct matrix rotation = rotation_matrix(&pose->rotation);
    int32_t from[3], turned[3];
    int64_t quotient[3], largest = 0;
    /* Differences of positions are below 2^31 + 2^30, as a light that turns may reach 2^31: a quarter of three of them,
     * turned, is below sqrt(3) * 3 * 2^28 < 2^31. They are taken times 2^up / 4: what is near gets up to 12 bits more,
     * since a small mesh has few positions to a Q16. */
    int up = 14;
    for (int i = 0; i < 3; i++) {
        int64_t way = fx_s64(world[i]) - pose->position[i];
        while (up && (way < 0 ? -way : way) << up >> 2 >= 1 << 29)
            up--;
    }
    for (int i = 0; i < 3; i++)
        from[i] = fx_s32(((fx_s64(world[i]) - pose->position[i]) * (1 << up)) >> 2);
    matrix_apply_transposed(&rotation, from, turned);
    for (int i = 0; i < 3; i++) {
        /* Q31 of the mesh's units, times 2^up / 4: below 2^60, the centre's share below 2^30 * 2^27 */
        int64_t local = fx_divide_s64(fx_s64(turned[i]) * (INT64_C(1) << 31), pose->scale) -
                        fx_s64(mesh->centre[i]) * (INT64_C(1) << (13 + up));
        quotient[i] = fx_divide_s64(local, mesh->extent) * 4; /* position units times 2^up */
        const int64_t size = quotient[i] < 0 ? -quotient[i] : quotient[i];
        largest = size > largest ? size : largest;
    }
    largest >>= up;
    int down = 0, shift = 0;
    while (largest >> down > FARTHEST)
        down++;
    while (shift < 8 && (largest + 1) << (shift + 1) <= FARTHEST)
        shift++;
    for (int i = 0; i < 3; i++) /* quotients are below 2^56, with a shift below 2^(28 + 14) */
        out->at[i] = fx_s32(fx_divide_s64(quotient[i] * (1 << shift), 1 << up) >> down);
    out->near = down == 0;
    out->shift = fx_s16(shift);
    if (down) { /* so far that the mesh is a point */
        q14_t unit[3];
        object_unit(out->at, unit);
        for (int i = 0; i < 3; i++)
            out->at[i] = unit[i];
    }
}

void object_light_setup(struct object_state *object, const struct scene_header *scene, const struct view *view,
                        const struct pose *pose, const struct matrix *to_eye, uint32_t time_ms)
{
    static const q30_t ahead[3] = {0, 0, Q30(1, 1)};
    static const int32_t none[3] = {0, 0, 0}; /* far things are so from anywhere */
    const struct scene_light *light = scene_lights(scene);
    if (!USES(USES_LOCAL_VIEWER) || scene->camera.viewer == VIEWER_INFINITE)
        far_point(to_eye, ahead, &object->eye);
    else
        near_point(view->position, object->mesh, pose, &object->eye);
    object->local = fx_u16(object->eye.near);
    for (unsigned i = 0; i < scene->light_count; i++, light++) {
        struct object_light *out = &object->light[i];
        int32_t vector[3], turned[3];
        light_vector_at(scene, light, time_ms, vector);
        if (USES(USES_POINT_LIGHT) && light->kind == LIGHT_POINT) {
            near_point(vector, object->mesh, pose, &out->source);
            object->local |= fx_u16(out->source.near);
        } else {
            q30_t towards[3];
            matrix_apply(&view->matrix, vector, turned);
            for (int j = 0; j < 3; j++)
                turned[j] >>= 2; /* vector_normalise wants |.| < 2^30 */
            vector_normalise(turned, towards);
            far_point(to_eye, towards, &out->source);
        }
        if (!object_near(&out->source) && !object_near(&object->eye)) {
            int32_t sum[3];
            for (int j = 0; j < 3; j++) {
                out->towards[j] = fx_s16(object_way(&out->source, none, j));
                sum[j] = out->towards[j] + object_way(&object->eye, none, j);
            }
            object_unit(sum, out->half);
        } else {
            for (int j = 0; j < 3; j++)
                out->towards[j] = out->half[j] = 0; /* vertices are lit anew, by place */
        }
    }
}
