/* SPDX-License-Identifier: MIT */
/* Random meshes under random lights, near and far, by every method: against the same in double precision, and against
 * themselves in bands and without the plan. */
#include "glint.h"
#include "random.h"
#include "raster/raster.h"
#include "reference/method.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "scene_case.h"

#define WIDTH  64
#define HEIGHT 48
#define SIDE   3 /* vertices a side of the mesh */

static struct scene_vertex vertices[SIDE * SIDE];
static struct scene_triangle triangles[2 * (SIDE - 1) * (SIDE - 1)];

/* A net that faces the eye, two units wide, its vertices and normals moved at random: `lean` 0 leaves the normals along
 * the view, 3 forgets it. */
static void random_mesh(struct scene_case *c, double lean)
{
    unsigned count = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double off[3];
        random_direction(off, 3);
        const double at[3] = {(i % SIDE - 1) * .8 + random_real(-.19, .19),
                              (1 - i / SIDE) * .8 + random_real(-.19, .19), random_real(-.4, .4)};
        for (int k = 0; k < 3; k++)
            vertices[i].position[k] = (int16_t)lrint(at[k] * 32767);
        scene_case_normal(vertices[i].normal, off[0] * lean, off[1] * lean, off[2] * lean + 1.0001);
    }
    for (int row = 0; row < SIDE - 1; row++)
        for (int column = 0; column < SIDE - 1; column++) {
            const int a = row * SIDE + column, corner[2][3] = {{a, a + SIDE, a + SIDE + 1}, {a, a + SIDE + 1, a + 1}};
            for (int t = 0; t < 2; t++, count++) {
                for (int k = 0; k < 3; k++)
                    triangles[count].corner[k] = (uint16_t)corner[t][(k + column) % 3];
                scene_case_bend(&triangles[count], vertices);
            }
        }
    c->mesh[0].vertices = vertices;
    c->mesh[0].triangles = triangles;
    c->mesh[0].vertex_count = SIDE * SIDE;
    c->mesh[0].triangle_count = count;
    c->object[0].position[2] = (q16_t)(-random_real(1.5, 3) * CASE_UNIT);
}

static void random_lights(struct scene_case *c)
{
    c->light_count = random_fraction() < .6 ? 1 : (unsigned)random_between(2, SCENE_MAX_LIGHTS);
    for (unsigned i = 0; i < c->light_count; i++) {
        struct scene_light *light = &c->light[i];
        double towards[3];
        random_direction(towards, 3);
        light->kind = random_fraction() < .5 ? LIGHT_POINT : LIGHT_DIRECTIONAL;
        const double distance = light->kind == LIGHT_POINT ? random_real(.1, 3) * CASE_UNIT : 1 << 30;
        for (int k = 0; k < 3; k++) {
            light->colour[k] = (uint16_t)(32768 / c->light_count);
            light->vector[k] = (int32_t)lrint(towards[k] * distance);
        }
        if (light->kind == LIGHT_POINT)
            light->vector[2] += c->object[0].position[2];
    }
}

/* A checked scene, to be freed. */
static struct scene_header *random_scene(double lean, const uint16_t *exponents, int exponent_count)
{
    struct scene_case c;
    scene_case_default(&c, WIDTH, HEIGHT);
    c.head.camera.kind = random_fraction() < .3 ? CAMERA_ORTHOGRAPHIC : CAMERA_PERSPECTIVE;
    c.head.camera.viewer = random_fraction() < .5 ? VIEWER_LOCAL : VIEWER_INFINITE;
    if (c.head.camera.kind == CAMERA_ORTHOGRAPHIC)
        c.head.camera.focal = 24 * CASE_UNIT;
    c.head.camera.near_plane = CASE_UNIT;
    c.material[0].ka = 3000;
    c.material[0].kd = (uint16_t)random_between(0, 32768);
    c.material[0].ks = (uint16_t)random_between(0, 32768);
    c.material[0].shininess = exponents[random_between(0, exponent_count - 1)];
    random_mesh(&c, lean);
    random_lights(&c);
    return scene_case_blob(&c);
}

static int is_compared(const char *name)
{
    return (strncmp(name, "phong", 5) == 0 || method_find(name) >= 0) && strncmp(name, "subdivide", 9) != 0 &&
           strncmp(name, "hybrid", 6) != 0 && strcmp(name, "flat") != 0;
}

static enum reference_method ideal_of(const char *name)
{
    if (strcmp(name, "phong") == 0)
        return REFERENCE_PHONG_SCREEN;
    return strcmp(name, "phong-perspective") == 0 ? REFERENCE_PHONG : (enum reference_method)method_find(name);
}

static double difference(const struct scene_header *scene, const struct glint_choice *choice)
{
    const struct reference_options options = {
        .width = WIDTH, .height = HEIGHT, .method = ideal_of(choice->name), .grey = true};
    struct reference_image truth;
    struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_GREY8);
    double most = 0;
    f.config.method = choice->method;
    uint8_t *picture = frame_case_picture(f, scene, 0, NULL);
    assert_true(reference_render(scene, &options, &truth));
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        if (truth.covered[i] && picture[i])
            most = fmax(most, fabs(picture[i] - truth.value[i] * 255));
    reference_free(&truth);
    free(picture);
    return most;
}

/* Half a step is the output's, the rest of the first that of corners rounded to Q14. What makes normals unit at each
 * pixel sees a light that is all but on the surface, and a quadratic normal that all but passes 0. */
static double most_of(unsigned id)
{
    return id == GLINT_PHONG || id == GLINT_OVERVELD || id == GLINT_BIQUADRATIC ? 4.5 : 1;
}

static void every_method_is_its_ideal_on_random_meshes(void **state)
{
    static const uint16_t exponents[] = {1, 2, 5, 10, 20, 50};
    (void)state;
    random_seed(1);
    for (int i = 0; i < 150; i++) {
        struct scene_header *scene = random_scene(.8 * random_fraction(), exponents, 6);
        for (unsigned m = 0; m < glint_choice_count; m++) {
            const char *name = glint_choices[m].name;
            double most = is_compared(name) ? difference(scene, &glint_choices[m]) : 0;
            if (most > most_of(glint_choices[m].method->id))
                fail_msg("scene %d, %s: off by %.2f", i, name, most);
        }
        free(scene);
    }
}

static const struct glint_power *const powers[] = {NULL, &glint_power_exact, &glint_power_4, &glint_power_8,
                                                   &glint_power_16};

/* Normals up to opposite ones, every exponent's end, every form of the power. */
static void neither_bands_nor_the_plan_change_a_pixel(void **state)
{
    static const uint16_t exponents[] = {1, 2, 5, 15, 50, 1023};
    (void)state;
    random_seed(2);
    for (int i = 0; i < 500; i++) {
        struct scene_header *scene = random_scene(3 * random_fraction(), exponents, 6);
        const struct glint_choice *choice = &glint_choices[(unsigned)i % glint_choice_count];
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, (enum glint_format)random_between(0, GLINT_FORMATS - 1));
        f.config.method = choice->method;
        f.config.power = powers[random_between(0, 4)];
        f.config.tables = (uint8_t)random_between(0, 1);
        f.config.flags = random_between(0, 3) ? 0 : GLINT_DITHER;
        uint8_t *picture = frame_case_picture(f, scene, 0, NULL);
        frame_case_same(&f, picture, scene, 1, 0, choice->name);
        frame_case_same(&f, picture, scene, 7, 0, choice->name);
        frame_case_same(&f, picture, scene, HEIGHT, GLINT_NO_PLAN, choice->name);
        free(picture);
        free(scene);
    }
}

/* The largest difference of a field of two 565 pictures, in 1/255. */
static int field_difference(const uint8_t *a, const uint8_t *b)
{
    static const int shift[] = {11, 5, 0}, top[] = {31, 63, 31};
    int most = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        for (int c = 0; c < 3; c++) {
            int size = abs((((const uint16_t *)(const void *)a)[i] >> shift[c] & top[c]) -
                           (((const uint16_t *)(const void *)b)[i] >> shift[c] & top[c])) *
                       255 / top[c];
            most = size > most ? size : most;
        }
    return most;
}

/* A step of red and blue is 8.2 of 1/255: a table's own steps may cost two. */
static void a_colour_table_holds_every_form_of_the_power(void **state)
{
    static const uint16_t exponents[] = {20, 50};
    (void)state;
    random_seed(3);
    for (int i = 0; i < 100; i++) {
        struct scene_header *scene = random_scene(.5 * random_fraction(), exponents, 2);
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_RGB565);
        f.config.method = i & 1 ? &glint_six : &glint_x;
        f.config.power = powers[i % 5];
        uint8_t *without = frame_case_picture(f, scene, 0, NULL);
        f.config.tables = 1;
        uint8_t *with = frame_case_picture(f, scene, 0, NULL);
        int most = field_difference(without, with);
        if (most > 17)
            fail_msg("scene %d, form %d, n %d: the table is off by %d", i, i % 5, scene_materials(scene)->shininess,
                     most);
        free(without);
        free(with);
        free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_is_its_ideal_on_random_meshes),
        cmocka_unit_test(neither_bands_nor_the_plan_change_a_pixel),
        cmocka_unit_test(a_colour_table_holds_every_form_of_the_power),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
