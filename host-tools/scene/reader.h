/* SPDX-License-Identifier: MIT */
/* Reads a scene file; its format is described in host-tools/README.md. */
#ifndef READER_H
#define READER_H

#include "scene/model.h"
#include "scene/node.h"

/* Fills an empty model; returns an exit code. On failure one message has been printed and the model is empty. */
int reader_load(const char *path, struct model *model);

/* The parts, each for one member of the root; failures stick to the node's file. */
void reader_meshes(const struct node *meshes, struct model *model, int *exit_code);
void reader_textures(const struct node *textures, struct model *model, int *exit_code);
void reader_objects(const struct node *objects, struct model *model);
void reader_lights(const struct node *lights, struct model *model);
void reader_camera(const struct node *camera, struct model_camera *out);

/* The shapes whose points the mesh's node holds, added to the mesh. */
void reader_patches(const struct node *mesh_node, struct model_mesh *mesh);
void reader_triangles(const struct node *mesh_node, struct model_mesh *mesh);

/* A file's path, which is relative to the scene file's folder: the caller's. */
char *reader_path(const struct node *node, const char *name);
/* The index of the texture that a material's member names, one of `textures` or a .png file; -1 if absent. */
int reader_texture(const struct node *material, const char *key, struct model *model, int *exit_code);
/* "x", "y", "z" or three numbers; made unit. Required. */
void reader_axis(const struct node *node, double out[3]);
/* A list of rotate, move and scale steps, each after those before; `pose` holds the first ones. Absent: no step. */
void reader_transform(const struct node *steps, struct model_pose *pose);
/* The member "spin" of an object or light. */
void reader_spin(const struct node *owner, struct model_motion *motion);
/* The index of the material that the member names; -1 if absent. */
int reader_material(const struct node *owner, const struct model *model);

#define READER_MOST_LENGTH 16383.0 /* scene units: below 2^14 with room for rounding */

/* The bump maps, after the textures; and the index of the one that a material names, -1 if absent. */
void reader_bumps(const struct node *bumps, struct model *model, int *exit_code);
int reader_bump(const struct node *material, const struct model *model);

/* Two whole numbers, kept as they are where the member is absent. */
void reader_pair(const struct node *node, const char *key, unsigned out[2], unsigned least, unsigned most);

/* The member "wrap": "repeat" or "clamp", for both ways or in a list of two. */
void reader_wrap(const struct node *node, struct model_texture *texture);

#endif
