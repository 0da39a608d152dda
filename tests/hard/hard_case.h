/* SPDX-License-Identifier: MIT */
/*
 * One triangle with given corners and normals under one far light, seen without perspective, and what each method makes
 * of it in double precision, written from the papers' formulas and nothing else. Include after cmocka.h.
 */
#ifndef HARD_CASE_H
#define HARD_CASE_H

#include "tests/unit/frame_case.h"
#include "tests/unit/random.h"
#include "tests/unit/scene_case.h"

#define HARD_SIDE 64 /* pixels of the picture, either way */

struct hard_case {
    struct scene_vertex vertex[3];
    struct scene_triangle triangle;
    double light[3]; /* towards it, unit */
    double kd, ks, ka;
    unsigned n;
};

/* Corners in sub-pixels from the picture's centre, x right and y down, |.| <= 511: exact on the mesh's grid. */
static inline void hard_corners(struct hard_case *h, const int sub[3][2])
{
    memset(h, 0, sizeof *h);
    for (int k = 0; k < 3; k++) {
        h->vertex[k].position[0] = (int16_t)(64 * sub[k][0]);
        h->vertex[k].position[1] = (int16_t)(-64 * sub[k][1]);
        h->triangle.corner[k] = (uint16_t)k;
    }
    h->ka = 1 / 16.;
    h->n = 20;
}

/* All of the picture but a margin, its face to the eye. */
static inline void hard_large(struct hard_case *h)
{
    static const int sub[3][2] = {{-480, 440}, {500, 300}, {-100, -480}};
    hard_corners(h, sub);
}

static inline void hard_normal(struct hard_case *h, int k, double x, double y, double z)
{
    scene_case_normal(h->vertex[k].normal, x, y, z);
}

static inline void hard_light(struct hard_case *h, double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z), v[3] = {x / length, y / length, z / length};
    memcpy(h->light, v, sizeof v);
}

/* The scene, checked, to be freed; bends are those of the normals. */
static inline struct scene_header *hard_scene(struct hard_case *h)
{
    struct scene_case c;
    scene_case_default(&c, HARD_SIDE, HARD_SIDE);
    c.head.camera.kind = CAMERA_ORTHOGRAPHIC;
    c.head.camera.focal = 32 * CASE_UNIT; /* 32768 of a position are 32 pixels */
    c.object[0].position[2] = -4 * CASE_UNIT;
    c.material[0].ka = (uint16_t)lrint(h->ka * 32768);
    c.material[0].kd = (uint16_t)lrint(h->kd * 32768);
    c.material[0].ks = (uint16_t)lrint(h->ks * 32768);
    c.material[0].shininess = (uint16_t)h->n;
    for (int i = 0; i < 3; i++)
        c.light[0].vector[i] = (int32_t)lrint(h->light[i] * (1 << 30));
    scene_case_bend(&h->triangle, h->vertex);
    c.mesh[0].vertices = h->vertex;
    c.mesh[0].triangles = &h->triangle;
    c.mesh[0].vertex_count = 3;
    c.mesh[0].triangle_count = 1;
    return scene_case_blob(&c);
}

/* Barycentric coordinates of a pixel's centre; 0 if it is not strictly inside. */
static inline int hard_inside(const struct hard_case *h, int x, int y, double l[3])
{
    double p[3][2];
    for (int k = 0; k < 3; k++) {
        p[k][0] = h->vertex[k].position[0] / 1024. + HARD_SIDE / 2 - x - .5;
        p[k][1] = -h->vertex[k].position[1] / 1024. + HARD_SIDE / 2 - y - .5;
    }
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const double *a = p[(k + 1) % 3], *b = p[(k + 2) % 3];
        l[k] = a[0] * b[1] - a[1] * b[0];
        sum += l[k];
    }
    for (int k = 0; k < 3; k++)
        l[k] /= sum;
    return l[0] > 1e-9 && l[1] > 1e-9 && l[2] > 1e-9;
}

static inline double hard_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double hard_clamped(double x)
{
    return x < 0 ? 0 : x > 1 ? 1 : x;
}

/* Full intensity is 1; not clamped above. */
static inline double hard_colour(const struct hard_case *h, double diffuse, double highlight)
{
    return h->ka + h->kd * hard_clamped(diffuse) + h->ks * pow(hard_clamped(highlight), h->n);
}

/* What the formulas need: N.L and N.H at the corners, (1 - Ni.Nj) / 2 of the edges 0-1, 1-2, 2-0 as the mesh has it,
 * 2 / |Ni + Nj|, and finished colours at the corners and, true ones, at the middles of the edges. */
struct hard_facts {
    double dot[2][3], bend[3], longer[3], normal[3][3], towards[2][3], corner[3], middle[3];
};

static inline void hard_facts(const struct hard_case *h, struct hard_facts *f)
{
    double half[3] = {h->light[0], h->light[1], h->light[2] + 1};
    const double length = sqrt(hard_dot(half, half));
    for (int i = 0; i < 3; i++) {
        f->towards[0][i] = h->light[i];
        f->towards[1][i] = length > 0 ? half[i] / length : i == 2; /* away from the eye: as object_unit() says */
    }
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            f->normal[k][i] = h->vertex[k].normal[i] / 16384.;
        f->bend[k] = h->triangle.bend[k] / 65536.;
        f->longer[k] = 1 / sqrt(fmax(1 - f->bend[k], 1 / 256.)); /* beyond 173 degrees the renderer's is held at 16 */
        for (int d = 0; d < 2; d++)
            f->dot[d][k] = hard_dot(f->normal[k], f->towards[d]);
        f->corner[k] = fmin(hard_colour(h, f->dot[0][k], f->dot[1][k]), 1);
    }
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        const double half = f->longer[k] / 2;
        f->middle[k] =
            fmin(hard_colour(h, (f->dot[0][k] + f->dot[0][next]) * half, (f->dot[1][k] + f->dot[1][next]) * half), 1);
    }
}

enum hard_way { HARD_GOURAUD, HARD_X, HARD_SIX, HARD_COLOR6, HARD_DUFF, HARD_PHONG, HARD_WAYS };
static const struct {
    const char *name;
    enum hard_way way;
    const struct glint_method *method;
} hard_ways[] = {
    {"gouraud", HARD_GOURAUD, &glint_gouraud}, {"x", HARD_X, &glint_x},          {"six", HARD_SIX, &glint_six},
    {"color6", HARD_COLOR6, &glint_color6},    {"duff", HARD_DUFF, &glint_duff}, {"phong", HARD_PHONG, &glint_phong},
    {"auto", HARD_PHONG, &glint_auto},
};
#define HARD_METHODS (sizeof hard_ways / sizeof *hard_ways)

/* The colour at barycentric coordinates, 1 for full intensity, not clamped above; *length is that of the normal,
 * *before the colour, or N.H, as it is interpolated. */
static inline double hard_value(const struct hard_case *h, const struct hard_facts *f, enum hard_way way,
                                const double l[3], double *length, double *before)
{
    double value[2] = {0, 0}, square = 1, sum = 0, n[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        const double pair = l[k] * l[next];
        square -= 4 * f->bend[k] * pair;
        for (int d = 0; d < 2; d++) {
            const double both = f->dot[d][k] + f->dot[d][next];
            value[d] += f->dot[d][k] * l[k];
            if (way == HARD_X)
                value[d] += both * f->bend[k] * pair;
            if (way == HARD_SIX)
                value[d] += both * 2 * (f->longer[k] - 1) * pair;
        }
        sum += f->corner[k] * l[k];
        if (way == HARD_COLOR6)
            sum += (4 * f->middle[k] - 2 * (f->corner[k] + f->corner[next])) * pair;
        for (int i = 0; i < 3; i++)
            n[i] += f->normal[k][i] * l[k];
    }
    *length = 1;
    *before = way == HARD_GOURAUD || way == HARD_COLOR6 ? sum : value[1];
    if (way == HARD_GOURAUD || way == HARD_COLOR6)
        return sum;
    if (way == HARD_DUFF)
        *length = sqrt(fmax(square, 1e-18));
    if (way == HARD_PHONG)
        *length = sqrt(fmax(hard_dot(n, n), 1e-18));
    return hard_colour(h, value[0] / *length, value[1] / *length);
}

#endif
