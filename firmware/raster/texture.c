/* SPDX-License-Identifier: MIT */
/*
 * The stages of a run that a texture adds: coordinates, their clamp, texels to factors, and the product. Each is a loop
 * made for its case. A factor is texel / 255 in Q12, 0..4096.
 */
#include "raster/texture.h"

#include "scene/texel.h"
#include "shade/uv.h"

#define ONE_TURN (1 << 28)

void texture_coordinates(struct raster *r, int x, int y, int n)
{
    const struct shade_setup *setup = &r->setup;
    const int divides = USES(USES_PERSPECTIVE) && setup->uv_kind == GLINT_TEXTURE_PERSPECTIVE;
    if (divides) {
        plane_values(&setup->plane, &setup->depth, x, y, n, r->value[0]);
        for (int i = 0; i < n; i++)
            r->divisor[i] = perspective_divisor((uint32_t)r->value[0][i], setup->uv_up);
    }
    for (int axis = 0; axis < 2; axis++) {
        int32_t *uv = r->uv[axis];
        plane_values(&setup->plane, &setup->uv[axis], x, y, n, uv);
        for (int i = 0; divides && i < n; i++)
            uv[i] = perspective_divide(uv[i], r->divisor[i]);
    }
}

/* Where the texture goes on with its border: within the middles of the outer texels, or just below 1 for the nearest.
 */
static void clamp(const struct scene_texture *t, int32_t *uv, int n, unsigned log2)
{
    const int32_t half = t->flags & TEXTURE_BILINEAR ? (ONE_TURN / 2) >> log2 : 0;
    const int32_t last = half ? ONE_TURN - half : ONE_TURN - 1;
    for (int i = 0; i < n; i++)
        uv[i] = uv[i] < half ? half : uv[i] > last ? last : uv[i];
}

/* Where a run's texels are looked up: coordinates in Q28 and their turns to texels. */
struct lookup {
    const void *texels;
    const uint32_t *palette;
    uint32_t mask_u, mask_v;
    unsigned down_u, down_v, row; /* shifts: to texels, and a row's */
};

static struct lookup lookup_of(const struct surface_texture *texture)
{
    const struct scene_texture *t = texture->head;
    return (struct lookup){texture->texels,
                           texture->palette,
                           (1u << t->log2_width) - 1,
                           (1u << t->log2_height) - 1,
                           28u - t->log2_width,
                           28u - t->log2_height,
                           t->log2_width};
}

/* 0x00RRGGBB of a texel. Templates from here on: `palette` and `grey` are constant. */
static inline __attribute__((always_inline)) uint32_t texel(const struct lookup *at, uint32_t index, int palette)
{
    if (palette)
        return at->palette[((const uint8_t *)at->texels)[index]];
    return texel_expand(((const uint16_t *)at->texels)[index]);
}

/* Three channels of 255 * 2^8 at most to factors; in grey, their weighted sum to one. Below 2^16 * 257. */
static inline __attribute__((always_inline)) void put(struct raster *r, int i, uint32_t red, uint32_t green,
                                                      uint32_t blue, int grey)
{
    if (grey) {
        const uint16_t *w = r->surface.texture.grey;
        const uint32_t sum = (red * w[0] + green * w[1] + blue * w[2]) >> 8;
        r->value[3][i] = (int32_t)((sum * 257 + (1u << 11)) >> 12);
        return;
    }
    r->value[3][i] = (int32_t)((red * 257 + (1u << 11)) >> 12);
    r->value[4][i] = (int32_t)((green * 257 + (1u << 11)) >> 12);
    r->value[5][i] = (int32_t)((blue * 257 + (1u << 11)) >> 12);
}

static inline __attribute__((always_inline)) void nearest(struct raster *r, int n, int palette, int grey)
{
    const struct lookup at = lookup_of(&r->surface.texture);
    for (int i = 0; i < n; i++) {
        const uint32_t u = (uint32_t)r->uv[0][i] >> at.down_u & at.mask_u;
        const uint32_t v = (uint32_t)r->uv[1][i] >> at.down_v & at.mask_v;
        const uint32_t rgb = texel(&at, v << at.row | u, palette);
        put(r, i, rgb >> 8 & 0xff00, rgb & 0xff00, rgb << 8 & 0xff00, grey);
    }
}

/* a + (b - a) f / 256 of two fields in a word, times 256: 255 * 2^8 at most in each, so that no carry is left between
 * them, whatever lies there on the way modulo 2^32. */
FX_WRAPS static inline uint32_t blend(uint32_t a, uint32_t b, uint32_t f)
{
    return (a << 8) + (b - a) * f;
}

/* Between rows: fields of 255 * 2^8 at most, times 2^8 and back. */
FX_WRAPS static inline uint32_t blend_wide(uint32_t a, uint32_t b, uint32_t f)
{
    return ((a << 8) + (b - a) * f) >> 8;
}

/* A position in 1/256 texels from the middle of texel 0, rounded. */
FX_WRAPS static inline uint32_t from_middle(int32_t uv, unsigned down)
{
    return ((uint32_t)uv - (1u << (down - 1)) + (1u << (down - 9))) >> (down - 8);
}

FX_WRAPS static inline __attribute__((always_inline)) void bilinear(struct raster *r, int n, int palette, int grey)
{
    const struct lookup at = lookup_of(&r->surface.texture);
    const uint32_t both = 0x00ff00ff;
    for (int i = 0; i < n; i++) {
        const uint32_t u = from_middle(r->uv[0][i], at.down_u), v = from_middle(r->uv[1][i], at.down_v);
        const uint32_t u0 = u >> 8 & at.mask_u, u1 = ((u >> 8) + 1) & at.mask_u, fu = u & 0xff, fv = v & 0xff;
        const uint32_t v0 = (v >> 8 & at.mask_v) << at.row, v1 = (((v >> 8) + 1) & at.mask_v) << at.row;
        const uint32_t a = texel(&at, v0 | u0, palette), b = texel(&at, v0 | u1, palette);
        const uint32_t c = texel(&at, v1 | u0, palette), d = texel(&at, v1 | u1, palette);
        const uint32_t low = blend(a & both, b & both, fu), high = blend(c & both, d & both, fu);
        const uint32_t low_green = blend(a >> 8 & 0xff, b >> 8 & 0xff, fu),
                       high_green = blend(c >> 8 & 0xff, d >> 8 & 0xff, fu);
        put(r, i, blend_wide(low >> 16, high >> 16, fv), blend_wide(low_green, high_green, fv),
            blend_wide(low & 0xffff, high & 0xffff, fv), grey);
    }
}

/* A function a case. */
#define CASE(name, filter, palette, grey)                               \
    static __attribute__((noinline)) void name(struct raster *r, int n) \
    {                                                                   \
        filter(r, n, palette, grey);                                    \
    }
CASE(nearest_565, nearest, 0, 0)
CASE(nearest_565_grey, nearest, 0, 1)
CASE(nearest_palette, nearest, 1, 0)
CASE(nearest_palette_grey, nearest, 1, 1)
CASE(bilinear_565, bilinear, 0, 0)
CASE(bilinear_565_grey, bilinear, 0, 1)
CASE(bilinear_palette, bilinear, 1, 0)
CASE(bilinear_palette_grey, bilinear, 1, 1)

static void find_factors(struct raster *r, int n, int grey)
{
    const struct scene_texture *t = r->surface.texture.head;
    const int palette = t->format == TEXTURE_PALETTE8;
    if (t->flags & TEXTURE_BILINEAR) {
        if (grey)
            (palette ? bilinear_palette_grey : bilinear_565_grey)(r, n);
        else
            (palette ? bilinear_palette : bilinear_565)(r, n);
    } else {
        if (grey)
            (palette ? nearest_palette_grey : nearest_565_grey)(r, n);
        else
            (palette ? nearest_palette : nearest_565)(r, n);
    }
}

/* Sums are below 25 * 255 * 2^15, see write.c: 2^-8 of them times 2^12 below 2^32. */
static inline __attribute__((always_inline)) void multiply(struct raster *r, int n, unsigned channels, int apart)
{
    uint32_t *sum = r->sum[0];
    const uint32_t *gloss = r->apart[0];
    for (int i = 0; i < n; i++, sum += 3, gloss += 3)
        for (unsigned c = 0; c < channels; c++) {
            const uint32_t lit = (sum[c] >> 8) * (uint32_t)r->value[3 + c][i] >> 4;
            sum[c] = apart ? lit + gloss[c] : lit;
        }
}

void texture_stage(struct raster *r, int n)
{
    const struct scene_texture *t = r->surface.texture.head;
    const int apart = USES(USES_SPECULAR) && r->gloss != r->sum[0];
    const unsigned channels = surface_channels(&r->surface);
    if (t->flags & TEXTURE_CLAMP_U)
        clamp(t, r->uv[0], n, t->log2_width);
    if (t->flags & TEXTURE_CLAMP_V)
        clamp(t, r->uv[1], n, t->log2_height);
    find_factors(r, n, channels == 1);
    if (channels == 1)
        apart ? multiply(r, n, 1, 1) : multiply(r, n, 1, 0);
    else
        apart ? multiply(r, n, 3, 1) : multiply(r, n, 3, 0);
}
