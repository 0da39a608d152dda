/* SPDX-License-Identifier: MIT */
/* Whole frames, through the public interface, against finished pixels by definition (exact_pixel.h), depth included. */
#include "exact_pixel.h"
#include "tests/unit/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/unit/frame_case.h"
#include "tests/unit/scene_case.h"

#define SIDE   40
#define CROWD  6 /* triangles of a picture of several */
#define ORDERS 6

static const uint16_t order_of[ORDERS][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
static const char *const format_name[] = {"rgb565", "rgb888", "grey8", "grey4"};

static struct scene_case scene;
static struct scene_vertex vertex[3 * CROWD];
static struct scene_triangle triangle[CROWD];
static long drawn, pixels, slivers, plain;

/* A picture under which a position unit is a sub-pixel, and its blob, whose parts are changed in place from here on. */
static struct scene_header *begin(unsigned width, unsigned height, unsigned lights)
{
    scene_case_default(&scene, (uint16_t)width, (uint16_t)height);
    scene.head.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.head.camera.focal = CASE_UNIT;
    scene.mesh[0].head.extent = 2048 * CASE_UNIT;
    scene.mesh[0].head.radius = 8192 * CASE_UNIT;
    scene.head.camera.far_plane = 20000 * CASE_UNIT;
    scene.object[0].position[2] = -9000 * CASE_UNIT;
    scene.light_count = lights;
    for (unsigned i = 0; i < lights; i++) {
        double v[3];
        random_direction(v, 3);
        for (int c = 0; c < 3; c++) {
            scene.light[i].vector[c] = (int32_t)lrint((c == 2 ? fabs(v[c]) : v[c]) * (1 << 30));
            scene.light[i].colour[c] = (uint16_t)random_between(8192, 32768);
        }
    }
    struct scene_material *m = &scene.material[0];
    static const uint16_t exponents[] = {1, 2, 5, 20, 50, 200, 1023};
    m->shininess = exponents[random_bits() % 7];
    m->kd = (uint16_t)random_between(0, 32768);
    m->ks = (uint16_t)(random_bits() % 3 ? random_between(0, 32768) : 0);
    m->ka = (uint16_t)random_between(0, 8000);
    m->flags = MATERIAL_TWO_SIDED;
    scene.mesh[0].vertices = vertex;
    scene.mesh[0].triangles = triangle;
    scene.mesh[0].vertex_count = 3 * CROWD;
    scene.mesh[0].triangle_count = CROWD;
    for (unsigned i = 0; i < 3 * CROWD; i++) {
        triangle[i / 3].corner[i % 3] = (uint16_t)i;
        scene_case_normal(vertex[i].normal, 0, 0, 1);
    }
    return scene_case_blob(&scene);
}

static int32_t random_place(unsigned size)
{
    static const int32_t special[] = {GUARD - 1, 1 - GUARD, GUARD - 2, 2 - GUARD, 0, 1, -1};
    const int32_t reach = size < 2000 ? 8 * (int32_t)size + 100 : GUARD - 15; /* nothing is to be clipped */
    switch (random_bits() % 8) {
    case 0:
        return special[random_bits() % 7];
    case 1:
        return random_between(1 - GUARD, GUARD - 1);
    case 2:
    case 3:
        return random_between(-reach / 8, reach / 8) * 8;
    default:
        return random_between(-reach, reach);
    }
}

/* On a line through the picture, far away on either side of it, but for a few sub-pixels. */
static void make_sliver(struct scene_vertex v[3], unsigned width, unsigned height)
{
    const double angle = random_real(0, 2 * 3.14159265358979);
    const int about = 1 << random_bits() % 5, x = random_between(-4 * (int)width, 4 * (int)width),
              y = random_between(-4 * (int)height, 4 * (int)height),
              least = GUARD - 200 - (abs(x) > abs(y) ? abs(x) : abs(y));
    for (int k = 0; k < 3; k++) {
        const double far = k == 2 ? random_real(-99, 99) : (k ? 1 : -1) * random_magnitude(100, least);
        v[k].position[0] = (int16_t)(x + lrint(far * cos(angle)) + random_between(-about, about));
        v[k].position[1] = (int16_t)(y + lrint(far * sin(angle)) + random_between(-about, about));
    }
}

/* Corners anywhere that is not clipped, every fourth time a sliver, every fourth as near everywhere; normals as far
 * apart as they may be, or close. */
static void random_corners(struct scene_vertex v[3], unsigned width, unsigned height)
{
    double n[3], spread = random_magnitude(.01, 3);
    const int level = random_bits() % 4 == 0;
    random_direction(n, 3);
    for (int k = 0; k < 3; k++) {
        double d[3];
        random_direction(d, 3);
        v[k].position[0] = (int16_t)random_place(width);
        v[k].position[1] = (int16_t)random_place(height);
        v[k].position[2] = (int16_t)(level ? 100 : random_between(-32767, 32767));
        scene_case_normal(v[k].normal, n[0] + spread * d[0], n[1] + spread * d[1], fabs(n[2]) + spread * d[2]);
    }
    if (random_bits() % 4 == 0)
        make_sliver(v, width, height);
}

static void *part(struct scene_header *blob, uint32_t offset)
{
    return (uint8_t *)blob + offset;
}

static struct scene_mesh *mesh_of(struct scene_header *blob)
{
    return part(blob, blob->meshes);
}

/* The mesh is one triangle, its corners in this order. */
static void put_one(struct scene_header *blob, const struct scene_vertex from[3], const uint16_t order[3])
{
    struct scene_mesh *mesh = mesh_of(blob);
    struct scene_vertex *v = part(blob, mesh->vertices);
    struct scene_triangle *t = part(blob, mesh->triangles);
    memcpy(v, from, 3 * sizeof *v);
    memcpy(t[0].corner, order, sizeof t[0].corner);
    scene_case_bend(&t[0], v);
    mesh->triangle_count = 1;
}

static void level_of(const struct frame_case *f, int x, int y, uint32_t level[3])
{
    const uint8_t *row = f->picture + (size_t)y * glint_row_bytes(&f->config);
    uint16_t colour;
    level[0] = row[f->config.format == GLINT_RGB888 ? 3 * x : f->config.format == GLINT_GREY4 ? x / 2 : x];
    switch (f->config.format) {
    case GLINT_RGB565:
        memcpy(&colour, row + 2 * x, 2);
        level[0] = colour >> 11;
        level[1] = colour >> 5 & 63;
        level[2] = colour & 31;
        break;
    case GLINT_RGB888:
        level[1] = row[3 * x + 1];
        level[2] = row[3 * x + 2];
        break;
    case GLINT_GREY4:
        level[0] = x & 1 ? level[0] & 15 : level[0] >> 4;
        break;
    default:
        break;
    }
}

/* The set-up of the triangle that was drawn last, made anew. */
static void set_up(const struct frame_case *f, struct shade_setup *setup)
{
    struct shade_input *in = &f->frame.raster->input;
    int32_t depth[3];
    memset(setup, 0, sizeof *setup);
    assert_int_equal(plane_setup(&setup->plane, in->place, f->config.width, f->config.height), 1);
    for (int k = 0; k < 3; k++)
        depth[k] = (uint16_t)in->place[k][VERTEX_DEPTH];
    plane_linear(&setup->plane, depth, &setup->depth);
    f->config.method->setup(setup, in);
}

static void complain(const struct frame_case *f, const struct exact_triangle *t, int x, int y, const uint32_t *got,
                     const struct exact_pixel *pixel, unsigned depth)
{
    fail_msg("method %d, %s, %u tables, flags %u: (%d, %d) (%d, %d) (%d, %d)/16 px in %u x %u: pixel (%d, %d) is "
             "%u %u %u at depth %u, not %u %u %u at %u",
             f->config.method->id, format_name[f->config.format], f->config.tables, f->config.flags, t->p[0].x,
             t->p[0].y, t->p[1].x, t->p[1].y, t->p[2].x, t->p[2].y, t->width, t->height, x, y, got[0], got[1], got[2],
             depth, pixel->level[0], pixel->level[1], pixel->level[2], pixel->depth);
}

/* Every pixel of a frame of one triangle. `corner`: as the mesh has it. */
static void check_picture(const struct frame_case *f, const struct scene_vertex corner[3])
{
    struct exact_triangle t = {.width = f->config.width, .height = f->config.height};
    struct shade_setup setup;
    int ready = 0;
    for (int k = 0; k < 3; k++)
        t.p[k] = (struct cover_point){corner[k].position[0], -corner[k].position[1]};
    if (exact_area(&t) < 0) {
        const struct cover_point other = t.p[1];
        t.p[1] = t.p[2];
        t.p[2] = other;
    }
    const struct raster *r = f->frame.raster;
    for (int y = 0; y < (int)t.height; y++)
        for (int x = 0; x < (int)t.width; x++) {
            uint32_t got[3] = {0, 0, 0};
            struct exact_pixel pixel = {0, {0, 0, 0}};
            const int covered = exact_area(&t) > 0 && exact_covers(&t, x, y);
            if (covered && !ready) {
                assert_int_equal(frame_case_drawn(f), 1);
                set_up(f, &setup);
                slivers += setup.plane.sliver;
                plain += setup.plain;
                ready = 1;
            }
            level_of(f, x, y, got);
            if (covered)
                pixel = exact_pixel(r, &setup, f->config.method->id, x, y);
            const unsigned depth = r->depth[y * r->width + x];
            if (depth != pixel.depth || memcmp(got, pixel.level, sizeof got) != 0)
                complain(f, &t, x, y, got, &pixel, depth);
            pixels += covered;
        }
    drawn += ready;
}

static struct frame_case open(unsigned width, unsigned height, const struct glint_method *method, unsigned format)
{
    struct frame_case f = {.config = {.width = (uint16_t)width,
                                      .height = (uint16_t)height,
                                      .format = (uint8_t)format,
                                      .method = method,
                                      .tables = (uint8_t)(random_bits() & 1),
                                      .flags = (uint8_t)(random_bits() & GLINT_NO_PLAN),
                                      .max_vertices = 3 * CROWD,
                                      .max_triangles = CROWD,
                                      .max_clipped = 8,
                                      .max_objects = 1,
                                      .max_lights = 2}};
    if (format == GLINT_RGB565 || format == GLINT_GREY4)
        f.config.flags |= (uint8_t)(random_bits() & GLINT_DITHER);
    frame_case_open(&f);
    return f;
}

/* Frames of one triangle in all six orders, in one piece and in bands. */
static void check_method(const struct glint_method *method, unsigned format, unsigned most_width, unsigned most_height,
                         int scenes)
{
    drawn = pixels = slivers = plain = 0;
    for (int i = 0; i < scenes; i++) {
        const unsigned width = (unsigned)random_between((int)most_width / SIDE, (int)most_width),
                       height = (unsigned)random_between((int)most_height / SIDE, (int)most_height);
        struct scene_header *blob = begin(width, height, 1 + (random_bits() & 1));
        struct frame_case f = open(width, height, method, format), bands = f;
        bands.config.band_rows = (uint16_t)random_between(1, (int32_t)height);
        bands.config.flags = f.config.flags;
        frame_case_open(&bands);
        for (int n = 0; n < 6; n++) {
            struct scene_vertex corner[3];
            random_corners(corner, width, height);
            for (int order = 0; order < ORDERS; order++) {
                put_one(blob, corner, order_of[order]);
                frame_case_draw(&f, blob, 0);
                check_picture(&f, corner);
                frame_case_draw(&bands, blob, 0);
                assert_memory_equal(bands.picture, f.picture, f.picture_bytes);
            }
        }
        frame_case_close(&bands);
        frame_case_close(&f);
        free(blob);
    }
    print_message("%ld frames, %ld pixels, %ld slivers, %ld without a clamp\n", drawn, pixels, slivers, plain);
    assert_true(drawn > scenes && pixels > 100 * scenes && slivers >= scenes / 10);
}

static void check_formats(const struct glint_method *method, uint32_t seed, unsigned formats)
{
    random_seed(seed);
    for (unsigned format = 0; format < GLINT_FORMATS; format++)
        if (formats >> format & 1)
            check_method(method, format, SIDE, SIDE, 400);
}

static void every_flat_pixel_is_what_its_definition_says(void **state)
{
    (void)state;
    check_formats(&glint_flat, 100, 15);
}

static void every_gouraud_pixel_is_what_its_polynomials_say(void **state)
{
    (void)state;
    check_formats(&glint_gouraud, 200, 15);
}

static void every_pixel_of_x_is_what_its_polynomials_say(void **state)
{
    (void)state;
    check_formats(&glint_x, 300, 15);
}

static void every_pixel_of_six_is_what_its_polynomials_say(void **state)
{
    (void)state;
    check_formats(&glint_six, 400, 15);
}

static void every_pixel_of_duff_is_what_its_polynomials_say(void **state)
{
    (void)state;
    check_formats(&glint_duff, 500, 15);
}

static void every_pixel_of_the_largest_pictures_is_what_its_polynomials_say(void **state)
{
    static const struct glint_method *const methods[] = {&glint_gouraud, &glint_x, &glint_six, &glint_duff};
    static const unsigned sizes[][2] = {{2048, 40}, {40, 2048}, {640, 400}};
    (void)state;
    random_seed(550);
    for (unsigned m = 0; m < 4; m++)
        for (unsigned size = 0; size < 3; size++)
            check_method(methods[m], (m + size) % 2 ? GLINT_GREY8 : GLINT_RGB565, sizes[size][0], sizes[size][1], 4);
}

/* The first row whose centre is not above a triangle's top. */
static int first_row(const struct scene_vertex v[3], unsigned height)
{
    int top = -v[0].position[1];
    for (int k = 1; k < 3; k++)
        top = -v[k].position[1] < top ? -v[k].position[1] : top;
    return (int)exact_between((exact_floor(top + 8 * (int)height + 7, 4)), 0, height);
}

/* Several triangles: each pixel is that of the nearest, of equally near ones that of the first by first row, then by
 * number. */
static void a_picture_of_many_is_the_nearest_of_its_triangles(void **state)
{
    static uint8_t wanted[SIDE * SIDE], alone[CROWD][SIDE * SIDE];
    static uint16_t depth[SIDE * SIDE], alone_depth[CROWD][SIDE * SIDE];
    (void)state;
    long ties = 0, hidden = 0;
    random_seed(600);
    for (int i = 0; i < 1500; i++) {
        const unsigned width = (unsigned)random_between(1, SIDE), height = (unsigned)random_between(1, SIDE);
        struct scene_header *blob = begin(width, height, 1);
        struct frame_case f = open(width, height, i & 1 ? &glint_x : &glint_gouraud, GLINT_GREY8);
        const size_t size = width * height;
        const struct raster *r = f.frame.raster;
        struct scene_vertex corner[CROWD][3];
        memset(wanted, 0, sizeof wanted);
        memset(depth, 0, sizeof depth);
        for (int n = 0; n < CROWD; n++) {
            random_corners(corner[n], width, height);
            put_one(blob, corner[n], order_of[0]);
            frame_case_draw(&f, blob, 0);
            memcpy(alone[n], f.picture, size);
            memcpy(alone_depth[n], r->depth, 2 * size);
        }
        for (unsigned row = 0; row < height; row++)
            for (int n = 0; n < CROWD; n++)
                for (size_t p = 0; p < size && first_row(corner[n], height) == (int)row; p++) {
                    ties += alone_depth[n][p] && alone_depth[n][p] == depth[p];
                    hidden += alone_depth[n][p] && alone_depth[n][p] < depth[p];
                    if (alone_depth[n][p] > depth[p]) {
                        depth[p] = alone_depth[n][p];
                        wanted[p] = alone[n][p];
                    }
                }
        struct scene_mesh *mesh = mesh_of(blob);
        struct scene_triangle *t = part(blob, mesh->triangles);
        memcpy(part(blob, mesh->vertices), corner, sizeof corner);
        for (int n = 0; n < CROWD; n++) {
            memcpy(t[n].corner, triangle[n].corner, sizeof t[n].corner);
            scene_case_bend(&t[n], part(blob, mesh->vertices));
        }
        mesh->triangle_count = CROWD;
        frame_case_draw(&f, blob, 0);
        assert_memory_equal(r->depth, depth, 2 * size);
        assert_memory_equal(f.picture, wanted, size);
        frame_case_close(&f);
        free(blob);
    }
    print_message("%ld pixels behind others, %ld as near\n", hidden, ties);
    assert_true(hidden > 10000 && ties > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_flat_pixel_is_what_its_definition_says),
        cmocka_unit_test(every_gouraud_pixel_is_what_its_polynomials_say),
        cmocka_unit_test(every_pixel_of_x_is_what_its_polynomials_say),
        cmocka_unit_test(every_pixel_of_six_is_what_its_polynomials_say),
        cmocka_unit_test(every_pixel_of_duff_is_what_its_polynomials_say),
        cmocka_unit_test(every_pixel_of_the_largest_pictures_is_what_its_polynomials_say),
        cmocka_unit_test(a_picture_of_many_is_the_nearest_of_its_triangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
