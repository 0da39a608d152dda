/* SPDX-License-Identifier: MIT */
#include "scene/scene.h"

static uint32_t of_material(const struct scene_material *m)
{
    uint32_t effects = m->texture != SCENE_NO_TEXTURE ? USES_TEXTURE : 0;
    if (m->bump != SCENE_NO_TEXTURE)
        effects |= USES_BUMP;
    if (m->flags & MATERIAL_TWO_SIDED)
        effects |= USES_TWO_SIDED;
    if (m->ks && (m->specular[0] | m->specular[1] | m->specular[2]))
        effects |= USES_SPECULAR;
    return effects;
}

static uint32_t of_motion(const struct scene_motion *m)
{
    return m->kind == MOTION_SPIN ? USES_SPIN : m->kind == MOTION_KEYS ? USES_KEYS : 0;
}

uint32_t scene_effects(const struct scene_header *scene)
{
    uint32_t effects = scene->camera.kind == CAMERA_PERSPECTIVE ? USES_PERSPECTIVE : USES_ORTHOGRAPHIC;
    for (unsigned i = 0; i < scene->material_count; i++)
        effects |= of_material(&scene_materials(scene)[i]);
    if (!scene->light_count)
        effects &= ~USES_SPECULAR;
    if (scene->camera.viewer == VIEWER_LOCAL)
        effects |= USES_LOCAL_VIEWER;
    if (scene->fog.kind != FOG_NONE)
        effects |= USES_FOG;
    if (scene->light_count > 1)
        effects |= USES_SEVERAL_LIGHTS;
    for (unsigned i = 0; i < scene->light_count; i++) {
        const struct scene_light *light = &scene_lights(scene)[i];
        effects |= of_motion(&light->motion) | (light->kind == LIGHT_POINT ? USES_POINT_LIGHT : 0);
    }
    for (unsigned i = 0; i < scene->object_count; i++)
        effects |= of_motion(&scene_objects(scene)[i].motion);
    return effects;
}
