/* SPDX-License-Identifier: MIT */
/* Triangles cut at the near and far planes and the guard band. */
#include "cover.h"
#include "geometry/clip.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "scene_case.h"

#define WIDTH  64
#define HEIGHT 48
#define RING   6

static struct scene_case scene;
static struct scene_vertex vertex[RING + 1]; /* a fan: the centre last */
static struct scene_triangle triangle[RING];

/* A closed fan of `count` triangles around vertex[count]. */
static struct scene_header *fan_blob(unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        triangle[i].corner[0] = (uint16_t)count;
        triangle[i].corner[1] = (uint16_t)i;
        triangle[i].corner[2] = (uint16_t)((i + 1) % count);
        scene_case_bend(&triangle[i], vertex);
    }
    scene.mesh[0].vertices = vertex;
    scene.mesh[0].triangles = triangle;
    scene.mesh[0].vertex_count = count + 1;
    scene.mesh[0].triangle_count = count;
    return scene_case_blob(&scene);
}

/* Leaves only one of the mesh's triangles, or brings all back. */
static void keep_one(struct scene_header *blob, unsigned which)
{
    struct scene_mesh *mesh = (struct scene_mesh *)((uint8_t *)blob + blob->meshes);
    struct scene_triangle *at = (struct scene_triangle *)((uint8_t *)blob + mesh->triangles);
    at[0] = triangle[which];
    mesh->triangle_count = 1;
}

/* Adds to count[] where each triangle alone is drawn; returns how many were clipped. */
static uint32_t count_pixels(struct frame_case *f, struct scene_header *blob, unsigned triangles, uint8_t *count)
{
    uint32_t clipped = 0;
    memset(count, 0, WIDTH * HEIGHT);
    for (unsigned i = 0; i < triangles; i++) {
        keep_one(blob, i);
        frame_case_draw(f, blob, 0);
        assert_int_equal(f->frame.stats.dropped, 0);
        clipped += f->frame.stats.clipped;
        for (size_t p = 0; p < WIDTH * HEIGHT; p++)
            count[p] = (uint8_t)(count[p] + (f->picture[p] != 0));
    }
    return clipped;
}

static void open_grey(struct frame_case *f, const struct glint_method *method)
{
    *f = (struct frame_case){.config = {.width = WIDTH, .height = HEIGHT, .format = GLINT_GREY8, .method = method}};
    f->config.max_vertices = RING + 1;
    f->config.max_triangles = f->config.max_clipped = 8 * RING;
    f->config.max_objects = f->config.max_lights = 1;
    frame_case_open(f);
}

static struct cover_point corner[RING + 1];

/* At the guard band, 1024 pixels out, beyond it, a sub-pixel inside it, where a cut close by may be rounded to a
 * corner's other side, or anywhere about the picture. */
static struct cover_point random_corner(void)
{
    static const int special[] = {16381, 16382, 16383, 16384, 16385, -16381, -16382, -16383, -16384, -16385, 0};
    struct cover_point p = {random_between(-32000, 32000), random_between(-32000, 32000)};
    if (random_bits() % 3 == 0)
        p.x = special[random_bits() % 11];
    if (random_bits() % 3 == 0)
        p.y = special[random_bits() % 11];
    return p;
}

static int by_angle(const void *left, const void *right)
{
    const struct cover_point *a = left, *b = right;
    double d =
        atan2(b->y - corner[RING].y, b->x - corner[RING].x) - atan2(a->y - corner[RING].y, a->x - corner[RING].x);
    return d > 0 ? -1 : d < 0;
}

/* A fan about a point in or near the picture, most of it outside the guard band; clockwise with y down. */
static int random_fan(void)
{
    corner[RING] = (struct cover_point){random_between(-640, 640), random_between(-500, 500)};
    for (int i = 0; i < RING; i++)
        corner[i] = random_corner();
    qsort(corner, RING, sizeof *corner, by_angle);
    for (int i = 0; i < RING; i++)
        if (cover_turn(corner[RING], corner[i], corner[(i + 1) % RING]) <= 0)
            return 0;
    for (int i = 0; i <= RING; i++) {
        vertex[RING == i ? RING : RING - 1 - i].position[0] = (int16_t)corner[i].x; /* y is turned over */
        vertex[RING == i ? RING : RING - 1 - i].position[1] = (int16_t)-corner[i].y;
        vertex[i].position[2] = 0;
        scene_case_normal(vertex[i].normal, 0, 0, 1);
    }
    return 1;
}

/* Sub-pixels from a point to the fan's outline. */
static double distance_to_outline(struct cover_point p)
{
    double nearest = 1e9;
    for (int i = 0; i < RING; i++) {
        struct cover_point a = corner[i], b = corner[(i + 1) % RING];
        nearest = fmin(nearest, fabs((double)cover_turn(a, b, p)) / hypot(b.x - a.x, b.y - a.y));
    }
    return nearest;
}

static void edge_shared_across_the_guard_band_is_drawn_once(void **state)
{
    (void)state;
    static uint8_t count[WIDTH * HEIGHT];
    struct frame_case f;
    uint32_t clipped = 0;
    long covered = 0;
    scene_case_sub_pixels(&scene, WIDTH, HEIGHT);
    open_grey(&f, &glint_flat);
    random_seed(61);
    for (int fans = 0; fans < 2000;) {
        if (!random_fan())
            continue;
        struct scene_header *blob = fan_blob(RING);
        clipped += count_pixels(&f, blob, RING, count);
        for (int p = 0; p < WIDTH * HEIGHT; p++) {
            struct cover_point centre = cover_centre(p % WIDTH, p / WIDTH, WIDTH, HEIGHT);
            int wanted = cover_polygon(corner, RING, centre);
            covered += wanted;
            /* A cut is rounded to a sub-pixel, so the outline may move by one. */
            if (count[p] > 1 || (count[p] != wanted && distance_to_outline(centre) > 2)) {
                for (int i = 0; i <= RING; i++)
                    print_message("(%d, %d)/16 px\n", corner[i].x, corner[i].y);
                fail_msg("pixel (%d, %d) is drawn %d times, not %d", p % WIDTH, p / WIDTH, count[p], wanted);
            }
        }
        free(blob);
        fans++;
    }
    frame_case_close(&f);
    assert_true(clipped > 4000 && covered > 100000);
}

/* How much of light falls on the fan's triangle at a pixel, by X's polynomial over the whole triangle, uncut. */
static double phi(const struct scene_triangle *t, struct cover_point c)
{
    struct cover_point p[3];
    double value[3], l[3], sum = 0;
    for (int k = 0; k < 3; k++) {
        const struct scene_vertex *v = &vertex[t->corner[k]];
        p[k] = (struct cover_point){v->position[0], -v->position[1]};
        value[k] = v->normal[2] / 16384.;
    }
    for (int k = 0; k < 3; k++)
        l[k] = (double)cover_turn(c, p[(k + 1) % 3], p[(k + 2) % 3]) / (double)cover_turn(p[0], p[1], p[2]);
    for (int k = 0; k < 3; k++)
        sum += value[k] * l[k] + (value[k] + value[(k + 1) % 3]) * (t->bend[k] / 65536.) * l[k] * l[(k + 1) % 3];
    return sum;
}

/* An edge through the very centre of a pixel to a corner where the guard band ends, between a triangle that has a
 * corner outside and one that has not: both must take the edge for the same. */
static void edge_to_a_corner_at_the_guard_band_is_drawn_once(void **state)
{
    (void)state;
    static uint8_t count[WIDTH * HEIGHT];
    struct frame_case f;
    int tested = 0;
    scene_case_sub_pixels(&scene, WIDTH, HEIGHT);
    open_grey(&f, &glint_flat);
    random_seed(65);
    memset(vertex, 0, sizeof vertex);
    for (int i = 0; i <= RING; i++)
        scene_case_normal(vertex[i].normal, 0, 0, 1);
    while (tested < 1500) {
        static const int ends[] = {16300, 16383, 16384, 16385};
        int x = random_between(20, WIDTH - 20), y = random_between(16, HEIGHT - 16), end = ends[tested % 4];
        struct cover_point c = cover_centre(x, y, WIDTH, HEIGHT);
        int dx = random_between(17, 600), dy = random_between(-2 * dx / 3, 2 * dx / 3), times = (end - c.x) / dx;
        if (times * dx != end - c.x)
            continue;
        const struct cover_point p[4] = {
            {c.x - dx, c.y - dy}, {end, c.y + times * dy}, {16000, 16000}, {random_between(-4000, 4000), -25000}};
        for (int i = 0; i < 4; i++) {
            vertex[i].position[0] = (int16_t)p[i].x;
            vertex[i].position[1] = (int16_t)-p[i].y;
        }
        struct scene_header *blob = fan_blob(3);
        triangle[0] = (struct scene_triangle){.corner = {0, 2, 1}};
        triangle[1] = (struct scene_triangle){.corner = {0, 1, 3}};
        count_pixels(&f, blob, 2, count);
        if (count[y * WIDTH + x] != 1)
            fail_msg("(%d, %d) to (%d, %d)/16 px: pixel (%d, %d) is drawn %d times", p[0].x, p[0].y, p[1].x, p[1].y, x,
                     y, count[y * WIDTH + x]);
        free(blob);
        tested++;
    }
    frame_case_close(&f);
}

/* The least height of a triangle of the fan, in sub-pixels. */
static double height_of(const struct scene_triangle *t)
{
    struct cover_point p[3];
    double longest = 0;
    for (int k = 0; k < 3; k++)
        p[k] = (struct cover_point){vertex[t->corner[k]].position[0], -vertex[t->corner[k]].position[1]};
    for (int k = 0; k < 3; k++)
        longest = fmax(longest, hypot(p[(k + 1) % 3].x - p[k].x, p[(k + 1) % 3].y - p[k].y));
    return fabs((double)cover_turn(p[0], p[1], p[2])) / longest;
}

static void x_on_pieces_has_the_values_of_the_whole_triangle(void **state)
{
    (void)state;
    struct frame_case f;
    double worst = 0;
    long compared = 0;
    scene_case_sub_pixels(&scene, WIDTH, HEIGHT);
    scene.material[0].ka = 0;
    scene.material[0].kd = 32768;
    open_grey(&f, &glint_x);
    random_seed(62);
    for (int fans = 0; fans < 1000;) {
        if (!random_fan())
            continue;
        for (int i = 0; i <= RING; i++) {
            double n[3];
            random_direction(n, 3);
            scene_case_normal(vertex[i].normal, n[0], n[1], fabs(n[2]) + .3);
        }
        struct scene_header *blob = fan_blob(RING);
        for (unsigned i = 0; i < RING; i++) {
            keep_one(blob, i);
            frame_case_draw(&f, blob, 0);
            if (f.frame.stats.clipped == 0 || height_of(&triangle[i]) < 80 * 16)
                continue; /* a cut rounded to a sub-pixel shows where that is much of the height */
            for (int p = 0; p < WIDTH * HEIGHT; p++) {
                double wanted = 255 * phi(&triangle[i], cover_centre(p % WIDTH, p / WIDTH, WIDTH, HEIGHT));
                if (f.picture[p] == 0)
                    continue;
                double error = fabs(f.picture[p] - wanted) - .5;
                worst = fmax(worst, error);
                compared++;
                if (wanted < 255 && error > .5) {
                    const uint16_t *c = triangle[i].corner;
                    fail_msg("(%d, %d) (%d, %d) (%d, %d)/16 px: pixel (%d, %d) is %d, not %.2f",
                             vertex[c[0]].position[0], -vertex[c[0]].position[1], vertex[c[1]].position[0],
                             -vertex[c[1]].position[1], vertex[c[2]].position[0], -vertex[c[2]].position[1], p % WIDTH,
                             p / WIDTH, f.picture[p], wanted);
                }
            }
        }
        free(blob);
        fans++;
    }
    print_message("%ld pixels of pieces, at most %.3f/255 off beyond rounding\n", compared, worst);
    frame_case_close(&f);
    assert_true(compared > 100000);
}

/* The plane of a fan in front of, around and behind the eye: its axes and a point, in scene units of the eye. */
static double axis[2][3], origin[3];

static void random_plane(void)
{
    double dot = 0, length = 0;
    random_direction(axis[0], 3);
    random_direction(axis[1], 3);
    for (int i = 0; i < 3; i++)
        dot += axis[0][i] * axis[1][i];
    for (int i = 0; i < 3; i++) {
        axis[1][i] -= dot * axis[0][i];
        length += axis[1][i] * axis[1][i];
    }
    for (int i = 0; i < 3; i++)
        axis[1][i] /= sqrt(length);
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Whether a ray through (sx, sy), sub-pixels from the picture's centre, meets a triangle of the fan between the planes.
 */
static int ray_meets(const struct scene_triangle *t, double sx, double sy)
{
    double d[3] = {sx / 16 / WIDTH, -sy / 16 / WIDTH, -1}, p[3][3], n[3], weight[3], sum = 0, away = 0;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            p[k][i] = vertex[t->corner[k]].position[i] / 1024.;
    for (int k = 0; k < 3; k++) { /* volumes of the ray with each edge: barycentric */
        cross(p[(k + 1) % 3], p[(k + 2) % 3], n);
        weight[k] = dot(n, d);
        sum += weight[k];
    }
    for (int k = 0; k < 3; k++) {
        if (!(weight[k] / sum >= 0))
            return 0;
        away -= p[k][2] * weight[k] / sum;
    }
    return away >= .25 && away <= scene.head.camera.far_plane / (double)CASE_UNIT;
}

/* 1 or 0 if all rays within an eighth of a pixel agree, else -1. */
static int certain(int x, int y)
{
    struct cover_point c = cover_centre(x, y, WIDTH, HEIGHT);
    int sum = 0;
    for (int dy = -2; dy <= 2; dy += 2)
        for (int dx = -2; dx <= 2; dx += 2)
            for (int i = 0, any = 0; i < RING && !any; i++)
                sum += any = ray_meets(&triangle[i], c.x + dx, c.y + dy);
    return sum == 0 ? 0 : sum == 9 ? 1 : -1;
}

/* A fan in a random plane, positions of up to 32 units in steps of 1/1024, facing the eye or not. */
static int random_floor(void)
{
    random_plane();
    for (int i = 0; i < 3; i++)
        origin[i] = random_real(-2, 2);
    corner[RING] = (struct cover_point){0, 0};
    for (int i = 0; i < RING; i++)
        corner[i] = (struct cover_point){random_between(-8000, 8000), random_between(-8000, 8000)};
    qsort(corner, RING, sizeof *corner, by_angle);
    for (int i = 0; i < RING; i++)
        if (cover_turn(corner[RING], corner[i], corner[(i + 1) % RING]) <= 0)
            return 0;
    for (int i = 0; i <= RING; i++) {
        for (int k = 0; k < 3; k++)
            vertex[i].position[k] =
                (int16_t)lrint((origin[k] + (axis[0][k] * corner[i].x + axis[1][k] * corner[i].y) / 512) * 1024);
        scene_case_normal(vertex[i].normal, 0, 0, 1);
    }
    return 1;
}

static void edge_shared_across_the_near_and_far_planes_is_drawn_once(void **state)
{
    (void)state;
    static uint8_t count[WIDTH * HEIGHT];
    struct frame_case f;
    uint32_t clipped = 0;
    long sure = 0;
    scene_case_default(&scene, WIDTH, HEIGHT);
    scene.mesh[0].head.extent = 32 * CASE_UNIT;
    scene.mesh[0].head.radius = 64 * CASE_UNIT;
    open_grey(&f, &glint_flat);
    random_seed(63);
    for (int fans = 0; fans < 200;) {
        if (!random_floor())
            continue;
        /* seen from its front; a glancing view makes a quantised plane uneven */
        double normal[3];
        cross(axis[0], axis[1], normal);
        if (dot(normal, origin) > -.2)
            continue;
        scene.head.camera.far_plane = (fans & 1 ? 3 : 64) * CASE_UNIT;
        struct scene_header *blob = fan_blob(RING);
        clipped += count_pixels(&f, blob, RING, count);
        for (int p = 0; p < WIDTH * HEIGHT; p++) {
            int wanted = certain(p % WIDTH, p / WIDTH);
            sure += wanted > 0;
            if (count[p] > 1 || (wanted >= 0 && count[p] != wanted))
                fail_msg("fan %d: pixel (%d, %d) is drawn %d times, not %d", fans, p % WIDTH, p / WIDTH, count[p],
                         wanted);
        }
        free(blob);
        fans++;
    }
    frame_case_close(&f);
    assert_true(clipped > 400 && sure > 100000);
}

static void behind_the_near_plane_nothing_is_drawn(void **state)
{
    (void)state;
    struct frame_case f;
    scene_case_default(&scene, WIDTH, HEIGHT);
    scene.mesh[0].head.extent = 32 * CASE_UNIT;
    scene.mesh[0].head.radius = 64 * CASE_UNIT;
    open_grey(&f, &glint_flat);
    random_seed(64);
    for (int i = 0; i < 5000; i++) {
        for (int v = 0; v < 4; v++) {
            for (int k = 0; k < 2; k++)
                vertex[v].position[k] = (int16_t)random_between(-8000, 8000);
            /* at the eye, at the plane (which is seen, so a step before it), or behind */
            static const int16_t special[] = {0, -255, -1, 1};
            vertex[v].position[2] =
                random_bits() & 1 ? special[random_bits() % 4] : (int16_t)random_between(-255, 8000);
            scene_case_normal(vertex[v].normal, 0, 0, 1);
        }
        struct scene_header *blob = fan_blob(3);
        frame_case_draw(&f, blob, 0);
        const struct glint_stats *s = &f.frame.stats;
        assert_true(s->triangles == 3 && s->rejected == 3 && s->clipped == 0 && frame_case_drawn(&f) == 0);
        for (size_t p = 0; p < f.picture_bytes; p++)
            assert_int_equal(f.picture[p], 0);
        free(blob);
    }
    frame_case_close(&f);
}

/* By clip.h within 2^-27: 1 on an edge of the triangle's own, 3/2 more at each further plane. */
static void weights_of_cut_corners_sum_to_one(void **state)
{
    (void)state;
    const int32_t one = Q30(1, 1);
    int64_t least = 0, most = 0;
    long cuts = 0;
    random_seed(65);
    for (int i = 0; i < 200000; i++) {
        const int32_t reach = 1 << random_between(3, 28);
        struct transform t = {
            .near_z = 1, .far_z = random_between(1, reach), .divide = 1, .shift = random_between(25, 32)};
        struct clip_polygon polygon = {.count = 3}, other;
        t.range = (uint32_t)t.far_z - 1;
        for (int k = 0; k < 3; k++) {
            struct clip_corner *c = &polygon.corner[k];
            c->eye.x = random_between(-reach, reach);
            c->eye.y = random_between(-reach, reach);
            c->eye.z = random_between(-reach, reach);
            c->weight[0] = c->weight[1] = c->weight[2] = 0;
            c->weight[k] = one;
        }
        clip_triangle(&t, &polygon, &other);
        for (int k = 0; k < polygon.count; k++, cuts++) {
            const q30_t *w = polygon.corner[k].weight;
            const int64_t off = (int64_t)w[0] + w[1] + w[2] - one;
            assert_true(w[0] >= 0 && w[1] >= 0 && w[2] >= 0);
            least = off < least ? off : least;
            most = off > most ? off : most;
        }
    }
    print_message("%ld corners, sums %d to %d * 2^-30 off\n", cuts, (int)least, (int)most);
    assert_true(cuts > 300000 && least >= -8 && most <= 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edge_shared_across_the_guard_band_is_drawn_once),
        cmocka_unit_test(edge_to_a_corner_at_the_guard_band_is_drawn_once),
        cmocka_unit_test(x_on_pieces_has_the_values_of_the_whole_triangle),
        cmocka_unit_test(edge_shared_across_the_near_and_far_planes_is_drawn_once),
        cmocka_unit_test(behind_the_near_plane_nothing_is_drawn),
        cmocka_unit_test(weights_of_cut_corners_sum_to_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
