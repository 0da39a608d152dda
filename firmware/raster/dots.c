/* SPDX-License-Identifier: MIT */
#include "raster/dots.h"

/* Adds `amount` (Q15) of a light's colour (Q8 steps at full) to a pixel: at most 1.0887 * 2^15 * 255 * 2^8 < 2^32. */
static inline __attribute__((always_inline)) void add(uint32_t *sum, uint32_t amount, const uint16_t *steps,
                                                      unsigned channels)
{
    for (unsigned c = 0; c < channels; c++)
        sum[c] += surface_diffuse(amount, steps[c]);
}

/* One dot product of the run into r->value[0]. */
static void find_values(struct raster *r, int x, int y, int n, unsigned channel, dots_divide *divide)
{
    plane_values(&r->setup.plane, &r->setup.channel[channel], x, y, n, r->value[0]);
    if (divide)
        divide(r, n);
}

/* The run's N.H to powers by another form than the table. */
static void find_powers(struct raster *r, int n)
{
    const struct surface *s = &r->surface;
    if (r->setup.folded)
        s->form->run_folded(s->power->exponent, r->setup.folded, r->value[0], n);
    else
        s->form->run(s->power->exponent, r->value[0], n);
}

/* A template: `channels` is constant. */
static inline __attribute__((always_inline)) void shade_channels(struct raster *r, int x, int y, int n,
                                                                 unsigned channels, dots_divide *divide)
{
    const struct surface *s = &r->surface;
    const struct shade_setup *setup = &r->setup;
    uint32_t *sum = r->sum[0];
    for (int i = 0; i < n; i++, sum += 3)
        for (unsigned c = 0; c < channels; c++)
            sum[c] = s->base[c];
    for (unsigned l = 0; l < surface_lights(s); l++) {
        if (setup->diffuse_lights >> l & 1) {
            find_values(r, x, y, n, 2 * l, divide);
            sum = r->sum[0];
            for (int i = 0; i < n; i++, sum += 3)
                if (r->value[0][i] > 0)
                    add(sum, fx_u32(r->value[0][i]) >> 15, s->light[l].diffuse, channels);
        }
        if (shade_specular(setup) >> l & 1) {
            find_values(r, x, y, n, 2 * l + 1, divide);
            sum = raster_gloss(r);
            if (surface_form(s)) {
                find_powers(r, n);
                for (int i = 0; i < n; i++, sum += 3)
                    add(sum, fx_u32(r->value[0][i]), s->light[l].specular, channels);
                continue;
            }
            for (int i = 0; i < n; i++, sum += 3) {
                uint32_t power = fx_power(s->power, r->value[0][i]);
                if (power)
                    add(sum, power, s->light[l].specular, channels);
            }
        }
    }
}

void dots_shade(struct raster *r, int x, int y, int n, dots_divide *divide)
{
    if (surface_channels(&r->surface) == 1)
        shade_channels(r, x, y, n, 1, divide);
    else
        shade_channels(r, x, y, n, 3, divide);
}

void dots_run(struct raster *r, int x, int y, int n)
{
    dots_shade(r, x, y, n, 0);
}
