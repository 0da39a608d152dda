/* SPDX-License-Identifier: MIT */
/* Frames where the view is hard: nothing left after snapping, corners past the guard band, at the eye and behind it. */
#include "exact_rational.h"
#include "tests/unit/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "raster/raster.h"
#include "tests/unit/frame_case.h"
#include "tests/unit/scene_case.h"

#define WIDTH  48
#define HEIGHT 40

static struct scene_case scene;
static struct scene_vertex vertex[4];
static struct scene_triangle triangle[2];
static struct frame_case frame;
static struct scene_header *blob;

/* A blob of four corners and two triangles, changed in place, and a renderer for it. */
static void begin(void)
{
    for (int i = 0; i < 4; i++)
        scene_case_normal(vertex[i].normal, 0, 0, 1);
    triangle[0] = (struct scene_triangle){.corner = {0, 1, 2}};
    triangle[1] = (struct scene_triangle){.corner = {0, 2, 3}};
    scene.material[0].flags = MATERIAL_TWO_SIDED;
    scene.mesh[0].vertices = vertex;
    scene.mesh[0].triangles = triangle;
    scene.mesh[0].vertex_count = 4;
    scene.mesh[0].triangle_count = 2;
    blob = scene_case_blob(&scene);
    frame = (struct frame_case){
        .config = {.width = WIDTH, .height = HEIGHT, .format = GLINT_GREY8, .method = &glint_flat, .max_clipped = 16}};
    frame.config.max_vertices = 4;
    frame.config.max_triangles = 16;
    frame.config.max_objects = frame.config.max_lights = 1;
    frame_case_open(&frame);
}

static void end(void)
{
    frame_case_close(&frame);
    free(blob);
}

/* An orthographic view under which a position unit is a sub-pixel. */
static void begin_flat(void)
{
    scene_case_default(&scene, WIDTH, HEIGHT);
    scene.head.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.head.camera.focal = CASE_UNIT;
    scene.mesh[0].head.extent = 2048 * CASE_UNIT;
    scene.mesh[0].head.radius = 8192 * CASE_UNIT;
    scene.head.camera.far_plane = 20000 * CASE_UNIT;
    scene.object[0].position[2] = -9000 * CASE_UNIT;
    begin();
}

static void *part(uint32_t offset)
{
    return (uint8_t *)blob + offset;
}

/* Draws one triangle of the mesh, the corners at places of three units. */
static void draw(const int32_t p[4][3], const uint16_t corner[3])
{
    struct scene_mesh *mesh = part(blob->meshes);
    struct scene_vertex *v = part(mesh->vertices);
    struct scene_triangle *t = part(mesh->triangles);
    for (int i = 0; i < 4; i++)
        for (int c = 0; c < 3; c++)
            v[i].position[c] = (int16_t)p[i][c];
    memcpy(t->corner, corner, sizeof t->corner);
    mesh->triangle_count = 1;
    frame_case_draw(&frame, blob, 0);
}

static void nothing_is_drawn(void)
{
    for (size_t i = 0; i < frame.picture_bytes; i++)
        assert_int_equal(frame.picture[i], 0);
}

static void what_has_no_area_or_snaps_to_none_is_culled(void **state)
{
    (void)state;
    begin_flat();
    random_seed(21);
    struct scene_object *object = part(blob->objects);
    for (int i = 0; i < 20000; i++) {
        int32_t p[4][3] = {{0}};
        const int snapped = i & 1, dx = random_between(-30, 30), dy = random_between(-30, 30);
        object->scale = snapped ? CASE_UNIT / 64 : CASE_UNIT; /* a unit is 1/64 sub-pixel, and area does not survive */
        for (int k = 0; k < 3; k++) {
            const int at = random_between(-9, 9);
            p[k][0] = snapped ? 64 * 5 + random_between(-31, 31) : at * dx;
            p[k][1] = snapped ? 64 * 3 + random_between(-31, 31) : at * dy;
            if (snapped && i & 2) /* to a line instead of to a point */
                p[k][0] += 640 * at;
        }
        draw(p, triangle[0].corner);
        assert_int_equal(frame.frame.stats.culled, 1);
        nothing_is_drawn();
    }
    end();
}

/* Whether a pixel's centre is within `near` sub-pixels of an edge's line, exactly: edge function squared against length
 * squared. */
static int touches(const struct exact_triangle *t, int x, int y, int near)
{
    const struct cover_point c = cover_centre(x, y, t->width, t->height);
    for (int k = 0; k < 3; k++) {
        const struct cover_point a = t->p[k], b = t->p[(k + 1) % 3];
        const exact_t side = exact_edge(t, k, c), dx = b.x - a.x, dy = b.y - a.y;
        if (side * side <= (dx * dx + dy * dy) * near * near)
            return 1;
    }
    return 0;
}

/* 2048 pixels across is the most that is drawn whole; a sub-pixel more is cut, and to what is in the picture that makes
 * no difference but where a cut's rounding moves an edge, by less than a sub-pixel. */
static void a_sub_pixel_more_than_2048_pixels_is_cut(void **state)
{
    static const int32_t edge[] = {-GUARD - 2, -GUARD - 1, -GUARD, 1 - GUARD, GUARD - 1, GUARD, GUARD + 1, GUARD + 2};
    long whole = 0, cut = 0, pixels = 0, moved = 0;
    (void)state;
    begin_flat();
    random_seed(22);
    for (int i = 0; i < 30000;) {
        struct exact_triangle t = {.width = WIDTH, .height = HEIGHT};
        int32_t p[4][3] = {{0}};
        int outside = 0;
        for (int k = 0; k < 3; k++) {
            p[k][0] = random_bits() % 3 ? edge[random_bits() % 8] : random_between(-500, 500);
            p[k][1] = random_bits() % 3 ? edge[random_bits() % 8] : random_between(-500, 500);
            t.p[k] = (struct cover_point){p[k][0], -p[k][1]};
            outside |= abs(p[k][0]) > GUARD || abs(p[k][1]) > GUARD;
        }
        draw(p, triangle[0].corner);
        const uint32_t clipped = frame.frame.stats.clipped;
        assert_int_equal(frame.frame.stats.dropped, 0);
        if (exact_area(&t) < 0) {
            const struct cover_point other = t.p[1];
            t.p[1] = t.p[2];
            t.p[2] = other;
        }
        int drawn = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                const int wanted = exact_area(&t) && exact_covers(&t, x, y), got = frame.picture[WIDTH * y + x] != 0;
                pixels += wanted;
                drawn += got;
                if (wanted == got)
                    continue;
                moved++;
                if (!outside || !touches(&t, x, y, 1))
                    fail_msg("(%d, %d) (%d, %d) (%d, %d)/16 px: pixel (%d, %d)", t.p[0].x, t.p[0].y, t.p[1].x, t.p[1].y,
                             t.p[2].x, t.p[2].y, x, y);
            }
        whole += drawn && !clipped;
        cut += drawn && clipped;
        i++;
    }
    print_message("%ld drawn whole, %ld cut; of %ld pixels %ld within a sub-pixel of a cut edge differ\n", whole, cut,
                  pixels, moved);
    assert_true(whole > 300 && cut > 3000 && pixels > 1000000);
    end();
}

/* Perspective, exactly: the object at the eye, unturned, a position unit a distance of 1, `near` of them to the near
 * plane. The ray through (sx, sy) sub-pixels is (sx, -sy, -16 WIDTH). */
struct ray {
    exact_t weight[3], sum, volume; /* edges' volumes with the ray, their sum, the corners' */
};

static exact_t volume(const int32_t a[3], const int32_t b[3], const int32_t c[3])
{
    exact_t sum = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += (exact_t)a[i] * ((int64_t)b[j] * c[k] - (int64_t)b[k] * c[j]);
    }
    return sum;
}

static struct ray ray_at(const int32_t *const p[3], int sx, int sy)
{
    const int32_t d[3] = {sx, -sy, -16 * WIDTH};
    struct ray r = {.sum = 0, .volume = volume(p[0], p[1], p[2])};
    for (int k = 0; k < 3; k++) {
        r.weight[k] = volume(p[(k + 1) % 3], p[(k + 2) % 3], d);
        r.sum += r.weight[k];
    }
    return r;
}

/* The edges and the near and far planes' lines on the screen, each a linear function of the place, positive inside. */
enum { LINES = 5 };

static void lines_at(const int32_t *const p[3], int near, int far, int sx, int sy, exact_t out[LINES])
{
    const struct ray r = ray_at(p, sx, sy);
    const exact_t away = r.volume * 16 * WIDTH; /* times the sum: the distance */
    const int sign = r.volume < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++)
        out[k] = r.weight[k] * sign;
    out[3] = (away - near * r.sum) * sign;
    out[4] = (far * r.sum - away) * sign;
}

/* 1 or 0 if it is inside or outside, -1 if it lies within 2 sub-pixels of a line: f^2 <= 4 |grad f|^2. */
static int certain(const int32_t *const p[3], int x, int y, int near, int far)
{
    const struct cover_point c = cover_centre(x, y, WIDTH, HEIGHT);
    exact_t here[LINES], right[LINES], below[LINES];
    int inside = 1;
    lines_at(p, near, far, c.x, c.y, here);
    lines_at(p, near, far, c.x + 1, c.y, right);
    lines_at(p, near, far, c.x, c.y + 1, below);
    for (int k = 0; k < LINES; k++) {
        const exact_t dx = right[k] - here[k], dy = below[k] - here[k];
        if (here[k] * here[k] <= 4 * (dx * dx + dy * dy))
            return -1;
        inside &= here[k] > 0;
    }
    return inside;
}

/* How far a pixel's depth is off: of near / distance on 65519 steps, in steps, less what two sub-pixels sideways make.
 */
static double depth_off(const int32_t *const p[3], int x, int y, int near, int depth)
{
    const struct cover_point c = cover_centre(x, y, WIDTH, HEIGHT);
    const struct ray r = ray_at(p, c.x, c.y), right = ray_at(p, c.x + 1, c.y), below = ray_at(p, c.x, c.y + 1);
    const double unit = (double)(DEPTH_NEAR - DEPTH_FAR) * near / ((double)r.volume * 16 * WIDTH);
    const double gradient = fabs((double)(right.sum - r.sum)) + fabs((double)(below.sum - r.sum));
    return fabs(depth - DEPTH_FAR - unit * (double)r.sum) - 2 * fabs(unit) * gradient;
}

static void begin_perspective(int near, int far)
{
    scene_case_default(&scene, WIDTH, HEIGHT);
    scene.mesh[0].head.extent = 128 * CASE_UNIT; /* 256 of Q16 a position unit */
    scene.mesh[0].head.radius = 256 * CASE_UNIT;
    scene.head.camera.near_plane = near * 256;
    scene.head.camera.far_plane = far * 256;
    begin();
}

static long seen, sure, clipped;
static double ratio, worst;

/* A parallelogram, whose two triangles share an edge and lie in one plane, exactly. */
static void check_floor(const int32_t p[4][3], int near, int far)
{
    static uint8_t count[WIDTH * HEIGHT];
    memset(count, 0, sizeof count);
    for (int half = 0; half < 2; half++) {
        const uint16_t *c = triangle[half].corner;
        const int32_t *const q[3] = {p[c[0]], p[c[1]], p[c[2]]};
        draw(p, c);
        clipped += frame.frame.stats.clipped;
        assert_int_equal(frame.frame.stats.dropped, 0);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                const int got = frame.picture[WIDTH * y + x] != 0, wanted = certain(q, x, y, near, far);
                count[WIDTH * y + x] = (uint8_t)(count[WIDTH * y + x] + got);
                if (wanted >= 0 && got != wanted)
                    fail_msg("(%d %d %d) (%d %d %d) (%d %d %d), near plane at %d: pixel (%d, %d) is %d", q[0][0],
                             q[0][1], q[0][2], q[1][0], q[1][1], q[1][2], q[2][0], q[2][1], q[2][2], near, x, y, got);
                if (wanted != 1)
                    continue;
                const double off = depth_off(q, x, y, near, frame.frame.raster->depth[WIDTH * y + x]);
                worst = fmax(worst, off);
                sure++;
            }
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        if (count[i] > 1)
            fail_msg("(%d %d %d) (%d %d %d) (%d %d %d), near plane at %d: pixel (%d, %d) is drawn twice", p[0][0],
                     p[0][1], p[0][2], p[1][0], p[1][1], p[1][2], p[2][0], p[2][1], p[2][2], near, i % WIDTH,
                     i / WIDTH);
        seen += count[i];
    }
}

/* Three corners, the fourth opposite the second. `nearest`: what the first one's distance is about. */
static int random_floor(int32_t p[4][3], int nearest)
{
    for (int k = 0; k < 3; k++) {
        const int away = k == 0 ? nearest : random_between(4 * abs(nearest) < 60 ? 60 : 4 * abs(nearest), 16000);
        p[k][2] = -away;
        p[k][0] = random_between(-abs(away) - 40, abs(away) + 40);
        p[k][1] = random_between(-abs(away) - 40, abs(away) + 40);
    }
    for (int c = 0; c < 3; c++) {
        p[3][c] = p[0][c] + p[2][c] - p[1][c];
        if (abs(p[3][c]) > 32000)
            return 0;
    }
    return volume(p[0], p[1], p[2]) != 0;
}

static void depth_ratios_of_4_and_more_are_drawn_where_they_are(void **state)
{
    static const int nears[] = {1, 16, 256};
    (void)state;
    seen = sure = clipped = 0;
    ratio = worst = 0;
    random_seed(23);
    for (int n = 0; n < 3; n++) {
        begin_perspective(nears[n], 31000);
        for (int i = 0; i < 1000;) {
            int32_t p[4][3];
            if (!random_floor(p, (int)random_magnitude(nears[n], 3000)))
                continue;
            ratio = fmax(ratio, (double)p[1][2] / p[0][2]);
            check_floor(p, nears[n], 31000);
            i++;
        }
        end();
    }
    print_message("%ld pixels, %ld certain, depth ratios from 4 to %.0f; depths at most %.1f off\n", seen, sure, ratio,
                  worst);
    assert_true(seen > 500000 && ratio > 1000 && worst < 5);
}

/* A corner in the eye's plane, just before it and just behind it: w of 0, of 1 and -1. */
static void w_of_0_is_cut_and_nothing_is_drawn_twice(void **state)
{
    (void)state;
    seen = sure = clipped = 0;
    worst = 0;
    random_seed(24);
    begin_perspective(1, 31000);
    for (int i = 0; i < 3000;) {
        int32_t p[4][3];
        if (!random_floor(p, i % 3 - 1))
            continue;
        check_floor(p, 1, 31000);
        i++;
    }
    end();
    print_message("%ld pixels, %ld certain, %ld cut; depths at most %.1f off\n", seen, sure, clipped, worst);
    assert_true(seen > 200000 && clipped > 2000 && worst < 5);
}

static void all_behind_the_near_plane_is_nothing(void **state)
{
    (void)state;
    random_seed(25);
    for (int near = 1; near <= 4096; near *= 16) {
        begin_perspective(near, 31000);
        for (int i = 0; i < 4000; i++) {
            int32_t p[4][3] = {{0}};
            for (int k = 0; k < 3; k++) {
                p[k][0] = random_between(-32767, 32767);
                p[k][1] = random_between(-32767, 32767);
                p[k][2] = i % 3 ? random_between(0, 32767) : -random_between(0, near - 1);
            }
            draw(p, triangle[0].corner);
            assert_int_equal(frame.frame.stats.rejected, 1);
            nothing_is_drawn();
        }
        end();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_has_no_area_or_snaps_to_none_is_culled),
        cmocka_unit_test(a_sub_pixel_more_than_2048_pixels_is_cut),
        cmocka_unit_test(depth_ratios_of_4_and_more_are_drawn_where_they_are),
        cmocka_unit_test(w_of_0_is_cut_and_nothing_is_drawn_twice),
        cmocka_unit_test(all_behind_the_near_plane_is_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
