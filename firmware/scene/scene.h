/* SPDX-License-Identifier: MIT */
/*
 * The scene as it lies in flash: one blob, no pointers. Every reference is a byte offset from the start of the
 * header, a multiple of 4; integers are stored in the byte order of the machine that draws (little-endian from
 * `glint pack`). scene_check() looks at every byte of structure once; after it, no reader checks again.
 *
 * Axes: right-handed, y up, the eye looks down -z. Lengths are in scene units, Q16 unless said otherwise; a bound on
 * a vector, as |p| < 2^14, is one on each of its components.
 */
#ifndef GLINT_SCENE_H
#define GLINT_SCENE_H

#include "fixed/fixed.h"
#include "uses.h"

#include <stddef.h>

#define SCENE_MAGIC   0x31544C47u /* "GLT1" */
#define SCENE_VERSION 2u

/* The most of each that the renderer addresses: 16-bit indices, and light sets that stay in 8 bits. */
#define SCENE_MAX_VERTICES  65535u
#define SCENE_MAX_TRIANGLES 65535u
#define SCENE_MAX_OBJECTS   255u
#define SCENE_MAX_LIGHTS    8u

/* One vertex of a mesh: position in 1/32768 of the mesh's extent from its centre; unit normal in Q14, its length
 * within 2^-13 of 1. */
struct scene_vertex {
    int16_t position[3];
    q14_t normal[3];
};

/* The way in which u grows, Q14: unit as a normal is, and perpendicular to it within 2^-11. v grows along B = sign (N x
 * T). */
struct scene_tangent {
    q14_t tangent[3];
    int16_t sign; /* 1 or -1 */
};

/* Bit e of a triangle's flags: where normals are interpolated quadratically, its edge from corner e to (e + 1) % 3 may
 * be. */
#define TRIANGLE_QUADRATIC 1u

/* Counter-clockwise seen from outside. bend[e] = -k = (1 - Ni.Nj)/2 in Q16 of the edge from corner e to corner
 * (e + 1) % 3, within 2^-11 of what the stored normals give, saturated at 65535 (X-shading, eq. 32; k itself is never
 * positive). */
struct scene_triangle {
    uint16_t corner[3];
    uint16_t bend[3];
    uint16_t material;
    uint16_t flags; /* TRIANGLE_QUADRATIC << e, 0..7 */
};

struct scene_mesh {
    uint32_t vertices;       /* offset of struct scene_vertex[vertex_count] */
    uint32_t triangles;      /* offset of struct scene_triangle[triangle_count] */
    uint32_t uvs;            /* offset of int16_t[vertex_count][2], Q12 texture coordinates; 0: none */
    uint32_t tangents;       /* offset of struct scene_tangent[vertex_count]; 0: none */
    uint32_t vertex_count;   /* 3..65535 */
    uint32_t triangle_count; /* 1..65535 */
    q16_t centre[3];         /* |c| < 2^14 units */
    q16_t extent;            /* a position component of 32768 is this long; 2^-10 <= extent < 2^14 units */
    q16_t radius; /* of a sphere about the centre that holds all vertices and a position unit more; 0 < radius < 2^15
                     units */
};

#define MATERIAL_FLAT      1u /* its vertices carry face normals: one value a directional light, by every method */
#define MATERIAL_TWO_SIDED 2u /* faces are seen from behind too, with their normals turned round */

#define SCENE_NO_TEXTURE 0xffffu

/* Colour at a pixel = texel * diffuse * (ka * ambient + sum kd * light * max(0, N.L))
 *                   + specular * sum ks * light * max(0, N.H)^shininess; each channel clamped to 0..1 at the end, then
 * mixed with the fog's. Colours and coefficients in Q15, 0..32768. */
struct scene_material {
    uint16_t diffuse[3];
    uint16_t specular[3];
    uint16_t ka, kd, ks;
    uint16_t shininess; /* 1..1023 */
    uint16_t power;     /* index of its struct fx_power, whose exponent is the shininess */
    uint16_t flags;
    uint16_t texture, bump; /* index of one of colours, and of one of slopes, or SCENE_NO_TEXTURE. Meshes that use it
                               have texture coordinates, and for a bump map tangents */
};

enum scene_texture_format {
    TEXTURE_RGB565,   /* uint16_t texels */
    TEXTURE_PALETTE8, /* uint8_t indices into the palette, each less than `colours` */
    TEXTURE_BUMP8,    /* int8_t x, y of the normal N', 128 for `steepness`; its z is a matter of x^2 + y^2 */
    TEXTURE_FORMATS
};

#define TEXTURE_BILINEAR 1u /* interpolated between the middles of texels, else the nearest */
#define TEXTURE_CLAMP_U  2u /* beyond 0..1 its border goes on, else it repeats */
#define TEXTURE_CLAMP_V  4u
/* Coordinates are interpolated modulo 16 turns: of a mesh with a clamped texture they are within +-this, so that
 * neither roundings nor a quadratic's overshoot (1/8 of the span) come round to the other border. */
#define SCENE_MOST_CLAMPED 6

/*
 * 2^log2_width columns from u = 0 to 1 in 2^log2_height rows from v = 0 to 1, the row at v = 0 first. A field of 565
 * stands for its value / 31 or 63 of full intensity, one of a palette for / 255.
 */
struct scene_texture {
    uint32_t texels;                 /* offset */
    uint32_t palette;                /* offset of uint32_t[colours], 0x00RRGGBB; of TEXTURE_BUMP8 of uint16_t
                                        [TEXTURE_RISES]: z in Q14, entry i of x^2 + y^2 from 128 i on (texel_rise()); else
                                        0 */
    uint8_t log2_width, log2_height; /* 0..10 */
    uint8_t format;                  /* enum scene_texture_format */
    uint8_t flags;
    uint16_t contrast;  /* a bound of the difference of texels next to each other in any channel, in 1/255 (of a
                           normal: texel units), Q8: what an error of a texel costs at most */
    uint16_t steepness; /* of TEXTURE_BUMP8: what 128 stands for, Q14, 1..TEXTURE_UNIT; else 0 */
    uint16_t colours;   /* of the palette, 1..256; without one 0 */
    uint16_t reserved;  /* 0 */
};

#define TEXTURE_UNIT  (1u << 14)
#define TEXTURE_RISES 258u /* 128^2 + 128^2 is in entry 256; an even count */

enum scene_fog_kind { FOG_NONE, FOG_LINEAR, FOG_EXPONENTIAL };

/* By the distance z along the view: a pixel's colour is mixed with the fog's, whose part is (z - from) / (to - from)
 * within 0..1, or 1 - e^(-density z). What is not of its kind is 0. */
struct scene_fog {
    uint16_t kind;
    uint16_t colour[3]; /* Q15 */
    q16_t from, to;     /* 0 <= from < to < 2^15 units */
    uint32_t density;   /* Q24 a unit, 1..2^28 */
};

enum scene_motion_kind { MOTION_NONE, MOTION_SPIN, MOTION_KEYS };

/* How a thing moves. Spin: turned about `axis` through its own origin by rate * time, before its own rotation (a
 * light: about the world's origin). Keys: rotation, position and scale interpolated between keys, the first held
 * before and the last after; keys are sorted by time, all different. */
struct scene_motion {
    uint16_t kind;
    uint16_t first_key;
    uint16_t key_count; /* at least 1 for MOTION_KEYS, else 0 */
    uint16_t reserved;  /* 0 */
    q30_t axis[3];      /* unit, for MOTION_SPIN */
    q16_t rate;         /* turns a second, |rate| < 2^8 */
};

/* A rotation is the unit quaternion (w, x, y, z) in Q30, its length within 2^-20 of 1. */
struct scene_key {
    uint32_t time_ms;
    q30_t rotation[4];
    q16_t position[3]; /* |p| < 2^14 units */
    q16_t scale;       /* 2^-8 <= scale < 2^8 */
};

struct scene_object {
    uint16_t mesh;
    uint16_t flags; /* 0 */
    q30_t rotation[4];
    q16_t position[3];
    q16_t scale; /* uniform; see scene_key for the ranges */
    struct scene_motion motion;
};

enum scene_light_kind { LIGHT_DIRECTIONAL, LIGHT_POINT };

struct scene_light {
    uint16_t kind;
    uint16_t flags;    /* 0 */
    int32_t vector[3]; /* directional: unit vector towards the light, Q30; point: position, Q16, |p| < 2^14 units */
    uint16_t colour[3];
    uint16_t reserved; /* 0 */
    struct scene_motion motion;
};

enum scene_camera_kind { CAMERA_PERSPECTIVE, CAMERA_ORTHOGRAPHIC };
enum scene_viewer_kind { VIEWER_INFINITE, VIEWER_LOCAL };

/* Perspective: pixel = (w/2 + f x / -z, h/2 - f y / -z); orthographic: (w/2 + f x, h/2 - f y), f in pixels (a unit) on
 * a picture of reference_width x reference_height. Another size w x h scales f by min(w / reference_width,
 * h / reference_height). Visible is near <= -z <= far. */
struct scene_camera {
    uint16_t kind;
    uint16_t viewer;                            /* for the highlight: the eye at infinity along +z, or where it is */
    q30_t rotation[4];                          /* turns world axes into eye axes */
    q16_t position[3];                          /* of the eye in the world */
    q16_t focal;                                /* 2^-4 <= focal < 2^14 */
    uint16_t reference_width, reference_height; /* 1..2048 */
    q16_t near_plane, far_plane;                /* 2^-8 <= near < far < 2^15 units */
};

struct scene_header {
    uint32_t magic;
    uint16_t version;
    uint16_t reserved; /* 0 */
    uint32_t length;   /* of the whole blob, bytes */
    uint32_t crc;      /* CRC-32 (IEEE 802.3) of bytes 16 .. length - 1 */
    uint32_t meshes, materials, powers, lights, objects, keys, textures; /* offsets of the arrays; 0 for an empty one */
    uint16_t mesh_count, material_count, power_count, light_count, object_count, key_count, texture_count;
    uint16_t reserved2;     /* 0 */
    uint32_t effects;       /* of uses.h: at least those of scene_effects.h */
    uint32_t duration_ms;   /* of one loop of the animation; 0: none. Time given to the renderer is taken modulo this */
    uint16_t ambient[3];    /* Q15 */
    uint16_t background[3]; /* Q15 */
    struct scene_fog fog;
    struct scene_camera camera;
};

enum scene_fault {
    SCENE_OK = 0,
    SCENE_E_ALIGN = -1,     /* the blob does not start at a multiple of 4 */
    SCENE_E_SHORT = -2,     /* shorter than its header or than the length it gives */
    SCENE_E_MAGIC = -3,     /* not a scene, or one of the other byte order */
    SCENE_E_VERSION = -4,   /* a scene of another version */
    SCENE_E_CRC = -5,       /* damaged */
    SCENE_E_STRUCTURE = -6, /* an array outside the blob, overlapping the header, misaligned or too long */
    SCENE_E_INDEX = -7,     /* a reference to something that is not there */
    SCENE_E_RANGE = -8,     /* a value outside the range given above */
    SCENE_E_USES = -9,      /* a good scene, but it needs what this program was compiled without (uses.h) */
};

/* Checks all of the blob: 0, or what is wrong. `size` may exceed the blob's own length (flash behind it). Reads
 * nothing outside blob[0..size). */
enum scene_fault scene_check(const void *blob, size_t size);

/* One short English sentence for a fault, for messages. */
const char *scene_fault_text(enum scene_fault fault);

/* CRC-32 (IEEE 802.3, reflected, as zlib's) of `size` bytes, continuing from `crc` (0 to begin). */
uint32_t scene_crc32(uint32_t crc, const void *bytes, size_t size);

/* The arrays of a checked scene. */
static inline const void *scene_at(const struct scene_header *scene, uint32_t offset)
{
    return (const uint8_t *)scene + offset;
}
static inline const struct scene_mesh *scene_meshes(const struct scene_header *s)
{
    return scene_at(s, s->meshes);
}
static inline const struct scene_material *scene_materials(const struct scene_header *s)
{
    return scene_at(s, s->materials);
}
static inline const struct fx_power *scene_powers(const struct scene_header *s)
{
    return scene_at(s, s->powers);
}
static inline const struct scene_light *scene_lights(const struct scene_header *s)
{
    return scene_at(s, s->lights);
}
static inline const struct scene_object *scene_objects(const struct scene_header *s)
{
    return scene_at(s, s->objects);
}
static inline const struct scene_key *scene_keys(const struct scene_header *s)
{
    return scene_at(s, s->keys);
}
static inline const struct scene_texture *scene_textures(const struct scene_header *s)
{
    return scene_at(s, s->textures);
}

#endif
