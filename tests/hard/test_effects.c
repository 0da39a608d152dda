/* SPDX-License-Identifier: MIT */
/*
 * Textures, fog, lights, back faces and budgets at the ends of their ranges, on a net of triangles with random normals:
 * what can be known by algebra to the bit, and all else against per-pixel Phong in double precision
 * (host-tools/reference), of the very triangle that was drawn at each pixel.
 */
#include "glint.h"
#include "raster/raster.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/budget/measure.h"
#include "tests/unit/frame_case.h"
#include "tests/unit/random.h"
#include "tests/unit/scene_case.h"

#define WIDTH  64
#define HEIGHT 48
#define SIDE   3

static struct scene_vertex vertices[SIDE * SIDE];
static struct scene_triangle triangles[2 * (SIDE - 1) * (SIDE - 1)];
static int16_t uvs[SIDE * SIDE][2];
static uint16_t texels[1 << 8];

/* A net of nine vertices that faces the eye, in perspective or not, lit from a random side; to be changed. */
static void net(struct scene_case *c, int perspective)
{
    double towards[3];
    scene_case_default(c, WIDTH, HEIGHT);
    c->head.camera.kind = perspective ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC;
    c->head.camera.focal = (perspective ? WIDTH : 24) * CASE_UNIT;
    c->head.camera.near_plane = CASE_UNIT;
    c->head.camera.far_plane = 8 * CASE_UNIT;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double off[3];
        random_direction(off, 3);
        const double at[3] = {(i % SIDE - 1) * .8 + random_real(-.15, .15),
                              (1 - i / SIDE) * .8 + random_real(-.15, .15), random_real(-.4, .4)};
        for (int k = 0; k < 3; k++)
            vertices[i].position[k] = (int16_t)lrint(at[k] * 32767);
        scene_case_normal(vertices[i].normal, .5 * off[0], .5 * off[1], .5 * off[2] + 1);
    }
    scene_case_net(c, vertices, triangles, SIDE);
    c->object[0].position[2] = -2 * CASE_UNIT;
    c->material[0].ka = 3000;
    c->material[0].kd = 16384;
    c->material[0].ks = 12000;
    c->material[0].shininess = 20;
    random_direction(towards, 3);
    for (int k = 0; k < 3; k++)
        c->light[0].vector[k] = (int32_t)lrint((k == 2 ? fabs(towards[k]) : towards[k]) * (1 << 30));
}

/* By how much pixels by auto and each budget, and by phong-perspective, pass what is promised. */
static double beyond(const struct scene_header *scene, uint16_t budget)
{
    struct measure m;
    measure_open(&m, scene, WIDTH, HEIGHT, GLINT_RGB888);
    measure_view(&m, (struct budget_view){0, 0, 0});
    struct budget_picture p = {
        .config = {.width = WIDTH, .height = HEIGHT, .format = GLINT_RGB888, .method = &glint_auto, .budget = budget}};
    budget_open(&p, scene);
    budget_draw(&p, scene, (struct budget_view){0, 0, 0});
    const double most = measure_picture(&m, p.pixels).error, allowed = (budget ? budget : 512) / 256. + 1;
    assert_true(p.frame.stats.largest_error <= (budget ? budget : 512));
    budget_close(&p);
    measure_close(&m);
    return most - allowed;
}

static const uint16_t budgets[] = {0, 1, 128, 512, 8192, 65535};

static void check_budgets(const struct scene_header *scene, const char *what, int number, double *closest)
{
    for (size_t b = 0; b < sizeof budgets / sizeof *budgets; b++) {
        const double more = beyond(scene, budgets[b]);
        if (more > 0)
            fail_msg("%s, case %d: %.2f beyond a budget of %u/256", what, number, more, budgets[b]);
        *closest = fmax(*closest, more);
    }
}

static uint8_t *picture_of(const struct scene_header *scene, const struct glint_method *method)
{
    struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_RGB888);
    f.config.method = method;
    return frame_case_picture(f, scene, 0, NULL);
}

static void assert_same(const struct scene_case *a, const struct scene_case *b, const char *what)
{
    struct scene_header *scene[2] = {scene_case_blob(a), scene_case_blob(b)};
    for (unsigned m = 0; m < glint_choice_count; m++) {
        uint8_t *picture[2];
        for (int i = 0; i < 2; i++)
            picture[i] = picture_of(scene[i], glint_choices[m].method);
        if (memcmp(picture[0], picture[1], WIDTH * HEIGHT * 3) != 0)
            fail_msg("%s: by %s there is a difference", what, glint_choices[m].name);
        free(picture[0]);
        free(picture[1]);
    }
    free(scene[0]);
    free(scene[1]);
}

static void add_texture(struct scene_case *c, int log2_width, int log2_height, unsigned flags)
{
    for (int i = 0; i < 1 << 8; i++)
        texels[i] = (uint16_t)(random_between(20, 31) << 11 | random_between(40, 63) << 5 | random_between(20, 31));
    c->texture = (struct scene_texture){
        .log2_width = (uint8_t)log2_width, .log2_height = (uint8_t)log2_height, .flags = (uint8_t)flags};
    c->texels = texels;
    c->uvs = (const int16_t(*)[2])uvs;
}

/* Of one texel: whatever the coordinates, filter and border, the picture is that of any other coordinates. */
static void a_texture_of_one_texel_is_a_colour(void **state)
{
    double closest = -9;
    (void)state;
    random_seed(1);
    for (int i = 0; i < 16; i++) {
        struct scene_case c, d;
        int16_t kept[SIDE * SIDE][2];
        net(&c, i & 1);
        add_texture(&c, 0, 0, (unsigned)i / 2);
        for (int v = 0; v < SIDE * SIDE; v++)
            for (int k = 0; k < 2; k++)
                uvs[v][k] = (int16_t)(random_between(0, 1) ? INT16_MAX : INT16_MIN);
        memcpy(kept, uvs, sizeof kept);
        d = c;
        memset(uvs, 0, sizeof uvs);
        d.uvs = (const int16_t(*)[2])kept;
        assert_same(&c, &d, "one texel");
        struct scene_header *scene = scene_case_blob(&d);
        check_budgets(scene, "one texel", i, &closest);
        free(scene);
    }
}

/* Coordinates over the whole range, negative ones too, repeating; and up to 6 turns either way where clamped. */
static void coordinates_at_their_ends_repeat_and_clamp(void **state)
{
    double closest = -9;
    (void)state;
    random_seed(2);
    for (int i = 0; i < 120; i++) {
        struct scene_case c;
        const unsigned flags = (unsigned)i & 7;
        net(&c, i / 8 & 1);
        add_texture(&c, random_between(0, 4), random_between(0, 4), flags);
        for (int v = 0; v < SIDE * SIDE; v++)
            for (int k = 0; k < 2; k++) {
                const int clamped = flags >> (k + 1) & 1, end = clamped                ? SCENE_MOST_CLAMPED * 4096
                                                                : random_between(0, 1) ? INT16_MAX
                                                                                       : 32768;
                uvs[v][k] = (int16_t)(random_between(0, 1) ? random_between(0, 1) && end < 32768 ? end : -end
                                                           : random_between(-end + 1, end - 1));
            }
        struct scene_header *scene = scene_case_blob(&c);
        check_budgets(scene, "coordinates", i, &closest);
        free(scene);
    }
    print_message("up to %.2f of 1/255 below what is allowed\n", -closest);
}

/* A light without intensity beside another: what there is without it, but for the sums' other roundings. */
static void lights_that_give_nothing_change_nothing(void **state)
{
    (void)state;
    random_seed(3);
    for (int i = 0; i < 12; i++) {
        struct scene_case c, d;
        net(&c, i & 1);
        if (i & 2) /* far, or near the net */
            c.head.camera.viewer = VIEWER_LOCAL;
        d = c;
        d.light_count = 2;
        d.light[1] = d.light[0];
        for (int k = 0; k < 3; k++)
            d.light[1].colour[k] = 0;
        d.light[1].vector[1] = -d.light[1].vector[1];
        struct scene_header *scene[2] = {scene_case_blob(&c), scene_case_blob(&d)};
        for (unsigned m = 0; m < glint_choice_count; m++) {
            if (strncmp(glint_choices[m].name, "subdivide", 9) == 0)
                continue; /* they look for highlights of each light */
            struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_RGB888);
            f.config.method = glint_choices[m].method;
            uint8_t *one = frame_case_picture(f, scene[0], 0, NULL), *two = frame_case_picture(f, scene[1], 0, NULL);
            for (int p = 0; p < WIDTH * HEIGHT * 3; p++)
                if (abs(one[p] - two[p]) > (strncmp(glint_choices[m].name, "auto", 4) == 0 ? 4 : 1))
                    fail_msg("case %d by %s: %d and %d", i, glint_choices[m].name, one[p], two[p]);
            free(one);
            free(two);
        }
        free(scene[0]);
        free(scene[1]);
    }
}

/* No light at all, or one opposite to the eye, whatever the object's turn: L + V is 0 but for roundings, and makes no
 * highlight. The ambient part in each pixel, by every method. */
static void light_from_behind_leaves_the_ambient_part(void **state)
{
    (void)state;
    random_seed(4);
    for (int i = 0; i < 12; i++) {
        struct scene_case c;
        double turn[4];
        net(&c, i & 1);
        for (int v = 0; v < SIDE * SIDE; v++)
            scene_case_normal(vertices[v].normal, random_real(-.3, .3), random_real(-.3, .3), 1);
        for (unsigned t = 0; t < c.mesh[0].triangle_count; t++)
            scene_case_bend(&triangles[t], vertices);
        random_direction(turn, 4);
        turn[0] = 4; /* not far */
        const double length = sqrt(16 + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
        for (int k = 0; k < 4 && i > 3; k++)
            c.object[0].rotation[k] = (q30_t)lrint(turn[k] / length * (1 << 30));
        c.light[0].vector[0] = c.light[0].vector[1] = 0;
        c.light[0].vector[2] = -(1 << 30);
        c.light_count = i & 2 ? 0 : 1;
        c.material[0].shininess = i & 4 ? 1 : 5;
        struct scene_header *scene = scene_case_blob(&c);
        const int ambient = (int)lrint(255 * 3000 / 32768.);
        for (unsigned m = 0; m < glint_choice_count; m++) {
            const struct glint_method *method = glint_choices[m].method;
            if (method == &glint_auto_shown || method->id == GLINT_OVERVELD || method->id == GLINT_BIQUADRATIC)
                continue; /* normals that bend may turn to the light */
            uint8_t *picture = picture_of(scene, method);
            for (int p = 0; p < WIDTH * HEIGHT * 3; p++)
                if (picture[p] && picture[p] != ambient)
                    fail_msg("case %d by %s: %d", i, glint_choices[m].name, picture[p]);
            free(picture);
        }
        free(scene);
    }
}

/* From 10 degrees beside opposite to the eye down to a hundredth: H is short, but no less exact for it. */
static void light_from_nearly_behind_is_within_the_budget(void **state)
{
    double closest = -9;
    (void)state;
    random_seed(7);
    for (int i = 0; i < 60; i++) {
        struct scene_case c;
        net(&c, i & 1);
        const double a = random_magnitude(.01, 10) * acos(-1) / 180, turn = random_real(0, 6.28);
        c.light[0].vector[0] = (int32_t)lrint(sin(a) * cos(turn) * (1 << 30));
        c.light[0].vector[1] = (int32_t)lrint(sin(a) * sin(turn) * (1 << 30));
        c.light[0].vector[2] = (int32_t)lrint(-cos(a) * (1 << 30));
        c.material[0].shininess = i % 3 ? 5 : 1;
        struct scene_header *scene = scene_case_blob(&c);
        check_budgets(scene, "light from nearly behind", i, &closest);
        free(scene);
    }
    print_message("up to %.2f of 1/255 below what is allowed\n", -closest);
}

/* Point lights from far off down to a tenth of a pixel above a vertex, and at it: what places rounded to 1/16 of a
 * pixel cost. `distance` in pixels of the orthographic view. */
static void a_light_at_a_vertex_stays_within_the_budget(void **state)
{
    static const double distances[] = {64, 16, 8, 4, 2, 1, .5, .1, 0};
    (void)state;
    random_seed(5);
    for (size_t d = 0; d < sizeof distances / sizeof *distances; d++) {
        double worst = -9;
        for (int i = 0; i < 20; i++) {
            struct scene_case c;
            net(&c, 0);
            const int v = random_between(0, SIDE * SIDE - 1);
            c.light[0].kind = LIGHT_POINT;
            for (int k = 0; k < 3; k++)
                c.light[0].vector[k] = vertices[v].position[k] * 2 + (k == 2 ? c.object[0].position[2] : 0) +
                                       (int32_t)lrint(distances[d] / 24 * vertices[v].normal[k] * 4);
            struct scene_header *scene = scene_case_blob(&c);
            worst = fmax(worst, beyond(scene, 256));
            free(scene);
        }
        print_message("a light %.1f pixels above a vertex: %.2f beyond what is allowed\n", distances[d], worst);
        assert_true(worst <= 0);
    }
}

/* Fog of the least and the most thickness: from clear to solid in one step of Q16, next to nothing and all. */
static void fog_at_its_ends_is_clear_and_solid(void **state)
{
    (void)state;
    random_seed(6);
    for (int i = 0; i < 24; i++) {
        struct scene_case c, none;
        net(&c, i & 1);
        none = c;
        static const uint16_t colour[3] = {32768, 16384, 0};
        memcpy(c.head.fog.colour, colour, sizeof colour);
        c.head.fog.kind = i & 2 ? FOG_EXPONENTIAL : FOG_LINEAR;
        const int thick = i & 4;
        if (i & 2)
            c.head.fog.density = thick ? 1u << 28 : 1;
        else
            c.head.fog.from = thick ? CASE_UNIT : 4 * CASE_UNIT;
        c.head.fog.to = i & 2 ? 0 : c.head.fog.from + 1;
        if (!thick) {
            assert_same(&c, &none, "fog that is none");
            continue;
        }
        struct scene_header *scene = scene_case_blob(&c);
        for (unsigned m = 0; m < glint_choice_count; m++) {
            uint8_t *picture = picture_of(scene, glint_choices[m].method);
            for (int p = 0; p < WIDTH * HEIGHT; p++)
                if ((picture[3 * p] | picture[3 * p + 1] | picture[3 * p + 2]) &&
                    (picture[3 * p] != 255 || picture[3 * p + 1] != 128 || picture[3 * p + 2] != 0))
                    fail_msg("case %d by %s: %d %d %d", i, glint_choices[m].name, picture[3 * p], picture[3 * p + 1],
                             picture[3 * p + 2]);
            free(picture);
        }
        free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_texture_of_one_texel_is_a_colour),
        cmocka_unit_test(coordinates_at_their_ends_repeat_and_clamp),
        cmocka_unit_test(lights_that_give_nothing_change_nothing),
        cmocka_unit_test(light_from_behind_leaves_the_ambient_part),
        cmocka_unit_test(light_from_nearly_behind_is_within_the_budget),
        cmocka_unit_test(a_light_at_a_vertex_stays_within_the_budget),
        cmocka_unit_test(fog_at_its_ends_is_clear_and_solid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
