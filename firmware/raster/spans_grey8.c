/* SPDX-License-Identifier: MIT */
/* Spans of 8-bit grey. */
#include "raster/spans.h"
#include "raster/spans_hand.h"

#define BOTH (SPANS_GREY8 | SPANS_DIFFUSE | SPANS_HIGHLIGHT)
SPANS_CASE(constant, SPANS_GREY8)
SPANS_CASE(colours, SPANS_GREY8 | SPANS_COLOUR)
SPANS_CASE(plain, SPANS_GREY8 | SPANS_PLAIN)
SPANS_CASE(plain_quadratic, SPANS_GREY8 | SPANS_PLAIN | SPANS_QUADRATIC)
SPANS_CASE(diffuse, SPANS_GREY8 | SPANS_DIFFUSE)
SPANS_CASE(diffuse_quadratic, SPANS_GREY8 | SPANS_DIFFUSE | SPANS_QUADRATIC)
SPANS_CASE(both_wide, BOTH | SPANS_QUADRATIC | SPANS_WIDE)
SPANS_CASE(both_power, BOTH | SPANS_QUADRATIC | SPANS_POWER)
SPANS_CASE(normals, SPANS_GREY8 | SPANS_NORMAL)
SPANS_CASE(lengths_diffuse, SPANS_GREY8 | SPANS_LENGTH | SPANS_QUADRATIC | SPANS_DIFFUSE)
SPANS_CASE(lengths_wide, BOTH | SPANS_LENGTH | SPANS_QUADRATIC | SPANS_WIDE)
SPANS_CASE(lengths_power, BOTH | SPANS_LENGTH | SPANS_QUADRATIC | SPANS_POWER)
#if SPANS_BY_HAND
#define both(r, e, look)           spans_by_hand(r, e, look, 1, 0, spans_hand_grey)
#define both_quadratic(r, e, look) spans_by_hand(r, e, look, 1, 0, spans_hand_grey_quadratic)
#else
SPANS_CASE(both, BOTH)
SPANS_CASE(both_quadratic, BOTH | SPANS_QUADRATIC)
#endif
#if SPANS_BY_HAND == 2
#define lengths(r, e, look) spans_by_hand(r, e, look, 1, 1, spans_hand_grey_lengths)
#else
SPANS_CASE(lengths, BOTH | SPANS_LENGTH | SPANS_QUADRATIC)
#endif

uint32_t spans_grey8_constant(struct raster *r, struct edges *e, uint32_t colour)
{
    const struct spans_look look = {.colour = colour};
    return constant(r, e, &look);
}

uint32_t spans_grey8_colours(struct raster *r, struct edges *e)
{
    const struct spans_look look = {0};
    return colours(r, e, &look);
}

/* A highlight by the material's table, or without one by the scene's: returns whether by a table. */
static int look_up(const struct raster *r, struct spans_look *look)
{
    const struct fx_power *power = r->surface.power;
    look->colour = r->surface.ambient;
    look->specular = r->surface.light[0].specular[0];
    look->foot = (1u << 30) - (1u << (30 - power->octave));
    look->table = r->surface_table ? r->surface_table->entry : power->value;
    look->down = (r->surface_table ? 30u - TABLE_BITS : 8u) - power->octave;
    return r->surface_table != 0;
}

static uint32_t draw_highlight(struct raster *r, struct edges *e)
{
    const struct shade_setup *setup = &r->setup;
    struct spans_look look;
    spans_highlight(r);
    if (!look_up(r, &look))
        return both_power(r, e, &look);
    if (setup->wide)
        return both_wide(r, e, &look);
    return setup->quadratic ? both_quadratic(r, e, &look) : both(r, e, &look);
}

uint32_t spans_grey8_dots(struct raster *r, struct edges *e)
{
    struct shade_setup *setup = &r->setup;
    const struct spans_look look = {.colour = r->surface.ambient};
    if (shade_specular(setup))
        return draw_highlight(r, e);
    if (!setup->diffuse_lights)
        return spans_grey8_constant(r, e, look.colour >> 7);
    if (setup->plain) {
        fx_wrap_inc(&setup->channel[0].p.f, look.colour << 15);
        return setup->quadratic ? plain_quadratic(r, e, &look) : plain(r, e, &look);
    }
    return setup->quadratic ? diffuse_quadratic(r, e, &look) : diffuse(r, e, &look);
}

uint32_t spans_grey8_lengths(struct raster *r, struct edges *e)
{
    struct shade_setup *setup = &r->setup;
    struct spans_look look;
    const int by_table = look_up(r, &look);
    if (!setup->diffuse_lights)
        setup->channel[0].p = (struct polynomial){0};
    if (!shade_specular(setup))
        return setup->diffuse_lights ? lengths_diffuse(r, e, &look) : spans_grey8_constant(r, e, look.colour >> 7);
    if (!by_table || setup->wide) {
        fx_wrap_inc(&setup->channel[1].p.f, 1u << 14); /* half of what a pixel drops before it multiplies */
        return by_table ? lengths_wide(r, e, &look) : lengths_power(r, e, &look);
    }
    const unsigned octave = r->surface.power->octave;
    look.down = 15u - octave;
    look.foot <<= octave;
    fx_wrap_inc(&setup->channel[1].p.f, 1u << (14 - octave));
    return lengths(r, e, &look);
}

uint32_t spans_grey8_normals(struct raster *r, struct edges *e)
{
    const struct surface *s = &r->surface;
    struct spans_light light = {.base = s->base[0],
                                .diffuse = s->light[0].diffuse[0],
                                .specular = surface_highlights(s) ? s->light[0].specular[0] : 0,
                                .power = s->power};
    object_light_at(r->input.object, 0, 0, light.towards, light.half);
    light.shortness = normals_shortness(light.half);
    const struct spans_look look = {.light = &light};
    return normals(r, e, &look);
}
