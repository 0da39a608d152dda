/* SPDX-License-Identifier: MIT */
/* What packing did to each mesh, and where a blob's bytes go. */
#ifndef PACK_REPORT_H
#define PACK_REPORT_H

#include "pack/pack.h"
#include "scene/model.h"

struct pack_mesh_report {
    char *name;
    size_t vertices_in, triangles_in;
    size_t vertices_out, triangles_out; /* sums over its parts */
    size_t degenerate;                  /* triangles without area on the grid, dropped */
    size_t repaired;                    /* corners without a normal, given their face's */
    unsigned parts;                     /* meshes of the blob: more than 1 beyond 65535 vertices or triangles */
    enum model_normals normals;
    bool uvs_dropped;      /* they span more than Q12 holds */
    double position_error; /* largest, scene units */
    double normal_error;   /* largest, degrees */
};

struct pack_texture_report {
    char *name;
    unsigned read[2], size[2]; /* columns and rows, as read and as packed */
    unsigned colours_read;     /* of a palette: before they were brought down to 256 */
    bool normals;              /* a bump map */
    double error;              /* root mean square of what rounding colours or normals did, 1/255 */
};

struct pack_report {
    struct pack_mesh_report *meshes; /* one for each mesh and material override that an object uses */
    size_t mesh_count;
    unsigned unused_meshes;
    struct pack_texture_report *textures; /* one for each that a material uses */
    size_t texture_count;
};

/* What packing did, and the blob's bytes. */
void report_print(FILE *out, const struct pack_result *result);

enum {
    REPORT_HEADER,
    REPORT_MESHES,
    REPORT_VERTICES,
    REPORT_TRIANGLES,
    REPORT_UVS,
    REPORT_TANGENTS,
    REPORT_MATERIALS,
    REPORT_POWERS,
    REPORT_LIGHTS,
    REPORT_OBJECTS,
    REPORT_KEYS,
    REPORT_TEXTURES,
    REPORT_PARTS
};
extern const char *const report_parts[REPORT_PARTS];

struct report_totals {
    size_t bytes[REPORT_PARTS];
    unsigned long vertices, triangles; /* of all objects: what a frame goes through */
};

struct report_totals report_count(const struct scene_header *scene);
/* What the scene can need of the renderer (firmware/uses.h): effects, and the methods that may be of use. */
void report_print_effects(FILE *out, const struct scene_header *scene);
void report_print_bytes(FILE *out, const struct scene_header *scene);

/* The largest angle between two vertex normals of a triangle, in degrees. */
double report_bend_degrees(const struct scene_header *scene, const struct scene_mesh *mesh);

#endif
