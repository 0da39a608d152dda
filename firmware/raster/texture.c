/* SPDX-License-Identifier: MIT */
/*
 * The stages of a run that a texture adds: coordinates, their clamp, and the product with texels. Each is a loop
 * made for its case.
 */
#include "raster/texture.h"

#include "shade/uv.h"

#define ONE_TURN (1 << 28)

void texture_coordinates(struct raster *r, int x, int y, int n)
{
    const struct shade_setup *setup = &r->setup;
    const int divides = USES(USES_PERSPECTIVE) && setup->uv_kind == GLINT_TEXTURE_PERSPECTIVE;
    if (divides) {
        plane_values(&setup->plane, &setup->depth, x, y, n, r->value[0]);
        for (int i = 0; i < n; i++)
            r->divisor[i] = perspective_divisor(fx_wrap_u32(r->value[0][i]), setup->uv_up);
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

/* What a texel multiplies a channel's sum by, Q12: from its fields in units of 2^-16 of 255 (palette), 31 or 63 (565),
 * rounded. 2^16 and 2^13 of them are left for the product: below 2^29. Sums are below 25 * 255 * 2^15, see write.c:
 * 2^-8 of them times 2^12 stay below 2^32. */
static inline uint32_t factor_of(uint32_t field, uint32_t top)
{
    const uint32_t down = top == 255 ? 8 : top == 63 ? 6 : 5; /* to 2^16 at most */
    const uint32_t whole = top << (16 - down);
    return ((field >> down) * (((1u << 28) + whole / 2) / whole) + (1u << 15)) >> 16;
}

/* Templates from here on: `palette` and `grey` are constant. Multiplies a pixel's sums by fields of 2^16 times a
 * texel's.
 */
static inline __attribute__((always_inline)) void multiply(uint32_t *sum, const uint16_t weight[3], uint32_t red,
                                                           uint32_t green, uint32_t blue, int palette, int grey)
{
    red = factor_of(red, palette ? 255 : 31);
    green = factor_of(green, palette ? 255 : 63);
    blue = factor_of(blue, palette ? 255 : 31);
    if (grey) {
        sum[0] = (sum[0] >> 8) * ((red * weight[0] + green * weight[1] + blue * weight[2] + 128) >> 8) >> 4;
        return;
    }
    sum[0] = (sum[0] >> 8) * red >> 4;
    sum[1] = (sum[1] >> 8) * green >> 4;
    sum[2] = (sum[2] >> 8) * blue >> 4;
}

/* A texel's red and blue, in either half of a word, and its green. */
struct fields {
    uint32_t red_blue, green;
};

static inline __attribute__((always_inline)) struct fields texel(const struct lookup *at, uint32_t index, int palette)
{
    if (palette) {
        const uint32_t rgb = at->palette[((const uint8_t *)at->texels)[index]];
        return (struct fields){rgb & 0x00ff00ff, rgb >> 8}; /* the highest byte of an entry is 0 */
    }
    const uint32_t t = ((const uint16_t *)at->texels)[index];
    return (struct fields){(t & 0xf800) << 5 | (t & 0x1f), t >> 5 & 0x3f};
}

static inline __attribute__((always_inline)) void nearest(struct raster *r, int n, int palette, int grey)
{
    const struct lookup at = lookup_of(&r->surface.texture);
    uint32_t *sum = r->sum[0];
    for (int i = 0; i < n; i++, sum += 3) {
        const uint32_t u = fx_wrap_u32(r->uv[0][i]) >> at.down_u & at.mask_u;
        const uint32_t v = fx_wrap_u32(r->uv[1][i]) >> at.down_v & at.mask_v;
        const struct fields f = texel(&at, v << at.row | u, palette);
        multiply(sum, r->surface.texture.grey, f.red_blue & 0xffff0000, (palette ? f.green & 0xff : f.green) << 16,
                 (f.red_blue & 0xffff) << 16, palette, grey);
    }
}

/* 256 a + (b - a) f of fields in a word, at most 255 * 2^8 in each: no carry is left between them, whatever lies there
 * on the way modulo 2^32. */
FX_WRAPS static inline uint32_t blend(uint32_t a, uint32_t b, uint32_t f)
{
    return (a << 8) + (b - a) * f;
}

/* A position in 1/256 texels from the middle of texel 0, rounded. */
FX_WRAPS static inline uint32_t from_middle(int32_t uv, unsigned down)
{
    return (fx_wrap_u32(uv) - (1u << (down - 1)) + (1u << (down - 9))) >> (down - 8);
}

static inline __attribute__((always_inline)) void bilinear(struct raster *r, int n, int palette, int grey)
{
    const struct lookup at = lookup_of(&r->surface.texture);
    const uint32_t byte = palette ? 0xff : 0x3f;
    uint32_t *sum = r->sum[0];
    for (int i = 0; i < n; i++, sum += 3) {
        const uint32_t u = from_middle(r->uv[0][i], at.down_u), v = from_middle(r->uv[1][i], at.down_v);
        const uint32_t u0 = u >> 8 & at.mask_u, u1 = ((u >> 8) + 1) & at.mask_u, fu = u & 0xff, fv = v & 0xff;
        const uint32_t v0 = (v >> 8 & at.mask_v) << at.row, v1 = (((v >> 8) + 1) & at.mask_v) << at.row;
        const struct fields a = texel(&at, v0 | u0, palette), b = texel(&at, v0 | u1, palette);
        const struct fields c = texel(&at, v1 | u0, palette), d = texel(&at, v1 | u1, palette);
        const uint32_t low = blend(a.red_blue, b.red_blue, fu), high = blend(c.red_blue, d.red_blue, fu);
        const uint32_t low_green = blend(a.green & byte, b.green & byte, fu),
                       high_green = blend(c.green & byte, d.green & byte, fu);
        multiply(sum, r->surface.texture.grey, blend(low >> 16, high >> 16, fv), blend(low_green, high_green, fv),
                 blend(low & 0xffff, high & 0xffff, fv), palette, grey);
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

static void multiply_run(struct raster *r, int n, int grey)
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

void texture_stage(struct raster *r, int n)
{
    const struct scene_texture *t = r->surface.texture.head;
    const unsigned channels = surface_channels(&r->surface);
    if (t->flags & TEXTURE_CLAMP_U)
        clamp(t, r->uv[0], n, t->log2_width);
    if (t->flags & TEXTURE_CLAMP_V)
        clamp(t, r->uv[1], n, t->log2_height);
    multiply_run(r, n, channels == 1);
    if (USES(USES_SPECULAR) && r->gloss != r->sum[0])
        for (int i = 0; i < n; i++)
            for (unsigned c = 0; c < channels; c++)
                r->sum[i][c] += r->apart[i][c];
}
