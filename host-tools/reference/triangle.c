/* SPDX-License-Identifier: MIT */
#include "reference/triangle.h"

#include "reference/bump.h"
#include "reference/fog.h"
#include "reference/texture.h"
#include "scene/vec.h"

#include <math.h>
#include <string.h>

/* A corner of what is drawn: of a whole triangle, or of a part that the near plane left of it. */
struct triangle_corner {
    struct decode_vertex vertex;
    double place[3]; /* in the triangle that is shaded */
    /* In the picture: 1/16 pixel from the centre, y down. Whole numbers in doubles: exact up to 2^26, far beyond any
     * picture, and what lies outside only has its edges misplaced there. */
    double x, y, closeness;
    const int16_t *placed; /* as in struct triangle_target, of a corner of the mesh */
};

/* `placed` is null or where it was rounded to. */
static double triangle_snap(double pixels, const int16_t *placed)
{
    if (placed && fabs(16 * pixels - *placed) <= .5 + 1 / 64.)
        return *placed;
    return floor(16 * pixels + .5);
}

static void triangle_project(const struct decode_view *view, struct triangle_corner *corner)
{
    const double *eye = corner->vertex.position;
    const int16_t *placed = corner->placed;
    double scale = view->perspective ? view->focal / -eye[2] : view->focal;
    corner->x = triangle_snap(scale * eye[0], placed);
    corner->y = triangle_snap(-scale * eye[1], placed ? placed + 1 : NULL);
    corner->closeness = view->perspective ? -1 / eye[2] : eye[2];
}

/* Twice the area to the left of a -> b (as seen, y up) that p spans. */
static double triangle_side(const struct triangle_corner *a, const struct triangle_corner *b, double x, double y)
{
    return (b->y - a->y) * (x - a->x) - (b->x - a->x) * (y - a->y);
}

/* On an edge, a pixel centre belongs to the triangle at its right, or below. */
static bool triangle_inside(const struct triangle_corner *a, const struct triangle_corner *b, double side)
{
    return side > 0 || (side == 0 && (b->y > a->y || (b->y == a->y && b->x < a->x)));
}

/* From coordinates in the picture of what is drawn to those in space, in the triangle that is shaded. */
static void triangle_unproject(const struct triangle_corner p[3], const double screen[3], double closeness,
                               double space[3])
{
    for (int k = 0; k < 3; k++)
        space[k] = 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            space[k] += screen[i] * (closeness ? p[i].closeness / closeness : 1) * p[i].place[k];
}

/* With texture and bump map: always perspective-correct, whatever the method does. `space` are the pixel's coordinates
 * there. */
static void triangle_textured(struct shading *shading, const struct decode_material *material, const double at[3],
                              const double space[3], unsigned channels, double colour[3])
{
    double factor[3], uv[2];
    for (int k = 0; k < 2; k++)
        uv[k] = space[0] * shading->corner[0].uv[k] + space[1] * shading->corner[1].uv[k] +
                space[2] * shading->corner[2].uv[k];
    texture_factors(material, uv, channels, factor);
    const bool all = texture_multiplies_all(shading->method);
    for (unsigned c = 0; c < 3; c++)
        shading->texel[c] = all ? 1 : factor[c];
    if (shading->bumped) {
        bump_normal(&material->bump, uv[0], uv[1], shading->relief);
        bump_pixel(shading, shading->method->bump, at, colour);
    } else {
        shading->method->pixel(shading, at, colour);
    }
    for (unsigned c = 0; all && c < channels; c++)
        colour[c] *= factor[c];
}

static void triangle_pixel(struct triangle_target *target, const struct decode_material *material,
                           struct shading *shading, const struct triangle_corner p[3], const double screen[3],
                           size_t index)
{
    const struct decode_view *view = target->view;
    struct reference_image *image = target->image;
    double closeness = 0, space[3], colour[3];
    for (int i = 0; i < 3; i++)
        closeness += screen[i] * p[i].closeness;
    double limit = view->perspective ? 1 / view->far_plane : -view->far_plane;
    double nearness = target->drawn ? fmin(screen[0], fmin(screen[1], screen[2])) : closeness;
    if ((closeness < limit && !target->drawn) || nearness <= target->depth[index])
        return;
    triangle_unproject(p, screen, view->perspective ? closeness : 0, space);
    triangle_textured(shading, material, shading->method->perspective ? space : screen, space, image->channels, colour);
    fog_apply(&view->fog, view->perspective ? 1 / closeness : -closeness, image->channels, colour);
    target->depth[index] = nearness;
    image->coverage += !image->covered[index];
    image->covered[index] = 1;
    for (unsigned c = 0; c < image->channels; c++)
        image->value[index * image->channels + c] = colour[c];
}

/* The range of pixels whose centres lie in [low, high] on an axis of `size` pixels. */
static void triangle_range(double low, double high, unsigned size, unsigned *first, unsigned *end)
{
    double half = size / 2.;
    double from = ceil(low / 16 + half - .5), to = floor(high / 16 + half - .5) + 1;
    *first = from <= 0 ? 0 : from >= size ? size : (unsigned)from;
    *end = to <= 0 ? 0 : to >= size ? size : (unsigned)to;
}

static void triangle_fill(struct triangle_target *target, const struct decode_material *material,
                          struct shading *shading, const struct triangle_corner p[3], double area)
{
    unsigned left, right, top, bottom, width = target->image->width, height = target->image->height;
    const double beside = target->drawn ? 16 : 0; /* drawn there by a rounding */
    triangle_range(fmin(p[0].x, fmin(p[1].x, p[2].x)) - beside, fmax(p[0].x, fmax(p[1].x, p[2].x)) + beside, width,
                   &left, &right);
    triangle_range(fmin(p[0].y, fmin(p[1].y, p[2].y)) - beside, fmax(p[0].y, fmax(p[1].y, p[2].y)) + beside, height,
                   &top, &bottom);
    for (unsigned row = top; row < bottom; row++) {
        for (unsigned column = left; column < right; column++) {
            double x = 16. * column + 8 - 8. * width, y = 16. * row + 8 - 8. * height, screen[3];
            const size_t index = (size_t)row * width + column;
            bool inside = true, wanted = target->drawn && target->drawn[index] == target->triangle;
            if (target->drawn && !wanted)
                continue;
            for (int i = 0; i < 3 && (inside || wanted); i++) {
                const struct triangle_corner *a = p + (i + 1) % 3, *b = p + (i + 2) % 3;
                double side = triangle_side(a, b, x, y);
                inside = inside && triangle_inside(a, b, side);
                screen[i] = side / area;
            }
            if (inside || wanted)
                triangle_pixel(target, material, shading, p, screen, index);
        }
    }
}

/* From behind: the same surface as if it had been built to face that way. */
static void triangle_turn(struct triangle_corner p[3], struct decode_vertex shaded[3], double bend[3])
{
    const struct triangle_corner corner = p[1];
    const struct decode_vertex vertex = shaded[1];
    const double between = bend[0];
    p[1] = p[2];
    p[2] = corner;
    shaded[1] = shaded[2];
    shaded[2] = vertex;
    bend[0] = bend[2];
    bend[2] = between;
    for (int i = 0; i < 3; i++) {
        const double at = p[i].place[1];
        p[i].place[1] = p[i].place[2];
        p[i].place[2] = at;
        for (int k = 0; k < 3; k++)
            shaded[i].normal[k] = -shaded[i].normal[k];
        for (int k = 0; k < 3; k++) /* with the whole frame: the slopes stay the map's */
            shaded[i].tangent[k] = -shaded[i].tangent[k];
        shaded[i].sign = -shaded[i].sign;
    }
}

/* What is drawn, `p`, and shaded, `shaded`: both may be turned. */
static void triangle_render(struct triangle_target *target, const struct decode_material *material,
                            struct triangle_corner p[3], struct decode_vertex shaded[3], double bend[3])
{
    struct shading shading = {.tolerance = target->tolerance,
                              .part_area = target->part_area,
                              .highlight = target->highlight,
                              .edges = target->edges};
    double place[3][2];
    for (int i = 0; i < 3; i++)
        triangle_project(target->view, p + i);
    double area = triangle_side(&p[0], &p[1], p[2].x, p[2].y);
    if (area < 0 && material->two_sided) {
        triangle_turn(p, shaded, bend);
        shading.edges = (shading.edges & 2u) | (shading.edges & 1u) << 2 | (shading.edges >> 2 & 1u);
        area = -area;
    }
    if (target->drawn ? area == 0 : area <= 0) /* what is drawn and all but edge-on may be a back here by a rounding */
        return;
    for (int i = 0; i < 3; i++) {
        place[i][0] = p[i].x / 16;
        place[i][1] = p[i].y / 16;
    }
    shading_material(&shading, target->view, material, target->image->channels);
    shading_setup(&shading, target->method, shaded, bend, place);
    triangle_fill(target, material, &shading, p, area);
}

/* Where a -> b crosses the near plane. */
static struct triangle_corner triangle_cut(const struct triangle_corner *a, const struct triangle_corner *b,
                                           double near)
{
    struct triangle_corner v = {0};
    double t = (-near - a->vertex.position[2]) / (b->vertex.position[2] - a->vertex.position[2]);
    for (int i = 0; i < 3; i++) {
        v.vertex.position[i] = a->vertex.position[i] + t * (b->vertex.position[i] - a->vertex.position[i]);
        if (i < 2)
            v.vertex.uv[i] = a->vertex.uv[i] + t * (b->vertex.uv[i] - a->vertex.uv[i]);
        v.vertex.normal[i] = a->vertex.normal[i] + t * (b->vertex.normal[i] - a->vertex.normal[i]);
        v.vertex.tangent[i] = a->vertex.tangent[i] + t * (b->vertex.tangent[i] - a->vertex.tangent[i]);
        v.place[i] = a->place[i] + t * (b->place[i] - a->place[i]);
    }
    v.vertex.position[2] = -near;
    v.vertex.sign = a->vertex.sign;
    return v;
}

/* A part of a clipped triangle. Methods that know the picture alone shade the part, with unit normals and their bends;
 * to those that work in space the cut makes no difference. */
static void triangle_part(struct triangle_target *target, const struct decode_material *material,
                          struct triangle_corner p[3], const struct decode_vertex whole[3], const double bend[3])
{
    struct decode_vertex corner[3];
    double bent[3];
    if (target->method->perspective) { /* each part turns its own copy */
        memcpy(corner, whole, sizeof corner);
        memcpy(bent, bend, sizeof bent);
        triangle_render(target, material, p, corner, bent);
        return;
    }
    for (int i = 0; i < 3; i++) {
        vec_normalise(p[i].vertex.normal);
        vec_normalise(p[i].vertex.tangent);
        corner[i] = p[i].vertex;
        for (int k = 0; k < 3; k++)
            p[i].place[k] = k == i;
    }
    for (int e = 0; e < 3; e++)
        bent[e] = (1 - vec_dot(corner[e].normal, corner[(e + 1) % 3].normal)) / 2;
    triangle_render(target, material, p, corner, bent);
}

void triangle_draw(struct triangle_target *target, const struct decode_material *material,
                   struct decode_vertex corner[3], double bend[3])
{
    double near = target->view->near_plane;
    struct triangle_corner p[3] = {{.place = {1, 0, 0}}, {.place = {0, 1, 0}}, {.place = {0, 0, 1}}}, kept[4];
    int count = 0, cuts = 0;
    for (int i = 0; i < 3; i++) {
        p[i].vertex = corner[i];
        p[i].placed = target->corner_placed[i];
    }
    for (int i = 0; i < 3; i++) {
        const struct triangle_corner *a = p + i, *b = p + (i + 1) % 3;
        bool a_in = -a->vertex.position[2] >= near, b_in = -b->vertex.position[2] >= near;
        if (a_in)
            kept[count++] = *a;
        if (a_in != b_in) {
            /* always from the inner end: triangles that share the edge share the corner */
            kept[count++] = a_in ? triangle_cut(a, b, near) : triangle_cut(b, a, near);
            cuts++;
        }
    }
    if (count == 3 && cuts == 0)
        triangle_render(target, material, p, corner, bend);
    for (int i = 2; i < count && cuts > 0; i++) {
        struct triangle_corner part[3] = {kept[0], kept[i - 1], kept[i]};
        triangle_part(target, material, part, corner, bend);
    }
}
