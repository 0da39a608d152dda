/* SPDX-License-Identifier: MIT */
#include "scene/scene_effects.h"

static uint32_t of_motion(const struct scene_motion *motion)
{
    return motion->kind == MOTION_SPIN ? USES_SPIN : motion->kind == MOTION_KEYS ? USES_KEYS : 0;
}

static uint32_t of_material(const struct scene_material *m)
{
    const int shines = m->ks && (m->specular[0] | m->specular[1] | m->specular[2]);
    return (shines ? USES_SPECULAR : 0) | (m->flags & MATERIAL_TWO_SIDED ? USES_TWO_SIDED : 0) |
           (m->texture != SCENE_NO_TEXTURE ? USES_TEXTURE : 0) | (m->bump != SCENE_NO_TEXTURE ? USES_BUMP : 0);
}

static uint32_t of_camera(const struct scene_camera *c)
{
    return (c->kind == CAMERA_PERSPECTIVE ? USES_PERSPECTIVE : USES_ORTHOGRAPHIC) |
           (c->viewer == VIEWER_LOCAL ? USES_LOCAL_VIEWER : 0);
}

uint32_t scene_effects(const struct scene_header *s)
{
    uint32_t effects = of_camera(&s->camera) | (s->light_count > 1 ? USES_SEVERAL_LIGHTS : 0) |
                       (s->fog.kind != FOG_NONE ? USES_FOG : 0);
    for (unsigned i = 0; i < s->light_count; i++)
        effects |=
            (scene_lights(s)[i].kind == LIGHT_POINT ? USES_POINT_LIGHT : 0) | of_motion(&scene_lights(s)[i].motion);
    for (unsigned i = 0; i < s->object_count; i++)
        effects |= of_motion(&scene_objects(s)[i].motion);
    for (unsigned i = 0; i < s->material_count; i++)
        effects |= of_material(&scene_materials(s)[i]);
    return s->light_count ? effects : effects & ~USES_SPECULAR;
}
