/* SPDX-License-Identifier: MIT */
#include "shade/surface.h"

#include "plan/curve.h"
#include "shade/shade.h"

/* Product of two Q15 numbers of at most 1, rounded. */
static uint32_t times(uint32_t a, uint32_t b)
{
    return (a * b + (1u << 14)) >> 15;
}

/* Rec. 601 luma of Q15 channels. */
static uint32_t luma(const uint32_t rgb[3])
{
    return (77 * rgb[0] + 150 * rgb[1] + 29 * rgb[2] + 128) >> 8;
}

/* Q15 intensities to the palette's channels: steps in Q(15 + fraction - 15). */
FX_COLD static void to_steps(const struct palette *palette, const uint32_t rgb_q15[3], unsigned down, uint32_t *out)
{
    const int is_grey = uses_channels(palette->channels) == 1;
    const uint32_t grey = is_grey ? luma(rgb_q15) : 0;
    for (unsigned c = 0; c < 3; c++) /* 2^15 * 255; of a grey palette the others' tops are 0 */
        out[c] = ((is_grey ? grey : rgb_q15[c]) * palette->top[c]) >> down;
}

FX_COLD void surface_colour(const struct palette *palette, const uint16_t rgb_q15[3], uint32_t *out)
{
    uint32_t rgb[3] = {rgb_q15[0], rgb_q15[1], rgb_q15[2]};
    to_steps(palette, rgb, 0, out);
}

/* A light's part of a material, Q8 steps at full intensity; returns the largest channel's. */
static uint16_t reflected(const struct palette *palette, const uint16_t material[3], uint16_t share,
                          const uint16_t light[3], uint16_t out[3])
{
    uint32_t rgb[3], steps[3];
    uint16_t most = 0;
    for (unsigned c = 0; c < 3; c++)
        rgb[c] = times(times(material[c], light[c]), share);
    to_steps(palette, rgb, 7, steps);
    for (unsigned c = 0; c < 3; c++) {
        out[c] = fx_u16(steps[c]);
        most = out[c] > most ? out[c] : most;
    }
    return most;
}

static void find_bump(struct surface_bump *bump, const struct scene_header *scene, unsigned index)
{
    const struct scene_texture *texture = scene_textures(scene) + index;
    bump->texel = 0;
    if (index == SCENE_NO_TEXTURE)
        return;
    bump->texel = scene_at(scene, texture->texels);
    bump->rise = scene_at(scene, texture->palette);
    bump->log2_width = texture->log2_width;
    bump->log2_height = texture->log2_height;
    bump->flags = texture->flags;
    bump->steepness = texture->steepness;
}

/* In grey a texel counts as the luma that it gives the diffuse colour, of what that has itself: exact under lights
 * without a hue. */
static void weigh(const uint16_t diffuse[3], uint16_t grey[3])
{
    static const uint8_t share[3] = {77, 150, 29};
    uint32_t part[3], sum = 0, rest = 256;
    for (unsigned c = 0; c < 3; c++) { /* 2^15 * 150, and with it 2^8 more: below 2^31 */
        part[c] = share[c] * fx_u32(diffuse[c]);
        sum += part[c];
    }
    for (unsigned c = 2; c > 0; c--) {
        grey[c] = fx_u16(sum ? ((part[c] << 8) + sum / 2) / sum : share[c]);
        rest -= grey[c];
    }
    grey[0] = fx_u16(rest);
}

FX_COLD static void take_texture(struct surface_texture *texture, const struct scene_header *scene,
                                 const struct scene_material *material)
{
    texture->texels = 0;
    if (material->texture == SCENE_NO_TEXTURE)
        return;
    texture->head = scene_textures(scene) + material->texture;
    texture->texels = scene_at(scene, texture->head->texels);
    texture->palette = scene_at(scene, texture->head->palette);
    weigh(material->diffuse, texture->grey);
}

/* Of ambient and diffuse light together, in the channel that has most: Q8, rounded up. */
FX_COLD static uint32_t most_light(const struct surface *s, const struct palette *palette)
{
    uint32_t most = 0;
    for (unsigned c = 0; c < s->channels; c++) {
        uint32_t sum = s->base[c] >> 7; /* Q8 steps, at most 9 * 255 * 2^8 */
        for (unsigned i = 0; i < s->lights; i++)
            sum += s->light[i].diffuse[c];
        sum = (sum + palette->top[c]) / palette->top[c];
        most = sum > most ? sum : most;
    }
    return most;
}

FX_COLD void surface_setup(struct surface *surface, const struct scene_header *scene,
                           const struct scene_material *material, const struct palette *palette)
{
    static const uint8_t limit[SCENE_MAX_LIGHTS + 1] = {128, 128, 64, 42, 32, 25, 21, 18, 16}; /* 128 / lights */
    uint32_t rgb[3];
    if (USES(USES_TEXTURE))
        take_texture(&surface->texture, scene, material);
    surface->power = scene_powers(scene) + material->power;
    surface->plan.power = 0;
    surface->channels = palette->channels;
    if (USES(USES_BUMP))
        find_bump(&surface->bump, scene, material->bump);
    surface->lights = fx_u8(scene->light_count);
    surface->highlights = 0;
    surface->bend_limit = limit[scene->light_count];
    for (unsigned c = 0; c < 3; c++)
        rgb[c] = times(times(material->diffuse[c], scene->ambient[c]), material->ka);
    to_steps(palette, rgb, 0, surface->base);
    for (unsigned c = 0; c < 3; c++)
        surface->top[c] = fx_u32(palette->top[c]) << 15;
    const struct scene_light *light = scene_lights(scene);
    for (unsigned i = 0; i < scene->light_count; i++) {
        surface->light[i].diffuse_most =
            reflected(palette, material->diffuse, material->kd, light[i].colour, surface->light[i].diffuse);
        surface->light[i].specular_most =
            reflected(palette, material->specular, material->ks, light[i].colour, surface->light[i].specular);
        surface->highlights |= surface->light[i].specular_most != 0;
    }
    if (USES(USES_TEXTURE) && surface->texture.texels)
        surface->texture.lit = most_light(surface, palette);
    surface->fold = surface->ambient = 0;
    if (USES(USES_GREY8) && palette->channels == 1 && palette->top[0] == 255 && surface->lights &&
        !surface_form(surface)) {
        surface->fold = surface->light[0].diffuse[0];
        surface->ambient = fx_u16((surface->base[0] >> 8) + (1 << 6));
    }
}

/* Steps of a channel's output (Q8) in 1/255 of full intensity, rounded up; at most 255 and a little. */
static uint32_t in_255(uint32_t steps, unsigned top)
{
    return (steps * 255 + top - 1) / top; /* below 2^24 */
}

#define ROUNDINGS 230u /* 1, less what sums and coefficients are rounded by */

/*
 * What colours by the vertex records' dot products can be off by in roundings, Q8 of 1/255. A record's N.H is off by up
 * to 3.1 units of Q14 (the normal's length by .9, the half-way vector's by 1.7, its own rounding), the power's slope is
 * at most n, and its table is off by 1/510. Phong's N.H is exact; what the table does to it, nothing mends.
 */
static uint32_t roughness(const struct plan_surface *plan)
{
    uint32_t sum = 0; /* below 8 * (2^16 * 2^12 + 2^16 * 2^5) < 2^32 */
    for (unsigned i = 0; i < plan->lights; i++)
        sum += plan->light[i].specular * (3u * plan->power->exponent + 32u) + 3u * plan->light[i].diffuse;
    return sum >> 14;
}

FX_COLD void surface_plan(struct surface *surface, const struct palette *palette, uint16_t budget)
{
    struct plan_surface *plan = &surface->plan;
    uint32_t base = 0;
    plan->power = surface->power;
    plan->lights = surface->lights;
    plan->highlights = surface->highlights;
    /* beyond it, where Phong goes straight into the band, Duff goes by runs */
    plan->duff_sum = surface_fold(surface) && surface->lights == 1 ? SHADE_LENGTH_SUM : UINT16_MAX;
    plan->foot = fx_s16((1 << 14) - ((1 << 14) >> surface->power->octave));
    for (unsigned c = 0; c < surface->channels; c++) {
        const uint32_t ambient = in_255(surface->base[c] >> 7, palette->top[c]);
        base = ambient > base ? ambient : base;
    }
    plan->full = fx_u16(base < 255u << 8 ? (255u << 8) - base : 0);
    for (unsigned i = 0; i < surface->lights; i++) {
        uint32_t diffuse = 0, specular = 0;
        for (unsigned c = 0; c < surface->channels; c++) {
            const uint32_t d = in_255(surface->light[i].diffuse[c], palette->top[c]),
                           h = in_255(surface->light[i].specular[c], palette->top[c]);
            diffuse = d > diffuse ? d : diffuse;
            specular = h > specular ? h : specular;
        }
        plan->light[i].diffuse = fx_u16(diffuse);
        plan->light[i].specular = fx_u16(specular);
    }
    /* Roundings may take as much as 1 beyond the budget; the rest is the budget's. */
    const uint32_t rough = roughness(plan), excess = rough > ROUNDINGS ? rough - ROUNDINGS : 0;
    plan->apart = USES(USES_TEXTURE) && surface->texture.texels;
    if (plan->apart)
        budget = fx_u16(budget - PLAN_TEXTURE_SHARE(budget));
    plan->spare = fx_u16(rough < ROUNDINGS ? ROUNDINGS - rough : 0);
    /* raster/spans_length.c: what is divided by the length straight into the band is off by 2^-13 */
    plan->lengths =
        surface_fold(surface)
            ? fx_u16((fx_u32(plan->light[0].specular) * plan->power->exponent + plan->light[0].diffuse) >> 13) + 1
            : 0;
    plan->sharp = excess > budget;
    plan->budget = fx_u16(plan->sharp ? 0 : budget - excess);
}

void surface_shade(const struct surface *surface, const int16_t *lights_q14, uint32_t *out)
{
    const unsigned channels = surface_channels(surface);
    for (unsigned c = 0; c < channels; c++)
        out[c] = surface->base[c];
    for (unsigned i = 0; i < surface_lights(surface); i++) {
        int32_t l = lights_q14[2 * i], h = lights_q14[2 * i + 1];
        uint32_t diffuse = l > 0 ? fx_u32(l) << 1 : 0;
        for (unsigned c = 0; c < channels; c++)
            out[c] += surface_diffuse(diffuse, surface->light[i].diffuse[c]);
        if (surface_highlights(surface) && h > 0) {
            uint32_t power = surface_power(surface, fx_s32(h << 16)); /* h < 2^14 */
            for (unsigned c = 0; c < channels; c++)
                out[c] += surface_diffuse(power, surface->light[i].specular[c]);
        }
    }
    for (unsigned c = 0; c < channels; c++)
        if (out[c] > surface->top[c])
            out[c] = surface->top[c];
}
