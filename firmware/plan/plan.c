/* SPDX-License-Identifier: MIT */
#include "plan/plan.h"

#include "plan/curve.h"

/* One dot product of a light that shows: what its part of the colour is off by, Q8 of 1/255. */
struct part {
    uint16_t none, linear, six; /* left out; linear; through six samples */
    uint8_t light, highlight;   /* which; highlight is 1 for N.H */
    uint8_t bent;               /* six is taken */
};

/* The work in hand. */
struct work {
    const struct plan_surface *s;
    const struct plan_triangle *t;
    struct curve curve;
    uint32_t shift;  /* how far perspective moves barycentric coordinates, Q16; 0: not at all */
    uint32_t linear; /* the sum of errors if all parts are linear */
    uint32_t chord;  /* of finished colours: how far their chord is above, so far of diffuse parts */
    uint32_t range;  /* from the least to the most that the parts can be, likewise */
    uint32_t most;   /* the most they can be */
    unsigned parts;
    struct part part[2 * SCENE_MAX_LIGHTS];
};

/* A coefficient (Q8) times a Q14 quantity of at most 1, rounded up. */
static inline uint32_t scaled(uint32_t coefficient, int32_t q14)
{
    return (coefficient * (uint32_t)q14 >> 14) + 1;
}

/* A highlight's part of the colour at N.H in Q14. */
static inline uint32_t shine(const struct plan_surface *s, unsigned light, int32_t h)
{
    return fx_power(s->power, (q30_t)((uint32_t)h << 16)) * s->light[light].specular >> 15;
}

/* How much a highlight can change while N.H moves by `by` below `top`: the power is convex, so most at the top (g). */
static inline uint32_t shine_slack(const struct plan_surface *s, unsigned light, int32_t top, int32_t by,
                                   uint32_t at_top)
{
    return at_top - shine(s, light, top > by ? top - by : 0) + 1;
}

/* The most that the chord of the highlight is above it on [low, high] (i): by its middle and its third quarter. */
static uint32_t shine_chord(const struct plan_surface *s, unsigned light, int32_t low, int32_t high)
{
    low = low > 0 ? low : 0;
    const uint32_t a = shine(s, light, low), b = shine(s, light, high);
    const uint32_t half = (a + b + 1) / 2 - shine(s, light, (low + high) >> 1);
    const uint32_t third = (a + 3 * b + 3) / 4 - shine(s, light, (low + 3 * high) >> 2);
    const uint32_t crossing = (8 * half + 4 * third) / 9 + 1, beyond = 2 * third > half ? 2 * third - half : 0;
    return crossing > beyond ? crossing : beyond;
}

static inline struct curve_values values(const struct work *w, unsigned index)
{
    int16_t *const *lights = w->t->lights;
    return curve_values(lights[0][index], lights[1][index], lights[2][index]);
}

/* Perspective moves a linear value by at most this, Q14: (range + 1) * shift < 2^15 * 2^16. */
static inline int32_t moved(const struct work *w, const struct curve_values *v)
{
    return w->shift ? (int32_t)((uint32_t)(v->high - v->low) * w->shift >> 16) + 1 : 0;
}

/* The gap between the corners' chord and max(0, .): ab / (a + b) <= min(a, b, (a + b) / 4) (i). */
static inline int32_t lit_chord(const struct curve_values *v)
{
    if (v->low >= 0)
        return 0;
    int32_t gap = (v->high - v->low) >> 2;
    gap = v->high < gap ? v->high : gap;
    return -v->low < gap ? -v->low : gap;
}

static inline void keep_part(struct work *w, unsigned index, uint32_t none, uint32_t linear)
{
    struct part *p = &w->part[w->parts++];
    p->none = (uint16_t)none; /* at most 255 and a rounding */
    p->linear = (uint16_t)linear;
    p->light = (uint8_t)(index >> 1);
    p->highlight = index & 1;
    p->bent = 0;
    w->most += none;
    w->linear += linear;
}

static inline void add_diffuse(struct work *w, struct shade_plan *plan, unsigned light)
{
    const uint32_t kd = w->s->light[light].diffuse;
    const struct curve_values v = values(w, 2 * light);
    plan->level[2 * light] = 0;
    if (v.high <= 0 || kd == 0) {
        plan->hidden_lights |= (uint8_t)(1u << light);
        return;
    }
    const int32_t linear = curve_linear(&w->curve, &v), top = curve_top(&w->curve, &v, linear),
                  low = v.low > 0 ? v.low : 0, by = linear + moved(w, &v);
    keep_part(w, 2 * light, scaled(kd, top), scaled(kd, by < 16384 ? by : 16384));
    w->chord += scaled(kd, lit_chord(&v));
    w->range += scaled(kd, top - low);
    plan->level[2 * light] = (uint16_t)(top + low);
}

static inline void add_highlight(struct work *w, struct shade_plan *plan, unsigned light)
{
    const struct plan_surface *s = w->s;
    const struct curve_values v = values(w, 2 * light + 1);
    plan->level[2 * light + 1] = 0;
    if (v.high > 0 && s->light[light].specular) {
        const int32_t linear = curve_linear(&w->curve, &v), top = curve_top(&w->curve, &v, linear);
        if (top >= s->foot) {
            const uint32_t most = shine(s, light, top) + 1;
            keep_part(w, 2 * light + 1, most, shine_slack(s, light, top, linear + moved(w, &v), most));
            return;
        }
    }
    plan->hidden_highlights |= (uint8_t)(1u << light);
}

/* (h) One colour, in the middle of what is possible, is off by half the range. */
static int is_constant(struct work *w, struct shade_plan *plan)
{
    uint32_t range = w->range;
    for (unsigned i = 0; i < w->parts && range <= 2u * w->s->budget; i++) {
        const struct part *p = &w->part[i];
        if (!p->highlight)
            continue;
        const struct curve_values v = values(w, 2u * p->light + 1);
        const uint32_t top = fx_power(w->s->power,
                                      (q30_t)((uint32_t)curve_top(&w->curve, &v, curve_linear(&w->curve, &v)) << 16)),
                       low = fx_power(w->s->power, (q30_t)((uint32_t)(v.low > 0 ? v.low : 0) << 16));
        range += p->none - (low * w->s->light[p->light].specular >> 15);
        plan->level[2 * p->light + 1] = (uint16_t)((top + low) / 2);
    }
    plan->error = (uint16_t)(range / 2 + 1);
    return plan->error <= w->s->budget;
}

/* (i) Finished colours: on the dark side as all parts linear, on the bright side their chord; and what is clamped at
 * the corners is missing between them. */
static int is_gouraud(struct work *w, struct shade_plan *plan)
{
    const struct plan_surface *s = w->s;
    const uint32_t over = w->most > s->full ? w->most - s->full : 0,
                   turn = w->shift ? (w->most * w->shift >> 16) + 1 : 0;
    uint32_t chord = w->chord;
    for (unsigned i = 0; i < w->parts && chord <= s->budget; i++) {
        const struct part *p = &w->part[i];
        if (!p->highlight)
            continue;
        if (p->none + chord <= s->budget) { /* never above what it is */
            chord += p->none;
            continue;
        }
        const struct curve_values v = values(w, 2u * p->light + 1);
        chord += shine_chord(s, p->light, v.low, v.high);
    }
    const uint32_t dark = w->linear + over, error = (dark > chord ? dark : chord) + turn;
    plan->error = (uint16_t)error;
    return error <= s->budget;
}

/* What perspective adds to a curved value (p): shift (range g + 2 h kB g^3), with g = 1 / |N| at most. */
static int32_t moved_curved(const struct work *w, const struct curve_values *v)
{
    if (!w->shift)
        return 0;
    const uint32_t g = (w->curve.stretch >> 7) + 257, cube = (g * g >> 8) * g >> 8; /* Q8: below 2^9, 2^11 */
    const uint32_t curl = ((uint32_t)v->high * w->curve.bend >> 15) + 1;            /* 2 h kB, below 2^14.1 */
    const uint32_t sum = ((uint32_t)(v->high - v->low) * g + curl * cube) >> 8;     /* below 2^17.3 */
    return (int32_t)((sum >> 2) * (w->shift >> 2) >> 12) + 2;
}

/* The error of a part whose curved value is off by `by`. */
static uint32_t curved_error(const struct work *w, const struct part *p, const struct curve_values *v, int32_t by)
{
    if (!p->highlight)
        return scaled(w->s->light[p->light].diffuse, by < 16384 ? by : 16384);
    int32_t top = curve_top(&w->curve, v, curve_linear(&w->curve, v)) + by;
    top = top < 16384 ? top : 16384;
    return shine_slack(w->s, p->light, top, by, shine(w->s, p->light, top) + 1);
}

/* Of the parts, bends those that gain most until the budget is kept; 0 if it cannot be. */
static int bend_parts(struct work *w)
{
    uint32_t total = w->linear;
    if (!w->curve.lines)
        return 0;
    for (unsigned i = 0; i < w->parts; i++) {
        struct part *p = &w->part[i];
        const struct curve_values v = values(w, 2u * p->light + p->highlight);
        p->six = (uint16_t)curved_error(w, p, &v, curve_six(&w->curve, &v) + moved_curved(w, &v));
    }
    while (total > w->s->budget) {
        struct part *best = 0;
        for (unsigned i = 0; i < w->parts; i++) {
            struct part *p = &w->part[i];
            if (!p->bent && p->six < p->linear && (!best || p->linear - p->six > best->linear - best->six))
                best = p;
        }
        if (!best)
            return 0;
        best->bent = 1;
        total -= best->linear - best->six;
    }
    w->linear = total;
    return 1;
}

/* Which dot products are computed, and how; highlights that the rest of the budget allows are left out. */
static void decide_parts(const struct work *w, struct shade_plan *plan)
{
    uint32_t total = w->linear;
    plan->rung = PLAN_LINEAR;
    for (unsigned i = w->parts; i-- > 0;) {
        const struct part *p = &w->part[i];
        const uint8_t bit = (uint8_t)(1u << p->light);
        const uint32_t rest = total - (p->bent ? p->six : p->linear);
        if (!p->highlight) {
            plan->diffuse |= bit;
            plan->diffuse_bent |= p->bent ? bit : 0;
        } else if (rest + p->none <= w->s->budget) {
            total = rest + p->none;
            plan->dropped_highlights |= bit;
            continue;
        } else {
            plan->specular |= bit;
            plan->specular_bent |= p->bent ? bit : 0;
        }
        if (p->bent)
            plan->rung = PLAN_SIX;
    }
    plan->error = (uint16_t)total;
}

/* Per-pixel Phong of far lights, by Duff's denominator, on the screen or in space. */
static void take_phong(const struct work *w, struct shade_plan *plan)
{
    uint32_t total = 0;
    for (unsigned i = 0; i < w->parts && w->shift; i++) {
        const struct curve_values v = values(w, 2u * w->part[i].light + w->part[i].highlight);
        total += w->curve.lines ? curved_error(w, &w->part[i], &v, moved_curved(w, &v)) : 65535;
    }
    plan->rung = total > w->s->budget ? PLAN_PHONG : PLAN_DUFF;
    plan->error = (uint16_t)(total > w->s->budget ? 0 : total);
}

/* (p) How far perspective moves barycentric coordinates over a triangle of these depths: (1 - r) / (1 + r) for the
 * root r of the depths' ratio, at most (a - b) / (4 b). Q16; a rounding of each depth included. */
static uint32_t shift_of(const struct plan_triangle *t)
{
    if (!t->divides)
        return 0;
    uint32_t most = (uint16_t)t->place[0][VERTEX_DEPTH], least = most;
    for (int k = 1; k < 3; k++) {
        const uint32_t depth = (uint16_t)t->place[k][VERTEX_DEPTH];
        most = depth > most ? depth : most;
        least = depth < least ? depth : least;
    }
    if (least < DEPTH_FAR + 256)
        return 1u << 16;
    const uint32_t shift = ((most - least + 1) << 14) / (least - DEPTH_FAR - 1) + 1; /* below 2^31 */
    return shift < 1u << 16 ? shift : 1u << 16;
}

void plan_triangle(struct shade_plan *plan, const struct plan_surface *s, const struct plan_triangle *t)
{
    struct work w; /* its parts are filled as they come */
    plan->diffuse = plan->specular = plan->diffuse_bent = plan->specular_bent = 0;
    plan->hidden_lights = plan->hidden_highlights = plan->dropped_highlights = plan->undivided = 0;
    plan->error = 0;
    if (t->local) { /* the corner values say nothing of what lies between: unit vectors of each place differ */
        plan->rung = PLAN_PHONG;
        return;
    }
    w.s = s;
    w.t = t;
    w.linear = w.chord = w.range = w.most = 0;
    w.parts = 0;
    w.shift = shift_of(t);
    curve_setup(&w.curve, t->bend);
    for (unsigned i = 0; i < s->lights; i++) {
        add_diffuse(&w, plan, i);
        if (s->highlights)
            add_highlight(&w, plan, i);
    }
    if (!w.parts)
        plan->rung = t->keep ? PLAN_LINEAR : PLAN_DARK;
    else if (w.range <= 2u * s->budget && is_constant(&w, plan))
        plan->rung = PLAN_CONSTANT;
    else if (w.linear <= s->budget && is_gouraud(&w, plan))
        plan->rung = PLAN_GOURAUD;
    else if (w.linear <= s->budget || bend_parts(&w))
        decide_parts(&w, plan);
    else
        take_phong(&w, plan);
    if (t->keep && plan->rung <= PLAN_SIX) {
        plan->diffuse |= plan->hidden_lights;
        plan->specular |= plan->hidden_highlights;
    }
    plan->undivided = t->divides && plan->rung > PLAN_CONSTANT && plan->rung < PLAN_PHONG;
}
