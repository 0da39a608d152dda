/* SPDX-License-Identifier: MIT */
/*
 * Of any packed bytes, by themselves or with a last picture, unpacking reads and writes nothing outside what it is
 * given. By induction: from every place in a band of two pixels by two, whatever was copied last, any token of which
 * up to FOLLOWING bytes (no token has more) are there ends at such a place or is refused. A band that is packed in any
 * number of bytes is a row of tokens. What lies before and behind belongs to nobody.
 *
 *   proves: unpack_row_bytes unpack_look unpack_copy unpack_put_colour unpack_put_grey unpack_put_pair unpack_step
 *           unpack_signed unpack_wide unpack_literal unpack_token unpack_rows
 *   options: -machdep gcc_x86_64 -eva-precision 3 -eva-slevel 500 -eva-split-return full
 *            -eva-slevel-function band:0,prove:0,token:20
 */
#include "proof.h"

#include "host-tools/view/unpack.c"

#define FOLLOWING 3
#define PIXELS    4

static uint8_t pixels[PIXELS * 3], last[PIXELS * 3], packed[FOLLOWING];

/* A token at pixel `place`, with `count` bytes behind its first. */
static void token(const struct unpack_rows *rows, size_t size, size_t place, size_t count)
{
    struct unpack u = {.rows = rows, .size = (unsigned)size, .kind = any_u32(0, 3), .before = (uint8_t)any_u32(0, 255)};
    u.in = packed + FOLLOWING - count;
    u.in_end = packed + FOLLOWING;
    u.out = rows->pixels + place * size;
    u.out_end = rows->pixels + rows->bytes;
    any_bytes(pixels, sizeof pixels);
    if (unpack_token(&u, any_u32(0, 255))) {
        const size_t bytes = (size_t)(u.out - rows->pixels);
        //@ assert bytes <= rows->bytes && bytes % size == 0 && u.kind <= 3;
        //@ assert 0 <= u.in_end - u.in <= count;
    }
}

static void band(enum stream_format format, size_t size)
{
    const size_t skip = (3 - size) * PIXELS; /* nothing lies behind */
    any_bytes(last, sizeof last);
    any_bytes(packed, sizeof packed);
    struct unpack_rows rows = {packed, 0, pixels + skip, any_flag() ? last + skip : 0, PIXELS * size, 2 * size, format};
    //@ loop unroll 5;
    for (size_t place = 0; place <= PIXELS; place++)
        //@ loop unroll 4;
        for (size_t count = 0; count <= FOLLOWING; count++)
            token(&rows, size, place, count);
    rows.packed_bytes = 1;
    unpack_rows(&rows);
}

/* What copies eight pixels at the least, where there are so many. */
static void eight(void)
{
    uint8_t many[16], before[16];
    any_bytes(many, sizeof many);
    any_bytes(before, sizeof before);
    const struct unpack_rows rows = {packed, 0, many, before, sizeof many, sizeof many / 2, STREAM_RGB565};
    struct unpack u = {.rows = &rows, .size = 2, .kind = PACK_LAST, .in = packed, .in_end = packed, .out = many};
    u.out_end = many + sizeof many;
    unpack_token(&u, PACK_MORE);
}

void prove(void)
{
    eight();
    band(STREAM_RGB565, 2);
    band(STREAM_RGB888, 3);
    band(STREAM_GREY8, 1);
    band(STREAM_GREY4, 1);
    unpack_row_bytes(any_u32(0, STREAM_FORMATS - 1), ANY_U32);
}
