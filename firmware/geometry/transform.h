/* SPDX-License-Identifier: MIT */
/*
 * From a mesh's int16 positions to the screen, in 32-bit products only.
 *
 * An object's transform is kept in block floating point: x and y rows already multiplied by the focal length and by 16
 * (sub-pixels), z measured forward from the eye; each fits |value| < 2^29 with the exponent chosen for the object, or
 * 2^29 + 2^13 as rotations may be a little too long, so that a vertex is placed to a small fraction of a sub-pixel
 * however large or far the object is.
 */
#ifndef GLINT_TRANSFORM_H
#define GLINT_TRANSFORM_H

#include "geometry/rotation.h"
#include "uses.h"

/*
 * Screen coordinates are 28.4, relative to the picture's centre, x right, y down; the guard band reaches this far. What
 * is cut there may be rounded out by a sub-pixel: differences stay within 2^15.
 */
#define GUARD (1024 * 16 - 1)

/* Depth 0 is what the buffer is cleared to; larger is nearer: near/z in perspective, (far - z) / (far - near) in
 * orthographic views, on DEPTH_FAR to DEPTH_NEAR. The margins keep an interpolated depth, rounding included, inside 16
 * bits. */
#define DEPTH_FAR  8
#define DEPTH_NEAR 65527

/* The camera for one frame. */
struct view {
    struct rotation rotation;
    struct matrix matrix;
    q16_t position[3];
    uint32_t focal;     /* 16 f in [2^30, 2^31) ... */
    int focal_exponent; /* ... times 2^-this */
    q16_t near_plane, far_plane;
    uint16_t kind; /* enum scene_camera_kind */
};

/* value = (hi . p) + ((lo . p) >> 14) + t for a position p. |hi| <= 2^14, 0 <= lo < 2^14, |p| <= 2^15: the lo sum is
 * below 3 * 2^29; the hi products are below 2^29 and every partial sum, the offset included, below 2^31. */
struct axis {
    int32_t hi[3], lo[3], t;
};

struct transform {
    struct axis x, y, z;
    int32_t near_z, far_z; /* in the units of the z row, at most 2^30 - 1 */
    uint32_t range;        /* far_z - near_z */
    int divide;            /* perspective: screen = (x / z) >> (shift - normalisation of z) */
    int shift;             /* orthographic: screen = x >> shift */
    uint32_t depth_scale;  /* perspective: the near plane, normalised; orthographic: (DEPTH_NEAR - DEPTH_FAR) / (far -
                              near) */
    int depth_shift;
};

/* A position in front of the near plane or not, before the divide. */
struct eye_point {
    int32_t x, y, z; /* in the units of the transform's rows */
};

/* A vertex on the screen. */
struct screen_point {
    int16_t x, y;   /* 28.4, |.| <= GUARD */
    uint16_t depth; /* DEPTH_FAR..DEPTH_NEAR */
};

/* Whether the view is a perspective one. */
static inline int transform_divides(const struct transform *t)
{
    return USES(USES_PERSPECTIVE) && (!USES(USES_ORTHOGRAPHIC) || t->divide);
}

/* The camera of a scene for a picture of this size. */
void view_setup(struct view *view, const struct scene_header *scene, uint16_t width, uint16_t height);

/* The transform of a mesh in a pose; 0 if all of its bounding sphere lies before the near plane, behind the far
 * plane, or out of the numbers' range. `world` receives the matrix from mesh axes to eye axes. */
int transform_setup(struct transform *out, const struct view *view, const struct scene_mesh *mesh,
                    const struct pose *pose, struct matrix *to_eye);

static inline int32_t axis_value(const struct axis *r, int32_t px, int32_t py, int32_t pz)
{
    return r->t + r->hi[0] * px + r->hi[1] * py + r->hi[2] * pz +
           ((r->lo[0] * px + r->lo[1] * py + r->lo[2] * pz) >> 14);
}

static inline struct eye_point transform_point(const struct transform *t, const int16_t p[3])
{
    int32_t x = p[0], y = p[1], z = p[2];
    struct eye_point e = {axis_value(&t->x, x, y, z), axis_value(&t->y, x, y, z), axis_value(&t->z, x, y, z)};
    return e;
}

#endif
