/* SPDX-License-Identifier: MIT */
/* A triangle, a light and a viewer, and in double precision what is half-way between them. */
#ifndef HIGHLIGHT_CASE_H
#define HIGHLIGHT_CASE_H

#include "plan/summit.h"
#include "random.h"

#include <math.h>
#include <string.h>

static struct object_state object;
static struct highlighted_point corner[3];

/* What the test is given, exactly: a direction in Q14 or a place. */
static inline void far_at(struct object_point *point)
{
    double v[3];
    random_direction(v, 3);
    for (int i = 0; i < 3; i++)
        point->at[i] = (int32_t)lrint(v[i] * 16384);
    point->near = 0;
}

static inline void near_at(struct object_point *point, double distance)
{
    double v[3];
    random_direction(v, 3);
    for (int i = 0; i < 3; i++)
        point->at[i] = (int32_t)lrint(v[i] * distance);
    point->near = 1;
}

static inline double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static inline void unit(double v[3])
{
    double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

static inline void way(const struct object_point *to, const double place[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = to->near ? to->at[i] - place[i] : to->at[i];
}

/* Place, normal, ways to light and viewer at weights of the corners. */
struct real_point {
    double place[3], normal[3], light[3], eye[3];
};

static inline struct real_point at_weights(const double weight[3])
{
    struct real_point p;
    for (int i = 0; i < 3; i++) {
        p.place[i] = p.normal[i] = 0;
        for (int k = 0; k < 3; k++) {
            p.place[i] += weight[k] * corner[k].place[i];
            p.normal[i] += weight[k] * corner[k].normal[i];
        }
    }
    way(&object.light[0].source, p.place, p.light);
    way(&object.eye, p.place, p.eye);
    return p;
}

/* The cosine of normal and half-way vector. */
static inline double cosine(const double weight[3])
{
    struct real_point p = at_weights(weight);
    double half[3];
    unit(p.normal);
    unit(p.light);
    unit(p.eye);
    for (int i = 0; i < 3; i++)
        half[i] = p.light[i] + p.eye[i];
    unit(half);
    return dot(p.normal, half);
}

/* A triangle as a mesh has them, the corners' normals within `spread` of one direction. */
static inline void random_corners(double spread, int size)
{
    double axis[3];
    int32_t middle[3];
    random_direction(axis, 3);
    for (int i = 0; i < 3; i++)
        middle[i] = random_between(size - 32768, 32767 - size);
    for (int k = 0; k < 3; k++) {
        double off[3], n[3];
        random_direction(off, 3);
        for (int i = 0; i < 3; i++) {
            n[i] = axis[i] + spread * off[i];
            corner[k].place[i] = middle[i] + random_between(-size, size);
        }
        unit(n);
        for (int i = 0; i < 3; i++)
            corner[k].normal[i] = (int32_t)lrint(n[i] * 16384);
    }
}

static inline int passes(void)
{
    struct highlighted_signs s[3];
    for (int k = 0; k < 3; k++)
        s[k] = highlighted_signs(&object, 1, &corner[k]);
    return highlighted_lights(&s[0], &s[1], &s[2]) == 1;
}

/* Where the normal is along the half-way vector of far light and viewer: weights, all >= 0 inside; 0 if nowhere. */
static inline int solve_far(double weight[3])
{
    const double centre[3] = {1 / 3., 1 / 3., 1 / 3.};
    struct real_point p = at_weights(centre);
    double half[3], n[3][3], side[3], sum = 0;
    unit(p.light);
    unit(p.eye);
    for (int i = 0; i < 3; i++)
        half[i] = p.light[i] + p.eye[i];
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            n[k][i] = corner[k].normal[i];
    cross(n[1], n[2], side);
    double det = dot(n[0], side);
    if (det == 0)
        return 0;
    for (int k = 0; k < 3; k++) {
        cross(n[(k + 1) % 3], n[(k + 2) % 3], side);
        weight[k] = dot(half, side) / det;
        sum += weight[k];
    }
    for (int k = 0; k < 3; k++)
        weight[k] /= sum;
    return sum > 0;
}

static inline int inside(const double weight[3])
{
    return weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0;
}

/* A viewer that sees the highlight somewhere about the triangle: the light's mirror image in a normal near it. */
static inline void aim_far_viewer(void)
{
    const double weight[3] = {random_real(-.5, 1), random_real(-.5, 1), random_real(-.5, 1)};
    struct real_point p = at_weights(weight);
    double v[3];
    unit(p.normal);
    unit(p.light);
    for (int i = 0; i < 3; i++)
        v[i] = 2 * dot(p.normal, p.light) * p.normal[i] - p.light[i];
    for (int i = 0; i < 3; i++)
        object.eye.at[i] = (int32_t)lrint(v[i] * 16384);
    object.eye.near = 0;
}

/* The brightest point inside, by trial: 1 if it is a highlight's centre, with normal and half-way vector as one. */
static inline int find_brightest(double best[3])
{
    double most = -2;
    for (int i = 1; i < 10; i++)
        for (int j = 1; i + j < 10; j++) {
            const double weight[3] = {i / 10., j / 10., 1 - i / 10. - j / 10.};
            double c = cosine(weight);
            if (c > most) {
                most = c;
                memcpy(best, weight, sizeof weight);
            }
        }
    for (double step = .05; step > 1e-5;) {
        static const int ways[6][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}};
        int better = 0;
        for (int w = 0; w < 6; w++) {
            double weight[3] = {best[0] + step * ways[w][0], best[1] + step * ways[w][1], 0};
            weight[2] = 1 - weight[0] - weight[1];
            double c = inside(weight) ? cosine(weight) : -2;
            if (c > most) {
                most = c;
                memcpy(best, weight, sizeof weight);
                better = 1;
            }
        }
        step = better ? step : step / 2;
    }
    struct real_point p = at_weights(best);
    return most > 1 - 1e-9 && dot(p.light, p.normal) > 0;
}

/* A viewer, far or near, that sees the light's mirror image about the middle. */
static inline void aim_viewer(double distance)
{
    const double weight[3] = {random_real(0, .6), random_real(0, .6), random_real(0, .6)};
    struct real_point p = at_weights(weight);
    double v[3];
    unit(p.normal);
    unit(p.light);
    object.eye.near = distance > 0;
    for (int i = 0; i < 3; i++) {
        v[i] = 2 * dot(p.normal, p.light) * p.normal[i] - p.light[i];
        object.eye.at[i] = (int32_t)lrint(distance > 0 ? p.place[i] + v[i] * distance : v[i] * 16384);
    }
}

#endif
