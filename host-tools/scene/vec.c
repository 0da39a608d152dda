/* SPDX-License-Identifier: MIT */
#include "scene/vec.h"

#include <math.h>
#include <string.h>

double vec_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void vec_sub(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[k] - b[k];
}

void vec_cross(const double a[3], const double b[3], double out[3])
{
    double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    memcpy(out, c, sizeof c);
}

/* Scaled by the largest component: a triangle of 1e-160 units still has a normal. */
double vec_length(const double v[3])
{
    double most = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    if (!(most > 0) || !isfinite(most))
        return most;
    double s[3] = {v[0] / most, v[1] / most, v[2] / most};
    return most * sqrt(vec_dot(s, s));
}

bool vec_normalise(double v[3])
{
    double length = vec_length(v);
    if (!(length > 0) || !isfinite(length) || isnan(v[0]) || isnan(v[1]) || isnan(v[2]))
        return false;
    for (int k = 0; k < 3; k++)
        v[k] /= length;
    return true;
}

void vec_quat_axis(const double axis[3], double radians, double out[4])
{
    out[0] = cos(radians / 2);
    for (int k = 0; k < 3; k++)
        out[k + 1] = axis[k] * sin(radians / 2);
}

void vec_quat_multiply(const double a[4], const double b[4], double out[4])
{
    double q[4] = {
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    };
    memcpy(out, q, sizeof q);
}

void vec_quat_rotate(const double q[4], const double v[3], double out[3])
{
    const double inverse[4] = {q[0], -q[1], -q[2], -q[3]};
    double p[4] = {0, v[0], v[1], v[2]};
    vec_quat_multiply(q, p, p);
    vec_quat_multiply(p, inverse, p);
    memcpy(out, p + 1, 3 * sizeof *out);
}

void vec_quat_rows(const double m[3][3], double out[4])
{
    /* The largest component first, so that nothing is divided by a small number. */
    double trace = m[0][0] + m[1][1] + m[2][2];
    int i = trace > 0 ? -1 : m[0][0] > m[1][1] ? (m[0][0] > m[2][2] ? 0 : 2) : (m[1][1] > m[2][2] ? 1 : 2);
    if (i < 0) {
        double w = sqrt(1 + trace) / 2;
        out[0] = w;
        out[1] = (m[2][1] - m[1][2]) / (4 * w);
        out[2] = (m[0][2] - m[2][0]) / (4 * w);
        out[3] = (m[1][0] - m[0][1]) / (4 * w);
        return;
    }
    int j = (i + 1) % 3, k = (i + 2) % 3;
    double s = sqrt(1 + m[i][i] - m[j][j] - m[k][k]) / 2;
    out[0] = (m[k][j] - m[j][k]) / (4 * s);
    out[i + 1] = s;
    out[j + 1] = (m[j][i] + m[i][j]) / (4 * s);
    out[k + 1] = (m[k][i] + m[i][k]) / (4 * s);
}
