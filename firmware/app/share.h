/* SPDX-License-Identifier: MIT */
/*
 * Pictures drawn by one CPU or two, band by band, and sent in order. Whoever is free takes the next band; whoever has
 * drawn one sends what is due, while the other draws on. A picture's last bands are sent by the second CPU while the
 * first begins the next picture, so that the display's wires need not rest.
 */
#ifndef SHARE_H
#define SHARE_H

#include "core.h"
#include "display.h"
#include "glint.h"

#include <stdatomic.h>

#define SHARE_MOST_BANDS 4u

struct share_slot {
    struct glint_band band;
    uint8_t last;       /* of its picture */
    atomic_uint number; /* the band's and one, when it is drawn */
};

/* The first part is the caller's, set before share_ready(); all else is 0 at first. */
struct share {
    const struct hal_core *core;  /* null: one CPU */
    struct hal_display *display;  /* open; null: nothing is sent */
    void *band[SHARE_MOST_BANDS]; /* buffers of config.band_rows rows: two, or four */
    /* Null, or draws over each band; assisting: on the second CPU. */
    void (*over)(void *context, const struct glint_band *, int assisting);
    void *context;
    struct glint_frame frame;

    uint32_t draw_us; /* what the first CPU took for its part of the last picture, without the display */
    uint32_t part_us; /* of that in hand, so far */

    struct glint_frame worker; /* the second CPU's */
    uint32_t buffers, count;   /* how many; bands a picture */
    /* Numbers of bands, counted on from picture to picture. */
    uint32_t next, end;   /* the next to be drawn; the first of the next picture. Under HAL_LOCK_TAKE */
    atomic_uint due;      /* the next to be sent. Under HAL_LOCK_SEND, but read anywhere */
    atomic_uint left;     /* those before have left their buffers */
    atomic_int error;     /* the display's: nothing is sent after it */
    atomic_int assisting; /* the second CPU has a band in hand */
    uint8_t started;      /* the second CPU runs */
    struct share_slot slot[SHARE_MOST_BANDS];
};

/* Takes a renderer that glint_init() made in share->frame, between pictures, and memory for the second CPU's worker.
 * Without enough of that there is one CPU: what is enough for one configuration is for all of its size. */
void share_ready(struct share *share, void *memory, uint32_t bytes);

/* Begins a picture: 0, or glint_frame_begin()'s error. */
int share_begin(struct share *share, const void *scene, uint32_t time_ms);

/* Draws it: 0, or the display's error, after which it is to be opened anew. With a second CPU the last bands are sent
 * later. */
int share_draw(struct share *share);

/* Returns when the display has all, or will not have it: 0, or its error. Before anyone else uses the display. */
int share_finish(struct share *share);

#endif
