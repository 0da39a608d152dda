/* SPDX-License-Identifier: MIT */
#include "view/unpack.h"

#include <string.h>

struct unpack {
    const struct unpack_rows *rows;
    const uint8_t *in, *in_end;
    uint8_t *out, *out_end;
    unsigned size;  /* bytes a pixel; GREY4 is packed in pairs */
    unsigned kind;  /* of the last copy, 0: none so far */
    uint8_t before; /* grey: the pixel before */
    int red, green, blue;
};

static const unsigned unpack_bits[STREAM_FORMATS] = {16, 24, 8, 4};

size_t unpack_row_bytes(enum stream_format format, uint32_t width)
{
    return ((size_t)width * unpack_bits[format] + 7) / 8;
}

/* The pixel before, by channels. */
static void unpack_look(struct unpack *u)
{
    if (u->out == u->rows->pixels)
        return;
    const uint8_t *at = u->out - u->size;
    switch (u->rows->format) {
    case STREAM_RGB565:
        u->red = at[1] >> 3;
        u->green = (at[1] & 7) << 3 | at[0] >> 5;
        u->blue = at[0] & 31;
        break;
    case STREAM_RGB888:
        u->red = at[0];
        u->green = at[1];
        u->blue = at[2];
        break;
    default:
        u->before = *at;
    }
}

static bool unpack_copy(struct unpack *u, unsigned kind, size_t count)
{
    const uint8_t *first = u->rows->pixels, *from;
    size_t bytes = count * u->size;
    if (bytes > (size_t)(u->out_end - u->out))
        return false;
    if (kind == PACK_LEFT && u->out == first) { /* the pixel before the first is 0 */
        memset(u->out, 0, u->size);
        u->out += u->size;
        bytes -= u->size;
    }
    if (kind == PACK_LEFT)
        from = u->out - u->size;
    else if (kind == PACK_ABOVE && (size_t)(u->out - first) >= u->rows->stride)
        from = u->out - u->rows->stride;
    else if (kind == PACK_LAST && u->rows->last)
        from = u->rows->last + (u->out - first);
    else
        return false;
    for (; bytes; bytes--) /* forwards: what was just written may be copied again */
        *u->out++ = *from++;
    u->kind = kind;
    return true;
}

static bool unpack_put_colour(struct unpack *u, int red, int green, int blue)
{
    if (u->out == u->out_end)
        return false;
    unpack_look(u);
    red += u->red, green += u->green, blue += u->blue;
    if (u->rows->format == STREAM_RGB565) {
        unsigned pixel = (unsigned)(red & 31) << 11 | (unsigned)(green & 63) << 5 | (unsigned)(blue & 31);
        *u->out++ = (uint8_t)(pixel & 255);
        *u->out++ = (uint8_t)(pixel >> 8);
    } else {
        *u->out++ = (uint8_t)(red & 255);
        *u->out++ = (uint8_t)(green & 255);
        *u->out++ = (uint8_t)(blue & 255);
    }
    return true;
}

static bool unpack_put_grey(struct unpack *u, int difference)
{
    if (u->out == u->out_end)
        return false;
    unpack_look(u);
    *u->out++ = (uint8_t)((u->before + difference) & 255);
    return true;
}

/* Of the two nibbles, each by itself. */
static bool unpack_put_pair(struct unpack *u, int left, int right)
{
    if (u->out == u->out_end)
        return false;
    unpack_look(u);
    *u->out++ = (uint8_t)((((u->before >> 4) + left) & 15) << 4 | ((u->before + right) & 15));
    return true;
}

static bool unpack_step(struct unpack *u, unsigned step)
{
    int s = (int)step, sign = step & 8 ? -1 : 1;
    switch (u->rows->format) {
    case STREAM_GREY8:
        return unpack_put_grey(u, s < 12 ? s - 12 : s - 11);
    case STREAM_GREY4:
        s += s >= 12;
        return unpack_put_pair(u, s / 5 - 2, s % 5 - 2);
    default:
        if (step < 16)
            return unpack_put_colour(u, sign * (s >> 1 & 1), sign * (1 + (s >> 2 & 1)), sign * (s & 1));
        s -= 16;
        s += s >= 4;
        return unpack_put_colour(u, s / 3 - 1, 0, s % 3 - 1);
    }
}

/* 3 or 6 bits, two's complement. */
static int unpack_signed(unsigned value, unsigned bits)
{
    return (int)(value & ((1u << bits) - 1)) - (value >> (bits - 1) & 1 ? 1 << bits : 0);
}

static bool unpack_wide(struct unpack *u, unsigned code)
{
    int first = unpack_signed(code >> 3, 3), second = unpack_signed(code, 3), green = unpack_signed(code, 6);
    if (u->rows->format == STREAM_GREY8)
        return unpack_put_grey(u, first) && unpack_put_grey(u, second);
    if (u->rows->format == STREAM_GREY4)
        return unpack_put_pair(u, first, second);
    if (u->in == u->in_end)
        return false;
    int both = *u->in++, half = u->rows->format == STREAM_RGB565 ? 2 : 1;
    int level = (green - (green & (half - 1))) / half; /* rounded down */
    return unpack_put_colour(u, level + (both >> 4) - 8, green, level + (both & 15) - 8);
}

static bool unpack_literal(struct unpack *u)
{
    if ((size_t)(u->in_end - u->in) < u->size || u->out == u->out_end)
        return false;
    memcpy(u->out, u->in, u->size);
    u->in += u->size;
    u->out += u->size;
    return true;
}

static bool unpack_token(struct unpack *u, unsigned code)
{
    unsigned kind = code >> 5 & 3, low = code & 31;
    if (code >= PACK_MORE)
        return u->kind && unpack_copy(u, u->kind, 8 * ((code & 63) + 1));
    if (code >= PACK_WIDE)
        return unpack_wide(u, code & 63);
    if (low < PACK_STEPS)
        return unpack_step(u, low) && (!kind || unpack_copy(u, kind, 1));
    if (kind)
        return unpack_copy(u, kind, (low & 7) + 1);
    return code == PACK_LITERAL && unpack_literal(u);
}

bool unpack_rows(const struct unpack_rows *rows)
{
    struct unpack u = {.rows = rows, .in = rows->packed, .in_end = rows->packed + rows->packed_bytes};
    u.out = rows->pixels;
    u.out_end = rows->pixels + rows->bytes;
    u.size = unpack_bits[rows->format] > 8 ? unpack_bits[rows->format] / 8 : 1;
    while (u.in != u.in_end)
        if (!unpack_token(&u, *u.in++))
            return false;
    return u.out == u.out_end;
}
