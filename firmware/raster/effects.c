/* SPDX-License-Identifier: MIT */
#include "raster/effects.h"

#include "raster/fogged.h"
#include "raster/texture.h"
#include "shade/uv.h"

void effects_surface(struct raster *r)
{
    r->effects = r->surface_effects = USES(USES_TEXTURE) && r->surface.texture.texels ? USES_TEXTURE : 0;
}

/* The stages of a run, each chosen once for it. */
static void finish(struct raster *r, int x, int y, int n)
{
    if (USES(USES_TEXTURE) && (r->effects & USES_TEXTURE)) {
        texture_coordinates(r, x, y, n);
        texture_stage(r, n);
    }
    if (USES(USES_FOG) && (r->effects & USES_FOG))
        fogged_run(r, x, y, n);
}

uint32_t effects_draw(struct raster *r, struct edges *e, runs_shade *shade)
{
    uint32_t drawn = 0;
    int y = e->row;
    do {
        const struct span *span = r->span, *last = span + raster_spans(r, e);
        for (; span != last; span++, y++)
            for (int x = span->x0; x < span->x1; x += RUN) {
                const int n = span->x1 - x < RUN ? span->x1 - x : RUN;
                const uint32_t mask = raster_visible(r, x, y, n);
                if (!mask)
                    continue;
                for (uint32_t seen = mask; seen; seen &= seen - 1)
                    drawn++;
                for (int i = 0; r->gloss != r->sum[0] && i < 3 * n; i++)
                    r->gloss[i] = 0;
                shade(r, x, y, n);
                finish(r, x, y, n);
                raster_write(r, x, y, mask);
            }
    } while (e->row < e->last);
    return drawn;
}

/* Whether highlights are to be kept apart. */
static int glosses(const struct raster *r, const struct glint_method *method)
{
    if (!(r->effects & USES_TEXTURE) || !surface_highlights(&r->surface))
        return 0;
    return method->colours == COLOURS_OF_NORMALS || (method->colours == COLOURS_OF_DOTS && shade_specular(&r->setup));
}

uint32_t effects_triangle(struct raster *r, struct edges *e, const struct glint_method *method)
{
    if (USES(USES_TEXTURE) && (r->effects & USES_TEXTURE))
        uv_setup(&r->setup, &r->input, r->input.texture);
    if (!method->run)
        return method->draw(r, e);
    r->gloss = glosses(r, method) ? r->apart[0] : r->sum[0];
    const uint32_t drawn = effects_draw(r, e, method->run);
    r->gloss = r->sum[0];
    return drawn;
}
