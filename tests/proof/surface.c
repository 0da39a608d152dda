/* SPDX-License-Identifier: MIT */
/*
 * shade/surface.c: any material under 0 to 8 lights of any colours, in grey and in colours of any depth, and what is
 * planned and shaded by it; planned in a program without textures as well.
 *
 *   proves: times luma to_steps surface_colour reflected find_bump weigh take_texture most_light surface_setup in_255
 *           roughness surface_plan surface_shade surface_diffuse surface_power
 *   assumes: fx_power
 *   options: -eva-precision 0 -eva-min-loop-unroll 3 -eva-slevel 60
 */
#include "proof.h"

#include "fixed/fixed.h"

/*@ requires \valid_read(table);
    assigns \result \from *table, s; */
static inline uint32_t fx_power(const struct fx_power *table, q30_t s);

#include "plan/curve.h"
#include "shade/shade.h"

/* What the program has: a constant of its own. */
static uint32_t uses = USES_ALL;
#undef GLINT_USES
#define GLINT_USES uses

#include "firmware/shade/surface.c"

static struct {
    struct scene_header header;
    struct scene_material material;
    struct fx_power power[2];
    struct scene_light light[SCENE_MAX_LIGHTS];
    struct scene_texture texture[2];
} scene;

/* In place of the forms: any power. */
static void run(unsigned n, int32_t *value, int count)
{
    for (int i = 0; i < count; i++)
        value[i] = any_s32(0, 32768);
}

static void intensities(uint16_t rgb[3])
{
    for (int c = 0; c < 3; c++)
        rgb[c] = any_u32(0, 32768);
}

static void shade(const struct surface *surface)
{
    int16_t lights[2 * SCENE_MAX_LIGHTS];
    uint32_t out[3];
    for (unsigned i = 0; i < 2 * SCENE_MAX_LIGHTS; i++)
        lights[i] = any_s32(-16400, 16400);
    surface_shade(surface, lights, out);
}

static void surfaces(const struct palette *palette, const struct glint_power *form)
{
    static struct surface surface;
    struct scene_material *material = &scene.material;
    uint32_t out[3];
    any_bytes(&surface, sizeof surface);
    surface.form = form;
    intensities(material->diffuse);
    intensities(material->specular);
    material->ka = any_u32(0, 32768);
    material->kd = any_u32(0, 32768);
    material->ks = any_u32(0, 32768);
    material->power = any_u32(0, 1);
    material->texture = any_flag() ? SCENE_NO_TEXTURE : 0;
    material->bump = any_flag() ? SCENE_NO_TEXTURE : 1;
    intensities(scene.header.ambient);
    surface_colour(palette, scene.header.ambient, out);
    surface_setup(&surface, &scene.header, material, palette);
    uses = USES_ALL & ~USES_TEXTURE;
    surface_plan(&surface, palette, any_u32(0, 65535));
    uses = USES_ALL;
    surface_plan(&surface, palette, any_u32(0, 65535));
    shade(&surface);
}

void prove(void)
{
    static const struct glint_power form = {run, 0, 0, 0};
    struct palette palette;
    any_bytes(&scene, sizeof scene);
    scene.header.materials = (uint8_t *)&scene.material - (uint8_t *)&scene;
    scene.header.powers = (uint8_t *)scene.power - (uint8_t *)&scene;
    scene.header.lights = (uint8_t *)scene.light - (uint8_t *)&scene;
    scene.header.textures = (uint8_t *)scene.texture - (uint8_t *)&scene;
    for (unsigned i = 0; i < 2; i++) {
        scene.power[i].exponent = any_u32(1, FX_POWER_MAX_EXPONENT);
        scene.power[i].octave = any_u32(0, FX_POWER_MAX_OCTAVE);
        scene.texture[i].texels = scene.texture[i].palette = any_u32(0, sizeof scene);
    }
    //@ loop unroll 9;
    for (unsigned count = 0; count <= SCENE_MAX_LIGHTS; count++) {
        scene.header.light_count = count;
        for (unsigned i = 0; i < SCENE_MAX_LIGHTS; i++)
            intensities(scene.light[i].colour);
        palette = (struct palette){1, {any_flag() ? 255 : 15, 0, 0}};
        surfaces(&palette, 0);
        surfaces(&palette, &form);
        palette = (struct palette){3, {any_flag() ? 255 : 31, any_flag() ? 255 : 63, any_flag() ? 255 : 31}};
        surfaces(&palette, 0);
        surfaces(&palette, &form);
    }
}
