/* SPDX-License-Identifier: MIT */
#include "scene/reader.h"

#include "scene/scene.h"
#include "scene/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define CAMERA_MEMBERS "type size focal fov position look_at up transform near far viewer"

static void read_materials(const struct node *materials, struct model *model, int *exit_code)
{
    const char *name;
    json_t *value;
    if (materials->value && !json_is_object(materials->value))
        node_fail(materials, "must be an object");
    json_object_foreach(materials->value, name, value)
    {
        struct node node = node_member(materials, name);
        struct model_material *m = model_add_material(model, name);
        node_object(&node, "diffuse specular ka kd ks shininess flat two_sided texture bump");
        node_member_vector(&node, "diffuse", m->diffuse, 3, 0, 1);
        node_member_vector(&node, "specular", m->specular, 3, 0, 1);
        m->ka = node_member_number(&node, "ka", 0, 1, m->ka);
        m->kd = node_member_number(&node, "kd", 0, 1, m->kd);
        m->ks = node_member_number(&node, "ks", 0, 1, m->ks);
        m->shininess = node_member_number(&node, "shininess", 1, 1023, m->ks > 0 ? NAN : 1);
        struct node flat = node_member(&node, "flat"), two_sided = node_member(&node, "two_sided");
        m->flat = node_bool(&flat, false);
        m->texture = reader_texture(&node, "texture", model, exit_code);
        m->bump = reader_bump(&node, model);
        m->two_sided = node_bool(&two_sided, false);
    }
}

int reader_material(const struct node *owner, const struct model *model)
{
    struct node node = node_member(owner, "material");
    const char *name = node_string(&node, "");
    int index = node.value ? model_find_material(model, name) : -1;
    /* the scene's own come first; those of shapes and model files, which follow, have no name in it */
    if (index >= (int)json_object_size(json_object_get(owner->file->root, "materials")))
        index = -1;
    if (node.value && index < 0)
        node_fail(&node, "no material named \"%s\"", name);
    return index;
}

void reader_lights(const struct node *lights, struct model *model)
{
    size_t count = node_length(lights, 0, SCENE_MAX_LIGHTS);
    for (size_t i = 0; i < count; i++) {
        struct node node = node_item(lights, i);
        struct model_light *light = model_add_light(model);
        node_object(&node, "type towards position colour spin");
        light->kind = node_member_choice(&node, "type", "directional point", LIGHT_DIRECTIONAL);
        const char *needed = light->kind == LIGHT_POINT ? "position" : "towards";
        struct node vector = node_member(&node, needed);
        struct node other = node_member(&node, light->kind == LIGHT_POINT ? "towards" : "position");
        if (!vector.value || other.value)
            node_fail(vector.value ? &other : &vector, vector.value ? "not for this type of light" : "missing");
        node_vector(&vector, light->vector, 3, -READER_MOST_LENGTH, READER_MOST_LENGTH);
        if (light->kind == LIGHT_DIRECTIONAL && !vec_normalise(light->vector))
            node_fail(&vector, "must not be zero");
        memcpy(light->colour, (double[]){1, 1, 1}, sizeof light->colour);
        node_member_vector(&node, "colour", light->colour, 3, 0, 1);
        reader_spin(&node, &light->motion);
    }
}

/* Eye axes: z from the target to the eye, x to the right, y up. */
static void look_at(const struct node *camera, const struct node *target, struct model_camera *out)
{
    double at[3] = {0}, up[3] = {0, 1, 0}, rows[3][3];
    node_vector(target, at, 3, -READER_MOST_LENGTH, READER_MOST_LENGTH);
    node_member_vector(camera, "up", up, 3, -READER_MOST_LENGTH, READER_MOST_LENGTH);
    vec_sub(out->position, at, rows[2]);
    vec_cross(up, rows[2], rows[0]);
    if (!vec_normalise(rows[2]) || !vec_normalise(rows[0]))
        node_fail(target, "the camera must not be there, nor look along \"up\"");
    vec_cross(rows[2], rows[0], rows[1]);
    vec_quat_rows((const double(*)[3])rows, out->rotation);
}

static void read_focal(const struct node *node, struct model_camera *out)
{
    struct node focal = node_member(node, "focal"), fov = node_member(node, "fov");
    if (!focal.value == !fov.value)
        node_fail(node, "needs either \"focal\" (pixels) or \"fov\" (degrees)");
    if (fov.value && out->kind == CAMERA_ORTHOGRAPHIC)
        node_fail(&fov, "not for an orthographic camera");
    if (fov.value)
        out->focal = out->size[1] / 2. / tan(node_number(&fov, 1, 170, NAN) * M_PI / 360);
    else
        out->focal = node_number(&focal, 0.0625, 16383, NAN);
    if (out->focal < 0.0625 || out->focal > 16383)
        node_fail(&fov, "a focal length of %g pixels is out of range", out->focal);
}

void reader_camera(const struct node *node, struct model_camera *out)
{
    struct model_pose pose = model_identity;
    double size[2] = {320, 240};
    node_object(node, CAMERA_MEMBERS);
    out->kind = node_member_choice(node, "type", "perspective orthographic", CAMERA_PERSPECTIVE);
    out->viewer = node_member_choice(node, "viewer", "infinite local", VIEWER_INFINITE);
    node_member_vector(node, "size", size, 2, 1, 2048);
    for (int k = 0; k < 2; k++)
        out->size[k] = (unsigned)size[k];
    if (out->size[0] != size[0] || out->size[1] != size[1])
        node_fail(node, "\"size\" must be whole numbers of pixels");
    read_focal(node, out);
    out->near_plane = node_member_number(node, "near", 1. / 256, 32766, NAN);
    out->far_plane = node_member_number(node, "far", 1. / 256, 32767, NAN);
    if (!(out->near_plane < out->far_plane))
        node_fail(node, "\"near\" must be less than \"far\"");

    struct node position = node_member(node, "position"), transform = node_member(node, "transform");
    struct node target = node_member(node, "look_at");
    if (transform.value && (position.value || target.value))
        node_fail(&transform, "not together with \"position\" or \"look_at\"");
    reader_transform(&transform, &pose);
    if (pose.scale != 1)
        node_fail(&transform, "a camera cannot be scaled");
    node_vector(&position, pose.position, 3, -READER_MOST_LENGTH, READER_MOST_LENGTH);
    memcpy(out->position, pose.position, sizeof out->position);
    for (int k = 0; k < 4; k++) /* from the camera's axes to the world's, turned round */
        out->rotation[k] = k ? -pose.rotation[k] : pose.rotation[k];
    if (target.value)
        look_at(node, &target, out);
}

static void read_fog(const struct node *node, struct model_fog *out)
{
    if (!node->value)
        return;
    out->kind = FOG_LINEAR + node_member_choice(node, "kind", "linear exponential", -1);
    node_object(node, out->kind == FOG_LINEAR ? "kind colour from to" : "kind colour density");
    node_member_vector(node, "colour", out->colour, 3, 0, 1);
    if (out->kind == FOG_EXPONENTIAL) {
        out->density = node_member_number(node, "density", 1e-6, 16, NAN);
        return;
    }
    out->from = node_member_number(node, "from", 0, 32766, NAN);
    out->to = node_member_number(node, "to", 0, 32767, NAN);
    if (!(out->to - out->from >= 1. / 4096))
        node_fail(node, "\"from\" must be less than \"to\"");
}

int reader_load(const char *path, struct model *model)
{
    struct node_file file;
    struct node root;
    *model = (struct model){0};
    int exit_code = node_open(&file, path, &root);
    if (!exit_code) {
        node_object(&root, "materials textures bumps meshes objects lights camera ambient background fog duration");
        node_member_vector(&root, "ambient", model->ambient, 3, 0, 1);
        node_member_vector(&root, "background", model->background, 3, 0, 1);
        model->duration_ms = (uint32_t)lround(1000 * node_member_number(&root, "duration", 0, 1e6, 0));
        struct node materials = node_member(&root, "materials"), meshes = node_member(&root, "meshes");
        struct node lights = node_member(&root, "lights"), objects = node_member(&root, "objects");
        struct node camera = node_member(&root, "camera"), fog = node_member(&root, "fog");
        struct node textures = node_member(&root, "textures");
        struct node bumps = node_member(&root, "bumps");
        read_fog(&fog, &model->fog);
        reader_camera(&camera, &model->camera);
        reader_lights(&lights, model);
        reader_textures(&textures, model, &exit_code);
        reader_bumps(&bumps, model, &exit_code);
        read_materials(&materials, model, &exit_code);
        if (!file.failed)
            reader_meshes(&meshes, model, &exit_code);
        if (!file.failed)
            reader_objects(&objects, model);
        node_close(&file);
    }
    if (!file.failed)
        return 0;
    model_free(model);
    return exit_code ? exit_code : 1; /* of a file that it names, or its own */
}
