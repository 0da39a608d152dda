/* SPDX-License-Identifier: MIT */
/* Bands packed and unpacked: random and adverse ones, in blocks of exactly their size. */
#include "stream/pack.h"
#include "view/unpack.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"

static const struct pack_format *const formats[STREAM_FORMATS] = {&pack_rgb565, &pack_rgb888, &pack_grey8, &pack_grey4};

struct band {
    const struct pack_format *format;
    size_t bytes, stride, room;
    uint8_t *pixels, *last, *out, *back;
};

/* Bytes that are copies of one another, near one another, or neither, with a taste of its own in each band. */
static void fill(uint8_t *pixels, size_t bytes, const uint8_t *other, size_t stride, unsigned size)
{
    int taste = random_between(0, 5), near = random_between(0, 40);
    for (size_t i = 0; i < bytes; i++) {
        int choice = random_between(0, 7);
        uint8_t before = i >= size ? pixels[i - size] : 0;
        if (taste == 0 || choice == 0)
            pixels[i] = (uint8_t)(random_bits() >> 9 & 255);
        else if (taste <= 2 && choice <= 3)
            pixels[i] = (uint8_t)((before + random_between(-near, near)) & 255);
        else if (other && choice <= 4 + taste)
            pixels[i] = other[i];
        else
            pixels[i] = i >= stride && choice & 1 ? pixels[i - stride] : before;
    }
}

static struct band open_band(enum stream_format format, unsigned width, unsigned rows, bool last)
{
    struct band b = {.format = formats[format], .stride = unpack_row_bytes(format, width)};
    unsigned size = b.format->bits > 8 ? b.format->bits / 8 : 1;
    b.bytes = b.stride * rows;
    b.room = 2 * b.bytes + 16; /* a literal takes a byte more than its pixel */
    b.pixels = malloc(b.bytes);
    b.back = malloc(b.bytes);
    b.out = malloc(b.room);
    b.last = last ? malloc(b.bytes) : NULL;
    if (last)
        fill(b.last, b.bytes, NULL, b.stride, size);
    fill(b.pixels, b.bytes, b.last, b.stride, size);
    return b;
}

static void close_band(struct band *b)
{
    free(b->pixels);
    free(b->last);
    free(b->out);
    free(b->back);
}

static uint32_t pack(const struct band *b, const uint8_t *last, uint8_t *out, size_t room)
{
    const struct pack_rows rows = {b->pixels, last, (uint32_t)b->bytes, (uint32_t)b->stride, out, (uint32_t)room};
    return b->format->pack(&rows);
}

static bool unpack(const struct band *b, const uint8_t *packed, size_t count)
{
    const struct unpack_rows rows = {packed, count, b->back, b->last, b->bytes, b->stride, b->format->format};
    memset(b->back, 0xA5, b->bytes);
    return unpack_rows(&rows);
}

static void whatever_is_packed_comes_back(void **state)
{
    uint32_t kinds[8] = {0};
    (void)state;
    random_seed(1);
    for (int i = 0; i < 20000; i++) {
        struct band b = open_band(i & 3, (unsigned)random_between(1, 50), (unsigned)random_between(1, 9), i & 4);
        uint32_t count = pack(&b, b.last, b.out, b.room);
        assert_true(count > 0 && count <= b.room);
        assert_true(unpack(&b, b.out, count));
        assert_memory_equal(b.back, b.pixels, b.bytes);
        kinds[i & 7] += count < b.bytes;
        close_band(&b);
    }
    for (int i = 0; i < 8; i++) /* of each kind 2500 */
        assert_in_range(kinds[i], 1000, 2400);
}

/* Too little room is told, and nothing is written beyond it; that of the whole result is enough but for the margin. */
static void no_byte_is_written_beyond_the_room(void **state)
{
    (void)state;
    random_seed(2);
    for (int i = 0; i < 3000; i++) {
        struct band b = open_band(i & 3, (unsigned)random_between(1, 30), (unsigned)random_between(1, 5), i & 4);
        uint32_t count = pack(&b, b.last, b.out, b.room), room = (uint32_t)random_between(0, (int32_t)count + 8);
        uint8_t *out = malloc(room + 1);
        uint32_t got = pack(&b, b.last, out, room);
        assert_true(got == 0 || got == count);
        assert_true(got <= room);
        if (room >= count + 6)
            assert_int_equal(got, count);
        free(out);
        close_band(&b);
    }
}

static void the_last_picture_is_no_burden(void **state)
{
    (void)state;
    random_seed(3);
    for (int i = 0; i < 10000; i++) {
        struct band b = open_band(i & 3, (unsigned)random_between(1, 60), (unsigned)random_between(1, 9), true);
        uint32_t change = pack(&b, b.last, b.out, b.room), alone = pack(&b, NULL, b.out, b.room);
        /* a longest copy is not always the best: up to 5 bytes were seen */
        assert_true(change <= alone + 8);
        close_band(&b);
    }
}

static void an_unchanged_band_takes_a_byte_for_512_pixels(void **state)
{
    enum { WIDTH = 240, ROWS = 16 };
    struct band b = open_band(STREAM_RGB565, WIDTH, ROWS, true);
    (void)state;
    memcpy(b.pixels, b.last, b.bytes);
    assert_true(pack(&b, b.last, b.out, b.room) <= 1 + (WIDTH * ROWS + 511) / 512);
    close_band(&b);
}

static void a_part_is_not_taken_for_the_whole(void **state)
{
    (void)state;
    random_seed(4);
    for (int i = 0; i < 1000; i++) {
        struct band b = open_band(i & 3, (unsigned)random_between(1, 16), (unsigned)random_between(1, 4), i & 4);
        uint32_t count = pack(&b, b.last, b.out, b.room);
        for (uint32_t part = 0; part < count; part++)
            assert_false(unpack(&b, b.out, part));
        b.out[count] = 0x00;
        assert_false(unpack(&b, b.out, count + 1));
        close_band(&b);
    }
}

/* Blocks of exactly their size let the sanitizers see what is read or written beside them. */
static void any_bytes_do_no_harm(void **state)
{
    uint32_t taken = 0;
    (void)state;
    random_seed(5);
    for (int i = 0; i < 60000; i++) {
        struct band b = open_band(i & 3, (unsigned)random_between(1, 6), (unsigned)random_between(1, 3), i & 4);
        uint32_t count = (uint32_t)random_between(0, 12);
        uint8_t *packed = malloc(count + 1);
        for (uint32_t at = 0; at < count; at++)
            packed[at] = (uint8_t)(random_bits() >> 9 & 255);
        taken += unpack(&b, packed + 0, count);
        free(packed);
        close_band(&b);
    }
    assert_in_range(taken, 100, 30000);
}

/* Bytes that mean nothing, or not there: more of no copy, above in the first row, the last picture of none, 19 to 1F.
 */
static void what_cannot_be_copied_is_refused(void **state)
{
    static const uint8_t codes[][3] = {{0xC0, 0, 0}, {0x18, 7, 0xC0}, {0x5F, 0, 0}, {0x41, 0, 0},
                                       {0x7F, 0, 0}, {0x61, 0, 0},    {0x19, 0, 0}, {0x1F, 0, 0}};
    (void)state;
    for (unsigned width = 1; width <= 9; width++)
        for (unsigned i = 0; i < sizeof codes / sizeof *codes; i++) {
            struct band b = open_band(STREAM_GREY8, width, 1, false);
            for (uint32_t count = i == 1 ? 3 : 1; count <= 3; count++)
                assert_false(unpack(&b, codes[i], count));
            close_band(&b);
        }
}

/* A band of one row or, for a copy from above, two: some pixels that nothing is like, a run that can be copied in one
 * way alone, and one more that ends it. */
static struct band open_run(enum stream_format format, enum pack_kind kind, unsigned run, unsigned lead)
{
    unsigned width = lead + run + 1, rows = kind == PACK_ABOVE ? 2 : 1;
    struct band b = {.format = formats[format]};
    unsigned size = b.format->bits > 8 ? b.format->bits / 8 : 1;
    b.stride = (size_t)width * size;
    b.bytes = b.stride * rows;
    b.room = 2 * b.bytes + 16;
    b.pixels = malloc(b.bytes);
    b.back = malloc(b.bytes);
    b.out = malloc(b.room);
    b.last = kind == PACK_LAST ? malloc(b.bytes) : NULL;
    for (unsigned i = 0; i < width * rows; i++) {
        uint8_t value = (uint8_t)(i * 67 % 251 + 4); /* far from its neighbours */
        if (kind == PACK_LEFT && i > lead && i < lead + run)
            value = (uint8_t)(lead * 67 % 251 + 4);
        if (kind == PACK_ABOVE && i >= width + lead && i < width + lead + run)
            value = b.pixels[(i - width) * size];
        memset(b.pixels + (size_t)i * size, value, size);
        if (b.last)
            memset(b.last + (size_t)i * size, i >= lead && i < lead + run ? value : value ^ 0x50, size);
    }
    return b;
}

/* The same in any room about the size of what comes, or nothing; and no byte beyond. */
static void fits_or_is_refused(const struct band *b, uint32_t count)
{
    enum { GUARD = 8 };
    for (uint32_t room = count > 4 ? count - 4 : 0; room < count + 9; room++) {
        uint8_t *out = malloc(room + GUARD);
        memset(out, 0xA5, room + GUARD);
        uint32_t got = pack(b, b->last, out, room);
        assert_true(got == 0 || (got == count && count <= room && memcmp(out, b->out, count) == 0));
        for (unsigned i = 0; i < GUARD; i++)
            assert_int_equal(out[room + i], 0xA5);
        free(out);
    }
}

/* By every way to copy, and each number of pixels at which what is written changes: 1, 8, 9, 16, 17 ... 512, 513 ... */
static void runs_of_every_length_come_back(void **state)
{
    (void)state;
    for (unsigned format = 0; format < STREAM_FORMATS; format++)
        for (unsigned kind = PACK_LEFT; kind <= PACK_LAST; kind++)
            for (unsigned run = 1; run <= 9000; run += run > 1100 ? 997 : run > 40 && run % 8 == 1 ? 6 : 1)
                for (unsigned lead = 0; lead <= 2; lead += 2) {
                    struct band b = open_run(format, kind, run, lead);
                    uint32_t count = pack(&b, b.last, b.out, b.room);
                    assert_true(count > 0 && count <= b.room);
                    assert_true(unpack(&b, b.out, count));
                    assert_memory_equal(b.back, b.pixels, b.bytes);
                    fits_or_is_refused(&b, count);
                    if (kind == PACK_LAST && lead == 0) { /* nothing but the run and the pixel behind it */
                        uint32_t pixel = (uint32_t)(b.bytes / (run + 1));
                        assert_in_range(count, 2 + (run + 503) / 512, 2 + pixel + (run + 503) / 512);
                    }
                    close_band(&b);
                }
}

static void every_width_comes_back_in_every_format(void **state)
{
    (void)state;
    random_seed(13);
    for (unsigned width = 1; width <= 70; width++)
        for (unsigned rows = 1; rows <= 4; rows++)
            for (unsigned kind = 0; kind < 2 * STREAM_FORMATS; kind++) {
                struct band b = open_band((enum stream_format)(kind & 3), width, rows, kind & 4);
                uint32_t count = pack(&b, b.last, b.out, b.room);
                assert_true(count > 0 && unpack(&b, b.out, count));
                assert_memory_equal(b.back, b.pixels, b.bytes);
                close_band(&b);
            }
}

/* Pixels that differ from the one before, above and of the last picture by too much for a difference: each a literal.
 * It takes just the room that it needs, the margin of a round, and is refused with a byte less. */
static void the_worst_band_takes_a_byte_a_pixel_more_than_its_pixels(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < 2 * STREAM_FORMATS; kind++)
        for (unsigned width = 1; width <= 33; width++) {
            struct band b = open_band((enum stream_format)(kind & 3), width, 3, kind & 4);
            unsigned size = b.format->bits > 8 ? b.format->bits / 8 : 1;
            uint32_t worst = (uint32_t)(b.bytes / size * (size + 1));
            for (size_t i = 0; i < b.bytes; i++) {
                size_t pixel = i / size, row = i / b.stride;
                b.pixels[i] = (uint8_t)((pixel * 0x55 + row * 0x33 + 0x77) & 255);
                if (b.last)
                    b.last[i] = b.pixels[i] ^ 0x99;
            }
            assert_int_equal(pack(&b, b.last, b.out, b.room), worst);
            assert_true(unpack(&b, b.out, worst));
            assert_memory_equal(b.back, b.pixels, b.bytes);
            uint32_t need = worst - (size + 1) + 6; /* before the last pixel a round's margin must be there */
            for (uint32_t room = 0; room <= need; room++) {
                uint8_t *out = malloc(room + 1);
                assert_int_equal(pack(&b, b.last, out, room), room == need ? worst : 0);
                free(out);
            }
            close_band(&b);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whatever_is_packed_comes_back),
        cmocka_unit_test(no_byte_is_written_beyond_the_room),
        cmocka_unit_test(the_last_picture_is_no_burden),
        cmocka_unit_test(an_unchanged_band_takes_a_byte_for_512_pixels),
        cmocka_unit_test(a_part_is_not_taken_for_the_whole),
        cmocka_unit_test(any_bytes_do_no_harm),
        cmocka_unit_test(what_cannot_be_copied_is_refused),
        cmocka_unit_test(runs_of_every_length_come_back),
        cmocka_unit_test(every_width_comes_back_in_every_format),
        cmocka_unit_test(the_worst_band_takes_a_byte_a_pixel_more_than_its_pixels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
