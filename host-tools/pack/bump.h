/* SPDX-License-Identifier: MIT */
/* A bump map's normals become a texture of the blob. */
#ifndef PACK_BUMP_H
#define PACK_BUMP_H

#include "pack/texture.h"

/* For a texture whose format is TEXTURE_BUMP8. Fills the report. */
void bump_pack(const struct model_texture *in, struct texture_packed *out, struct pack_texture_report *report);

#endif
