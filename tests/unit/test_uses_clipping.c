/* SPDX-License-Identifier: MIT */
/* What pack says of clipping holds for any moment, turn and size of picture. */
#include "pack/pack.h"
#include "pack/uses.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "random.h"

static const char *const scenes[] = {"tests/scenes/torus288.json",      "tests/scenes/torus800-persp.json",
                                     "tests/scenes/demo.json",          "tests/scenes/bulb.json",
                                     "tests/scenes/spin-torus800.json", "tests/scenes/sphere690-persp.json",
                                     "tests/golden/materials.json"};
#define SCENES (sizeof scenes / sizeof scenes[0])

/* Begins frames of random moments and turns: how many triangles were clipped, dropped or rejected. */
static uint32_t cut(const struct scene_header *scene, unsigned width, unsigned height, unsigned frames)
{
    struct frame_case f = frame_case_small(width, height, GLINT_GREY8);
    uint32_t count = 0;
    random_seed(width);
    f.config.band_rows = 1;
    frame_case_open_for(&f, scene);
    for (unsigned i = 0; i < frames; i++) {
        glint_turn(&f.frame, (uint16_t)random_bits(), (uint16_t)random_bits());
        assert_int_equal(glint_frame_begin(&f.frame, scene, random_bits() % 60000), 0);
        count += f.frame.stats.clipped + f.frame.stats.dropped + f.frame.stats.rejected;
    }
    frame_case_close(&f);
    return count;
}

static void nothing_is_cut_where_no_clipping_is_needed(void **state)
{
    (void)state;
    static const uint16_t sizes[][2] = {{240, 240}, {128, 64}, {2048, 2048}, {2048, 1}, {17, 1999}};
    for (unsigned i = 0; i < SCENES; i++) {
        struct pack_result scene;
        assert_int_equal(pack_load(scenes[i], NULL, &scene), 0);
        assert_false(scene.scene->effects & USES_CLIPPING);
        for (unsigned s = 0; s < sizeof sizes / sizeof sizes[0]; s++)
            assert_int_equal(cut(scene.scene, sizes[s][0], sizes[s][1], 10), 0);
        pack_free(&scene);
    }
}

static void the_stores_have_no_room_for_pieces_then(void **state)
{
    (void)state;
    struct pack_result scene;
    struct glint_config config = {0};
    assert_int_equal(pack_load(scenes[0], NULL, &scene), 0);
    glint_fit_stores(&config, scene.scene);
    assert_int_equal(config.max_clipped, 0);
    assert_int_equal(config.max_triangles, 288);
    pack_free(&scene);
}

/* Brings one plane of the view, or one side, to the object until pack says clipping: the ball that is then taken for it
 * touches, but the object is not far. */
static void a_view_that_closes_in_needs_clipping_before_it_cuts(void **state)
{
    (void)state;
    struct pack_result scene;
    assert_int_equal(pack_load("tests/scenes/torus800-persp.json", NULL, &scene), 0);
    struct scene_header *s = malloc(scene.size);
    assert_non_null(s);
    for (int side = 0; side < 5; side++) {
        unsigned steps = 0;
        memcpy(s, scene.scene, scene.size);
        while (!uses_clipping(s)) {
            assert_int_equal(cut(s, 240, 240, 1), 0);
            assert_true(++steps < 2000);
            if (side == 0)
                s->camera.near_plane += 1 << 11;
            else if (side == 1)
                s->camera.far_plane -= 1 << 11;
            else
                s->camera.position[side - 2] -= 1 << 11;
        }
        assert_true(steps > 0);
    }
    free(s);
    pack_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(nothing_is_cut_where_no_clipping_is_needed),
                                       cmocka_unit_test(the_stores_have_no_room_for_pieces_then),
                                       cmocka_unit_test(a_view_that_closes_in_needs_clipping_before_it_cuts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
