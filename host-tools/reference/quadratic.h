/* SPDX-License-Identifier: MIT */
/*
 * The quadratic through six samples, at a triangle's corners and at the middles of its edges, in barycentric form:
 *   sum corner[i] at[i] + sum bulge[e] at[e] at[e + 1]
 * It is eq. 16 and 17 of "Fast Near Phong-Quality Software Shading" without an order of the corners. Edge e runs from
 * corner e to e + 1 (mod 3).
 */
#ifndef QUADRATIC_H
#define QUADRATIC_H

struct quadratic {
    double corner[3];
    double bulge[3]; /* by how much the middle of the edge lies above the mean of its ends, times 4 */
};

static inline void quadratic_middle(struct quadratic *q, unsigned e, double middle)
{
    q->bulge[e] = 4 * (middle - (q->corner[e] + q->corner[(e + 1) % 3]) / 2);
}

static inline double quadratic_linear(const double corner[3], const double at[3])
{
    return at[0] * corner[0] + at[1] * corner[1] + at[2] * corner[2];
}

static inline double quadratic_value(const struct quadratic *q, const double at[3])
{
    return quadratic_linear(q->corner, at) + at[0] * at[1] * q->bulge[0] + at[1] * at[2] * q->bulge[1] +
           at[2] * at[0] * q->bulge[2];
}

#endif
