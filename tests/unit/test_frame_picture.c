/* SPDX-License-Identifier: MIT */
/* The same picture however it is asked for: bands, frames, formats, the plan. */
#include "pack/pack.h"
#include "raster/raster.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>

#include "frame_case.h"
#include "random.h"
#include "scene_case.h"

static struct pack_result tiny, sphere, clipped;

static int load(void **state)
{
    (void)state;
    return pack_load("tests/scenes/tiny.json", NULL, &tiny) ||
           pack_load("tests/scenes/sphere690.json", NULL, &sphere) ||
           pack_load("tests/golden/clip.json", NULL, &clipped);
}

static int unload(void **state)
{
    (void)state;
    pack_free(&tiny);
    pack_free(&sphere);
    pack_free(&clipped);
    return 0;
}

static void two_frames_under_way_do_not_disturb_each_other(void **state)
{
    (void)state;
    struct frame_case f = frame_case_small(40, 30, GLINT_RGB565), g = frame_case_small(48, 36, GLINT_GREY4);
    uint8_t *f_alone = frame_case_picture(f, tiny.scene, 300, NULL),
            *g_alone = frame_case_picture(g, clipped.scene, 700, NULL);
    f.config.band_rows = 4;
    g.config.band_rows = 7;
    frame_case_open_for(&f, tiny.scene);
    frame_case_open_for(&g, clipped.scene);
    assert_int_equal(glint_frame_begin(&f.frame, tiny.scene, 300), 0);
    int f_more = frame_case_band(&f), g_more;
    assert_int_equal(glint_frame_begin(&g.frame, clipped.scene, 700), 0);
    do {
        g_more = frame_case_band(&g);
        f_more = frame_case_band(&f);
    } while (f_more || g_more);
    assert_memory_equal(f.picture, f_alone, f.picture_bytes);
    assert_memory_equal(g.picture, g_alone, g.picture_bytes);
    frame_case_close(&f);
    frame_case_close(&g);
    free(f_alone);
    free(g_alone);
}

static void bands_of_every_height_give_the_same_picture(void **state)
{
    (void)state;
    struct frame_case whole = frame_case_small(40, 30, GLINT_RGB888);
    uint8_t *wanted = frame_case_picture(whole, clipped.scene, 900, NULL);
    for (unsigned rows = 1; rows <= 30; rows++) {
        struct frame_case f = whole;
        struct glint_band band;
        unsigned next = 0;
        f.config.band_rows = (uint16_t)rows;
        frame_case_open_for(&f, clipped.scene);
        for (int pass = 0; pass < 2; pass++) { /* a renderer is as good as new for its next frame */
            frame_case_draw(&f, clipped.scene, 900);
            assert_memory_equal(f.picture, wanted, f.picture_bytes);
        }
        assert_int_equal(glint_frame_next_band(&f.frame, &band), 0);
        assert_int_equal(glint_frame_begin(&f.frame, clipped.scene, 0), 0);
        for (unsigned i = 0; glint_frame_next_band(&f.frame, &band) == 1; i++, next += band.rows) {
            assert_int_equal(band.y, next);
            assert_int_equal(band.rows, next + rows <= 30 ? rows : 30 - next);
            assert_int_equal(band.stride, 120);
            assert_ptr_equal(band.pixels, f.config.band[i & 1]);
        }
        assert_int_equal(next, 30);
        frame_case_close(&f);
    }
    free(wanted);
}

static void one_band_buffer_serves_every_time(void **state)
{
    (void)state;
    struct frame_case f = frame_case_small(40, 30, GLINT_RGB888);
    uint8_t *wanted = frame_case_picture(f, tiny.scene, 0, NULL);
    f.config.band_rows = 8;
    frame_case_open_for(&f, tiny.scene);
    f.config.band[1] = NULL;
    assert_int_equal(glint_init(&f.frame, &f.config), 0);
    frame_case_draw(&f, tiny.scene, 0);
    assert_memory_equal(f.picture, wanted, f.picture_bytes);
    for (size_t i = 0; i < glint_band_bytes(&f.config); i++)
        assert_int_equal(f.block[2][FRAME_SENTINELS + i], 0xA5);
    frame_case_close(&f);
    free(wanted);
}

/* The levels of a pixel's channels, 0..1; returns how many. */
static int levels_at(const struct frame_case *f, unsigned x, unsigned y, double out[3])
{
    const uint8_t *row = f->picture + y * glint_row_bytes(&f->config);
    uint16_t pixel;
    switch (f->config.format) {
    case GLINT_RGB565:
        memcpy(&pixel, row + 2 * x, 2);
        out[0] = (pixel >> 11) / 31.;
        out[1] = (pixel >> 5 & 63) / 63.;
        out[2] = (pixel & 31) / 31.;
        return 3;
    case GLINT_RGB888:
        for (int c = 0; c < 3; c++)
            out[c] = row[3 * x + (unsigned)c] / 255.;
        return 3;
    case GLINT_GREY8:
        out[0] = row[x] / 255.;
        return 1;
    default:
        out[0] = (x & 1 ? row[x / 2] & 15 : row[x / 2] >> 4) / 15.;
        return 1;
    }
}

static double luma(const double rgb[3])
{
    return .299 * rgb[0] + .587 * rgb[1] + .114 * rgb[2];
}

/* Against the same picture in 24 bits: at most half a step of each, and a little for what was rounded before. */
static void compare_formats(const struct frame_case *f, const struct frame_case *fine)
{
    static const double steps[GLINT_FORMATS] = {31, 255, 255, 15};
    double step = 1 / steps[f->config.format], most = (f->config.flags & GLINT_DITHER ? 1. : .5) * step + 1.6 / 255;
    const struct glint_method *m = f->config.method;
    if (step > 1 / 255. &&
        (m == &glint_x || m == &glint_hybrid_x || m == &glint_six || m == &glint_x_perspective ||
         m == &glint_six_perspective || m == &glint_duff || m == &glint_bump_linear || m == &glint_bump_quadratic ||
         m == &glint_bump_normalised || m == &glint_bump_frames || m == &glint_bump_upright))
        most += step; /* bends of less than half a step are left out, here of up to four values */
    if (m == &glint_auto)
        most += 2 * 2 / 255.; /* each picture is within its budget of the truth */
    if (m == &glint_subdivide_centre || m == &glint_subdivide_highlight)
        most += 2 * SPLIT_TOLERANCE / 255.; /* a close decision to split may fall out differently */
    for (unsigned y = 0; y < f->config.height; y++)
        for (unsigned x = 0; x < f->config.width; x++) {
            double got[3], wanted[3];
            levels_at(fine, x, y, wanted);
            int channels = levels_at(f, x, y, got);
            for (int c = 0; c < channels; c++)
                if (fabs(got[c] - (channels == 1 ? luma(wanted) : wanted[c])) > most)
                    fail_msg("format %d, %u x %u: pixel (%u, %u) channel %d is %.4f, not %.4f", f->config.format,
                             f->config.width, f->config.height, x, y, c, got[c],
                             channels == 1 ? luma(wanted) : wanted[c]);
        }
}

static void every_format_at_every_shape_shows_the_same_picture(void **state)
{
    (void)state;
    static const uint16_t sizes[][2] = {{1, 1}, {1, 40}, {40, 1},  {2048, 1}, {1, 2048},
                                        {5, 3}, {7, 7},  {41, 31}, {64, 48}};
    struct scene_header *dim = malloc(tiny.size); /* channels and luma would not be clamped alike */
    assert_non_null(dim);
    memcpy(dim, tiny.scene, tiny.size);
    struct scene_light *light = (struct scene_light *)((uint8_t *)dim + dim->lights);
    for (unsigned i = 0; i < 3u * dim->light_count; i++)
        light[i / 3].colour[i % 3] /= 2;
    for (unsigned i = 0; i < 9 * glint_choice_count; i++)
        for (int format = 0; format < GLINT_FORMATS; format++)
            for (uint8_t flags = 0; flags <= GLINT_DITHER; flags++) {
                struct frame_case fine =
                    frame_case_small(sizes[i / glint_choice_count][0], sizes[i / glint_choice_count][1], GLINT_RGB888);
                fine.config.method = glint_choices[i % glint_choice_count].method;
                struct frame_case f = fine;
                f.config.format = (uint8_t)format;
                f.config.flags = flags;
                f.config.band_rows = (uint16_t)(1 + i % sizes[i / glint_choice_count][1]);
                frame_case_open_for(&fine, dim);
                frame_case_open_for(&f, dim);
                frame_case_draw(&fine, dim, 400);
                frame_case_draw(&f, dim, 400);
                compare_formats(&f, &fine);
                frame_case_close(&fine);
                frame_case_close(&f);
            }
    free(dim);
}

static void the_plan_leaves_out_only_what_cannot_be_seen(void **state)
{
    (void)state;
    static const char *const names[] = {
        "tiny",           "torus288",        "torus800",       "sphere690",       "torus288-persp",
        "torus800-persp", "sphere690-persp", "bench-torus288", "bench-torus4000", "demo"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[64];
        struct pack_result scene;
        snprintf(path, sizeof path, "tests/scenes/%s.json", names[i]);
        assert_int_equal(pack_load(path, NULL, &scene), 0);
        for (unsigned j = 0; j < glint_choice_count * GLINT_FORMATS * 2; j++) {
            struct frame_case f = frame_case_small(64, 48, (enum glint_format)(j / 2 % GLINT_FORMATS));
            f.config.method = glint_choices[j / 2 / GLINT_FORMATS].method;
            f.config.tables = j & 1 ? 4 : 0;
            uint8_t *planned = frame_case_picture(f, scene.scene, 100, NULL);
            f.config.flags = GLINT_NO_PLAN;
            uint8_t *full = frame_case_picture(f, scene.scene, 100, NULL);
            size_t bytes = glint_row_bytes(&f.config) * f.config.height;
            if (memcmp(planned, full, bytes) != 0)
                fail_msg("%s, %s, format %d, %u tables", names[i], glint_choices[j / 2 / GLINT_FORMATS].name,
                         f.config.format, f.config.tables);
            free(planned);
            free(full);
        }
        pack_free(&scene);
    }
}

/* One triangle under up to eight lights, of which each takes an eighth of full intensity. */
static void eight_lights_are_the_sum_of_each(void **state)
{
    (void)state;
    static struct scene_case c;
    static const int16_t xy[3][2] = {{-9000, -9000}, {9000, -7000}, {-2000, 9000}};
    struct scene_vertex vertex[3] = {0};
    struct scene_triangle triangle = {.corner = {0, 1, 2}};
    long lit = 0;
    random_seed(71);
    for (unsigned i = 0; i < 500; i++) {
        const struct glint_choice *choice = &glint_choices[i % glint_choice_count];
        if (choice->method == &glint_color6)
            continue; /* it rings, and a pixel clamps each light's ringing below 0, or that of all */
        if (choice->method->choose || choice->method == &glint_subdivide_centre)
            continue; /* what is split, or drawn by another method, depends on the light */
        scene_case_default(&c, 32, 32);
        for (int k = 0; k < 3; k++) {
            memcpy(vertex[k].position, xy[k], sizeof xy[k]);
            scene_case_normal(vertex[k].normal, random_real(-1, 1), random_real(-1, 1), 1);
        }
        scene_case_bend(&triangle, vertex);
        c.mesh[0] = (struct scene_case_mesh){c.mesh[0].head, vertex, &triangle, 3, 1};
        c.object[0].position[2] = -CASE_UNIT;
        c.material[0].ka = 0;
        c.material[0].kd = c.material[0].ks = 16384;
        c.material[0].shininess = 12;
        c.light_count = SCENE_MAX_LIGHTS;
        for (int l = 0; l < 8; l++) {
            double v[3];
            random_direction(v, 3);
            for (int k = 0; k < 3; k++) {
                c.light[l].vector[k] = (int32_t)lrint(v[k] * 0x1p30);
                c.light[l].colour[k] = 4096;
            }
        }
        struct frame_case f = frame_case_small(32, 32, GLINT_RGB888);
        f.config.method = choice->method;
        struct scene_header *blob = scene_case_blob(&c);
        uint8_t *all = frame_case_picture(f, blob, 0, NULL);
        int sum[32 * 32 * 3] = {0};
        blob->light_count = 1;
        for (int l = 0; l < 8; l++) {
            uint8_t *one = frame_case_picture(f, blob, 0, NULL);
            blob->lights += (uint32_t)sizeof(struct scene_light);
            for (int p = 0; p < 32 * 32 * 3; p++)
                sum[p] += one[p];
            free(one);
        }
        for (int p = 0; p < 32 * 32 * 3; p++) {
            if (abs(sum[p] - all[p]) > 4) /* eight roundings */
                fail_msg("%s: %d, not %d", choice->name, all[p], sum[p]);
            lit += all[p] > 16;
        }
        free(all);
        free(blob);
    }
    assert_true(lit > 50000);
}

/* Front faces of a sphere do not hide each other. */
static void pixels_are_counted_once_each(void **state)
{
    (void)state;
    for (unsigned m = 0; m < glint_choice_count; m++) {
        struct frame_case f = frame_case_small(60, 60, GLINT_GREY8);
        uint32_t covered = 0, pixels = 0;
        f.config.method = glint_choices[m].method;
        f.config.band_rows = 7;
        frame_case_open_for(&f, sphere.scene);
        frame_case_draw(&f, sphere.scene, 0);
        for (size_t i = 0; i < f.picture_bytes; i++)
            covered += f.picture[i] != 0;
        for (int id = 0; id < GLINT_METHODS; id++) {
            pixels += f.frame.stats.pixels[id];
            /* where there is no map, bump mapping is x, six and duff */
            assert_true(strcmp(glint_choices[m].name, glint_method_names[id]) != 0 ||
                        strncmp(glint_choices[m].name, "bump-", 5) == 0 ||
                        f.frame.stats.drawn[id] == frame_case_drawn(&f));
        }
        assert_int_equal(pixels, covered);
        assert_true(covered > 1500 && f.frame.stats.setups >= frame_case_drawn(&f));
        frame_case_sums(&f);
        frame_case_close(&f);
    }
}

static void more_than_255_bands_are_still_in_turn(void **state)
{
    (void)state;
    struct frame_case whole = {.config = {.width = 9, .height = 300, .format = GLINT_GREY8, .method = &glint_x}};
    struct frame_case rows = whole;
    rows.config.band_rows = 1;
    frame_case_open_for(&whole, sphere.scene);
    frame_case_open_for(&rows, sphere.scene);
    frame_case_draw(&whole, sphere.scene, 0);
    frame_case_draw(&rows, sphere.scene, 0);
    assert_memory_equal(whole.picture, rows.picture, whole.picture_bytes);
    frame_case_close(&whole);
    frame_case_close(&rows);
}

/* A colour table belongs to what it was made for: another scene in the same place gets its own, and a picture does not
 * depend on those drawn before. */
static void a_colour_table_follows_its_scene(void **state)
{
    (void)state;
    struct frame_case f = {
        .config = {.width = 96, .height = 72, .format = GLINT_RGB565, .method = &glint_x, .tables = 1}};
    struct frame_case fresh = f;
    struct pack_result scene[2];
    struct pack_options options = {.shininess = 22};
    assert_int_equal(pack_load("tests/scenes/torus288.json", &options, &scene[0]), 0);
    options.shininess = 46;
    assert_int_equal(pack_load("tests/scenes/torus288.json", &options, &scene[1]), 0);
    assert_int_equal(scene[0].size, scene[1].size);
    frame_case_open_for(&f, scene[0].scene);
    frame_case_draw(&f, scene[0].scene, 0);
    void *place = (void *)(uintptr_t)scene[0].scene;
    memcpy(place, scene[1].scene, scene[1].size);
    frame_case_draw(&f, place, 0);
    frame_case_open_for(&fresh, scene[1].scene);
    frame_case_draw(&fresh, scene[1].scene, 0);
    assert_memory_equal(f.picture, fresh.picture, f.picture_bytes);
    frame_case_close(&f);
    frame_case_close(&fresh);
    pack_free(&scene[0]);
    pack_free(&scene[1]);
}

/* Until a material is another, its table stays as it is: what is written into it shows in the next picture. */
static void a_table_is_made_once(void **state)
{
    static const uint8_t formats[] = {GLINT_RGB565, GLINT_RGB888, GLINT_GREY8};
    (void)state;
    for (size_t i = 0; i < sizeof formats; i++) {
        struct frame_case f = frame_case_small(40, 30, (enum glint_format)formats[i]);
        f.config.tables = 1;
        frame_case_open_for(&f, sphere.scene);
        frame_case_draw(&f, sphere.scene, 0);
        uint8_t *first = malloc(f.picture_bytes);
        assert_non_null(first);
        memcpy(first, f.picture, f.picture_bytes);
        frame_case_draw(&f, sphere.scene, 0);
        assert_memory_equal(f.picture, first, f.picture_bytes);
        struct table *table = f.frame.raster->table;
        memset(table->entry, 0, table_bytes(formats[i]) - sizeof *table);
        frame_case_draw(&f, sphere.scene, 0);
        assert_memory_not_equal(f.picture, first, f.picture_bytes);
        free(first);
        frame_case_close(&f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_frames_under_way_do_not_disturb_each_other),
        cmocka_unit_test(bands_of_every_height_give_the_same_picture),
        cmocka_unit_test(one_band_buffer_serves_every_time),
        cmocka_unit_test(every_format_at_every_shape_shows_the_same_picture),
        cmocka_unit_test(the_plan_leaves_out_only_what_cannot_be_seen),
        cmocka_unit_test(eight_lights_are_the_sum_of_each),
        cmocka_unit_test(pixels_are_counted_once_each),
        cmocka_unit_test(more_than_255_bands_are_still_in_turn),
        cmocka_unit_test(a_colour_table_follows_its_scene),
        cmocka_unit_test(a_table_is_made_once),
    };
    return cmocka_run_group_tests(tests, load, unload);
}
