/* SPDX-License-Identifier: MIT */
/*
 * What scene.h promises of a scene that passes the check, each by itself and without a line of scene_check.c: sizes in
 * 64 bits, lengths in double precision, what its effects are told anew. Not asked, because nothing rests on it: that
 * tables of powers are true, that coordinates of clamped textures are within +-SCENE_MOST_CLAMPED, that the highest
 * byte of a palette's colours is 0, and USES_CLIPPING.
 */
#ifndef PROMISES_H
#define PROMISES_H

#include "scene/scene.h"

#include <math.h>
#include <stdbool.h>
#include <zlib.h>

struct promises {
    const struct scene_header *scene;
    size_t size;
    bool edge; /* a length is so near its bound that the check's roundings decide */
};

/* In a function that returns null, or the first promise that is broken. */
#define PROMISE(condition)     \
    do                         \
        if (!(condition))      \
            return #condition; \
    while (0)
#define PROMISE_ALL(call)                        \
    do {                                         \
        const char *promise_broken_first = call; \
        if (promise_broken_first)                \
            return promise_broken_first;         \
    } while (0)
/* value <= most, by a check whose own rounding is less than `slack`. */
#define PROMISE_NEAR(p, value, most, slack)                            \
    do {                                                               \
        const double promise_over = (double)(value) - (double)(most);  \
        PROMISE(promise_over <= (slack) && "" #value " <= " #most ""); \
        (p)->edge |= promise_over > -(slack);                          \
    } while (0)

static inline bool promises_between(int64_t value, int64_t least, int64_t most)
{
    return least <= value && value <= most;
}

static inline bool promises_colour(const uint16_t c[3])
{
    return c[0] <= 32768 && c[1] <= 32768 && c[2] <= 32768;
}

/* Q16 units, less than 2^14. */
static inline bool promises_place(const int32_t p[3])
{
    return fabs(p[0] / 65536.) < 16384 && fabs(p[1] / 65536.) < 16384 && fabs(p[2] / 65536.) < 16384;
}

/* Whether `count` elements lie at the offset, behind the header; none have no place. */
static inline bool promises_array(const struct scene_header *s, uint64_t offset, uint64_t count, uint64_t element)
{
    return count ? offset % 4 == 0 && offset >= sizeof *s && offset + count * element <= s->length : offset == 0;
}

static inline const char *promises_unit(struct promises *p, const q30_t *v, int components)
{
    double square = 0;
    for (int i = 0; i < components; i++)
        square += ldexp(v[i], -30) * ldexp(v[i], -30);
    PROMISE_NEAR(p, fabs(sqrt(square) - 1), ldexp(1, -20), ldexp(1, -40));
    return NULL;
}

/* Q14, within 2^-13. */
static inline const char *promises_normal(struct promises *p, const int16_t v[3])
{
    const double length = sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]) / 16384;
    PROMISE_NEAR(p, fabs(length - 1), ldexp(1, -13), ldexp(1, -26));
    return NULL;
}

static inline double promises_dot(const int16_t a[3], const int16_t b[3])
{
    return ((double)a[0] * b[0] + (double)a[1] * b[1] + (double)a[2] * b[2]) / (16384. * 16384.);
}

static inline const char *promises_header(struct promises *p)
{
    const struct scene_header *s = p->scene;
    PROMISE((uintptr_t)s % 4 == 0 && p->size >= sizeof *s);
    PROMISE(s->magic == SCENE_MAGIC && s->version == SCENE_VERSION);
    PROMISE(s->length >= sizeof *s && s->length <= p->size);
    PROMISE(s->crc == crc32(0, (const uint8_t *)s + 16, s->length - 16));
    PROMISE(s->reserved == 0 && s->reserved2 == 0);
    PROMISE(s->object_count <= SCENE_MAX_OBJECTS && s->light_count <= SCENE_MAX_LIGHTS);
    PROMISE(promises_array(s, s->meshes, s->mesh_count, sizeof(struct scene_mesh)));
    PROMISE(promises_array(s, s->materials, s->material_count, sizeof(struct scene_material)));
    PROMISE(promises_array(s, s->powers, s->power_count, sizeof(struct fx_power)));
    PROMISE(promises_array(s, s->lights, s->light_count, sizeof(struct scene_light)));
    PROMISE(promises_array(s, s->objects, s->object_count, sizeof(struct scene_object)));
    PROMISE(promises_array(s, s->keys, s->key_count, sizeof(struct scene_key)));
    PROMISE(promises_array(s, s->textures, s->texture_count, sizeof(struct scene_texture)));
    PROMISE(promises_colour(s->ambient) && promises_colour(s->background));
    return NULL;
}

static inline const char *promises_view(struct promises *p)
{
    const struct scene_camera *c = &p->scene->camera;
    const struct scene_fog *f = &p->scene->fog;
    PROMISE(c->kind == CAMERA_PERSPECTIVE || c->kind == CAMERA_ORTHOGRAPHIC);
    PROMISE(c->viewer == VIEWER_INFINITE || c->viewer == VIEWER_LOCAL);
    PROMISE_ALL(promises_unit(p, c->rotation, 4));
    PROMISE(promises_place(c->position));
    PROMISE(c->focal / 65536. >= 1. / 16 && c->focal / 65536. < 16384);
    PROMISE(promises_between(c->reference_width, 1, 2048) && promises_between(c->reference_height, 1, 2048));
    PROMISE(c->near_plane / 65536. >= 1. / 256 && c->near_plane < c->far_plane);
    PROMISE(promises_colour(f->colour));
    PROMISE(f->kind == FOG_NONE || f->kind == FOG_LINEAR || f->kind == FOG_EXPONENTIAL);
    PROMISE(f->kind == FOG_LINEAR ? f->from >= 0 && f->to > f->from : f->from == 0 && f->to == 0);
    PROMISE(f->kind == FOG_EXPONENTIAL ? promises_between(f->density, 1, 1 << 28) : f->density == 0);
    return NULL;
}

/* Channel k of a texel in 1/255, of 565 rounded to the nearest; of a normal, in texel units. */
static inline double promises_texel(const struct scene_header *s, const struct scene_texture *t, uint32_t u, uint32_t v,
                                    int k)
{
    static const struct {
        int shift;
        double most;
    } field[3] = {{0, 31}, {5, 63}, {11, 31}};
    const uint32_t at = (v << t->log2_width) + u;
    const void *texels = scene_at(s, t->texels);
    if (t->format == TEXTURE_BUMP8)
        return k < 2 ? ((const int8_t *)texels)[2 * at + (uint32_t)k] : 0;
    if (t->format == TEXTURE_PALETTE8)
        return ((const uint32_t *)scene_at(s, t->palette))[((const uint8_t *)texels)[at]] >> 8 * k & 255;
    return round((((const uint16_t *)texels)[at] >> field[k].shift & (int)field[k].most) * 255 / field[k].most);
}

/* The largest difference of neighbours; the ends are some unless the texture is clamped. */
static inline double promises_contrast(const struct scene_header *s, const struct scene_texture *t)
{
    const uint32_t width = 1u << t->log2_width, height = 1u << t->log2_height;
    double most = 0;
    for (uint32_t v = 0; v < height; v++)
        for (uint32_t u = 0; u < width; u++)
            for (int k = 0; k < 3; k++) {
                const double here = promises_texel(s, t, u, v, k);
                if (u + 1 < width || !(t->flags & TEXTURE_CLAMP_U))
                    most = fmax(most, fabs(promises_texel(s, t, (u + 1) % width, v, k) - here));
                if (v + 1 < height || !(t->flags & TEXTURE_CLAMP_V))
                    most = fmax(most, fabs(promises_texel(s, t, u, (v + 1) % height, k) - here));
            }
    return most;
}

static inline const char *promises_texture(const struct scene_header *s, const struct scene_texture *t)
{
    const bool bump = t->format == TEXTURE_BUMP8, indexed = t->format == TEXTURE_PALETTE8;
    PROMISE(t->log2_width <= 10 && t->log2_height <= 10 && t->format < TEXTURE_FORMATS && t->reserved == 0);
    PROMISE(!(t->flags & ~(TEXTURE_BILINEAR | TEXTURE_CLAMP_U | TEXTURE_CLAMP_V)));
    PROMISE(bump ? promises_between(t->steepness, 1, TEXTURE_UNIT) : t->steepness == 0);
    PROMISE(indexed ? promises_between(t->colours, 1, 256) : t->colours == 0);
    const uint64_t texels = UINT64_C(1) << t->log2_width << t->log2_height;
    PROMISE(promises_array(s, t->texels, texels, indexed ? 1 : 2));
    PROMISE(bump ? promises_array(s, t->palette, TEXTURE_RISES, 2) : promises_array(s, t->palette, t->colours, 4));
    for (uint64_t i = 0; indexed && i < texels; i++)
        PROMISE(((const uint8_t *)scene_at(s, t->texels))[i] < t->colours);
    for (uint64_t i = 0; bump && i < TEXTURE_RISES; i++) {
        const uint64_t square = (128 * i + 64) * t->steepness * t->steepness >> 14; /* x^2 + y^2 in Q28 */
        const double z = square < 1 << 28 ? floor(sqrt((double)((1 << 28) - square))) : 0;
        PROMISE(((const uint16_t *)scene_at(s, t->palette))[i] == z);
    }
    const double most = promises_contrast(s, t);
    const bool rounded = t->format == TEXTURE_RGB565 && most > 0 && most < 255; /* both of them, by up to a half */
    PROMISE(t->contrast >= 256 * (most + rounded));
    return NULL;
}

static inline const char *promises_material(const struct scene_header *s, const struct scene_material *m)
{
    PROMISE(promises_colour(m->diffuse) && promises_colour(m->specular));
    PROMISE(m->ka <= 32768 && m->kd <= 32768 && m->ks <= 32768 && m->flags < 4);
    PROMISE(m->power < s->power_count && scene_powers(s)[m->power].exponent == m->shininess);
    PROMISE(m->texture == SCENE_NO_TEXTURE || m->texture < s->texture_count);
    PROMISE(m->texture == SCENE_NO_TEXTURE || scene_textures(s)[m->texture].format != TEXTURE_BUMP8);
    PROMISE(m->bump == SCENE_NO_TEXTURE || m->bump < s->texture_count);
    PROMISE(m->bump == SCENE_NO_TEXTURE || scene_textures(s)[m->bump].format == TEXTURE_BUMP8);
    return NULL;
}

static inline const char *promises_power(const struct fx_power *f)
{
    PROMISE(promises_between(f->exponent, 1, FX_POWER_MAX_EXPONENT) && f->octave <= FX_POWER_MAX_OCTAVE);
    for (unsigned i = 0; i < FX_POWER_STEPS; i++)
        PROMISE(f->value[i] <= f->value[i + 1]);
    PROMISE(f->value[FX_POWER_STEPS] <= 32768 && f->value[FX_POWER_STEPS] == f->value[FX_POWER_STEPS + 1]);
    return NULL;
}

static inline const char *promises_vertices(struct promises *p, const struct scene_mesh *m)
{
    const struct scene_vertex *v = scene_at(p->scene, m->vertices);
    const struct scene_tangent *t = scene_at(p->scene, m->tangents);
    double furthest = 0;
    for (uint32_t i = 0; i < m->vertex_count; i++) {
        PROMISE_ALL(promises_normal(p, v[i].normal));
        furthest = fmax(furthest,
                        sqrt((double)v[i].position[0] * v[i].position[0] + (double)v[i].position[1] * v[i].position[1] +
                             (double)v[i].position[2] * v[i].position[2]));
        if (!m->tangents)
            continue;
        PROMISE(t[i].sign == 1 || t[i].sign == -1);
        PROMISE_ALL(promises_normal(p, t[i].tangent));
        PROMISE(fabs(promises_dot(t[i].tangent, v[i].normal)) <= ldexp(1, -11));
    }
    PROMISE((floor(furthest) + 1) * m->extent / 32768 <= m->radius); /* whole units, and one more */
    return NULL;
}

static inline const char *promises_triangles(struct promises *p, const struct scene_mesh *m)
{
    const struct scene_triangle *t = scene_at(p->scene, m->triangles);
    const struct scene_vertex *v = scene_at(p->scene, m->vertices);
    for (uint32_t i = 0; i < m->triangle_count; i++) {
        PROMISE(t[i].flags <= 7 && t[i].material < p->scene->material_count);
        PROMISE(t[i].corner[0] < m->vertex_count && t[i].corner[1] < m->vertex_count &&
                t[i].corner[2] < m->vertex_count);
        const struct scene_material *material = scene_materials(p->scene) + t[i].material;
        PROMISE(material->texture == SCENE_NO_TEXTURE || m->uvs);
        PROMISE(material->bump == SCENE_NO_TEXTURE || (m->uvs && m->tangents));
        for (int e = 0; e < 3; e++) {
            const double dot = promises_dot(v[t[i].corner[e]].normal, v[t[i].corner[(e + 1) % 3]].normal);
            PROMISE_NEAR(p, fabs((1 - dot) * 32768 - t[i].bend[e]), 32, 1.01);
        }
    }
    return NULL;
}

static inline const char *promises_mesh(struct promises *p, const struct scene_mesh *m)
{
    const struct scene_header *s = p->scene;
    PROMISE(promises_between(m->vertex_count, 3, 65535) && promises_between(m->triangle_count, 1, 65535));
    PROMISE(promises_place(m->centre) && m->radius > 0);
    PROMISE(m->extent / 65536. >= 1. / 1024 && m->extent / 65536. < 16384);
    PROMISE(promises_array(s, m->vertices, m->vertex_count, sizeof(struct scene_vertex)));
    PROMISE(promises_array(s, m->triangles, m->triangle_count, sizeof(struct scene_triangle)));
    PROMISE(!m->uvs || promises_array(s, m->uvs, m->vertex_count, 4));
    PROMISE(!m->tangents || promises_array(s, m->tangents, m->vertex_count, sizeof(struct scene_tangent)));
    PROMISE_ALL(promises_vertices(p, m));
    return promises_triangles(p, m);
}

static inline const char *promises_motion(struct promises *p, const struct scene_motion *m)
{
    PROMISE(m->kind == MOTION_NONE || m->kind == MOTION_SPIN || m->kind == MOTION_KEYS);
    PROMISE(m->reserved == 0 && (m->kind == MOTION_KEYS ? m->key_count >= 1 : m->key_count == 0));
    if (m->kind == MOTION_SPIN) {
        PROMISE_ALL(promises_unit(p, m->axis, 3));
        PROMISE(fabs(m->rate / 65536.) < 256);
    }
    if (m->kind == MOTION_KEYS)
        PROMISE(m->first_key + m->key_count <= p->scene->key_count);
    for (int i = 1; i < m->key_count; i++)
        PROMISE(scene_keys(p->scene)[m->first_key + i - 1].time_ms < scene_keys(p->scene)[m->first_key + i].time_ms);
    return NULL;
}

/* Where it stands, as a key and an object say it. */
static inline const char *promises_pose(struct promises *p, const q30_t rotation[4], const q16_t position[3],
                                        q16_t scale)
{
    PROMISE_ALL(promises_unit(p, rotation, 4));
    PROMISE(promises_place(position));
    PROMISE(scale / 65536. >= 1. / 256 && scale / 65536. < 256);
    return NULL;
}

static inline const char *promises_light(struct promises *p, const struct scene_light *l)
{
    PROMISE((l->kind == LIGHT_DIRECTIONAL || l->kind == LIGHT_POINT) && l->flags == 0 && l->reserved == 0);
    PROMISE(promises_colour(l->colour));
    if (l->kind == LIGHT_DIRECTIONAL)
        PROMISE_ALL(promises_unit(p, l->vector, 3));
    PROMISE(l->kind == LIGHT_DIRECTIONAL || promises_place(l->vector));
    return promises_motion(p, &l->motion);
}

static inline uint32_t promises_moves(const struct scene_motion *m)
{
    return (m->kind == MOTION_SPIN) * USES_SPIN + (m->kind == MOTION_KEYS) * USES_KEYS;
}

static inline const char *promises_effects(const struct scene_header *s)
{
    uint32_t uses = s->camera.kind == CAMERA_ORTHOGRAPHIC ? USES_ORTHOGRAPHIC : USES_PERSPECTIVE;
    uses |= (s->camera.viewer == VIEWER_LOCAL) * USES_LOCAL_VIEWER + (s->fog.kind != FOG_NONE) * USES_FOG;
    uses |= (s->light_count >= 2) * USES_SEVERAL_LIGHTS;
    for (int i = 0; i < s->light_count; i++)
        uses |=
            promises_moves(&scene_lights(s)[i].motion) | (scene_lights(s)[i].kind == LIGHT_POINT) * USES_POINT_LIGHT;
    for (int i = 0; i < s->object_count; i++)
        uses |= promises_moves(&scene_objects(s)[i].motion);
    for (int i = 0; i < s->material_count; i++) {
        const struct scene_material *m = scene_materials(s) + i;
        uses |= (m->texture != SCENE_NO_TEXTURE) * USES_TEXTURE | (m->bump != SCENE_NO_TEXTURE) * USES_BUMP;
        uses |= ((m->flags & MATERIAL_TWO_SIDED) != 0) * USES_TWO_SIDED;
        if (s->light_count && m->ks && m->specular[0] + m->specular[1] + m->specular[2])
            uses |= USES_SPECULAR;
    }
    PROMISE(!(s->effects & ~USES_EFFECTS) && (s->effects & uses) == uses);
    return NULL;
}

/* Null if all of them hold, else the first that does not; in the order in which one rests on another. */
static inline const char *promises_broken(struct promises *p)
{
    const struct scene_header *s = p->scene;
    PROMISE_ALL(promises_header(p));
    PROMISE_ALL(promises_view(p));
    for (int i = 0; i < s->texture_count; i++)
        PROMISE_ALL(promises_texture(s, scene_textures(s) + i));
    for (int i = 0; i < s->power_count; i++)
        PROMISE_ALL(promises_power(scene_powers(s) + i));
    for (int i = 0; i < s->material_count; i++)
        PROMISE_ALL(promises_material(s, scene_materials(s) + i));
    for (int i = 0; i < s->mesh_count; i++)
        PROMISE_ALL(promises_mesh(p, scene_meshes(s) + i));
    for (int i = 0; i < s->key_count; i++)
        PROMISE_ALL(promises_pose(p, scene_keys(s)[i].rotation, scene_keys(s)[i].position, scene_keys(s)[i].scale));
    for (int i = 0; i < s->object_count; i++) {
        const struct scene_object *o = scene_objects(s) + i;
        PROMISE(o->mesh < s->mesh_count && o->flags == 0);
        PROMISE_ALL(promises_pose(p, o->rotation, o->position, o->scale));
        PROMISE_ALL(promises_motion(p, &o->motion));
    }
    for (int i = 0; i < s->light_count; i++)
        PROMISE_ALL(promises_light(p, scene_lights(s) + i));
    return promises_effects(s);
}

#endif
