/* SPDX-License-Identifier: MIT */
#include "raster/split.h"

#include "raster/effects.h"
#include "raster/fine.h"
#include "shade/part.h"

#define LEAST_HEIGHT 64 /* sub-pixels: what is lower is not split, so that its parts, half as high, have quadratics */

/* A triangle that is or may be split: its corners' weights, as struct part_corner has them. */
struct piece {
    uint16_t weight[3][2];
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
        const int32_t p = fx_s32(fx_mulhi_u32(wa << up, inverse) >> 1);
        const int32_t q = fx_s32(fx_mulhi_u32(wb << up, inverse) >> 1);
        for (int axis = 0; axis < 2; axis++) { /* differences of Q28 below 2^32, p + q <= 2^30: rounded down once */
            const int64_t rest = whole->value[axis][2];
            out->value[axis][k] =
                fx_s32(rest + (((whole->value[axis][0] - rest) * p + (whole->value[axis][1] - rest) * q) >> 30));
        }
        out->s[k] = fx_u16(sum >> 15);
    }
}

/* What a channel over a part is made of: values from corner 0's on, in Q14 of 2^13 at most, and bulges in Q28, which of
 * differences up to 2^13 are at most 2^28; of the edge 1-2, with twice the difference, 2^29; both times 2^up. */
struct terms {
    int32_t value[3], bulge[3];
    int up;
};

static __attribute__((noinline)) void find_terms(struct terms *terms, const struct uv_corners *uv, int axis)
{
    const int32_t *u = uv->value[axis];
    int64_t most = 0;
    int down = 8;
    for (int k = 0; k < 3; k++) {
        const int64_t d = fx_s64(u[k]) - u[0];
        most |= d < 0 ? -d : d;
    }
    while (most >> down > (1 << 13) - 2)
        down++;
    for (int k = 0; k < 3; k++) {
        const int next = k == 2 ? 0 : k + 1;
        terms->value[k] = fx_s32((fx_s64(u[k]) - u[0] + (1 << (down - 1))) >> down);
        terms->bulge[k] = fx_s32(-(((fx_s64(u[k]) - u[next]) * uv_ratio(uv->s[k], uv->s[next])) >> (15 + down)));
    }
    terms->up = down - 16;
}

static void take_corners(const struct piece *piece, struct part_corner corner[3])
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++)
            corner[k].weight[i] = piece->weight[k][i];
}

/* Whether a part is off by more than is allowed. Its frame, and the next one's, are not to lie on the stack while
 * pixels are drawn. */
static __attribute__((noinline)) int errs(const struct raster *r, const struct piece *piece)
{
    struct uv_corners uv;
    find_corners(&r->corners, piece, &uv);
    const struct texture_spread spread = uv_spread(&uv, &r->surface.texture);
    return texture_error(&spread, GLINT_TEXTURE_QUADRATIC) > PLAN_TEXTURE_SHARE(r->budget);
}

/* Channels over a part; perspective-correct where it cannot be split further, or is too thin for a quadratic. */
static __attribute__((noinline)) void set_part(struct raster *r, const struct piece *piece, int bad)
{
    struct uv_corners uv;
    struct part_corner corner[3];
    const struct part_corner *const corners[3] = {&corner[0], &corner[1], &corner[2]};
    find_corners(&r->corners, piece, &uv);
    take_corners(piece, corner);
    r->setup.uv_kind = GLINT_TEXTURE_SPLIT;
    for (int axis = 0; axis < 2 && !bad; axis++) {
        struct terms terms;
        find_terms(&terms, &uv, axis);
        struct channel *channel = &r->setup.uv[axis];
        bad = !part_channel(&r->setup, &r->input, corners, terms.value, terms.bulge, terms.up, channel);
        fx_wrap_inc(&channel->p.f, fx_wrap_u32(uv.value[axis][0]));
    }
    if (bad)
        uv_setup_corners(&r->setup, &r->corners, GLINT_TEXTURE_PERSPECTIVE);
}

static __attribute__((noinline)) void take_places(const struct raster *r, const struct piece *piece,
                                                  struct part_place place[3])
{
    struct part_corner corner[3];
    take_corners(piece, corner);
    for (int k = 0; k < 3; k++)
        place[k] = part_place(&r->input, &corner[k]);
}

/* 1 if it has a row in the band. */
static int shows(const struct raster *r, const struct part_place p[3])
{
    int32_t top = p[0].y < p[1].y ? p[0].y : p[1].y, bottom = p[0].y > p[1].y ? p[0].y : p[1].y;
    top = p[2].y < top ? p[2].y : top;
    bottom = p[2].y > bottom ? p[2].y : bottom;
    return fine_row(bottom, r->height) > r->y0 && fine_row(top, r->height) < r->y1;
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
            part.weight[k][c] = fx_u16((a + b) >> 1); /* exact for as many halvings as there are */
        }
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

/* The part that a way down from the whole triangle leads to, two bits a level. */
static __attribute__((noinline)) void find_piece(struct piece *piece, unsigned depth, unsigned way)
{
    *piece = (struct piece){{{PART_ONE, 0}, {0, PART_ONE}, {0, 0}}};
    for (; depth > 0; depth--)
        *piece = part_of(piece, way >> (2 * depth - 2) & 3);
}

uint32_t split_draw(struct raster *r, struct edges *e, runs_shade *shade)
{
    unsigned depth = 0, way = 0;
    uint32_t drawn = 0;
    for (;;) {
        struct piece piece;
        struct part_place place[3];
        int more = 0;
        find_piece(&piece, depth, way);
        take_places(r, &piece, place);
        if (shows(r, place)) {
            const int bad = errs(r, &piece);
            more = bad && depth < SPLIT_DEPTH && part_height(place) >= LEAST_HEIGHT;
            if (!more) {
                set_part(r, &piece, bad);
                for (int32_t row = r->y0; fine_setup(e, place, r->width, r->height, row, r->y1); row = e->last)
                    drawn += effects_draw(r, e, shade);
            }
        }
        if (more) {
            depth++;
            way <<= 2;
            continue;
        }
        for (; depth && (way & 3) == 3; depth--)
            way >>= 2;
        if (!depth)
            return drawn;
        way++;
    }
}
