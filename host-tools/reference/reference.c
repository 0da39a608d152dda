/* SPDX-License-Identifier: MIT */
#include "reference/reference.h"

#include "reference/shading.h"
#include "scene/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct reference_target {
    struct reference_image *image;
    const struct decode_view *view;
    enum reference_method method;
    double *depth; /* closeness: 1 / distance in perspective, else - distance; -infinity where nothing is */
};

/* A corner in the picture: 1/16 pixel from the centre, y down. Whole numbers in doubles: exact up to 2^26, far beyond
 * any picture, and what lies outside only has its edges misplaced there. */
struct reference_corner {
    double x, y, closeness;
};

static double reference_snap(double pixels)
{
    return floor(16 * pixels + .5);
}

static struct reference_corner reference_project(const struct decode_view *view, const double eye[3])
{
    double scale = view->perspective ? view->focal / -eye[2] : view->focal;
    return (struct reference_corner){reference_snap(scale * eye[0]), reference_snap(-scale * eye[1]),
                                     view->perspective ? -1 / eye[2] : eye[2]};
}

/* Twice the area to the left of a -> b (as seen, y up) that p spans. */
static double reference_side(const struct reference_corner *a, const struct reference_corner *b, double x, double y)
{
    return (b->y - a->y) * (x - a->x) - (b->x - a->x) * (y - a->y);
}

/* On an edge, a pixel centre belongs to the triangle at its right, or below. */
static bool reference_inside(const struct reference_corner *a, const struct reference_corner *b, double side)
{
    return side > 0 || (side == 0 && (b->y > a->y || (b->y == a->y && b->x < a->x)));
}

static void reference_pixel(struct reference_target *target, const struct shading *shading,
                            const struct reference_corner p[3], const double screen[3], size_t index)
{
    const struct decode_view *view = target->view;
    struct reference_image *image = target->image;
    double closeness = 0, space[3], colour[3];
    for (int i = 0; i < 3; i++)
        closeness += screen[i] * p[i].closeness;
    double limit = view->perspective ? 1 / view->far_plane : -view->far_plane;
    if (closeness < limit || closeness <= target->depth[index])
        return;
    for (int i = 0; i < 3; i++)
        space[i] = view->perspective ? screen[i] * p[i].closeness / closeness : screen[i];
    shading_pixel(shading, screen, space, colour);
    target->depth[index] = closeness;
    image->coverage += !image->covered[index];
    image->covered[index] = 1;
    for (unsigned c = 0; c < image->channels; c++)
        image->value[index * image->channels + c] = colour[c];
}

/* The range of pixels whose centres lie in [low, high] on an axis of `size` pixels. */
static void reference_range(double low, double high, unsigned size, unsigned *first, unsigned *end)
{
    double half = size / 2.;
    double from = ceil(low / 16 + half - .5), to = floor(high / 16 + half - .5) + 1;
    *first = from <= 0 ? 0 : from >= size ? size : (unsigned)from;
    *end = to <= 0 ? 0 : to >= size ? size : (unsigned)to;
}

static void reference_triangle(struct reference_target *target, const struct decode_material *material,
                               const struct decode_vertex corner[3], const double bend[3])
{
    struct reference_corner p[3];
    struct shading shading;
    for (int i = 0; i < 3; i++)
        p[i] = reference_project(target->view, corner[i].position);
    double area = reference_side(&p[0], &p[1], p[2].x, p[2].y);
    if (area <= 0)
        return;
    unsigned left, right, top, bottom, width = target->image->width, height = target->image->height;
    reference_range(fmin(p[0].x, fmin(p[1].x, p[2].x)), fmax(p[0].x, fmax(p[1].x, p[2].x)), width, &left, &right);
    reference_range(fmin(p[0].y, fmin(p[1].y, p[2].y)), fmax(p[0].y, fmax(p[1].y, p[2].y)), height, &top, &bottom);
    shading_setup(&shading, target->view, material, target->image->channels, target->method, corner, bend);
    for (unsigned row = top; row < bottom; row++) {
        for (unsigned column = left; column < right; column++) {
            double x = 16. * column + 8 - 8. * width, y = 16. * row + 8 - 8. * height, screen[3];
            bool inside = true;
            for (int i = 0; i < 3 && inside; i++) {
                const struct reference_corner *a = p + (i + 1) % 3, *b = p + (i + 2) % 3;
                double side = reference_side(a, b, x, y);
                inside = reference_inside(a, b, side);
                screen[i] = side / area;
            }
            if (inside)
                reference_pixel(target, &shading, p, screen, (size_t)row * width + column);
        }
    }
}

/* Where a -> b crosses the near plane. The normal is not made unit: perspective-correct interpolation of these
 * normals is then that of the whole triangle's. */
static struct decode_vertex reference_cut(const struct decode_vertex *a, const struct decode_vertex *b, double near)
{
    struct decode_vertex v;
    double t = (-near - a->position[2]) / (b->position[2] - a->position[2]);
    for (int i = 0; i < 3; i++) {
        v.position[i] = a->position[i] + t * (b->position[i] - a->position[i]);
        v.normal[i] = a->normal[i] + t * (b->normal[i] - a->normal[i]);
    }
    v.position[2] = -near;
    return v;
}

/* A part of a clipped triangle. The methods that know nothing but corners get unit normals there and their bends. */
static void reference_part(struct reference_target *target, const struct decode_material *material,
                           struct decode_vertex corner[3])
{
    double bend[3];
    for (int i = 0; i < 3 && target->method != REFERENCE_PHONG; i++)
        vec_normalise(corner[i].normal);
    for (int e = 0; e < 3; e++)
        bend[e] = (1 - vec_dot(corner[e].normal, corner[(e + 1) % 3].normal)) / 2;
    reference_triangle(target, material, corner, bend);
}

static void reference_clip(struct reference_target *target, const struct decode_material *material,
                           const struct decode_vertex corner[3], const double bend[3])
{
    double near = target->view->near_plane;
    struct decode_vertex kept[4];
    int count = 0, cuts = 0;
    for (int i = 0; i < 3; i++) {
        const struct decode_vertex *a = corner + i, *b = corner + (i + 1) % 3;
        bool a_in = -a->position[2] >= near, b_in = -b->position[2] >= near;
        if (a_in)
            kept[count++] = *a;
        if (a_in != b_in) {
            /* always from the inner end: triangles that share the edge share the corner */
            kept[count++] = a_in ? reference_cut(a, b, near) : reference_cut(b, a, near);
            cuts++;
        }
    }
    if (count == 3 && cuts == 0)
        reference_triangle(target, material, corner, bend);
    for (int i = 2; i < count && cuts > 0; i++) {
        struct decode_vertex part[3] = {kept[0], kept[i - 1], kept[i]};
        reference_part(target, material, part);
    }
}

static void reference_object(struct reference_target *target, const struct scene_header *scene,
                             const struct scene_object *object, uint32_t time_ms, struct decode_vertex *vertices)
{
    const struct scene_mesh *mesh = scene_meshes(scene) + object->mesh;
    const struct scene_triangle *triangles = scene_at(scene, mesh->triangles);
    decode_vertices(scene, object, time_ms, vertices);
    for (uint32_t t = 0; t < mesh->triangle_count; t++) {
        struct decode_vertex corner[3];
        struct decode_material material;
        double bend[3];
        for (unsigned i = 0; i < 3; i++) {
            corner[i] = vertices[triangles[t].corner[i]];
            bend[i] = decode_bend(triangles + t, i);
        }
        decode_material(scene, triangles[t].material, &material);
        reference_clip(target, &material, corner, bend);
    }
}

static void reference_clear(struct reference_target *target)
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
    struct reference_target target = {.image = image, .view = &view, .method = options->method};
    size_t pixels = (size_t)image->width * image->height;
    struct decode_vertex *vertices = malloc((SCENE_MAX_VERTICES + 1) * sizeof *vertices);
    image->value = malloc(pixels * image->channels * sizeof *image->value);
    image->covered = calloc(pixels, 1);
    target.depth = malloc(pixels * sizeof *target.depth);
    bool done = vertices && image->value && image->covered && target.depth;
    if (done) {
        decode_view(scene, options->time_ms, image->width, image->height, &view);
        reference_clear(&target);
        for (unsigned o = 0; o < scene->object_count; o++)
            reference_object(&target, scene, scene_objects(scene) + o, options->time_ms, vertices);
    } else {
        reference_free(image);
    }
    free(vertices);
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
