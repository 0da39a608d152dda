/* SPDX-License-Identifier: MIT */
/* The words over the window's picture: figures of a stream, lines, letters. */
#include "view/overlay.h"
#include "view/status.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

enum { BOX = 0xB0, INK = 0xFF };

/* The canvas as text: a space where nothing is, . the box, # ink. */
static const char *drawn(enum overlay_place place, const char *line, unsigned width, unsigned height)
{
    static char out[400];
    static uint32_t pixels[400];
    struct overlay_text text = {.count = 0};
    struct overlay o = {pixels, width, height};
    char *at = out;
    memset(pixels, 0, sizeof pixels);
    overlay_add(&text, "%s", line);
    overlay_draw(&o, place, &text);
    for (unsigned i = 0; i < width * height; i++) {
        unsigned alpha = pixels[i] >> 24;
        *at++ = alpha == INK ? '#' : alpha == BOX ? '.' : alpha == 0 ? ' ' : '!';
        if (i % width == width - 1)
            *at++ = '|';
    }
    *at = 0;
    return out;
}

static void letters_stand_in_a_box(void **state)
{
    (void)state;
    assert_string_equal(drawn(OVERLAY_TOP, "i?", 13, 10), "...........  |"
                                                          "...........  |"
                                                          "..###.###..  |"
                                                          "...#....#..  |"
                                                          "...#...#...  |"
                                                          "...#.......  |"
                                                          "..###..#...  |"
                                                          "...........  |"
                                                          "...........  |"
                                                          "             |");
    assert_string_equal(drawn(OVERLAY_MIDDLE, "-", 11, 11), "           |"
                                                            "  .......  |"
                                                            "  .......  |"
                                                            "  .......  |"
                                                            "  .......  |"
                                                            "  ..###..  |"
                                                            "  .......  |"
                                                            "  .......  |"
                                                            "  .......  |"
                                                            "  .......  |"
                                                            "           |");
    assert_string_equal(drawn(OVERLAY_BOTTOM, ".", 8, 10), "        |"
                                                           "....... |"
                                                           "....... |"
                                                           "....... |"
                                                           "....... |"
                                                           "....... |"
                                                           "....... |"
                                                           "...#... |"
                                                           "....... |"
                                                           "....... |");
}

static void what_has_no_room_is_cut_off(void **state)
{
    (void)state;
    assert_string_equal(drawn(OVERLAY_TOP, "iiiiiiiiiiii", 6, 4), "......|"
                                                                  "......|"
                                                                  "..###.|"
                                                                  "...#..|");
    assert_string_equal(drawn(OVERLAY_BOTTOM, "iiiiiiiiiiii", 6, 4), "......|"
                                                                     "......|"
                                                                     "..###.|"
                                                                     "...#..|");
    assert_string_equal(drawn(OVERLAY_MIDDLE, "", 3, 1), "   |");
}

static void every_printable_letter_but_the_space_has_ink(void **state)
{
    char line[2] = "";
    (void)state;
    for (line[0] = ' '; line[0] <= '~'; line[0]++)
        assert_int_equal(strchr(drawn(OVERLAY_TOP, line, 7, 9), '#') != NULL, line[0] != ' ');
}

static void lines_keep_to_their_room_and_to_letters(void **state)
{
    char longest[OVERLAY_COLUMNS * 3 + 1];
    struct overlay_text text = {.count = 0};
    (void)state;
    overlay_add(&text, "a\tb\x1b\x7f\xC3\xA4\xE2\x82\xAC!");
    assert_string_equal(text.lines[0], "a?b???"
                                       "?!");
    memset(longest, 'x', sizeof longest);
    longest[sizeof longest - 1] = 0;
    for (unsigned i = 1; i < OVERLAY_LINES + 5; i++)
        overlay_add(&text, "%s", longest);
    assert_int_equal(text.count, OVERLAY_LINES);
    assert_int_equal(strlen(text.lines[OVERLAY_LINES - 1]), OVERLAY_COLUMNS);
}

static const char hello[] = "picosystem\0torus800\0scenes/demo.json\0\0gouraud\0x\0";

static void figures_say_what_the_device_says(void **state)
{
    static struct names names;
    struct meter meter = {.latency_ms = 12.34};
    struct frames_picture p = {.pixels = (const uint8_t *)"",
                               .width = 240,
                               .height = 240,
                               .number = 77,
                               .moment_ms = 2050,
                               .bytes = 11520,
                               .bands = {1, 3, 12},
                               .scene = 1,
                               .method = 1,
                               .budget = 4,
                               .draw_us = 9000,
                               .pack_us = 3000,
                               .triangles = 800,
                               .drawn = 410,
                               .dropped = 2,
                               .skipped = 5};
    struct status status = {.port = "usb:1", .names = &names, .picture = &p, .meter = &meter, .lost = 3};
    static const char *const few[] = {"demo.json by x, budget 4/255", "50.0 pictures/s, latency 12.3 ms",
                                      "576 KB/s, 10.0:1, lost 3, left out 5"};
    static const char *const want[] = {"picosystem, usb:1",
                                       "demo.json by x, budget 4/255",
                                       "240x240 rgb565, picture 77, 2.050 s",
                                       "drawn in 9000 us, packed in 3000 us",
                                       "410 of 800 triangles, 2 without memory",
                                       "50.0 pictures/s, latency 12.3 ms",
                                       "11520 bytes a picture, 576 KB/s",
                                       "compressed 10.0:1, raw 6, qoi 19, change 75 %",
                                       "lost here 3, left out by the device 5"};
    struct overlay_text text = {.count = 0};
    char title[100];
    (void)state;
    names_set(&names, hello, sizeof hello - 1);
    for (unsigned i = 0; i <= 25; i++) /* one every 20 ms */
        if (!meter_turn(&meter, 1000. + 20. * i))
            meter_picture(&meter, &p, 1000. + 20. * i);
    status_figures(&status, &text);
    assert_int_equal(text.count, sizeof few / sizeof *few);
    for (unsigned i = 0; i < text.count; i++)
        assert_string_equal(text.lines[i], few[i]);
    status.details = true;
    text.count = 0;
    status_figures(&status, &text);
    assert_int_equal(text.count, sizeof want / sizeof *want);
    for (unsigned i = 0; i < text.count; i++)
        assert_string_equal(text.lines[i], want[i]);
    status_title(&status, title, sizeof title);
    assert_string_equal(title, "picosystem, 240x240, 50.0 pictures/s - Glint");
    status_title(&status, title, 8);
    assert_string_equal(title, "picosys");
}

static void before_the_first_picture_there_is_nothing_to_say(void **state)
{
    static struct names names;
    struct meter meter = {0};
    const struct status status = {.port = "-", .names = &names, .meter = &meter};
    struct overlay_text text = {.count = 0};
    char title[100];
    (void)state;
    status_figures(&status, &text);
    assert_int_equal(text.count, 0);
    status_title(&status, title, sizeof title);
    assert_string_equal(title, "- - Glint");
}

static void a_place_that_hello_does_not_name_is_unknown(void **state)
{
    static struct names names;
    struct meter meter = {0};
    const struct frames_picture p = {.width = 1, .height = 1, .scene = 2, .method = 255, .paused = true};
    const struct status status = {.port = "-", .names = &names, .meter = &meter, .picture = &p};
    struct overlay_text text = {.count = 0};
    (void)state;
    names_set(&names, hello, sizeof hello - 1);
    status_figures(&status, &text);
    assert_int_equal(text.count, 2);
    assert_string_equal(text.lines[0], "? by ?, stopped");
    assert_string_equal(text.lines[1], "0.0 pictures/s"); /* nor is there a latency, or anything of bytes */
}

static void notes_are_forgotten_in_time(void **state)
{
    struct status_notes notes = {.notes = {{.until = 0.}}};
    struct overlay_text text = {.count = 0};
    char line[] = "note 0";
    (void)state;
    for (unsigned i = 0; i < STATUS_NOTES + 1; i++) {
        line[5] = (char)('0' + i);
        status_note(&notes, line, 6, 100. * i);
    }
    status_list(&notes, &text);
    assert_int_equal(text.count, STATUS_NOTES);
    assert_string_equal(text.lines[0], "note 1");
    assert_false(status_forget(&notes, STATUS_NOTE_MS + 99.));
    assert_true(status_forget(&notes, STATUS_NOTE_MS + 200.));
    text.count = 0;
    status_list(&notes, &text);
    assert_int_equal(text.count, STATUS_NOTES - 2);
    assert_string_equal(text.lines[0], "note 3");
}

static void a_long_note_is_cut_off(void **state)
{
    struct status_notes notes = {.notes = {{.until = 0.}}};
    struct overlay_text text = {.count = 0};
    static char longest[1024];
    (void)state;
    memset(longest, 'n', sizeof longest);
    status_note(&notes, longest, sizeof longest, 0.);
    status_list(&notes, &text);
    assert_int_equal(strlen(text.lines[0]), OVERLAY_COLUMNS);
}

static void the_keys_have_a_line_each(void **state)
{
    struct overlay_text text = {.count = 0};
    (void)state;
    status_keys(&text);
    assert_in_range(text.count, 10, OVERLAY_LINES - 1);
    for (unsigned i = 0; i < text.count; i++)
        assert_in_range(strlen(text.lines[i]), 1, OVERLAY_COLUMNS - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(letters_stand_in_a_box),
                                       cmocka_unit_test(what_has_no_room_is_cut_off),
                                       cmocka_unit_test(every_printable_letter_but_the_space_has_ink),
                                       cmocka_unit_test(lines_keep_to_their_room_and_to_letters),
                                       cmocka_unit_test(figures_say_what_the_device_says),
                                       cmocka_unit_test(before_the_first_picture_there_is_nothing_to_say),
                                       cmocka_unit_test(a_place_that_hello_does_not_name_is_unknown),
                                       cmocka_unit_test(notes_are_forgotten_in_time),
                                       cmocka_unit_test(a_long_note_is_cut_off),
                                       cmocka_unit_test(the_keys_have_a_line_each)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
