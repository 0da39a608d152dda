/* SPDX-License-Identifier: MIT */
/* What a triangle's channels are set up from, by definition, from the vertex records on: test_pictures.c takes over. */
#include "exact_bounds.h"
#include "exact_pixel.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "pictures_case.h"

#define SIDE 40

static long checked, backs, bent, straight, by_corners;

/* The triangle that was drawn, its corners clockwise, and which of the mesh's each is: 0, 2, 1, or from behind 0, 1, 2,
 * its dot products negated as far as a record holds them. */
struct seen {
    struct exact_triangle t;
    const int16_t *record[3];
    int corner[3], sign;
};

static struct seen look(const struct frame_case *f, const struct scene_triangle *triangle)
{
    struct seen s = {.t = {.width = f->config.width, .height = f->config.height}, .corner = {0, 2, 1}, .sign = 1};
    for (int turned = 0; turned < 2; turned++) {
        for (int k = 0; k < 3; k++) {
            s.record[k] = f->frame.vertices + triangle->corner[s.corner[k]] * f->frame.vertex_stride;
            s.t.p[k] = (struct cover_point){s.record[k][VERTEX_X], s.record[k][VERTEX_Y]};
        }
        if (exact_area(&s.t) > 0)
            return s;
        s.sign = -1;
        s.corner[1] = 1;
        s.corner[2] = 2;
    }
    fail_msg("no area");
    return s;
}

static int32_t dot_of(const struct seen *s, int k, unsigned index)
{
    const int32_t dot = s->sign * s->record[k][VERTEX_LIGHTS + index];
    return dot > 16383 ? 16383 : dot;
}

static void near(double off, double bound)
{
    if (!(fabs(off) <= bound))
        fail_msg("a coefficient is off by %.1f, not at most %.1f", off, bound);
}

/* A channel of this quantity. */
static void check_channel(const struct exact_triangle *t, const struct plane *plane, const struct channel *channel,
                          const struct exact_quantity *q)
{
    checked++;
    if (channel->exact) {
        by_corners++;
        for (int k = 0; k < 3; k++) {
            assert_int_equal(channel->corner.value[k], q->value[k] * (channel->exact == PLANE_EXACT_WIDE ? 65536 : 1));
            assert_int_equal(channel->corner.bulge[k], q->bulge[k]);
        }
        return;
    }
    const struct polynomial *got = &channel->p;
    const struct exact_polynomial p = exact_polynomial(t, q, plane->ox, plane->oy);
    const int linear = !(got->a | got->b | got->c);
    const struct exact_bounds by = linear                      ? exact_linear_bounds(t, &p)
                                   : plane->thin || plane->far ? exact_wide_bounds(t, &p, 1)
                                                               : exact_quadratic_bounds(t, &p);
    near(exact_off(got->f, p.f, p.den), by.f);
    near(exact_off(got->d, p.d, p.den), by.d);
    near(exact_off(got->e, p.e, p.den), by.e);
    near(exact_off(got->a, p.a, p.den), by.a);
    near(exact_off(got->b, p.b, p.den), by.b);
    near(exact_off(got->c, p.c, p.den), by.c);
}

/* gouraud: finished colours of the corners, Q8 steps. */
static void check_colours(const struct raster *r, const struct seen *seen, const struct shade_setup *setup)
{
    const struct surface *s = &r->surface;
    struct exact_quantity q[3] = {{.unit = 65536}, {.unit = 65536}, {.unit = 65536}};
    for (int k = 0; k < 3; k++) {
        struct exact_dots d = {.has_l = {0}};
        int64_t sum[3];
        for (unsigned i = 0; i < s->lights; i++) {
            d.l[i] = dot_of(seen, k, 2 * i) * 65536;
            d.h[i] = dot_of(seen, k, 2 * i + 1) * 65536;
            d.has_l[i] = 1;
            d.has_h[i] = d.h[i] > 0;
        }
        exact_sums(s, &d, sum);
        for (unsigned c = 0; c < s->channels; c++)
            q[c].value[k] = (int32_t)exact_floor(exact_between(sum[c], 0, s->top[c]), 7);
    }
    for (unsigned c = 0; c < s->channels; c++)
        check_channel(&seen->t, &setup->plane, &setup->channel[c], &q[c]);
}

/* x: Ii, and the bulges (Ii + Ij) kij in Q28 of edges' -k in Q16; in steps of grey times the diffuse light, to nearest.
 * A bend is left out where its third, at full light, is less than half a step. */
static void check_dot(const struct raster *r, const struct scene_triangle *triangle, const struct seen *seen,
                      const struct shade_setup *setup, unsigned index)
{
    struct exact_quantity q = {.unit = 65536};
    const struct channel *channel = &setup->channel[index];
    const int fold = !index && setup->in_steps ? r->surface.fold : 0;
    int32_t most = 0;
    for (int k = 0; k < 3; k++)
        q.value[k] = dot_of(seen, k, index);
    for (int k = 0; k < 3; k++) {
        const int a = seen->corner[k], b = seen->corner[(k + 1) % 3], edge = (a + 1) % 3 == b ? a : b;
        q.bulge[k] = (int32_t)-exact_floor((int64_t)(q.value[k] + q.value[(k + 1) % 3]) * triangle->bend[edge], 2);
        most = abs(q.bulge[k]) > most ? abs(q.bulge[k]) : most;
    }
    for (int k = 0; k < 3 && fold; k++) {
        q.value[k] = (int32_t)exact_floor((int64_t)q.value[k] * fold + (1 << 15), 16);
        q.bulge[k] = (int32_t)(2 * exact_floor((int64_t)q.bulge[k] * fold, 17));
    }
    const int linear = channel->exact
                           ? !(channel->corner.bulge[0] | channel->corner.bulge[1] | channel->corner.bulge[2])
                           : !(channel->p.a | channel->p.b | channel->p.c);
    if (linear && most) {
        straight++;
        if (!(index & 1))
            assert_true((double)most / 3 * r->surface.light[index / 2].diffuse_most <= 0x1p28 * 128);
        for (int k = 0; k < 3; k++)
            q.bulge[k] = 0;
    }
    bent += !linear;
    check_channel(&seen->t, &setup->plane, channel, &q);
}

static void check_frames(const struct glint_method *method, uint32_t seed)
{
    checked = backs = bent = straight = by_corners = 0;
    random_seed(seed);
    for (int i = 0; i < 1200; i++) {
        const unsigned width = (unsigned)random_between(1, SIDE), height = (unsigned)random_between(1, SIDE);
        struct scene_header *blob = pictures_begin(width, height, 1 + (random_bits() & 1));
        struct frame_case f = frame_case_small(width, height, i & 1 ? GLINT_GREY8 : GLINT_RGB888);
        f.config.method = method;
        f.config.tables = (uint8_t)(random_bits() & 1);
        frame_case_open_for(&f, blob);
        for (int n = 0; n < 8; n++) {
            struct scene_vertex corner[3];
            pictures_random_corners(corner, width, height);
            pictures_put_one(blob, corner, pictures_order[random_bits() % ORDERS]);
            frame_case_draw(&f, blob, 0);
            if (!frame_case_drawn(&f))
                continue;
            const struct raster *r = f.frame.raster;
            const struct scene_triangle *triangle = pictures_part(blob, pictures_mesh_of(blob)->triangles);
            const struct seen seen = look(&f, triangle);
            static struct shade_setup setup;
            int32_t depth[3];
            memset(&setup, 0, sizeof setup);
            assert_int_equal(plane_setup(&setup.plane, r->input.place, width, height), 1);
            for (int k = 0; k < 3; k++)
                depth[k] = (uint16_t)seen.record[k][VERTEX_DEPTH];
            plane_linear(&setup.plane, depth, &setup.depth);
            method->setup(&setup, &r->input);
            backs += seen.sign < 0;
            if (method == &glint_gouraud)
                check_colours(r, &seen, &setup);
            for (unsigned c = 0; c < 2u * r->surface.lights && method == &glint_x; c++)
                if ((c & 1 ? setup.specular_lights : setup.diffuse_lights) >> c / 2 & 1)
                    check_dot(r, triangle, &seen, &setup, c);
        }
        frame_case_close(&f);
        free(blob);
    }
    print_message("%ld channels, %ld bent, %ld bends left out, %ld by corner values; %ld triangles from behind\n",
                  checked, bent, straight, by_corners, backs);
    assert_true(checked > 3000 && backs > 1000 && by_corners > 50);
}

static void gouraud_is_set_up_from_finished_colours(void **state)
{
    (void)state;
    check_frames(&glint_gouraud, 31);
}

static void x_is_set_up_from_dot_products_and_bulges(void **state)
{
    (void)state;
    check_frames(&glint_x, 32);
    assert_true(bent > 1000 && straight > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gouraud_is_set_up_from_finished_colours),
        cmocka_unit_test(x_is_set_up_from_dot_products_and_bulges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
