/* SPDX-License-Identifier: MIT */
/*
 * What becomes of the normal between two unit normals at an angle, by method: "Fast Near Phong-Quality Software
 * Shading", Fig. 3 (the norm of the middle vector), and the error that follows from it.
 */
#ifndef CURVE_H
#define CURVE_H

/* Errors are the largest difference of N.L from Phong's along the edge, under the worst light: that is the largest
 * distance between the vectors that L is multiplied with. */
struct curve_point {
    double norm;         /* of X's middle vector; Phong's is 1 */
    double linear_norm;  /* of the mean of the normals */
    double error;        /* of X */
    double six_error;    /* of the quadratic through the true middle */
    double linear_error; /* of Gouraud's N.L */
};

/* 0 <= degrees < 180 between the normals. */
struct curve_point curve_x(double degrees);

#endif
