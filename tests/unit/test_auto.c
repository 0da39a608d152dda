/* SPDX-License-Identifier: MIT */
/* glint_auto over whole pictures: what it drops exactly, counts, and does with a budget that changes. That every pixel
 * stays within the budget is tests/budget's to see. */
#include "pack/pack.h"
#include "scene/scene.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#include "frame_case.h"
#include "scene_case.h"

static const char *const names[] = {"torus288",       "sphere690",  "teapot896-grey", "torus288-persp", "pawn",
                                    "two-sided-bowl", "fog-linear", "texture-quad",   "bump-torus288"};
#define SCENES (sizeof names / sizeof *names)
static struct pack_result scenes[SCENES];

static int load(void **state)
{
    (void)state;
    int bad = 0;
    for (size_t i = 0; i < SCENES; i++) {
        char path[64];
        snprintf(path, sizeof path, "tests/scenes/%s.json", names[i]);
        bad |= pack_load(path, NULL, &scenes[i]);
    }
    return bad;
}

static int unload(void **state)
{
    (void)state;
    for (size_t i = 0; i < SCENES; i++)
        pack_free(&scenes[i]);
    return 0;
}

static struct frame_case by_auto(enum glint_format format, unsigned budget)
{
    struct frame_case f = frame_case_small(120, 120, format);
    f.config.method = &glint_auto;
    f.config.budget = GLINT_BUDGET(budget, 1);
    return f;
}

static void assert_same(struct frame_case a, struct frame_case b, const void *scene, const char *name)
{
    const size_t bytes = glint_row_bytes(&a.config) * a.config.height;
    uint8_t *one = frame_case_picture(a, scene, 0, NULL), *other = frame_case_picture(b, scene, 0, NULL);
    if (memcmp(one, other, bytes) != 0)
        fail_msg("%s: format %d, tables %d, budget %d", name, a.config.format, a.config.tables, a.config.budget / 256);
    free(one);
    free(other);
}

static void what_is_dropped_as_it_cannot_show_changes_no_byte(void **state)
{
    (void)state;
    static const unsigned budgets[] = {1, 4, 32};
    for (size_t i = 0; i < SCENES; i++)
        for (int format = GLINT_RGB565; format <= GLINT_GREY8; format++)
            for (int b = 0; b < 3; b++)
                for (int tables = 0; tables < 2; tables++) {
                    struct frame_case planned = by_auto((enum glint_format)format, budgets[b]), kept;
                    planned.config.tables = (uint8_t)tables;
                    kept = planned;
                    kept.config.flags = GLINT_NO_PLAN;
                    assert_same(planned, kept, scenes[i].scene, names[i]);
                }
}

static void a_picture_is_the_same_in_any_bands(void **state)
{
    (void)state;
    for (size_t i = 0; i < SCENES; i++)
        for (int format = GLINT_RGB565; format <= GLINT_GREY8; format++) {
            struct frame_case whole = by_auto((enum glint_format)format, 3), bands = whole;
            whole.config.tables = bands.config.tables = 1;
            bands.config.band_rows = 7;
            assert_same(whole, bands, scenes[i].scene, names[i]);
        }
}

static void a_budget_counts_from_the_next_frame_on(void **state)
{
    (void)state;
    struct frame_case f = by_auto(GLINT_GREY8, 1);
    const uint16_t budgets[] = {GLINT_BUDGET(1, 1), GLINT_BUDGET(32, 1), GLINT_BUDGET(1, 2), 0, GLINT_BUDGET(8, 1)};
    frame_case_open_for(&f, scenes[0].scene);
    for (size_t i = 0; i < sizeof budgets / sizeof *budgets; i++) {
        struct frame_case fresh = by_auto(GLINT_GREY8, 0);
        fresh.config.budget = budgets[i];
        glint_set_budget(&f.frame, budgets[i]);
        frame_case_draw(&f, scenes[0].scene, 0);
        uint8_t *expected = frame_case_picture(fresh, scenes[0].scene, 0, NULL);
        assert_memory_equal(f.picture, expected, f.picture_bytes);
        free(expected);
        const uint16_t allowed = budgets[i] ? budgets[i] : GLINT_BUDGET(2, 1);
        assert_in_range(f.frame.stats.largest_error, allowed / 2, allowed);
    }
    frame_case_close(&f);
}

static void more_budget_takes_plainer_methods(void **state)
{
    (void)state;
    uint32_t last = UINT32_MAX, plain[2] = {0, 0};
    for (unsigned budget = 1; budget <= 64; budget *= 2) {
        struct glint_stats s;
        free(frame_case_picture(by_auto(GLINT_GREY8, budget), scenes[0].scene, 0, &s));
        assert_true(s.pixels[GLINT_DUFF] <= last);
        last = s.pixels[GLINT_DUFF];
        plain[budget > 8] += s.pixels[GLINT_CONSTANT] + s.pixels[GLINT_GOURAUD];
    }
    assert_int_equal(last, 0);
    assert_true(plain[1] > 4 * plain[0]);
}

static void each_rung_is_taken_somewhere(void **state)
{
    (void)state;
    static const int rungs[] = {GLINT_DARK, GLINT_CONSTANT, GLINT_GOURAUD, GLINT_LINEAR,
                                GLINT_SIX,  GLINT_DUFF,     GLINT_PHONG};
    struct glint_stats s;
    uint32_t drawn[GLINT_METHODS] = {0}, hidden = 0, dropped = 0, straight = 0, undivided = 0;
    for (size_t i = 0; i < SCENES; i++)
        for (unsigned budget = 2; budget <= 8; budget += 6) {
            free(frame_case_picture(by_auto(GLINT_GREY8, budget), scenes[i].scene, 0, &s));
            for (int m = 0; m < GLINT_METHODS; m++)
                drawn[m] += s.drawn[m];
            hidden += s.hidden_highlights;
            dropped += s.dropped_highlights;
            straight += s.straightened;
            undivided += s.undivided;
        }
    for (size_t i = 0; i < sizeof rungs / sizeof *rungs; i++)
        if (!drawn[rungs[i]])
            fail_msg("nothing is drawn by %s", glint_method_names[rungs[i]]);
    assert_true(hidden && dropped && straight && undivided);
}

/* Mixtures of bump maps, fog and plain triangles, what counts is a triangle's own. */
static void what_is_counted_is_of_the_triangle_itself(void **state)
{
    (void)state;
    for (size_t i = 0; i < SCENES; i++) {
        struct glint_stats s;
        uint32_t linear = 0, drawn = 0, lights = ((const struct scene_header *)scenes[i].scene)->light_count;
        free(frame_case_picture(by_auto(GLINT_GREY8, 2), scenes[i].scene, 0, &s));
        for (int m = 0; m < GLINT_METHODS; m++)
            drawn += s.drawn[m];
        linear = s.drawn[GLINT_LINEAR] + s.drawn[GLINT_SIX];
        assert_in_range(s.straightened, 0, 2 * lights * linear);
        assert_in_range(s.hidden_lights, 0, lights * (drawn - s.fogged_wholly));
    }
}

static void a_light_that_reaches_nothing_is_computed_nowhere(void **state)
{
    (void)state;
    struct pack_result behind;
    struct glint_stats s;
    assert_int_equal(pack_load("tests/scenes/torus288.json", NULL, &behind), 0);
    struct scene_light *light = (struct scene_light *)(uintptr_t)scene_lights(behind.scene);
    for (int i = 0; i < 3; i++)
        light->vector[i] = -light->vector[i]; /* no check is asked of the blob again */
    free(frame_case_picture(by_auto(GLINT_GREY8, 2), behind.scene, 0, &s));
    /* vertices at the rim are lit a little, and their triangles are one colour or nearly dark */
    assert_true(s.drawn[GLINT_DARK] > 80 && s.hidden_lights >= s.drawn[GLINT_DARK]);
    assert_true(s.hidden_highlights >= s.drawn[GLINT_DARK]);
    pack_free(&behind);
}

static void a_worker_counts_what_is_left_out(void **state)
{
    (void)state;
    struct frame_case f = by_auto(GLINT_GREY8, 2);
    struct glint_stats alone;
    free(frame_case_picture(f, scenes[0].scene, 0, &alone));
    f.config.band_rows = 60;
    frame_case_open_for(&f, scenes[0].scene);
    struct glint_frame worker;
    struct glint_band band;
    const size_t bytes = glint_worker_memory_needed(&f.config);
    void *memory = malloc(bytes);
    assert_non_null(memory);
    assert_int_equal(glint_worker_init(&worker, &f.frame, memory, bytes), 0);
    assert_int_equal(glint_frame_begin(&f.frame, scenes[0].scene, 0), 0);
    glint_worker_begin(&worker, &f.frame);
    assert_int_equal(glint_frame_band(&f.frame, 0, f.config.band[0], &band), 1);
    assert_int_equal(glint_frame_band(&worker, 1, f.config.band[0], &band), 1);
    glint_worker_end(&worker, &f.frame);
    const struct glint_stats *s = &f.frame.stats;
    assert_int_equal(s->hidden_lights, alone.hidden_lights);
    assert_int_equal(s->hidden_highlights, alone.hidden_highlights);
    assert_int_equal(s->dropped_highlights, alone.dropped_highlights);
    assert_int_equal(s->straightened, alone.straightened);
    assert_int_equal(s->largest_error, alone.largest_error);
    free(memory);
    frame_case_close(&f);
}

static void a_picture_of_the_plan_counts_as_the_plan(void **state)
{
    (void)state;
    for (size_t i = 0; i < SCENES; i++) {
        struct frame_case f = by_auto(GLINT_RGB888, 2), shown = f;
        struct glint_stats a, b;
        shown.config.method = &glint_auto_shown;
        free(frame_case_picture(f, scenes[i].scene, 0, &a));
        free(frame_case_picture(shown, scenes[i].scene, 0, &b));
        assert_memory_equal(a.drawn, b.drawn, sizeof a.drawn);
        assert_memory_equal(a.pixels, b.pixels, sizeof a.pixels);
    }
}

/* The colours of methods, and the brightnesses, of 256, by which triangles of one differ. */
static const uint8_t legend[GLINT_METHODS][3] = {
    [GLINT_DARK] = {45, 45, 60},
    [GLINT_CONSTANT] = {60, 110, 220},
    [GLINT_GOURAUD] = {60, 170, 75},
    [GLINT_LINEAR] = {200, 215, 70},
    [GLINT_SIX] = {245, 150, 40},
    [GLINT_DUFF] = {215, 50, 50},
    [GLINT_PHONG] = {190, 60, 200},
    [GLINT_BUMP_LINEAR] = {120, 215, 225},
    [GLINT_BUMP_QUADRATIC] = {50, 155, 190},
    [GLINT_BUMP_NORMALISED] = {30, 95, 150},
};
static const int brightnesses[] = {256, 244, 232, 220, 208, 196, 184, 172};

static int is_lit_so(const uint8_t *pixel, const uint8_t *colour, unsigned channels, int by)
{
    for (unsigned c = 0; c < channels; c++)
        if (pixel[c] != (colour[c] * by + 128) / 256)
            return 0;
    return 1;
}

/* Whether a pixel is in the colour of some method that drew something. */
static int is_in_the_legend(const uint8_t *pixel, unsigned channels, const struct glint_stats *stats)
{
    for (int id = 0; id < GLINT_METHODS; id++) {
        const uint8_t *rgb = legend[id];
        const uint8_t grey = (uint8_t)((77 * rgb[0] + 150 * rgb[1] + 29 * rgb[2]) / 256);
        for (int i = 0; i < 8 && stats->drawn[id]; i++)
            if (is_lit_so(pixel, channels == 1 ? &grey : rgb, channels, brightnesses[i]))
                return 1;
    }
    return 0;
}

static void a_picture_of_the_plan_is_in_the_colours_of_its_legend(void **state)
{
    (void)state;
    for (size_t i = 0; i < 2 * SCENES; i++) {
        const unsigned channels = i < SCENES ? 3 : 1;
        struct frame_case f = by_auto(channels == 3 ? GLINT_RGB888 : GLINT_GREY8, 2);
        struct glint_stats stats;
        long shown = 0;
        f.config.method = &glint_auto_shown;
        uint8_t *picture = frame_case_picture(f, scenes[i % SCENES].scene, 0, &stats);
        for (long at = 0; at < 120 * 120; at++) {
            const uint8_t *pixel = picture + at * channels;
            if (memcmp(pixel, picture, channels) == 0) /* the background, as in the first corner */
                continue;
            if (!is_in_the_legend(pixel, channels, &stats))
                fail_msg("%s: %u channels, pixel %ld is %d %d %d", names[i % SCENES], channels, at, pixel[0],
                         channels == 3 ? pixel[1] : 0, channels == 3 ? pixel[2] : 0);
            shown++;
        }
        assert_true(shown > 1000);
        free(picture);
    }
}

/* Duff's where the budget has no room for its table of lengths, which 8-bit grey alone divides by: Phong's, off by
 * nothing. A highlight of exponent 28 and full size leaves of a budget of 1 less than a tenth. */
static void what_is_left_to_phong_is_off_by_nothing(void **state)
{
    (void)state;
    struct scene_case c;
    struct scene_vertex vertex[3] = {
        {.position = {-800, -600, 0}}, {.position = {800, -600, 0}}, {.position = {0, 800, 0}}};
    struct scene_triangle triangle = {.corner = {0, 1, 2}};
    scene_case_sub_pixels(&c, 120, 120);
    for (int k = 0; k < 3; k++)
        scene_case_normal(vertex[k].normal, vertex[k].position[0] / 2000., vertex[k].position[1] / 2000., 1);
    scene_case_bend(&triangle, vertex);
    c.mesh[0] = (struct scene_case_mesh){c.mesh[0].head, vertex, &triangle, 3, 1};
    c.material[0].ka = 0;
    c.material[0].kd = c.material[0].ks = 32768;
    c.material[0].shininess = 28;
    struct scene_header *blob = scene_case_blob(&c);
    for (unsigned tables = 0; tables < 2; tables++) {
        struct frame_case colours = by_auto(GLINT_RGB888, 1), grey = by_auto(GLINT_GREY8, 1);
        struct glint_stats s;
        colours.config.tables = grey.config.tables = (uint8_t)tables;
        free(frame_case_picture(colours, blob, 0, &s));
        assert_int_equal(s.drawn[GLINT_DUFF], 1);
        free(frame_case_picture(grey, blob, 0, &s));
        assert_int_equal(s.drawn[GLINT_PHONG], 1);
        assert_int_equal(s.largest_error, 0);
    }
    free(blob);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_dropped_as_it_cannot_show_changes_no_byte),
        cmocka_unit_test(a_picture_is_the_same_in_any_bands),
        cmocka_unit_test(a_budget_counts_from_the_next_frame_on),
        cmocka_unit_test(more_budget_takes_plainer_methods),
        cmocka_unit_test(each_rung_is_taken_somewhere),
        cmocka_unit_test(what_is_counted_is_of_the_triangle_itself),
        cmocka_unit_test(a_light_that_reaches_nothing_is_computed_nowhere),
        cmocka_unit_test(a_worker_counts_what_is_left_out),
        cmocka_unit_test(a_picture_of_the_plan_counts_as_the_plan),
        cmocka_unit_test(a_picture_of_the_plan_is_in_the_colours_of_its_legend),
        cmocka_unit_test(what_is_left_to_phong_is_off_by_nothing),
    };
    return cmocka_run_group_tests(tests, load, unload);
}
