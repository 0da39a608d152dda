/* SPDX-License-Identifier: MIT */
/*
 * The set-ups of Table 1 of Hast, Barrera and Bengtsson (2002, "B"), on the type `real` of formulas.h: all that
 * stepping a quadratic along the left edges and the spans needs, here of the square of a linearly interpolated vector
 * (Phong's denominator). Actual triangle: the vector's screen gradients, their dot products, and Abbas and others'
 * increments (2001, section 4). Ortho-normalised: B eq. 36-42 (f = C.C), and increments from u, v directly. One edge on
 * the left or two.
 */
#ifndef STEPS_H
#define STEPS_H

#include "formulas.h"

/* Along one left edge: the value, its step to the next row and that step's; the step to the right, and its by row. */
struct step_edge {
    real value, step, second, right, right_step;
};

struct step_variables {
    real right_second; /* of all rows */
    struct step_edge edge[2];
};

/* Increments along (dx, dy) of the row's next, from (x, y). */
static inline void step_start(const struct real_quadratic *q, real x, real y, real dx, struct step_edge *out)
{
    const real square = q->a * dx * dx + q->c * dx + q->b;
    out->step = square + (2 * q->a * x + q->c * y + q->d) * dx + q->c * x + 2 * q->b * y + q->e;
    out->second = 2 * square;
    out->right = 2 * q->a * x + q->c * y + q->a + q->d;
    out->right_step = 2 * q->a * dx + q->c;
}

static inline void step_square(const real *x, const real *y, const real *l, struct real_quadratic *q)
{
    q->a = real_dot(x, x);
    q->b = real_dot(y, y);
    q->c = 2 * real_dot(x, y);
    q->d = 2 * real_dot(x, l);
    q->e = 2 * real_dot(y, l);
    q->f = real_dot(l, l);
}

static inline void step_actual(const struct real_case *c, struct step_variables *out, int edges)
{
    const real w = 1 / (c->x1 * c->y2 - c->x2 * c->y1);
    real gx[3], gy[3];
    struct real_quadratic q;
    for (int i = 0; i < 3; i++) {
        const real a = c->n[1][i] - c->n[0][i], b = c->n[2][i] - c->n[0][i];
        gx[i] = (a * c->y2 - b * c->y1) * w;
        gy[i] = (b * c->x1 - a * c->x2) * w;
    }
    step_square(gx, gy, c->n[0], &q);
    out->right_second = 2 * q.a;
    out->edge[0].value = q.f;
    if (edges == 1) {
        step_start(&q, 0, 0, c->x2 / c->y2, &out->edge[0]);
        return;
    }
    step_start(&q, 0, 0, c->x1 / c->y1, &out->edge[0]);
    out->edge[1].value = real_dot(c->n[1], c->n[1]);
    step_start(&q, c->x1, c->y1, (c->x2 - c->x1) / (c->y2 - c->y1), &out->edge[1]);
}

/* On the edge where u = 0, v = n dv; where v = 0, u = n du; from (1, 0) on, both, du = -dv. */
static inline void step_ortho(const struct real_case *c, struct step_variables *out, int edges)
{
    const real w = 1 / (c->x1 * c->y2 - c->x2 * c->y1), au = c->y2 * w, av = -c->y1 * w;
    real a[3], b[3];
    struct real_quadratic q;
    for (int i = 0; i < 3; i++) {
        a[i] = c->n[1][i] - c->n[0][i];
        b[i] = c->n[2][i] - c->n[0][i];
    }
    step_square(a, b, c->n[0], &q);
    const real square = q.a * au * au + q.b * av * av + q.c * au * av;
    const real in_u = 2 * q.a * au + q.c * av, in_v = 2 * q.b * av + q.c * au;
    out->right_second = 2 * square;
    struct step_edge *e = &out->edge[0];
    e->value = q.f;
    e->right = square + q.d * au + q.e * av;
    if (edges == 1) {
        const real dv = 1 / c->y2, bend = q.b * dv * dv;
        e->step = bend + q.e * dv;
        e->second = 2 * bend;
        e->right_step = in_v * dv;
        return;
    }
    const real du = 1 / c->y1, bend = q.a * du * du;
    e->step = bend + q.d * du;
    e->second = 2 * bend;
    e->right_step = in_u * du;
    const real dv = 1 / (c->y2 - c->y1), lower = (q.a + q.b - q.c) * dv * dv;
    struct step_edge *next = &out->edge[1];
    next->value = q.a + q.d + q.f;
    next->step = lower + (q.c + q.e - 2 * q.a - q.d) * dv;
    next->second = 2 * lower;
    next->right = e->right + in_u;
    next->right_step = (in_v - in_u) * dv;
}

#define STEP(name, way, edges)                                                    \
    static int step_##name(const struct real_case *c, struct step_variables *out) \
    {                                                                             \
        way(c, out, edges);                                                       \
        return 1;                                                                 \
    }
STEP(actual_1, step_actual, 1)
STEP(actual_2, step_actual, 2)
STEP(ortho_1, step_ortho, 1)
STEP(ortho_2, step_ortho, 2)

struct step_setup {
    const char *name;
    int edges;
    int (*setup)(const struct real_case *c, struct step_variables *out);
};
static const struct step_setup step_setups[] = {{"actual-1", 1, step_actual_1},
                                                {"ortho-1", 1, step_ortho_1},
                                                {"actual-2", 2, step_actual_2},
                                                {"ortho-2", 2, step_ortho_2}};
#define STEP_SETUPS (sizeof step_setups / sizeof step_setups[0])

#endif
