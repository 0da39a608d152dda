/* SPDX-License-Identifier: MIT */
/*
 * What is packed of a band stays in its room, whatever the pixels, the last picture's and the room: of all bands of
 * PIXELS pixels, in rows of each width. Larger ones differ in how long a copy is, which pack_copy() is asked for by
 * itself: a round of the loop has PACK_MARGIN bytes and one more for each 512 pixels.
 *
 *   proves: pack_load pack_alike pack_copy pack_longest pack_band pack_colour pack_signed pack_difference_rgb565
 *           pack_difference_rgb888 pack_difference_grey8 pack_difference_grey4 pack_band_rgb565 pack_band_rgb888
 *           pack_band_grey8 pack_band_grey4
 *   options: -eva-precision 3 -eva-slevel 5000 -eva-split-return full
 *            -eva-slevel-function band:0,bands:0,copies:0,longest:0,prove:0
 */
#include "proof.h"

#include "firmware/stream/pack.c"

#define PIXELS 2u
#define MOST   (4 * PIXELS + PACK_MARGIN) /* bytes: nothing takes more */

static void band(const struct pack_format *format, unsigned size, unsigned count, unsigned width)
{
    static uint32_t pixels[2], last[2];
    static uint8_t memory[MOST];
    //@ loop unroll 10;
    for (unsigned room = PACK_MARGIN - 1; room <= MOST; room++) {
        any_bytes(pixels, sizeof pixels);
        any_bytes(last, sizeof last);
        const uint8_t *first = (const uint8_t *)pixels + sizeof pixels - count * size;
        const uint8_t *before = (const uint8_t *)last + sizeof last - count * size;
        const struct pack_rows rows = {first,        any_flag() ? before : 0, count * size,
                                       width * size, memory + MOST - room,    room};
        uint32_t bytes = format->pack(&rows);
        //@ assert bytes <= room;
    }
}

/* Of one pixel, of two beside each other, of two above each other. */
static void bands(const struct pack_format *format, unsigned size)
{
    band(format, size, 1, 1);
    band(format, size, 2, 2);
    band(format, size, 2, 1);
}

/* A copy of any length up to 8 * 64 * 40 pixels: each number of bytes is a case of its own. */
static void copies(void)
{
    static uint8_t memory[42];
    uint32_t length = (uint32_t)(pack_copy(memory, any_u32(1, 3), any_u32(1, 8)) - memory);
    //@ assert length == 1;
    //@ loop unroll 40;
    for (uint32_t more = 0; more < 40; more++) {
        uint32_t count = any_u32(512 * more + 9, 512 * more + 520);
        length = (uint32_t)(pack_copy(memory, any_u32(1, 3), count) - memory);
        //@ assert length <= 2 + ((512 * more + 9) >> 9);
    }
}

/* A copy for which no better one is looked for; no pixel is like the one before. */
static void longest(void)
{
    static uint8_t pixels[PACK_LONG], last[PACK_LONG], out[PACK_MARGIN];
    any_bytes(pixels, sizeof pixels);
    any_bytes(last, sizeof last);
    const struct pack_rows rows = {pixels, last, PACK_LONG, 8, out, sizeof out};
    unsigned kind = 0;
    const uint8_t *end = pack_longest(&rows, pixels, pixels + PACK_LONG, 256, 1, &kind);
    const uint32_t length = (uint32_t)(end - pixels);
    //@ assert length <= PACK_LONG;
}

void prove(void)
{
    copies();
    longest();
    bands(&pack_rgb565, 2);
    bands(&pack_rgb888, 3);
    bands(&pack_grey8, 1);
    bands(&pack_grey4, 1);
}
