/* SPDX-License-Identifier: MIT */
/* One triangle into the picture: near clip, projection, snapping, coverage, depth. reference.h says by which rules. */
#ifndef TRIANGLE_H
#define TRIANGLE_H

#include "reference/decode.h"
#include "reference/method.h"

struct triangle_target {
    struct reference_image *image;
    const struct decode_view *view;
    const struct method *method;
    double tolerance, part_area;     /* as in struct shading */
    bool highlight;                  /* can reach the next triangle */
    bool every_zigzag;               /* whatever the mesh says of its edges */
    unsigned edges;                  /* of the next triangle, that may be quadratic, a bit each */
    const uint32_t *drawn;           /* as in struct reference_options */
    double nudge[2];                 /* as in struct reference_options */
    uint32_t triangle;               /* the next one's number */
    const int16_t (*placed)[2];      /* the same, of the object in hand */
    const int16_t *corner_placed[3]; /* and of the triangle's corners */
    /* With `drawn`, the smallest barycentric coordinate in what the near plane left of the triangle; else: */
    double *depth; /* closeness: 1 / distance in perspective, else - distance; -infinity where nothing is */
};

/* `bend` as decode_bend() gives it for the three edges. Both may be turned round, where the back of it is seen. */
void triangle_draw(struct triangle_target *target, const struct decode_material *material,
                   struct decode_vertex corner[3], double bend[3]);

#endif
