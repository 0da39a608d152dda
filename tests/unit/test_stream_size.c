/* SPDX-License-Identifier: MIT */
/* Bytes a frame of moving scenes: what full-speed USB must carry at 50 pictures a second, and a table of the rest. */
#include "pack/pack.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>

#include "frame_case.h"
#include "stream_case.h"

enum { FRAMES = 20, RATE = 50 };

/* The average of FRAMES pictures, the first left out. Every object of a scene that stands still is given a turn in four
 * seconds, about an axis that is nothing to it. */
static unsigned average(const char *name, enum glint_format format, unsigned width, unsigned height, unsigned flags,
                        bool last)
{
    char path[64];
    struct pack_result scene = {0};
    struct stream_case_bytes out = {0};
    struct frame_case f = frame_case_small(width, height, format);
    size_t first = 0;
    snprintf(path, sizeof path, "tests/scenes/%s.json", name);
    assert_int_equal(pack_load(path, NULL, &scene), 0);
    struct scene_object *objects =
        (struct scene_object *)((uint8_t *)(uintptr_t)scene.scene + scene.scene->objects); /* the heap's */
    for (unsigned i = 0; i < scene.scene->object_count && scene.scene->duration_ms == 0; i++)
        objects[i].motion = (struct scene_motion){
            .kind = MOTION_SPIN, .axis = {644245094, 858993459, 0} /* (.6, .8, 0) */, .rate = 65536 / 4};
    f.config.flags = (uint8_t)flags;
    f.config.band_rows = (uint16_t)(height < 16 ? height : 16);
    frame_case_open_for(&f, scene.scene);
    struct stream s = stream_case_open(&out, (enum stream_format)format, width, height, f.config.band_rows, last);
    for (uint32_t i = 0; i <= FRAMES; i++) {
        frame_case_draw(&f, scene.scene, i * 1000 / RATE);
        assert_int_equal(stream_case_send(&s, f.picture, f.config.band_rows), 0);
        first = first ? first : out.count;
    }
    unsigned bytes = (unsigned)((out.count - first) / FRAMES);
    frame_case_close(&f);
    stream_case_close(&s, &out);
    pack_free(&scene);
    return bytes;
}

static void a_moving_torus_fits_full_speed_usb(void **state)
{
    static const char *const tori[] = {"torus288", "torus512", "torus800"};
    (void)state;
    for (size_t i = 0; i < sizeof tori / sizeof *tori; i++) {
        unsigned plain = average(tori[i], GLINT_RGB565, 240, 240, 0, true);
        unsigned dithered = average(tori[i], GLINT_RGB565, 240, 240, GLINT_DITHER, true);
        print_message("# %-15s 240x240 rgb565: %5u bytes a frame, dithered %5u\n", tori[i], plain, dithered);
        assert_in_range(plain, 1000, 14000);
        assert_in_range(dithered, 1000, 20000);
    }
}

static void no_moving_scene_comes_near_its_raw_size(void **state)
{
    static const char *const scenes[] = {"demo", "torus800-persp", "bench-torus4000", "sphere690",
                                         "bulb", "pawn",           "zigzag",          "teapot896"};
    static const struct {
        enum glint_format format;
        unsigned width, height, flags, raw;
        const char *name;
    } kinds[] = {{GLINT_RGB565, 240, 240, 0, 115200, "rgb565"},
                 {GLINT_RGB565, 240, 240, GLINT_DITHER, 115200, "rgb565 dithered"},
                 {GLINT_GREY4, 128, 64, GLINT_DITHER, 4096, "grey4 dithered"}};
    (void)state;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++)
        for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
            unsigned key = average(scenes[i], kinds[k].format, kinds[k].width, kinds[k].height, kinds[k].flags, false);
            unsigned change =
                average(scenes[i], kinds[k].format, kinds[k].width, kinds[k].height, kinds[k].flags, true);
            print_message("# %-15s %-16s raw %6u, codec 1 %6u, codec 2 %6u\n", scenes[i], kinds[k].name, kinds[k].raw,
                          key, change);
            assert_true(change <= key);
            assert_in_range(key, 100, kinds[k].raw / 2);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_moving_torus_fits_full_speed_usb),
        cmocka_unit_test(no_moving_scene_comes_near_its_raw_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
