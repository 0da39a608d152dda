/* SPDX-License-Identifier: MIT */
#include "plan/highlighted.h"

/* The way from a place to light or eye: at most 2^28 + 2^16 a component, of a far one a unit vector in Q14. */
static void way_to(const struct object_point *to, const int32_t place[3], int32_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = object_way(to, place, i);
}

/* Products of way and normal: 3 * 2^28.01 * 2^25 < 2^55; of two ways: below 2^58. */
static int64_t inner(const int32_t a[3], const int32_t b[3])
{
    return fx_s64(a[0]) * b[0] + fx_s64(a[1]) * b[1] + fx_s64(a[2]) * b[2];
}

/* The sign of (l x v) . n, exactly: components of the cross product are below 2^58; in halves, the upper sum is below
 * 3 * 2^26 * 2^25 and the lower below 3 * 2^32 * 2^25. */
static int triple_sign(const int32_t l[3], const int32_t v[3], const int32_t n[3])
{
    int64_t high = 0, low = 0;
    for (int i = 0; i < 3; i++) {
        int j = i == 2 ? 0 : i + 1, k = 3 - i - j;
        int64_t cross = fx_s64(l[j]) * v[k] - fx_s64(l[k]) * v[j];
        high += (cross >> 32) * n[i];
        low += (cross & 0xffffffff) * n[i];
    }
    high += low >> 32;
    return high < 0 ? -1 : high > 0 || (low & 0xffffffff);
}

/* A positive number as mantissa in [2^30, 2^31), rounded down, and exponent. */
struct scaled {
    uint32_t mantissa;
    int exponent;
};

static struct scaled scaled_of(uint64_t x)
{
    uint32_t upper = fx_u32(x >> 32);
    int bits = upper ? 64 - fx_s32(fx_clz(upper)) : 32 - fx_s32(fx_clz(fx_u32(x) | 1));
    struct scaled s = {fx_u32(bits > 31 ? x >> (bits - 31) : x << (31 - bits)), bits - 31};
    return s;
}

static struct scaled times(struct scaled a, struct scaled b)
{
    struct scaled product = scaled_of(fx_u64(a.mantissa) * b.mantissa);
    product.exponent += a.exponent + b.exponent;
    return product;
}

/* The sign of x - y. Either has been rounded down five times by less than 2^-30 of itself: what differs by no more than
 * 2^-27 counts as equal, and up to 2^-25 may. */
static int compare(struct scaled x, struct scaled y)
{
    int up = x.exponent - y.exponent;
    if (up > 1 || up < -1)
        return up > 0 ? 1 : -1;
    int64_t a = x.mantissa, b = y.mantissa;
    if (up > 0)
        a *= 2;
    else if (up < 0)
        b *= 2;
    int64_t difference = a - b;
    return difference > 32 ? 1 : difference < -32 ? -1 : 0; /* of 2^30..2^31, or 2^32 */
}

/* The sign of vn / |v| - ln / |l| from the squares; 0 where there is no way to go. */
static int h2_sign(int64_t vn, uint64_t vv, int64_t ln, uint64_t ll)
{
    if (!vv || !ll)
        return 0;
    if ((vn < 0) != (ln < 0) || !vn || !ln)
        return vn > ln ? 1 : vn < ln ? -1 : 0;
    struct scaled v = scaled_of(fx_u64(vn < 0 ? -vn : vn)), l = scaled_of(fx_u64(ln < 0 ? -ln : ln));
    int larger = compare(times(times(v, v), scaled_of(ll)), times(times(l, l), scaled_of(vv)));
    return vn < 0 ? -larger : larger;
}

struct highlighted_conditions highlighted_at(const struct object_state *object, unsigned light,
                                             const struct highlighted_point *point)
{
    struct highlighted_conditions at;
    int32_t l[3], v[3];
    way_to(&object->light[light].source, point->place, l);
    way_to(&object->eye, point->place, v);
    int64_t ln = inner(l, point->normal), vn = inner(v, point->normal);
    at.h1 = fx_s8(triple_sign(l, v, point->normal));
    at.h2 = fx_s8(h2_sign(vn, fx_u64(inner(v, v)), ln, fx_u64(inner(l, l))));
    at.away = ln < 0 && vn < 0;
    at.towards = ln > 0 && vn > 0;
    return at;
}

struct highlighted_signs highlighted_signs(const struct object_state *object, unsigned lights,
                                           const struct highlighted_point *point)
{
    struct highlighted_signs signs = {0, 0, 0, 0, 0, 0};
    for (unsigned i = 0; i < lights; i++) {
        struct highlighted_conditions at = highlighted_at(object, i, point);
        signs.below1 |= fx_u8((at.h1 <= 0) << i);
        signs.above1 |= fx_u8((at.h1 >= 0) << i);
        signs.below2 |= fx_u8((at.h2 <= 0) << i);
        signs.above2 |= fx_u8((at.h2 >= 0) << i);
        signs.away |= fx_u8(at.away << i);
        signs.towards |= fx_u8(at.towards << i);
    }
    return signs;
}

_Static_assert(sizeof(struct highlighted_signs) <= 2 * HIGHLIGHTED_WORDS, "kept in a vertex record while testing");

/* Which sides of a triangle may hold a highlight's centre. */
static int16_t sides_of(const struct highlighted_signs *a, const struct highlighted_signs *b,
                        const struct highlighted_signs *c, int backs)
{
    int16_t sides = highlighted_lights(a, b, c) ? HIGHLIGHTED_FRONT : 0;
    if (backs && highlighted_centres(a, b, c) & ~fx_u32(a->towards & b->towards & c->towards))
        sides |= HIGHLIGHTED_BACK;
    return sides;
}

void highlighted_mark(const struct object_state *object, const struct scene_header *scene, int16_t *records,
                      unsigned stride, struct glint_stats *stats)
{
    const struct scene_mesh *mesh = object->mesh;
    const struct scene_vertex *vertex = scene_at(scene, mesh->vertices);
    const struct scene_triangle *triangle = scene_at(scene, mesh->triangles);
    const unsigned lights = scene->light_count;
    const int backs = USES(USES_TWO_SIDED) && scene->effects & USES_TWO_SIDED;
    int16_t *const words = records + VERTEX_LIGHTS + 2 * lights, *word = words;
    for (uint32_t n = mesh->vertex_count; n; n--, vertex++, word += stride) {
        struct highlighted_point point;
        for (int i = 0; i < 3; i++) {
            point.place[i] = vertex->position[i];
            point.normal[i] = vertex->normal[i];
        }
        *(struct highlighted_signs *)(void *)word = highlighted_signs(object, lights, &point);
        word[HIGHLIGHTED_WORDS] = 0;
    }
    for (uint32_t n = mesh->triangle_count; n; n--, triangle++) {
        int16_t *corner[3];
        for (int k = 0; k < 3; k++)
            corner[k] = words + triangle->corner[k] * stride;
        const int16_t sides =
            sides_of((const void *)corner[0], (const void *)corner[1], (const void *)corner[2], backs);
        if (!sides)
            continue;
        stats->potentially_highlighted++;
        for (int k = 0; k < 3; k++)
            corner[k][HIGHLIGHTED_WORDS] |= sides;
    }
    stats->highlight_tests += mesh->triangle_count;
    word = words;
    for (uint32_t n = mesh->vertex_count; n; n--, word += stride)
        for (int i = 0; i < HIGHLIGHTED_WORDS; i++)
            word[i] = 0;
}
