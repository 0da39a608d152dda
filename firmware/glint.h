/* SPDX-License-Identifier: MIT */
/*
 * Glint's whole public interface: what a user's own firmware includes.
 *
 * The caller owns every byte. glint_init() divides one block of memory, glint_frame_begin() transforms, lights, clips
 * and sorts a scene at a moment of its animation, and glint_frame_next_band() draws a few rows at a time into the
 * caller's band buffers, top to bottom. Nothing is allocated, nothing is static, nothing calls out; several renderers
 * can be under way at once, and several CPUs can draw one picture.
 */
#ifndef GLINT_H
#define GLINT_H

#include <stddef.h>
#include <stdint.h>

#define GLINT_MAX_SIZE 2048u /* pixels, either way */

enum glint_error {
    GLINT_E_ARGUMENT = -1, /* a size, format or method that does not exist or that this program was compiled without,
                              or a null pointer */
    GLINT_E_MEMORY = -2,   /* config.memory is smaller than glint_memory_needed() or not aligned */
    GLINT_E_SCENE = -3,    /* not a scene this version reads, or one that needs an effect that this program was compiled
                              without (uses.h); glint_scene_problem() says why */
};

enum glint_format {
    GLINT_RGB565, /* uint16_t in the CPU's byte order, rounded to nearest */
    GLINT_RGB888, /* bytes r, g, b */
    GLINT_GREY8,  /* Rec. 601 luma of the colours, shaded as one channel */
    GLINT_GREY4,  /* two pixels a byte, the left in the high nibble; a row starts at a byte */
    GLINT_FORMATS
};

/* The shading methods: only those that a program names are linked. Everything is linear or quadratic in the picture. A
 * point light or a near eye is taken from each vertex (flat, gouraud, x) or pixel (what interpolates normals). */
struct glint_method;
extern const struct glint_method glint_flat;    /* one value a triangle */
extern const struct glint_method glint_gouraud; /* finished colour linear over the triangle */
extern const struct glint_method glint_x;       /* N.L and N.H quadratic over the triangle from the vertex normals
                                                   alone (X-shading, eq. 32), clamp and power per pixel */
extern const struct glint_method glint_six;     /* the same with exactly normalised mid-edge normals */
extern const struct glint_method glint_color6;  /* finished colour quadratic through six samples */
extern const struct glint_method glint_duff;    /* Phong by N.L / |N|, numerator linear and |N|^2 quadratic */
extern const struct glint_method glint_phong;   /* normal interpolated and normalised per pixel */
/* Normals quadratic over the triangle, normalised per pixel: for coarse meshes whose edges hide an inflection. */
extern const struct glint_method glint_overveld;      /* van Overveld and Wyvill's, on every edge */
extern const struct glint_method glint_overveld_scan; /* the same along edges, then along each row: a baseline */
extern const struct glint_method glint_biquadratic;   /* Lee and Jen's, only on edges that have an inflection */
/* The same, correct in perspective. They divide by the 16-bit depth: put the near plane close to the scene (a
 * hundredth of its distance costs up to 12/255 in highlights). */
extern const struct glint_method glint_x_perspective, glint_six_perspective, glint_phong_perspective,
    glint_biquadratic_perspective;

/* Bump maps: light and half-way direction turned into the surface's moving frame at the corners, interpolated, and
 * multiplied with the map's normals (Hast et al. 2002). Materials without a map are drawn by x, six and
 * duff (or phong, near and in perspective); the other methods leave maps out, but for auto. */
extern const struct glint_method glint_bump_linear;     /* the directions as they are */
extern const struct glint_method glint_bump_quadratic;  /* through six samples, middles the ends' normalised average */
extern const struct glint_method glint_bump_normalised; /* made unit at each pixel; correct in perspective */
/* bump-quadratic, its middles from the moving frame there: of the ends' averages, and with its axes at right angles */
extern const struct glint_method glint_bump_frames, glint_bump_upright;

/* Triangles split into smaller ones (at most GLINT_MAX_PARTS, and none lower than half a pixel), whose corners are
 * shaded with the normal interpolated there. Adaptive ones draw by gouraud all but the potentially highlighted
 * triangles (Cho et al. 1996, "Improved Specular Highlights with Adaptive Shading") and those that share a vertex with
 * one. */
#define GLINT_MAX_PARTS 1024
extern const struct glint_method glint_subdivide_recursive; /* into 4 down to `subdivide_area`, linear: pseudo-Phong */
extern const struct glint_method glint_subdivide_centre;    /* finished colour quadratic; into 4 while it errs at the
                                                               centre by more than `subdivide_tolerance` */
extern const struct glint_method glint_subdivide_regular;   /* adaptive, otherwise as recursive */
extern const struct glint_method glint_subdivide_highlight; /* adaptive: at the highlight's centre, then on the edges
                                                               that meet there by `subdivide_threshold` */
extern const struct glint_method glint_hybrid_phong;        /* adaptive: by phong */
extern const struct glint_method glint_hybrid_x;            /* adaptive: by x */

/* The cheapest way, a triangle, that keeps every pixel within `budget` of per-pixel Phong with the scene's own effects:
 * nothing but the ambient part, one colour, gouraud, N.L and N.H linear or quadratic each, duff or phong; and of each
 * light's parts only those that can show. firmware/plan/README.md has the bounds. */
extern const struct glint_method glint_auto;
extern const struct glint_method glint_auto_shown; /* a picture of what auto does: each triangle in the colour of what
                                                      it is drawn by (README.md's legend) */
#define GLINT_BUDGET(num, den) ((256u * (num) + (den) / 2) / (den)) /* num/den 255ths as config.budget */

/* Their places in the statistics; the adaptive ones and auto count under what they draw by. */
enum glint_method_id {
    GLINT_FLAT,
    GLINT_GOURAUD,
    GLINT_X,
    GLINT_SIX,
    GLINT_COLOR6,
    GLINT_DUFF,
    GLINT_PHONG,
    GLINT_OVERVELD,
    GLINT_BIQUADRATIC,
    GLINT_SUBDIVIDE,
    GLINT_BUMP_LINEAR,
    GLINT_BUMP_QUADRATIC,
    GLINT_BUMP_NORMALISED,
    GLINT_DARK,     /* auto: the ambient part alone */
    GLINT_CONSTANT, /* auto: one colour */
    GLINT_LINEAR,   /* auto: N.L and N.H linear; GLINT_SIX: one of them at least quadratic */
    GLINT_METHODS
};

/* All of them by name, for programs that offer the choice: who names these lists links every method. */
struct glint_choice {
    const char *name;
    const struct glint_method *method;
};
extern const struct glint_choice glint_choices[];
extern const unsigned glint_choice_count;
extern const char *const glint_method_names[GLINT_METHODS]; /* by enum glint_method_id */

/* Forms of the highlight's power; null in a configuration: an interpolated table, within .5 of 1/255 (.3 where
 * it is not cut to 0). */
struct glint_power;
extern const struct glint_power glint_power_exact; /* rounded to nearest, slow */
/* max(0, 1 - (n / g)(1 - N.H))^g for N.H > 0, no table and no power: off by at most 17.5, 7.6 and 3 of 1/255 at n = 50
 */
extern const struct glint_power glint_power_4, glint_power_8, glint_power_16;

/* How texture coordinates are interpolated over a triangle (shade/uv.h). */
enum glint_texture {
    GLINT_TEXTURE_DEFAULT, /* auto: by the plan; other methods: perspective */
    GLINT_TEXTURE_AFFINE,
    GLINT_TEXTURE_QUADRATIC,   /* through six true samples */
    GLINT_TEXTURE_SPLIT,       /* the same, of triangles split where they err by more than the budget */
    GLINT_TEXTURE_PERSPECTIVE, /* a reciprocal a pixel */
    GLINT_TEXTURES
};

/* flags */
#define GLINT_DITHER 1u /* ordered 4x4 dither for RGB565 and GREY4 */
/* N.L and N.H of the first light are computed where bounds say that they cannot show, too: the same picture, which is
 * to be seen by it. What other lights leave out, and what a budget allows, stays left out. */
#define GLINT_NO_PLAN 2u
/* biquadratic: on every edge that passes the paper's test, not only where the triangles at it confirm an inflection.
 * That is for comparison: on a teapot it darkens spots of spout and handle. */
#define GLINT_EVERY_ZIGZAG 4u

struct glint_config {
    uint16_t width, height; /* of the picture, 1..2048 */
    uint16_t band_rows;     /* rows a band, 1..height */
    uint8_t format;         /* enum glint_format */
    uint8_t flags;          /* GLINT_DITHER, GLINT_NO_PLAN, GLINT_EVERY_ZIGZAG */
    const struct glint_method *method;
    const struct glint_power *power; /* null: the table */
    uint8_t texture;                 /* enum glint_texture */

    void *band[2]; /* glint_band_bytes() each, aligned to 4; band[1] may be null: then band[0] serves every time */
    void *memory;  /* glint_memory_needed() bytes, aligned as a pointer, untouched by the caller until the last frame */
    size_t memory_bytes;

    uint16_t max_vertices; /* stores: what does not fit is dropped whole and counted */
    uint16_t max_triangles;
    uint16_t max_clipped; /* triangles made by clipping, at any one time a few: 64 suits most scenes */
    uint8_t max_objects;
    uint8_t max_lights; /* 0..8; a scene with more is not drawn (GLINT_E_SCENE) */
    uint8_t tables; /* one a material under one light, for fast paths: of colours in RGB565 (16 KiB each), of highlights
                       in GREY8 (2 KiB) and RGB888 (8 KiB); table.c says what they cost in accuracy. 0: none */

    uint16_t budget; /* of auto: how far a pixel may be off, Q8 in 1/255 of full intensity; 0: 2.0. Integer roundings
                        add at most 1.5/255 (and half a step in formats of fewer bits) */

    /* when the subdividing methods split; 0: the default */
    uint8_t subdivide_tolerance; /* 1/255 of full intensity; default 4 */
    uint8_t subdivide_threshold; /* of a colour between a corner's and the true one, 1/256; default 77, .3 */
    uint16_t subdivide_area;     /* pixels; default 32 */
};

/* What a frame did. Counts begin anew with each frame; the pixel counts grow with each band. */
struct glint_stats {
    uint32_t triangles;             /* in all objects */
    uint32_t culled;                /* facing away, or without area on the pixel grid */
    uint32_t rejected;              /* wholly outside the view */
    uint32_t clipped;               /* cut at the near or far plane or the guard band */
    uint32_t dropped;               /* no room in a store */
    uint32_t drawn[GLINT_METHODS];  /* by the method they were drawn with */
    uint32_t pixels[GLINT_METHODS]; /* that passed the depth test, by method */
    uint32_t specular_triangles;    /* of the drawn: those a highlight can reach */
    uint32_t linear_triangles;      /* of the drawn by x and six: those whose bend cannot show */
    uint32_t highlight_tests;       /* triangles tested for a highlight, when the frame begins: those of all objects */
    uint32_t potentially_highlighted; /* those of them that may hold one's centre */
    uint32_t setups;                  /* triangle set-ups: one a triangle and band that it touches */
    uint32_t turned;                  /* triangles of which the back is seen, and drawn */
    uint32_t mapped[GLINT_TEXTURES];  /* of the drawn: those with a texture or bump map, by enum glint_texture */
    uint32_t fogged;                  /* of the drawn: those that some fog reaches */
    uint32_t fogged_by_pixel;         /* of them, those whose fog is found for each pixel anew */
    uint32_t fogged_wholly;           /* of them, those that are all fog: unlit */
    /* Of the drawn by auto: what was left out, and the bound of the error that this allows. */
    uint32_t hidden_lights;      /* pairs of a triangle and a light that reaches no pixel of it: exact */
    uint32_t hidden_highlights;  /* whose highlight reaches none: exact */
    uint32_t dropped_highlights; /* whose highlight is too faint for the budget */
    uint32_t straightened;       /* dot products drawn linear where six would bend them */
    uint32_t undivided;          /* triangles of a perspective view drawn without perspective correction */
    uint16_t largest_error;      /* of all triangles, Q8 in 1/255; at most the budget */
};

struct glint_band {
    void *pixels;
    uint16_t y, rows; /* of the picture */
    uint32_t stride;  /* bytes a row */
};

struct scene_header;

/* The renderer's state: sizes and pointers into config.memory. Its members are its own; 'stats' may be read. */
struct glint_frame {
    struct glint_config config;
    struct glint_stats stats;
    const struct scene_header *scene;
    uint16_t yaw, pitch; /* glint_turn() */
    uint16_t next_row;
    uint8_t band_index;
    uint8_t light_count;
    uint16_t vertex_stride; /* int16_t a vertex record */
    uint16_t vertex_count, triangle_count, clipped_count, object_count;
    uint16_t oldest; /* of order[]: all before it end above next_row */
    struct object_state *objects;
    int16_t *vertices;
    struct triangle_ref *triangles;
    struct clipped_triangle *clipped;
    uint16_t *order; /* triangles by first row, then as submitted */
    uint16_t *rows;  /* how many of them begin in a row or above it */
    uint16_t *depth;
    struct raster *raster;
};

/* Bytes a row, and a band of config->band_rows rows, of the configured size and format. */
size_t glint_row_bytes(const struct glint_config *config);
size_t glint_band_bytes(const struct glint_config *config);

/* Checks a scene blob in full (CRC included): 0 or GLINT_E_SCENE. Do this once, before its first use. */
int glint_scene_check(const void *scene, size_t size);
/* Why glint_scene_check() refused: one short sentence. */
const char *glint_scene_problem(const void *scene, size_t size);

/* Sets the max_ members to what a checked scene takes; max_clipped to what all but contrived views do. */
void glint_fit_stores(struct glint_config *config, const void *scene);

/* Bytes that config->memory must have; 0 if the configuration is not one glint_init() takes. */
size_t glint_memory_needed(const struct glint_config *config);

/* Makes a renderer of a configuration, which is copied. */
int glint_init(struct glint_frame *frame, const struct glint_config *config);

/* Turns every object about its own origin, from the next frame on: its front to the right by `yaw`, then up by `pitch`,
 * as seen by the eye, in 1/65536 turns, on top of its animation. Lights and camera stay. 0, 0 costs nothing and is what
 * glint_init() sets. */
void glint_turn(struct glint_frame *frame, uint16_t yaw, uint16_t pitch);

/* Sets config.budget from the next frame on; 0: 2.0. */
void glint_set_budget(struct glint_frame *frame, uint16_t budget_q8);

/* Begins the frame at `time_ms` of a checked scene. The scene must stay where it is until the last band. */
int glint_frame_begin(struct glint_frame *frame, const void *scene, uint32_t time_ms);

/* Draws the next band: 1 and the band, or 0 after the last. */
int glint_frame_next_band(struct glint_frame *frame, struct glint_band *band);

/* Draws band `index`, rows index * band_rows and on, into pixels of the caller's (glint_band_bytes(), aligned to 4): 1
 * and the band, or 0 if there is none. Bands may come in any order; from top to bottom is fastest. */
int glint_frame_band(struct glint_frame *frame, unsigned index, void *pixels, struct glint_band *band);

/*
 * Several CPUs or threads on one picture. Each further one has a worker: a frame in memory of its own that draws bands
 * from another's lists. While bands are drawn the lists are only read, so that a picture is the same whoever draws
 * what.
 *
 *   once         glint_worker_init(&worker, &frame, memory, bytes)
 *   a picture    glint_frame_begin(&frame, scene, time) and glint_worker_begin(&worker, &frame), one after the other;
 *                at the same time, each with its own: glint_frame_band(&frame, ...), glint_frame_band(&worker, ...);
 *                when all have done: glint_worker_end(&worker, &frame)
 *
 * Who draws which band, and that none is left out, is the caller's. A finished colour (gouraud, color6) is then made
 * once a triangle, not once a vertex.
 */

/* Bytes of memory a worker takes, aligned as a pointer: the working state and a band's depth. */
size_t glint_worker_memory_needed(const struct glint_config *config);

/* Makes a worker for a frame that glint_init() made. */
int glint_worker_init(struct glint_frame *worker, const struct glint_frame *frame, void *memory, size_t bytes);

/* Readies a worker for the picture that has just begun, and makes the colour tables. */
void glint_worker_begin(struct glint_frame *worker, struct glint_frame *frame);

/* Adds the worker's statistics to the frame's. */
void glint_worker_end(const struct glint_frame *worker, struct glint_frame *frame);

#endif
