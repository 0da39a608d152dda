/* SPDX-License-Identifier: MIT */
/*
 * The truth: a renderer in double precision of the packed scene, that is, of the very mesh that the integer renderer
 * draws (decode.h). Vertices are projected in double and then snapped to 28.4 by floor(16 x + 1/2) relative to the
 * picture's centre, x right and y down, so that both draw the same pixels: centres at 1/2, top and left edges
 * inclusive, triangles without positive area on the grid culled. Clipping, depth and shading stay in double, per pixel.
 *
 * Beside per-pixel Phong, with the normal interpolated correctly in perspective, it draws what ideal arithmetic makes
 * of the other methods, which interpolate over the snapped triangle in the picture or, if their names say so, over the
 * triangle in space.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "scene/scene.h"

#include <stdbool.h>

/* Named and described in method.c. */
enum reference_method {
    REFERENCE_PHONG,
    REFERENCE_GOURAUD,
    REFERENCE_X,
    REFERENCE_SIX,
    REFERENCE_COLOR6,
    REFERENCE_DUFF,
    REFERENCE_OVERVELD,
    REFERENCE_OVERVELD_SCAN,
    REFERENCE_BIQUADRATIC,
    REFERENCE_PHONG_SCREEN,
    REFERENCE_X_PERSPECTIVE,
    REFERENCE_SIX_PERSPECTIVE,
    REFERENCE_DUFF_PERSPECTIVE,
    REFERENCE_BIQUADRATIC_PERSPECTIVE,
    REFERENCE_BUMP_LINEAR,
    REFERENCE_BUMP_QUADRATIC,
    REFERENCE_BUMP_FRAMES,
    REFERENCE_BUMP_UPRIGHT,
    REFERENCE_BUMP_NORMALISED,
    REFERENCE_SUBDIVIDE_RECURSIVE,
    REFERENCE_SUBDIVIDE_CENTRE,
    REFERENCE_SUBDIVIDE_REGULAR,
    REFERENCE_SUBDIVIDE_HIGHLIGHT,
    REFERENCE_HYBRID_PHONG,
    REFERENCE_HYBRID_X,
    REFERENCE_METHODS
};

struct reference_options {
    unsigned width, height; /* 1..2048; both 0: the camera's reference size */
    uint32_t time_ms;
    enum reference_method method;
    double tolerance;    /* of subdivide-centre, in 1/255; 0: 4 */
    double part_area;    /* of subdivide-recursive and -regular, in pixels; 0: 32 */
    bool grey;           /* shade one channel: Rec. 601 luma of the material's colours under each light */
    bool every_zigzag;   /* of biquadratic: bend every edge that passes the test by itself */
    uint16_t yaw, pitch; /* every object turned as glint_turn() says, in 1/65536 turns */
    /* Null, or [height][width]: which triangle the integer renderer drew at each pixel, counted through all objects;
     * REFERENCE_NOTHING: none. Then the picture is of these, at these pixels, so that what is compared is shading
     * alone: where two surfaces meet in one depth or an edge in a pixel's centre, roundings say which is seen. */
    const uint32_t *drawn;
    /* Null, or with `drawn`: where it placed each vertex, x and y in 28.4 from the picture's centre, counted through
     * all objects. Taken where it is the true place rounded either way, to within 1/64 of a step: a sliver whose corner
     * is all but half-way between two steps is another triangle after the other rounding. */
    const int16_t (*placed)[2];
    /* Textures and bump maps without filter are sampled that much beside, in texels: where a coordinate is all but on a
     * texel's border, its rounding says on which side. */
    double nudge[2];
};

#define REFERENCE_NOTHING UINT32_MAX

struct reference_image {
    unsigned width, height, channels;
    double *value;    /* [height][width][channels], 0..1, not rounded */
    uint8_t *covered; /* [height][width], 1 where a triangle was drawn */
    size_t coverage;  /* pixels covered */
};

/* Renders a checked scene. False: out of memory, and nothing to free. */
bool reference_render(const struct scene_header *scene, const struct reference_options *options,
                      struct reference_image *image);

void reference_free(struct reference_image *image);

/* A value as an 8-bit display shows it. */
uint8_t reference_byte(double value);

#endif
