/* SPDX-License-Identifier: MIT */
#include "scene/reader.h"
#include "scene/scene.h"
#include "scene/vec.h"

#include <math.h>
#include <string.h>

void reader_axis(const struct node *node, double out[3])
{
    if (json_is_string(node->value)) {
        int axis = node_choice(node, "x y z", -1);
        for (int k = 0; k < 3; k++)
            out[k] = k == axis;
        return;
    }
    memcpy(out, (double[]){0, 0, 0}, 3 * sizeof *out);
    node_vector(node, out, 3, -READER_MOST_LENGTH, READER_MOST_LENGTH);
    if (!vec_normalise(out))
        node_fail(node, "must be \"x\", \"y\", \"z\" or three numbers that are not all zero");
}

/* {"rotate": [axis, angle]} in degrees, or [axis, angle, "rad"]. */
static void rotate(const struct node *node, struct model_pose *pose)
{
    double axis[3], turn[4];
    if (node_length(node, 2, 3) == 0)
        return;
    struct node axis_node = node_item(node, 0), angle_node = node_item(node, 1), unit_node = node_item(node, 2);
    reader_axis(&axis_node, axis);
    double angle = node_number(&angle_node, -36000, 36000, NAN);
    if (node_choice(&unit_node, "deg rad", 0) == 0)
        angle *= M_PI / 180;
    vec_quat_axis(axis, angle, turn);
    vec_quat_multiply(turn, pose->rotation, pose->rotation);
    vec_quat_rotate(turn, pose->position, pose->position);
}

void reader_transform(const struct node *steps, struct model_pose *pose)
{
    size_t count = node_length(steps, 0, 256);
    for (size_t i = 0; i < count; i++) {
        struct node step = node_item(steps, i);
        node_object(&step, "rotate move scale");
        if (json_object_size(step.value) != 1)
            node_fail(&step, "must have exactly one of: rotate move scale");
        struct node turn = node_member(&step, "rotate"), move = node_member(&step, "move");
        double offset[3] = {0}, scale = node_member_number(&step, "scale", 1. / 256, 255.99, 1);
        if (turn.value)
            rotate(&turn, pose);
        node_vector(&move, offset, 3, -READER_MOST_LENGTH, READER_MOST_LENGTH);
        for (int k = 0; k < 3; k++)
            pose->position[k] = pose->position[k] * scale + offset[k];
        pose->scale *= scale;
    }
    for (int k = 0; k < 3; k++)
        if (fabs(pose->position[k]) > READER_MOST_LENGTH)
            node_fail(steps, "ends further than %g units from the origin", READER_MOST_LENGTH);
    if (pose->scale < 1. / 256 || pose->scale > 255.99)
        node_fail(steps, "a scale of %g in all is outside 1/256 .. 255.99", pose->scale);
}

void reader_spin(const struct node *owner, struct model_motion *motion)
{
    struct node spin = node_member(owner, "spin");
    if (!spin.value)
        return;
    node_object(&spin, "axis rate");
    struct node axis = node_member(&spin, "axis");
    reader_axis(&axis, motion->axis);
    motion->kind = MOTION_SPIN;
    motion->rate = node_member_number(&spin, "rate", -255.99, 255.99, NAN);
}

/* Each key's steps follow the object's own. */
static void read_keys(const struct node *keys, struct model *model, const struct model_pose *pose,
                      struct model_motion *motion)
{
    size_t count = node_length(keys, 1, 65535);
    motion->kind = MOTION_KEYS;
    motion->first_key = model->key_count;
    motion->key_count = count;
    for (size_t i = 0; i < count; i++) {
        struct node node = node_item(keys, i);
        node_object(&node, "time transform");
        struct node steps = node_member(&node, "transform");
        struct model_key *key = model_add_key(model);
        key->time_ms = (uint32_t)lround(1000 * node_member_number(&node, "time", 0, 1e6, NAN));
        key->pose = *pose;
        reader_transform(&steps, &key->pose);
        if (i > 0 && key[-1].time_ms >= key->time_ms)
            node_fail(&node, "keys must come in the order of their times, a millisecond apart or more");
    }
}

void reader_objects(const struct node *objects, struct model *model)
{
    size_t count = node_length(objects, 0, SCENE_MAX_OBJECTS);
    for (size_t i = 0; i < count; i++) {
        struct node node = node_item(objects, i);
        node_object(&node, "mesh material transform spin keys");
        struct node mesh = node_member(&node, "mesh"), steps = node_member(&node, "transform");
        struct node keys = node_member(&node, "keys"), spin = node_member(&node, "spin");
        const char *name = node_string(&mesh, NULL);
        int index = model_find_mesh(model, name);
        if (index < 0)
            node_fail(&mesh, "no mesh named \"%s\"", name);
        struct model_object *object = model_add_object(model);
        object->mesh = index < 0 ? 0 : (size_t)index;
        object->material = reader_material(&node, model);
        reader_transform(&steps, &object->pose);
        reader_spin(&node, &object->motion);
        if (keys.value && spin.value)
            node_fail(&keys, "not together with \"spin\"");
        else if (keys.value)
            read_keys(&keys, model, &object->pose, &object->motion);
    }
}
