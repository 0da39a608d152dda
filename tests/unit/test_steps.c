/* SPDX-License-Identifier: MIT */
/* Ranges that decide which loop draws, and what loops divide by, at their ends. */
#include "random.h"
#include "raster/raster.h"
#include "shade/x.c"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

/* Drawn without a clamp, all sums must be within the format: a step and more above 0, a step below 256, in Q7. */
static void what_is_drawn_without_a_clamp_stays_in_the_format(void **state)
{
    int plain = 0, wide = 0;
    (void)state;
    random_seed(81);
    for (int i = 0; i < 200000; i++) {
        struct shade_setup setup;
        struct surface surface = {.fold = (uint16_t)(i % 3 ? random_between(0, 65280) : random_between(0, 999))};
        surface.ambient = (uint16_t)random_between(0, 255 << 7);
        const int far = i % 8 == 0; /* up to 2 */
        const int32_t a = random_between(far ? 16500 : -16384, 18000), b = random_between(far ? 16500 : -16384, 18000),
                      bend = far ? random_between(14000, 16499) : random_between(0, i % 5 ? 3000 : 65535);
        const struct bounds range = {a < b ? a : b, a < b ? b : a};
        int32_t value[3] = {a, b, a};
        steps_take(&setup, &surface, range, bend, value, NULL);
        const double low = range.low - bend, high = range.high + bend, fold = surface.fold / 32768.;
        const int fits = low > 0 && high < 32768 && low * fold + surface.ambient > 128 &&
                         high * fold + surface.ambient < (255 << 7) - 1;
        assert_int_equal(setup.in_steps, 1);
        assert_true(fabs(value[1] - b * (surface.fold / 65536.)) <= .5);
        if (setup.plain) {
            assert_true(low > 0 && high < 32768 && low * fold + surface.ambient >= 128);
            assert_true(high * fold + surface.ambient < 255 << 7);
        } else {
            assert_false(fits);
            wide += low > 0 && high >= 32768;
        }
        plain += setup.plain;
    }
    assert_true(plain > 5000 && wide > 5000);
}

/* A normal shorter than 2^-9 counts as that long, a depth behind the far plane as a step before it. */
static void what_is_divided_by_is_never_0(void **state)
{
    static struct raster r;
    (void)state;
    r.width = r.height = 64;
    r.setup.perspective = 1;
    for (int i = 0; i < 64; i++) {
        const uint32_t step = 1u << 10;
        r.setup.depth = (struct channel){.p = {.f = (DEPTH_FAR << 16) + (uint32_t)(i - 32) * step * RUN, .d = step}};
        r.setup.channel[SHADE_SQUARE] = (struct channel){.p = {.f = (uint32_t)(i - 32) * 256 * RUN, .d = 256}};
        raster_divisors(&r, 0, 0, RUN);
        for (int x = 0; x < RUN; x++) {
            const double w = fmax((i - 32) * 1024. * RUN + 1024. * x, 65536) / 0x1p32; /* of the depth's scale */
            assert_true(fabs(r.divisor[x].half / 0x1p30 * exp2(r.divisor[x].up) * w - 1) < 0x1p-28);
        }
        raster_lengths(&r, 0, 0, RUN);
        for (int x = 0; x < RUN; x++) {
            const double square = fmax(((i - 32) * RUN + x) * 256., 4096) / 0x1p30;
            assert_true(fabs(r.divisor[x].half / 0x1p30 * exp2(r.divisor[x].up) * sqrt(square) - 1) < 0x1p-20);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_drawn_without_a_clamp_stays_in_the_format),
        cmocka_unit_test(what_is_divided_by_is_never_0),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
