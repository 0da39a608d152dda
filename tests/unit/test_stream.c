/* SPDX-License-Identifier: MIT */
/* Streams as messages: the example of PROTOCOL.md, and every picture back bit for bit. */
#include "pack/pack.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>

#include "frame_case.h"
#include "random.h"
#include "stream_case.h"

static struct pack_result tiny, demo;

static int load(void **state)
{
    (void)state;
    return pack_load("tests/scenes/tiny.json", NULL, &tiny) || pack_load("tests/scenes/demo.json", NULL, &demo);
}

static int unload(void **state)
{
    (void)state;
    pack_free(&tiny);
    pack_free(&demo);
    return 0;
}

/* The picture of PROTOCOL.md, "Example", and the one after it. */
static const uint16_t example[2][8] = {{0x8410, 0x8410, 0x8430, 0x8430, 0x8410, 0x8410, 0x8430, 0x07E0},
                                       {0x8410, 0x8410, 0x8430, 0x8430, 0x8410, 0x8410, 0x8430, 0x94B2}};

/* Its bytes: the lines of the file's last code block that begin with one. */
static size_t example_bytes(uint8_t *bytes, size_t room)
{
    FILE *file = fopen("firmware/stream/PROTOCOL.md", "r");
    char line[512];
    size_t count = 0;
    unsigned byte;
    int used;
    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        if (strspn(line, "0123456789ABCDEF \n") == strlen(line))
            for (const char *at = line; sscanf(at, "%2x %n", &byte, &used) == 1 && count < room; at += used)
                bytes[count++] = (uint8_t)byte;
        else if (line[0] != '#' && line[0] != '`')
            count = 0; /* words: what was before them is none of it */
    }
    fclose(file);
    return count;
}

static void the_example_of_the_protocol_is_what_is_sent(void **state)
{
    struct stream_case_bytes out = {0};
    struct stream s = stream_case_open(&out, STREAM_RGB565, 4, 2, 2, true);
    const struct stream_frame frame = {.moment_ms = 40, .scene = 1, .method = 2, .budget = 4};
    const struct stream_statistics statistics = {.draw_us = 1000, .pack_us = 200, .triangles = 12, .drawn = 6};
    uint8_t bytes[1024];
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        s.time_us = 1000000 + 20000 * i;
        assert_int_equal(stream_frame_begin(&s, &frame), 0);
        assert_int_equal(stream_band(&s, example[i], 0, 2), 0);
        assert_int_equal(stream_frame_end(&s, &statistics), 0);
    }
    assert_int_equal(example_bytes(bytes, sizeof bytes), out.count);
    assert_memory_equal(out.bytes, bytes, out.count);
    stream_case_close(&s, &out);
}

static void the_example_of_the_protocol_is_shown(void **state)
{
    struct stream_case_view view;
    uint8_t bytes[1024];
    size_t count = example_bytes(bytes, sizeof bytes);
    (void)state;
    stream_case_watch(&view, (const uint8_t *)example, sizeof example[0], 2);
    stream_case_take(&view, bytes, count);
    assert_int_equal(view.shown, 3);
    assert_int_equal(view.wrong + view.frames.lost, 0);
}

/* Draws and sends four moments, and looks at them: the bytes of the stream. */
static size_t send_scene(const void *scene, struct frame_case f, unsigned buffer_rows, bool last)
{
    struct stream_case_bytes out = {0};
    struct stream_case_view view;
    enum { COUNT = 4 };
    frame_case_open_for(&f, scene);
    struct stream s = stream_case_open(&out, f.config.format, f.config.width, f.config.height, buffer_rows, last);
    uint8_t *pictures = malloc(COUNT * f.picture_bytes);
    for (uint32_t i = 0; i < COUNT; i++) {
        frame_case_draw(&f, scene, 90 * i);
        memcpy(pictures + i * f.picture_bytes, f.picture, f.picture_bytes);
        assert_int_equal(stream_case_send(&s, f.picture, f.config.band_rows), 0);
    }
    size_t bytes = out.count;
    stream_case_watch(&view, pictures, f.picture_bytes, COUNT);
    stream_case_take(&view, out.bytes, out.count);
    assert_int_equal(view.shown, (1 << COUNT) - 1);
    assert_int_equal(view.wrong + view.frames.lost, 0);
    free(pictures);
    frame_case_close(&f);
    stream_case_close(&s, &out);
    return bytes;
}

static void pictures_come_back_in_every_format_and_band_height(void **state)
{
    (void)state;
    for (int format = 0; format < GLINT_FORMATS; format++)
        for (unsigned flags = 0; flags <= GLINT_DITHER; flags += GLINT_DITHER)
            for (unsigned rows = 1; rows <= 45; rows += 11) {
                struct frame_case f = frame_case_small(61, 45, format);
                f.config.flags = (uint8_t)flags;
                f.config.band_rows = (uint16_t)rows;
                size_t keys = send_scene(demo.scene, f, rows, false);
                size_t changes = send_scene(demo.scene, f, rows, true);
                assert_true(changes < keys);
                /* a buffer smaller than a band, and one larger */
                assert_true(send_scene(demo.scene, f, 1, true) >= changes);
                send_scene(tiny.scene, f, 64, true);
            }
}

static void noise_stays_within_the_bound(void **state)
{
    (void)state;
    random_seed(6);
    for (int format = 0; format < STREAM_FORMATS; format++)
        for (unsigned rows = 1; rows <= 20; rows++) {
            struct stream_case_bytes out = {0};
            struct stream_case_view view;
            size_t bytes = unpack_row_bytes(format, 33) * 20;
            struct stream s = stream_case_open(&out, format, 33, 20, rows, true);
            uint8_t *pictures = malloc(3 * bytes);
            for (size_t i = 0; i < 3 * bytes; i++)
                pictures[i] = (uint8_t)(random_bits() >> 11 & 255);
            for (unsigned i = 0; i < 3; i++) {
                size_t before = out.count;
                assert_int_equal(stream_case_send(&s, pictures + i * bytes, 20), 0);
                assert_true(out.count - before <= bytes + 116 + 36 * ((20 + rows - 1) / rows));
            }
            stream_case_watch(&view, pictures, bytes, 3);
            stream_case_take(&view, out.bytes, out.count);
            assert_int_equal(view.shown, 7);
            free(pictures);
            stream_case_close(&s, &out);
        }
}

/* A write that fails at any byte: the next frame is a key frame, and all from then on is shown. */
static void what_cannot_be_written_costs_its_frame_alone(void **state)
{
    enum { BYTES = 2 * 24 * 10, COUNT = 5 };
    static uint8_t pictures[COUNT * BYTES];
    size_t whole = 0;
    (void)state;
    random_seed(9);
    for (size_t i = 0; i < sizeof pictures; i++)
        pictures[i] = (uint8_t)(i >= BYTES && random_between(0, 3) ? pictures[i - BYTES] : random_between(0, 3));
    for (size_t stop = 0; stop == 0 || stop < whole; stop++) {
        struct stream_case_bytes out = {0};
        struct stream_case_view view;
        struct stream s = stream_case_open(&out, STREAM_RGB565, 24, 10, 3, true);
        unsigned failed = COUNT;
        for (unsigned i = 0; i < COUNT; i++) {
            uint32_t number = s.number;
            if (i == 2)
                out.stop_at = stop;
            int error = stream_case_send(&s, pictures + i * BYTES, 10);
            if (error) {
                assert_int_equal(error, -7);
                assert_int_equal(s.key, 1);
                failed = i;
                out.stop_at = 0;
            }
            /* the pictures are known by their place: what was given up takes one too */
            s.number = number + 1;
        }
        whole = out.count > whole ? out.count : whole;
        stream_case_watch(&view, pictures, BYTES, COUNT);
        stream_case_take(&view, out.bytes, out.count);
        assert_int_equal(view.wrong, 0);
        assert_int_equal(view.shown, (1u << COUNT) - 1 - (failed < COUNT ? 1u << failed : 0));
        stream_case_close(&s, &out);
    }
}

static void a_key_frame_comes_when_it_is_asked_for(void **state)
{
    struct stream_case_bytes out = {0};
    struct stream_case_view view;
    uint8_t pictures[4][6 * 4] = {{1}, {2}, {3}, {4}};
    struct stream s = stream_case_open(&out, STREAM_GREY8, 6, 4, 4, true);
    size_t second = 0;
    (void)state;
    for (unsigned i = 0; i < 4; i++) {
        s.key = i == 2;
        if (i == 2)
            second = out.count;
        stream_case_send(&s, pictures[i], 4);
        assert_int_equal(s.key, 0);
    }
    stream_case_watch(&view, pictures[0], sizeof pictures[0], 4);
    stream_case_take(&view, out.bytes + second, out.count - second);
    assert_int_equal(view.shown, 12);
    stream_case_close(&s, &out);
}

struct heard {
    char hello[128], log[128];
    uint32_t hello_length, log_length;
};

static void hear_hello(void *context, const char *text, uint32_t length)
{
    struct heard *heard = context;
    assert_true(length <= sizeof heard->hello);
    memcpy(heard->hello, text, length);
    heard->hello_length = length;
}

static void hear_log(void *context, const char *text, uint32_t length)
{
    struct heard *heard = context;
    assert_true(length <= sizeof heard->log);
    memcpy(heard->log, text, length);
    heard->log_length = length;
}

static void names_and_lines_come_through(void **state)
{
    struct named {
        const char *name;
        int other;
    } scenes[2] = {{"torus", 1}, {"pawn", 2}};
    const char *methods[1] = {"x"};
    static const char wanted[] = "board\0torus\0pawn\0\0x";
    const struct stream_names names = {"board", {scenes, 2, sizeof scenes[0]}, {methods, 1, sizeof methods[0]}};
    struct heard heard = {0};
    const struct frames_events events = {.hello = hear_hello, .log = hear_log, .context = &heard};
    struct frames frames;
    struct stream_case_bytes out = {0};
    struct stream s = stream_case_open(&out, STREAM_GREY8, 6, 4, 4, false);
    (void)state;
    assert_int_equal(stream_hello(&s, &names), 0);
    assert_int_equal(stream_log(&s, "12 µs"), 0);
    assert_int_equal(stream_log(&s, ""), 0);
    frames_open(&frames, &events);
    frames_push(&frames, "booting\r\n", 9);
    frames_push(&frames, out.bytes, out.count);
    assert_int_equal(frames.parser.count, 0);
    frames_close(&frames);
    assert_int_equal(heard.hello_length, sizeof wanted);
    assert_memory_equal(heard.hello, wanted, sizeof wanted);
    assert_int_equal(heard.log_length, strlen("12 µs"));
    assert_memory_equal(heard.log, "12 µs", heard.log_length);
    stream_case_close(&s, &out);
}

static void a_line_too_long_is_cut_where_a_message_ends(void **state)
{
    char text[STREAM_MAX_LOG + 2], whole[STREAM_MAX_LOG + 1];
    struct stream_case_bytes out = {0}, cut = {0};
    struct stream s = stream_case_open(&out, STREAM_GREY8, 6, 4, 4, false), t = s;
    (void)state;
    for (unsigned i = 0; i < sizeof text; i++)
        text[i] = (char)('a' + i % 26);
    memcpy(whole, text, sizeof whole);
    text[sizeof text - 1] = whole[sizeof whole - 1] = 0;
    t.context = &cut;
    assert_int_equal(stream_log(&s, whole), 0);
    assert_int_equal(stream_log(&t, text), 0);
    assert_true(out.count > STREAM_MAX_LOG);
    assert_int_equal(cut.count, out.count);
    assert_memory_equal(cut.bytes, out.bytes, out.count);
    free(cut.bytes);
    stream_case_close(&s, &out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_example_of_the_protocol_is_what_is_sent),
        cmocka_unit_test(the_example_of_the_protocol_is_shown),
        cmocka_unit_test(pictures_come_back_in_every_format_and_band_height),
        cmocka_unit_test(noise_stays_within_the_bound),
        cmocka_unit_test(what_cannot_be_written_costs_its_frame_alone),
        cmocka_unit_test(a_key_frame_comes_when_it_is_asked_for),
        cmocka_unit_test(names_and_lines_come_through),
        cmocka_unit_test(a_line_too_long_is_cut_where_a_message_ends),
    };
    return cmocka_run_group_tests(tests, load, unload);
}
