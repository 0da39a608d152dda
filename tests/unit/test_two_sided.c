/* SPDX-License-Identifier: MIT */
/* Backs of two-sided faces: a net seen from behind is, to the bit, the net built to face that way. */
#include "glint.h"
#include "random.h"
#include "shade/shade.h"

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

struct net {
    struct scene_vertex vertex[SIDE * SIDE];
    struct scene_triangle triangle[COUNT];
};

/* A net across the view, about two units wide, moved at random. */
static void random_net(struct net *net)
{
    unsigned count = 0;
    memset(net, 0, sizeof *net);
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct scene_vertex *v = &net->vertex[i];
        double off[3];
        random_direction(off, 3);
        const double at[3] = {(i % SIDE - 1) * .8 + random_real(-.15, .15),
                              (1 - i / SIDE) * .8 + random_real(-.15, .15), random_real(-.4, .4)};
        for (int k = 0; k < 3; k++)
            v->position[k] = (int16_t)lrint(at[k] * 32767);
        scene_case_normal(v->normal, .8 * off[0], .8 * off[1], .8 * off[2] + 1);
    }
    for (int row = 0; row < SIDE - 1; row++)
        for (int column = 0; column < SIDE - 1; column++) {
            const int a = row * SIDE + column, corner[2][3] = {{a, a + SIDE, a + SIDE + 1}, {a, a + SIDE + 1, a + 1}};
            for (int t = 0; t < 2; t++, count++) {
                for (int k = 0; k < 3; k++)
                    net->triangle[count].corner[k] = (uint16_t)corner[t][(k + column) % 3];
                scene_case_bend(&net->triangle[count], net->vertex);
                net->triangle[count].flags = (uint16_t)random_between(0, 7);
            }
        }
}

/* The same net built to face the other way: normals and turns are the opposite. */
static void turn_round(const struct net *net, struct net *out)
{
    *out = *net;
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int k = 0; k < 3; k++)
            out->vertex[i].normal[k] = (q14_t)-net->vertex[i].normal[k];
    for (int t = 0; t < COUNT; t++) {
        struct scene_triangle *to = &out->triangle[t];
        const struct scene_triangle *from = &net->triangle[t];
        to->corner[1] = from->corner[2];
        to->corner[2] = from->corner[1];
        scene_case_bend(to, out->vertex);
        to->flags = 0;
        for (int e = 0; e < 3; e++)
            to->flags |= (uint16_t)((from->flags >> e & 1) << (2 - e));
    }
}

static void use_net(struct scene_case *c, const struct net *net)
{
    c->mesh[0].vertices = net->vertex;
    c->mesh[0].triangles = net->triangle;
    c->mesh[0].vertex_count = SIDE * SIDE;
    c->mesh[0].triangle_count = COUNT;
}

static void random_scene(struct scene_case *c, int near)
{
    scene_case_default(c, WIDTH, HEIGHT);
    c->head.camera.kind = near || random_fraction() < .7 ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC;
    c->head.camera.viewer = random_fraction() < .3 ? VIEWER_LOCAL : VIEWER_INFINITE;
    if (c->head.camera.kind == CAMERA_ORTHOGRAPHIC)
        c->head.camera.focal = 24 * CASE_UNIT;
    c->head.camera.near_plane = CASE_UNIT;
    c->material[0].ka = 3000;
    c->material[0].kd = 20000;
    c->material[0].ks = 16000;
    c->material[0].shininess = (uint16_t)random_between(1, 40);
    /* near: the near plane cuts through the net */
    c->object[0].position[2] = (q16_t)(-(near ? random_real(.8, 1.2) : random_real(1.6, 3)) * CASE_UNIT);
    c->light_count = (unsigned)random_between(1, 3);
    for (unsigned i = 0; i < c->light_count; i++) {
        struct scene_light *light = &c->light[i];
        double towards[3];
        random_direction(towards, 3);
        light->kind = random_fraction() < .3 ? LIGHT_POINT : LIGHT_DIRECTIONAL;
        for (int k = 0; k < 3; k++) {
            light->colour[k] = (uint16_t)(32768 / c->light_count);
            light->vector[k] = (int32_t)lrint(towards[k] * (light->kind == LIGHT_POINT ? 2 * CASE_UNIT : 1 << 30));
        }
    }
}

/* The net seen from behind, two-sided or not, and built to be seen from there. */
struct pair {
    struct net net, built;
    struct scene_header *behind, *before;
};

static void open_pair(struct pair *p, int near)
{
    struct scene_case c;
    random_scene(&c, near);
    random_net(&p->built);
    turn_round(&p->built, &p->net);
    use_net(&c, &p->built);
    c.material[0].flags = near ? MATERIAL_TWO_SIDED : 0; /* so near, some may face away */
    p->before = scene_case_blob(&c);
    use_net(&c, &p->net);
    c.material[0].flags = MATERIAL_TWO_SIDED;
    p->behind = scene_case_blob(&c);
}

static void close_pair(struct pair *p)
{
    free(p->behind);
    free(p->before);
}

/* Returns how many triangles were cut. */
static uint32_t check_same(const struct frame_case *f, const struct pair *p, int scene, const char *name)
{
    struct glint_stats behind, before;
    uint8_t *picture = frame_case_picture(*f, p->behind, 0, &behind);
    uint8_t *wanted = frame_case_picture(*f, p->before, 0, &before);
    assert_true(before.triangles == COUNT && before.culled < COUNT);
    if (behind.culled != before.culled || behind.clipped != before.clipped || behind.rejected != before.rejected)
        fail_msg("scene %d: %s: other triangles are seen", scene, name);
    if (memcmp(picture, wanted, glint_row_bytes(&f->config) * HEIGHT) != 0)
        fail_msg("scene %d: %s draws the back in another way", scene, name);
    free(picture);
    free(wanted);
    return behind.turned ? behind.clipped : 0;
}

/* Returns how many backs were cut. */
static uint32_t check_all(int near, int scenes)
{
    uint32_t cut = 0;
    for (int i = 0; i < scenes; i++) {
        struct pair p;
        open_pair(&p, near);
        for (unsigned m = 0; m < glint_choice_count; m++) {
            struct frame_case f =
                frame_case_small(WIDTH, HEIGHT, (enum glint_format)random_between(0, GLINT_FORMATS - 1));
            f.config.method = glint_choices[m].method;
            f.config.band_rows = (uint16_t)random_between(1, HEIGHT);
            f.config.tables = (uint8_t)random_between(0, 1);
            f.config.flags = (uint8_t)(random_between(0, 1) ? GLINT_DITHER : 0);
            cut += check_same(&f, &p, i, glint_choices[m].name);
        }
        close_pair(&p);
    }
    return cut;
}

static void a_back_is_the_face_built_that_way(void **state)
{
    (void)state;
    random_seed(1);
    check_all(0, 40);
}

static void so_are_the_pieces_of_one_that_is_cut(void **state)
{
    (void)state;
    random_seed(2);
    assert_true(check_all(1, 40) > 1000);
}

static void one_sided_backs_are_culled(void **state)
{
    struct pair p;
    struct glint_stats stats;
    (void)state;
    random_seed(3);
    open_pair(&p, 0);
    ((struct scene_material *)(uintptr_t)scene_materials(p.behind))->flags = 0;
    p.behind->effects &= ~USES_TWO_SIDED;
    free(frame_case_picture(frame_case_small(WIDTH, HEIGHT, GLINT_GREY8), p.behind, 0, &stats));
    assert_int_equal(stats.culled, COUNT);
    close_pair(&p);
}

/* Gouraud keeps a vertex's colour for one side: a fold shows both sides of the same vertices. */
static void both_sides_of_a_vertex_have_their_own_colour(void **state)
{
    struct net net;
    struct scene_case c;
    (void)state;
    random_seed(4);
    for (int i = 0; i < 20; i++) {
        random_scene(&c, 0);
        random_net(&net);
        net.vertex[0].position[0] = net.vertex[3].position[0] = net.vertex[6].position[0] = 20000; /* folded over */
        c.material[0].flags = MATERIAL_TWO_SIDED;
        use_net(&c, &net);
        struct scene_header *scene = scene_case_blob(&c);
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_RGB888);
        f.config.method = &glint_gouraud;
        struct glint_stats stats;
        uint8_t *whole = frame_case_picture(f, scene, 0, &stats);
        f.config.band_rows = 5;
        uint8_t *bands = frame_case_picture(f, scene, 0, NULL);
        assert_int_equal(stats.culled, 0);
        assert_memory_equal(whole, bands, WIDTH * HEIGHT * 3);
        free(whole);
        free(bands);
        free(scene);
    }
}

/* Memory holds anything before. */
static void a_back_is_of_its_faces_material(void **state)
{
    static const struct scene_vertex vertex[3];
    static const struct surface surface;
    static const struct scene_mesh mesh;
    static struct object_state object;
    static int16_t lights[3][SHADE_VERTEX_WORDS];
    const struct scene_triangle face = {.corner = {0, 1, 2}, .material = 7};
    struct shade_input in = {.triangle = &face,
                             .vertices = vertex,
                             .lights = {lights[0], lights[1], lights[2]},
                             .object = &object,
                             .surface = &surface};
    struct shade_turned turned;
    (void)state;
    object.mesh = &mesh;
    memset(&turned, 0xff, sizeof turned);
    shade_turn(&turned, &in, COLOUR_WORDS);
    assert_int_equal(in.triangle->material, 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_back_is_the_face_built_that_way),
        cmocka_unit_test(so_are_the_pieces_of_one_that_is_cut),
        cmocka_unit_test(one_sided_backs_are_culled),
        cmocka_unit_test(both_sides_of_a_vertex_have_their_own_colour),
        cmocka_unit_test(a_back_is_of_its_faces_material),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
