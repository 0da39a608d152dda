/* SPDX-License-Identifier: MIT */
/*
 * What a scene uses, and how much a texture's neighbours differ, of any bytes in the arrays of a scene: none to two of
 * each, which end where the blob ends; textures of every format, 1 by 1 to 4 by 2 texels.
 *
 *   proves: of_motion of_material of_camera scene_effects texel_at difference texel_contrast texel_rise
 *   options: -eva-precision 1 -eva-slevel 300 -eva-slevel-function prove:0
 */
#include "proof.h"

#include "firmware/fixed/divide.c"

#include "firmware/scene/scene_effects.c"

#include "firmware/scene/texel.c"

static struct {
    struct scene_header header;
    uint32_t rest[128];
} blob;

#define PALETTE 1024u /* bytes */

/* The offset of an array that ends with the blob. */
static uint32_t at_end(uint32_t bytes)
{
    return sizeof blob - bytes;
}

static void effects(unsigned count)
{
    struct scene_header *s = &blob.header;
    any_bytes(&blob, sizeof blob);
    s->light_count = s->object_count = s->material_count = (uint16_t)count;
    s->lights = at_end(count * sizeof(struct scene_light));
    s->objects = at_end(count * sizeof(struct scene_object));
    s->materials = at_end(count * sizeof(struct scene_material));
    scene_effects(s);
}

static void contrast(unsigned log2_width, unsigned log2_height, unsigned format)
{
    static struct {
        struct scene_header header;
        uint8_t bytes[PALETTE + 16];
    } wide;
    struct scene_texture texture;
    const uint32_t texels = (1u << log2_width << log2_height) * (format == TEXTURE_PALETTE8 ? 1 : 2);
    any_bytes(&texture, sizeof texture);
    any_bytes(&wide, sizeof wide);
    texture.log2_width = (uint8_t)log2_width;
    texture.log2_height = (uint8_t)log2_height;
    texture.format = (uint8_t)format;
    texture.texels = sizeof wide - texels;
    texture.palette = sizeof wide.header;
    texel_contrast(&wide.header, &texture);
}

void prove(void)
{
    //@ loop unroll 3;
    for (unsigned count = 0; count <= 2; count++)
        effects(count);
    //@ loop unroll 4;
    for (unsigned format = TEXTURE_RGB565; format <= TEXTURE_BUMP8; format++)
        //@ loop unroll 3;
        for (unsigned width = 0; width <= 2; width++)
            //@ loop unroll 2;
            for (unsigned height = 0; height <= 1; height++)
                contrast(width, height, format);
    texel_rise((uint16_t)any_u32(0, 65535), any_u32(0, 255));
}
