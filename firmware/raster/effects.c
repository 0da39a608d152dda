/* SPDX-License-Identifier: MIT */
#include "raster/effects.h"

#include "raster/fogged.h"
#include "raster/split.h"
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
                drawn += fx_u32(n);
                for (uint32_t hidden = ~mask & ((1u << n) - 1); hidden; hidden &= hidden - 1)
                    drawn--;
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

/* Sets up how texture coordinates are found, if the set-up of a bump map has not. 1: by splitting. */
static __attribute__((noinline)) int choose_kind(struct raster *r, const struct glint_method *method)
{
    struct shade_input *in = &r->input;
    const struct surface_texture *texture = &r->surface.texture;
    struct uv_corners uv;
    unsigned kind = in->texture;
    if (r->setup.uv_kind)
        return 0;
    uv_corners(&uv, in);
    const struct texture_spread spread = uv_spread(&uv, texture);
    if (kind == GLINT_TEXTURE_DEFAULT && r->surface.plan.power) { /* auto */
        uint32_t error;
        kind = texture_choose(texture->head, &spread, PLAN_TEXTURE_SHARE(r->budget), &error);
        in->plan.error = fx_u16(in->plan.error + error);
    }
    if (kind == GLINT_TEXTURE_SPLIT && texture_error(&spread, GLINT_TEXTURE_QUADRATIC) <= PLAN_TEXTURE_SHARE(r->budget))
        kind = GLINT_TEXTURE_QUADRATIC;
    if (kind == GLINT_TEXTURE_SPLIT && method->run && split_begin(r, &uv))
        return 1;
    uv_setup_corners(&r->setup, &uv, kind);
    return 0;
}

uint32_t effects_triangle(struct raster *r, struct edges *e, const struct glint_method *method)
{
    int splits = 0;
    if (USES(USES_FOG) && (r->effects & USES_FOG))
        fogged_setup(r, method);
    if (USES(USES_TEXTURE) && (r->effects & USES_TEXTURE))
        splits = choose_kind(r, method);
    if (!method->run)
        return method->draw(r, e);
    r->gloss = glosses(r, method) ? r->apart[0] : r->sum[0];
    const uint32_t drawn = splits ? split_draw(r, e, method->run) : effects_draw(r, e, method->run);
    r->gloss = r->sum[0];
    return drawn;
}
