/* SPDX-License-Identifier: MIT */
/* Frames of one triangle of four corners, to be clipped. Include after cmocka.h. */
#ifndef CLIP_CASE_H
#define CLIP_CASE_H

#include "tests/unit/frame_case.h"
#include "tests/unit/random.h"
#include "tests/unit/scene_case.h"

#define WIDTH  48
#define HEIGHT 40

static struct scene_case scene;
static struct scene_vertex vertex[4];
static struct scene_triangle triangle[2];
static struct frame_case frame;
static struct scene_header *blob;

/* A blob of four corners and two triangles, changed in place, and a renderer for it. */
static inline void clip_begin(void)
{
    for (int i = 0; i < 4; i++)
        scene_case_normal(vertex[i].normal, 0, 0, 1);
    triangle[0] = (struct scene_triangle){.corner = {0, 1, 2}};
    triangle[1] = (struct scene_triangle){.corner = {0, 2, 3}};
    scene.material[0].flags = MATERIAL_TWO_SIDED;
    scene.mesh[0].vertices = vertex;
    scene.mesh[0].triangles = triangle;
    scene.mesh[0].vertex_count = 4;
    scene.mesh[0].triangle_count = 2;
    blob = scene_case_blob(&scene);
    frame = (struct frame_case){
        .config = {.width = WIDTH, .height = HEIGHT, .format = GLINT_GREY8, .method = &glint_flat, .max_clipped = 16}};
    frame.config.max_vertices = 4;
    frame.config.max_triangles = 16;
    frame.config.max_objects = frame.config.max_lights = 1;
    frame_case_open(&frame);
}

static inline void clip_end(void)
{
    frame_case_close(&frame);
    free(blob);
}

static inline void *clip_part(uint32_t offset)
{
    return (uint8_t *)blob + offset;
}

/* Draws one triangle of the mesh, the corners at places of three units. */
static inline void clip_draw(const int32_t p[4][3], const uint16_t corner[3])
{
    struct scene_mesh *mesh = clip_part(blob->meshes);
    struct scene_vertex *v = clip_part(mesh->vertices);
    struct scene_triangle *t = clip_part(mesh->triangles);
    for (int i = 0; i < 4; i++)
        for (int c = 0; c < 3; c++)
            v[i].position[c] = (int16_t)p[i][c];
    memcpy(t->corner, corner, sizeof t->corner);
    mesh->triangle_count = 1;
    frame_case_draw(&frame, blob, 0);
}

static inline void clip_nothing_is_drawn(void)
{
    for (size_t i = 0; i < frame.picture_bytes; i++)
        assert_int_equal(frame.picture[i], 0);
}

#endif
