/* SPDX-License-Identifier: MIT */
/* Vectors and quaternions (w, x, y, z) in double precision. Outputs may be inputs. */
#ifndef VEC_H
#define VEC_H

#include "scene/model.h"

double vec_dot(const double a[3], const double b[3]);
void vec_sub(const double a[3], const double b[3], double out[3]);
void vec_cross(const double a[3], const double b[3], double out[3]);
double vec_length(const double v[3]);
/* Makes v unit; false, and v untouched, when it is zero or not finite. */
bool vec_normalise(double v[3]);

/* The rotation by `radians` about the unit axis. */
void vec_quat_axis(const double axis[3], double radians, double out[4]);
/* First b, then a. */
void vec_quat_multiply(const double a[4], const double b[4], double out[4]);
void vec_quat_rotate(const double q[4], const double v[3], double out[3]);
/* Of a rotation matrix given by its rows. */
void vec_quat_rows(const double rows[3][3], double out[4]);

#endif
