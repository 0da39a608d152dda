/* SPDX-License-Identifier: MIT */
/* Loops that draw straight into the band against the general way by runs, and the tables they look colours up in. */
#include "pack/pack.h"
#include "random.h"
#include "raster/spans.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "frame_case.h"

#define SIDE 120

static const uint16_t exponents[] = {1, 5, 20, 24, 50, 200, 1023};

/* The scene with another highlight, and with a second light that is black: that takes the general way. */
static void *changed(const struct pack_result *from, unsigned exponent, uint16_t kd, uint16_t ks, int black)
{
    const size_t room = sizeof(struct scene_light) * 2 + sizeof(struct fx_power);
    struct scene_header *scene = calloc(1, from->size + room);
    assert_non_null(scene);
    memcpy(scene, from->scene, from->size);
    struct scene_light *light = (void *)((uint8_t *)scene + from->size);
    struct fx_power *power = (void *)(light + 2);
    light[0] = light[1] = scene_lights(scene)[0];
    memset(light[1].colour, 0, sizeof light[1].colour);
    fx_power_build(power, exponent);
    scene->lights = (uint32_t)from->size;
    scene->light_count = (uint16_t)(1 + black);
    scene->powers = (uint32_t)(from->size + sizeof light[0] * 2);
    scene->power_count = 1;
    struct scene_material *material = (void *)((uint8_t *)scene + scene->materials);
    for (unsigned i = 0; i < scene->material_count; i++) {
        material[i].shininess = (uint16_t)exponent;
        material[i].power = 0;
        material[i].kd = kd;
        material[i].ks = ks;
    }
    return scene;
}

struct distance {
    int most;
    double mean;
};

static struct distance compare(const uint8_t *a, const uint8_t *b, size_t bytes)
{
    struct distance d = {0, 0};
    long counted = 0, sum = 0;
    for (size_t i = 0; i < bytes; i++) {
        const int off = abs(a[i] - b[i]);
        d.most = off > d.most ? off : d.most;
        sum += off;
        counted += a[i] || b[i];
    }
    d.mean = (double)sum / (double)(counted ? counted : 1);
    return d;
}

static int differ[GLINT_FORMATS]; /* pictures: there are two ways */

/* The two ways may leave out different bends, half a step each of N.L and of N.H, which with the roundings two steps
 * hold. These scenes show one, but of Duff's high powers by the tables of lengths and of powers. */
static void a_scene(const char *path, const struct glint_method *method, enum glint_format format, unsigned tables)
{
    struct pack_result packed;
    assert_int_equal(pack_load(path, NULL, &packed), 0);
    for (size_t i = 0; i < sizeof exponents / sizeof *exponents; i++) {
        struct frame_case f = frame_case_small(SIDE, SIDE, format);
        f.config.method = method;
        f.config.tables = (uint8_t)tables;
        void *one = changed(&packed, exponents[i], 20000, 10000 * (i % 3), 0),
             *two = changed(&packed, exponents[i], 20000, 10000 * (i % 3), 1);
        uint8_t *straight = frame_case_picture(f, one, 0, NULL), *runs = frame_case_picture(f, two, 0, NULL);
        const struct distance d = compare(straight, runs, glint_row_bytes(&f.config) * SIDE);
        if (d.most > (method == &glint_duff && exponents[i] >= 200 ? 2 : 1) || d.mean > .06)
            fail_msg("%s, format %d, %u tables, n = %u: at most %d, mean %.3f", path, format, tables, exponents[i],
                     d.most, d.mean);
        differ[format] += d.most != 0;
        free(straight);
        free(runs);
        free(one);
        free(two);
    }
    pack_free(&packed);
}

static void a_triangle_drawn_straight_is_the_one_drawn_by_runs(void **state)
{
    static const char *const scenes[] = {"tests/scenes/torus288.json", "tests/scenes/sphere690-persp.json",
                                         "tests/golden/clip.json"};
    static const struct glint_method *const methods[] = {&glint_x, &glint_six, &glint_duff};
    (void)state;
    for (int i = 0; i < 3; i++)
        for (int m = 0; m < 3; m++)
            for (unsigned tables = 0; tables < 2; tables++) {
                a_scene(scenes[i], methods[m], GLINT_GREY8, tables);
                a_scene(scenes[i], methods[m], GLINT_RGB888, tables);
            }
    assert_true(differ[GLINT_GREY8] > 90 && differ[GLINT_RGB888] > 30);
}

static void every_length_is_its_formula(void **state)
{
    (void)state;
    for (int i = 0; i < 1 << SPANS_LENGTH_BITS; i++)
        assert_int_equal(spans_length[i], lround(32768 / sqrt(1 - (i + .5) / 4096)));
}

/* What plan->lengths counts on (shade/surface.c): N.V over the length of N as Duff's pixels take it. */
static void a_table_of_lengths_divides_within_its_error(void **state)
{
    double most = 0;
    (void)state;
    random_seed(6);
    for (uint32_t s = 0; s < 1u << 28; s += 997) {
        const double length = sqrt(1 - s / 1073741824.), part = random_real(.999, 1); /* N.V is at most |N| */
        const uint32_t dot = (uint32_t)(part * length * (1 << 30)) + (1u << 14);
        const uint32_t by = spans_length[fx_saturated(s, SPANS_LENGTH_BITS, 28 - SPANS_LENGTH_BITS)];
        most = fmax(most, fabs((dot >> 15) * by / 1073741824. - part));
    }
    print_message("at most %.3g of 2^-13\n", most * 8192);
    assert_true(most <= 1. / 8192 && most > .7 / 8192);
}

/* A raster that has nothing but a material's surface, and its table. */
struct tabled {
    struct raster raster;
    struct fx_power power;
    uint32_t table[20000 / 4];
};

static void tabled_make(struct tabled *t, enum glint_format format, unsigned exponent)
{
    struct raster *r = &t->raster;
    memset(t, 0, sizeof *t);
    r->format = (uint8_t)format;
    r->tables = 1;
    r->table = t->table;
    r->palette.channels = format == GLINT_GREY8 ? 1 : 3;
    for (unsigned c = 0; c < r->palette.channels; c++)
        r->palette.top[c] = raster_top(format, c);
    fx_power_build(&t->power, exponent);
    struct surface *s = &r->surface;
    s->power = &t->power;
    s->channels = r->palette.channels;
    s->lights = 1;
    for (unsigned c = 0; c < s->channels; c++) {
        const double top = r->palette.top[c] * 256, kd = random_real(0, .7), ks = random_real(0, 1);
        s->base[c] = (uint32_t)(top * random_real(0, .2) * 128);
        s->light[0].diffuse[c] = (uint16_t)(top * kd);
        s->light[0].specular[c] = (uint16_t)(top * ks);
    }
    assert_true(table_bytes(format) <= sizeof t->table);
    table_find(r);
    assert_non_null(r->surface_table);
}

/* How far what the table has for a channel is from the truth at (N.L, N.H), 1/255. */
static double table_off(const struct tabled *t, unsigned c, double l, double h)
{
    const struct raster *r = &t->raster;
    const struct surface *s = &r->surface;
    const double top = r->palette.top[c], octave = s->power->octave;
    const double place = fmax(0, 1 - (1 - h) * pow(2, octave)); /* 0 at the foot */
    const uint16_t *entry = r->surface_table->entry;
    double has = 0, wanted = s->base[c] / 32768. + s->light[0].diffuse[c] / 256. * l +
                             s->light[0].specular[c] / 256. * pow(h, s->power->exponent);
    if (r->format == GLINT_RGB565) {
        static const int shift[] = {11, 5, 0};
        const int row = (int)fmin(127, place * 128), column = (int)fmin(63, l * 64 + .5);
        has = entry[row * TABLE_DIFFUSE + column] >> shift[c] & r->palette.top[c];
    } else {
        const int row = (int)fmin((1 << TABLE_BITS) - 1, place * (1 << TABLE_BITS));
        has = (entry[row * (s->channels == 3 ? 4 : 1) + (int)c] - 64) / 128. + s->light[0].diffuse[c] / 256. * l;
        return fabs(has - wanted);
    }
    wanted = fmin(wanted, top);
    return fmax(0, fabs(has - wanted) - .5) * 255 / top; /* less the rounding to the field */
}

static void a_table_is_within_its_error(void **state)
{
    static const enum glint_format formats[] = {GLINT_RGB565, GLINT_GREY8, GLINT_RGB888};
    static struct tabled t;
    (void)state;
    random_seed(5);
    for (int f = 0; f < 3; f++) {
        double closest = 0;
        for (int i = 0; i < 60; i++) {
            tabled_make(&t, formats[f], exponents[i % 7]);
            /* and the power's own table: .29, and .5 below its foot */
            const double bound = table_error(&t.raster) / 256. + .5;
            for (int k = 0; k < 4000; k++) {
                const double l = random_fraction(), h = 1 - random_magnitude(1e-6, 1);
                for (unsigned c = 0; c < t.raster.palette.channels; c++) {
                    const double off = table_off(&t, c, l, h);
                    if (off > bound)
                        fail_msg("format %d, n = %u: off by %.2f at N.L %.4f, N.H %.6f, more than %.2f", formats[f],
                                 t.power.exponent, off, l, h, bound);
                    closest = off / bound > closest ? off / bound : closest;
                }
            }
        }
        print_message("format %d: at most %.2f of the bound\n", formats[f], closest);
        assert_true(closest > .7);
    }
}

static void without_a_table_there_is_no_error(void **state)
{
    static struct tabled t;
    (void)state;
    tabled_make(&t, GLINT_GREY8, 20);
    t.raster.surface.lights = 0;
    table_find(&t.raster);
    assert_null(t.raster.surface_table);
    assert_int_equal(table_error(&t.raster), 0);
    assert_int_equal(table_bytes(GLINT_GREY4), 0);
}

/* Each number of a surface that a table is made of, in turn: the table found next is what an empty one would become. */
static void a_table_is_made_anew_for_any_channel_that_changes(void **state)
{
    static const enum glint_format formats[] = {GLINT_RGB565, GLINT_RGB888};
    static struct tabled t, fresh;
    (void)state;
    random_seed(7);
    for (int f = 0; f < 2; f++)
        for (unsigned c = 0; c < 3; c++)
            for (int which = 0; which < 3; which++) {
                tabled_make(&t, formats[f], 20);
                struct surface *s = &t.raster.surface;
                s->base[c] += which == 0 ? 16 << 15 : 0;
                s->light[0].diffuse[c] = (uint16_t)(s->light[0].diffuse[c] + (which == 1 ? 16 << 8 : 0));
                s->light[0].specular[c] = (uint16_t)(s->light[0].specular[c] + (which == 2 ? 16 << 8 : 0));
                fresh = t;
                memset(fresh.table, 0, sizeof fresh.table);
                fresh.raster.table = fresh.table;
                table_find(&t.raster);
                table_find(&fresh.raster);
                assert_memory_equal(t.table, fresh.table, table_bytes(formats[f]));
            }
}

/* 1 / |N| of |N|^2: a normal shorter than 2^-9 counts as that long. */
static void a_length_is_at_least_its_smallest(void **state)
{
    static const int32_t squares[] = {-(1 << 20), -1,      0,       1,       1000,    (1 << 12) - 1, 1 << 12,
                                      5000,       1 << 14, 3 << 20, 1 << 28, 9 << 26, 1 << 30};
    static struct raster r;
    (void)state;
    for (size_t i = 0; i < sizeof squares / sizeof *squares; i++) {
        memset(&r, 0, sizeof r);
        r.setup.channel[SHADE_SQUARE].p.f = (uint32_t)squares[i];
        raster_lengths(&r, 0, 0, RUN);
        const double wanted = 1 / sqrt(fmax(squares[i] / 0x1p30, 0x1p-18));
        for (int k = 0; k < RUN; k++)
            assert_true(fabs(ldexp(r.divisor[k].half, (int)r.divisor[k].up - 30) / wanted - 1) < 0x1p-20);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_triangle_drawn_straight_is_the_one_drawn_by_runs),
        cmocka_unit_test(every_length_is_its_formula),
        cmocka_unit_test(a_table_of_lengths_divides_within_its_error),
        cmocka_unit_test(a_table_is_within_its_error),
        cmocka_unit_test(without_a_table_there_is_no_error),
        cmocka_unit_test(a_table_is_made_anew_for_any_channel_that_changes),
        cmocka_unit_test(a_length_is_at_least_its_smallest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
