/* SPDX-License-Identifier: MIT */
/*
 * A scene in double precision, as read from files and before it is rounded into a blob. Names and meanings are those
 * of firmware/scene/scene.h; lengths in scene units, angles in radians, colours and coefficients 0..1.
 *
 * A struct model owns all it points to; model_free() releases it. Growing functions end the program with a message
 * when memory runs out: a host tool has nothing better to do.
 */
#ifndef MODEL_H
#define MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct model_vertex {
    double position[3];
    double normal[3]; /* need not be unit; zero when there is none */
    double uv[2];
    double tangent[3]; /* along growing u; zero: none given */
    double sign;       /* of the frame, tangents_make()'s */
};

struct model_triangle {
    uint32_t corner[3]; /* counter-clockwise seen from outside */
    uint32_t material;
};

enum model_normals { MODEL_NORMALS_GIVEN, MODEL_NORMALS_SMOOTHED, MODEL_NORMALS_FLAT };

struct model_mesh {
    char *name;
    struct model_vertex *vertices;
    struct model_triangle *triangles;
    size_t vertex_count, vertex_room, triangle_count, triangle_room;
    enum model_normals normals; /* where they come from, for the report */
    bool has_uvs;               /* its vertices have texture coordinates */
    bool keeps_uvs;             /* they are kept though no material of it has a texture */
};

struct model_material {
    char *name;
    double diffuse[3], specular[3], ka, kd, ks, shininess;
    bool flat, two_sided;
    int texture, bump; /* -1: none */
    /* Until the texture that a model names has been read: */
    char *picture;   /* its file, as the model names it, or what it is called inside the model; or null */
    uint8_t *inside; /* what would be the file, of the first material that has a picture from inside the model */
    size_t inside_size;
};

/* Colours, as read or made; packing brings it to powers of two. */
struct model_texture {
    char *name;
    bool is_file; /* its name is a path, and all that name this file share it */
    int format;   /* enum scene_texture_format */
    bool bilinear, clamp[2];
    unsigned width, height;
    uint8_t *rgb;         /* top row first */
    double (*normals)[3]; /* of TEXTURE_BUMP8 instead, unit */
};

struct model_fog {
    int kind; /* enum scene_fog_kind */
    double colour[3], from, to, density;
};

struct model_pose {
    double rotation[4]; /* unit quaternion w, x, y, z */
    double position[3];
    double scale;
};

struct model_key {
    uint32_t time_ms;
    struct model_pose pose;
};

struct model_motion {
    int kind; /* enum scene_motion_kind */
    size_t first_key, key_count;
    double axis[3], rate; /* turns a second */
};

struct model_object {
    size_t mesh;
    int material; /* replaces all of the mesh's; -1: none */
    struct model_pose pose;
    struct model_motion motion;
};

struct model_light {
    int kind; /* enum scene_light_kind */
    double vector[3], colour[3];
    struct model_motion motion;
};

struct model_camera {
    int kind, viewer; /* enum scene_camera_kind, scene_viewer_kind */
    double rotation[4], position[3], focal, near_plane, far_plane;
    unsigned size[2];
};

struct model {
    struct model_mesh *meshes;
    struct model_material *materials;
    struct model_object *objects;
    struct model_light *lights;
    struct model_key *keys;
    struct model_texture *textures;
    size_t mesh_count, material_count, object_count, light_count, key_count, texture_count;
    double ambient[3], background[3];
    struct model_fog fog;
    uint32_t duration_ms;
    struct model_camera camera;
};

extern const struct model_pose model_identity;

/* Each adds one zeroed element (a white matt material, an object at the origin) and returns it; the pointer holds
 * until the next one of its kind. `name` is copied. */
struct model_mesh *model_add_mesh(struct model *model, const char *name);
struct model_material *model_add_material(struct model *model, const char *name);
struct model_object *model_add_object(struct model *model);
struct model_light *model_add_light(struct model *model);
struct model_key *model_add_key(struct model *model);
struct model_texture *model_add_texture(struct model *model, const char *name);

uint32_t model_add_vertex(struct model_mesh *mesh, const double position[3], const double normal[3], double u,
                          double v);
void model_add_triangle(struct model_mesh *mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t material);

/* Index of the mesh or material of that name, or -1. */
int model_find_mesh(const struct model *model, const char *name);
int model_find_material(const struct model *model, const char *name);
int model_find_texture(const struct model *model, const char *name);

void model_free(struct model *model);

/* malloc and strdup that do not return null. */
void *model_alloc(size_t size);
char *model_copy(const char *text);
/* Room for one more element, zeroed and counted; for short arrays, which grow by one. */
void *model_add(void *array, size_t *count, size_t element);
/* Room for at least count + 1 elements, doubling; returns the array, perhaps moved. */
void *model_grow(void *array, size_t count, size_t *room, size_t element);

#endif
