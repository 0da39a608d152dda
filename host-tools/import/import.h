/* SPDX-License-Identifier: MIT */
/*
 * Models through assimp: OBJ with MTL, PLY, STL, glTF 1 and 2. The node tree is flattened and everything that is not a
 * triangle, a normal, a texture coordinate or a material is left out.
 *
 * Materials. MTL: Kd, Ks and Ns are diffuse, specular and shininess, ka = kd = 1, ks = 1 if Ks and Ns are there. glTF:
 * with base colour B, metalness m and roughness r, n = 2/r^4 - 2 (the Blinn-Phong exponent whose lobe is as wide as
 * the microfacets'), diffuse = (B (1 - m/2))^(1/2.2), since B is linear and Glint's colours are display values, and
 * specular = mix(0.04, B, m) (n + 8)/8, at most 1. Exponents are rounded to 1..1023. A mesh without material is light
 * grey. Vertex colours are not read. A texture of the diffuse or base colour is, from a PNG file beside the model or
 * inside it; one that cannot be is left out, with a warning.
 *
 * Normals that are missing, and STL's, which are only its facets', are made by normals_smooth().
 */
#ifndef IMPORT_H
#define IMPORT_H

#include "scene/model.h"

#define IMPORT_CREASE 45.0 /* degrees */

/* Adds the file's triangles to mesh `mesh` of the model and its materials to the model; returns an exit code and has
 * printed a message when it is not 0. */
int import_file(const char *path, double crease, struct model *model, size_t mesh);

/* Moves the mesh to the origin and scales it so that its bounding sphere there has radius 1. */
void import_fit(struct model_mesh *mesh);

/* Exit code 0 if `path` is a regular file that opens for reading; otherwise 3, having said why. Libraries' own messages
 * would hide that it is a folder, or not there. */
int import_check_readable(const char *path);

/* Whether the name ends like a model that import_file() reads. */
bool import_knows(const char *path);

#endif
