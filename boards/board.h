/* SPDX-License-Identifier: MIT */
/* What a board gives to the program in firmware/app. A board is a folder here whose board.c has the one function. */
#ifndef BOARD_H
#define BOARD_H

#include "core.h"
#include "display.h"
#include "link.h"
#include "stream/stream.h"

struct board {
    const char *name;
    struct hal_display *display; /* not yet open */
    uint16_t width, height;      /* of the picture, in pixels */
    uint16_t band_rows;
    uint8_t format;                 /* enum hal_pixel_format: RGB565 or GREY4 */
    uint8_t dither;                 /* 1: ordered dither */
    const struct pack_format *pack; /* of that format, for the stream */
    void *band[4]; /* band_rows rows of the format each, aligned to 4: two, or four where there is a second CPU */
    void *memory;  /* the renderer's, aligned to 4 */
    uint32_t memory_bytes;
    const struct hal_core *core; /* the second CPU; null: none */
    void *worker;                /* its memory (glint_worker_memory_needed()), aligned to 4 */
    uint32_t worker_bytes;
    struct hal_link *link; /* open: every picture is streamed over it, and the display has done with a band when flush
                            * returns. Null: over the serial line, when asked for */
    uint8_t *last;         /* room for a picture, aligned to 4: only what changes is streamed; null: key frames */
    int (*log)(struct stream *, const char *); /* stream_log: reports go over the link too; or null */
};

/* Starts clocks, pins, time, keys and the serial line. Called once, first. */
const struct board *board_start(void);

#endif
