/* SPDX-License-Identifier: MIT */
#include "reference/reference.h"

#include "reference/highlight.h"
#include "reference/triangle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The mesh under way. */
struct reference_mesh {
    struct decode_vertex vertex[SCENE_MAX_VERTICES + 1];
    bool reached[SCENE_MAX_VERTICES + 1]; /* by a highlight */
};

static void reference_triangle(struct triangle_target *target, const struct scene_header *scene,
                               const struct scene_triangle *triangle, const struct reference_mesh *mesh)
{
    struct decode_vertex corner[3];
    struct decode_material material;
    double bend[3];
    target->highlight = false;
    target->edges = target->every_zigzag ? 7 : triangle->flags;
    for (unsigned i = 0; i < 3; i++) {
        corner[i] = mesh->vertex[triangle->corner[i]];
        target->corner_placed[i] = target->placed ? target->placed[triangle->corner[i]] : NULL;
        bend[i] = decode_bend(triangle, i);
        target->highlight = target->highlight || (target->method->highlight && mesh->reached[triangle->corner[i]]);
    }
    decode_material(scene, triangle->material, &material);
    memcpy(material.texture.nudge, target->nudge, sizeof target->nudge);
    memcpy(material.bump.nudge, target->nudge, sizeof target->nudge);
    triangle_draw(target, &material, corner, bend);
}

static void reference_object(struct triangle_target *target, const struct scene_header *scene,
                             const struct scene_object *object, const struct reference_options *options,
                             struct reference_mesh *mesh)
{
    const struct scene_mesh *packed = scene_meshes(scene) + object->mesh;
    const struct scene_triangle *triangles = scene_at(scene, packed->triangles);
    decode_vertices(scene, object, options->time_ms, mesh->vertex);
    decode_turn(scene, object, options->time_ms, options->yaw, options->pitch, mesh->vertex);
    if (target->method->highlight)
        highlight_mark(target->view, triangles, packed->triangle_count, mesh->vertex, mesh->reached,
                       packed->vertex_count);
    for (uint32_t t = 0; t < packed->triangle_count; t++, target->triangle++)
        reference_triangle(target, scene, triangles + t, mesh);
    if (target->placed)
        target->placed += packed->vertex_count;
}

static void reference_clear(struct triangle_target *target)
{
    struct reference_image *image = target->image;
    size_t pixels = (size_t)image->width * image->height;
    for (size_t i = 0; i < pixels; i++) {
        target->depth[i] = -INFINITY;
        shading_channels(target->view->background, image->channels, image->value + i * image->channels);
    }
}

bool reference_render(const struct scene_header *scene, const struct reference_options *options,
                      struct reference_image *image)
{
    *image = (struct reference_image){.width = options->width ? options->width : scene->camera.reference_width,
                                      .height = options->height ? options->height : scene->camera.reference_height,
                                      .channels = options->grey ? 1 : 3};
    struct decode_view view;
    struct triangle_target target = {.image = image,
                                     .view = &view,
                                     .method = methods + options->method,
                                     .drawn = options->drawn,
                                     .placed = options->placed,
                                     .nudge = {options->nudge[0], options->nudge[1]},
                                     .tolerance = (options->tolerance ? options->tolerance : 4) / 255,
                                     .part_area = options->part_area ? options->part_area : 32,
                                     .every_zigzag = options->every_zigzag};
    size_t pixels = (size_t)image->width * image->height;
    struct reference_mesh *mesh = malloc(sizeof *mesh);
    image->value = malloc(pixels * image->channels * sizeof *image->value);
    image->covered = calloc(pixels, 1);
    target.depth = malloc(pixels * sizeof *target.depth);
    bool done = mesh && image->value && image->covered && target.depth;
    if (done) {
        decode_view(scene, options->time_ms, image->width, image->height, &view);
        reference_clear(&target);
        for (unsigned o = 0; o < scene->object_count; o++)
            reference_object(&target, scene, scene_objects(scene) + o, options, mesh);
    } else {
        reference_free(image);
    }
    free(mesh);
    free(target.depth);
    return done;
}

void reference_free(struct reference_image *image)
{
    free(image->value);
    free(image->covered);
    *image = (struct reference_image){0};
}

uint8_t reference_byte(double value)
{
    return (uint8_t)(value * 255 + .5);
}
