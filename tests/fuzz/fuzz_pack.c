/* SPDX-License-Identifier: MIT */
/* Bands of any pixels: packed into any room they come back or are refused, and nothing is written beside the room.
 * Input: format and codec, width, rows, room; then what the last picture and the band are drawn by, a byte for a run.
 */
#include "fuzz/fuzz.h"
#include "stream/pack.h"
#include "view/unpack.h"

static const struct pack_format *const formats[STREAM_FORMATS] = {&pack_rgb565, &pack_rgb888, &pack_grey8, &pack_grey4};

/* Draws runs: kk llllll, 2^(l / 4) (4 + l mod 4) / 4 bytes like those to the left, above or of the other picture, or up
 * to 64 that follow in the input. Beyond its end all is as to the left. */
static void draw(struct fuzz_bytes *in, uint8_t *pixels, size_t bytes, const uint8_t *other, size_t stride, size_t size)
{
    size_t at = 0;
    while (at < bytes) {
        unsigned code = in->at == in->end ? 0x7F : fuzz_take(in), kind = code >> 6, length = code & 63;
        size_t run = kind ? ((size_t)(4 + (length & 3)) << (length >> 2 & 15)) / 4 : length + 1;
        for (; run && at < bytes; run--, at++)
            if (kind == 0)
                pixels[at] = (uint8_t)fuzz_take(in);
            else if (kind == 2 && at >= stride)
                pixels[at] = pixels[at - stride];
            else if (kind == 3 && other)
                pixels[at] = other[at];
            else
                pixels[at] = at >= size ? pixels[at - size] : 0;
    }
}

static uint32_t pack(const struct pack_rows *rows, enum stream_format format, uint8_t *out, size_t room)
{
    struct pack_rows into = *rows;
    into.out = out;
    into.room = (uint32_t)room;
    uint32_t count = formats[format]->pack(&into);
    FUZZ_CHECK(count <= room);
    return count;
}

/* With less room it is refused or the same, and with no byte to spare but the margin it is the same. */
static void fits(const struct pack_rows *rows, enum stream_format format, const uint8_t *whole, uint32_t count,
                 unsigned spare)
{
    size_t room = spare < 8 ? count + spare : (size_t)count * spare / 256;
    uint8_t *out = fuzz_block(room);
    uint32_t got = pack(rows, format, out, room);
    FUZZ_CHECK(got == 0 || (got == count && memcmp(out, whole, count) == 0));
    FUZZ_CHECK(got == count || room < count + 6);
    free(out);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_bytes in = {data, data + size};
    unsigned kind = fuzz_take(&in), width = fuzz_take(&in) % 97 + 1, height = fuzz_take(&in) % 12 + 1,
             spare = fuzz_take(&in);
    enum stream_format format = (enum stream_format)(kind & 3);
    size_t pixel = formats[format]->bits > 8 ? formats[format]->bits / 8 : 1;
    size_t stride = unpack_row_bytes(format, width), bytes = stride * height, room = 2 * bytes + 16;
    uint8_t *pixels = fuzz_block(bytes), *last = kind & 4 ? fuzz_block(bytes) : NULL, *back = fuzz_block(bytes);
    uint8_t *out = fuzz_block(room);
    if (last)
        draw(&in, last, bytes, NULL, stride, pixel);
    draw(&in, pixels, bytes, last, stride, pixel);
    const struct pack_rows rows = {
        .pixels = pixels, .last = last, .bytes = (uint32_t)bytes, .stride = (uint32_t)stride};
    uint32_t count = pack(&rows, format, out, room);
    FUZZ_CHECK(count > 0);
    const struct unpack_rows packed = {out, count, back, last, bytes, stride, format};
    FUZZ_CHECK(unpack_rows(&packed) && memcmp(back, pixels, bytes) == 0);
    fits(&rows, format, out, count, spare);
    free(pixels);
    free(last);
    free(back);
    free(out);
    return 0;
}
