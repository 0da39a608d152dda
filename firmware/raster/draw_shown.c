/* SPDX-License-Identifier: MIT */
/* Each triangle in one colour that says what auto draws it by: a picture of the plan. */
#include "raster/raster.h"

/* What a triangle is drawn by: README.md's legend. */
static const uint8_t colours[GLINT_METHODS][3] = {
    [GLINT_DARK] = {45, 45, 60},
    [GLINT_CONSTANT] = {60, 110, 220},
    [GLINT_GOURAUD] = {60, 170, 75},
    [GLINT_LINEAR] = {200, 215, 70},
    [GLINT_SIX] = {245, 150, 40},
    [GLINT_DUFF] = {215, 50, 50},
    [GLINT_PHONG] = {190, 60, 200},
    [GLINT_BUMP_LINEAR] = {120, 215, 225},
    [GLINT_BUMP_QUADRATIC] = {50, 155, 190},
    [GLINT_BUMP_NORMALISED] = {30, 95, 150},
};

/* Next to one another they differ a little, by two bits of their number, and those without a highlight are darker. */
static uint32_t brightness(const struct shade_input *in)
{
    const uint32_t number = in->triangle->corner[0] + in->triangle->corner[1] + in->triangle->corner[2];
    return 256 - 12 * (number & 3) - (in->plan.hidden_highlights | in->plan.dropped_highlights ? 48 : 0);
}

static void shade_shown(struct shade_setup *setup, const struct shade_input *in)
{
    const struct surface *s = in->surface;
    const uint8_t *colour = colours[in->plan.level[0]];
    const uint8_t grey[3] = {fx_u8((77 * colour[0] + 150 * colour[1] + 29 * colour[2]) >> 8), 0, 0};
    const uint32_t by = brightness(in);
    for (unsigned c = 0; c < surface_channels(s); c++) /* 2^23 * 2^8 below 2^31, twice */
        setup->flat[c] = (s->top[c] / 255 * (surface_channels(s) == 1 ? grey : colour)[c] >> 8) * by;
}

#define SHOWN(method) [(method)] = {.id = (method), .setup = shade_shown, .draw = draw_flat}
static const struct glint_method shown[GLINT_METHODS] = {
    SHOWN(GLINT_DARK),
    SHOWN(GLINT_CONSTANT),
    SHOWN(GLINT_GOURAUD),
    SHOWN(GLINT_LINEAR),
    SHOWN(GLINT_SIX),
    SHOWN(GLINT_DUFF),
    SHOWN(GLINT_PHONG),
    SHOWN(GLINT_BUMP_LINEAR),
    SHOWN(GLINT_BUMP_QUADRATIC),
    SHOWN(GLINT_BUMP_NORMALISED),
};

static const struct glint_method *choose_shown(struct raster *r)
{
    const struct glint_method *method = glint_auto.choose(r);
    r->input.plan.level[0] = method->id; /* which is of constant colours alone, that are not drawn here */
    r->effects = 0;
    return &shown[method->id];
}

const struct glint_method glint_auto_shown = {.id = GLINT_FLAT,
                                              .uses_tables = 1,
                                              .vertex_words = COLOUR_WORDS,
                                              .setup = shade_shown,
                                              .draw = draw_flat,
                                              .choose = choose_shown};
