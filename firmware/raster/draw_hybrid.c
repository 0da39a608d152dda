/* SPDX-License-Identifier: MIT */
/* Gouraud, and a better method where a highlight may be (Cho et al. 1996, section 3.3). Counted under what draws. */
#include "raster/adaptive.h"

static const struct glint_method *choose_phong(struct raster *r)
{
    return adaptive_treats(&r->input) ? &glint_phong : &glint_gouraud;
}

static const struct glint_method *choose_x(struct raster *r)
{
    return adaptive_treats(&r->input) ? &glint_x : &glint_gouraud;
}

const struct glint_method glint_hybrid_phong = {
    .id = GLINT_PHONG, .vertex_words = ADAPTIVE_WORDS, .object = highlighted_mark, .choose = choose_phong};
const struct glint_method glint_hybrid_x = {
    .id = GLINT_X, .uses_tables = 1, .vertex_words = ADAPTIVE_WORDS, .object = highlighted_mark, .choose = choose_x};
