/* SPDX-License-Identifier: MIT */
/* What each method makes of the normals between a triangle's corners: the table, and the functions it is made of. */
#ifndef METHOD_H
#define METHOD_H

#include "reference/bump.h"
#include "reference/reference.h"
#include "reference/shading.h"

struct method {
    const char *name, *summary;
    bool perspective; /* interpolates over the triangle in space, else over its picture */
    bool highlight;   /* asks which triangles a highlight can reach */
    void (*setup)(struct shading *shading);
    /* The colour, 0..1 a channel, where the barycentric coordinates are `at`: in space or in the picture. */
    void (*pixel)(const struct shading *shading, const double at[3], double colour[3]);
    enum bump_kind bump; /* how it draws materials with a bump map, in place of these */
};

/* By enum reference_method. */
extern const struct method methods[REFERENCE_METHODS];

/* The place of a name in that table, or -1. */
int method_find(const char *name);

/* colour.c: finished colour */
void colour_setup_linear(struct shading *shading);
void colour_setup_quadratic(struct shading *shading);
void colour_setup_part(struct shading *shading, bool quadratic); /* where corners' normals are not unit */
void colour_pixel(const struct shading *shading, const double at[3], double colour[3]);

/* dots.c: N.L and N.H */
void dots_setup_x(struct shading *shading);
void dots_setup_six(struct shading *shading);
void dots_setup_duff(struct shading *shading);
void dots_pixel(const struct shading *shading, const double at[3], double colour[3]);
void dots_pixel_duff(const struct shading *shading, const double at[3], double colour[3]);

/* normal.c: the normal, made unit per pixel */
void normal_setup_linear(struct shading *shading);
void normal_setup_overveld(struct shading *shading);
void normal_setup_biquadratic(struct shading *shading);
void normal_pixel(const struct shading *shading, const double at[3], double colour[3]);
void normal_pixel_scan(const struct shading *shading, const double at[3], double colour[3]);

/* subdivide.c: smaller triangles where that shows, or a better method */
void subdivide_pixel_size(const struct shading *shading, const double at[3], double colour[3]);
void subdivide_pixel_centre(const struct shading *shading, const double at[3], double colour[3]);
void subdivide_setup_highlight(struct shading *shading);
void subdivide_pixel_highlight(const struct shading *shading, const double at[3], double colour[3]);
void subdivide_setup_regular(struct shading *shading);
void subdivide_setup_hybrid_phong(struct shading *shading);
void subdivide_setup_hybrid_x(struct shading *shading);

#endif
