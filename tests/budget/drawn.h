/* SPDX-License-Identifier: MIT */
/*
 * Which triangle the integer renderer draws at each pixel: by a method of its own that, instead of shading, notes the
 * triangle in hand where the depth test passes. What is seen is the same by every method.
 */
#ifndef DRAWN_H
#define DRAWN_H

#include "raster/runs.h"
#include "reference/reference.h"

#include <stdlib.h>
#include <string.h>

/* A copy of a scene without texture, bump map and fog, in which each object has a mesh of its own (of the same vertices
 * and triangles), by which a triangle's object is known. */
struct drawn_scene {
    struct scene_header *scene;
    uint32_t first[SCENE_MAX_OBJECTS + 1]; /* the number of an object's first triangle */
};

/* What the method, which takes no argument for it, reads and writes. */
static const struct drawn_scene *drawn_from;
static uint32_t *drawn_to;

static inline void drawn_open(struct drawn_scene *d, const struct scene_header *scene)
{
    const uint32_t length = (scene->length + 3) & ~3u;
    struct scene_header *copy = calloc(1, length + scene->object_count * sizeof(struct scene_mesh));
    if (!copy)
        abort();
    memcpy(copy, scene, scene->length);
    copy->meshes = length;
    copy->mesh_count = scene->object_count;
    struct scene_mesh *mesh = (void *)((uint8_t *)copy + copy->meshes);
    struct scene_object *object = (void *)((uint8_t *)copy + copy->objects);
    uint32_t count = 0;
    for (unsigned o = 0; o < scene->object_count; o++) {
        mesh[o] = scene_meshes(scene)[object[o].mesh];
        object[o].mesh = (uint16_t)o;
        d->first[o] = count;
        count += mesh[o].triangle_count;
    }
    struct scene_material *material = (void *)((uint8_t *)copy + copy->materials);
    for (unsigned m = 0; m < scene->material_count; m++)
        material[m].texture = material[m].bump = SCENE_NO_TEXTURE;
    copy->fog.kind = FOG_NONE;
    d->scene = copy;
}

static inline void drawn_close(struct drawn_scene *d)
{
    free(d->scene);
    d->scene = NULL;
}

static void drawn_setup(struct shade_setup *setup, const struct shade_input *in)
{
    (void)setup, (void)in;
}

static void drawn_shade(struct raster *r, int x, int y, int n)
{
    (void)r, (void)x, (void)y, (void)n;
}

static int drawn_same(const struct scene_vertex *a, const struct scene_vertex *b, int sign)
{
    int same = 1;
    for (int i = 0; i < 3; i++)
        same &= a->position[i] == b->position[i] && a->normal[i] == sign * b->normal[i];
    return same;
}

/* The number, in its mesh, of the triangle in hand: a back is drawn from a copy, its corners in the other turn and its
 * normals opposite. */
static uint32_t drawn_index(const struct shade_input *in, const struct scene_mesh *mesh)
{
    const struct scene_triangle *triangles = scene_at(drawn_from->scene, mesh->triangles);
    const struct scene_vertex *vertices = scene_at(drawn_from->scene, mesh->vertices);
    if (in->vertices == vertices)
        return (uint32_t)(in->triangle - triangles);
    for (uint32_t t = 0; t < mesh->triangle_count; t++) {
        int same = 1;
        for (int k = 0; k < 3; k++)
            same &=
                drawn_same(&vertices[triangles[t].corner[k]], &in->vertices[in->triangle->corner[k ? 3 - k : 0]], -1);
        if (same)
            return t;
    }
    abort();
}

static uint32_t drawn_number; /* of the triangle in hand */

static void drawn_write(struct raster *r, int x, int y, uint32_t mask)
{
    for (uint32_t *to = drawn_to + (size_t)y * r->width + x; mask; mask >>= 1, to++)
        if (mask & 1)
            *to = drawn_number;
}

static uint32_t drawn_draw(struct raster *r, struct edges *e)
{
    const struct scene_mesh *mesh = r->input.object->mesh;
    drawn_number = drawn_from->first[mesh - scene_meshes(drawn_from->scene)] + drawn_index(&r->input, mesh);
    return runs_draw_by(r, e, drawn_shade, drawn_write);
}

static const struct glint_method drawn_method = {.id = GLINT_FLAT, .setup = drawn_setup, .draw = drawn_draw};

#endif
