/* SPDX-License-Identifier: MIT */
/* Bump mapping: N'.L' and N'.H' of vectors that shade/bump.c has interpolated; clamp, power and sum per pixel. */
#include "plan/bump.h"
#include "raster/bump.h"
#include "raster/runs.h"
#include "shade/bump.h"

/* One dot product of the run in Q30, into r->value[0]. |N'| < 3/2 whatever the map, |L'| <= 7/6: below 2^31; halved in
 * the sum, as each term may reach 2^30. */
static void find_dots(struct raster *r, int x, int y, int n, const struct channel *channel)
{
    for (int axis = 0; axis < 3; axis++)
        plane_values(&r->setup.plane, &channel[axis], x, y, n, r->value[axis]);
    for (int i = 0; i < n; i++) {
        int32_t dot = 0;
        for (int axis = 0; axis < 3; axis++)
            dot += (r->value[axis][i] >> 15) * r->value[3 + axis][i];
        r->value[0][i] = dot * 2;
    }
}

/* The same over the vector's length. The largest component is first moved to 15 bits, as numerators of a perspective
 * may be small: with |v|^2 in [2^28, 3 * 2^30), |N'.v| < 3/2 * 2^14 |v| < 2^30.4, and less than 2^29.6 where the root
 * takes it twice. */
static void find_unit_dots(struct raster *r, int x, int y, int n, const struct channel *channel)
{
    for (int axis = 0; axis < 3; axis++)
        plane_values(&r->setup.plane, &channel[axis], x, y, n, r->value[axis]);
    for (int i = 0; i < n; i++) {
        int32_t v[3], dot = 0;
        uint32_t size = 1, squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            v[axis] = r->value[axis][i];
            size |= fx_u32(v[axis] ^ v[axis] >> 31);
        }
        const int32_t up = 1 << (fx_clz(size) - 1);
        for (int axis = 0; axis < 3; axis++) {
            v[axis] = v[axis] * up >> 16;
            squared += fx_u32(v[axis] * v[axis]);
            dot += v[axis] * r->value[3 + axis][i];
        }
        if (squared < 1u << 28) /* 0, between opposite corners */
            squared = 1u << 28;
        const unsigned twice = squared < 1u << 30; /* root of squared 4 */
        const int32_t inverse = fx_s32(fx_rsqrt_norm(squared << 2 * twice) >> 1);
        r->value[0][i] = fx_mulhi_s32(dot * (1 << twice), inverse) * 8;
    }
}

static inline __attribute__((always_inline)) void add(uint32_t *sum, uint32_t amount, const uint16_t *steps,
                                                      unsigned channels)
{
    for (unsigned c = 0; c < channels; c++) /* amount <= 7/4 in Q15, times 255 * 2^8: below 2^32 */
        sum[c] += surface_diffuse(amount, steps[c]);
}

static inline __attribute__((always_inline)) void add_diffuse(struct raster *r, int n, unsigned l, unsigned channels)
{
    uint32_t *sum = r->sum[0];
    for (int i = 0; i < n; i++, sum += 3)
        if (r->value[0][i] > 0)
            add(sum, fx_u32(r->value[0][i]) >> 15, r->surface.light[l].diffuse, channels);
}

/* The run's N'.H' to powers: by the table, or by another form. */
RUNS_APART static void find_powers(struct raster *r, int n)
{
    const struct glint_power *form = surface_form(&r->surface);
    if (form) {
        form->run(r->surface.power->exponent, r->value[0], n);
        return;
    }
    for (int i = 0; i < n; i++)
        r->value[0][i] = fx_s32(fx_power(r->surface.power, r->value[0][i]));
}

static inline __attribute__((always_inline)) void add_highlight(struct raster *r, int n, unsigned l, unsigned channels)
{
    uint32_t *sum = r->gloss;
    find_powers(r, n);
    for (int i = 0; i < n; i++, sum += 3)
        if (r->value[0][i])
            add(sum, fx_u32(r->value[0][i]), r->surface.light[l].specular, channels);
}

/* A template: `channels` and `normalised` are constant. */
static inline __attribute__((always_inline)) void shade(struct raster *r, int x, int y, int n, unsigned channels,
                                                        int normalised)
{
    const struct surface *s = &r->surface;
    const struct shade_setup *setup = &r->setup;
    const struct channel *channel = setup->bump;
    uint32_t *sum = r->sum[0];
    bump_normals(r, x, y, n);
    for (int i = 0; i < n; i++, sum += 3)
        for (unsigned c = 0; c < channels; c++)
            sum[c] = s->base[c];
    for (unsigned l = 0; l < surface_lights(s); l++, channel += BUMP_CHANNELS)
        for (int which = 0; which < 2; which++) {
            if (!((which ? shade_specular(setup) : setup->diffuse_lights) >> l & 1))
                continue;
            if (normalised)
                find_unit_dots(r, x, y, n, channel + BUMP_HALF * which);
            else
                find_dots(r, x, y, n, channel + BUMP_HALF * which);
            if (which)
                add_highlight(r, n, l, channels);
            else
                add_diffuse(r, n, l, channels);
        }
}

static void run_plain(struct raster *r, int x, int y, int n)
{
    if (surface_channels(&r->surface) == 1)
        shade(r, x, y, n, 1, 0);
    else
        shade(r, x, y, n, 3, 0);
}

static void run_normalised(struct raster *r, int x, int y, int n)
{
    if (surface_channels(&r->surface) == 1)
        shade(r, x, y, n, 1, 1);
    else
        shade(r, x, y, n, 3, 1);
}

static uint32_t draw_plain(struct raster *r, struct edges *e)
{
    if (USES(USES_GREY8) && r->setup.in_steps)
        return bump_grey(r, e);
    return runs_draw(r, e, run_plain);
}

static uint32_t draw_normalised(struct raster *r, struct edges *e)
{
    if (USES(USES_GREY8) && r->setup.in_steps)
        return bump_grey(r, e);
    return runs_draw(r, e, run_normalised);
}

/* A material without a map is drawn by the method that interpolates the same way: what is normalised, by Duff's where
 * that is per-pixel Phong. */
static const struct glint_method *choose_linear(struct raster *r)
{
    return surface_bumps(&r->surface) ? &glint_bump_linear : &glint_x;
}

static const struct glint_method *choose_quadratic(struct raster *r)
{
    return surface_bumps(&r->surface) ? &glint_bump_quadratic : &glint_six;
}

static const struct glint_method *choose_frames(struct raster *r)
{
    return surface_bumps(&r->surface) ? &glint_bump_frames : &glint_six;
}

static const struct glint_method *choose_upright(struct raster *r)
{
    return surface_bumps(&r->surface) ? &glint_bump_upright : &glint_six;
}

static const struct glint_method *choose_normalised(struct raster *r)
{
    if (surface_bumps(&r->surface))
        return &glint_bump_normalised;
    return r->input.divides || object_local(r->input.object) ? &glint_phong_perspective : &glint_duff;
}

const struct glint_method glint_bump_linear = {.id = GLINT_BUMP_LINEAR,
                                               .uses_tables = 1,
                                               .setup = shade_bump_linear,
                                               .draw = draw_plain,
                                               .choose = choose_linear,
                                               .run = run_plain,
                                               .colours = COLOURS_OF_DOTS};
const struct glint_method glint_bump_quadratic = {.id = GLINT_BUMP_QUADRATIC,
                                                  .uses_tables = 1,
                                                  .setup = shade_bump_quadratic,
                                                  .draw = draw_plain,
                                                  .choose = choose_quadratic,
                                                  .run = run_plain,
                                                  .colours = COLOURS_OF_DOTS};
const struct glint_method glint_bump_frames = {.id = GLINT_BUMP_QUADRATIC,
                                               .uses_tables = 1,
                                               .setup = shade_bump_frames,
                                               .draw = draw_plain,
                                               .choose = choose_frames,
                                               .run = run_plain,
                                               .colours = COLOURS_OF_DOTS};
const struct glint_method glint_bump_upright = {.id = GLINT_BUMP_QUADRATIC,
                                                .uses_tables = 1,
                                                .setup = shade_bump_upright,
                                                .draw = draw_plain,
                                                .choose = choose_upright,
                                                .run = run_plain,
                                                .colours = COLOURS_OF_DOTS};
const struct glint_method glint_bump_normalised = {.id = GLINT_BUMP_NORMALISED,
                                                   .uses_tables = 1,
                                                   .setup = shade_bump_normalised,
                                                   .draw = draw_normalised,
                                                   .choose = choose_normalised,
                                                   .run = run_normalised,
                                                   .colours = COLOURS_OF_DOTS};

const struct glint_method *bump_planned(struct raster *r)
{
    static const struct glint_method *const methods[] = {&glint_bump_linear, &glint_bump_quadratic,
                                                         &glint_bump_normalised};
    static const uint8_t rungs[] = {PLAN_LINEAR, PLAN_SIX, PLAN_PHONG};
    const struct shade_input *in = &r->input;
    const uint32_t shift = in->divides ? plan_shift(in->place) : 0;
    uint16_t bend[SCENE_MAX_LIGHTS][2][3];
    struct plan_bump sum = {0, 0};
    bump_bends(in, bend);
    for (unsigned i = 0; i < surface_lights(&r->surface); i++)
        plan_bump_light(&sum, &r->surface.plan, i, (const uint16_t(*)[3])bend[i], shift);
    r->input.plan = (struct shade_plan){0};
    const enum plan_bump_kind kind = plan_bump_choose(&sum, &r->surface.plan, &r->input.plan.error);
    r->input.plan.rung = rungs[kind];
    r->input.plan.undivided = in->divides && kind != PLAN_BUMP_NORMALISED;
    return methods[kind];
}
