/* SPDX-License-Identifier: MIT */
/* The truth against closed forms, on scenes small enough to compute by hand. */
#include "reference/reference.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W = 64, H = 48, MAX_VERTICES = 2200, MAX_TRIANGLES = 4200 };

/* A scene as it lies in memory: one mesh, one object, one light. */
struct scene {
    struct scene_header header;
    struct scene_mesh mesh;
    struct scene_material material;
    struct scene_light light;
    struct scene_object object;
    struct scene_key keys[2];
    struct scene_vertex vertices[MAX_VERTICES];
    struct scene_triangle triangles[MAX_TRIANGLES];
};

static struct scene scene;

static q30_t q30(double x)
{
    return (q30_t)lrint(ldexp(x, 30));
}
static q16_t q16(double x)
{
    return (q16_t)lrint(ldexp(x, 16));
}
static uint16_t q15(double x)
{
    return (uint16_t)lrint(ldexp(x, 15));
}

/* Orthographic, a pixel a unit, white light from the viewer's side at (.6, 0, .8); the mesh spans +-32768 / 512 units,
 * so that a position unit is 1/512. ka .25, kd .5, ks .25 and exponent 8 are exact. */
static void scene_start(void)
{
    static const struct scene_object object = {.rotation = {1 << 30}, .scale = 1 << 16};
    memset(&scene, 0, sizeof scene);
    struct scene_header *h = &scene.header;
    h->meshes = offsetof(struct scene, mesh);
    h->materials = offsetof(struct scene, material);
    h->lights = offsetof(struct scene, light);
    h->objects = offsetof(struct scene, object);
    h->keys = offsetof(struct scene, keys);
    h->mesh_count = h->material_count = h->light_count = h->object_count = 1;
    h->camera = (struct scene_camera){.kind = CAMERA_ORTHOGRAPHIC,
                                      .rotation = {1 << 30},
                                      .focal = 1 << 16,
                                      .reference_width = W,
                                      .reference_height = H,
                                      .near_plane = 1 << 16,
                                      .far_plane = 100 << 16};
    scene.mesh.vertices = offsetof(struct scene, vertices);
    scene.mesh.triangles = offsetof(struct scene, triangles);
    scene.mesh.extent = 64 << 16;
    scene.material = (struct scene_material){.ka = q15(.25),
                                             .kd = q15(.5),
                                             .ks = q15(.25),
                                             .shininess = 8,
                                             .texture = SCENE_NO_TEXTURE,
                                             .bump = SCENE_NO_TEXTURE};
    scene.light.kind = LIGHT_DIRECTIONAL;
    scene.object = object;
    for (int i = 0; i < 3; i++) {
        h->ambient[i] = scene.material.diffuse[i] = scene.material.specular[i] = scene.light.colour[i] = 1 << 15;
        scene.light.vector[i] = q30((double[]){.6, 0, .8}[i]);
    }
}

static unsigned scene_vertex(double x, double y, double z, double nx, double ny, double nz)
{
    struct scene_vertex *v = scene.vertices + scene.mesh.vertex_count;
    for (int i = 0; i < 3; i++) {
        v->position[i] = (int16_t)lrint(512 * (double[]){x, y, z}[i]);
        v->normal[i] = (q14_t)lrint(ldexp((double[]){nx, ny, nz}[i], 14));
    }
    return scene.mesh.vertex_count++;
}

static void scene_triangle(unsigned a, unsigned b, unsigned c)
{
    struct scene_triangle *t = scene.triangles + scene.mesh.triangle_count++;
    const unsigned corner[3] = {a, b, c};
    for (int e = 0; e < 3; e++) {
        const q14_t *n = scene.vertices[corner[e]].normal, *m = scene.vertices[corner[(e + 1) % 3]].normal;
        double dot = ldexp((double)n[0] * m[0] + (double)n[1] * m[1] + (double)n[2] * m[2], -28);
        t->corner[e] = (uint16_t)corner[e];
        t->bend[e] = (uint16_t)lrint(fmax(0, ldexp((1 - dot) / 2, 16)));
    }
}

/* Corners counter-clockwise. */
static void scene_quad(const double corner[4][3], double nx, double ny, double nz)
{
    unsigned first = 0;
    for (int i = 0; i < 4; i++) {
        unsigned v = scene_vertex(corner[i][0], corner[i][1], corner[i][2], nx, ny, nz);
        first = i ? first : v;
    }
    scene_triangle(first, first + 1, first + 2);
    scene_triangle(first, first + 2, first + 3);
}

static struct reference_image draw(enum reference_method method, uint32_t time_ms)
{
    const struct reference_options options = {.method = method, .grey = true, .time_ms = time_ms};
    struct reference_image image;
    assert_true(reference_render(&scene.header, &options, &image));
    assert_int_equal(image.channels, 1);
    return image;
}

static double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void unit3(double v[3])
{
    double length = sqrt(dot3(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

/* The formula of scene.h, for the material and light of scene_start(). */
static double shade(const double normal[3], const double to_light[3], const double to_viewer[3])
{
    double half[3] = {to_light[0] + to_viewer[0], to_light[1] + to_viewer[1], to_light[2] + to_viewer[2]};
    unit3(half);
    return fmin(1, .25 + .5 * fmax(0, dot3(normal, to_light)) + .25 * pow(fmax(0, dot3(normal, half)), 8));
}

static const double infinitely_far[3] = {0, 0, 1};

static void assert_close(double a, double b, double limit)
{
    if (!(fabs(a - b) <= limit))
        fail_msg("%.12f is not %.12f", a, b);
}

static void a_plane_has_one_colour(void **state)
{
    static const double corner[4][3] = {{-10, -10, -20}, {10, -10, -20}, {10, 10, -20}, {-10, 10, -20}};
    static const double normal[3] = {0, 0, 1}, light[3] = {.6, 0, .8};
    (void)state;
    for (int method = 0; method < REFERENCE_METHODS; method++) {
        scene_start();
        scene_quad(corner, 0, 0, 1);
        struct reference_image image = draw((enum reference_method)method, 0);
        assert_int_equal(image.coverage, 20 * 20);
        assert_close(image.value[24 * W + 32], shade(normal, light, infinitely_far), 1e-8);
        assert_close(image.value[14 * W + 22], shade(normal, light, infinitely_far), 1e-8);
        reference_free(&image);
    }
}

/* Corners on pixel centres: left and top are inside, right and bottom are not, and no pixel of the diagonal is lost. */
static void left_and_top_edges_are_inclusive(void **state)
{
    static const double corner[4][3] = {{-9.5, -9.5, -20}, {6.5, -9.5, -20}, {6.5, 6.5, -20}, {-9.5, 6.5, -20}};
    (void)state;
    scene_start();
    scene_quad(corner, 0, 0, 1);
    struct reference_image image = draw(REFERENCE_PHONG, 0);
    assert_int_equal(image.coverage, 16 * 16);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++)
            assert_int_equal(image.covered[y * W + x], x >= 22 && x < 38 && y >= 17 && y < 33);
    reference_free(&image);
}

static void back_faces_are_culled(void **state)
{
    static const double corner[4][3] = {{-10, 10, -20}, {10, 10, -20}, {10, -10, -20}, {-10, -10, -20}};
    (void)state;
    scene_start();
    scene_quad(corner, 0, 0, 1);
    struct reference_image image = draw(REFERENCE_PHONG, 0);
    assert_int_equal(image.coverage, 0);
    reference_free(&image);
}

static void the_nearer_surface_shows(void **state)
{
    static const double near[4][3] = {{-10, -10, -5}, {10, -10, -5}, {10, 10, -5}, {-10, 10, -5}};
    static const double far[4][3] = {{-12, -12, -20}, {12, -12, -20}, {12, 12, -20}, {-12, 12, -20}};
    static const double normal[3] = {0, 0, 1}, light[3] = {.6, 0, .8};
    (void)state;
    for (int order = 0; order < 2; order++) {
        scene_start();
        scene_quad(order ? near : far, order ? 0 : -1, 0, order ? 1 : 0);
        scene_quad(order ? far : near, order ? -1 : 0, 0, order ? 0 : 1);
        struct reference_image image = draw(REFERENCE_PHONG, 0);
        assert_int_equal(image.coverage, 24 * 24);
        assert_close(image.value[24 * W + 32], shade(normal, light, infinitely_far), 1e-8);
        assert_close(image.value[24 * W + 21], .25, 1e-8); /* the far one faces away from the light */
        reference_free(&image);
    }
}

/* A point light and a near viewer over a plane y = -2 that recedes from z = -4 to z = -32, or, for the clip, begins
 * behind the eye: every pixel is where its ray meets the plane. Focal length 32 puts the corners on whole 1/16 pixels.
 */
static void check_floor(double z_near, double limit)
{
    const double corner[4][3] = {{-8, -2, z_near}, {8, -2, z_near}, {8, -2, -32}, {-8, -2, -32}};
    static const double normal[3] = {0, 1, 0}, light[3] = {1, 3, -6};
    size_t below = 0;
    scene_start();
    scene_quad(corner, 0, 1, 0);
    scene.header.camera.kind = CAMERA_PERSPECTIVE;
    scene.header.camera.viewer = VIEWER_LOCAL;
    scene.header.camera.focal = 32 << 16;
    scene.light.kind = LIGHT_POINT;
    for (int i = 0; i < 3; i++)
        scene.light.vector[i] = q16(light[i]);
    struct reference_image image = draw(REFERENCE_PHONG, 0);
    for (int y = 0; y < H; y++) {
        for (int x = 0; x < W; x++) {
            double ray[3] = {(x + .5 - W / 2) / 32, -(y + .5 - H / 2) / 32, -1}, t = -2 / ray[1];
            double point[3] = {t * ray[0], t * ray[1], t * ray[2]};
            if (!image.covered[y * W + x])
                continue;
            double to_light[3] = {light[0] - point[0], light[1] - point[1], light[2] - point[2]};
            double to_viewer[3] = {-point[0], -point[1], -point[2]};
            unit3(to_light);
            unit3(to_viewer);
            assert_close(image.value[y * W + x], shade(normal, to_light, to_viewer), limit);
            below++;
        }
    }
    assert_int_equal(below, image.coverage);
    /* rows 26 to 47 lie between z = -32 and the picture's lower edge at z = -2.7, 16 units wide: 512 / distance pixels
     */
    assert_true(below > (z_near > 0 ? 1100 : 600) && below < W * H / 2);
    reference_free(&image);
}

static void a_plane_in_perspective_is_lit_where_its_pixels_are(void **state)
{
    (void)state;
    check_floor(-4, 1e-9);
}

static void clipping_at_the_near_plane_changes_no_pixel(void **state)
{
    (void)state;
    check_floor(4, 1e-4); /* the cut through the diagonal is snapped to 1/16 pixel */
}

/* How much a cut through a bent triangle, from z = -4 to -32, changes the pixels behind it. */
static double cut(enum reference_method method)
{
    double largest = 0;
    struct reference_image image[2];
    for (int i = 0; i < 2; i++) {
        scene_start();
        scene_triangle(scene_vertex(-4, -2, -4, -.6, .8, 0), scene_vertex(4, -2, -4, .6, .8, 0),
                       scene_vertex(0, 8, -32, 0, .6, .8));
        scene.header.camera.kind = CAMERA_PERSPECTIVE;
        scene.header.camera.focal = 32 << 16;
        scene.header.camera.near_plane = i ? 10 << 16 : 1 << 16;
        image[i] = draw(method, 0);
    }
    assert_true(image[1].coverage > 50 && image[1].coverage < image[0].coverage);
    for (int i = 0; i < W * H; i++)
        if (image[1].covered[i])
            largest = fmax(largest, fabs(image[0].value[i] - image[1].value[i]));
    reference_free(&image[0]);
    reference_free(&image[1]);
    return largest;
}

/* But for the cut's snapping to 1/16 pixel. In the picture a part is a triangle of its own. */
static void methods_in_space_do_not_see_the_near_plane(void **state)
{
    (void)state;
    assert_true(cut(REFERENCE_PHONG) < 5e-4);
    assert_true(cut(REFERENCE_X_PERSPECTIVE) < 5e-4);
    assert_true(cut(REFERENCE_BIQUADRATIC_PERSPECTIVE) < 5e-4);
    assert_true(cut(REFERENCE_X) > 2 / 255.);
}

static void beyond_the_far_plane_nothing_shows(void **state)
{
    static const double corner[4][3] = {{-10, -10, -20}, {10, -10, -20}, {10, 10, -20}, {-10, 10, -20}};
    (void)state;
    scene_start();
    scene_quad(corner, 0, 0, 1);
    scene.header.camera.far_plane = 19 << 16;
    struct reference_image image = draw(REFERENCE_PHONG, 0);
    assert_int_equal(image.coverage, 0);
    reference_free(&image);
}

/* Normals interpolated over a fine sphere are those of the sphere. */
static void a_fine_sphere_is_shaded_like_a_sphere(void **state)
{
    enum { SLICES = 64, STACKS = 32 };
    static const double light[3] = {.6, 0, .8};
    const double pi = acos(-1), r = 20;
    double largest = 0;
    (void)state;
    scene_start();
    for (int j = 0; j <= STACKS; j++) {
        for (int i = 0; i <= SLICES; i++) {
            double a = 2 * pi * i / SLICES, b = pi * j / STACKS - pi / 2;
            double n[3] = {cos(b) * sin(a), sin(b), cos(b) * cos(a)};
            unsigned v = scene_vertex(r * n[0], r * n[1], r * n[2] - 30, n[0], n[1], n[2]);
            if (i < SLICES && j < STACKS) {
                scene_triangle(v, v + 1, v + SLICES + 2);
                scene_triangle(v, v + SLICES + 2, v + SLICES + 1);
            }
        }
    }
    struct reference_image image = draw(REFERENCE_PHONG, 0);
    for (int y = 0; y < H; y++) {
        for (int x = 0; x < W; x++) {
            double n[3] = {(x + .5 - W / 2) / r, -(y + .5 - H / 2) / r, 0};
            double z2 = 1 - dot3(n, n);
            if (z2 < .04)
                continue;
            n[2] = sqrt(z2);
            assert_int_equal(image.covered[y * W + x], 1);
            largest = fmax(largest, fabs(image.value[y * W + x] - shade(n, light, infinitely_far)));
        }
    }
    assert_true(largest < 1.5 / 255);
    assert_true(largest > 0);
    reference_free(&image);
}

/* One triangle whose lower edge runs through pixel centres, normals 40 degrees apart. */
static struct reference_image draw_bent(enum reference_method method)
{
    scene_start();
    scene_triangle(scene_vertex(-8.5, 8.5, -20, -.6, 0, .8), scene_vertex(-8.5, -7.5, -20, 0, 0, 1),
                   scene_vertex(7.5, 8.5, -20, 0, .28, .96));
    return draw(method, 0);
}

/* At the middle of the upper edge, which is inside: what each method makes of the normals of its ends. */
static void methods_agree_with_their_formulas_at_the_middle_of_an_edge(void **state)
{
    static const double light[3] = {.6, 0, .8};
    double a[3], b[3], sum[3], half[3] = {.6, 0, 1.8};
    const size_t middle = (24 - 9) * W + 31; /* (-.5, 8.5) */
    (void)state;
    struct reference_image phong = draw_bent(REFERENCE_PHONG), six = draw_bent(REFERENCE_SIX);
    struct reference_image gouraud = draw_bent(REFERENCE_GOURAUD), x = draw_bent(REFERENCE_X);
    for (int i = 0; i < 3; i++) {
        a[i] = ldexp(scene.vertices[0].normal[i], -14);
        b[i] = ldexp(scene.vertices[2].normal[i], -14);
        sum[i] = a[i] + b[i];
    }
    double bend = ldexp(scene.triangles[0].bend[2], -16), stretch = (2 + bend) / 4; /* (5 - N1.N2) / 8 */
    unit3(half);
    assert_int_equal(phong.covered[middle], 1);
    assert_close(x.value[middle], .25 + .5 * dot3(sum, light) * stretch + .25 * pow(dot3(sum, half) * stretch, 8),
                 1e-8);
    assert_close(gouraud.value[middle], (shade(a, light, infinitely_far) + shade(b, light, infinitely_far)) / 2, 1e-8);
    unit3(sum);
    assert_close(phong.value[middle], shade(sum, light, infinitely_far), 1e-8);
    assert_close(six.value[middle], phong.value[middle], 1e-8);
    assert_true(fabs(gouraud.value[middle] - phong.value[middle]) > 1 / 255.);
    reference_free(&phong);
    reference_free(&six);
    reference_free(&gouraud);
    reference_free(&x);
}

/* Left and right halves of where a 20 x 4 bar is after a quarter turn a second about z, the animation 3 s long. */
static void spin_turns_and_time_wraps_at_the_duration(void **state)
{
    static const double bar[4][3] = {{0, -2, -20}, {20, -2, -20}, {20, 2, -20}, {0, 2, -20}};
    static const struct {
        uint32_t time;
        int x, y;
    } at[] = {{0, 42, 24}, {1000, 32, 14}, {2000, 22, 24}, {3000, 42, 24}, {4000, 32, 14}};
    (void)state;
    scene_start();
    scene_quad(bar, 0, 0, 1);
    scene.header.duration_ms = 3000;
    scene.object.motion = (struct scene_motion){.kind = MOTION_SPIN, .axis = {0, 0, 1 << 30}, .rate = 1 << 14};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        struct reference_image image = draw(REFERENCE_PHONG, at[i].time);
        for (size_t j = 0; j < sizeof at / sizeof *at; j++)
            assert_int_equal(image.covered[at[j].y * W + at[j].x], at[j].x == at[i].x && at[j].y == at[i].y);
        reference_free(&image);
    }
}

/* From the origin at 1 s to 8 right, twice as large and a quarter turned at 3 s. */
static void keys_are_held_outside_and_mixed_between(void **state)
{
    static const double square[4][3] = {{-4, -4, -20}, {4, -4, -20}, {4, 4, -20}, {-4, 4, -20}};
    static const struct {
        uint32_t time;
        double side, x;
    } at[] = {{0, 8, 0}, {1000, 8, 0}, {2000, 12, 4}, {3000, 16, 8}, {9000, 16, 8}};
    (void)state;
    scene_start();
    scene_quad(square, 0, 0, 1);
    scene.object.motion = (struct scene_motion){.kind = MOTION_KEYS, .key_count = 2};
    scene.keys[0] = (struct scene_key){.time_ms = 1000, .rotation = {1 << 30}, .scale = 1 << 16};
    scene.keys[1] = (struct scene_key){.time_ms = 3000,
                                       .rotation = {-q30(sqrt(.5)), 0, 0, -q30(sqrt(.5))}, /* the longer way */
                                       .position = {8 << 16},
                                       .scale = 2 << 16};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        struct reference_image image = draw(REFERENCE_PHONG, at[i].time);
        double sum = 0;
        for (size_t p = 0; p < W * H; p++)
            sum += image.covered[p] * ((double)(p % W) + .5 - W / 2);
        assert_close((double)image.coverage, at[i].side * at[i].side, 8);
        assert_close(sum / (double)image.coverage, at[i].x, .05);
        reference_free(&image);
    }
}

static void a_spinning_light_goes_round_the_world(void **state)
{
    static const double corner[4][3] = {{-10, -10, -20}, {10, -10, -20}, {10, 10, -20}, {-10, 10, -20}};
    static const double normal[3] = {0, 0, 1}, moved[3] = {.8, 0, -.6};
    (void)state;
    scene_start();
    scene_quad(corner, 0, 0, 1);
    scene.light.motion = (struct scene_motion){.kind = MOTION_SPIN, .axis = {0, 1 << 30, 0}, .rate = 1 << 16};
    struct reference_image image = draw(REFERENCE_PHONG, 250);
    assert_close(image.value[24 * W + 32], shade(normal, moved, infinitely_far), 1e-8);
    reference_free(&image);
}

static void grey_is_the_luma_of_the_colours(void **state)
{
    static const double corner[4][3] = {{-10, -10, -20}, {10, -10, -20}, {10, 10, -20}, {-10, 10, -20}};
    struct reference_options options = {.width = 2 * W, .height = 2 * H};
    struct reference_image colour, grey;
    (void)state;
    scene_start();
    scene_quad(corner, 0, 0, 1);
    scene.material.ks = 0;
    for (int i = 0; i < 3; i++) {
        scene.material.diffuse[i] = q15((double[]){1, .5, .25}[i]);
        scene.header.background[i] = q15((double[]){.25, .5, 1}[i]);
    }
    assert_true(reference_render(&scene.header, &options, &colour));
    options.grey = true;
    assert_true(reference_render(&scene.header, &options, &grey));
    assert_int_equal(colour.coverage, 40 * 40);
    for (size_t i = 0; i < (size_t)4 * W * H; i++) {
        const double *rgb = colour.value + 3 * i;
        assert_close(grey.value[i], .299 * rgb[0] + .587 * rgb[1] + .114 * rgb[2], 1e-12);
    }
    reference_free(&colour);
    reference_free(&grey);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_has_one_colour),
        cmocka_unit_test(left_and_top_edges_are_inclusive),
        cmocka_unit_test(back_faces_are_culled),
        cmocka_unit_test(the_nearer_surface_shows),
        cmocka_unit_test(a_plane_in_perspective_is_lit_where_its_pixels_are),
        cmocka_unit_test(clipping_at_the_near_plane_changes_no_pixel),
        cmocka_unit_test(methods_in_space_do_not_see_the_near_plane),
        cmocka_unit_test(beyond_the_far_plane_nothing_shows),
        cmocka_unit_test(a_fine_sphere_is_shaded_like_a_sphere),
        cmocka_unit_test(methods_agree_with_their_formulas_at_the_middle_of_an_edge),
        cmocka_unit_test(spin_turns_and_time_wraps_at_the_duration),
        cmocka_unit_test(keys_are_held_outside_and_mixed_between),
        cmocka_unit_test(a_spinning_light_goes_round_the_world),
        cmocka_unit_test(grey_is_the_luma_of_the_colours),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
