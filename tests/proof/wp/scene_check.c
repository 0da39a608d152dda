/* SPDX-License-Identifier: MIT */
/*
 * What scene_check() promises, for a blob of any bytes and any length: it reads nothing outside the bytes that it is
 * given, and after 0 every array that the header and the meshes name lies in them, where it may be read as what it is.
 * That bytes can be read as structs that begin at a multiple of 4 is assumed (READS); all else is proven, function by
 * function, but for the goals in scene_check.open.
 */
#include "scene/scene_effects.h"
#include "scene/texel.h"
#include <stdbool.h>
#define AT(type, s, offset) ((const struct type *)((const uint8_t *)(s) + (offset)))
#define VERTICES(s, m)      AT(scene_vertex, s, (m)->vertices)
#define TRIANGLES(s, m)     AT(scene_triangle, s, (m)->triangles)
#define TANGENTS(s, m)      AT(scene_tangent, s, (m)->tangents)

/* Formatting would take ==> apart. */
/* clang-format off */
/* How many bytes of a blob can be read, as any array that begins at a multiple of 4. */
/*@ axiomatic blob { logic integer bytes_of(struct scene_header *s) reads \nothing; } */
#define READS(type, s) \
    (\forall integer at, i; 0 <= at && 0 <= i && at % 4 == 0 && at + (i + 1) * sizeof(type) <= bytes_of(s) ==> \
        \valid_read((const type *)((const uint8_t *)(s) + at) + i))
#define INSIDE(s, offset, count, size) \
    ((count) == 0 ||                   \
     ((offset) % 4 == 0 && sizeof(struct scene_header) <= (offset) && (offset) + (count) * (size) <= bytes_of(s)))
#define HEADER(s) (\valid_read(s) && (s)->length <= bytes_of(s))
#define GOOD(s)   (HEADER(s) && (ARRAYS(s)))
#define ARRAYS(s)                                                                     \
    (INSIDE(s, (s)->meshes, (s)->mesh_count, sizeof(struct scene_mesh)) &&            \
     INSIDE(s, (s)->materials, (s)->material_count, sizeof(struct scene_material)) && \
     INSIDE(s, (s)->powers, (s)->power_count, sizeof(struct fx_power)) &&             \
     INSIDE(s, (s)->lights, (s)->light_count, sizeof(struct scene_light)) &&          \
     INSIDE(s, (s)->objects, (s)->object_count, sizeof(struct scene_object)) &&       \
     INSIDE(s, (s)->keys, (s)->key_count, sizeof(struct scene_key)) &&                \
     INSIDE(s, (s)->textures, (s)->texture_count, sizeof(struct scene_texture)))
#define MESH_ARRAYS(s, m)                                                             \
    (3 <= (m)->vertex_count <= 65535 && 1 <= (m)->triangle_count <= 65535 &&          \
     INSIDE(s, (m)->vertices, (m)->vertex_count, sizeof(struct scene_vertex)) &&      \
     INSIDE(s, (m)->triangles, (m)->triangle_count, sizeof(struct scene_triangle)) && \
     ((m)->uvs == 0 || INSIDE(s, (m)->uvs, (m)->vertex_count, 4)) &&                  \
     ((m)->tangents == 0 || INSIDE(s, (m)->tangents, (m)->vertex_count, sizeof(struct scene_tangent))))
#define NORMALS(s, m) \
    (\forall integer j, k; 0 <= j < (m)->vertex_count && 0 <= k < 3 ==> -16386 <= VERTICES(s, m)[j].normal[k] <= 16386)
/* Indices: the first n triangles' corners and materials; all of the first n meshes, materials, objects, lights. */
#define CORNERS(s, m, n)                                                            \
    (\forall integer j; 0 <= j < (n) ==>                                            \
        TRIANGLES(s, m)[j].corner[0] < (m)->vertex_count &&                         \
        TRIANGLES(s, m)[j].corner[1] < (m)->vertex_count &&                         \
        TRIANGLES(s, m)[j].corner[2] < (m)->vertex_count)
#define SURFACES(s, m, n) (\forall integer j; 0 <= j < (n) ==> TRIANGLES(s, m)[j].material < (s)->material_count)
#define MESH(s, m) \
    (MESH_ARRAYS(s, m) && CORNERS(s, m, (m)->triangle_count) && SURFACES(s, m, (m)->triangle_count))
#define MATERIAL(s, m)                                                              \
    ((m)->power < (s)->power_count &&                                               \
     ((m)->texture == SCENE_NO_TEXTURE || (m)->texture < (s)->texture_count) &&     \
     ((m)->bump == SCENE_NO_TEXTURE || (m)->bump < (s)->texture_count))
#define MOTION(s, m) ((m)->kind == MOTION_KEYS ==> 1 <= (m)->key_count && (m)->first_key + (m)->key_count <= (s)->key_count)
#define OBJECT(s, o) ((o)->mesh < (s)->mesh_count && (MOTION(s, &(o)->motion)))
/*@ predicate mesh_ok(struct scene_header *s, struct scene_mesh *m) = MESH(s, m);
    predicate material_ok(struct scene_header *s, struct scene_material *m) = MATERIAL(s, m);
    predicate object_ok(struct scene_header *s, struct scene_object *o) = OBJECT(s, o);
    predicate motion_ok(struct scene_header *s, struct scene_motion *m) = MOTION(s, m); */
#define MESHES(s, n)    (\forall integer a; 0 <= a < (n) ==> mesh_ok(s, AT(scene_mesh, s, (s)->meshes) + a))
#define MATERIALS(s, n) (\forall integer a; 0 <= a < (n) ==> material_ok(s, AT(scene_material, s, (s)->materials) + a))
#define OBJECTS(s, n)   (\forall integer a; 0 <= a < (n) ==> object_ok(s, AT(scene_object, s, (s)->objects) + a))
#define LIGHTS(s, n) \
    (\forall integer a; 0 <= a < (n) ==> motion_ok(s, &(AT(scene_light, s, (s)->lights) + a)->motion))
/* clang-format on */
#define TEXELS(t) (1 << ((t)->log2_width + (t)->log2_height))
/*@ requires \valid_read((const uint8_t *)bytes + (0 .. size - 1));
    assigns \nothing; */
uint32_t scene_crc32(uint32_t crc, const void *bytes, size_t size);

/*@ assigns \nothing;
    ensures \result <= 65535 && \result * \result <= x < (\result + 1) * (\result + 1); */
uint32_t fx_root(uint32_t x);

/*@ assigns \nothing;
    ensures \result == (const void *)((const uint8_t *)scene + offset); */
static inline const void *scene_at(const struct scene_header *scene, uint32_t offset);

/*@ requires \valid_read(s);
    assigns \nothing;
    ensures \result == AT(scene_mesh, s, s->meshes); */
static inline const struct scene_mesh *scene_meshes(const struct scene_header *s);
/*@ requires \valid_read(s);
    assigns \nothing;
    ensures \result == AT(scene_material, s, s->materials); */
static inline const struct scene_material *scene_materials(const struct scene_header *s);
/*@ requires \valid_read(s);
    assigns \nothing;
    ensures \result == AT(scene_light, s, s->lights); */
static inline const struct scene_light *scene_lights(const struct scene_header *s);
/*@ requires \valid_read(s);
    assigns \nothing;
    ensures \result == AT(scene_object, s, s->objects); */
static inline const struct scene_object *scene_objects(const struct scene_header *s);
/*@ requires \valid_read(s);
    assigns \nothing;
    ensures \result == AT(scene_key, s, s->keys); */
static inline const struct scene_key *scene_keys(const struct scene_header *s);
/*@ requires \valid_read(s);
    assigns \nothing;
    ensures \result == AT(scene_texture, s, s->textures); */
static inline const struct scene_texture *scene_textures(const struct scene_header *s);
/*@ requires \valid_read(s);
    assigns \nothing;
    ensures \result == AT(fx_power, s, s->powers); */
static inline const struct fx_power *scene_powers(const struct scene_header *s);

/*@ assigns \nothing;
    ensures \result <==> first <= value < end; */
static bool in_range(int32_t value, int32_t first, int32_t end);

/*@ requires \valid_read(p + (0 .. 2));
    assigns \nothing;
    ensures \result <==> \forall integer k; 0 <= k < 3 ==> -0x40000000 < p[k] < 0x40000000; */
static bool position_ok(const q16_t p[3]);

/*@ requires \valid_read(c + (0 .. 2));
    assigns \nothing; */
static bool colour_ok(const uint16_t c[3]);

/*@ requires 1 <= components <= 4 && \valid_read(v + (0 .. components - 1));
    assigns \nothing; */
static bool unit_ok(const q30_t *v, unsigned components);

/*@ requires HEADER(s) && 1 <= element <= 264 && (count <= 65535 || (count <= 0x100000 && element <= 2));
    assigns \nothing;
    ensures \result ==> INSIDE(s, offset, count, element) && (count == 0 ==> offset == 0); */
static bool array_ok(const struct scene_header *s, uint32_t offset, uint32_t count, uint32_t element);

/*@ requires (size >= sizeof(struct scene_header) ==> \valid_read(s)) && READS(uint8_t, s);
    requires size == bytes_of(s) && \valid_read((const uint8_t *)s + (0 .. size - 1));
    assigns \nothing;
    ensures \result == SCENE_OK ==> GOOD(s);
    ensures \result == SCENE_OK ==> s->object_count <= 255 && s->light_count <= 8; */
static enum scene_fault check_header(const struct scene_header *s, size_t size);

/*@ requires \valid_read(s);
    assigns \nothing; */
static enum scene_fault check_camera(const struct scene_header *s);

/*@ requires \valid_read(f);
    assigns \nothing; */
static enum scene_fault check_fog(const struct scene_fog *f);

/*@ assigns \nothing;
    ensures \result ==> square <= 0x10010004; */
static bool square_ok(uint32_t square);

/*@ requires READS(struct scene_vertex, s);
    requires HEADER(s) && \valid_read(mesh) && MESH_ARRAYS(s, mesh);
    assigns \nothing;
    ensures \result == SCENE_OK ==> NORMALS(s, mesh); */
static enum scene_fault check_vertices(const struct scene_header *s, const struct scene_mesh *mesh);

/*@ requires \valid_read(a + (0 .. 2)) && \valid_read(b + (0 .. 2));
    requires \forall integer k; 0 <= k < 3 ==> -16386 <= a[k] <= 16386 && -16386 <= b[k] <= 16386;
    assigns \nothing; */
static int bend_ok(const q14_t a[3], const q14_t b[3], uint16_t bend);

/*@ requires READS(struct scene_vertex, s) && READS(struct scene_tangent, s);
    requires HEADER(s) && \valid_read(mesh) && MESH_ARRAYS(s, mesh) && NORMALS(s, mesh);
    assigns \nothing; */
static enum scene_fault check_tangents(const struct scene_header *s, const struct scene_mesh *mesh);

/*@ requires \valid_read(mesh) && \valid_read(m);
    assigns \nothing;
    ensures \result ==> (m->texture != SCENE_NO_TEXTURE ==> mesh->uvs != 0) &&
                        (m->bump != SCENE_NO_TEXTURE ==> mesh->uvs != 0 && mesh->tangents != 0); */
static bool mapped(const struct scene_mesh *mesh, const struct scene_material *m);

/*@ requires READS(struct scene_vertex, s) && READS(struct scene_triangle, s) && READS(struct scene_material, s);
    requires GOOD(s) && \valid_read(mesh) && MESH_ARRAYS(s, mesh) && NORMALS(s, mesh);
    assigns \nothing;
    ensures \result == SCENE_OK ==> CORNERS(s, mesh, mesh->triangle_count);
    ensures \result == SCENE_OK ==> SURFACES(s, mesh, mesh->triangle_count); */
static enum scene_fault check_triangles(const struct scene_header *s, const struct scene_mesh *mesh);

/*@ requires READS(struct scene_vertex, s) && READS(struct scene_triangle, s) &&
        READS(struct scene_material, s) && READS(struct scene_tangent, s);
    requires GOOD(s) && \valid_read(mesh);
    assigns \nothing;
    ensures \result == SCENE_OK ==> mesh_ok(s, mesh); */
static enum scene_fault check_mesh(const struct scene_header *s, const struct scene_mesh *mesh);

/*@ requires \valid_read(p);
    assigns \nothing; */
static enum scene_fault check_power(const struct fx_power *p);

/*@ requires READS(struct scene_texture, s) && READS(struct fx_power, s);
    requires GOOD(s) && \valid_read(m);
    assigns \nothing;
    ensures \result == SCENE_OK ==> material_ok(s, m); */
static enum scene_fault check_material(const struct scene_header *s, const struct scene_material *m);

/*@ requires READS(uint8_t, s) && READS(uint16_t, s) && READS(uint32_t, s);
    requires HEADER(s) && \valid_read(t) && t->log2_width <= 10 && t->log2_height <= 10;
    requires INSIDE(s, t->texels, TEXELS(t), t->format == TEXTURE_PALETTE8 ? 1 : 2);
    requires t->format == TEXTURE_PALETTE8 ==> 1 <= t->colours <= 256 && INSIDE(s, t->palette, t->colours, 4);
    requires t->format == TEXTURE_PALETTE8 && t->colours < 256 ==>
        \forall integer i; 0 <= i < TEXELS(t) ==> ((const uint8_t *)s)[t->texels + i] < t->colours;
    assigns \nothing; */
uint16_t texel_contrast(const struct scene_header *s, const struct scene_texture *t);

/*@ requires i < TEXTURE_RISES && steepness <= TEXTURE_UNIT;
    assigns \nothing; */
uint16_t texel_rise(uint16_t steepness, uint32_t i);

/*@ requires READS(uint8_t, s) && READS(uint16_t, s) && READS(uint32_t, s);
    requires GOOD(s) && \valid_read(t);
    assigns \nothing; */
static enum scene_fault check_texture(const struct scene_header *s, const struct scene_texture *t);

/*@ requires \valid_read(k);
    assigns \nothing; */
static enum scene_fault check_key(const struct scene_key *k);

/*@ requires READS(struct scene_key, s);
    requires GOOD(s) && \valid_read(m);
    assigns \nothing;
    ensures \result == SCENE_OK ==> motion_ok(s, m); */
static enum scene_fault check_motion(const struct scene_header *s, const struct scene_motion *m);

/*@ requires READS(struct scene_key, s);
    requires GOOD(s) && \valid_read(o);
    assigns \nothing;
    ensures \result == SCENE_OK ==> object_ok(s, o); */
static enum scene_fault check_object(const struct scene_header *s, const struct scene_object *o);

/*@ requires READS(struct scene_key, s);
    requires GOOD(s) && \valid_read(l);
    assigns \nothing;
    ensures \result == SCENE_OK ==> motion_ok(s, &l->motion); */
static enum scene_fault check_light(const struct scene_header *s, const struct scene_light *l);

/*@ requires READS(struct scene_material, s) && READS(struct scene_light, s) && READS(struct scene_object, s);
    requires GOOD(s);
    assigns \nothing; */
uint32_t scene_effects(const struct scene_header *s);

/*@ requires size >= sizeof(struct scene_header) ==> \valid_read((const struct scene_header *)blob);
    requires \valid_read((const uint8_t *)blob + (0 .. size - 1));
    requires size == bytes_of((struct scene_header *)blob) && READS(uint8_t, (struct scene_header *)blob) &&
        READS(uint16_t, (struct scene_header *)blob) && READS(uint32_t, (struct scene_header *)blob) &&
        READS(struct scene_mesh, (struct scene_header *)blob) &&
        READS(struct scene_vertex, (struct scene_header *)blob) &&
        READS(struct scene_triangle, (struct scene_header *)blob) &&
        READS(struct scene_tangent, (struct scene_header *)blob) &&
        READS(struct scene_material, (struct scene_header *)blob) &&
        READS(struct scene_texture, (struct scene_header *)blob) &&
        READS(struct fx_power, (struct scene_header *)blob) &&
        READS(struct scene_key, (struct scene_header *)blob) &&
        READS(struct scene_object, (struct scene_header *)blob) &&
        READS(struct scene_light, (struct scene_header *)blob);
    assigns \nothing;
    ensures \result == SCENE_OK ==> GOOD((struct scene_header *)blob);
    ensures \result == SCENE_OK ==> MESHES((struct scene_header *)blob, ((struct scene_header *)blob)->mesh_count);
    ensures \result == SCENE_OK ==>
        MATERIALS((struct scene_header *)blob, ((struct scene_header *)blob)->material_count);
    ensures \result == SCENE_OK ==> OBJECTS((struct scene_header *)blob, ((struct scene_header *)blob)->object_count);
    ensures \result == SCENE_OK ==> LIGHTS((struct scene_header *)blob, ((struct scene_header *)blob)->light_count); */
enum scene_fault scene_check(const void *blob, size_t size);

#include "firmware/scene/scene_check.c"
