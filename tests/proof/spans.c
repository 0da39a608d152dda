/* SPDX-License-Identifier: MIT */
/*
 * raster/spans.h in each format: any polynomials stay in the table, every span in the band.
 *
 *   proves: spans_rgb565_constant spans_rgb565_colours spans_rgb565_dots constant565 colours565
 *           diffuse565 diffuse_quadratic565 both565 both_quadratic565 both_wide565 spans_rgb565
 *           spans_grey8_constant spans_grey8_colours spans_grey8_dots spans_grey8_lengths look_up
 *           draw_highlight constant8 colours8 plain8 plain_quadratic8 diffuse8 diffuse_quadratic8
 *           both8 both_quadratic8 both_wide8 both_power8 lengths_diffuse8 lengths_wide8 lengths_power8
 *           lengths8 spans_rgb888_constant spans_rgb888_colours spans_rgb888_dots constant888
 *           colours888 diffuse888 both888 both_wide888 spans_rgb888 spans_draw spans_pixels spans_at
 *           spans_start spans_find spans_step spans_highlight
 *   assumes: fx_saturated
 *   options: -eva-precision 1 -eva-slevel 100 -absolute-valid-range 0x20000000-0x2000004a
 */
#include "any_spans.h"

#include "contracts.h"

#include "firmware/raster/spans.c"
#include "firmware/raster/spans_length.c"

/* Each format has loops of its own under the same names. */
#define constant(...)          constant565(__VA_ARGS__)
#define colours(...)           colours565(__VA_ARGS__)
#define diffuse(...)           diffuse565(__VA_ARGS__)
#define diffuse_quadratic(...) diffuse_quadratic565(__VA_ARGS__)
#define both(...)              both565(__VA_ARGS__)
#define both_quadratic(...)    both_quadratic565(__VA_ARGS__)
#define both_wide(...)         both_wide565(__VA_ARGS__)
#include "firmware/raster/spans_rgb565.c"
#undef constant
#undef colours
#undef diffuse
#undef diffuse_quadratic
#undef both
#undef both_quadratic
#undef both_wide
#undef BOTH

#define constant(...)          constant8(__VA_ARGS__)
#define colours(...)           colours8(__VA_ARGS__)
#define plain(...)             plain8(__VA_ARGS__)
#define plain_quadratic(...)   plain_quadratic8(__VA_ARGS__)
#define diffuse(...)           diffuse8(__VA_ARGS__)
#define diffuse_quadratic(...) diffuse_quadratic8(__VA_ARGS__)
#define both(...)              both8(__VA_ARGS__)
#define both_quadratic(...)    both_quadratic8(__VA_ARGS__)
#define both_wide(...)         both_wide8(__VA_ARGS__)
#define both_power(...)        both_power8(__VA_ARGS__)
#define normals(...)           normals8(__VA_ARGS__)
#define lengths_diffuse(...)   lengths_diffuse8(__VA_ARGS__)
#define lengths_wide(...)      lengths_wide8(__VA_ARGS__)
#define lengths_power(...)     lengths_power8(__VA_ARGS__)
#define lengths(...)           lengths8(__VA_ARGS__)
#include "firmware/raster/spans_grey8.c"
#undef constant
#undef colours
#undef plain
#undef plain_quadratic
#undef diffuse
#undef diffuse_quadratic
#undef both
#undef both_quadratic
#undef both_wide
#undef both_power
#undef normals
#undef lengths_diffuse
#undef lengths_wide
#undef lengths_power
#undef lengths
#undef BOTH

#define constant(...)  constant888(__VA_ARGS__)
#define colours(...)   colours888(__VA_ARGS__)
#define diffuse(...)   diffuse888(__VA_ARGS__)
#define both(...)      both888(__VA_ARGS__)
#define both_wide(...) both_wide888(__VA_ARGS__)
#include "firmware/raster/spans_rgb888.c"
#undef constant
#undef colours
#undef diffuse
#undef both
#undef both_wide
#undef BOTH

/* raster_colour() gives a colour in the format: three bytes at most. */
uint32_t raster_colour(const struct raster *r, const uint32_t sum[3])
{
    return any_u32(0, 0xffffff);
}

void object_light_at(const struct object_state *o, unsigned light, const int32_t place[3], q14_t towards[3],
                     q14_t half[3])
{
    for (int i = 0; i < 3; i++) {
        towards[i] = any_s32(-16388, 16388);
        half[i] = any_s32(-16388, 16388);
    }
}

static uint32_t constant(struct raster *r, struct edges *e)
{
    spans_grey8_constant(r, e, any_u32(0, 255));
    e->row--;
    spans_rgb888_constant(r, e, any_u32(0, 0xffffff));
    e->row--;
    return spans_rgb565_constant(r, e, any_u32(0, 0xffff));
}

static uint32_t tabled_rgb565(struct raster *r, struct edges *e)
{
    r->surface_table = (const struct table *)table;
    return spans_rgb565_dots(r, e);
}

static uint32_t tabled_grey8(struct raster *r, struct edges *e)
{
    r->surface_table = (const struct table *)table;
    return spans_grey8_dots(r, e);
}

static uint32_t tabled_lengths(struct raster *r, struct edges *e)
{
    r->surface_table = (const struct table *)table;
    return spans_grey8_lengths(r, e);
}

static uint32_t tabled_rgb888(struct raster *r, struct edges *e)
{
    r->surface_table = (const struct table *)table;
    return spans_rgb888_dots(r, e);
}

void prove(void)
{
    every_span(constant);
    every_span(spans_rgb565_colours);
    every_span(spans_grey8_colours);
    every_span(spans_rgb888_colours);
    every_span(tabled_rgb565);
    every_span(tabled_grey8);
    every_span(spans_grey8_dots);
    every_span(tabled_lengths);
    every_span(spans_grey8_lengths);
    every_span(tabled_rgb888);
}
