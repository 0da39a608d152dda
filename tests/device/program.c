/* SPDX-License-Identifier: MIT */
#include "tests/device/program.h"

static void line_char(struct line *line, char c)
{
    if (line->length < sizeof line->text - 2)
        line->text[line->length++] = c;
}

void line_text(struct line *line, const char *text)
{
    while (*text)
        line_char(line, *text++);
}

void line_decimal(struct line *line, uint32_t value)
{
    char digits[10];
    int count = 0;
    do
        digits[count++] = (char)('0' + value % 10);
    while ((value /= 10) != 0);
    while (count)
        line_char(line, digits[--count]);
}

void line_hex(struct line *line, uint32_t value)
{
    for (int shift = 28; shift >= 0; shift -= 4)
        line_char(line, "0123456789abcdef"[value >> shift & 15]);
}

void line_end(struct line *line)
{
    line->text[line->length++] = '\n';
    line->text[line->length] = 0;
    program_write(line->text);
    line->length = 0;
}

int text_equal(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

uint32_t text_number(const char *text)
{
    uint32_t value = 0;
    while (*text >= '0' && *text <= '9')
        value = value * 10 + (uint32_t)(*text++ - '0');
    return value;
}
