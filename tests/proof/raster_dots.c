/* SPDX-License-Identifier: MIT */
/*
 * raster/dots.c: runs of any length under any lights that show, in grey and in colours, by the power's table and by
 * its forms, as they are and divided, with a texture's highlights apart or not.
 *
 *   proves: add find_values find_powers shade_channels dots_shade dots_run
 *   assumes: plane_values fx_power
 *   options: -eva-precision 0 -eva-min-loop-unroll 17 -warn-unsigned-overflow
 */
#include "proof.h"

#include "raster/raster.h"

/*@ requires there: \valid_read(plane) && \valid_read(channel) && 0 <= n <= RUN && \valid(out + (0 .. n - 1));
    assigns out[0 .. n - 1] \from indirect: *plane, indirect: *channel, indirect: x, indirect: y;
    ensures set: \initialized(out + (0 .. n - 1)); */
void plane_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out);

/*@ requires \valid_read(table);
    assigns \result \from indirect: *table, indirect: s;
    ensures \result <= 32768; */
static inline uint32_t fx_power(const struct fx_power *table, q30_t s);

#include "firmware/raster/dots.c"

static struct raster raster;

/* In place of shade/power.c and of divisions by W or by the length. */
static void run(unsigned n, int32_t *value, int count)
{
    for (int i = 0; i < count; i++)
        value[i] = any_s32(0, 32768);
}
static void run_folded(unsigned n, unsigned down, int32_t *value, int count)
{
    run(n, value, count);
}
static void divide(struct raster *r, int n)
{
    for (int i = 0; i < n; i++)
        r->value[0][i] = ANY_S32;
}

/* What a texture does not multiply starts at 0 (raster/effects.c). */
static void none_apart(void)
{
    for (int i = 0; i < RUN; i++)
        for (int c = 0; c < 3; c++)
            raster.apart[i][c] = 0;
}

static void lit(const struct glint_power *form, const struct fx_power *power, uint32_t *gloss)
{
    any_bytes(&raster, sizeof raster);
    raster.gloss = gloss;
    raster.surface.form = form;
    raster.surface.power = power;
    raster.surface.channels = any_flag() ? 1 : 3;
    raster.surface.lights = any_u32(0, SCENE_MAX_LIGHTS);
    for (int c = 0; c < 3; c++)
        raster.surface.base[c] = any_u32(0, 255 << 15);
    const int x = any_s32(0, 2047), y = any_s32(0, 2047);
    //@ loop unroll 17;
    for (int n = 0; n <= RUN; n++) {
        none_apart();
        dots_shade(&raster, x, y, n, divide);
        none_apart();
        dots_run(&raster, x, y, n);
    }
}

void prove(void)
{
    static const struct glint_power form = {run, 0, run_folded, 0};
    static struct fx_power power;
    any_bytes(&power, sizeof power);
    power.octave = any_u32(0, FX_POWER_MAX_OCTAVE);
    lit(0, &power, raster.sum[0]);
    lit(0, &power, raster.apart[0]);
    lit(&form, &power, raster.sum[0]);
    lit(&form, &power, raster.apart[0]);
}
