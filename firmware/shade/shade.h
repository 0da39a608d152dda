/* SPDX-License-Identifier: MIT */
/* What a method's set-up is given, and what it leaves for the pixels. */
#ifndef GLINT_SHADE_H
#define GLINT_SHADE_H

#include "plan/plan.h"
#include "shade/plane.h"
#include "shade/surface.h"

/* A piece of a triangle made by clipping: three corners of the clipped polygon. */
struct clipped_triangle {
    uint16_t source; /* the mesh's triangle */
    uint16_t reserved;
    int16_t place[3][3];   /* x, y, depth as in a vertex record */
    uint16_t weight[3][2]; /* of each corner: barycentric in the source triangle, Q15, the third what is left to 1 */
    int8_t finer[3][2];    /* what they were rounded by, Q23 */
};

/* A finished colour, and the material's number where it is kept behind a vertex record's lights. */
#define COLOUR_WORDS 4

/* What a method may keep in a vertex record behind the lights: a finished colour, and a mark of the adaptive ones. */
#define SHADE_VERTEX_WORDS (COLOUR_WORDS + 1)

/*
 * A triangle seen from behind, as one that was built to face that way: corners 0, 2, 1 of the mesh's, normals and dot
 * products negated. All methods take it for a triangle of a mesh of three vertices.
 */
struct shade_turned {
    struct scene_triangle triangle;
    struct scene_vertex vertex[3];
    int16_t uv[3][2];
    struct scene_tangent tangent[USES(USES_BUMP) ? 3 : 1]; /* turned round with the normal: the slopes stay the map's */
    int16_t lights[3][USES(USES_TWO_SIDED) ? 2 * SCENE_MAX_LIGHTS + SHADE_VERTEX_WORDS : 1];
};

/* A triangle to be shaded. Corners stand clockwise on the screen (y down), so that determinants are positive. */
struct shade_input {
    const int16_t *place[3];               /* x, y, depth of the corners */
    int16_t *lights[3];                    /* N.L and N.H, Q14, of the source triangle's corners, in the same turn */
    const struct scene_triangle *triangle; /* the source; its edges stand in `bend` as 2, 1, 0 */
    const struct scene_vertex *vertices;   /* of its mesh */
    const struct clipped_triangle *piece;  /* null: the corners are the source's */
    const uint16_t (*weight)[3];           /* null: the corners are the source's */
    const int16_t (*uvs)[2];               /* of its mesh, Q12; null: none */
    const struct scene_tangent *tangents;  /* likewise; for bump maps */
    const struct object_state *object;
    const struct surface *surface;
    uint16_t (
        *colours)[COLOUR_WORDS]; /* for finished colours; null: they are kept with the vertices, one CPU's alone */
    struct shade_plan plan;      /* glint_auto: what this triangle takes */
    uint8_t texture;             /* enum glint_texture: how the triangle's coordinates are to be interpolated */
    uint8_t divides;             /* the view is a perspective one */
    uint8_t no_plan;             /* keep effects that cannot show */
    uint8_t every_zigzag;        /* GLINT_EVERY_ZIGZAG */
    uint8_t tabled;              /* a colour table holds the material's power, of N.H itself */
    uint8_t grey_table;          /* there is a table for 8-bit grey */
    uint8_t sampled; /* mid-edges may need a look of their own: something is near, or the power has another form */
};

/* The corners' weights in the source; null: they are its own. */
static inline const uint16_t (*shade_weight(const struct shade_input *in))[3]
{
    return USES(USES_CLIPPING) ? in->weight : 0;
}

/* Which of the source's corners is the input's corner k. */
#define SHADE_TURN(k) ((k) ? 3 - (k) : 0)

/* Turns the triangle of an input round, whose places and lights are those of corners 0, 2, 1 of the mesh's; `words` of
 * a vertex record are the method's. The colour that one keeps is not that of the back: the copy has none. */
void shade_turn(struct shade_turned *turned, struct shade_input *in, unsigned words);

/* Channels: per light N.L then N.H (x, six, duff), finished colours (gouraud, color6), or the normal's components
 * and the place's (phong, overveld, biquadratic). */
#define SHADE_MAX_CHANNELS (2 * SCENE_MAX_LIGHTS + 1)
#define SHADE_WEIGHT       6                      /* beside places in perspective: W of shade/perspective.h, Q30 */
#define SHADE_SQUARE       (2 * SCENE_MAX_LIGHTS) /* duff: the squared length of the normal */

/* bump mapping: for each light L' and H' in the moving frame, Q30; behind them, of a light alone, their squared lengths
 * (shade/bump.h) */
#define SHADE_BUMP_LIGHTS   (USES(USES_SEVERAL_LIGHTS) ? SCENE_MAX_LIGHTS : 1)
#define SHADE_BUMP_CHANNELS (USES(USES_BUMP) ? 6 * SHADE_BUMP_LIGHTS + 2 : 1)

/*
 * Normals quadratic over the triangle, N = sum ni li - sum bij li lj: component `axis` of corner k, Q14, and the bulges
 * of the edges 0-1, 1-2, 2-0, Q28. As bij = 3 P (ni + nj) with P a projection on some line, N = sum li (1 - 3 sum lj
 * Pij) ni,   so that |N| <= sum li max(1, 2 - 3 li) <= 7/6, in a piece of the triangle too. Bulges are at most 6.1,
 * those of a piece 7.7.
 */
struct normal_quadratic {
    int32_t value[3][3], bulge[3][3]; /* [axis][corner or edge] */
};

/* overveld-scan: the triangle, and the row in hand. */
struct shade_rows {
    struct normal_quadratic normal;
    int32_t place[3][3]; /* of the corners, in position units, [axis][corner] */
    struct shade_row_end {
        int32_t x;         /* 2^-8 sub-pixels from the picture's centre */
        int32_t normal[3]; /* Q28 */
        int32_t place[3];  /* Q12 position units */
    } end[2];
    int32_t bulge[3]; /* from end to end, Q28 */
    int32_t y;
    uint32_t width, up, inverse; /* of the row: 2^-8 sub-pixels; its leading zero bits; 2^63 / (width << up) */
};

/* A corner of a part that a triangle is split into: where it is in the barycentric coordinates of the triangle's
 * corners on the screen, Q15, the third being the rest; and its finished colour, Q8 steps, at most 255 * 2^8. */
struct part_corner {
    uint16_t weight[2];
    uint16_t colour[3];
};

/* A part that is or may be split into 4: corners, and the middles of its edges 01, 12, 20. */
struct part_split {
    struct part_corner corner[6];
    uint16_t next; /* the next of the 4 to be drawn */
};
#define PART_DEPTH 5 /* times that a triangle is split at most */

/* The largest S (firmware/plan/README.md, a), Q16, at which 1 - |N|^2 <= 4 S stays below 1/4, less 1/500 for the
 * channel's error: 51 degrees between three normals, 60 between two. */
#define SHADE_LENGTH_SUM 4066

struct shade_setup {
    union { /* what set-up finds out, all 0 before it */
        uint32_t found[3];
        struct {
            uint8_t perspective;     /* channels are numerators: 1 + how far closeness is moved up; 0: as they are */
            uint8_t diffuse_lights;  /* x: bit i: light i reaches the triangle */
            uint8_t specular_lights; /* x: bit i: light i's highlight does */
            uint8_t quadratic;       /* some channel bends (x: visibly); 0: all are linear */
            uint8_t folded;    /* N.H is that of a form of the power folded with this `down`; 0: the dot product */
            uint8_t wide;      /* x: N.H times 2^octave of the power, from its foot, leaves [-2, 2) */
            uint8_t runs_only; /* x: a channel that no polynomial holds, or N.H beyond what a table's loop can index */
            uint8_t in_steps;  /* N.L counts in steps of the output (shade/steps.h); where it does, */
            uint8_t plain;     /* it needs no clamp together with the ambient part */
            uint8_t length;    /* duff: SHADE_SQUARE holds 1 - |N|^2, below 1/4; numerators are linear */
            uint8_t uv_kind;   /* enum glint_texture of `uv` */
        };
    };
    struct plane plane;
    struct channel depth;
    union { /* behind the depth: raster/spans_thumb.c reads them one after the other */
        struct channel channel[SHADE_MAX_CHANNELS];
        struct channel bump[SHADE_BUMP_CHANNELS];
        struct {
            struct channel before_rows[6]; /* the place's among them */
            struct shade_rows rows;
        };
        struct { /* subdivision: colours are 3 channels, behind them there is room */
            struct channel colour[3];
            struct part_split split[PART_DEPTH + 1]; /* a stack, the part in hand on top */
        } parts;
    };
    uint32_t flat[3];                                          /* flat: the finished colour, Q15 steps */
    struct channel fog;                                        /* its part where that is linear, Q14 */
    struct channel uv[USES(USES_TEXTURE | USES_BUMP) ? 2 : 1]; /* texture coordinates: shade/uv.h */
    uint8_t uv_up;                                             /* of perspective ones: how far closeness is moved up */
};

/* Whether no light but the first shows: the triangle is then drawn as under one light. Once the others are set up. */
static inline int shade_alone(const struct shade_setup *setup)
{
    return !USES(USES_SEVERAL_LIGHTS) || (setup->diffuse_lights | setup->specular_lights) <= 1;
}

/* The lights whose highlight shows. */
static inline unsigned shade_specular(const struct shade_setup *setup)
{
    return USES(USES_SPECULAR) ? setup->specular_lights : 0;
}

/* Each fills the channels it needs; plane and depth are done. */
void shade_flat(struct shade_setup *setup, const struct shade_input *in);
void shade_gouraud(struct shade_setup *setup, const struct shade_input *in);
void shade_planned(struct shade_setup *setup, const struct shade_input *in); /* linear and six, as in->plan says */
void shade_planned_duff(struct shade_setup *setup, const struct shade_input *in);
void shade_constant(struct shade_setup *setup, const struct shade_input *in);
void shade_x(struct shade_setup *setup, const struct shade_input *in);
void shade_x_perspective(struct shade_setup *setup, const struct shade_input *in);
void shade_six(struct shade_setup *setup, const struct shade_input *in);
void shade_six_perspective(struct shade_setup *setup, const struct shade_input *in);
void shade_duff(struct shade_setup *setup, const struct shade_input *in);
void shade_color6(struct shade_setup *setup, const struct shade_input *in);
void shade_phong(struct shade_setup *setup, const struct shade_input *in);
void shade_phong_perspective(struct shade_setup *setup, const struct shade_input *in);
void shade_overveld(struct shade_setup *setup, const struct shade_input *in);
void shade_overveld_scan(struct shade_setup *setup, const struct shade_input *in);
void shade_biquadratic(struct shade_setup *setup, const struct shade_input *in);
void shade_bump_linear(struct shade_setup *setup, const struct shade_input *in);
void shade_bump_quadratic(struct shade_setup *setup, const struct shade_input *in);
void shade_bump_frames(struct shade_setup *setup, const struct shade_input *in);
void shade_bump_upright(struct shade_setup *setup, const struct shade_input *in);
void shade_bump_normalised(struct shade_setup *setup, const struct shade_input *in);
void shade_biquadratic_perspective(struct shade_setup *setup, const struct shade_input *in);

#endif
