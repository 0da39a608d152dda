/* SPDX-License-Identifier: MIT */
/*
 * Effects together: random nets under every pair of effects, against the same in double precision, and against
 * themselves in bands, without the plan and with colour tables.
 */
#include "glint.h"
#include "random.h"
#include "reference/method.h"
#include "reference/reference.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "scene_case.h"

#define WIDTH  64
#define HEIGHT 48
#define SIDE   3 /* vertices a side of the net */
#define COUNT  (2 * (SIDE - 1) * (SIDE - 1))

/* What a scene has, a bit each. */
enum {
    PERSPECTIVE = 1,
    POINT_LIGHT = 2,
    SEVERAL_LIGHTS = 4,
    LOCAL_VIEWER = 8,
    SPECULAR = 16,
    FOG = 32,
    EXPONENTIAL = 64, /* the fog, if there is one */
    BACK = 128,       /* a two-sided net seen from behind */
    CLIPPED = 256,    /* in perspective: by the near plane */
    TEXTURE = 512,
};
#define EFFECTS 10
#define LOG2    3 /* of a texture's sides */

static struct scene_vertex vertices[SIDE * SIDE];
static struct scene_triangle triangles[COUNT];
static int16_t uvs[SIDE * SIDE][2];
static uint16_t texels[1 << 2 * LOG2];

static void random_net(struct scene_case *c, int back)
{
    unsigned count = 0;
    memset(triangles, 0, sizeof triangles);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double off[3], sign = back ? -1 : 1;
        random_direction(off, 3);
        const double at[3] = {(i % SIDE - 1) * .8 + random_real(-.15, .15),
                              (1 - i / SIDE) * .8 + random_real(-.15, .15), random_real(-.4, .4)};
        for (int k = 0; k < 3; k++)
            vertices[i].position[k] = (int16_t)lrint(at[k] * 32767);
        scene_case_normal(vertices[i].normal, sign * .5 * off[0], sign * .5 * off[1], sign * (.5 * off[2] + 1));
    }
    for (int row = 0; row < SIDE - 1; row++)
        for (int column = 0; column < SIDE - 1; column++) {
            const int a = row * SIDE + column, corner[2][3] = {{a, a + SIDE, a + SIDE + 1}, {a, a + SIDE + 1, a + 1}};
            for (int t = 0; t < 2; t++, count++) {
                for (int k = 0; k < 3; k++)
                    triangles[count].corner[back && k ? 3 - k : k] = (uint16_t)corner[t][k];
                scene_case_bend(&triangles[count], vertices);
            }
        }
    c->mesh[0].vertices = vertices;
    c->mesh[0].triangles = triangles;
    c->mesh[0].vertex_count = SIDE * SIDE;
    c->mesh[0].triangle_count = COUNT;
}

/* A texel or two between vertices, of colours not far apart: what a rounding of the coordinates costs stays small. */
static void random_texture(struct scene_case *c)
{
    for (int i = 0; i < 1 << 2 * LOG2; i++)
        texels[i] = (uint16_t)(random_between(18, 31) << 11 | random_between(36, 63) << 5 | random_between(18, 31));
    for (int i = 0; i < SIDE * SIDE; i++) {
        uvs[i][0] = (int16_t)((i % SIDE) * 900 + random_between(-200, 200));
        uvs[i][1] = (int16_t)((i / SIDE) * 900 + random_between(-200, 200));
    }
    c->texture.log2_width = c->texture.log2_height = LOG2;
    c->texture.flags = (uint8_t)(TEXTURE_BILINEAR | random_between(0, 3) * TEXTURE_CLAMP_U);
    c->texels = texels;
    c->uvs = (const int16_t(*)[2])uvs;
}

static void random_lights(struct scene_case *c, unsigned effects)
{
    c->light_count = effects & SEVERAL_LIGHTS ? (unsigned)random_between(2, SCENE_MAX_LIGHTS) : 1;
    for (unsigned i = 0; i < c->light_count; i++) {
        struct scene_light *light = &c->light[i];
        double towards[3];
        random_direction(towards, 3);
        light->kind = effects & POINT_LIGHT && (i == 0 || random_fraction() < .5) ? LIGHT_POINT : LIGHT_DIRECTIONAL;
        /* not so near that it shines through a rounding of the place */
        const double distance = light->kind == LIGHT_POINT ? random_real(1.2, 3) * CASE_UNIT : 1 << 30;
        for (int k = 0; k < 3; k++) {
            light->colour[k] = (uint16_t)(32768 / c->light_count);
            light->vector[k] = (int32_t)lrint((k == 2 ? fabs(towards[k]) : towards[k]) * distance);
        }
        if (light->kind == LIGHT_POINT)
            light->vector[2] += c->object[0].position[2];
    }
}

static void random_fog(struct scene_fog *fog, unsigned effects, double distance)
{
    if (!(effects & FOG))
        return;
    for (int k = 0; k < 3; k++)
        fog->colour[k] = (uint16_t)random_between(0, 32768);
    fog->kind = effects & EXPONENTIAL ? FOG_EXPONENTIAL : FOG_LINEAR;
    if (effects & EXPONENTIAL) {
        fog->density = (uint32_t)lrint(random_real(.1, 2) / distance * 0x1p24);
        return;
    }
    const double from = fmax(0, distance + random_real(-1.5, .5));
    fog->from = (q16_t)lrint(from * CASE_UNIT);
    fog->to = (q16_t)lrint((from + random_real(.1, 2)) * CASE_UNIT);
}

static struct scene_header *random_scene(unsigned effects)
{
    struct scene_case c;
    scene_case_default(&c, WIDTH, HEIGHT);
    const double distance = effects & CLIPPED ? random_real(.8, 1.2) : random_real(1.6, 2.5);
    c.head.camera.kind = effects & PERSPECTIVE ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC;
    c.head.camera.viewer = effects & LOCAL_VIEWER ? VIEWER_LOCAL : VIEWER_INFINITE;
    c.head.camera.focal = (effects & PERSPECTIVE ? WIDTH : 24) * CASE_UNIT;
    c.head.camera.near_plane = CASE_UNIT;
    c.head.camera.far_plane = 8 * CASE_UNIT;
    c.object[0].position[2] = (q16_t)(-distance * CASE_UNIT);
    c.material[0].ka = 3000;
    c.material[0].kd = (uint16_t)random_between(10000, 32768);
    c.material[0].ks = effects & SPECULAR ? (uint16_t)random_between(10000, 32768) : 0;
    c.material[0].shininess = (uint16_t)random_between(1, 30);
    c.material[0].flags = effects & BACK ? MATERIAL_TWO_SIDED : 0;
    for (int k = 0; k < 3; k++)
        c.material[0].diffuse[k] = (uint16_t)random_between(8000, 32768);
    random_net(&c, (effects & BACK) != 0);
    if (effects & TEXTURE)
        random_texture(&c);
    random_lights(&c, effects);
    random_fog(&c.head.fog, effects, distance);
    return scene_case_blob(&c);
}

/* Each pair of effects comes up in a quarter of all sets. */
static unsigned random_effects(void)
{
    unsigned effects = (unsigned)random_between(0, (1 << EFFECTS) - 1);
    if (effects & CLIPPED && !(effects & PERSPECTIVE))
        effects ^= CLIPPED;
    return effects;
}

/* The largest difference from the truth, 1/255. */
static double difference(const struct scene_header *scene, struct frame_case f, const struct reference_image *truth)
{
    double most = 0;
    uint8_t *picture = frame_case_picture(f, scene, 0, NULL);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        for (int c = 0; truth->covered[i] && c < 3; c++)
            most = fmax(most, fabs(picture[3 * i + c] - truth->value[3 * i + c] * 255));
    free(picture);
    return most;
}

static void open_truth(const struct scene_header *scene, struct reference_image *truth)
{
    const struct reference_options options = {.width = WIDTH, .height = HEIGHT, .method = REFERENCE_PHONG};
    assert_true(reference_render(scene, &options, truth));
}

/* Half a step is the output's, the rest roundings of corners and, of fog, of depths. */
#define MOST 1

static void effects_together_are_the_truth(void **state)
{
    double worst = 0, of_fog = 0;
    (void)state;
    random_seed(1);
    for (int i = 0; i < 400; i++) {
        const unsigned effects = random_effects();
        struct scene_header *scene = random_scene(effects);
        struct reference_image truth;
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_RGB888);
        f.config.method = &glint_phong_perspective;
        open_truth(scene, &truth);
        const double most = difference(scene, f, &truth);
        if (most > MOST)
            fail_msg("scene %d, effects %x: off by %.2f", i, effects, most);
        worst = fmax(worst, most);
        of_fog = fmax(of_fog, effects & FOG ? most : 0);
        reference_free(&truth);
        free(scene);
    }
    print_message("off by at most %.2f of 1/255, %.2f with fog\n", worst, of_fog);
    assert_true(worst > .5);
}

/* The fog has its part of the budget. */
static void auto_keeps_its_budget(void **state)
{
    static const uint16_t budgets[] = {128, 256, 512, 1024, 2048, 4096, 8192};
    double tightest = 0;
    (void)state;
    random_seed(3);
    for (int i = 0; i < 400; i++) {
        const unsigned effects = random_effects() | FOG;
        struct scene_header *scene = random_scene(effects);
        struct reference_image truth;
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_RGB888);
        f.config.method = &glint_auto;
        f.config.budget = budgets[i % 7];
        open_truth(scene, &truth);
        const double most = difference(scene, f, &truth), allowed = f.config.budget / 256. + 1.5;
        if (most > allowed)
            fail_msg("scene %d, effects %x: off by %.2f with a budget of %.2f", i, effects, most,
                     f.config.budget / 256.);
        tightest = fmax(tightest, most / allowed);
        reference_free(&truth);
        free(scene);
    }
    print_message("up to %.2f of what is allowed\n", tightest);
}

static void neither_bands_nor_the_plan_change_a_pixel(void **state)
{
    (void)state;
    random_seed(2);
    for (int i = 0; i < 600; i++) {
        struct scene_header *scene = random_scene(random_effects());
        const struct glint_choice *choice = &glint_choices[(unsigned)i % glint_choice_count];
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, (enum glint_format)random_between(0, GLINT_FORMATS - 1));
        f.config.method = choice->method;
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(effects_together_are_the_truth),
        cmocka_unit_test(auto_keeps_its_budget),
        cmocka_unit_test(neither_bands_nor_the_plan_change_a_pixel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
