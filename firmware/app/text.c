/* SPDX-License-Identifier: MIT */
#include "app/text.h"

/* Five rows from the top, an octal digit each, the left pixel in its highest bit. */
static const uint16_t text_digits[10] = {075557, 026227, 071747, 071717, 055711,
                                         074717, 074757, 071122, 075757, 075717};
static const uint16_t text_letters[26] = {025755, 065656, 034443, 065556, 074647, 074644, 034553, 055755, 072227,
                                          011152, 055655, 044447, 057755, 065555, 025552, 065644, 025563, 065655,
                                          034216, 072222, 055557, 055552, 055775, 055255, 055222, 071247};

static uint16_t text_glyph(char c)
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

void text_draw(const struct glint_band *band, unsigned format, unsigned width, unsigned x, unsigned y, const char *text)
{
    for (; *text && x + TEXT_WIDTH <= width; text++, x += TEXT_WIDTH) {
        uint16_t glyph = text_glyph(*text);
        for (unsigned i = 0; i < TEXT_HEIGHT; i++) {
            if (y + i < band->y || y + i >= (unsigned)band->y + band->rows)
                continue;
            uint8_t *row = (uint8_t *)band->pixels + (y + i - band->y) * band->stride;
            unsigned bits = i < 5 ? glyph >> 3 * (4 - i) & 7u : 0;
            for (unsigned j = 0; j < TEXT_WIDTH; j++)
                text_put(row, format, x + j, bits << 1 >> (3 - j) & 1);
        }
    }
}

void text_add(struct text_line *line, const char *text)
{
    while (*text && line->length < sizeof line->text - 1)
        line->text[line->length++] = *text++;
    line->text[line->length] = 0;
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
