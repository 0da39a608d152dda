/* SPDX-License-Identifier: MIT */
/*
 * The one place where a scene is not trusted. Order matters: the header and its CRC first, then that every array lies
 * inside the blob, and only then the arrays' contents, so that no reference is followed before it is known to be good.
 * What only an effect reads that this program has no code for is not looked at.
 */
#include "scene/scene_effects.h"
#include "scene/texel.h"

#include <stdbool.h>

#define POSITION_END (1 << 30) /* 2^14 units in Q16 */
#define SCALE_MIN    (1 << 8)  /* 2^-8 */
#define SCALE_END    (1 << 24) /* 2^8 */
#define UNIT_Q15     32768u
#define RATE_END     (1 << 24) /* 2^8 turns a second */

static bool in_range(int32_t value, int32_t first, int32_t end)
{
    return value >= first && value < end;
}

static bool position_ok(const q16_t p[3])
{
    return in_range(p[0], 1 - POSITION_END, POSITION_END) && in_range(p[1], 1 - POSITION_END, POSITION_END) &&
           in_range(p[2], 1 - POSITION_END, POSITION_END);
}

static bool colour_ok(const uint16_t c[3])
{
    return c[0] <= UNIT_Q15 && c[1] <= UNIT_Q15 && c[2] <= UNIT_Q15;
}

/* Length within 2^-20 of 1. Components are at most 2^30 + 2^10 here, so four squares stay below 2^63. */
static bool unit_ok(const q30_t *v, unsigned components)
{
    int64_t excess = -((int64_t)1 << 60);
    /*@ loop invariant 0 <= components <= \at(components, Pre);
        loop invariant v == \at(v, Pre) + (\at(components, Pre) - components);
        loop invariant 0 <= excess + 0x1000000000000000 <= (\at(components, Pre) - components) * 0x2000000000000000;
        loop assigns v, components, excess;
        loop variant components; */
    for (; components; components--) {
        int32_t c = *v++;
        if (!in_range(c, -(1 << 30) - (1 << 10), (1 << 30) + (1 << 10) + 1))
            return false;
        excess += (int64_t)c * c;
    }
    const int64_t most = ((int64_t)1 << 41) + (1 << 20); /* (1 + 2^-20)^2 - 1 in Q60 */
    return excess <= most && excess >= -most;
}

/* An array of `count` elements at `offset`, inside the blob and behind the header; an empty one has offset 0. */
static bool array_ok(const struct scene_header *s, uint32_t offset, uint32_t count, uint32_t element)
{
    if (count == 0)
        return offset == 0;
    /* count <= 65535 and element < 2^9, or texels of 2^20 and element <= 2: the product fits */
    return offset % 4 == 0 && offset >= sizeof *s && offset <= s->length && count * element <= s->length - offset;
}

static enum scene_fault check_header(const struct scene_header *s, size_t size)
{
    if ((uintptr_t)s % 4 != 0)
        return SCENE_E_ALIGN;
    if (size < sizeof *s)
        return SCENE_E_SHORT;
    if (s->magic != SCENE_MAGIC)
        return SCENE_E_MAGIC;
    if (s->version != SCENE_VERSION)
        return SCENE_E_VERSION;
    if (s->length < sizeof *s || s->length > size)
        return SCENE_E_SHORT;
    if (s->crc != scene_crc32(0, (const uint8_t *)s + 16, s->length - 16))
        return SCENE_E_CRC;
    if (s->reserved != 0 || s->reserved2 != 0 || s->object_count > SCENE_MAX_OBJECTS ||
        s->light_count > SCENE_MAX_LIGHTS)
        return SCENE_E_RANGE;
    if (!array_ok(s, s->meshes, s->mesh_count, sizeof(struct scene_mesh)) ||
        !array_ok(s, s->materials, s->material_count, sizeof(struct scene_material)) ||
        !array_ok(s, s->powers, s->power_count, sizeof(struct fx_power)) ||
        !array_ok(s, s->lights, s->light_count, sizeof(struct scene_light)) ||
        !array_ok(s, s->objects, s->object_count, sizeof(struct scene_object)) ||
        !array_ok(s, s->keys, s->key_count, sizeof(struct scene_key)) ||
        !array_ok(s, s->textures, s->texture_count, sizeof(struct scene_texture)))
        return SCENE_E_STRUCTURE;
    return SCENE_OK;
}

static enum scene_fault check_camera(const struct scene_header *s)
{
    const struct scene_camera *c = &s->camera;
    bool ok = colour_ok(s->ambient) && colour_ok(s->background) && c->kind <= CAMERA_ORTHOGRAPHIC &&
              c->viewer <= VIEWER_LOCAL && unit_ok(c->rotation, 4) && position_ok(c->position) &&
              in_range(c->focal, 1 << 12, 1 << 30) && in_range(c->reference_width, 1, 2049) &&
              in_range(c->reference_height, 1, 2049) && c->near_plane >= SCALE_MIN && c->near_plane < c->far_plane;
    return ok ? SCENE_OK : SCENE_E_RANGE;
}

static enum scene_fault check_fog(const struct scene_fog *f)
{
    bool far = f->kind == FOG_LINEAR ? f->from >= 0 && f->from < f->to : f->from == 0 && f->to == 0;
    bool dense = f->kind == FOG_EXPONENTIAL ? f->density >= 1 && f->density <= 1u << 28 : f->density == 0;
    return f->kind <= FOG_EXPONENTIAL && colour_ok(f->colour) && far && dense ? SCENE_OK : SCENE_E_RANGE;
}

/* A square in Q28 of a length within 2^-13 of 1. */
static bool square_ok(uint32_t square)
{
    return square + (1u << 16) >= 1u << 28 && square <= (1u << 28) + (1u << 16) + 4; /* (1 + 2^-13)^2 */
}

/* Positions inside the bounding sphere, on which clipping relies, and normals of unit length. */
static enum scene_fault check_vertices(const struct scene_header *s, const struct scene_mesh *mesh)
{
    const struct scene_vertex *v = scene_at(s, mesh->vertices);
    uint32_t furthest = 0;
    /*@ loop invariant 0 <= i <= mesh->vertex_count && v == VERTICES(s, mesh) + i && furthest <= 3 * 0x40000000;
        loop invariant \forall integer j, k; 0 <= j < i && 0 <= k < 3 ==>
            -16386 <= VERTICES(s, mesh)[j].normal[k] <= 16386;
        loop assigns i, v, furthest;
        loop variant mesh->vertex_count - i; */
    for (uint32_t i = 0; i < mesh->vertex_count; i++, v++) {
        uint32_t distance = 0, length = 0; /* squares: each at most 2^30, so three fit */
        /*@ loop invariant 0 <= k <= 3 && distance <= k * 0x40000000 && length <= k * 0x40000000;
            loop invariant \forall integer j; 0 <= j < k ==> v->normal[j] * v->normal[j] <= length;
            loop assigns k, distance, length;
            loop variant 3 - k; */
        for (int k = 0; k < 3; k++) {
            distance += (uint32_t)(v->position[k] * v->position[k]);
            length += (uint32_t)(v->normal[k] * v->normal[k]);
        }
        if (distance > furthest)
            furthest = distance;
        if (!square_ok(length))
            return SCENE_E_RANGE;
    }
    /* root < 2^16 and extent < 2^30; rounded up, as a mesh may be a few steps of a radius large */
    return ((uint64_t)(fx_root(furthest) + 1) * (uint32_t)mesh->extent + 32767) >> 15 <= (uint32_t)mesh->radius
               ? SCENE_OK
               : SCENE_E_RANGE;
}

/* Shading's overflow bounds rest on bends that belong to their normals: within 2^-11 of (1 - Na.Nb) / 2, which is
 * several times what rounding normals to Q14 can do. */
static int bend_ok(const q14_t a[3], const q14_t b[3], uint16_t bend)
{
    int32_t dot = 0; /* normals are near unit length: at most 2^28 (1 + 2^-12) in size, each product at most 2^28 */
    /*@ loop invariant 0 <= k <= 3 && -k * 0x20000000 <= dot <= k * 0x20000000;
        loop assigns k, dot;
        loop variant 3 - k; */
    for (int k = 0; k < 3; k++)
        dot += a[k] * b[k];
    int32_t expected = ((1 << 28) - dot) >> 13;
    return expected - bend < 32 && bend - expected < 32;
}

static enum scene_fault check_tangents(const struct scene_header *s, const struct scene_mesh *mesh)
{
    const struct scene_tangent *t = scene_at(s, mesh->tangents);
    const struct scene_vertex *v = scene_at(s, mesh->vertices);
    /*@ loop invariant 0 <= i <= mesh->vertex_count;
        loop invariant mesh->tangents != 0 ==> v == VERTICES(s, mesh) + i && t == TANGENTS(s, mesh) + i;
        loop assigns i, t, v;
        loop variant mesh->vertex_count - i; */
    for (uint32_t i = 0; mesh->tangents && i < mesh->vertex_count; i++, t++, v++) {
        uint32_t length = 0; /* as in check_vertices() */
        int32_t across = 0;  /* of near unit vectors, once the other is known to be one */
        /*@ loop invariant 0 <= k <= 3 && length <= k * 0x40000000;
            loop invariant \forall integer j; 0 <= j < k ==> t->tangent[j] * t->tangent[j] <= length;
            loop assigns k, length;
            loop variant 3 - k; */
        for (int k = 0; k < 3; k++)
            length += (uint32_t)(t->tangent[k] * t->tangent[k]);
        if (!square_ok(length) || (t->sign != 1 && t->sign != -1))
            return SCENE_E_RANGE;
        /*@ loop invariant 0 <= k <= 3 && -k * 0x20000000 <= across <= k * 0x20000000;
            loop assigns k, across;
            loop variant 3 - k; */
        for (int k = 0; k < 3; k++)
            across += t->tangent[k] * v->normal[k];
        if (!in_range(across, -(1 << 17), (1 << 17) + 1)) /* 2^-11 in Q28 */
            return SCENE_E_RANGE;
    }
    return SCENE_OK;
}

/* A material that wants texture coordinates or tangents is on a mesh that has them. */
static bool mapped(const struct scene_mesh *mesh, const struct scene_material *m)
{
    return (m->texture == SCENE_NO_TEXTURE || mesh->uvs) &&
           (m->bump == SCENE_NO_TEXTURE || (mesh->uvs && mesh->tangents));
}

static enum scene_fault check_triangles(const struct scene_header *s, const struct scene_mesh *mesh)
{
    const struct scene_triangle *t = scene_at(s, mesh->triangles);
    const struct scene_vertex *v = scene_at(s, mesh->vertices);
    /*@ loop invariant 0 <= i <= mesh->triangle_count && t == TRIANGLES(s, mesh) + i;
        loop invariant CORNERS(s, mesh, i);
        loop invariant SURFACES(s, mesh, i);
        loop assigns i, t;
        loop variant mesh->triangle_count - i; */
    for (uint32_t i = 0; i < mesh->triangle_count; i++, t++) {
        if (t->flags >= 8 * TRIANGLE_QUADRATIC)
            return SCENE_E_RANGE;
        /*@ loop invariant 0 <= k <= 3 && \forall integer j; 0 <= j < k ==> t->corner[j] < mesh->vertex_count;
            loop assigns k;
            loop variant 3 - k; */
        for (int k = 0; k < 3; k++)
            if (t->corner[k] >= mesh->vertex_count)
                return SCENE_E_INDEX;
        //@ assert t->corner[0] < mesh->vertex_count;
        //@ assert t->corner[1] < mesh->vertex_count;
        //@ assert t->corner[2] < mesh->vertex_count;
        if (t->material >= s->material_count || !mapped(mesh, &scene_materials(s)[t->material]))
            return SCENE_E_INDEX;
        /*@ loop invariant 0 <= k <= 3;
            loop assigns k;
            loop variant 3 - k; */
        for (int k = 0; k < 3; k++)
            if (!bend_ok(v[t->corner[k]].normal, v[t->corner[k == 2 ? 0 : k + 1]].normal, t->bend[k]))
                return SCENE_E_RANGE;
    }
    return SCENE_OK;
}

static enum scene_fault check_mesh(const struct scene_header *s, const struct scene_mesh *mesh)
{
    if (mesh->vertex_count < 3 || mesh->vertex_count > SCENE_MAX_VERTICES || mesh->triangle_count < 1 ||
        mesh->triangle_count > SCENE_MAX_TRIANGLES || !position_ok(mesh->centre) ||
        !in_range(mesh->extent, 1 << 6, 1 << 30) || mesh->radius <= 0)
        return SCENE_E_RANGE;
    if (!array_ok(s, mesh->vertices, mesh->vertex_count, sizeof(struct scene_vertex)) ||
        !array_ok(s, mesh->triangles, mesh->triangle_count, sizeof(struct scene_triangle)) ||
        (mesh->uvs != 0 && !array_ok(s, mesh->uvs, mesh->vertex_count, 2 * sizeof(int16_t))) ||
        (mesh->tangents != 0 && !array_ok(s, mesh->tangents, mesh->vertex_count, sizeof(struct scene_tangent))))
        return SCENE_E_STRUCTURE;
    enum scene_fault fault = check_vertices(s, mesh);
    if (!fault && USES(USES_BUMP))
        fault = check_tangents(s, mesh);
    return fault ? fault : check_triangles(s, mesh);
}

static enum scene_fault check_power(const struct fx_power *p)
{
    bool ok = in_range(p->exponent, 1, FX_POWER_MAX_EXPONENT + 1) && p->octave <= FX_POWER_MAX_OCTAVE &&
              p->value[FX_POWER_STEPS] <= UNIT_Q15 && p->value[FX_POWER_STEPS + 1] == p->value[FX_POWER_STEPS];
    /*@ loop invariant 0 <= i <= FX_POWER_STEPS;
        loop assigns i, ok;
        loop variant FX_POWER_STEPS - i; */
    for (unsigned i = 0; ok && i < FX_POWER_STEPS; i++)
        ok = p->value[i] <= p->value[i + 1];
    return ok ? SCENE_OK : SCENE_E_RANGE;
}

static enum scene_fault check_material(const struct scene_header *s, const struct scene_material *m)
{
    if (!colour_ok(m->diffuse) || !colour_ok(m->specular) || m->ka > UNIT_Q15 || m->kd > UNIT_Q15 || m->ks > UNIT_Q15 ||
        (m->flags & ~(MATERIAL_FLAT | MATERIAL_TWO_SIDED)) != 0)
        return SCENE_E_RANGE;
    if (m->power >= s->power_count || (m->texture != SCENE_NO_TEXTURE && m->texture >= s->texture_count) ||
        (m->bump != SCENE_NO_TEXTURE && m->bump >= s->texture_count))
        return SCENE_E_INDEX;
    if ((m->texture != SCENE_NO_TEXTURE && scene_textures(s)[m->texture].format == TEXTURE_BUMP8) ||
        (m->bump != SCENE_NO_TEXTURE && scene_textures(s)[m->bump].format != TEXTURE_BUMP8))
        return SCENE_E_RANGE;
    return scene_powers(s)[m->power].exponent == m->shininess ? SCENE_OK : SCENE_E_RANGE;
}

static enum scene_fault check_texture(const struct scene_header *s, const struct scene_texture *t)
{
    if (t->log2_width > 10 || t->log2_height > 10 || t->format >= TEXTURE_FORMATS ||
        (t->flags & ~(TEXTURE_BILINEAR | TEXTURE_CLAMP_U | TEXTURE_CLAMP_V)) != 0 || t->reserved != 0 ||
        (t->format == TEXTURE_BUMP8) != (t->steepness > 0) || t->steepness > TEXTURE_UNIT ||
        (t->format == TEXTURE_PALETTE8) != (t->colours > 0) || t->colours > 256)
        return SCENE_E_RANGE;
    const uint32_t texels = 1u << (t->log2_width + t->log2_height);
    if (!array_ok(s, t->texels, texels, t->format == TEXTURE_PALETTE8 ? 1 : 2) ||
        !array_ok(s, t->palette, t->steepness ? TEXTURE_RISES / 2 : t->colours, sizeof(uint32_t)))
        return SCENE_E_STRUCTURE;
    const uint8_t *index = scene_at(s, t->texels);
    /*@ loop invariant 0 <= i <= TEXTURE_RISES;
        loop assigns i;
        loop variant TEXTURE_RISES - i; */
    for (uint32_t i = 0; t->steepness && i < TEXTURE_RISES; i++)
        if (((const uint16_t *)scene_at(s, t->palette))[i] != texel_rise(t->steepness, i))
            return SCENE_E_RANGE;
    /*@ loop invariant 0 <= i <= texels;
        loop assigns i;
        loop variant texels - i; */
    for (uint32_t i = 0; t->colours && t->colours < 256 && i < texels; i++)
        if (index[i] >= t->colours)
            return SCENE_E_INDEX;
    return t->contrast >= texel_contrast(s, t) ? SCENE_OK : SCENE_E_RANGE;
}

static enum scene_fault check_key(const struct scene_key *k)
{
    return unit_ok(k->rotation, 4) && position_ok(k->position) && in_range(k->scale, SCALE_MIN, SCALE_END)
               ? SCENE_OK
               : SCENE_E_RANGE;
}

static enum scene_fault check_motion(const struct scene_header *s, const struct scene_motion *m)
{
    if (m->kind > MOTION_KEYS || m->reserved != 0 || (m->kind == MOTION_KEYS) != (m->key_count > 0))
        return SCENE_E_RANGE;
    if (m->kind == MOTION_SPIN && (!unit_ok(m->axis, 3) || !in_range(m->rate, 1 - RATE_END, RATE_END)))
        return SCENE_E_RANGE;
    if (m->kind != MOTION_KEYS)
        return SCENE_OK;
    if (m->first_key >= s->key_count || m->key_count > s->key_count - m->first_key)
        return SCENE_E_INDEX;
    const struct scene_key *key = scene_keys(s) + m->first_key;
    /*@ loop invariant 1 <= i <= m->key_count;
        loop assigns i;
        loop variant m->key_count - i; */
    for (unsigned i = 1; i < m->key_count; i++)
        if (key[i - 1].time_ms >= key[i].time_ms)
            return SCENE_E_RANGE;
    return SCENE_OK;
}

static enum scene_fault check_object(const struct scene_header *s, const struct scene_object *o)
{
    if (o->mesh >= s->mesh_count)
        return SCENE_E_INDEX;
    if (o->flags != 0 || !unit_ok(o->rotation, 4) || !position_ok(o->position) ||
        !in_range(o->scale, SCALE_MIN, SCALE_END))
        return SCENE_E_RANGE;
    return check_motion(s, &o->motion);
}

static enum scene_fault check_light(const struct scene_header *s, const struct scene_light *l)
{
    if (l->kind > LIGHT_POINT || l->flags != 0 || l->reserved != 0 || !colour_ok(l->colour))
        return SCENE_E_RANGE;
    if (!(l->kind == LIGHT_POINT ? position_ok(l->vector) : unit_ok(l->vector, 3)))
        return SCENE_E_RANGE;
    return check_motion(s, &l->motion);
}

enum scene_fault scene_check(const void *blob, size_t size)
{
    const struct scene_header *s = blob;
    enum scene_fault fault = check_header(s, size);
    if (!fault)
        fault = check_camera(s);
    if (!fault)
        fault = check_fog(&s->fog);
    /*@ loop invariant fault == SCENE_OK ==> GOOD(s) && i <= s->texture_count;
        loop assigns i, fault;
        loop variant s->texture_count - i; */
    for (unsigned i = 0; USES(USES_TEXTURE | USES_BUMP) && !fault && i < s->texture_count; i++)
        fault = check_texture(s, &scene_textures(s)[i]);
    /*@ loop invariant fault == SCENE_OK ==> GOOD(s) && i <= s->mesh_count;
        loop invariant fault == SCENE_OK ==> MESHES(s, i);
        loop assigns i, fault;
        loop variant s->mesh_count - i; */
    for (unsigned i = 0; !fault && i < s->mesh_count; i++)
        fault = check_mesh(s, &scene_meshes(s)[i]);
    /*@ loop invariant fault == SCENE_OK ==> GOOD(s) && i <= s->power_count;
        loop invariant fault == SCENE_OK ==> MESHES(s, s->mesh_count);
        loop assigns i, fault;
        loop variant s->power_count - i; */
    for (unsigned i = 0; !fault && i < s->power_count; i++)
        fault = check_power(&scene_powers(s)[i]);
    /*@ loop invariant fault == SCENE_OK ==> GOOD(s) && i <= s->material_count;
        loop invariant fault == SCENE_OK ==> MESHES(s, s->mesh_count) && MATERIALS(s, i);
        loop assigns i, fault;
        loop variant s->material_count - i; */
    for (unsigned i = 0; !fault && i < s->material_count; i++)
        fault = check_material(s, &scene_materials(s)[i]);
    /*@ loop invariant fault == SCENE_OK ==> GOOD(s) && i <= s->key_count;
        loop invariant fault == SCENE_OK ==> MESHES(s, s->mesh_count) && MATERIALS(s, s->material_count);
        loop assigns i, fault;
        loop variant s->key_count - i; */
    for (unsigned i = 0; !fault && i < s->key_count; i++)
        fault = check_key(&scene_keys(s)[i]);
    /*@ loop invariant fault == SCENE_OK ==> GOOD(s) && i <= s->object_count;
        loop invariant fault == SCENE_OK ==> MESHES(s, s->mesh_count) && MATERIALS(s, s->material_count);
        loop invariant fault == SCENE_OK ==> OBJECTS(s, i);
        loop assigns i, fault;
        loop variant s->object_count - i; */
    for (unsigned i = 0; !fault && i < s->object_count; i++)
        fault = check_object(s, &scene_objects(s)[i]);
    /*@ loop invariant fault == SCENE_OK ==> GOOD(s) && i <= s->light_count;
        loop invariant fault == SCENE_OK ==> MESHES(s, s->mesh_count) && MATERIALS(s, s->material_count);
        loop invariant fault == SCENE_OK ==> OBJECTS(s, s->object_count) && LIGHTS(s, i);
        loop assigns i, fault;
        loop variant s->light_count - i; */
    for (unsigned i = 0; !fault && i < s->light_count; i++)
        fault = check_light(s, &scene_lights(s)[i]);
    if (!fault && ((s->effects & ~USES_EFFECTS) != 0 || (scene_effects(s) & ~s->effects) != 0))
        fault = SCENE_E_RANGE;
    if (!fault && (s->effects & ~GLINT_USES) != 0)
        fault = SCENE_E_USES;
    return fault;
}
