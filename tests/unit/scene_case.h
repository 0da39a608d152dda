/* SPDX-License-Identifier: MIT */
/* Scenes made by hand, triangle by triangle, for tests of the renderer. Include after cmocka.h. */
#ifndef SCENE_CASE_H
#define SCENE_CASE_H

#include "scene/scene_effects.h"
#include "scene/texel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define CASE_UNIT 65536 /* a scene unit in Q16 */

struct scene_case_mesh {
    struct scene_mesh head; /* offsets and counts are filled in */
    const struct scene_vertex *vertices;
    const struct scene_triangle *triangles;
    uint32_t vertex_count, triangle_count;
};

/* The parts of a scene; the first `..._count` of each array count. */
struct scene_case {
    struct scene_header head; /* camera, colours, duration; offsets, counts and CRC are filled in */
    struct scene_case_mesh mesh[4];
    struct scene_material material[4]; /* each gets the power table of its shininess */
    struct scene_light light[SCENE_MAX_LIGHTS];
    struct scene_object object[SCENE_MAX_OBJECTS];
    unsigned mesh_count, material_count, light_count, object_count;
    const uint16_t *texels;               /* of material 0, RGB565, or null */
    const int8_t (*bumps)[2];             /* its bump map, or null */
    struct scene_texture texture, bump;   /* their size and flags; a bump map's steepness */
    const int16_t (*uvs)[2];              /* of mesh 0, or null */
    const struct scene_tangent *tangents; /* of mesh 0, or null */
};

/* One mesh, yet without triangles, of extent 1 unit; one white material; one light along +z; one object at the origin,
 * seen from there in perspective, on a picture of this size with a focal length of its width. */
static inline void scene_case_default(struct scene_case *c, uint16_t width, uint16_t height)
{
    memset(c, 0, sizeof *c);
    c->mesh_count = c->material_count = c->light_count = c->object_count = 1;
    struct scene_camera *camera = &c->head.camera;
    camera->rotation[0] = 1 << 30;
    camera->focal = width * CASE_UNIT;
    camera->reference_width = width;
    camera->reference_height = height;
    camera->near_plane = CASE_UNIT / 4;
    camera->far_plane = 64 * CASE_UNIT;
    for (int i = 0; i < 3; i++) {
        c->head.ambient[i] = 32768;
        c->light[0].colour[i] = c->material[0].diffuse[i] = c->material[0].specular[i] = 32768;
    }
    c->mesh[0].head.extent = CASE_UNIT;
    c->mesh[0].head.radius = 2 * CASE_UNIT;
    c->light[0].vector[2] = 1 << 30;
    c->material[0].ka = 32768;
    c->material[0].shininess = 1;
    c->object[0].rotation[0] = 1 << 30;
    c->object[0].scale = CASE_UNIT;
}

/* The same under an orthographic camera by which a position unit is a sub-pixel, so that corners beyond the guard band
 * are known. */
static inline void scene_case_sub_pixels(struct scene_case *c, uint16_t width, uint16_t height)
{
    scene_case_default(c, width, height);
    c->head.camera.kind = CAMERA_ORTHOGRAPHIC;
    c->head.camera.focal = CASE_UNIT;
    c->mesh[0].head.extent = 2048 * CASE_UNIT;
    c->mesh[0].head.radius = 8192 * CASE_UNIT;
    c->head.camera.far_plane = 20000 * CASE_UNIT;
    c->object[0].position[2] = -9000 * CASE_UNIT;
}

/* A unit vector of Q14 as the packer rounds it. */
static inline void scene_case_normal(q14_t out[3], double x, double y, double z)
{
    double length = sqrt(x * x + y * y + z * z);
    out[0] = (q14_t)lrint(x / length * 16384);
    out[1] = (q14_t)lrint(y / length * 16384);
    out[2] = (q14_t)lrint(z / length * 16384);
}

/* The bends of a triangle's edges from its corners' normals; all of them may be quadratic. */
static inline void scene_case_bend(struct scene_triangle *triangle, const struct scene_vertex *vertices)
{
    triangle->flags = 7 * TRIANGLE_QUADRATIC;
    for (int e = 0; e < 3; e++) {
        const q14_t *a = vertices[triangle->corner[e]].normal, *b = vertices[triangle->corner[(e + 1) % 3]].normal;
        double dot = ((double)a[0] * b[0] + (double)a[1] * b[1] + (double)a[2] * b[2]) / (16384. * 16384.);
        double bend = floor((1 - dot) * 32768 + .5);
        triangle->bend[e] = (uint16_t)(bend < 0 ? 0 : bend > 65535 ? 65535 : bend);
    }
}

/* Mesh 0 becomes a net of side x side vertices, row by row from the top left, two triangles a cell. */
static inline void scene_case_net(struct scene_case *c, const struct scene_vertex *vertices,
                                  struct scene_triangle *triangles, int side)
{
    unsigned count = 0;
    for (int cell = 0; cell < (side - 1) * (side - 1); cell++) {
        const int a = cell / (side - 1) * side + cell % (side - 1),
                  corner[2][3] = {{a, a + side, a + side + 1}, {a, a + side + 1, a + 1}};
        for (int t = 0; t < 2; t++, count++) {
            for (int k = 0; k < 3; k++)
                triangles[count].corner[k] = (uint16_t)corner[t][k];
            scene_case_bend(&triangles[count], vertices);
        }
    }
    c->mesh[0].vertices = vertices;
    c->mesh[0].triangles = triangles;
    c->mesh[0].vertex_count = (uint32_t)(side * side);
    c->mesh[0].triangle_count = count;
}

static inline void *scene_case_take(struct scene_header *blob, uint32_t *offset, size_t count, size_t bytes,
                                    const void *from)
{
    void *at = (uint8_t *)blob + blob->length;
    *offset = count ? blob->length : 0;
    if (from)
        memcpy(at, from, count * bytes);
    blob->length += (uint32_t)((count * bytes + 3) & ~(size_t)3);
    return at;
}

static inline size_t scene_case_texels(const struct scene_texture *texture)
{
    return (size_t)1 << (texture->log2_width + texture->log2_height);
}

static inline void scene_case_textures(struct scene_header *blob, const struct scene_case *c,
                                       struct scene_material *material)
{
    const size_t count = (c->texels != NULL) + (c->bumps != NULL);
    struct scene_texture *texture = scene_case_take(blob, &blob->textures, count, sizeof *texture, NULL);
    blob->texture_count = (uint16_t)count;
    if (c->texels) {
        material->texture = 0;
        *texture = c->texture;
        texture->format = TEXTURE_RGB565;
        scene_case_take(blob, &texture->texels, scene_case_texels(texture), sizeof *c->texels, c->texels);
        texture->contrast = texel_contrast(blob, texture);
        texture++;
    }
    if (c->bumps) {
        material->bump = (uint16_t)(count - 1);
        *texture = c->bump;
        texture->format = TEXTURE_BUMP8;
        scene_case_take(blob, &texture->texels, scene_case_texels(texture), sizeof *c->bumps, c->bumps);
        uint16_t *rise = scene_case_take(blob, &texture->palette, TEXTURE_RISES, sizeof *rise, NULL);
        for (uint32_t i = 0; i < TEXTURE_RISES; i++)
            rise[i] = texel_rise(texture->steepness, i);
        texture->contrast = texel_contrast(blob, texture);
    }
}

/* The blob, checked; to be freed by the caller. */
static inline struct scene_header *scene_case_blob(const struct scene_case *c)
{
    size_t size = sizeof(struct scene_header) + 4 * sizeof(struct scene_mesh) + sizeof c->object + sizeof c->light +
                  4 * (sizeof(struct scene_material) + sizeof(struct fx_power)) + 64;
    for (unsigned i = 0; i < c->mesh_count; i++)
        size += (c->mesh[i].vertex_count * (sizeof(struct scene_vertex) + sizeof(struct scene_tangent) + 4)) +
                (c->mesh[i].triangle_count * sizeof(struct scene_triangle)) + 8;
    for (int i = 0; i < 2; i++)
        size += sizeof c->texture + 2 * (scene_case_texels(i ? &c->bump : &c->texture) + TEXTURE_RISES) + 8;
    struct scene_header *blob = calloc(1, size);
    assert_non_null(blob);
    *blob = c->head;
    blob->magic = SCENE_MAGIC;
    blob->version = SCENE_VERSION;
    blob->length = sizeof *blob;
    blob->mesh_count = (uint16_t)c->mesh_count;
    blob->material_count = blob->power_count = (uint16_t)c->material_count;
    blob->light_count = (uint16_t)c->light_count;
    blob->object_count = (uint16_t)c->object_count;
    scene_case_take(blob, &blob->lights, c->light_count, sizeof(struct scene_light), c->light);
    scene_case_take(blob, &blob->objects, c->object_count, sizeof(struct scene_object), c->object);
    struct scene_material *material =
        scene_case_take(blob, &blob->materials, c->material_count, sizeof *material, c->material);
    struct fx_power *power = scene_case_take(blob, &blob->powers, c->material_count, sizeof *power, NULL);
    for (unsigned i = 0; i < c->material_count; i++) {
        material[i].power = (uint16_t)i;
        material[i].texture = material[i].bump = SCENE_NO_TEXTURE;
        fx_power_build(&power[i], material[i].shininess);
    }
    scene_case_textures(blob, c, material);
    struct scene_mesh *mesh = scene_case_take(blob, &blob->meshes, c->mesh_count, sizeof *mesh, NULL);
    for (unsigned i = 0; i < c->mesh_count; i++) {
        const struct scene_case_mesh *from = &c->mesh[i];
        mesh[i] = from->head;
        mesh[i].vertex_count = from->vertex_count;
        mesh[i].triangle_count = from->triangle_count;
        scene_case_take(blob, &mesh[i].vertices, from->vertex_count, sizeof *from->vertices, from->vertices);
        scene_case_take(blob, &mesh[i].triangles, from->triangle_count, sizeof *from->triangles, from->triangles);
        if (c->uvs && i == 0)
            scene_case_take(blob, &mesh[i].uvs, from->vertex_count, sizeof *c->uvs, c->uvs);
        if (c->tangents && i == 0)
            scene_case_take(blob, &mesh[i].tangents, from->vertex_count, sizeof *c->tangents, c->tangents);
    }
    blob->effects = scene_effects(blob) | USES_CLIPPING;
    blob->crc = scene_crc32(0, (const uint8_t *)blob + 16, blob->length - 16);
    assert_int_equal(scene_check(blob, blob->length), SCENE_OK);
    return blob;
}

#endif
