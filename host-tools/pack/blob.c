/* SPDX-License-Identifier: MIT */
#include "pack/blob.h"

#include "pack/convert.h"
#include "pack/quantise.h"
#include "pack/texture.h"
#include "pack/uses.h"
#include "scene/scene_effects.h"
#include "scene/texel.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "structs are written as they lie in memory");

#define NONE UINT32_MAX

/* A mesh with one choice of materials: it becomes one or more meshes of the blob. */
struct variant {
    size_t mesh;
    int material;
    unsigned first; /* of its meshes in the blob */
    struct quantise_mesh packed;
};

struct builder {
    const struct model *model;
    const char *path;
    struct pack_report *report;
    struct variant *variants;
    size_t variant_count;
    size_t *variant_of; /* of each object of the model */
    struct scene_header header;
    uint8_t *bytes;
    size_t size, room;
};

/* Appends zeroed bytes, or a copy, at a multiple of 4. Returns the offset: 0 for nothing, as an empty array has. */
static uint32_t put(struct builder *b, const void *data, size_t size)
{
    size_t offset = b->size, padded = (size + 3) / 4 * 4;
    if (size == 0)
        return 0;
    while (offset + padded > b->room)
        b->bytes = model_grow(b->bytes, b->room, &b->room, 1);
    memset(b->bytes + offset, 0, padded);
    if (data)
        memcpy(b->bytes + offset, data, size);
    b->size += padded;
    return (uint32_t)offset;
}

static void find_variants(struct builder *b)
{
    const struct model *model = b->model;
    bool *used = model_alloc(model->mesh_count);
    b->variant_of = model_alloc(model->object_count * sizeof *b->variant_of);
    b->variants = model_alloc(model->object_count * sizeof *b->variants);
    for (size_t i = 0; i < model->object_count; i++) {
        const struct model_object *object = &model->objects[i];
        size_t v = 0;
        while (v < b->variant_count &&
               (b->variants[v].mesh != object->mesh || b->variants[v].material != object->material))
            v++;
        if (v == b->variant_count)
            b->variants[b->variant_count++] = (struct variant){.mesh = object->mesh, .material = object->material};
        b->variant_of[i] = v;
        used[object->mesh] = true;
    }
    for (size_t i = 0; i < model->mesh_count; i++)
        b->report->unused_meshes += !used[i];
    free(used);
}

static int quantise_variants(struct builder *b)
{
    unsigned meshes = 0;
    b->report->meshes = model_alloc(b->variant_count * sizeof *b->report->meshes);
    b->report->mesh_count = b->variant_count;
    for (size_t i = 0; i < b->variant_count; i++) {
        struct variant *v = &b->variants[i];
        const struct model_mesh *mesh = &b->model->meshes[v->mesh];
        b->report->meshes[i].name = model_copy(mesh->name);
        const char *reason = quantise_mesh(b->model, mesh, v->material, &v->packed, &b->report->meshes[i]);
        if (reason) {
            fprintf(stderr, "%s: mesh \"%s\" %s\n", b->path, mesh->name, reason);
            return PACK_BAD_DATA;
        }
        v->first = meshes;
        meshes += v->packed.part_count;
    }
    b->header.mesh_count = (uint16_t)meshes; /* at most 255 objects' worth, see put_objects() */
    return PACK_OK;
}

/* The index of the exponent's table among the first `count`, built if it is new. */
static uint16_t find_power(struct fx_power *powers, uint16_t *count, unsigned exponent)
{
    uint16_t i = 0;
    while (i < *count && powers[i].exponent != exponent)
        i++;
    if (i == *count)
        fx_power_build(&powers[(*count)++], exponent);
    return i;
}

/* The textures that the materials use, in the model's order; fills `map` with their indices in the blob. */
static void put_textures(struct builder *b, const struct scene_material *materials, uint16_t *map)
{
    const size_t all = b->model->texture_count;
    struct scene_texture *textures = model_alloc(all * sizeof *textures);
    struct pack_report *report = b->report;
    report->textures = model_alloc(all * sizeof *report->textures);
    for (unsigned i = 0; i < b->header.material_count; i++)
        for (size_t t = 0; t < all; t++)
            map[t] |= materials[i].texture == t || materials[i].bump == t;
    for (size_t t = 0; t < all; t++)
        if (map[t]) {
            struct texture_packed packed;
            texture_pack(&b->model->textures[t], &packed, &report->textures[report->texture_count++]);
            packed.head.texels = put(b, packed.texels, packed.size);
            packed.head.palette = put(b, packed.palette, packed.head.colours * sizeof *packed.palette);
            if (packed.rises)
                packed.head.palette = put(b, packed.rises, TEXTURE_RISES * sizeof *packed.rises);
            map[t] = b->header.texture_count;
            textures[b->header.texture_count++] = packed.head;
            texture_free(&packed);
        }
    b->header.textures = put(b, textures, b->header.texture_count * sizeof *textures);
    for (unsigned i = 0; i < b->header.texture_count; i++) {
        struct scene_texture *at = (struct scene_texture *)(b->bytes + b->header.textures) + i;
        at->contrast = texel_contrast((struct scene_header *)b->bytes, at);
    }
    free(textures);
}

/* Materials that triangles use, in the model's order; triangles are changed to the blob's indices. */
static void put_materials(struct builder *b)
{
    const size_t all = b->model->material_count;
    uint32_t *map = model_alloc(all * sizeof *map), count = 0;
    for (size_t v = 0; v < b->variant_count; v++)
        for (unsigned p = 0; p < b->variants[v].packed.part_count; p++) {
            const struct quantise_part *part = &b->variants[v].packed.parts[p];
            for (uint32_t t = 0; t < part->head.triangle_count; t++)
                map[part->triangles[t].material] = 1;
        }
    struct scene_material *materials = model_alloc(all * sizeof *materials);
    struct fx_power *powers = model_alloc(FX_POWER_MAX_EXPONENT * sizeof *powers);
    for (size_t i = 0; i < all; i++)
        if (map[i]) {
            map[i] = count;
            materials[count] = convert_material(&b->model->materials[i]);
            materials[count].power = find_power(powers, &b->header.power_count, materials[count].shininess);
            materials[count].texture = (uint16_t)b->model->materials[i].texture; /* of the model as yet */
            materials[count].bump = (uint16_t)b->model->materials[i].bump;
            count++;
        }
    for (size_t v = 0; v < b->variant_count; v++)
        for (unsigned p = 0; p < b->variants[v].packed.part_count; p++) {
            struct quantise_part *part = &b->variants[v].packed.parts[p];
            for (uint32_t t = 0; t < part->head.triangle_count; t++)
                part->triangles[t].material = (uint16_t)map[part->triangles[t].material];
        }
    b->header.material_count = (uint16_t)count;
    uint16_t *textures = model_alloc(b->model->texture_count * sizeof *textures);
    put_textures(b, materials, textures);
    for (uint32_t i = 0; i < count; i++) {
        struct scene_material *m = &materials[i];
        m->texture = m->texture == SCENE_NO_TEXTURE ? m->texture : textures[m->texture];
        m->bump = m->bump == SCENE_NO_TEXTURE ? m->bump : textures[m->bump];
    }
    free(textures);
    b->header.materials = put(b, materials, count * sizeof *materials);
    b->header.powers = put(b, powers, b->header.power_count * sizeof *powers);
    free(map);
    free(materials);
    free(powers);
}

static void put_lights_and_keys(struct builder *b)
{
    const struct model *model = b->model;
    struct scene_light *lights = model_alloc(model->light_count * sizeof *lights);
    struct scene_key *keys = model_alloc(model->key_count * sizeof *keys);
    for (size_t i = 0; i < model->light_count; i++)
        lights[i] = convert_light(&model->lights[i]);
    const struct scene_camera camera = convert_camera(&model->camera);
    uses_order_lights(lights, (unsigned)model->light_count, &camera);
    for (size_t i = 0; i < model->key_count; i++)
        keys[i] = convert_key(&model->keys[i], NULL);
    for (size_t o = 0; o < model->object_count; o++) {
        const struct model_motion *m = &model->objects[o].motion;
        for (size_t i = 1; i < m->key_count; i++)
            keys[m->first_key + i] = convert_key(&model->keys[m->first_key + i], &keys[m->first_key + i - 1]);
    }
    b->header.light_count = (uint16_t)model->light_count;
    b->header.key_count = (uint16_t)model->key_count;
    b->header.lights = put(b, lights, model->light_count * sizeof *lights);
    b->header.keys = put(b, keys, model->key_count * sizeof *keys);
    free(lights);
    free(keys);
}

/* An object for each part of its mesh. */
static int put_objects(struct builder *b)
{
    struct scene_object objects[SCENE_MAX_OBJECTS];
    unsigned count = 0;
    for (size_t i = 0; i < b->model->object_count; i++) {
        const struct variant *v = &b->variants[b->variant_of[i]];
        if (count + v->packed.part_count > SCENE_MAX_OBJECTS) {
            fprintf(stderr,
                    "%s: more than %u objects, counting the parts of meshes beyond 65535 vertices or triangles\n",
                    b->path, SCENE_MAX_OBJECTS);
            return PACK_BAD_DATA;
        }
        for (unsigned p = 0; p < v->packed.part_count; p++)
            objects[count++] = convert_object(&b->model->objects[i], v->first + p);
    }
    b->header.object_count = (uint16_t)count;
    b->header.objects = put(b, objects, count * sizeof *objects);
    return PACK_OK;
}

static void put_meshes(struct builder *b)
{
    struct scene_mesh *meshes = model_alloc(b->header.mesh_count * sizeof *meshes), *out = meshes;
    b->header.meshes = put(b, NULL, b->header.mesh_count * sizeof *meshes);
    for (size_t v = 0; v < b->variant_count; v++)
        for (unsigned p = 0; p < b->variants[v].packed.part_count; p++) {
            const struct quantise_part *part = &b->variants[v].packed.parts[p];
            *out = part->head;
            out->vertices = put(b, part->vertices, out->vertex_count * sizeof *part->vertices);
            out->triangles = put(b, part->triangles, out->triangle_count * sizeof *part->triangles);
            out->uvs = put(b, part->uvs, part->uvs ? out->vertex_count * sizeof *part->uvs : 0);
            out->tangents = put(b, part->tangents, part->tangents ? out->vertex_count * sizeof *part->tangents : 0);
            out++;
        }
    memcpy(b->bytes + b->header.meshes, meshes, b->header.mesh_count * sizeof *meshes);
    free(meshes);
}

static void seal(struct scene_header *scene)
{
    scene->crc = scene_crc32(0, (const uint8_t *)scene + 16, scene->length - 16);
}

static int lay_out(struct builder *b)
{
    const struct model *model = b->model;
    put(b, NULL, sizeof b->header);
    int code = put_objects(b);
    if (code)
        return code;
    put_materials(b);
    put_lights_and_keys(b);
    put_meshes(b);
    b->header.magic = SCENE_MAGIC;
    b->header.version = SCENE_VERSION;
    b->header.length = (uint32_t)b->size;
    b->header.duration_ms = model->duration_ms;
    b->header.camera = convert_camera(&model->camera);
    convert_colour(model->ambient, b->header.ambient);
    convert_colour(model->background, b->header.background);
    b->header.fog = convert_fog(&model->fog);
    memcpy(b->bytes, &b->header, sizeof b->header);
    ((struct scene_header *)b->bytes)->effects =
        scene_effects((struct scene_header *)b->bytes) | uses_clipping((struct scene_header *)b->bytes);
    seal((struct scene_header *)b->bytes);
    enum scene_fault fault = scene_check(b->bytes, b->size);
    if (fault) /* what the readers let through and the blob cannot hold */
        fprintf(stderr, "%s: cannot be packed: %s\n", b->path, scene_fault_text(fault));
    return fault ? PACK_BAD_DATA : PACK_OK;
}

int blob_build(const struct model *model, const char *path, struct pack_result *result)
{
    struct builder b = {.model = model, .path = path, .report = model_alloc(sizeof *b.report)};
    int code = PACK_OK;
    if (model->material_count > UINT16_MAX || model->key_count > UINT16_MAX || model->texture_count >= UINT16_MAX) {
        fprintf(stderr, "%s: more than 65535 materials, keys or textures\n", path);
        code = PACK_BAD_DATA;
    }
    if (!code) {
        find_variants(&b);
        code = quantise_variants(&b);
    }
    if (!code)
        code = lay_out(&b);
    *result = (struct pack_result){(struct scene_header *)b.bytes, b.size, b.report};
    if (code)
        pack_free(result);
    for (size_t i = 0; i < b.variant_count; i++)
        quantise_free(&b.variants[i].packed);
    free(b.variants);
    free(b.variant_of);
    return code;
}

void blob_override_shininess(struct scene_header *scene, unsigned shininess)
{
    struct scene_material *materials = (struct scene_material *)((uint8_t *)scene + scene->materials);
    struct fx_power *powers = (struct fx_power *)((uint8_t *)scene + scene->powers);
    if (scene->power_count == 0)
        return;
    fx_power_build(powers, shininess);
    for (unsigned i = 0; i < scene->material_count; i++) {
        materials[i].shininess = (uint16_t)shininess;
        materials[i].power = 0;
    }
    seal(scene);
}
