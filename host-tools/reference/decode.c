/* SPDX-License-Identifier: MIT */
#include "reference/decode.h"

#include "scene/vec.h"

#include <math.h>
#include <string.h>

static double decode_q(int32_t value, int bits)
{
    return ldexp(value, -bits);
}

static void decode_vector(const int32_t *in, int bits, double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = decode_q(in[i], bits);
}

static void decode_rotation(const q30_t in[4], double out[4])
{
    double length = 0;
    for (int i = 0; i < 4; i++) {
        out[i] = decode_q(in[i], 30);
        length += out[i] * out[i];
    }
    for (int i = 0; i < 4; i++)
        out[i] /= sqrt(length);
}

static void decode_colour(const uint16_t q15[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = decode_q(q15[i], 15);
}

/* A point p goes to position + scale * rotation(p). */
struct decode_pose {
    double rotation[4], position[3], scale;
};

static const struct decode_pose decode_identity = {{1, 0, 0, 0}, {0, 0, 0}, 1};

static void decode_apply(const struct decode_pose *pose, const double in[3], double out[3])
{
    vec_quat_rotate(pose->rotation, in, out);
    for (int i = 0; i < 3; i++)
        out[i] = pose->position[i] + pose->scale * out[i];
}

static void decode_key(const struct scene_key *key, struct decode_pose *pose)
{
    decode_rotation(key->rotation, pose->rotation);
    decode_vector(key->position, 16, pose->position);
    pose->scale = decode_q(key->scale, 16);
}

/* Between two keys, everything linear; the rotation by the shorter way, made unit again. */
static void decode_between(const struct scene_key keys[2], double u, struct decode_pose *pose)
{
    struct decode_pose b;
    double dot = 0, length = 0;
    decode_key(keys, pose);
    decode_key(keys + 1, &b);
    for (int i = 0; i < 4; i++)
        dot += pose->rotation[i] * b.rotation[i];
    for (int i = 0; i < 4; i++) {
        pose->rotation[i] += u * ((dot < 0 ? -b.rotation[i] : b.rotation[i]) - pose->rotation[i]);
        length += pose->rotation[i] * pose->rotation[i];
    }
    for (int i = 0; i < 4; i++)
        pose->rotation[i] /= sqrt(length);
    for (int i = 0; i < 3; i++)
        pose->position[i] += u * (b.position[i] - pose->position[i]);
    pose->scale += u * (b.scale - pose->scale);
}

/* Moves `pose`, a thing's own, to the moment: a spin comes before it, keys replace it. */
static void decode_motion(const struct scene_header *scene, const struct scene_motion *motion, uint32_t time_ms,
                          struct decode_pose *pose)
{
    uint32_t time = scene->duration_ms ? time_ms % scene->duration_ms : time_ms;
    if (motion->kind == MOTION_SPIN) {
        double axis[3], spin[4], turns = decode_q(motion->rate, 16) * time / 1000;
        decode_vector(motion->axis, 30, axis);
        vec_normalise(axis);
        vec_quat_axis(axis, 2 * acos(-1) * (turns - floor(turns)), spin);
        vec_quat_multiply(pose->rotation, spin, pose->rotation);
    } else if (motion->kind == MOTION_KEYS) {
        const struct scene_key *keys = scene_keys(scene) + motion->first_key;
        unsigned last = motion->key_count - 1u, k = 0;
        while (k < last && keys[k + 1].time_ms <= time)
            k++;
        if (k == last || time < keys[k].time_ms)
            decode_key(keys + k, pose);
        else
            decode_between(keys + k, (double)(time - keys[k].time_ms) / (keys[k + 1].time_ms - keys[k].time_ms), pose);
    }
}

/* World to eye. */
static void decode_camera(const struct scene_camera *camera, struct decode_pose *eye)
{
    double position[3];
    decode_rotation(camera->rotation, eye->rotation);
    decode_vector(camera->position, 16, position);
    vec_quat_rotate(eye->rotation, position, position);
    for (int i = 0; i < 3; i++)
        eye->position[i] = -position[i];
    eye->scale = 1;
}

static void decode_light(const struct scene_header *scene, const struct scene_light *light, uint32_t time_ms,
                         const struct decode_pose *eye, struct decode_light *out)
{
    struct decode_pose pose = decode_identity;
    decode_motion(scene, &light->motion, time_ms, &pose);
    decode_colour(light->colour, out->colour);
    out->point = light->kind == LIGHT_POINT;
    if (out->point) {
        decode_vector(light->vector, 16, out->vector);
        pose.scale = 1; /* a light has no size */
        decode_apply(&pose, out->vector, out->vector);
        decode_apply(eye, out->vector, out->vector);
    } else {
        decode_vector(light->vector, 30, out->vector);
        vec_quat_rotate(pose.rotation, out->vector, out->vector);
        vec_quat_rotate(eye->rotation, out->vector, out->vector);
        vec_normalise(out->vector);
    }
}

static void decode_fog(const struct scene_fog *packed, struct decode_fog *fog)
{
    fog->kind = packed->kind;
    decode_colour(packed->colour, fog->colour);
    fog->from = decode_q(packed->from, 16);
    fog->to = decode_q(packed->to, 16);
    fog->density = ldexp(packed->density, -24);
}

void decode_view(const struct scene_header *scene, uint32_t time_ms, unsigned width, unsigned height,
                 struct decode_view *view)
{
    const struct scene_camera *camera = &scene->camera;
    struct decode_pose eye;
    decode_camera(camera, &eye);
    memset(view, 0, sizeof *view);
    view->perspective = camera->kind == CAMERA_PERSPECTIVE;
    view->local_viewer = camera->viewer == VIEWER_LOCAL;
    view->focal = decode_q(camera->focal, 16) *
                  fmin((double)width / camera->reference_width, (double)height / camera->reference_height);
    view->near_plane = decode_q(camera->near_plane, 16);
    view->far_plane = decode_q(camera->far_plane, 16);
    decode_colour(scene->background, view->background);
    decode_fog(&scene->fog, &view->fog);
    view->light_count = scene->light_count;
    for (unsigned i = 0; i < view->light_count; i++)
        decode_light(scene, scene_lights(scene) + i, time_ms, &eye, view->lights + i);
}

static void decode_object(const struct scene_header *scene, const struct scene_object *object, uint32_t time_ms,
                          struct decode_pose *pose)
{
    decode_rotation(object->rotation, pose->rotation);
    decode_vector(object->position, 16, pose->position);
    pose->scale = decode_q(object->scale, 16);
    decode_motion(scene, &object->motion, time_ms, pose);
}

void decode_vertices(const struct scene_header *scene, const struct scene_object *object, uint32_t time_ms,
                     struct decode_vertex *vertices)
{
    const struct scene_mesh *mesh = scene_meshes(scene) + object->mesh;
    const struct scene_vertex *packed = scene_at(scene, mesh->vertices);
    const int16_t(*uvs)[2] = mesh->uvs ? scene_at(scene, mesh->uvs) : NULL;
    const struct scene_tangent *tangents = mesh->tangents ? scene_at(scene, mesh->tangents) : NULL;
    struct decode_pose pose, eye;
    double centre[3], extent = decode_q(mesh->extent, 16);
    decode_object(scene, object, time_ms, &pose);
    decode_camera(&scene->camera, &eye);
    decode_vector(mesh->centre, 16, centre);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        double position[3], normal[3];
        for (int i = 0; i < 3; i++) {
            position[i] = centre[i] + extent * decode_q(packed[v].position[i], 15);
            normal[i] = decode_q(packed[v].normal[i], 14);
        }
        double tangent[3] = {0, 0, 0};
        for (int i = 0; tangents && i < 3; i++)
            tangent[i] = decode_q(tangents[v].tangent[i], 14);
        vertices[v].sign = tangents ? tangents[v].sign : 0;
        vec_quat_rotate(pose.rotation, tangent, tangent);
        vec_quat_rotate(eye.rotation, tangent, vertices[v].tangent);
        for (int k = 0; k < 2; k++)
            vertices[v].uv[k] = uvs ? decode_q(uvs[v][k], 12) : 0;
        decode_apply(&pose, position, position);
        decode_apply(&eye, position, vertices[v].position);
        vec_quat_rotate(pose.rotation, normal, normal);
        vec_quat_rotate(eye.rotation, normal, vertices[v].normal);
    }
}

void decode_turn(const struct scene_header *scene, const struct scene_object *object, uint32_t time_ms, uint16_t yaw,
                 uint16_t pitch, struct decode_vertex *vertices)
{
    static const double right[3] = {0, 1, 0}, down[3] = {1, 0, 0};
    const double step = 2 * acos(-1) / 65536;
    struct decode_pose pose, eye;
    double origin[3], about_y[4], turn[4];
    if (!yaw && !pitch)
        return;
    decode_object(scene, object, time_ms, &pose);
    decode_camera(&scene->camera, &eye);
    decode_apply(&eye, pose.position, origin);
    vec_quat_axis(right, step * yaw, about_y);
    vec_quat_axis(down, -step * pitch, turn);
    vec_quat_multiply(turn, about_y, turn);
    for (uint32_t v = 0; v < scene_meshes(scene)[object->mesh].vertex_count; v++) {
        double *position = vertices[v].position;
        vec_sub(position, origin, position);
        vec_quat_rotate(turn, position, position);
        for (int i = 0; i < 3; i++)
            position[i] += origin[i];
        vec_quat_rotate(turn, vertices[v].normal, vertices[v].normal);
        vec_quat_rotate(turn, vertices[v].tangent, vertices[v].tangent);
    }
}

void decode_material(const struct scene_header *scene, unsigned index, struct decode_material *material)
{
    const struct scene_material *packed = scene_materials(scene) + index;
    double ambient[3];
    decode_colour(scene->ambient, ambient);
    decode_colour(packed->diffuse, material->diffuse);
    decode_colour(packed->specular, material->specular);
    for (unsigned c = 0; c < 3; c++) {
        material->ambient[c] = material->diffuse[c] * decode_q(packed->ka, 15) * ambient[c];
        material->diffuse[c] *= decode_q(packed->kd, 15);
        material->specular[c] *= decode_q(packed->ks, 15);
    }
    material->shininess = packed->shininess;
    material->texture.scene = scene;
    material->bump.scene = scene;
    material->bump.head = packed->bump == SCENE_NO_TEXTURE ? NULL : scene_textures(scene) + packed->bump;
    material->texture.head = packed->texture == SCENE_NO_TEXTURE ? NULL : scene_textures(scene) + packed->texture;
    decode_colour(packed->diffuse, material->grey);
    const double share[3] = {.299, .587, .114};
    double sum = 0;
    for (unsigned c = 0; c < 3; c++)
        sum += material->grey[c] *= share[c];
    for (unsigned c = 0; c < 3; c++)
        material->grey[c] = sum > 0 ? material->grey[c] / sum : share[c];
    material->two_sided = (packed->flags & MATERIAL_TWO_SIDED) != 0;
}

double decode_bend(const struct scene_triangle *triangle, unsigned e)
{
    return decode_q(triangle->bend[e], 16);
}
