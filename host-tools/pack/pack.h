/* SPDX-License-Identifier: MIT */
/*
 * From any file Glint reads to a scene blob (firmware/scene/scene.h) in memory, and from there to a file.
 *
 * By its ending a file is a scene (.json, see host-tools/README.md), a blob (.glt, checked in full) or a model (.obj
 * .ply .stl .gltf .glb), which is framed automatically: centred, scaled to unit radius, one key light, a slow spin of
 * one turn in 6 s.
 *
 * Functions that return int return the exit code of the command line: 0 done, 1 bad data, 3 device or I/O. Whenever it
 * is not 0, one line `file:line: reason` or `file: reason` has been printed on stderr and nothing is left to free.
 */
#ifndef PACK_H
#define PACK_H

#include "scene/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum pack_exit { PACK_OK = 0, PACK_BAD_DATA = 1, PACK_BAD_USAGE = 2, PACK_IO = 3 };

struct pack_options {
    unsigned shininess; /* 1..1023: replaces the exponent of every material; 0: as the scene says */
};

struct pack_report; /* what was welded, dropped and rounded: see report.h */

/* A checked blob. */
struct pack_result {
    const struct scene_header *scene; /* the blob; from malloc, so aligned for anything */
    size_t size;                      /* bytes, scene->length */
    struct pack_report *report;       /* null when the blob came ready-made from a .glt file */
};

/* Loads `path`; null options are all defaults. The result is the caller's, to be given to pack_free(). */
int pack_load(const char *path, const struct pack_options *options, struct pack_result *result);

/* Releases and clears a result; one that is all zeros is left alone. */
void pack_free(struct pack_result *result);

/* Writes the blob as it is, or as const C that compiles freestanding: `const uint32_t NAME[]` and `const uint32_t
 * NAME_length` (bytes). Both write to a temporary name beside `path` and rename, so there is never half a file. */
int pack_write_blob(const char *path, const struct pack_result *result);
int pack_write_c(const char *path, const char *name, const struct pack_result *result);

/* Whether the array can have this name: a C identifier that is not a keyword, nor otherwise taken. */
bool pack_is_name(const char *name);

/* Fills name[size] with such a name, as the last part of `path`, less its ending, suggests: scene_int from int.c. */
void pack_name(const char *path, char *name, size_t size);

#endif
