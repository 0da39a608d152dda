/* SPDX-License-Identifier: MIT */
/* Bands of codecs 1 and 2: any bytes are taken or refused without a step beside the blocks; what is taken has every
 * pixel from them, and comes back when packed again. Input: format and codec, width, rows, last picture, the band. */
#include "fuzz/fuzz.h"
#include "stream/pack.h"
#include "view/unpack.h"

static const struct pack_format *const formats[STREAM_FORMATS] = {&pack_rgb565, &pack_rgb888, &pack_grey8, &pack_grey4};

/* Unpacks into a block that was all `before`: null if it was refused. */
static uint8_t *unpacked(struct unpack_rows rows, uint8_t before)
{
    rows.pixels = fuzz_block(rows.bytes);
    memset(rows.pixels, before, rows.bytes);
    if (unpack_rows(&rows))
        return rows.pixels;
    free(rows.pixels);
    return NULL;
}

static void comes_back(const struct unpack_rows *rows, const uint8_t *pixels)
{
    uint32_t room = (uint32_t)(2 * rows->bytes + 16);
    uint8_t *out = fuzz_block(room);
    const struct pack_rows again = {pixels, rows->last, (uint32_t)rows->bytes, (uint32_t)rows->stride, out, room};
    struct unpack_rows back = *rows;
    back.packed = out;
    back.packed_bytes = formats[rows->format]->pack(&again);
    FUZZ_CHECK(back.packed_bytes > 0 && back.packed_bytes <= room);
    uint8_t *twice = unpacked(back, 0);
    FUZZ_CHECK(twice && memcmp(twice, pixels, rows->bytes) == 0);
    free(twice);
    free(out);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_bytes in = {data, data + size};
    unsigned kind = fuzz_take(&in), width = fuzz_take(&in) % 80 + 1, rows = fuzz_take(&in) % 40 + 1,
             like = fuzz_take(&in);
    struct unpack_rows band = {
        .packed = in.at, .packed_bytes = (size_t)(in.end - in.at), .format = (enum stream_format)(kind & 3)};
    band.stride = unpack_row_bytes(band.format, width);
    band.bytes = band.stride * rows;
    uint8_t *last = kind & 4 ? fuzz_block(band.bytes) : NULL;
    for (size_t i = 0; last && i < band.bytes; i++)
        last[i] = (uint8_t)((like + i * (like >> 5)) & 255);
    band.last = last;
    uint8_t *once = unpacked(band, 0x00), *again = unpacked(band, 0xFF);
    FUZZ_CHECK(!once == !again);
    FUZZ_CHECK(!once || memcmp(once, again, band.bytes) == 0);
    if (once)
        comes_back(&band, once);
    free(once);
    free(again);
    free(last);
    return 0;
}
