/* SPDX-License-Identifier: MIT */
#include "app/text.h"

#include "fixed/fixed.h"

static const uint16_t text_digits[10] = {075557, 026227, 071747, 071717, 055711,
                                         074717, 074757, 071122, 075757, 075717};
static const uint16_t text_letters[26] = {025755, 065656, 034443, 065556, 074647, 074644, 034553, 055755, 072227,
                                          011152, 055655, 044447, 057755, 065555, 025552, 065644, 025563, 065655,
                                          034216, 072222, 055557, 055552, 055775, 055255, 055222, 071247};

uint16_t text_glyph(char c)
{
    if (c >= '0' && c <= '9')
        return text_digits[c - '0'];
    if (c >= 'a' && c <= 'z')
        return text_letters[c - 'a'];
    if (c >= 'A' && c <= 'Z')
        return text_letters[c - 'A'];
    switch (c) {
    case '-':
        return 000700;
    case '.':
        return 000002;
    case ',':
        return 000024;
    case ':':
        return 002020;
    case '/':
        return 011244;
    case '!':
        return 022202;
    default:
        return 0;
    }
}

static void text_put(uint8_t *row, unsigned format, unsigned x, int lit)
{
    if (format == GLINT_RGB565)
        ((uint16_t *)(void *)row)[x] = lit ? 0xffff : 0;
    else if (x & 1)
        row[x / 2] = (uint8_t)((row[x / 2] & 0xf0) | (lit ? 0x0f : 0));
    else
        row[x / 2] = (uint8_t)((row[x / 2] & 0x0f) | (lit ? 0xf0 : 0));
}

/* One row of pixels of all letters: row `i` of their cells, or none of those, widened to 2^large pixels. */
static void text_row(const struct text_canvas *canvas, uint8_t *row, unsigned x, const char *text, unsigned i)
{
    const unsigned large = text_large(canvas->width), cell = text_width(canvas->width);
    for (; *text && x + cell <= canvas->width; text++) {
        unsigned bits = i < 5 ? text_glyph(*text) >> 3 * (4 - i) & 7u : 0;
        for (unsigned j = 0; j < cell; j++, x++)
            text_put(row, canvas->format, x, (int)(bits >> (3 - (j >> large)) & 1) ^ canvas->dark);
    }
}

void text_draw(const struct text_canvas *canvas, unsigned x, unsigned y, const char *text)
{
    const struct glint_band *band = canvas->band;
    const unsigned large = text_large(canvas->width), lead = canvas->dark, above = lead << large;
    for (unsigned i = 0; i < band->rows; i++) {
        unsigned down = fx_wrap_sub(band->y + i + above, y); /* huge above the text */
        if (down < text_height(canvas->width) + above)
            text_row(canvas, (uint8_t *)band->pixels + i * band->stride, x, text, (down >> large) - lead);
    }
}

void text_add(struct text_line *line, const char *text)
{
    while (*text && line->length < sizeof line->text - 1)
        line->text[line->length++] = *text++;
    line->text[line->length] = 0;
}

void text_pad(struct text_line *line, unsigned length)
{
    while (line->length < length)
        text_add(line, " ");
}

void text_add_number(struct text_line *line, uint32_t value)
{
    char digits[11];
    unsigned at = sizeof digits - 1;
    digits[at] = 0;
    do
        digits[--at] = (char)('0' + value % 10);
    while ((value /= 10) != 0);
    text_add(line, digits + at);
}

void text_add_angle(struct text_line *line, uint16_t angle)
{
    uint32_t thousandths = (angle * 5625u + 512) >> 10; /* 360,000 / 65,536; below 2^29 */
    text_add_number(line, thousandths / 1000);
    /* a 1 before the three digits keeps their zeros, and becomes the point */
    unsigned point = line->length;
    text_add_number(line, 1000 + thousandths % 1000);
    if (point < line->length)
        line->text[point] = '.';
}
