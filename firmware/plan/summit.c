/* SPDX-License-Identifier: MIT */
#include "plan/summit.h"

#define REFINEMENTS 3 /* each brings the centre many times nearer, unless the light nearly touches the triangle */

struct search {
    const struct object_state *object;
    const struct highlighted_point *corner;
    unsigned light;
};

/* Places are below 2^15, normals of 2^14 (1 + 2^-13): times weights that sum to 2^10. */
static struct highlighted_point point_at(const struct search *s, const uint16_t weight[3])
{
    struct highlighted_point point;
    for (int i = 0; i < 3; i++) {
        int32_t place = SUMMIT_ONE / 2, normal = 0;
        for (int k = 0; k < 3; k++) {
            place += weight[k] * s->corner[k].place[i];
            normal += weight[k] * s->corner[k].normal[i];
        }
        point.place[i] = place >> 10;
        point.normal[i] = normal;
    }
    return point;
}

/* On which side of a condition: a zero counts as above. */
static int is_below(const struct search *s, const uint16_t weight[3], int second)
{
    struct highlighted_point point = point_at(s, weight);
    struct highlighted_conditions at = highlighted_at(s->object, s->light, &point);
    return (second ? at.h2 : at.h1) < 0;
}

/* t / SUMMIT_ONE of the way from u to v. Rounding down two of the weights leaves the third, their rest, at least 0. On
 * an edge of the triangle from corner to corner it is exact. */
static void between(const uint16_t u[3], const uint16_t v[3], int t, uint16_t out[3])
{
    for (int i = 0; i < 2; i++)
        out[i] = fx_u16(u[i] + ((v[i] - u[i]) * t >> 10));
    out[2] = fx_u16(SUMMIT_ONE - out[0] - out[1]);
}

/* Where a condition changes from u's side to v's, the other. */
static void solve(const struct search *s, const uint16_t u[3], const uint16_t v[3], int second, uint16_t out[3])
{
    const int side = is_below(s, u, second);
    for (int low = 0, high = SUMMIT_ONE; high - low > 1;) {
        int middle = (low + high) >> 1;
        between(u, v, middle, out);
        if (is_below(s, out, second) == side)
            low = middle;
        else
            high = middle;
    }
}

/* The cosine of normal and half-way vector there, Q14. Its frame is not to lie on the stack while edges are solved. */
static __attribute__((noinline)) int32_t cosine_at(const struct search *s, const uint16_t weight[3])
{
    const struct highlighted_point point = point_at(s, weight);
    q14_t towards[3], half[3], normal[3];
    object_light_at(s->object, s->light, point.place, towards, half);
    object_unit(point.normal, normal);
    return object_dot(normal, half);
}

/* P again, from P = `weight`, between Q and R on the edges that meet in corner a; b, c the others. */
static void refine(const struct search *s, const uint16_t ends[2][3], int a, int b, int c, uint16_t weight[3])
{
    const uint16_t others = fx_u16(weight[b] + weight[c]);
    uint16_t from[3] = {0, 0, 0}, across[3] = {0, 0, 0}, on[3];
    if (!others)
        return;
    from[a] = SUMMIT_ONE;
    across[b] = fx_u16((weight[b] * SUMMIT_ONE + others / 2) / others);
    across[c] = fx_u16(SUMMIT_ONE - across[b]);
    if (is_below(s, from, 0) == is_below(s, across, 0))
        return; /* the curve leaves the triangle between: the straight guess stands */
    solve(s, from, across, 0, on);
    /* the end on the other side: Q and R are on different ones */
    solve(s, on, ends[is_below(s, on, 1) == is_below(s, ends[0], 1)], 1, weight);
}

enum summit_place summit_find(const struct object_state *object, unsigned light,
                              const struct highlighted_point corner[3], uint16_t weight[3], int *opposite)
{
    const struct search s = {object, corner, light};
    int side[3], a;
    uint16_t at[3][3] = {{SUMMIT_ONE, 0, 0}, {0, SUMMIT_ONE, 0}, {0, 0, SUMMIT_ONE}}, ends[2][3];
    for (int k = 0; k < 3; k++)
        side[k] = is_below(&s, at[k], 0);
    /* the corner whose side is neither other's */
    if (side[0] == side[1] && side[1] == side[2])
        return SUMMIT_NONE;
    a = side[1] == side[2] ? 0 : side[0] == side[2] ? 1 : 2;
    const int b = a == 2 ? 0 : a + 1, c = 3 - a - b;
    solve(&s, at[a], at[b], 0, ends[0]);
    solve(&s, at[a], at[c], 0, ends[1]);
    if (is_below(&s, ends[0], 1) != is_below(&s, ends[1], 1)) {
        solve(&s, ends[0], ends[1], 1, weight);
        for (int i = 0; i < REFINEMENTS && object->local; i++)
            refine(&s, (const uint16_t(*)[3])ends, a, b, c, weight);
        return SUMMIT_INSIDE;
    }
    const int nearer = cosine_at(&s, ends[0]) < cosine_at(&s, ends[1]);
    for (int k = 0; k < 3; k++)
        weight[k] = ends[nearer][k];
    *opposite = nearer ? b : c; /* R is on the edge from a to c */
    return SUMMIT_EDGE;
}
