/* SPDX-License-Identifier: MIT */
/* A picture becomes a texture of the blob: powers of two, 565 or a palette, its row at v = 0 first. */
#ifndef PACK_TEXTURE_H
#define PACK_TEXTURE_H

#include "pack/report.h"
#include "scene/scene.h"

#define TEXTURE_MOST 1024u /* texels a side: larger ones are brought down to it */

struct texture_packed {
    struct scene_texture head; /* its offsets and contrast are for the writer of the blob to fill */
    void *texels;
    size_t size; /* bytes */
    uint32_t *palette;
    uint16_t *rises; /* of a bump map: TEXTURE_RISES */
};

/* The nearest power of two by ratio, at most TEXTURE_MOST. */
uint8_t texture_log2(unsigned size);

/* Fills the report. */
void texture_pack(const struct model_texture *in, struct texture_packed *out, struct pack_texture_report *report);

void texture_free(struct texture_packed *texture);

#endif
