/* SPDX-License-Identifier: MIT */
#include "reference/curve.h"

#include <math.h>

#define CURVE_STEPS 500

/* The middle of the edge stretched so much that its norm is as wanted, at s of the way along the edge, from the unit
 * vector there. Cosine and sine of half the angle; the bisector is the first axis, so that the mean is (cosine, 0). */
static double curve_distance(double cosine, double sine, double norm, double s)
{
    double x = cosine + 4 * (norm - cosine) * s * (1 - s), linear_x = cosine, y = sine * (2 * s - 1);
    double length = hypot(linear_x, y);
    return hypot(x - linear_x / length, y - y / length);
}

static double curve_error(double cosine, double sine, double norm)
{
    double largest = 0;
    for (int i = 0; i <= CURVE_STEPS; i++)
        largest = fmax(largest, curve_distance(cosine, sine, norm, (double)i / CURVE_STEPS));
    return largest;
}

struct curve_point curve_x(double degrees)
{
    double half = degrees * acos(-1) / 360, cosine = cos(half), sine = sin(half);
    double norm = cosine * (5 - cos(2 * half)) / 4; /* eq. 27: |N1 + N2| is twice the cosine */
    return (struct curve_point){.norm = norm,
                                .linear_norm = cosine,
                                .error = curve_error(cosine, sine, norm),
                                .six_error = curve_error(cosine, sine, 1),
                                .linear_error = curve_error(cosine, sine, cosine)};
}
