/* SPDX-License-Identifier: MIT */
/* Plans under one light without perspective, as most are: no loop, and each bound only where it can decide. */
#include "plan/plan.h"

#include "plan/parts.h"

/* What is known of the triangle; errors in Q8 of 1/255. */
struct facts {
    struct curve curve;
    struct curve_values l, h;    /* N.L, N.H */
    int lit, shines;             /* they show */
    uint32_t diffuse, specular;  /* coefficients */
    uint32_t most;               /* the highlight */
    uint32_t linear_l, linear_h; /* errors if linear */
};

/* (h) One colour, in the middle of what is possible, is off by half of that. */
static int is_constant(const struct facts *f, const struct plan_surface *s, struct shade_plan *plan)
{
    const int32_t low = f->l.low > 0 ? f->l.low : 0;
    uint32_t range = f->lit ? parts_scaled(f->diffuse, f->l.top - low) : 0, power[2] = {0, 0};
    if (range > 2u * s->budget)
        return 0;
    if (f->shines) {
        power[0] = parts_power(s, f->h.low > 0 ? f->h.low : 0);
        power[1] = parts_power(s, f->h.top);
        range += ((power[1] - power[0]) * f->specular >> 15) + 1;
        if (range > 2u * s->budget)
            return 0;
    }
    plan->level[0] = fx_u16(f->lit ? f->l.top + low : 0);
    plan->level[1] = fx_u16((power[0] + power[1]) / 2);
    plan->error = fx_u16((range + 1) / 2);
    return 1;
}

/* (i) Finished colours: on the dark side as both linear, on the bright side their chord; what is clamped at a corner is
 * missing beside it. */
static int is_gouraud(const struct facts *f, const struct plan_surface *s, struct shade_plan *plan)
{
    const uint32_t most = f->most + (f->lit ? parts_scaled(f->diffuse, f->l.top) : 0),
                   dark = f->linear_l + f->linear_h + (most > s->full ? most - s->full : 0);
    if (dark > s->budget)
        return 0;
    uint32_t bright = f->lit ? parts_scaled(f->diffuse, parts_lit_gap(&f->l)) : 0;
    if (bright + f->most > s->budget) { /* a chord is never above all there is */
        bright += parts_shine_gap(s, f->specular, &f->h);
        if (bright > s->budget)
            return 0;
    } else {
        bright += f->most;
    }
    plan->error = fx_u16(dark > bright ? dark : bright);
    return 1;
}

/* Both linear are within the budget: the highlight is left out if that is, too. */
static void take_linear(const struct facts *f, const struct plan_surface *s, struct shade_plan *plan)
{
    plan->rung = PLAN_LINEAR;
    plan->diffuse = fx_u8(f->lit);
    plan->specular = fx_u8(f->shines);
    plan->error = fx_u16(f->linear_l + f->linear_h);
    if (f->shines && f->linear_l + f->most <= s->budget) {
        plan->specular = 0;
        plan->dropped_highlights = 1;
        plan->error = fx_u16(f->linear_l + f->most);
    }
}

/* Both linear are not: one or both through six samples, without the highlight or with it, or Duff. */
static void take_six(const struct facts *f, const struct plan_surface *s, struct shade_plan *plan)
{
    const uint32_t budget = s->budget, never = 1u << 16;
    uint32_t six_l = 0, six_h = 0, error;
    /* between normals beyond 90 degrees, what Duff divides by is short, and what N.L is rounded by grows */
    plan->rung = s->sharp || !f->curve.lines || f->curve.sum > s->duff_sum ? PLAN_PHONG : PLAN_DUFF;
    if (!f->curve.lines)
        return;
    plan->diffuse = fx_u8(f->lit);
    plan->specular = fx_u8(f->shines);
    if (f->lit)
        six_l = parts_scaled(f->diffuse, curve_six(&f->curve, &f->l));
    if (six_l > f->linear_l) /* a bound may be the looser one of its kind */
        six_l = never;
    error = six_l + f->most;
    if (error <= budget) {
        plan->diffuse_bent = 1;
        plan->dropped_highlights = plan->specular;
        plan->specular = 0;
    } else if (!f->shines) {
        return;
    } else {
        six_h = parts_slack_above(s, f->specular, f->h.top, curve_six(&f->curve, &f->h));
        if ((error = f->linear_l + six_h) <= budget) {
            plan->specular_bent = 1;
        } else if ((error = six_l + f->linear_h) <= budget) {
            plan->diffuse_bent = 1;
        } else if ((error = six_l + six_h) <= budget) {
            plan->diffuse_bent = plan->specular_bent = 1;
        } else {
            return;
        }
    }
    plan->diffuse_bent &= plan->diffuse;
    plan->rung = plan->diffuse_bent | plan->specular_bent ? PLAN_SIX : PLAN_LINEAR;
    plan->error = fx_u16(error);
}

void plan_keep(struct shade_plan *plan)
{
    if (plan->rung == PLAN_CONSTANT || plan->rung == PLAN_GOURAUD || plan->rung == PLAN_PHONG)
        return;
    if (plan->rung == PLAN_DARK)
        plan->rung = PLAN_LINEAR;
    plan->diffuse |= plan->hidden_lights & 1;
    plan->specular |= plan->hidden_highlights & 1;
}

void plan_triangle(struct shade_plan *plan, const struct plan_surface *s, const struct plan_triangle *t)
{
    struct facts f;
    plan->none[0] = plan->none[1] = 0;
    plan->error = 0;
    if (s->lights != 1 || t->shift) {
        plan_several(plan, s, t);
        return;
    }
    const int16_t *const a = t->lights[0], *const b = t->lights[1], *const c = t->lights[2];
    f.diffuse = s->light[0].diffuse;
    f.specular = s->light[0].specular;
    f.l = curve_values(a[0], b[0], c[0]);
    f.lit = f.l.high > 0 && f.diffuse;
    f.shines = 0;
    f.most = f.linear_l = f.linear_h = 0;
    curve_setup(&f.curve, t->bend);
    if (f.lit) {
        curve_bound(&f.curve, &f.l);
        f.linear_l = parts_scaled(f.diffuse, f.l.linear);
    }
    f.h = curve_values(a[1], b[1], c[1]);
    if (f.h.high > 0 && f.specular) {
        curve_bound(&f.curve, &f.h);
        if (f.h.top >= s->foot) {
            f.shines = 1;
            f.most = parts_shine(s, f.specular, f.h.top) + 1;
            f.linear_h = parts_slack(s, f.specular, f.h.top, f.h.linear, f.most);
        }
    }
    plan->hidden_lights = fx_u8(!f.lit);
    plan->hidden_highlights = f.specular && !f.shines;
    const int finished = !s->apart || (!f.shines && (!f.lit || parts_scaled(f.diffuse, f.l.top) <= s->full));
    if (!f.lit && !f.shines)
        plan->rung = PLAN_DARK;
    else if (finished && is_constant(&f, s, plan))
        plan->rung = PLAN_CONSTANT;
    else if (f.linear_l + f.linear_h > s->budget)
        take_six(&f, s, plan);
    else if (finished && is_gouraud(&f, s, plan))
        plan->rung = PLAN_GOURAUD;
    else
        take_linear(&f, s, plan);
    if (t->keep)
        plan_keep(plan);
}
