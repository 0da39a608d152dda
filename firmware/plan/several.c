/* SPDX-License-Identifier: MIT */
/* Plans under several lights, and in perspective. */
#include "plan/parts.h"

#define DUFF_MOST_SHIFT (1u << 14) /* plan_shift() of depths 1 : 2 */

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
    uint32_t linear; /* the sum of errors if all parts are linear */
    uint32_t most;   /* the most that the parts can add */
    unsigned parts;
    struct part part[2 * SCENE_MAX_LIGHTS];
};

static struct curve_values values(const struct work *w, unsigned light, unsigned highlight)
{
    const int16_t *const *lights = w->t->lights;
    const unsigned index = 2 * light + highlight;
    struct curve_values v = curve_values(lights[0][index], lights[1][index], lights[2][index]);
    if (v.high > 0)
        curve_bound(&w->curve, &v);
    return v;
}

static uint32_t coefficient(const struct work *w, unsigned light, unsigned highlight)
{
    return highlight ? w->s->light[light].specular : w->s->light[light].diffuse;
}

/* (p) What perspective adds to a linear value: (range + 1) * shift <= 2^31. */
static int32_t moved(const struct work *w, const struct curve_values *v)
{
    return w->t->shift ? fx_s32(fx_u32(v->high - v->low) * w->t->shift >> 16) + 1 : 0;
}

/* (p) And to a curved one: shift (range g + 2 h kB g^3), g the largest 1 / |N|. */
static int32_t moved_curved(const struct work *w, const struct curve_values *v)
{
    if (!w->t->shift)
        return 0;
    const uint32_t g = (w->curve.stretch >> 7) + 257, cube = (g * g >> 8) * g >> 8; /* Q8: below 2^9, 2^11 */
    const uint32_t curl = (fx_u32(v->high) * w->curve.bend >> 15) + 1;              /* 2 h kB, below 2^14.1 */
    const uint32_t sum = (fx_u32(v->high - v->low) * g + curl * cube) >> 8;         /* below 2^17.3 */
    return fx_s32((sum >> 2) * (w->t->shift >> 2) >> 12) + 2;
}

static void keep_part(struct work *w, unsigned light, unsigned highlight, uint32_t none, uint32_t linear)
{
    w->part[w->parts++] = (struct part){fx_u16(none), fx_u16(linear), 0, fx_u8(light), fx_u8(highlight), 0};
    w->most += none;
    w->linear += linear;
}

static void add_parts(struct work *w, struct shade_plan *plan, unsigned light)
{
    const struct plan_surface *s = w->s;
    const uint32_t diffuse = coefficient(w, light, 0), specular = coefficient(w, light, 1);
    const struct curve_values l = values(w, light, 0), h = values(w, light, 1);
    if (l.high > 0 && diffuse)
        keep_part(w, light, 0, parts_scaled(diffuse, l.top), parts_scaled(diffuse, l.linear + moved(w, &l)));
    else
        plan->hidden_lights |= fx_u8(1u << light);
    if (h.high > 0 && specular && h.top >= s->foot) {
        const uint32_t most = parts_shine(s, specular, h.top) + 1;
        keep_part(w, light, 1, most, parts_slack(s, specular, h.top, h.linear + moved(w, &h), most));
    } else if (specular) {
        plan->hidden_highlights |= fx_u8(1u << light);
    }
}

/* (h) One colour, in the middle of what is possible, is off by half of that. */
static int is_constant(const struct work *w, struct shade_plan *plan)
{
    uint32_t range = 0;
    for (unsigned i = 0; i < 2u * w->s->lights; i++)
        plan->level[i] = 0;
    for (unsigned i = 0; i < w->parts; i++) {
        const struct part *p = &w->part[i];
        const struct curve_values v = values(w, p->light, p->highlight);
        uint32_t low = v.low > 0 ? fx_u32(v.low) : 0, high = fx_u32(v.top);
        if (p->highlight) {
            low = parts_power(w->s, fx_s32(low));
            high = parts_power(w->s, fx_s32(high));
        } else {
            low *= 2;
            high *= 2; /* Q15 */
        }
        range += ((high - low) * coefficient(w, p->light, p->highlight) >> 15) + 1;
        if (range > 2u * w->s->budget)
            return 0;
        plan->level[2 * p->light + p->highlight] = fx_u16((low + high) / 2);
    }
    plan->error = fx_u16((range + 1) / 2);
    return 1;
}

/* (i) Finished colours: on the dark side as all parts linear, on the bright side their chords; what is clamped at a
 * corner is missing beside it; and perspective moves what all parts add. */
static int is_gouraud(const struct work *w, struct shade_plan *plan)
{
    const struct plan_surface *s = w->s;
    const uint32_t over = w->most > s->full ? w->most - s->full : 0,
                   turn = w->t->shift ? ((w->most >> 2) * (w->t->shift >> 2) >> 12) + 2 : 0;
    uint32_t bright = 0;
    for (unsigned i = 0; i < w->parts; i++) {
        const struct part *p = &w->part[i];
        const struct curve_values v = values(w, p->light, p->highlight);
        const uint32_t by = coefficient(w, p->light, p->highlight),
                       gap = p->highlight ? parts_shine_gap(s, by, &v) : parts_scaled(by, parts_lit_gap(&v));
        bright += gap < p->none ? gap : p->none; /* a chord is never above all there is */
        if (bright > s->budget)
            return 0;
    }
    const uint32_t dark = w->linear + over, error = (dark > bright ? dark : bright) + turn;
    plan->error = fx_wrap_u16(error); /* of no account beyond the budget: another rung's takes its place */
    return error <= s->budget;
}

/* The error of a part whose curved value is off by `by`. */
static uint32_t curved_error(const struct work *w, const struct part *p, const struct curve_values *v, int32_t by)
{
    const uint32_t factor = coefficient(w, p->light, p->highlight);
    return p->highlight ? parts_slack_above(w->s, factor, v->top, by) : parts_scaled(factor, by);
}

/* Bends, of the parts, those that gain most until the budget is kept; 0 if it cannot be. */
static int bend_parts(struct work *w)
{
    if (!w->curve.lines)
        return 0;
    for (unsigned i = 0; i < w->parts; i++) {
        struct part *p = &w->part[i];
        const struct curve_values v = values(w, p->light, p->highlight);
        p->six = fx_u16(curved_error(w, p, &v, curve_six(&w->curve, &v) + moved_curved(w, &v)));
    }
    while (w->linear > w->s->budget) {
        struct part *best = 0;
        for (unsigned i = 0; i < w->parts; i++) {
            struct part *p = &w->part[i];
            if (!p->bent && p->six < p->linear && (!best || p->linear - p->six > best->linear - best->six))
                best = p;
        }
        if (!best)
            return 0;
        best->bent = 1;
        w->linear -= fx_u32(best->linear) - best->six;
    }
    return 1;
}

/* Which dot products are computed, and how; highlights that the rest of the budget allows are left out. */
static void take_parts(const struct work *w, struct shade_plan *plan)
{
    uint32_t total = w->linear;
    plan->rung = PLAN_LINEAR;
    for (unsigned left = w->parts; left > 0; left--) {
        const struct part *p = &w->part[left - 1];
        const uint8_t bit = fx_u8(1u << p->light);
        const uint32_t rest = total - (p->bent ? p->six : p->linear);
        if (p->highlight && rest + p->none <= w->s->budget) {
            total = rest + p->none;
            plan->dropped_highlights |= bit;
            continue;
        }
        *(p->highlight ? &plan->specular : &plan->diffuse) |= bit;
        if (p->bent) {
            *(p->highlight ? &plan->specular_bent : &plan->diffuse_bent) |= bit;
            plan->rung = PLAN_SIX;
        }
    }
    plan->error = fx_u16(total);
}

/* What the weights of perspective-correct Duff are rounded by: less than 2^-14 of N.L and N.H (shade/planned.c). */
static uint32_t weights_error(const struct work *w)
{
    uint32_t sum = 0;
    for (unsigned i = 0; i < w->parts; i++) {
        const struct part *p = &w->part[i]; /* a power's slope is at most n < 2^12 */
        sum += (coefficient(w, p->light, p->highlight) * (p->highlight ? w->s->power->exponent : 1u) >> 14) + 1;
    }
    return sum;
}

/* Per-pixel Phong by Duff's denominator, on the screen if that is not seen; else by normals as long as their corners
 * are close, unless depths differ by more than 1 : 2, where they would be short. */
static void take_phong(const struct work *w, struct shade_plan *plan)
{
    uint32_t total = 0;
    for (unsigned i = 0; i < w->parts && w->t->shift; i++) {
        const struct part *p = &w->part[i];
        const struct curve_values v = values(w, p->light, p->highlight);
        total += w->curve.lines ? curved_error(w, p, &v, moved_curved(w, &v)) : 1u << 16;
    }
    plan->undivided = w->t->shift && total <= w->s->budget;
    if (total > w->s->budget && w->t->shift <= DUFF_MOST_SHIFT)
        total = weights_error(w);
    plan->rung = PLAN_DUFF;
    if (total > w->s->budget || w->s->sharp || !w->curve.lines) /* Phong, too, goes by runs: no duff_sum */
        plan->rung = PLAN_PHONG;
    for (unsigned i = 0; i < w->parts; i++)
        *(w->part[i].highlight ? &plan->specular : &plan->diffuse) |= fx_u8(1u << w->part[i].light);
    if (plan->rung == PLAN_PHONG)
        plan->undivided = 0, total = 0;
    plan->error = fx_u16(total);
}

uint32_t plan_shift(const int16_t *const place[3])
{
    uint32_t most = fx_wrap_u16(place[0][VERTEX_DEPTH]), least = most;
    for (int k = 1; k < 3; k++) {
        const uint32_t depth = fx_wrap_u16(place[k][VERTEX_DEPTH]);
        most = depth > most ? depth : most;
        least = depth < least ? depth : least;
    }
    if (least < DEPTH_FAR + 256)
        return 1u << 16;
    /* of depths a > b, a rounding each included: below 2^31 */
    const uint32_t shift = ((most - least + 1) << 14) / (least - DEPTH_FAR - 1) + 1;
    return shift < 1u << 16 ? shift : 1u << 16;
}

/* Whether colours may be finished where a texel is to multiply them: no highlight shows, and nothing is clamped. */
static int is_finished(const struct work *w)
{
    for (unsigned i = 0; i < w->parts; i++)
        if (w->part[i].highlight)
            return 0;
    return w->most <= w->s->full;
}

void plan_several(struct shade_plan *plan, const struct plan_surface *s, const struct plan_triangle *t)
{
    struct work w; /* its parts are filled as they come */
    w.s = s;
    w.t = t;
    w.linear = w.most = 0;
    w.parts = 0;
    plan->none[0] = plan->none[1] = 0;
    plan->error = 0;
    curve_setup(&w.curve, t->bend);
    for (unsigned i = 0; i < s->lights; i++)
        add_parts(&w, plan, i);
    const int finished = !s->apart || is_finished(&w);
    if (!w.parts)
        plan->rung = PLAN_DARK;
    else if (finished && is_constant(&w, plan))
        plan->rung = PLAN_CONSTANT;
    else if (finished && w.linear <= s->budget && is_gouraud(&w, plan))
        plan->rung = PLAN_GOURAUD;
    else if (w.linear <= s->budget || bend_parts(&w))
        take_parts(&w, plan);
    else
        take_phong(&w, plan);
    if (t->shift && plan->rung > PLAN_CONSTANT && plan->rung < PLAN_DUFF)
        plan->undivided = 1;
    if (t->keep)
        plan_keep(plan);
}
