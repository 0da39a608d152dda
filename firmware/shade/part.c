/* SPDX-License-Identifier: MIT */
#include "shade/part.h"

#include "shade/colour.h"

struct part_place part_place(const struct shade_input *in, const struct part_corner *corner)
{
    /* Places are below 2^14, weights sum to 2^15. */
    const int32_t u = corner->weight[0], v = corner->weight[1], w = fx_s32(PART_ONE) - u - v;
    const int16_t *a = in->place[0], *b = in->place[1], *c = in->place[2];
    return (struct part_place){u * a[0] + v * b[0] + w * c[0], u * a[1] + v * b[1] + w * c[1]};
}

void part_weights(const struct shade_input *in, const struct part_corner *corner, uint16_t weight[3])
{
    const uint32_t at[3] = {corner->weight[0], corner->weight[1], PART_ONE - corner->weight[0] - corner->weight[1]};
    uint32_t rest = PART_ONE;
    for (int i = 0; i < 3; i++) {
        uint32_t w = at[i];
        if (shade_weight(in)) { /* products of weights that sum to 2^15: at most 2^30 */
            w = at[0] * in->weight[0][i] + at[1] * in->weight[1][i] + at[2] * in->weight[2][i];
            w = i == 2 ? rest : w >> 15;
        }
        weight[i] = fx_u16(w);
        rest -= w;
    }
}

void part_shade(const struct shade_input *in, struct part_corner *corner)
{
    const struct surface *s = in->surface;
    const struct object_state *object = in->object;
    uint16_t weight[3];
    int32_t sum[3] = {0, 0, 0}, place[3] = {0, 0, 0};
    q14_t normal[3];
    int16_t lights[2 * SCENE_MAX_LIGHTS];
    part_weights(in, corner, weight);
    for (int k = 0; k < 3; k++) {
        const struct scene_vertex *vertex = &in->vertices[in->triangle->corner[SHADE_TURN(k)]];
        for (int i = 0; i < 3; i++) { /* below 2^15 (1 + 2^-13) times 2^15 */
            sum[i] += vertex->normal[i] * weight[k];
            place[i] += vertex->position[i] * weight[k];
        }
    }
    for (int i = 0; i < 3; i++) {
        sum[i] >>= 1; /* |normals| <= 2^14 (1 + 2^-13): below 2^29 (1 + 2^-13) */
        place[i] >>= 15;
    }
    object_unit(sum, normal);
    for (unsigned l = 0; l < surface_lights(s); l++) {
        q14_t towards[3], half[3];
        object_light_at(object, l, place, towards, half);
        if (!object_local(object))
            for (int i = 0; i < 3; i++)
                towards[i] = object->light[l].towards[i];
        lights[2 * l] = object_dot(normal, towards);
        lights[2 * l + 1] = object_dot(normal, half);
    }
    colour_finished(s, lights, corner->colour);
}

void part_whole(const struct shade_input *in, int k, struct part_corner *corner)
{
    corner->weight[0] = k == 0 ? PART_ONE : 0;
    corner->weight[1] = k == 1 ? PART_ONE : 0;
    if (shade_weight(in)) {
        part_shade(in, corner);
        return;
    }
    const uint16_t *colour = colour_corner(in, k);
    for (unsigned c = 0; c < surface_channels(in->surface); c++)
        corner->colour[c] = colour[c];
}

void part_between(const struct shade_input *in, const struct part_corner *a, const struct part_corner *b,
                  struct part_corner *out)
{
    for (int i = 0; i < 2; i++)
        out->weight[i] = fx_u16((a->weight[i] + b->weight[i]) >> 1);
    part_shade(in, out);
}

/* A part's corners 1 and 2 from corner 0, scaled as struct plane has it: the largest in [2^13, 2^14). */
struct shape {
    int32_t x1, y1, x2, y2;
    int scale; /* that of struct plane: from sub-pixels */
    int lost;  /* low bits are missing */
    int32_t det;
};

static uint32_t size_of(int32_t v)
{
    return fx_u32(v < 0 ? -v : v);
}

/* x 2^up or x 2^-down, rounded to 0: rounded down, -2^14 would be among them, whose square plane_quadratic() does not
 * hold. */
static int32_t scaled(int32_t x, int up, int down)
{
    x *= 1 << up;
    return (x + (x >> 31 & ((1 << down) - 1))) >> down;
}

static struct shape shape_of(const struct part_place p[3])
{
    /* differences of places: at most 2^30 */
    struct shape s = {p[1].x - p[0].x, p[1].y - p[0].y, p[2].x - p[0].x, p[2].y - p[0].y, 0, 0, 0};
    const uint32_t largest = size_of(s.x1) | size_of(s.y1) | size_of(s.x2) | size_of(s.y2);
    const int scale = largest ? fx_s32(fx_clz(largest)) - 18 : 0, down = scale < 0 ? -scale : 0,
              up = scale > 0 ? scale : 0;
    s.lost = ((s.x1 | s.y1 | s.x2 | s.y2) & ((1 << down) - 1)) != 0;
    s.x1 = scaled(s.x1, up, down);
    s.y1 = scaled(s.y1, up, down);
    s.x2 = scaled(s.x2, up, down);
    s.y2 = scaled(s.y2, up, down);
    s.scale = scale + 15;
    s.det = s.x1 * s.y2 - s.x2 * s.y1; /* that of a triangle in a box of 2^15: below 2^30 */
    return s;
}

/* The largest of both and half the other: the length or up to an eighth more. */
static uint32_t length_of(int32_t x, int32_t y)
{
    uint32_t a = size_of(x), b = size_of(y);
    return a > b ? a + b / 2 : b + a / 2;
}

static int32_t height_of(const struct shape *s)
{
    uint32_t a = length_of(s->x1, s->y1), b = length_of(s->x2, s->y2), c = length_of(s->x2 - s->x1, s->y2 - s->y1);
    a = a > b ? a : b;
    a = a > c ? a : c; /* below 2^16 */
    if (s->det <= 0)
        return 0;
    uint32_t height = fx_u32(s->det) / a;
    return fx_s32(s->scale >= 0 ? height >> s->scale : height << -s->scale);
}

int32_t part_height(const struct part_place p[3])
{
    const struct shape s = shape_of(p);
    return height_of(&s);
}

/* A part's plane, and how to come from its own origin to the set-up's. */
struct frame {
    struct plane plane;
    int32_t i, j;           /* its origin pixel from the set-up's */
    int32_t rest_x, rest_y; /* what plane.fx and fy lack, 2^-15 sub-pixels, at most half a sub-pixel */
    int32_t height;         /* part_height() */
    int lost;               /* the plane's corners have been rounded */
};

/* `at` in 2^-15 sub-pixels from the origin pixel's centre: the nearest pixel, and from `at` to its centre. */
static void nearest(int32_t at, int32_t *pixel, int32_t *sub, int32_t *rest)
{
    *pixel = (at + (1 << 18)) >> 19;
    int32_t to_centre = *pixel * (1 << 19) - at; /* at most 2^18 */
    *sub = (to_centre + (1 << 14)) >> 15;
    *rest = to_centre - *sub * (1 << 15);
}

/* 0 if the part has no area. Its own locals are not to lie on the stack with what follows. */
static __attribute__((noinline)) int frame_setup(struct frame *frame, const struct plane *whole,
                                                 const struct shade_input *in,
                                                 const struct part_corner *const corner[3])
{
    const struct part_place p[3] = {part_place(in, corner[0]), part_place(in, corner[1]), part_place(in, corner[2])};
    const struct shape shape = shape_of(p), *const s = &shape;
    struct plane *plane = &frame->plane;
    frame->height = height_of(s);
    frame->lost = s->lost;
    if (s->det <= 0)
        return 0;
    const int zeros = fx_s32(fx_clz(fx_u32(s->det)));
    plane->x1 = s->x1;
    plane->y1 = s->y1;
    plane->x2 = s->x2;
    plane->y2 = s->y2;
    plane->whole_x1 = (p[1].x - p[0].x) >> 15;
    plane->whole_y1 = (p[1].y - p[0].y) >> 15;
    plane->whole_x2 = (p[2].x - p[0].x) >> 15;
    plane->whole_y2 = (p[2].y - p[0].y) >> 15;
    plane->scale = s->scale;
    plane->det = s->scale >= 0 ? fx_u32(s->det) >> 2 * s->scale : fx_u32(s->det) << -2 * s->scale;
    plane->up = zeros + 2 * s->scale;
    plane->r = fx_recip_norm(fx_u32(s->det) << zeros);
    plane->half = fx_s32(plane->r >> 1);
    plane->shift = zeros + s->scale - 14;
    plane->sliver = 0;
    /* the set-up's origin from the picture's centre: at most 2^14 sub-pixels; differences 2^30 */
    nearest(p[0].x - (in->place[0][VERTEX_X] + whole->fx) * (1 << 15), &frame->i, &plane->fx, &frame->rest_x);
    nearest(p[0].y - (in->place[0][VERTEX_Y] + whole->fy) * (1 << 15), &frame->j, &plane->fy, &frame->rest_y);
    plane->ox = whole->ox + frame->i;
    plane->oy = whole->oy + frame->j;
    return 1;
}

/* The same polynomial from the set-up's origin. Slopes are below 2^31 a pixel. */
FX_WRAPS static void move(const struct frame *frame, struct polynomial *p)
{
    const uint32_t i = fx_wrap_u32(frame->i), j = fx_wrap_u32(frame->j);
    p->f += fx_wrap_u32(fx_mulhi_s32(fx_wrap_s32(p->d), frame->rest_x * (1 << 13)) +
                        fx_mulhi_s32(fx_wrap_s32(p->e), frame->rest_y * (1 << 13)));
    p->f += p->a * i * i + p->b * j * j + p->c * i * j - p->d * i - p->e * j;
    p->d -= 2 * p->a * i + p->c * j;
    p->e -= 2 * p->b * j + p->c * i;
}

/* Modulo 2^32, as all sums of a polynomial. */
FX_WRAPS static void scale_up(struct polynomial *p, int up)
{
    p->f <<= up;
    p->d <<= up;
    p->e <<= up;
    p->a <<= up;
    p->b <<= up;
    p->c <<= up;
}

/* What is lower than half a pixel: the mean in its middle, and along the main axis of its longest edge that one's
 * slope, if it is a pixel long; a slope is below 2^30 then, and values stay within 2^30 of the mean. */
static __attribute__((noinline)) void narrow(struct shade_setup *setup, const struct shade_input *in,
                                             const struct part_corner *const corner[3])
{
    const struct part_place p[3] = {part_place(in, corner[0]), part_place(in, corner[1]), part_place(in, corner[2])};
    const int32_t ox = (in->place[0][VERTEX_X] + setup->plane.fx) * (1 << 15),
                  oy = (in->place[0][VERTEX_Y] + setup->plane.fy) * (1 << 15); /* the origin */
    int from = 0, to = 0, steep = 0;
    int32_t longest = (1 << 19) - 1;
    for (int k = 0; k < 3; k++) {
        const int next = k == 2 ? 0 : k + 1;
        const int32_t x = p[next].x - p[k].x, y = p[next].y - p[k].y; /* at most 2^30 */
        const int32_t axis = size_of(y) > size_of(x) ? y : x;
        if (fx_s32(size_of(axis)) <= longest)
            continue;
        longest = fx_s32(size_of(axis));
        steep = axis == y;
        from = axis > 0 ? k : next;
        to = axis > 0 ? next : k;
    }
    const unsigned up = fx_clz(fx_u32(longest));
    const int64_t inverse = fx_recip_norm(fx_u32(longest) << up); /* 2^63 / longest 2^up, 1 <= up <= 12 */
    int64_t off = 0;                                              /* thrice the way from the middle to the origin */
    for (int k = 0; k < 3; k++)
        off += steep ? oy - fx_s64(p[k].y) : ox - fx_s64(p[k].x);
    for (unsigned c = 0; c < surface_channels(in->surface); c++) {
        const int32_t first = corner[from]->colour[c] >> 2, last = corner[to]->colour[c] >> 2;
        const int32_t sum = (corner[0]->colour[c] >> 2) + (corner[1]->colour[c] >> 2) + (corner[2]->colour[c] >> 2);
        const int64_t slope = (last - first) * inverse >> (28 - up); /* a pixel's, Q22 */
        struct channel *channel = &setup->channel[c];
        channel->exact = 0;
        channel->p = (struct polynomial){0, 0, 0, 0, 0, 0};
        channel->p.f = fx_wrap_u32(fx_divide_s64((fx_s64(sum) << 16) + (slope * off >> 19), 3)); /* 2^30 * 3 2^30 */
        *(steep ? &channel->p.e : &channel->p.d) = fx_wrap_u32(fx_s32(slope));
    }
}

/* What has been rounded can pass the corners' values: by 2^-9 of them where the height is 2^9 of the scaled units. */
#define MOST_UP_ROUNDED 5
/* plane.c's limit for quadratics. */
#define MOST_UP_QUADRATIC 9

int part_linear(struct shade_setup *setup, const struct shade_input *in, const struct part_corner *const corner[3],
                int fine)
{
    struct frame frame;
    const int any = frame_setup(&frame, &setup->plane, in, corner);
    /* Slopes: Q8 values over 2 pixels are 2^16 / 2 in Q16; Q6 over half a pixel the same. */
    if (fine && (!any || frame.height < 32 || (frame.lost && frame.plane.up - 2 * frame.plane.scale > MOST_UP_ROUNDED)))
        return 0;
    if (!any || frame.height < 8) {
        narrow(setup, in, corner);
        return 1;
    }
    for (unsigned c = 0; c < surface_channels(in->surface); c++) {
        int32_t value[3];
        for (int k = 0; k < 3; k++)
            value[k] = corner[k]->colour[c] >> (fine ? 0 : 2);
        plane_linear(&frame.plane, value, &setup->channel[c]);
        move(&frame, &setup->channel[c].p);
    }
    return 1;
}

static uint32_t shifted_down(uint32_t x, int down)
{
    return fx_u32(fx_s32(x) >> down);
}

static void scale_down(struct polynomial *p, int down)
{
    p->f = shifted_down(p->f, down);
    p->d = shifted_down(p->d, down);
    p->e = shifted_down(p->e, down);
    p->a = shifted_down(p->a, down);
    p->b = shifted_down(p->b, down);
    p->c = shifted_down(p->c, down);
}

int part_channel(const struct shade_setup *setup, const struct shade_input *in,
                 const struct part_corner *const corner[3], const int32_t value[3], const int32_t bulge[3], int up,
                 struct channel *channel)
{
    struct frame frame;
    if (!frame_setup(&frame, &setup->plane, in, corner))
        return 0;
    plane_setup_quadratic(&frame.plane);
    if (frame.height < 32 || frame.plane.up - 2 * frame.plane.scale > MOST_UP_QUADRATIC)
        return 0;
    frame.plane.thin = 0;
    plane_quadratic(&frame.plane, value, bulge, channel);
    if (up >= 0)
        scale_up(&channel->p, up);
    else
        scale_down(&channel->p, -up); /* here, where all of it fits 32 bits: from the set-up's origin it need not */
    move(&frame, &channel->p);
    return 1;
}

static int32_t rounded(uint16_t colour, int lost)
{
    return (colour + (1 << (lost - 1))) >> lost;
}

int part_quadratic(struct shade_setup *setup, const struct shade_input *in, const struct part_corner *const corner[3],
                   const struct part_corner middle[3])
{
    struct frame frame;
    if (!frame_setup(&frame, &setup->plane, in, corner))
        return 0;
    plane_setup_quadratic(&frame.plane);
    if (frame.height < 8 || frame.plane.up - 2 * frame.plane.scale > MOST_UP_QUADRATIC)
        return 0;
    frame.plane.thin = 0;
    /* Bends over 1 pixel's height are 4 times those over the 2 that plane_quadratic() is made for, over half a pixel 16
     * times: 2 or 4 bits less. Rounded, these still hold each sample within half of 1/255. */
    const int lost = frame.height < 16 ? 8 : frame.height < 32 ? 6 : 4;
    for (unsigned c = 0; c < surface_channels(in->surface); c++) {
        int32_t value[3], bulge[3];
        for (int k = 0; k < 3; k++)
            value[k] = rounded(corner[k]->colour[c], lost);
        for (int k = 0; k < 3; k++) {
            /* a = 2 (I1 + I2 - 2 I12): the values have 8 bits and 4, 2 or 0 of fraction, so that in Q28 of 2^14 it
             * stays within what plane_quadratic() takes, 4 * 255 * 2^4 * 2^14 < 2^28. */
            const int32_t ends = value[k] + value[k == 2 ? 0 : k + 1];
            bulge[k] = (ends - 2 * rounded(middle[k].colour[c], lost)) * (1 << 15);
        }
        plane_quadratic(&frame.plane, value, bulge, &setup->channel[c]);
        move(&frame, &setup->channel[c].p);
        scale_up(&setup->channel[c].p, lost - 2);
    }
    return 1;
}
