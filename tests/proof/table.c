/* SPDX-License-Identifier: MIT */
/*
 * raster/table.c: the tables of any material under any light, made, found, and found made; what they cost.
 *
 *   proves: made_for diffuse_of make_colours make_highlights make table_bytes table_at table_clear table_find
 *           table_error
 *   assumes: fx_power
 *   options: -eva-precision 0 -eva-slevel 0 -eva-min-loop-unroll 130
 */
#include "proof.h"

#include "fixed/fixed.h"

/*@ requires \valid_read(table);
    assigns \result \from *table, s;
    ensures \result <= 32768; */
static inline uint32_t fx_power(const struct fx_power *table, q30_t s);

#include "firmware/raster/table.c"

#define TABLES 2

/* Of each format: its largest table. */
static uint32_t memory[TABLES * (sizeof(struct table) + 2 * TABLE_HIGHLIGHT * TABLE_DIFFUSE) / 4];

volatile uint32_t sink;

/* In place of raster/write.c: any colour of the format. */
uint32_t raster_colour(const struct raster *r, const uint32_t sum[3])
{
    return any_u32(0, 65535);
}

/* In place of the forms: any power. */
static void run(unsigned n, int32_t *value, int count)
{
    for (int i = 0; i < count; i++)
        value[i] = any_s32(0, 32768);
}

static void surfaces(struct raster *r, const struct fx_power *power, const struct glint_power *form)
{
    struct surface *s = &r->surface;
    any_bytes(s, sizeof *s);
    s->power = power;
    s->form = form;
    s->channels = r->palette.channels;
    for (int c = 0; c < 3; c++) {
        s->base[c] = any_u32(0, 255u << 15);
        s->light[0].diffuse[c] = any_u32(0, 255u << 8);
        s->light[0].specular[c] = any_u32(0, 255u << 8);
    }
    r->surface_material = any_u32(0, 65535);
    table_find(r);
    sink = table_error(r);
}

static void formats(enum glint_format format, unsigned channels, uint32_t most)
{
    static const struct glint_power form = {run, 0, 0, 0};
    static struct raster r;
    struct fx_power power = {.exponent = any_u32(1, FX_POWER_MAX_EXPONENT), .octave = any_u32(0, FX_POWER_MAX_OCTAVE)};
    for (unsigned i = 0; i < FX_POWER_STEPS + 2; i++)
        power.value[i] = any_u32(0, 32768);
    r.table = memory;
    r.tables = TABLES;
    r.format = format;
    r.dither = any_flag();
    r.effects = any_flag();
    r.palette = (struct palette){channels, {most, most, most}};
    sink = table_bytes(format);
    table_clear(&r);
    surfaces(&r, &power, 0);
    surfaces(&r, &power, &form);
}

void prove(void)
{
    formats(GLINT_RGB565, 3, any_u32(31, 63));
    formats(GLINT_GREY8, 1, 255);
    formats(GLINT_RGB888, 3, 255);
    sink = table_bytes(GLINT_GREY4);
}
