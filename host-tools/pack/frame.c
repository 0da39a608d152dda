/* SPDX-License-Identifier: MIT */
#include "pack/frame.h"

#include "import/import.h"
#include "scene/scene.h"
#include "scene/vec.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#define DISTANCE   4.0  /* of the eye from the middle, in radii of the model */
#define FROM_ABOVE 0.35 /* radians */
#define ASIDE      0.5  /* radians that the front is turned away at first: a box shows three faces */
#define WIDTH      320
#define HEIGHT     240
#define FILLED     0.94 /* of the picture, the way that fills it more */

/* How far the model's vertices get from the picture's middle, in focal lengths, while it turns. A vertex at height y
 * and distance r from the axis is at angle t seen at r sin t / (a - b cos t) and (c - d cos t) / (a - b cos t), where
 * a = DISTANCE - y sin, b = r cos, c = y cos, d = r sin of FROM_ABOVE. The first is greatest where cos t = b / a, the
 * second, monotonous in cos t, at either end. */
static void reach(const struct model_mesh *mesh, int up, double *across, double *along)
{
    const double sine = sin(FROM_ABOVE), cosine = cos(FROM_ABOVE);
    *across = *along = 0;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const double *p = mesh->vertices[i].position;
        double r = hypot(p[0], p[3 - up]), a = DISTANCE - p[up] * sine, b = r * cosine;
        *across = fmax(*across, r / sqrt(a * a - b * b));
        *along = fmax(*along, fabs(p[up] * cosine - r * sine) / (a - b));
        *along = fmax(*along, fabs(p[up] * cosine + r * sine) / (a + b));
    }
}

static void set_camera(struct model_camera *camera, const struct model_mesh *mesh, int up)
{
    double across, along;
    reach(mesh, up, &across, &along);
    *camera = (struct model_camera){.kind = CAMERA_PERSPECTIVE,
                                    .viewer = VIEWER_INFINITE,
                                    .position = {0, DISTANCE * sin(FROM_ABOVE), DISTANCE * cos(FROM_ABOVE)},
                                    .focal = FILLED / 2 * fmin(WIDTH / across, HEIGHT / along),
                                    .size = {WIDTH, HEIGHT},
                                    .near_plane = DISTANCE - 1.1,
                                    .far_plane = DISTANCE + 1.1};
    vec_quat_axis((const double[3]){1, 0, 0}, FROM_ABOVE, camera->rotation);
}

/* The angle about the upright axis that brings the model's front to +z. The areas of a closed surface cancel; of one
 * that is open to a side, which would be drawn as nothing from there, they point away from it. */
static double facing(const struct model_mesh *mesh, int up)
{
    double sum[3] = {0, 0, 0}, total = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *corner = mesh->triangles[i].corner;
        double ab[3], ac[3], area[3];
        vec_sub(mesh->vertices[corner[1]].position, mesh->vertices[corner[0]].position, ab);
        vec_sub(mesh->vertices[corner[2]].position, mesh->vertices[corner[0]].position, ac);
        vec_cross(ab, ac, area);
        total += vec_length(area);
        for (int k = 0; k < 3; k++)
            sum[k] += area[k];
    }
    const double front = up == 1 ? sum[2] : -sum[1];
    return hypot(sum[0], front) > total / 2 ? -atan2(sum[0], front) : 0;
}

int frame_load(const char *path, struct model *model)
{
    *model = (struct model){.ambient = {.15, .15, .17}, .background = {.20, .21, .23}, .duration_ms = 6000};
    const char *slash = strrchr(path, '/');
    model_add_mesh(model, slash ? slash + 1 : path);
    int code = import_file(path, IMPORT_CREASE * M_PI / 180, model, 0);
    if (code) {
        model_free(model);
        return code;
    }
    struct model_mesh *mesh = &model->meshes[0];
    import_fit(mesh);

    size_t length = strlen(path);
    const int up = length > 4 && !strcasecmp(path + length - 4, ".stl") ? 2 : 1;
    set_camera(&model->camera, mesh, up);

    struct model_light *light = model_add_light(model);
    *light = (struct model_light){.kind = LIGHT_DIRECTIONAL, .vector = {-.45, .65, .75}, .colour = {.85, .85, .83}};
    vec_normalise(light->vector);

    struct model_object *object = model_add_object(model);
    double *rotation = object->pose.rotation, upright[4];
    vec_quat_axis((const double[3]){1, 0, 0}, up == 2 ? -M_PI / 2 : 0, upright);
    vec_quat_axis((const double[3]){0, 1, 0}, facing(mesh, up) + ASIDE, rotation);
    vec_quat_multiply(rotation, upright, rotation);
    object->motion = (struct model_motion){.kind = MOTION_SPIN, .rate = 1 / 6.};
    object->motion.axis[up] = 1; /* the model's own axes: a spin comes before the rotation */
    return 0;
}
