/* SPDX-License-Identifier: MIT */
/* The handheld's program from its state to the glass of a model panel. */
#include "app/app.h"
#include "input.h"
#include "panel_case.h"

#include "frame_case.h"
#include "pack_case.h"

#define SCENES      3
#define TORUS       1 /* of program_scenes[]: nothing of it leaves the view */
#define TEAPOT      2
#define BLOB_WORDS  (64 * 1024 / 4)
#define MEMORY      (200u * 1024u)
#define BAND_ROWS   20
#define CELL        8  /* of large letters */
#define LINE        12 /* pixels */
#define WHITE       0xFFFF
#define GLASS_LARGE 0 /* of glasses[]: ST7789 240x240 */
#define GLASS_SMALL 8 /* SSD0323 128x64 */

static uint32_t blobs[SCENES][BLOB_WORDS], lengths[SCENES];
const struct program_scene program_scenes[] = {
    {"demo", blobs[0], &lengths[0]}, {"torus288", blobs[1], &lengths[1]}, {"teapot896", blobs[2], &lengths[2]}};
const unsigned program_scene_count = SCENES;

static uint32_t held, memory[MEMORY / 4], bands[2][BAND_ROWS * 240 / 2];
static struct board board;
static struct app app;

uint32_t input_buttons(void)
{
    return held;
}

static int load(void **state)
{
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        char path[64];
        struct pack_result packed;
        snprintf(path, sizeof path, "tests/scenes/%s.json", program_scenes[i].name);
        if (pack_load(path, NULL, &packed) != 0 || packed.size > sizeof blobs[i])
            return 1;
        memcpy(blobs[i], packed.scene, packed.size);
        lengths[i] = (uint32_t)packed.size;
        pack_free(&packed);
    }
    return 0;
}

/* The program, stopped and without figures, on a panel of that size. */
static void begin(unsigned glass, unsigned rotation, uint32_t memory_bytes)
{
    case_prepare(&glasses[glass], rotation);
    set.panel.memory = set.memory;
    set.panel.memory_size = 4u * set.height;
    assert_int_equal(case_open(), 0);
    board = (struct board){.name = "model",
                           .display = &set.panel.display,
                           .width = set.width,
                           .height = set.height,
                           .band_rows = BAND_ROWS,
                           .format = glasses[glass].controller->format,
                           .dither = 1,
                           .band = {bands[0], bands[1]},
                           .memory = memory,
                           .memory_bytes = memory_bytes};
    app =
        (struct app){.board = &board,
                     .control = {.scenes = SCENES, .methods = (uint16_t)glint_choice_count, .budget = CONTROL_BUDGET}};
    while (app_method(&app)->method != &glint_x)
        app.control.method++;
    show_ready(&app);
}

static void show(void)
{
    assert_int_equal(show_frame(&app), 0);
    assert_int_equal(show_finish(&app), 0);
    case_no_faults();
}

/* What the renderer makes of the app's state by itself becomes set.picture: 1 if that is not empty. */
static int draw(unsigned tables)
{
    struct frame_case f = frame_case_small(set.width, set.height, (enum glint_format)board.format);
    f.config.flags = GLINT_DITHER;
    f.config.method = app_method(&app)->method;
    f.config.tables = (uint8_t)tables;
    f.config.subdivide_tolerance = app.control.budget;
    frame_case_open_for(&f, app_scene(&app)->blob);
    glint_turn(&f.frame, app.control.yaw, app.control.pitch);
    frame_case_draw(&f, app_scene(&app)->blob, app.control.moment_ms);
    for (unsigned i = 0; i < set.width * set.height; i++)
        set.picture[i] = board.format == GLINT_RGB565 ? ((uint16_t *)(void *)f.picture)[i]
                                                      : (i & 1 ? f.picture[i / 2] & 15 : f.picture[i / 2] >> 4);
    frame_case_close(&f);
    for (unsigned i = 1; i < set.width * set.height; i++)
        if (set.picture[i] != set.picture[0])
            return 1;
    return 0;
}

static void the_glass_shows_what_the_renderer_draws(void **state)
{
    (void)state;
    for (unsigned glass = GLASS_LARGE; glass <= GLASS_SMALL; glass += GLASS_SMALL - GLASS_LARGE)
        for (unsigned rotation = 0; rotation < 360; rotation += 90) {
            begin(glass, rotation, sizeof memory);
            for (unsigned i = 0; i < 6; i++) {
                app.control.scene = (uint16_t)(i % SCENES);
                app.control.method = (uint16_t)((i * 7) % glint_choice_count);
                app.control.yaw = (uint16_t)(i * 5000);
                app.control.pitch = (uint16_t)(65536 - i * 3000);
                app.control.moment_ms = i * 300;
                app.control.budget = (uint8_t)(i + 1);
                show_ready(&app);
                show();
                assert_null(app.problem);
                assert_true(draw(board.format == GLINT_RGB565));
                assert_int_equal(case_wrong(0, 0), 0);
            }
        }
}

/* Less memory by a step, which must leave a picture, if a poorer one. */
static void take_away(uint32_t bytes)
{
    assert_true(board.memory_bytes > bytes);
    board.memory_bytes -= bytes;
    show_ready(&app);
    assert_null(app.problem);
}

static void the_table_is_given_up_first(void **state)
{
    (void)state;
    begin(GLASS_LARGE, 0, sizeof memory);
    app.control.scene = TEAPOT;
    show_ready(&app);
    const struct glint_config whole = app.share.frame.config;
    assert_int_equal(whole.tables, 1);
    assert_true(whole.max_clipped > 64);
    take_away(board.memory_bytes - (uint32_t)glint_memory_needed(&whole) + 4);
    assert_int_equal(app.share.frame.config.tables, 0);
    assert_int_equal(app.share.frame.config.max_triangles, whole.max_triangles);
    show();
    assert_true(draw(0));
    assert_int_equal(case_wrong(0, 0), 0);
    while (app.share.frame.config.max_clipped == whole.max_clipped)
        take_away(256);
    assert_int_equal(app.share.frame.config.max_clipped, 64);
    assert_int_equal(app.share.frame.config.max_triangles, whole.max_triangles - (whole.max_clipped - 64));
    show();
    assert_int_equal(app.share.frame.stats.dropped, 0);
    while (app.share.frame.config.max_triangles > 64)
        take_away(256);
    show();
    assert_int_equal(app.share.frame.stats.drawn[GLINT_X], app.share.frame.config.max_triangles);
    assert_true(app.share.frame.stats.dropped > 0);
    board.memory_bytes = 4096;
    show_ready(&app);
    assert_string_equal(app.problem, "no room for its vertices");
    show();
    assert_true(draw(0) && case_wrong(0, 0) > 0);
}

static void a_scene_that_is_not_clipped_takes_no_room_for_pieces(void **state)
{
    (void)state;
    begin(GLASS_LARGE, 0, sizeof memory);
    app.control.scene = TORUS;
    show_ready(&app);
    const uint16_t all = app.share.frame.config.max_triangles;
    assert_int_equal(app.share.frame.config.max_clipped, 0);
    while (app.share.frame.config.max_triangles == all)
        take_away(256);
    assert_int_equal(app.share.frame.config.max_clipped, 0);
    assert_in_range(app.share.frame.config.max_triangles, all - 256 / 10, all - 1);
}

/* Pixels of the picture that are not as drawn, outside and inside of columns [0, right), rows [top, bottom). */
static void differences(unsigned right, unsigned top, unsigned bottom, unsigned counts[2])
{
    counts[0] = counts[1] = 0;
    for (unsigned y = 0; y < set.height; y++)
        for (unsigned x = 0; x < set.width; x++)
            counts[x < right && y >= top && y < bottom] += case_seen(x, y, 0, 0) != set.picture[y * set.width + x];
}

static void the_menu_leaves_the_scene_around_it(void **state)
{
    (void)state;
    for (unsigned glass = GLASS_LARGE; glass <= GLASS_SMALL; glass += GLASS_SMALL - GLASS_LARGE) {
        unsigned large = glass == GLASS_LARGE, counts[2];
        begin(glass, 0, sizeof memory);
        app.control.menu = 1;
        for (unsigned line = 0; line < CONTROL_LINES; line++) {
            app.control.line = (uint8_t)line;
            show();
            assert_true(draw(large));
            unsigned cell = large ? CELL : CELL / 2, row = large ? LINE : LINE / 2, right = 19 * cell;
            differences(right, row - row / 6, (1 + CONTROL_LINES) * row, counts);
            assert_int_equal(counts[0], 0);
            assert_true(counts[1] > 1000u);
            for (unsigned i = 0; i < CONTROL_LINES; i++) /* between two letters, and below the last one */
                assert_int_equal(case_seen(right - 1, (i + 2) * row - 1, 0, 0),
                                 i == line || i + 1 == line ? (large ? WHITE : 15) : 0);
        }
    }
}

static void the_longest_line_of_the_menu_fits(void **state)
{
    (void)state;
    begin(GLASS_LARGE, 0, sizeof memory);
    while (strcmp(app_method(&app)->name, "biquadratic-perspective") != 0)
        app.control.method = (uint16_t)((app.control.method + 1) % glint_choice_count);
    show_ready(&app);
    for (unsigned i = 0; i < glint_choice_count; i++)
        assert_true(strlen(glint_choices[i].name) <= 240 / CELL - MENU_LABEL);
    app.control.menu = 1;
    show();
    unsigned lit = 0; /* of the last letter, an E: its upright's five pixels, and three bars of two more */
    for (unsigned y = 2 * LINE; y < 3 * LINE; y++)
        for (unsigned x = 240 - CELL; x < 240; x++)
            lit += case_seen(x, y, 0, 0) == WHITE;
    assert_int_equal(lit, 4 * (5 + 2 + 1 + 2));
}

static void figures_are_at_the_edges(void **state)
{
    (void)state;
    begin(GLASS_LARGE, 0, sizeof memory);
    show();
    show_repaint(&app);
    show(); /* without what turns the display on */
    app.control.figures = 1;
    app.rate = 599;
    app.share.draw_us = 12345;
    unsigned counts[2];
    uint32_t sent = app.sent;
    assert_true(sent > 240 * 240 * 2);
    show();
    assert_true(app.sent > 0 && app.sent <= 2 * LINE * 240 * 2 + 22);
    assert_true(draw(1));
    for (unsigned y = LINE; y < 240 - LINE; y++)
        for (unsigned x = 0; x < 240; x++)
            assert_int_equal(case_seen(x, y, 0, 0), set.picture[y * 240 + x]);
    differences(17 * CELL, 0, LINE, counts); /* "59.9 fps 12345 us" */
    assert_true(counts[1] > 300);
    show_repaint(&app);
    show();
    assert_int_equal(app.sent, sent);
}

static void the_test_shows_colours_under_words(void **state)
{
    (void)state;
    static const uint16_t colours[] = {0xFFFF, 0xFFE0, 0x07FF, 0x07E0, 0xF81F, 0xF800, 0x001F, 0};
    for (unsigned rotation = 0; rotation < 360; rotation += 90) {
        begin(GLASS_LARGE, rotation, sizeof memory);
        app.control.test = HAL_A;
        show();
        for (unsigned i = 0; i < 240; i++)
            assert_true(case_seen(i, 0, 0, 0) == WHITE && case_seen(i, 239, 0, 0) == WHITE &&
                        case_seen(0, i, 0, 0) == WHITE && case_seen(239, i, 0, 0) == WHITE);
        for (unsigned bar = 0; bar < 8; bar++)
            for (unsigned y = 20; y < 180; y += 130)
                assert_int_equal(case_seen(bar * 30 + 15, y, 0, 0), colours[bar]);
        static const uint16_t full[] = {0xF800, 0x07C0, 0x001F, 0xFFDF};
        for (unsigned ramp = 0; ramp < 4; ramp++) {
            assert_int_equal(case_seen(238, 187 + 15 * ramp, 0, 0), full[ramp]);
            assert_int_equal(case_seen(1, 187 + 15 * ramp, 0, 0), 0);
            for (unsigned x = 2; x < 238; x++)
                assert_true(case_seen(x, 187 + 15 * ramp, 0, 0) >= case_seen(x - 1, 187 + 15 * ramp, 0, 0));
        }
        char wanted[64];
        struct text_line line = {.length = 0};
        snprintf(wanted, sizeof wanted, "test model 240x240, rotation %u", rotation);
        report_picture(&app, &line);
        assert_string_equal(line.text, wanted);
        unsigned black = 0;
        for (unsigned y = 4 * LINE; y < 6 * LINE; y++)
            for (unsigned x = CELL; x < 10 * CELL; x++)
                black += case_seen(x, y, 0, 0) == 0;
        assert_true(black > 500); /* words in a box of black, on white, yellow and cyan */
    }
}

static void a_damaged_scene_is_named_and_the_menu_leads_away(void **state)
{
    (void)state;
    begin(GLASS_SMALL, 0, sizeof memory);
    blobs[1][100] ^= 1;
    app.control.scene = 1;
    show_ready(&app);
    assert_non_null(app.problem);
    show();
    unsigned lit = 0;
    for (unsigned i = 0; i < 128 * 64; i++)
        lit += case_seen(i % 128, i / 128, 0, 0) == 15;
    assert_true(lit > 100);
    app.control.menu = 1;
    show();
    struct text_line line = {.length = 0};
    report_picture(&app, &line);
    assert_string_equal(line.text, "error torus288: the scene is damaged: its CRC does not match, menu scene");
    assert_int_equal(case_seen(0, 6, 0, 0), 15); /* the chosen line's corner */
    blobs[1][100] ^= 1;
    app.control.menu = 0;
    app.control.scene = 2;
    show_ready(&app);
    show();
    assert_true(draw(0));
    assert_int_equal(case_wrong(0, 0), 0);
}

static void reports_say_all(void **state)
{
    (void)state;
    begin(GLASS_LARGE, 0, sizeof memory);
    app.control.yaw = 16384;
    app.control.pitch = 65535;
    app.control.moment_ms = 4294967295u;
    app.share.draw_us = 987654321;
    app.sent = 115211;
    app.control.budget = 12;
    struct text_line line = {.length = 0};
    report_picture(&app, &line);
    assert_string_equal(line.text,
                        "frame demo x 4294967295 ms, 987654321 us, turn 90.000,359.995, budget 12, 115211 bytes");
    app.control.running = app.control.menu = 1;
    app.control.line = CONTROL_LINE_SCREEN;
    app.share.frame.stats.dropped = 17;
    app.control.method = 18;
    line.length = 0;
    report_picture(&app, &line);
    assert_non_null(strstr(line.text, " bytes, running, 17 dropped, menu screen"));
    assert_true(line.length < sizeof line.text - 1);
}

static void an_angle_in_words_is_that_angle(void **state)
{
    (void)state;
    for (unsigned angle = 0; angle < 65536; angle++) {
        struct text_line line = {.length = 0};
        text_add_angle(&line, (uint16_t)angle);
        assert_true(line.length >= 5 && line.text[line.length - 4] == '.');
        assert_int_equal(lrint(atof(line.text) * 65536 / 360), angle);
    }
}

static void an_error_of_the_display_is_told(void **state)
{
    (void)state;
    begin(GLASS_LARGE, 0, sizeof memory);
    show();
    int calls = set.wires.calls;
    show_repaint(&app);
    show();
    calls = set.wires.calls - calls;
    for (int i = 0; i < calls; i++) {
        show_repaint(&app);
        set.wires.fail_at = set.wires.calls + i;
        int error = show_frame(&app);
        assert_int_equal(error ? error : show_finish(&app), HAL_E_IO);
        set.wires.fail_at = -1;
        assert_int_equal(panel_display.close(&set.panel.display, 0), 0);
        assert_int_equal(case_open(), 0);
        show();
        assert_true(draw(1));
        assert_int_equal(case_wrong(0, 0), 0);
    }
}

/* The test's last band is sent before the picture that follows is drawn into its buffer, which then never goes out. */
static void the_last_band_of_the_test_is_on_the_glass(void **state)
{
    (void)state;
    begin(GLASS_LARGE, 0, sizeof memory);
    board.band_rows = 16; /* fifteen bands: the last one and the first share a buffer */
    show_ready(&app);
    app.control.test = HAL_A;
    show();
    for (unsigned i = 0; i < 240 * 240; i++)
        set.picture[i] = case_seen(i % 240, i / 240, 0, 0);
    show_repaint(&app);
    assert_int_equal(show_frame(&app), 0);
    app.control.test = 0;
    set.wires.fail_at = set.wires.calls;
    assert_int_equal(show_frame(&app), HAL_E_IO);
    assert_int_equal(case_wrong(0, 0), 0);
}

static void a_button_pressed_while_a_picture_is_drawn_is_seen(void **state)
{
    (void)state;
    begin(GLASS_LARGE, 0, sizeof memory);
    held = HAL_B;
    show();
    held = 0;
    assert_int_equal(app.buttons, HAL_B);
}

static void words_stay_in_their_band_and_width(void **state)
{
    (void)state;
    static const uint16_t widths[] = {120, 239, 240, 241};
    for (unsigned w = 0; w < 4; w++)
        for (unsigned format = 0; format < 2; format++) {
            /* 41 letters of 24 or 12 rows in bands of 5, each beside sentinels, against one band of all rows */
            enum { ROWS = 40, STRIDE = 500 };
            static uint8_t whole[ROWS][STRIDE], part[ROWS][STRIDE];
            struct glint_band band = {whole, 0, ROWS, STRIDE};
            struct text_canvas canvas = {.band = &band,
                                         .width = widths[w],
                                         .format = format ? GLINT_GREY4 : GLINT_RGB565,
                                         .dark = (uint8_t)(w & 1)};
            static const char words[] = "The QUICK brown fox, 0123456789: -./!jumps";
            memset(whole, 0x77, sizeof whole);
            memset(part, 0x77, sizeof part);
            text_draw(&canvas, 3, 7, words);
            for (unsigned y = 0; y < ROWS; y += 5) {
                band = (struct glint_band){part[y], (uint16_t)y, 5, STRIDE};
                text_draw(&canvas, 3, 7, words);
            }
            assert_memory_equal(whole, part, sizeof whole);
            unsigned written = format ? (widths[w] + 1u) / 2 : 2u * widths[w];
            unsigned touched = 0;
            for (unsigned y = 0; y < ROWS; y++)
                for (unsigned x = 0; x < STRIDE; x++) {
                    int inside = x < written && y + (canvas.dark << text_large(widths[w])) >= 7 &&
                                 y < 7 + text_height(widths[w]);
                    touched += whole[y][x] != 0x77;
                    assert_true(inside || whole[y][x] == 0x77);
                }
            assert_true(touched > 300);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_glass_shows_what_the_renderer_draws),
        cmocka_unit_test(the_table_is_given_up_first),
        cmocka_unit_test(a_scene_that_is_not_clipped_takes_no_room_for_pieces),
        cmocka_unit_test(the_menu_leaves_the_scene_around_it),
        cmocka_unit_test(the_longest_line_of_the_menu_fits),
        cmocka_unit_test(figures_are_at_the_edges),
        cmocka_unit_test(the_test_shows_colours_under_words),
        cmocka_unit_test(a_damaged_scene_is_named_and_the_menu_leads_away),
        cmocka_unit_test(reports_say_all),
        cmocka_unit_test(an_angle_in_words_is_that_angle),
        cmocka_unit_test(an_error_of_the_display_is_told),
        cmocka_unit_test(the_last_band_of_the_test_is_on_the_glass),
        cmocka_unit_test(a_button_pressed_while_a_picture_is_drawn_is_seen),
        cmocka_unit_test(words_stay_in_their_band_and_width),
    };
    return cmocka_run_group_tests(tests, load, NULL);
}
