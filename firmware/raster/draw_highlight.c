/* SPDX-License-Identifier: MIT */
/*
 * Highlight subdivision (Cho et al. 1996, section 3.1): a new corner at the highlight's centre, which splits the
 * triangle into 3, or where that lies outside, at the nearer place on an edge, which splits it into 2; a neighbour
 * without one takes its brightest corner instead. Then the edges that meet there are halved towards it while the colour
 * in their middle is not what linear interpolation makes of it.
 */
#include "plan/summit.h"
#include "raster/adaptive.h"
#include "raster/parts.h"

#define HALVINGS     5       /* of an edge: weights in Q10 become exact ones in Q15 */
#define LEAST_LENGTH 4 << 19 /* of an edge to be halved, one way or the other: 4 pixels */

/* Luma (Rec. 601) in 1/2^16 of full intensity: the same in every format but for roundings, so that all are split alike.
 */
static int32_t brightness(const struct raster *r, const struct part_corner *corner)
{
    static const uint8_t share[3] = {77, 150, 29};
    uint32_t sum = 0;
    if (raster_channels(r) == 1)
        return fx_s32((corner->colour[0] << 8) / r->palette.top[0]);
    for (unsigned c = 0; c < 3; c++) /* colours are at most top * 2^8: below 2^24 */
        sum += share[c] * (fx_u32(corner->colour[c]) << 8) / r->palette.top[c];
    return fx_s32(sum >> 8);
}

/* Whether the true colour in the middle of a and b differs from the mean by more than the threshold, in parts of it. */
static int differs(const struct raster *r, const struct part_corner *a, const struct part_corner *b,
                   const struct part_corner *middle)
{
    const int32_t is = brightness(r, middle), error = (brightness(r, a) + brightness(r, b)) / 2 - is;
    return (error < 0 ? -error : error) * 256 > r->split.threshold * is; /* at most 2^16 * 2^8 */
}

static int is_short(const struct raster *r, const struct part_corner *a, const struct part_corner *b)
{
    const struct part_place p = part_place(&r->input, a), q = part_place(&r->input, b);
    const int32_t x = p.x < q.x ? q.x - p.x : p.x - q.x, y = p.y < q.y ? q.y - p.y : p.y - q.y;
    return x < LEAST_LENGTH && y < LEAST_LENGTH;
}

/* Halves the edge from the peak to `end`: 1 and the middle, or 0 if it is left whole. As it depends on the edge alone,
 * the part on its other side is split at the same places. */
static int halve(const struct raster *r, const struct part_corner *peak, const struct part_corner *end,
                 struct part_corner *middle)
{
    if (is_short(r, peak, end))
        return 0;
    part_between(&r->input, peak, end, middle);
    return differs(r, peak, end, middle);
}

/* The part of a peak and two corners that follow it: what is cut off at a new corner is done, what keeps the peak goes
 * on. */
static uint32_t draw_fan(struct raster *r, struct edges *e, const struct part_corner *peak, const struct part_corner *a,
                         const struct part_corner *b)
{
    struct part_corner end[2] = {*a, *b}, middle;
    const struct part_corner *const rest[3] = {peak, &end[0], &end[1]}, *const cut[3] = {&middle, &end[0], &end[1]};
    int left[2] = {HALVINGS, HALVINGS};
    uint32_t drawn = 0;
    if (!parts_shows(r, rest))
        return 0;
    while (left[0] || left[1])
        for (int k = 0; k < 2; k++) {
            if (!left[k])
                continue;
            if (!halve(r, peak, &end[k], &middle)) {
                left[k] = 0;
                continue;
            }
            drawn += parts_linear(r, e, cut);
            end[k] = middle;
            left[k]--;
        }
    return drawn + parts_linear(r, e, rest);
}

/* A corner of the triangle in the mesh. */
static struct highlighted_point point_of(const struct shade_input *in, const struct part_corner *corner)
{
    struct highlighted_point point = {{0, 0, 0}, {0, 0, 0}};
    uint16_t weight[3];
    part_weights(in, corner, weight);
    for (int k = 0; k < 3; k++) {
        const struct scene_vertex *vertex = &in->vertices[in->triangle->corner[SHADE_TURN(k)]];
        for (int i = 0; i < 3; i++) { /* weights sum to 2^15: at most 2^30 */
            point.place[i] += vertex->position[i] * weight[k];
            point.normal[i] += vertex->normal[i] * weight[k];
        }
    }
    for (int i = 0; i < 3; i++) {
        point.place[i] >>= 15;
        point.normal[i] >>= 15;
    }
    return point;
}

/* The brightest peak of all lights that may have one here: where it lies, and the corner. Its frame is not to lie on
 * the stack while parts are drawn. */
static __attribute__((noinline)) enum summit_place
find_summit(const struct raster *r, const struct part_corner whole[3], struct part_corner *peak, int *opposite)
{
    const struct highlighted_point point[3] = {point_of(&r->input, &whole[0]), point_of(&r->input, &whole[1]),
                                               point_of(&r->input, &whole[2])};
    const struct object_state *object = r->input.object;
    const unsigned count = r->surface.lights;
    const struct highlighted_signs at[3] = {highlighted_signs(object, count, &point[0]),
                                            highlighted_signs(object, count, &point[1]),
                                            highlighted_signs(object, count, &point[2])};
    const unsigned lights = highlighted_lights(&at[0], &at[1], &at[2]);
    enum summit_place found = SUMMIT_NONE;
    for (unsigned l = 0; l < count; l++) {
        uint16_t weight[3];
        struct part_corner corner;
        int across = 0;
        enum summit_place place = lights >> l & 1 ? summit_find(object, l, point, weight, &across) : SUMMIT_NONE;
        if (place == SUMMIT_NONE)
            continue;
        corner.weight[0] = fx_u16(weight[0] * (PART_ONE / SUMMIT_ONE));
        corner.weight[1] = fx_u16(weight[1] * (PART_ONE / SUMMIT_ONE));
        part_shade(&r->input, &corner);
        if (found != SUMMIT_NONE && brightness(r, &corner) <= brightness(r, peak))
            continue;
        found = place;
        *peak = corner;
        *opposite = across;
    }
    return found;
}

static uint32_t draw(struct raster *r, struct edges *e)
{
    if (r->setup.plane.sliver)
        return draw_gouraud(r, e);
    /* Not on the stack, where drawing has much to put. */
    struct part_corner *const corner = r->setup.parts.split[0].corner, *const peak = corner + 3;
    int at = 0;
    for (int k = 0; k < 3; k++)
        part_whole(&r->input, k, &corner[k]);
    const enum summit_place place = find_summit(r, corner, peak, &at);
    if (place == SUMMIT_NONE)
        for (int k = 1; k < 3; k++)
            if (brightness(r, &corner[k]) > brightness(r, &corner[at]))
                at = k;
    const struct part_corner *a = &corner[at], *b = &corner[at == 2 ? 0 : at + 1], *c = &corner[at ? at - 1 : 2];
    if (place == SUMMIT_NONE)
        return draw_fan(r, e, a, b, c);
    uint32_t drawn = draw_fan(r, e, peak, a, b) + draw_fan(r, e, peak, c, a);
    return place == SUMMIT_EDGE ? drawn : drawn + draw_fan(r, e, peak, b, c);
}

static const struct glint_method split_at_highlight = {.id = GLINT_SUBDIVIDE, .setup = shade_gouraud, .draw = draw};

static const struct glint_method *choose(struct raster *r)
{
    return adaptive_treats(&r->input) ? &split_at_highlight : &glint_gouraud;
}

const struct glint_method glint_subdivide_highlight = {.id = GLINT_SUBDIVIDE,
                                                       .vertex_words = ADAPTIVE_WORDS,
                                                       .setup = shade_gouraud,
                                                       .draw = draw,
                                                       .object = highlighted_mark,
                                                       .choose = choose};
