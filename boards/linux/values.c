/* SPDX-License-Identifier: MIT */
#include "boards/linux/values.h"

#include "host/numbers.h"

#include <stddef.h>
#include <string.h>

int values_number(const char *text, uint32_t low, uint32_t high, uint32_t *value)
{
    return numbers_whole(text, low, high, value);
}

int values_short(const char *text, uint32_t low, uint32_t high, uint16_t *value)
{
    uint32_t number;
    if (!values_number(text, low, high, &number))
        return 0;
    *value = (uint16_t)number;
    return 1;
}

int values_size(const char *text, uint16_t *width, uint16_t *height)
{
    return numbers_size(text, 320, width, height);
}

int values_hertz(const char *text, uint32_t *value)
{
    uint32_t whole, unit = 1, part = 0;
    const char *at = numbers_digits(text, &whole);
    const char *fraction = at && *at == '.' ? at + 1 : NULL;
    if (!at || (fraction && !(at = numbers_digits(fraction, &part))))
        return 0;
    if (*at == 'k' || *at == 'M')
        unit = *at++ == 'k' ? 1000 : 1000000;
    uint64_t hertz = (uint64_t)whole * unit, scale = 1;
    /* zeros behind the point may be any number: scale stops at 10 units, 10^7; part * unit < 2^52 */
    for (const char *digit = fraction; digit && *digit >= '0' && *digit <= '9' && scale <= unit; digit++)
        scale *= 10;
    if (*at || (fraction && (scale > unit || unit == 1)))
        return 0;
    hertz += (uint64_t)part * unit / scale;
    if (hertz < 1 || hertz > UINT32_MAX)
        return 0;
    *value = (uint32_t)hertz;
    return 1;
}

int values_switch(const char *text, uint8_t *value)
{
    int on = !text || strcmp(text, "on") == 0;
    if (!on && strcmp(text, "off") != 0)
        return 0;
    *value = (uint8_t)on;
    return 1;
}

int values_pin(char *text, struct wires_pin *pin)
{
    int inverted = *text == '!';
    const char *line = text + inverted;
    if (!*line)
        return 0;
    pin->line = strcmp(text, "none") == 0 ? NULL : line;
    pin->inverted = (uint8_t)inverted;
    return 1;
}

static uint16_t values_button(const char *name)
{
    static const char *const names[] = {"up", "down", "left", "right", "a", "b", "x", "y"};
    for (unsigned i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(names[i], name) == 0)
            return (uint16_t)(1u << i);
    return 0;
}

int values_keys(char *text, struct keys_config *keys)
{
    unsigned count = 0;
    if (strcmp(text, "none") == 0)
        text += strlen(text);
    for (char *next; *text; text = next) {
        next = text + strcspn(text, ",");
        if (*next)
            *next++ = 0;
        char *line = strchr(text, '=');
        if (!line || !line[1] || count == GPIO_LINES)
            return 0;
        *line++ = 0;
        keys->line[count] = line;
        keys->button[count] = values_button(text);
        if (!keys->button[count++])
            return 0;
    }
    keys->count = count;
    return 1;
}
