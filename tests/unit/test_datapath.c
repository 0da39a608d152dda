/* SPDX-License-Identifier: MIT */
/* The clocked registers against the renderer's spans and values: the same pixels, the same bits, a pixel a clock. */
#include "cover.h"
#include "datapath/datapath.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>

#define SIZE 512 /* of the picture, in which all triangles lie */

struct triangle {
    int16_t place[3][2];
    const int16_t *p[3];
    struct plane plane;
    struct channel channel;
};

/* Clockwise, up to `reach` sub-pixels across, with a quadratic that a polynomial holds. */
static void random_triangle(struct triangle *t, int reach)
{
    do {
        const int most = 8 * SIZE, x = random_between(-most, most - 1), y = random_between(-most, most - 1);
        for (int k = 0; k < 3; k++) {
            const int px = x + random_between(-reach, reach), py = y + random_between(-reach, reach);
            t->place[k][0] = (int16_t)(px < -most ? -most : px >= most ? most - 1 : px);
            t->place[k][1] = (int16_t)(py < -most ? -most : py >= most ? most - 1 : py);
            t->p[k] = t->place[k];
        }
        if (random_bits() % 8 == 0) /* horizontal-sided already */
            t->place[1][1] = t->place[random_bits() & 1 ? 0 : 2][1];
        if (!plane_setup(&t->plane, t->p, SIZE, SIZE))
            continue;
        plane_setup_quadratic(&t->plane);
        int32_t value[3], bulge[3];
        for (int k = 0; k < 3; k++) {
            value[k] = random_between(-16384, 16384);
            bulge[k] = random_between(-(1 << 28), 1 << 28);
        }
        plane_quadratic(&t->plane, value, bulge, &t->channel);
        if (!t->channel.exact)
            return;
    } while (1);
}

/* What the renderer draws: spans of the rows from *row on, and how many rows. */
static int renderer_spans(const struct triangle *t, int *row, struct span out[SIZE])
{
    struct edges e;
    if (!edges_setup(&e, t->p, SIZE, SIZE, 0, SIZE))
        return 0;
    *row = e.row;
    return edges_spans(&e, SIZE, out, SIZE);
}

/* Counted from the spans alone: pixels, rows without any, and what the loads cost. */
struct clocks {
    long pixels, empty, bubbles;
    int first, last_row; /* nothing drawn yet; pixels of the row before the next load */
};

static void expect_part(struct clocks *c, const struct span *span, int rows)
{
    if (!c->first && c->last_row < 2)
        c->bubbles++; /* the load comes in the clock that ends the row */
    c->first = 0;
    for (int r = 0; r < rows; r++) {
        c->last_row = span[r].x1 > span[r].x0 ? span[r].x1 - span[r].x0 : 0;
        c->pixels += c->last_row;
        c->empty += c->last_row == 0;
    }
}

/* A pixel of the datapath is the next one of the renderer. */
static void check_pixel(const struct triangle *t, struct datapath_pixel got, int row, const struct span *span, int rows,
                        int *at, int *column)
{
    while (*at < rows && *column >= span[*at].x1 - span[*at].x0) {
        ++*at;
        *column = 0;
    }
    int32_t wanted;
    assert_true(*at < rows);
    assert_int_equal(got.y, row + *at);
    assert_int_equal(got.x, span[*at].x0 + *column);
    plane_values(&t->plane, &t->channel, got.x, got.y, 1, &wanted);
    assert_int_equal((int32_t)got.value, wanted);
    ++*column;
}

/* Loads the parts of one triangle as soon as they may be, until all are taken and drawn. Returns the clocks. */
static long draw_alone(const struct triangle *t, struct clocks *c)
{
    static struct span span[SIZE];
    struct datapath_part part[2];
    struct datapath d = {0};
    int row = 0, rows = renderer_spans(t, &row, span), at = 0, column = 0, next = 0, done = 0;
    int parts = datapath_parts(t->p, SIZE, SIZE, &t->plane, &t->channel.p, part);
    for (int k = 0; k < parts; k++) {
        expect_part(c, span + done, part[k].rows);
        done += part[k].rows;
    }
    assert_int_equal(done, rows);
    long clocks = 0, drawn = 0;
    while (drawn < c->pixels || next < parts) {
        const struct datapath_part *load = datapath_ready(&d) && next < parts ? &part[next++] : 0;
        struct datapath_pixel out = datapath_clock(&d, load);
        clocks++;
        if (out.write) {
            check_pixel(t, out, row, span, rows, &at, &column);
            drawn++;
        }
        assert_true(clocks <= c->pixels + c->empty + c->bubbles + 2);
    }
    /* nothing comes after the last pixel */
    for (int k = 0; k < 4 + rows; k++)
        assert_false(datapath_clock(&d, 0).write);
    return clocks;
}

static void random_triangles_have_the_renderers_pixels_and_bits(void **state)
{
    (void)state;
    long pixels = 0, parts[3] = {0};
    random_seed(31);
    for (int reach = 64; reach <= 4096; reach *= 2)
        for (int n = 0; n < (reach > 500 ? 60 : 600); n++) {
            struct triangle t;
            struct clocks c = {.first = 1};
            struct datapath_part part[2];
            random_triangle(&t, reach);
            draw_alone(&t, &c);
            pixels += c.pixels;
            parts[datapath_parts(t.p, SIZE, SIZE, &t.plane, &t.channel.p, part)]++;
        }
    print_message("%ld pixels, %ld triangles of one part, %ld of two\n", pixels, parts[1], parts[2]);
    assert_true(pixels > 1000000 && parts[1] > 100 && parts[2] > 1000);
}

/* The first load and the clock in which its first row comes to the pixel registers; after that, nothing but pixels,
 * rows without one, and loads that had no clock of a last row to hide in. */
static void a_triangle_takes_two_clocks_and_one_a_pixel(void **state)
{
    (void)state;
    long without = 0;
    random_seed(32);
    for (int n = 0; n < 2000; n++) {
        struct triangle t;
        struct clocks c = {.first = 1};
        random_triangle(&t, 256);
        long clocks = draw_alone(&t, &c);
        if (c.pixels == 0 || c.last_row == 0)
            continue; /* rows after the last pixel are not waited for */
        assert_int_equal(clocks, 2 + c.pixels + c.empty + c.bubbles);
        without += c.empty + c.bubbles == 0;
    }
    assert_true(without > 200);
}

/* A stream of triangles: each is loaded while the one before draws its last row. */
static void triangles_follow_one_another_without_a_gap(void **state)
{
    (void)state;
    enum { COUNT = 300 };
    static struct span span[SIZE];
    static struct datapath_part part[2 * COUNT];
    struct datapath d = {0};
    struct clocks c = {.first = 1};
    int parts = 0, next = 0;
    uint32_t wanted_sum = 0, sum = 0;
    random_seed(33);
    for (int n = 0; n < COUNT; n++) {
        struct triangle t;
        int row = 0, done = 0;
        random_triangle(&t, 512);
        int rows = renderer_spans(&t, &row, span);
        int more = datapath_parts(t.p, SIZE, SIZE, &t.plane, &t.channel.p, part + parts);
        for (int k = 0; k < more; k++) {
            expect_part(&c, span + done, part[parts + k].rows);
            done += part[parts + k].rows;
        }
        parts += more;
        for (int r = 0; r < rows; r++)
            for (int x = span[r].x0; x < span[r].x1; x++) {
                int32_t value;
                plane_values(&t.plane, &t.channel, x, row + r, 1, &value);
                wanted_sum = (wanted_sum + (uint32_t)value + (uint32_t)x) * 2654435761u;
            }
    }
    long clocks = 0, drawn = 0;
    for (; drawn < c.pixels; clocks++) {
        const struct datapath_part *load = datapath_ready(&d) && next < parts ? &part[next++] : 0;
        struct datapath_pixel out = datapath_clock(&d, load);
        drawn += out.write;
        if (out.write)
            sum = (sum + out.value + (uint32_t)out.x) * 2654435761u;
    }
    assert_int_equal(sum, wanted_sum);
    assert_true(c.last_row > 0); /* the last clock counted is that of a pixel */
    assert_int_equal(clocks, 2 + c.pixels + c.empty + c.bubbles);
    print_message("%ld pixels in %ld clocks: %ld rows without a pixel, %ld loads that nothing hid\n", c.pixels, clocks,
                  c.empty, c.bubbles);
    assert_true(clocks < c.pixels * 1.05);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_triangles_have_the_renderers_pixels_and_bits),
        cmocka_unit_test(a_triangle_takes_two_clocks_and_one_a_pixel),
        cmocka_unit_test(triangles_follow_one_another_without_a_gap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
