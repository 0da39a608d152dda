/* SPDX-License-Identifier: MIT */
#include "view/overlay.h"

#include "app/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define OVERLAY_BOX   0xB0000000u
#define OVERLAY_INK   0xFFFFFFFFu
#define OVERLAY_INSET 2u

/* As text.c's letters: five rows from the top, an octal digit each. */
static const struct {
    char mark;
    uint16_t rows;
} overlay_marks[] = {{'?', 071202}, {'%', 051245},  {'(', 012221}, {')', 042224},  {'+', 002720}, {'=', 007070},
                     {'_', 000007}, {'<', 012421},  {'>', 042124}, {'\'', 022000}, {'"', 055000}, {'#', 057575},
                     {'*', 052720}, {'[', 032223},  {']', 062226}, {';', 002024},  {'@', 025543}, {'&', 025253},
                     {'|', 022222}, {'\\', 044211}, {'^', 025000}, {'~', 000360},  {'$', 036236}, {'{', 032423},
                     {'}', 062126}, {'`', 042000}};

void overlay_add(struct overlay_text *text, const char *format, ...)
{
    char line[1024 + 64];
    if (text->count == OVERLAY_LINES)
        return;
    va_list values;
    va_start(values, format);
    vsnprintf(line, sizeof line, format, values);
    va_end(values);
    char *out = text->lines[text->count++], *end = out + OVERLAY_COLUMNS;
    for (const char *in = line; *in && out != end; in++)
        if ((*in & 0xC0) != 0x80) /* a character of UTF-8 begins here */
            *out++ = (char)(*in < ' ' || *in > '~' ? '?' : *in);
    *out = 0;
}

static unsigned overlay_letter(char c)
{
    for (unsigned i = 0; i < sizeof overlay_marks / sizeof *overlay_marks; i++)
        if (overlay_marks[i].mark == c)
            return overlay_marks[i].rows;
    return text_glyph(c);
}

/* Inside the overlay only. */
static void overlay_put(const struct overlay *o, unsigned x, unsigned y, uint32_t colour)
{
    if (x < o->width && y < o->height)
        o->pixels[(size_t)y * o->width + x] = colour;
}

static void overlay_line(const struct overlay *o, unsigned x, unsigned y, const char *line)
{
    for (; *line; line++, x += OVERLAY_CELL) {
        unsigned letter = overlay_letter(*line);
        for (unsigned i = 0; i < 15; i++)
            if (letter >> (14 - i) & 1)
                overlay_put(o, x + i % 3, y + i / 3, OVERLAY_INK);
    }
}

void overlay_draw(const struct overlay *o, enum overlay_place place, const struct overlay_text *text)
{
    unsigned columns = 0;
    for (unsigned i = 0; i < text->count; i++)
        columns = strlen(text->lines[i]) > columns ? (unsigned)strlen(text->lines[i]) : columns;
    if (columns == 0)
        return;
    /* the last letter's gap is the box's edge */
    unsigned width = columns * OVERLAY_CELL - 1 + 2 * OVERLAY_INSET;
    unsigned height = text->count * OVERLAY_LINE - 2 + 2 * OVERLAY_INSET;
    unsigned left = place == OVERLAY_MIDDLE && width < o->width ? (o->width - width) / 2 : 0;
    unsigned top = place == OVERLAY_TOP || height > o->height ? 0 : o->height - height;
    top /= place == OVERLAY_MIDDLE ? 2 : 1;
    for (unsigned y = 0; y < height; y++)
        for (unsigned x = 0; x < width; x++)
            overlay_put(o, left + x, top + y, OVERLAY_BOX);
    for (unsigned i = 0; i < text->count; i++)
        overlay_line(o, left + OVERLAY_INSET, top + OVERLAY_INSET + i * OVERLAY_LINE, text->lines[i]);
}
