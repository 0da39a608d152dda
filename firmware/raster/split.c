/* SPDX-License-Identifier: MIT */
#include "raster/split.h"

#include "raster/effects.h"
#include "raster/fine.h"
#include "shade/part.h"

#define LEAST_HEIGHT 64 /* sub-pixels: what is lower is not split, so that its parts, half as high, have quadratics */

/* A triangle that is or may be split: its corners' weights, as struct part_corner has them. */
struct piece {
    uint16_t weight[3][2];
    uint8_t next; /* the next of its 4 parts to be drawn */
};

/* A part's coordinates, and what they have to be divided by. */
static void find_corners(const struct uv_corners *whole, const struct piece *piece, struct uv_corners *out)
{
    *out = *whole;
    for (int k = 0; k < 3; k++) {
        const uint32_t a = piece->weight[k][0], b = piece->weight[k][1], c = PART_ONE - a - b;
        const uint32_t wa = a * whole->s[0], wb = b * whole->s[1], wc = c * whole->s[2]; /* Q31, together below 2^31 */
        const uint32_t sum = wa + wb + wc;
        const unsigned up = fx_clz(sum);
        const uint32_t inverse = fx_recip_norm(sum << up);
        /* shares in Q30; the last is the rest, so that what is the same at all corners stays so */
        const int32_t p = (int32_t)(fx_mulhi_u32(wa << up, inverse) >> 1);
        const int32_t q = (int32_t)(fx_mulhi_u32(wb << up, inverse) >> 1);
        for (int axis = 0; axis < 2; axis++) { /* differences of Q28 below 2^32, products below 2^63 */
            const int64_t rest = whole->value[axis][2];
            out->value[axis][k] = (int32_t)(rest + (((whole->value[axis][0] - rest) * p) >> 30) +
                                            (((whole->value[axis][1] - rest) * q) >> 30));
        }
        out->s[k] = (uint16_t)(sum >> 15);
    }
}

/* The channels over a part; 0 where it is too thin. Values are taken from corner 0's, in Q14 of 2^14 at most: of
 * differences up to 2^13, bulges are at most 2^28. */
static int set_channels(struct raster *r, const struct uv_corners *uv, const struct part_corner *const corner[3])
{
    struct shade_setup *setup = &r->setup;
    for (int axis = 0; axis < 2; axis++) {
        const int32_t *u = uv->value[axis];
        int32_t value[3], bulge[3];
        int64_t most = 0;
        int down = 8;
        for (int k = 0; k < 3; k++) {
            const int64_t d = (int64_t)u[k] - u[0];
            most |= d < 0 ? -d : d;
        }
        while (most >> down > (1 << 13) - 2)
            down++;
        for (int k = 0; k < 3; k++) {
            const int next = k == 2 ? 0 : k + 1;
            value[k] = (int32_t)(((int64_t)u[k] - u[0] + (1 << (down - 1))) >> down);
            bulge[k] = (int32_t) - ((((int64_t)u[k] - u[next]) * uv_ratio(uv->s[k], uv->s[next])) >> (15 + down));
        }
        if (!part_channel(setup, &r->input, corner, value, bulge, down - 16, &setup->uv[axis]))
            return 0;
        setup->uv[axis].p.f += (uint32_t)u[0];
    }
    return 1;
}

static void take_corners(const struct piece *piece, struct part_corner corner[3])
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++)
            corner[k].weight[i] = piece->weight[k][i];
}

/* Whether a part is off by more than is allowed. */
static int errs(const struct raster *r, const struct uv_corners *uv)
{
    const struct texture_spread spread = uv_spread(uv, &r->surface.texture);
    return texture_error(&spread, GLINT_TEXTURE_QUADRATIC) > PLAN_TEXTURE_SHARE(r->budget);
}

/* Part i of a split triangle: at a corner, or between the middles of the edges. In the parent's turn. */
static struct piece part_of(const struct piece *whole, unsigned i)
{
    static const uint8_t corner[4][3][2] = {
        {{0, 0}, {0, 1}, {0, 2}}, {{0, 1}, {1, 1}, {1, 2}}, {{0, 2}, {1, 2}, {2, 2}}, {{0, 1}, {1, 2}, {0, 2}}};
    struct piece part;
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 2; c++) {
            const unsigned a = whole->weight[corner[i][k][0]][c], b = whole->weight[corner[i][k][1]][c];
            part.weight[k][c] = (uint16_t)((a + b) >> 1); /* exact for as many halvings as there are */
        }
    part.next = 0;
    return part;
}

int split_begin(struct raster *r, const struct uv_corners *uv)
{
    struct plane *plane = &r->setup.plane;
    plane_setup_quadratic(plane);
    if (uv->distant || plane->thin)
        return 0;
    r->corners = *uv;
    r->setup.uv_kind = GLINT_TEXTURE_SPLIT;
    return 1;
}

/* A part as it is; perspective-correct where it cannot be split further, or is too thin for a quadratic. */
static uint32_t draw_part(struct raster *r, struct edges *e, runs_shade *shade, const struct uv_corners *uv,
                          const struct part_corner *const corner[3], const struct part_place place[3])
{
    uint32_t drawn = 0;
    if (!uv || !set_channels(r, uv, corner))
        uv_setup(&r->setup, &r->corners, GLINT_TEXTURE_PERSPECTIVE);
    do
        drawn += effects_draw(r, e, shade);
    while (fine_setup(e, place, r->width, r->height, e->last, r->y1));
    r->setup.uv_kind = GLINT_TEXTURE_SPLIT;
    return drawn;
}

uint32_t split_draw(struct raster *r, struct edges *e, runs_shade *shade)
{
    struct piece stack[SPLIT_DEPTH + 1], *top = stack;
    uint32_t drawn = 0;
    *top = (struct piece){{{PART_ONE, 0}, {0, PART_ONE}, {0, 0}}, 0};
    for (;;) {
        struct part_corner corner[3];
        const struct part_corner *const corners[3] = {&corner[0], &corner[1], &corner[2]};
        int more = 0;
        take_corners(top, corner);
        const struct part_place place[3] = {part_place(&r->input, &corner[0]), part_place(&r->input, &corner[1]),
                                            part_place(&r->input, &corner[2])};
        if (parts_shows(r, corners)) {
            struct uv_corners uv;
            find_corners(&r->corners, top, &uv);
            const int bad = errs(r, &uv);
            more = bad && top - stack < SPLIT_DEPTH && part_height(place) >= LEAST_HEIGHT;
            if (!more && fine_setup(e, place, r->width, r->height, r->y0, r->y1))
                drawn += draw_part(r, e, shade, bad ? 0 : &uv, corners, place);
        }
        top->next = more ? 0 : 4;
        for (; top->next == 4; top--)
            if (top == stack)
                return drawn;
        top[1] = part_of(top, top->next);
        top->next++;
        top++;
    }
}
