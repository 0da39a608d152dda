/* SPDX-License-Identifier: MIT */
#include "pack/order.h"

#include "scene/model.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* A struct's integers in order: how many bytes, halves of a word, words. */
#define ORDER_MOTION   "4h4w"
#define ORDER_CAMERA   "2h8w2h2w"
#define ORDER_VERTEX   "6h"
#define ORDER_TANGENT  "4h"
#define ORDER_TRIANGLE "8h"
#define ORDER_UV       "2h"
#define ORDER_MESH     "11w"
#define ORDER_MATERIAL "14h"
#define ORDER_TEXTURE  "2w4b4h"
#define ORDER_POWER    "132h"
#define ORDER_KEY      "9w"
#define ORDER_OBJECT   "2h8w" ORDER_MOTION
#define ORDER_LIGHT    "2h3w4h" ORDER_MOTION
#define ORDER_HEADER   "1w2h9w8h2w6h4h3w" ORDER_CAMERA

struct order_copy {
    const struct scene_header *scene;
    uint8_t *to;
};

/* Of elements of `size` bytes, from the blob to its copy: arrays may lie over one another. */
static void order_array(const struct order_copy *copy, uint32_t offset, size_t count, const char *layout, size_t size)
{
    const uint8_t *from = scene_at(copy->scene, offset), *end = from + count * size;
    uint8_t *to = copy->to + offset;
    while (from != end) {
        const uint8_t *next = from + size;
        for (const char *at = layout; *at; at++) {
            unsigned long many = strtoul(at, (char **)(uintptr_t)&at, 10);
            const unsigned width = *at == 'w' ? 4 : *at == 'h' ? 2 : 1;
            for (; many; many--, from += width, to += width)
                for (unsigned b = 0; b < width; b++)
                    to[b] = from[width - 1 - b];
        }
        assert(from == next);
    }
}

static void order_textures(const struct order_copy *copy)
{
    const struct scene_texture *t = scene_textures(copy->scene);
    for (const struct scene_texture *end = t + copy->scene->texture_count; t != end; t++) {
        if (t->format == TEXTURE_RGB565)
            order_array(copy, t->texels, (size_t)1 << (t->log2_width + t->log2_height), "1h", sizeof(uint16_t));
        if (t->format == TEXTURE_BUMP8)
            order_array(copy, t->palette, TEXTURE_RISES, "1h", sizeof(uint16_t));
        else
            order_array(copy, t->palette, t->colours, "1w", sizeof(uint32_t));
    }
}

static void order_meshes(const struct order_copy *copy)
{
    const struct scene_mesh *mesh = scene_meshes(copy->scene);
    for (const struct scene_mesh *end = mesh + copy->scene->mesh_count; mesh != end; mesh++) {
        order_array(copy, mesh->vertices, mesh->vertex_count, ORDER_VERTEX, sizeof(struct scene_vertex));
        order_array(copy, mesh->triangles, mesh->triangle_count, ORDER_TRIANGLE, sizeof(struct scene_triangle));
        order_array(copy, mesh->uvs, mesh->uvs ? mesh->vertex_count : 0, ORDER_UV, 2 * sizeof(int16_t));
        order_array(copy, mesh->tangents, mesh->tangents ? mesh->vertex_count : 0, ORDER_TANGENT,
                    sizeof(struct scene_tangent));
    }
}

void order_swap(const struct pack_result *result, struct pack_result *swapped)
{
    const struct scene_header *s = result->scene;
    struct order_copy copy = {s, model_alloc(result->size)};
    struct scene_header *header = (struct scene_header *)copy.to;
    *swapped = (struct pack_result){.scene = header, .size = result->size};
    memcpy(copy.to, s, result->size);
    order_textures(&copy);
    order_meshes(&copy);
    order_array(&copy, s->textures, s->texture_count, ORDER_TEXTURE, sizeof(struct scene_texture));
    order_array(&copy, s->meshes, s->mesh_count, ORDER_MESH, sizeof(struct scene_mesh));
    order_array(&copy, s->materials, s->material_count, ORDER_MATERIAL, sizeof(struct scene_material));
    order_array(&copy, s->powers, s->power_count, ORDER_POWER, sizeof(struct fx_power));
    order_array(&copy, s->lights, s->light_count, ORDER_LIGHT, sizeof(struct scene_light));
    order_array(&copy, s->objects, s->object_count, ORDER_OBJECT, sizeof(struct scene_object));
    order_array(&copy, s->keys, s->key_count, ORDER_KEY, sizeof(struct scene_key));
    order_array(&copy, 0, 1, ORDER_HEADER, sizeof(struct scene_header));
    header->crc = __builtin_bswap32(scene_crc32(0, copy.to + 16, s->length - 16));
}

bool order_is_swapped(const struct scene_header *scene)
{
    return scene->magic == __builtin_bswap32(SCENE_MAGIC);
}
