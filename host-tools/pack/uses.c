/* SPDX-License-Identifier: MIT */
#include "pack/uses.h"

#include <string.h>

const struct uses_name uses_names[] = {{USES_TEXTURE, "texture"},
                                       {USES_BUMP, "bump"},
                                       {USES_FOG, "fog"},
                                       {USES_TWO_SIDED, "two-sided"},
                                       {USES_SPECULAR, "specular"},
                                       {USES_POINT_LIGHT, "point-light"},
                                       {USES_LOCAL_VIEWER, "local-viewer"},
                                       {USES_PERSPECTIVE, "perspective"},
                                       {USES_ORTHOGRAPHIC, "orthographic"},
                                       {USES_SPIN, "spin"},
                                       {USES_KEYS, "keys"},
                                       {USES_SEVERAL_LIGHTS, "several-lights"},
                                       {USES_RGB565, "rgb565"},
                                       {USES_RGB888, "rgb888"},
                                       {USES_GREY8, "grey8"},
                                       {USES_GREY4, "grey4"},
                                       {USES_DITHER, "dither"},
                                       {USES_POWERS, "powers"},
                                       {0, NULL}};

void uses_print(FILE *out, uint32_t uses)
{
    if (!uses)
        fputs(" none", out);
    for (const struct uses_name *n = uses_names; n->name; n++)
        if (uses & n->bit)
            fprintf(out, " %s", n->name);
}

static uint32_t find_one(const char *name, size_t length)
{
    for (const struct uses_name *n = uses_names; n->name; n++)
        if (n->bit & ~USES_EFFECTS && strlen(n->name) == length && !strncmp(n->name, name, length))
            return n->bit;
    return 0;
}

uint32_t uses_find(const char *names)
{
    uint32_t uses = 0;
    for (;; names++) {
        const size_t length = strcspn(names, ",");
        const uint32_t bit = find_one(names, length);
        if (!bit)
            return 0;
        uses |= bit;
        names += length;
        if (!*names)
            return uses;
    }
}
