/* SPDX-License-Identifier: MIT */
/*
 * Random and lattice triangles through edges, spans and polynomials against their definition (exact.h):
 * `exact_triangles PART PARTS` takes a share of EACH of both. A triangle is tried from each of its corners, refused the
 * other way round, cut into bands of every height, and every 64th into every rectangle of its picture.
 */
#include "exact_bounds.h"
#include "geometry/transform.h"
#include "raster/edges.h"
#include "tests/unit/random.h"

#include <stdio.h>
#include <stdlib.h>

#define EACH 1000000
#define SIDE 24 /* of the largest picture of which each pixel is looked at */

static struct counts {
    long triangles, pixels, slivers, slim, refused, rectangles, depth_off[4];
    double closest[4]; /* of the bounds: linear, quadratic, in 64 bits, corner values */
    double worst[2];   /* values' errors in display units: linear, quadratic */
} counts;

static struct exact_triangle triangle;

static void fail(const char *what, int x, int y)
{
    const struct cover_point *p = triangle.p;
    printf("FAIL %s: (%d, %d) (%d, %d) (%d, %d)/16 px in %u x %u, pixel (%d, %d)\n", what, p[0].x, p[0].y, p[1].x,
           p[1].y, p[2].x, p[2].y, triangle.width, triangle.height, x, y);
    exit(1);
}

static void near(int kind, double off, double bound, const char *what, int x, int y)
{
    if (!(fabs(off) <= bound))
        fail(what, x, y);
    const double part = bound > 0 ? fabs(off) / bound : 0;
    if (part > counts.closest[kind])
        counts.closest[kind] = part;
}

/* Corners as the renderer has them, from `first` on. */
static const int16_t *const *places(int first, int step)
{
    static int16_t xy[3][2];
    static const int16_t *const p[3] = {xy[0], xy[1], xy[2]};
    for (int k = 0; k < 3; k++) {
        const struct cover_point *from = &triangle.p[(first + 3 + step * k) % 3];
        xy[k][0] = (int16_t)from->x;
        xy[k][1] = (int16_t)from->y;
    }
    return p;
}

/* Which pixels of each row it covers, one by one. */
static struct span wanted[SIDE];
static int area_of_picture;

static void find_wanted(void)
{
    area_of_picture = 0;
    for (int y = 0; y < (int)triangle.height; y++) {
        struct span row = {0, 0};
        int runs = 0, before = 0;
        for (int x = 0; x < (int)triangle.width; x++) {
            const int now = exact_covers(&triangle, x, y);
            if (now && !before) {
                row.x0 = (int16_t)x;
                runs++;
            }
            if (now)
                row.x1 = (int16_t)(x + 1);
            area_of_picture += now;
            before = now;
        }
        if (runs > 1)
            fail("the definition is not convex", 0, y);
        wanted[y] = row;
    }
}

/* The spans of rows [from, to), `most` at a time, are those of the definition, whose first row and column are (left,
 * top) of the picture's. */
static void check_spans(const int16_t *const *p, int width, int height, int from, int to, int most, int left, int top)
{
    struct edges e;
    struct span got[SIDE];
    int y = from;
    if (edges_setup(&e, p, (unsigned)width, (unsigned)height, from, to)) {
        for (; y < e.row; y++)
            if (wanted[y + top].x1 > left && wanted[y + top].x0 < left + width &&
                wanted[y + top].x1 > wanted[y + top].x0)
                fail("a row is left out", left, y + top);
        while (e.row < e.last) {
            const int count = edges_spans(&e, width, got, most);
            if (count < 1 || count > most || e.row != y + count)
                fail("a count of rows", count, y);
            for (int i = 0; i < count; i++, y++) {
                int x0 = wanted[y + top].x0 - left, x1 = wanted[y + top].x1 - left;
                x0 = x0 < 0 ? 0 : x0;
                x1 = x1 > width ? width : x1;
                const int none = x1 <= x0, nothing = got[i].x1 <= got[i].x0;
                if (none != nothing || (!none && (got[i].x0 != x0 || got[i].x1 != x1)))
                    fail("a span", got[i].x0 + left, y + top);
            }
        }
    }
    for (; y < to; y++)
        if (wanted[y + top].x1 > wanted[y + top].x0 && wanted[y + top].x1 > left && wanted[y + top].x0 < left + width)
            fail("a row is left out below", left, y + top);
}

/* The depth at the first covered pixel of the rectangle that is now the picture, whose corner is (left, top) of the
 * picture's: the same bits as in `whole`. */
static void check_same_value(const struct plane *whole, const struct channel *depth, const int32_t value[3], int left,
                             int top)
{
    for (int y = top; y < top + (int)triangle.height; y++) {
        const int x = wanted[y].x0 > left ? wanted[y].x0 : left;
        struct plane plane;
        struct channel channel;
        int32_t got, same;
        if (x >= wanted[y].x1 || x >= left + (int)triangle.width)
            continue;
        plane_setup(&plane, places(0, 1), triangle.width, triangle.height);
        plane_linear(&plane, value, &channel);
        plane_values(&plane, &channel, x - left, y - top, 1, &got);
        plane_values(whole, depth, x, y, 1, &same);
        if (got != same)
            fail("a value in a rectangle", x, y);
        return;
    }
}

/* Every rectangle of the picture as a picture of its own, and every cut of it into two bands. */
static void check_rectangles(void)
{
    const struct exact_triangle whole = triangle;
    const int w = (int)whole.width, h = (int)whole.height;
    const int32_t value[3] = {DEPTH_FAR, DEPTH_NEAR, random_between(DEPTH_FAR, DEPTH_NEAR)};
    struct plane plane;
    struct channel depth;
    plane_setup(&plane, places(0, 1), whole.width, whole.height);
    plane_linear(&plane, value, &depth);
    for (int x0 = 0; x0 < w; x0++)
        for (int x1 = x0 + 1; x1 <= w; x1++)
            for (int y0 = 0; y0 < h; y0++)
                for (int y1 = y0 + 1; y1 <= h; y1++) {
                    for (int k = 0; k < 3; k++) {
                        triangle.p[k].x = whole.p[k].x + 8 * (w - x0 - x1);
                        triangle.p[k].y = whole.p[k].y + 8 * (h - y0 - y1);
                    }
                    triangle.width = (unsigned)(x1 - x0);
                    triangle.height = (unsigned)(y1 - y0);
                    check_spans(places(0, 1), x1 - x0, y1 - y0, 0, y1 - y0, SIDE, x0, y0);
                    check_same_value(&plane, &depth, value, x0, y0);
                    counts.rectangles++;
                }
    triangle = whole;
    for (int from = 0; from < h; from++)
        for (int to = from + 1; to <= h; to++)
            check_spans(places(0, 1), w, h, from, to, 1 + from % SIDE, 0, 0);
}

/* A polynomial's coefficients within their bounds. */
static void check_coefficients(int kind, const struct polynomial *got, const struct exact_polynomial *exact,
                               const struct exact_bounds *bounds)
{
    near(kind, exact_off(got->f, exact->f, exact->den), bounds->f, "coefficient f", 0, 0);
    near(kind, exact_off(got->d, exact->d, exact->den), bounds->d, "coefficient d", 0, 0);
    near(kind, exact_off(got->e, exact->e, exact->den), bounds->e, "coefficient e", 0, 0);
    near(kind, exact_off(got->a, exact->a, exact->den), bounds->a, "coefficient a", 0, 0);
    near(kind, exact_off(got->b, exact->b, exact->den), bounds->b, "coefficient b", 0, 0);
    near(kind, exact_off(got->c, exact->c, exact->den), bounds->c, "coefficient c", 0, 0);
}

/* What all of it may add up to inside the triangle (plane.c), in display units of Q22: linear 1/64, and beyond 1024
 * pixels what corner differences are rounded by, half of 2 or 4 units of Q14 at each of two; quadratic 1/5 and 3/16, or
 * beyond 1024 pixels 1/2. */
static void check_error(const struct exact_triangle *t, int kind, double off, int x, int y)
{
    const int scale = exact_frame(t).scale;
    const double lost = scale < 0 ? ldexp(1, -scale - 1) / 64 : 0, error = fabs(off) * 0x1p-22,
                 bound = kind < 2 ? 1. / 64 + lost : 1. / 5 + (scale < 0 ? 1. / 2 : 3. / 16);
    if (error > bound)
        fail(kind < 2 ? "a linear value's error" : "a quadratic value's error", x, y);
    if (kind && error > counts.worst[kind - 1])
        counts.worst[kind - 1] = error;
}

/* All covered pixels: of a polynomial, exactly what its coefficients say, and at the ends of rows not too far from what
 * it should be; of corner values, within their bound. */
static void check_values(const struct exact_triangle *t, const struct plane *plane, const struct channel *channel,
                         const struct exact_quantity *q, int kind)
{
    int32_t got[SIDE];
    const exact_t den = (exact_t)exact_area(t) * exact_area(t);
    for (int y = 0; y < (int)t->height; y++) {
        const int x0 = wanted[y].x0, n = wanted[y].x1 - x0;
        if (n <= 0)
            continue;
        plane_values(plane, channel, x0, y, n, got);
        for (int i = 0; i < n; i++) {
            if (channel->exact)
                near(3, exact_off((uint32_t)got[i], exact_value(t, q, x0 + i, y), den),
                     exact_corner_bound(q, channel->exact == PLANE_EXACT_WIDE), "a value by corners", x0 + i, y);
            else if ((uint32_t)got[i] != exact_at(&channel->p, x0 + i - plane->ox, y - plane->oy))
                fail("a value", x0 + i, y);
            else if (i == 0 || i == n - 1)
                check_error(t, kind, exact_off((uint32_t)got[i], exact_value(t, q, x0 + i, y), den), x0 + i, y);
        }
    }
}

/* Depth is what stands above 16 bits of the plane: the whole part of the rational, or where the plane's error (1/64 of
 * a display unit is 1 of depth) passes a whole number, 1 off; of a sliver's corners, two weights too small by 1 of Q16,
 * 2; beyond 1024 pixels, where corner depths are rounded too, 3. Never is it outside what the margins leave
 * (transform.h).
 */
static void check_depth(const struct exact_triangle *t, const struct plane *plane, const struct channel *channel,
                        const struct exact_quantity *q)
{
    const exact_t den = (exact_t)exact_area(t) * exact_area(t) << 16;
    const int most = exact_frame(t).scale < 0 ? 3 : channel->exact ? 2 : 1;
    for (int y = 0; y < (int)t->height; y++)
        for (int x = wanted[y].x0; x < wanted[y].x1; x++) {
            int32_t got;
            plane_values(plane, channel, x, y, 1, &got);
            const int32_t depth = (int32_t)((uint32_t)got >> 16),
                          exact = (int32_t)(exact_value(t, q, x, y) / den); /* not negative */
            const int off = abs(depth - exact);
            if (off > most || depth < DEPTH_FAR - 4 || depth > DEPTH_NEAR + 4)
                fail("a depth", x, y);
            counts.depth_off[off]++;
        }
}

static void random_quantity(struct exact_quantity *q, int kind)
{
    const int extreme = random_bits() & 1;
    q->unit = 65536;
    for (int k = 0; k < 3; k++) {
        q->bulge[k] = 0;
        if (kind == 0)
            q->value[k] =
                extreme ? (random_bits() & 1 ? DEPTH_FAR : DEPTH_NEAR) : random_between(DEPTH_FAR, DEPTH_NEAR);
        else
            q->value[k] = extreme ? random_between(0, 1) * 32768 - 16384 : random_between(-16384, 16384);
        if (kind == 2)
            q->bulge[k] = extreme ? random_between(0, 1) * (1 << 29) - (1 << 28) : random_between(-(1 << 28), 1 << 28);
    }
}

/* One channel, by the way it goes. */
static void check_channel(const struct exact_triangle *t, struct plane *plane, int kind)
{
    struct exact_quantity q;
    struct channel channel;
    struct exact_bounds bounds;
    random_quantity(&q, kind);
    const int wide = kind == 2 && (plane->thin || plane->far);
    if (kind == 2)
        plane_quadratic(plane, q.value, q.bulge, &channel);
    else
        plane_linear(plane, q.value, &channel);
    if (!channel.exact) {
        const struct exact_polynomial p = exact_polynomial(t, &q, plane->ox, plane->oy);
        bounds = kind < 2 ? exact_linear_bounds(t, &p)
                 : wide   ? exact_wide_bounds(t, &p)
                          : exact_quadratic_bounds(t, &p);
        check_coefficients(kind < 2 ? 0 : wide ? 2 : 1, &channel.p, &p, &bounds);
    }
    if (area_of_picture)
        check_values(t, plane, &channel, &q, kind);
    if (area_of_picture && kind == 0)
        check_depth(t, plane, &channel, &q);
}

static void check_set_up(int first)
{
    struct plane plane;
    const struct exact_triangle t = {
        {triangle.p[first], triangle.p[(first + 1) % 3], triangle.p[(first + 2) % 3]}, triangle.width, triangle.height};
    if (!plane_setup(&plane, places(first, 1), t.width, t.height) || plane.det != exact_area(&t))
        fail("the determinant", first, 0);
    const struct exact_origin o = exact_origin(&t);
    if (plane.ox != o.x || plane.oy != o.y || plane.fx != o.from_x || plane.fy != o.from_y)
        fail("the origin", plane.ox, plane.oy);
    plane_setup_quadratic(&plane);
    for (int kind = 0; kind < 3; kind++)
        check_channel(&t, &plane, kind);
    counts.slivers += plane.sliver;
    counts.slim += plane.slim;
    if (plane_setup(&plane, places(first, -1), t.width, t.height))
        fail("a back is not refused", first, 0);
    counts.refused++;
}

static void check_triangle(void)
{
    const int w = (int)triangle.width, h = (int)triangle.height, cut = random_between(0, h);
    find_wanted();
    for (int first = 0; first < 3; first++) {
        const int16_t *const *p = places(first, 1);
        check_spans(p, w, h, 0, h, random_between(1, SIDE), 0, 0);
        if (cut > 0 && cut < h) {
            check_spans(p, w, h, 0, cut, SIDE, 0, 0);
            check_spans(p, w, h, cut, h, SIDE, 0, 0);
        }
        check_set_up(first);
    }
    if (counts.triangles % 64 == 0 && w * h <= 64)
        check_rectangles();
    counts.triangles++;
    counts.pixels += area_of_picture;
}

static int32_t within(int32_t v, int32_t reach)
{
    return v < -reach ? -reach : v > reach ? reach : v;
}

/* Anywhere: as far as a few pixels, the picture's neighbourhood or the guard band; a third of them slivers, whose third
 * corner is near the line of the others. */
static void random_triangle(void)
{
    static const int32_t reaches[] = {40, 200, 200, 400, 3000, GUARD};
    const int32_t reach = reaches[random_bits() % 6];
    for (int k = 0; k < 3; k++)
        triangle.p[k] = (struct cover_point){random_between(-reach, reach), random_between(-reach, reach)};
    if (random_bits() % 3 == 0) {
        const double at = random_real(-.2, 1.2);
        const int height = 1 << random_bits() % 6;
        const struct cover_point *p = triangle.p;
        triangle.p[2] = (struct cover_point){
            within((int32_t)lrint(p[0].x + (p[1].x - p[0].x) * at) + random_between(-height, height), GUARD),
            within((int32_t)lrint(p[0].y + (p[1].y - p[0].y) * at) + random_between(-height, height), GUARD)};
    }
}

/* On pixel centres and corners, within a few sub-pixels of one, or on the guard band's corners and the like. */
static void lattice_triangle(void)
{
    static const int32_t special[] = {GUARD, GUARD - 1, GUARD + 1, 0, 1, -1, -GUARD, 1 - GUARD, -1 - GUARD, 8, -8};
    const int32_t reach = 8 * ((int32_t)triangle.width + 2);
    const unsigned kind = random_bits() % 4;
    const struct cover_point about = {random_between(-reach / 8, reach / 8) * 8,
                                      random_between(-reach / 8, reach / 8) * 8};
    for (int k = 0; k < 3; k++) {
        struct cover_point *p = &triangle.p[k];
        if (kind == 0) {
            *p = (struct cover_point){random_between(-reach / 8, reach / 8) * 8,
                                      random_between(-reach / 8, reach / 8) * 8};
        } else if (kind == 1) {
            *p = (struct cover_point){about.x + random_between(-9, 9), about.y + random_between(-9, 9)};
        } else {
            *p = (struct cover_point){special[random_bits() % 11], special[random_bits() % 11]};
            if (kind == 2 && random_bits() % 3 == 0)
                *p = (struct cover_point){random_between(-reach, reach), random_between(-reach, reach)};
        }
    }
}

static void run(const char *name, void make(void), uint32_t seed, long count)
{
    counts = (struct counts){0};
    random_seed(seed);
    while (counts.triangles < count) {
        triangle.width = (unsigned)random_between(1, counts.triangles % 64 == 0 ? 8 : SIDE);
        triangle.height = (unsigned)random_between(1, counts.triangles % 64 == 0 ? 8 : SIDE);
        make();
        if (exact_area(&triangle) < 0) {
            const struct cover_point other = triangle.p[1];
            triangle.p[1] = triangle.p[2];
            triangle.p[2] = other;
        }
        if (exact_area(&triangle) != 0) {
            check_triangle();
            continue;
        }
        struct plane plane; /* no area: refused in every order */
        for (int first = 0; first < 3; first++)
            if (plane_setup(&plane, places(first, 1), 8, 8) || plane_setup(&plane, places(first, -1), 8, 8))
                fail("no area", first, 0);
    }
    printf("ok %s: %ld triangles from 3 corners, %ld refused from behind, %ld pixels, %ld rectangles; %ld slivers, %ld "
           "slim; depth off by 1, 2, 3 at %ld, %ld, %ld pixels; of the bounds at most %.2f (linear) %.2f (quadratic) "
           "%.2f (64 "
           "bits) %.2f (corners); values off by at most %.4f and %.4f display units\n",
           name, counts.triangles, counts.refused, counts.pixels, counts.rectangles, counts.slivers / 3,
           counts.slim / 3, counts.depth_off[1], counts.depth_off[2], counts.depth_off[3], counts.closest[0],
           counts.closest[1], counts.closest[2], counts.closest[3], counts.worst[0], counts.worst[1]);
}

int main(int argc, char **argv)
{
    const int part = argc > 1 ? atoi(argv[1]) : 0, parts = argc > 2 ? atoi(argv[2]) : 1;
    run("random triangles", random_triangle, 1000u + (uint32_t)part, EACH / parts);
    run("lattice triangles", lattice_triangle, 2000u + (uint32_t)part, EACH / parts);
    return 0;
}
