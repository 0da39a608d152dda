/* SPDX-License-Identifier: MIT */
#include "pack/frame.h"

#include "import/import.h"
#include "scene/scene.h"
#include "scene/vec.h"

#include <math.h>
#include <string.h>
#include <strings.h>

/* The unit sphere in 320 x 240: sin(asin(1/d)) f = f / sqrt(d^2 - 1) = 112 of 120 pixels. */
#define DISTANCE   4.0
#define FOCAL      434.0
#define FROM_ABOVE 0.35 /* radians */

static void set_camera(struct model_camera *camera)
{
    *camera = (struct model_camera){.kind = CAMERA_PERSPECTIVE,
                                    .viewer = VIEWER_INFINITE,
                                    .position = {0, DISTANCE * sin(FROM_ABOVE), DISTANCE * cos(FROM_ABOVE)},
                                    .focal = FOCAL,
                                    .size = {320, 240},
                                    .near_plane = DISTANCE - 1.1,
                                    .far_plane = DISTANCE + 1.1};
    vec_quat_axis((const double[3]){1, 0, 0}, FROM_ABOVE, camera->rotation);
}

int frame_load(const char *path, struct model *model)
{
    *model = (struct model){.ambient = {.15, .15, .17}, .background = {.20, .21, .23}, .duration_ms = 6000};
    set_camera(&model->camera);
    const char *slash = strrchr(path, '/');
    model_add_mesh(model, slash ? slash + 1 : path);
    int code = import_file(path, IMPORT_CREASE * M_PI / 180, model, 0);
    if (code) {
        model_free(model);
        return code;
    }
    model->meshes[0].has_uvs = false; /* nothing here would use them */
    import_fit(&model->meshes[0]);

    struct model_light *light = model_add_light(model);
    *light = (struct model_light){.kind = LIGHT_DIRECTIONAL, .vector = {-.45, .65, .75}, .colour = {.85, .85, .83}};
    vec_normalise(light->vector);

    struct model_object *object = model_add_object(model);
    size_t length = strlen(path);
    const bool stands_on_z = length > 4 && !strcasecmp(path + length - 4, ".stl");
    if (stands_on_z)
        vec_quat_axis((const double[3]){1, 0, 0}, -M_PI / 2, object->pose.rotation);
    object->motion = (struct model_motion){.kind = MOTION_SPIN, .rate = 1 / 6.};
    object->motion.axis[stands_on_z ? 2 : 1] = 1; /* the model's own axes: a spin comes before the rotation */
    return 0;
}
