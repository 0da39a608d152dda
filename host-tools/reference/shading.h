/* SPDX-License-Identifier: MIT */
/*
 * The colour of a point in double precision: the formula of struct scene_material, for one triangle under its lights.
 * What a method makes of the normals between the corners is in colour.c, dots.c, normal.c, scan.c and subdivide.c.
 */
#ifndef SHADING_H
#define SHADING_H

#include "reference/decode.h"
#include "reference/peak.h"
#include "reference/quadratic.h"

struct method;

/* One triangle, ready to be shaded at any point. Each method fills what it needs of the quadratics. */
struct shading {
    const struct method *method;
    const struct decode_view *view;
    unsigned channels;
    /* The material under each light. With one channel, the Rec. 601 luma of these products. */
    double texel[3]; /* of the pixel in hand: times ambient and diffuse light; 1 where there is none */
    double ambient[3], diffuse[SCENE_MAX_LIGHTS][3], specular[SCENE_MAX_LIGHTS][3], shininess;
    struct decode_vertex corner[3];
    double bend[3]; /* (1 - Ni.Nj) / 2 of the edges */
    unsigned edges; /* biquadratic: that may be quadratic, a bit each */
    /* What subdivision asks for. */
    double tolerance;                                /* of colour, at the centre */
    double part_area;                                /* in pixels, not larger */
    bool highlight;                                  /* can reach it */
    struct peak peak;                                /* of subdivide-highlight */
    double place[3][2];                              /* of the corners in the picture, pixels to the right and down */
    struct quadratic colour[3];                      /* of the channels */
    struct quadratic dot[SCENE_MAX_LIGHTS][2];       /* N.L [0] and N.H [1] of the lights */
    struct quadratic normal[3];                      /* of the components */
    struct quadratic square;                         /* |N|^2 */
    bool bumped;                                     /* the material has a bump map, and the method draws it: */
    struct quadratic turned[SCENE_MAX_LIGHTS][2][3]; /* L' [0] and H' [1] of the lights */
    double relief[3];                                /* the map's normal at the pixel in hand */
};

/* Red, green and blue as they are, or with one channel their Rec. 601 luma. */
void shading_channels(const double rgb[3], unsigned channels, double *out);

/* The material under each light. The rest is shading_setup()'s, but what subdivision asks for, the caller's. */
void shading_material(struct shading *shading, const struct decode_view *view, const struct decode_material *material,
                      unsigned channels);

void shading_setup(struct shading *shading, const struct method *method, const struct decode_vertex corner[3],
                   const double bend[3], double place[3][2]);

/* The directions towards the light and half-way to the viewer, unit, at a point. */
void shading_directions(const struct decode_view *view, const struct decode_light *light, const double point[3],
                        double towards[2][3]);

/* N.L [0] and N.H [1] under one light, its direction and the half vector unit at that very position. */
void shading_dots(const struct shading *shading, unsigned light, const double position[3], const double normal[3],
                  double dots[2]);

/* The colour, 0..1 a channel, for the dot products of every light. Clamped here, after interpolation: a dot product
 * between corners may rightly be negative, and interpolated it may pass 1. */
void shading_colour(const struct shading *shading, double dots[][2], double colour[3]);

/* Both together: the colour of a point with this normal. */
void shading_point(const struct shading *shading, const double position[3], const double normal[3], double colour[3]);

/* Linear between corners: the position and the normal, which is not made unit. */
struct decode_vertex shading_mix(const struct decode_vertex corner[3], const double at[3]);

/* The middle of edge e, its normal not made unit. */
struct decode_vertex shading_middle(const struct decode_vertex corner[3], unsigned e);

#endif
