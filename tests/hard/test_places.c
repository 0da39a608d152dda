/* SPDX-License-Identifier: MIT */
/* Faces seen exactly from their edge, neighbours in one depth, and highlights with light or eye where none should be.
 */
#include "plan/highlighted.h"
#include "raster/raster.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "hard_case.h"

/* A two-sided triangle whose third corner goes through the line of the others a sub-pixel at a time: one side, nothing,
 * the other, by every method; each pixel whose centre is inside, and no other. */
static void a_two_sided_face_edge_on_is_nothing(void **state)
{
    (void)state;
    for (unsigned m = 0; m < glint_choice_count; m++)
        for (int off = -40; off <= 40; off += off < -4 || off > 3 ? 12 : 1) {
            struct hard_case h;
            const int sub[3][2] = {{-480, 400}, {480, -160}, {0, 120 + off}};
            hard_corners(&h, sub);
            for (int k = 0; k < 3; k++)
                hard_normal(&h, k, .1 * k, .2, 1);
            hard_light(&h, .3, .2, 1);
            h.kd = .5;
            h.ks = .3;
            struct scene_header *scene = hard_scene(&h);
            ((struct scene_material *)(void *)((uint8_t *)scene + scene->materials))->flags = MATERIAL_TWO_SIDED;
            scene->effects |= USES_TWO_SIDED;
            struct frame_case f = frame_case_small(HARD_SIDE, HARD_SIDE, GLINT_GREY8);
            struct glint_stats stats;
            f.config.method = glint_choices[m].method;
            uint8_t *picture = frame_case_picture(f, scene, 0, &stats);
            uint32_t pixels = 0;
            for (int i = 0; i < GLINT_METHODS; i++)
                pixels += stats.pixels[i];
            uint32_t inside = 0, seen = 0;
            for (int i = 0; i < HARD_SIDE * HARD_SIDE; i++) {
                double l[3];
                const int in = off && hard_inside(&h, i % HARD_SIDE, i / HARD_SIDE, l);
                inside += in != 0;
                seen += picture[i] != 0;
                if (in && !picture[i])
                    fail_msg("%s, %d beside the edge: no pixel at %d, %d", glint_choices[m].name, off, i % HARD_SIDE,
                             i / HARD_SIDE);
            }
            assert_true(pixels == seen && seen >= inside && (off || !seen));
            assert_int_equal(stats.culled, off == 0);
            assert_int_equal(stats.turned, off > 0);
            free(picture);
            free(scene);
        }
}

#define SIDE 5

/* A net whose neighbours share edges in one depth, in perspective and cut by the near plane or not, its triangles in
 * their order, the other way round and shuffled: one picture, every pixel drawn once. */
static void neighbours_in_one_depth_are_one_picture_in_any_order(void **state)
{
    static struct scene_vertex vertices[SIDE * SIDE];
    static struct scene_triangle triangles[2 * (SIDE - 1) * (SIDE - 1)];
    const unsigned all = 2 * (SIDE - 1) * (SIDE - 1);
    (void)state;
    random_seed(1);
    for (unsigned i = 0; i < 4 * glint_choice_count; i++) {
        struct scene_case c;
        scene_case_default(&c, 80, 60);
        for (int v = 0; v < SIDE * SIDE; v++) {
            double n[3];
            random_direction(n, 3);
            const double at[3] = {(v % SIDE - 2) * .45 + random_real(-.09, .09),
                                  (2 - v / SIDE) * .45 + random_real(-.09, .09), i & 1 ? v % SIDE * .4 - .8 : 0};
            for (int k = 0; k < 3; k++)
                vertices[v].position[k] = (int16_t)lrint(at[k] * 32767);
            scene_case_normal(vertices[v].normal, n[0], n[1], n[2] + 1.01);
        }
        scene_case_net(&c, vertices, triangles, SIDE);
        c.object[0].position[2] = (q16_t)(-1.5 * CASE_UNIT);
        c.head.camera.near_plane = (q16_t)((i & 2 ? .9 : .5) * CASE_UNIT); /* through the net, where it is tilted */
        c.material[0].kd = 20000;
        c.material[0].ks = 9000;
        c.material[0].shininess = 9;
        uint8_t *first = NULL;
        for (int order = 0; order < 3; order++) {
            struct scene_header *scene = scene_case_blob(&c);
            struct frame_case f = frame_case_small(80, 60, GLINT_RGB888);
            struct glint_stats stats;
            f.config.method = glint_choices[i / 4].method;
            uint8_t *picture = frame_case_picture(f, scene, 0, &stats);
            uint32_t pixels = 0, seen = 0;
            for (int k = 0; k < GLINT_METHODS; k++)
                pixels += stats.pixels[k];
            for (int p = 0; p < 80 * 60; p++)
                seen += (picture[3 * p] | picture[3 * p + 1] | picture[3 * p + 2]) != 0;
            if (pixels != seen)
                fail_msg("case %u, %s: %u pixels for %u places", i, glint_choices[i / 4].name, pixels, seen);
            if (first && memcmp(first, picture, 80 * 60 * 3) != 0 && glint_choices[i / 4].method != &glint_auto_shown)
                fail_msg("case %u, %s: order %d makes another picture", i, glint_choices[i / 4].name, order);
            if (first)
                free(picture);
            else
                first = picture;
            free(scene);
            for (unsigned t = 0; t < all; t++) {
                const unsigned other = order ? (unsigned)random_between(0, (int)all - 1) : all - 1 - t;
                const struct scene_triangle kept = triangles[t];
                if (order || t < all / 2) {
                    triangles[t] = triangles[other];
                    triangles[other] = kept;
                }
            }
        }
        free(first);
    }
}

static void real_way(const struct object_point *to, const double place[3], double out[3])
{
    double length = 0;
    for (int i = 0; i < 3; i++) {
        out[i] = to->near ? to->at[i] - place[i] : to->at[i] / 16384.;
        length += out[i] * out[i];
    }
    for (int i = 0; i < 3; i++)
        out[i] /= sqrt(length);
}

/* The greatest N.H over a triangle where it is lit, on a lattice. */
static double brightest(const struct object_state *object, const struct highlighted_point p[3])
{
    double most = -1;
    for (int i = 1; i < 24; i++)
        for (int j = 1; i + j < 24; j++) {
            const double w[3] = {i / 24., j / 24., 1 - i / 24. - j / 24.};
            double place[3] = {0, 0, 0}, n[3] = {0, 0, 0}, l[3], v[3], h[3];
            for (int a = 0; a < 3; a++)
                for (int k = 0; k < 3; k++) {
                    place[a] += w[k] * p[k].place[a];
                    n[a] += w[k] * p[k].normal[a];
                }
            real_way(&object->light[0].source, place, l);
            real_way(&object->eye, place, v);
            for (int a = 0; a < 3; a++)
                h[a] = l[a] + v[a];
            if (hard_dot(n, l) > 0 && hard_dot(n, v) > 0)
                most = fmax(most, hard_dot(n, h) / sqrt(hard_dot(n, n) * fmax(hard_dot(h, h), 1e-12)));
        }
    return most;
}

/* The light inside the mesh's box, the eye inside or far: what has its highlight's centre in a triangle passes but for
 * a few whose directions turn too much; what faces away from both at all corners never does. */
static void a_light_inside_the_box_hides_few_highlights(void **state)
{
    long centres = 0, missed = 0, away = 0, others = 0, passed = 0;
    (void)state;
    random_seed(2);
    for (int i = 0; i < 30000; i++) {
        struct object_state object = {.local = 1};
        struct highlighted_point p[3];
        struct highlighted_signs s[3];
        double axis[3], at[3] = {0, 0, 0}, normal[3] = {0, 0, 0}, light[3], length;
        int back = 1, inside = 1;
        random_direction(axis, 3);
        object.light[0].source.near = 1;
        object.eye.near = (int16_t)(i & 1);
        const int32_t middle[3] = {random_between(-28000, 28000), random_between(-28000, 28000),
                                   random_between(-28000, 28000)};
        for (int a = 0; a < 3; a++)
            object.light[0].source.at[a] = random_between(-32768, 32767);
        for (int k = 0; k < 3; k++) {
            double off[3];
            random_direction(off, 3);
            for (int a = 0; a < 3; a++) {
                p[k].place[a] = middle[a] + random_between(-4000, 4000);
                p[k].normal[a] = (int32_t)lrint((axis[a] + .3 * off[a]) * 12000);
                at[a] += p[k].place[a] / 3.;
                normal[a] += p[k].normal[a];
            }
        }
        real_way(&object.light[0].source, at, light);
        length = sqrt(hard_dot(normal, normal));
        const double lean = hard_dot(normal, light) / length;
        for (int a = 0; a < 3; a++) { /* the eye where the middle mirrors the light, or behind */
            const double v = (2 * lean * normal[a] / length - light[a]) * (i % 3 ? 1 : -1);
            object.eye.at[a] = (int32_t)lrint(i & 1 ? at[a] + v * 12000 : v * 16384);
            inside &= !(i & 1) || abs(object.eye.at[a]) < 32768;
        }
        if (!inside)
            continue;
        for (int k = 0; k < 3; k++) {
            s[k] = highlighted_signs(&object, 1, &p[k]);
            const double place[3] = {p[k].place[0], p[k].place[1], p[k].place[2]},
                         n[3] = {p[k].normal[0], p[k].normal[1], p[k].normal[2]};
            double l[3], v[3];
            real_way(&object.light[0].source, place, l);
            real_way(&object.eye, place, v);
            back &= hard_dot(n, l) < 0 && hard_dot(n, v) < 0;
        }
        const int passes = highlighted_lights(&s[0], &s[1], &s[2]) != 0;
        if (back) {
            away++;
            assert_false(passes);
        } else if (brightest(&object, p) > 1 - 1e-4) {
            centres++;
            missed += !passes;
        } else {
            others++;
            passed += passes;
        }
    }
    print_message(
        "%ld highlights with the light inside the box, %ld missed; of %ld triangles without %ld pass; %ld face "
        "away from both\n",
        centres, missed, others, passed, away);
    assert_true(passed * 4 < others);
    assert_true(centres > 3000 && missed * 20 < centres && away > 3000);
}

/* A vertex on the line between a light and an eye that are near: what is left of L + V is roundings, and there is no
 * half-way. A hundredth of a radian aside there is, where it should be. */
static void between_a_near_light_and_eye_there_is_no_half_way(void **state)
{
    double worst = 1;
    (void)state;
    random_seed(3);
    for (int i = 0; i < 20000; i++) {
        struct object_state object = {.local = 1};
        const int32_t place[3] = {random_between(-9000, 9000), random_between(-9000, 9000),
                                  random_between(-9000, 9000)};
        const double lean = i & 1 ? .01 : 0;
        double line[3], aside[3], l[3], v[3], half[3];
        q14_t towards[3], got[3];
        random_direction(line, 3);
        random_direction(aside, 3);
        const double along = hard_dot(line, aside);
        object.light[0].source.near = object.eye.near = 1;
        for (int a = 0; a < 3; a++) {
            object.light[0].source.at[a] = place[a] + (int32_t)lrint(line[a] * 60000);
            object.eye.at[a] = place[a] - (int32_t)lrint((line[a] - lean * (aside[a] - along * line[a])) * 90000);
        }
        object_light_at(&object, 0, place, towards, got);
        if (!lean) {
            for (int a = 0; a < 3; a++)
                assert_int_equal(got[a], 0);
            continue;
        }
        const double at[3] = {place[0], place[1], place[2]};
        real_way(&object.light[0].source, at, l);
        real_way(&object.eye, at, v);
        for (int a = 0; a < 3; a++)
            half[a] = l[a] + v[a];
        const double size = sqrt(hard_dot(half, half));
        if (size < 2. / 512) /* the leaning ran along the line */
            continue;
        const double real[3] = {got[0] / 16384., got[1] / 16384., got[2] / 16384.};
        const double cosine = hard_dot(half, real) / size;
        worst = cosine < worst ? cosine : worst;
        assert_true(fabs(sqrt(hard_dot(real, real)) - 1) < 1e-3);
    }
    print_message("half-way a hundredth beside opposite: a cosine of %.4f to it at least\n", worst);
    assert_true(worst > .99);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_two_sided_face_edge_on_is_nothing),
        cmocka_unit_test(neighbours_in_one_depth_are_one_picture_in_any_order),
        cmocka_unit_test(a_light_inside_the_box_hides_few_highlights),
        cmocka_unit_test(between_a_near_light_and_eye_there_is_no_half_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
