/* SPDX-License-Identifier: MIT */
/* Triangles in parts: what they cover, and how they are split. */
#include "pack/pack.h"
#include "random.h"
#include "raster/parts.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>

#include "subdivide_case.h"

/* --- parts on the pixel grid --- */

static struct raster raster;
static int16_t place[3][3];
static uint8_t count[HEIGHT][WIDTH];

/* Clockwise on the screen; half of them slivers or far beyond the picture. */
static void random_triangle(void)
{
    int32_t turn;
    do {
        const int reach = random_bits() & 1 ? 700 : 16384, thin = random_bits() & 1;
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 2; i++)
                place[k][i] = (int16_t)random_between(-reach, reach - 1);
        for (int i = 0; i < 2 && thin; i++)
            place[2][i] = (int16_t)((place[0][i] + place[1][i]) / 2 + random_between(-3, 3));
        turn = (place[1][0] - place[0][0]) * (place[2][1] - place[0][1]) -
               (place[2][0] - place[0][0]) * (place[1][1] - place[0][1]);
    } while (turn <= 0);
    for (int k = 0; k < 3; k++)
        raster.input.place[k] = place[k];
}

static void count_spans(struct edges *e)
{
    struct span span[SPANS];
    while (e->row < e->last) {
        const int row = e->row, rows = edges_spans(e, WIDTH, span, SPANS);
        for (int i = 0; i < rows; i++)
            for (int x = span[i].x0; x < span[i].x1; x++)
                count[row + i][x]++;
    }
}

static void count_part(const struct part_corner *a, const struct part_corner *b, const struct part_corner *c)
{
    const struct part_place p[3] = {part_place(&raster.input, a), part_place(&raster.input, b),
                                    part_place(&raster.input, c)};
    struct edges e;
    for (int row = 0; fine_setup(&e, p, WIDTH, HEIGHT, row, HEIGHT); row = e.last)
        count_spans(&e);
}

/* A part has a row where the row's centre lies from its top on and above its bottom, to the last bit of a place. */
static void a_part_shows_where_a_centre_is_between_its_ends(void **state)
{
    enum { ROW = 20, CENTRE = 16 * ROW + 8 - 8 * HEIGHT };
    static const int16_t corner[3][3] = {{0, CENTRE - 1, 0}, {0, CENTRE, 0}, {0, CENTRE + 1, 0}};
    (void)state;
    raster.height = HEIGHT;
    raster.y0 = ROW;
    raster.y1 = ROW + 1;
    for (int k = 0; k < 3; k++)
        raster.input.place[k] = corner[k];
    for (int top = -3; top <= 3; top++)
        for (int bottom = top; bottom <= 3; bottom++) {
            /* that many 2^-19 of a pixel below the centre: weights of the first and the last corner differ by them */
            const struct part_corner at[3] = {
                {{(uint16_t)(10 - top), (uint16_t)((int)PART_ONE - 20 + top)}, {0}},
                {{(uint16_t)(10 - bottom), (uint16_t)((int)PART_ONE - 20 + bottom)}, {0}},
                {{(uint16_t)(10 - bottom), (uint16_t)((int)PART_ONE - 20 + bottom)}, {0}}};
            for (int first = 0; first < 3; first++) {
                const struct part_corner *const part[3] = {&at[first], &at[(first + 1) % 3], &at[(first + 2) % 3]};
                assert_int_equal(parts_shows(&raster, part), top <= 0 && 0 < bottom);
            }
        }
}

static struct part_corner middle(const struct part_corner *a, const struct part_corner *b)
{
    struct part_corner m = {
        {(uint16_t)((a->weight[0] + b->weight[0]) / 2), (uint16_t)((a->weight[1] + b->weight[1]) / 2)}, {0}};
    return m;
}

/* As both ways of subdivision split: into 4, or at a corner of weights in Q10 into 3, and edges halved towards it; at
 * random, so that parts of all sizes meet. */
static void split_at_random(const struct part_corner *a, const struct part_corner *b, const struct part_corner *c,
                            int deep)
{
    if (!deep || random_bits() % 4 == 0) {
        count_part(a, b, c);
        return;
    }
    const struct part_corner ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    if (random_bits() & 1) {
        split_at_random(a, &ab, &ca, deep - 1);
        split_at_random(&ab, b, &bc, deep - 1);
        split_at_random(&ca, &bc, c, deep - 1);
        split_at_random(&ab, &bc, &ca, deep - 1);
    } else {
        split_at_random(a, b, &ca, deep - 1);
        split_at_random(b, c, &ca, deep - 1);
    }
}

static void parts_cover_each_pixel_of_their_triangle_once(void **state)
{
    (void)state;
    const struct part_corner corner[3] = {{{PART_ONE, 0}, {0}}, {{0, PART_ONE}, {0}}, {{0, 0}, {0}}};
    long covered = 0;
    random_seed(11);
    for (int i = 0; i < 20000; i++) {
        static uint8_t wanted[HEIGHT * WIDTH];
        struct edges e;
        random_triangle();
        memset(count, 0, sizeof count);
        if (edges_setup(&e, raster.input.place, WIDTH, HEIGHT, 0, HEIGHT))
            count_spans(&e);
        memcpy(wanted, count, sizeof count);
        memset(count, 0, sizeof count);
        if (i & 1) {
            split_at_random(&corner[0], &corner[1], &corner[2], PART_DEPTH);
        } else { /* about a corner anywhere inside, or on an edge */
            const int u = random_between(0, 1024), v = random_bits() % 4 ? random_between(0, 1024 - u) : 1024 - u;
            const struct part_corner peak = {{(uint16_t)(32 * u), (uint16_t)(32 * v)}, {0}};
            for (int k = 0; k < 3; k++)
                split_at_random(&peak, &corner[k], &corner[(k + 1) % 3], 5);
        }
        if (memcmp(wanted, count, sizeof count) != 0)
            fail_msg("triangle %d: (%d, %d) (%d, %d) (%d, %d)", i, place[0][0], place[0][1], place[1][0], place[1][1],
                     place[2][0], place[2][1]);
        for (int p = 0; p < WIDTH * HEIGHT; p++)
            covered += wanted[p];
    }
    assert_true(covered > 5000000);
}

/* --- triangles in a scene --- */

static uint32_t sum(const uint32_t counts[GLINT_METHODS])
{
    uint32_t all = 0;
    for (int id = 0; id < GLINT_METHODS; id++)
        all += counts[id];
    return all;
}

static void every_mode_draws_the_pixels_that_gouraud_draws(void **state)
{
    (void)state;
    long pixels = 0, clipped = 0, split = 0;
    random_seed(12);
    for (int i = 0; i < 600; i++) {
        struct scene_header *blob = subdivide_case_scene(i & 1, random_between(1, 80));
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, i % 4 < 2 ? GLINT_GREY8 : GLINT_RGB565);
        struct glint_stats wanted, got;
        f.config.subdivide_area = (uint16_t)(i % 3 ? 0 : 1);
        f.config.subdivide_tolerance = f.config.subdivide_threshold = (uint8_t)(i % 3 ? 0 : 1);
        f.config.method = &glint_gouraud;
        uint8_t *gouraud = frame_case_picture(f, blob, 0, &wanted);
        for (size_t m = 0; m < METHODS; m++) {
            f.config.method = methods[m];
            uint8_t *picture = frame_case_picture(f, blob, 0, &got);
            const size_t bytes = glint_row_bytes(&f.config) / WIDTH;
            assert_int_equal(sum(got.pixels), sum(wanted.pixels));
            assert_int_equal(sum(got.drawn), sum(wanted.drawn));
            for (size_t p = 0; p < WIDTH * HEIGHT; p++) /* the ambient part leaves no drawn pixel black */
                assert_int_equal(memcmp(picture + p * bytes, "\0\0", bytes) == 0,
                                 memcmp(gouraud + p * bytes, "\0\0", bytes) == 0);
            split += got.drawn[GLINT_SUBDIVIDE];
            free(picture);
        }
        pixels += sum(wanted.pixels);
        clipped += wanted.clipped;
        free(gouraud);
        free(blob);
    }
    print_message("%ld pixels, %ld clipped, %ld split\n", pixels, clipped, split);
    assert_true(pixels > 50000 && clipped > 20 && split > 600);
}

static void bands_of_any_height_give_the_same_bits(void **state)
{
    (void)state;
    random_seed(13);
    for (int i = 0; i < 120; i++) {
        struct scene_header *blob = subdivide_case_scene(i & 1, random_between(1, 80));
        for (size_t m = 0; m < METHODS; m++) {
            struct frame_case f = frame_case_small(WIDTH, HEIGHT, (enum glint_format)(i % GLINT_FORMATS));
            f.config.method = methods[m];
            f.config.subdivide_area = (uint16_t)(i % 5 ? 0 : 3);
            f.config.subdivide_threshold = 20;
            uint8_t *whole = frame_case_picture(f, blob, 0, NULL);
            f.config.band_rows = (uint16_t)(i % 3 ? random_between(2, 20) : 1);
            uint8_t *bands = frame_case_picture(f, blob, 0, NULL);
            assert_memory_equal(whole, bands, glint_row_bytes(&f.config) * HEIGHT);
            free(whole);
            free(bands);
        }
        free(blob);
    }
}

/* Neither marks nor colours kept with the vertices, nor what is left in memory. */
static void a_picture_does_not_depend_on_the_one_before(void **state)
{
    (void)state;
    long marked = 0;
    random_seed(15);
    for (int i = 0; i < 60; i++) {
        struct scene_header *one = subdivide_case_scene(i & 1, random_between(1, 80));
        struct scene_header *other = subdivide_case_scene(i & 1, random_between(1, 80));
        for (size_t m = 0; m < METHODS; m++) {
            struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_RGB565);
            f.config.method = methods[m];
            uint8_t *wanted = frame_case_picture(f, one, 0, NULL);
            frame_case_open_for(&f, one);
            frame_case_draw(&f, other, 0);
            marked += f.frame.stats.potentially_highlighted;
            frame_case_draw(&f, one, 0);
            assert_memory_equal(f.picture, wanted, f.picture_bytes);
            frame_case_close(&f);
            free(wanted);
        }
        free(one);
        free(other);
    }
    assert_true(marked > 40);
}

/* --- how triangles are split --- */

/* The last scene with a small highlight within its triangle: the light is the viewer's mirror image there. */
static struct scene_header *highlight_scene(void)
{
    double n[3], length = 0;
    for (int i = 0; i < 3; i++) {
        n[i] = vertex[0].normal[i] + vertex[1].normal[i] + vertex[2].normal[i];
        length += n[i] * n[i];
    }
    for (int i = 0; i < 3; i++) /* 2 (n.v) n - v, v = (0, 0, 1) */
        scene.light[0].vector[i] = (int32_t)lrint((2 * n[2] * n[i] / length - (i == 2)) * 0x1p30);
    scene.head.camera.viewer = VIEWER_INFINITE;
    scene.material[0].shininess = 1000;
    return scene_case_blob(&scene);
}

/* Large triangles, split as deep as they can be: the stack's last place is used, and what stands behind it stays. */
static void the_stack_is_as_deep_as_the_deepest_split(void **state)
{
    (void)state;
    int deepest[2] = {0, 0};
    random_seed(14);
    for (int i = 0; i < 60; i++) {
        free(subdivide_case_scene(0, 1));
        struct scene_header *blob = highlight_scene();
        struct frame_case f = frame_case_small(1024, 768, GLINT_GREY8);
        f.config.method = methods[i % 2];
        f.config.subdivide_area = f.config.subdivide_tolerance = 1;
        frame_case_open_for(&f, blob);
        assert_int_equal(glint_frame_begin(&f.frame, blob, 0), 0);
        struct shade_setup *setup = &f.frame.raster->setup;
        uint8_t *last = (uint8_t *)&setup->parts.split[PART_DEPTH], *behind = last + sizeof(struct part_split);
        uint8_t *const end = (uint8_t *)setup->flat + sizeof setup->flat;
        memset(last, 0x5A, (size_t)(end - last));
        while (frame_case_band(&f))
            ;
        deepest[i % 2] += *last != 0x5A || last[1] != 0x5A;
        for (; behind != end; behind++)
            assert_int_equal(*behind, 0x5A);
        frame_case_close(&f);
        free(blob);
    }
    print_message("split to the last: %d by size, %d by centre\n", deepest[0], deepest[1]);
    assert_true(deepest[0] >= 5 && deepest[1] >= 5);
}

static void assert_alike(const struct pack_result *torus, struct glint_config a, struct glint_config b, int alike)
{
    uint8_t *one = subdivide_case_picture(torus, a, NULL), *other = subdivide_case_picture(torus, b, NULL);
    assert_int_equal(memcmp(one, other, 240 * 240) == 0, alike);
    free(one);
    free(other);
}

static void limits_left_out_are_the_papers(void **state)
{
    (void)state;
    struct pack_result torus;
    assert_int_equal(pack_load("tests/scenes/torus288.json", NULL, &torus), PACK_OK);
    for (size_t m = 0; m < METHODS; m++) {
        const struct glint_config none = {.method = methods[m]};
        struct glint_config given = none, other = none;
        given.subdivide_tolerance = 4;
        given.subdivide_area = 32;
        given.subdivide_threshold = 77;
        other.subdivide_tolerance = 1;
        other.subdivide_area = 4;
        other.subdivide_threshold = 8;
        assert_alike(&torus, none, given, 1);
        assert_alike(&torus, none, other, methods[m] == &glint_hybrid_phong || methods[m] == &glint_hybrid_x);
    }
    /* larger than any triangle */
    const struct glint_config gouraud = {.method = &glint_gouraud};
    assert_alike(&torus, (struct glint_config){.method = &glint_subdivide_regular, .subdivide_area = 65535}, gouraud,
                 1);
    assert_alike(&torus, (struct glint_config){.method = &glint_subdivide_recursive, .subdivide_area = 65535}, gouraud,
                 1);
    pack_free(&torus);
}

/* Corners in a line, in one place, and a third of a pixel apart: no polynomial holds over such a part. */
static void parts_without_area_or_too_small_have_no_polynomial(void **state)
{
    static const struct {
        uint16_t weight[3][2];
        int height; /* sub-pixels, or an eighth less */
    } parts[] = {{{{32768, 0}, {16384, 16384}, {0, 32768}}, 0},
                 {{{8192, 8192}, {8192, 8192}, {8192, 8192}}, 0},
                 {{{0, 0}, {200, 0}, {0, 200}}, 4},
                 {{{0, 0}, {8192, 0}, {0, 8192}}, 181}};
    static const int16_t corner[3][2] = {{1024, 0}, {0, 1024}, {0, 0}};
    static const int32_t value[3] = {100, 200, 300}, bulge[3] = {0, 0, 0};
    static const struct part_place least[3] = {{5, 0}, {105, 0}, {5, 100}};
    struct shade_input in = {.place = {corner[0], corner[1], corner[2]}};
    struct shade_setup setup;
    struct surface surface = {.channels = 3};
    (void)state;
    in.surface = &surface;
    assert_int_equal(part_height(least), 0); /* a 300th of a sub-pixel */
    assert_int_equal(plane_setup(&setup.plane, in.place, WIDTH, HEIGHT), 1);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        const int large = parts[i].height > 100;
        struct part_corner at[3], middle[3];
        struct part_place there[3];
        const struct part_corner *const of[3] = {&at[0], &at[1], &at[2]};
        for (int k = 0; k < 3; k++) {
            at[k] =
                (struct part_corner){{parts[i].weight[k][0], parts[i].weight[k][1]}, {255 << 8, 255 << 8, 255 << 8}};
            middle[k] = at[k];
            there[k] = part_place(&in, &at[k]);
            setup.channel[k].p.f = 12345;
        }
        assert_in_range(part_height(there), parts[i].height * 7 / 8, parts[i].height);
        assert_int_equal(part_quadratic(&setup, &in, of, middle), large);
        assert_int_equal(setup.channel[2].p.f == 12345, !large);
        setup.channel[0].p.f = 12345;
        assert_int_equal(part_channel(&setup, &in, of, value, bulge, 0, &setup.channel[0]), large);
        assert_int_equal(setup.channel[0].p.f == 12345, !large);
    }
}

/* 2^-15 of a sub-pixel below a whole number of them, over the longest edge, which is level. */
static void the_height_of_a_part_is_rounded_down(void **state)
{
    (void)state;
    for (int32_t height = 2; height < 2048; height++) {
        const int32_t up = height * 32768 - 1;
        const struct part_place place[3] = {{0, 0}, {8192 * 32768, 0}, {4096 * 32768, up}};
        assert_int_equal(part_height(place), height - 1);
    }
}

static void triangles_are_counted_under_what_draws_them(void **state)
{
    (void)state;
    static const enum glint_method_id treated[METHODS] = {GLINT_SUBDIVIDE, GLINT_SUBDIVIDE, GLINT_SUBDIVIDE,
                                                          GLINT_SUBDIVIDE, GLINT_PHONG,     GLINT_X};
    struct pack_result torus;
    assert_int_equal(pack_load("tests/scenes/torus288.json", NULL, &torus), PACK_OK);
    for (size_t m = 0; m < METHODS; m++) {
        struct glint_stats stats;
        free(subdivide_case_picture(&torus, (struct glint_config){.method = methods[m]}, &stats));
        assert_int_equal(stats.drawn[treated[m]] + stats.drawn[GLINT_GOURAUD], sum(stats.drawn));
        assert_int_equal(sum(stats.drawn), 144);
        assert_int_equal(stats.highlight_tests, m < 2 ? 0 : 288);
        if (m < 2)
            assert_int_equal(stats.drawn[GLINT_GOURAUD], 0);
        else /* four potentially highlighted ones in all; the visible ones with their neighbours */
            assert_true(stats.potentially_highlighted > 0 && stats.drawn[treated[m]] > stats.potentially_highlighted &&
                        stats.drawn[treated[m]] < 50);
    }
    pack_free(&torus);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_part_shows_where_a_centre_is_between_its_ends),
        cmocka_unit_test(parts_cover_each_pixel_of_their_triangle_once),
        cmocka_unit_test(every_mode_draws_the_pixels_that_gouraud_draws),
        cmocka_unit_test(bands_of_any_height_give_the_same_bits),
        cmocka_unit_test(a_picture_does_not_depend_on_the_one_before),
        cmocka_unit_test(the_stack_is_as_deep_as_the_deepest_split),
        cmocka_unit_test(limits_left_out_are_the_papers),
        cmocka_unit_test(parts_without_area_or_too_small_have_no_polynomial),
        cmocka_unit_test(the_height_of_a_part_is_rounded_down),
        cmocka_unit_test(triangles_are_counted_under_what_draws_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
