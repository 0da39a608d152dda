/* SPDX-License-Identifier: MIT */
#include "scene/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct model_pose model_identity = {{1, 0, 0, 0}, {0, 0, 0}, 1};

static void *checked(void *memory)
{
    if (!memory) {
        fputs("glint: out of memory\n", stderr);
        exit(3);
    }
    return memory;
}

void *model_alloc(size_t size)
{
    return checked(calloc(1, size ? size : 1));
}

char *model_copy(const char *text)
{
    return checked(strdup(text));
}

void *model_grow(void *array, size_t count, size_t *room, size_t element)
{
    if (count < *room)
        return array;
    *room = *room ? 2 * *room : 16;
    return checked(*room > SIZE_MAX / element ? NULL : realloc(array, *room * element));
}

void *model_add(void *array, size_t *count, size_t element)
{
    array = checked(realloc(array, (*count + 1) * element));
    memset((char *)array + element * (*count)++, 0, element);
    return array;
}

struct model_mesh *model_add_mesh(struct model *model, const char *name)
{
    model->meshes = model_add(model->meshes, &model->mesh_count, sizeof *model->meshes);
    struct model_mesh *mesh = &model->meshes[model->mesh_count - 1];
    mesh->name = model_copy(name);
    return mesh;
}

struct model_material *model_add_material(struct model *model, const char *name)
{
    model->materials = model_add(model->materials, &model->material_count, sizeof *model->materials);
    struct model_material *m = &model->materials[model->material_count - 1];
    *m = (struct model_material){
        .diffuse = {1, 1, 1}, .specular = {1, 1, 1}, .ka = 1, .kd = 1, .shininess = 1, .texture = -1, .bump = -1};
    m->name = model_copy(name);
    return m;
}

struct model_object *model_add_object(struct model *model)
{
    model->objects = model_add(model->objects, &model->object_count, sizeof *model->objects);
    struct model_object *object = &model->objects[model->object_count - 1];
    object->material = -1;
    object->pose = model_identity;
    return object;
}

struct model_light *model_add_light(struct model *model)
{
    model->lights = model_add(model->lights, &model->light_count, sizeof *model->lights);
    return &model->lights[model->light_count - 1];
}

struct model_key *model_add_key(struct model *model)
{
    model->keys = model_add(model->keys, &model->key_count, sizeof *model->keys);
    return &model->keys[model->key_count - 1];
}

struct model_texture *model_add_texture(struct model *model, const char *name)
{
    model->textures = model_add(model->textures, &model->texture_count, sizeof *model->textures);
    struct model_texture *texture = &model->textures[model->texture_count - 1];
    texture->name = model_copy(name);
    return texture;
}

uint32_t model_add_vertex(struct model_mesh *mesh, const double position[3], const double normal[3], double u, double v)
{
    mesh->vertices = model_grow(mesh->vertices, mesh->vertex_count, &mesh->vertex_room, sizeof *mesh->vertices);
    struct model_vertex *vertex = &mesh->vertices[mesh->vertex_count];
    *vertex = (struct model_vertex){.uv = {u, v}};
    memcpy(vertex->position, position, sizeof vertex->position);
    memcpy(vertex->normal, normal, sizeof vertex->normal);
    return (uint32_t)mesh->vertex_count++;
}

void model_add_triangle(struct model_mesh *mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t material)
{
    mesh->triangles = model_grow(mesh->triangles, mesh->triangle_count, &mesh->triangle_room, sizeof *mesh->triangles);
    mesh->triangles[mesh->triangle_count++] = (struct model_triangle){{a, b, c}, material};
}

int model_find_mesh(const struct model *model, const char *name)
{
    for (size_t i = 0; i < model->mesh_count; i++)
        if (!strcmp(model->meshes[i].name, name))
            return (int)i;
    return -1;
}

int model_find_material(const struct model *model, const char *name)
{
    for (size_t i = 0; i < model->material_count; i++)
        if (!strcmp(model->materials[i].name, name))
            return (int)i;
    return -1;
}

int model_find_texture(const struct model *model, const char *name)
{
    for (size_t i = 0; i < model->texture_count; i++)
        if (!strcmp(model->textures[i].name, name))
            return (int)i;
    return -1;
}

void model_free(struct model *model)
{
    for (size_t i = 0; i < model->mesh_count; i++) {
        free(model->meshes[i].name);
        free(model->meshes[i].vertices);
        free(model->meshes[i].triangles);
    }
    for (size_t i = 0; i < model->material_count; i++) {
        free(model->materials[i].name);
        free(model->materials[i].picture);
        free(model->materials[i].inside);
    }
    for (size_t i = 0; i < model->texture_count; i++) {
        free(model->textures[i].name);
        free(model->textures[i].rgb);
        free(model->textures[i].normals);
    }
    free(model->textures);
    free(model->meshes);
    free(model->materials);
    free(model->objects);
    free(model->lights);
    free(model->keys);
    *model = (struct model){0};
}
