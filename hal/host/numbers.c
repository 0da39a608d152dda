/* SPDX-License-Identifier: MIT */
#include "host/numbers.h"

#include <stddef.h>

const char *numbers_digits(const char *text, uint32_t *value)
{
    uint64_t number = 0;
    const char *at = text;
    for (; *at >= '0' && *at <= '9'; at++) {
        number = number * 10 + (uint64_t)(*at - '0');
        if (number > UINT32_MAX)
            return NULL;
    }
    *value = (uint32_t)number;
    return at == text ? NULL : at;
}

int numbers_whole(const char *text, uint32_t low, uint32_t high, uint32_t *value)
{
    uint32_t number;
    const char *end = numbers_digits(text, &number);
    if (!end || *end || number < low || number > high)
        return 0;
    *value = number;
    return 1;
}

int numbers_size(const char *text, uint32_t most, uint16_t *width, uint16_t *height)
{
    uint32_t w, h;
    const char *x = numbers_digits(text, &w);
    if (!x || *x != 'x' || w < 1 || w > most || !numbers_whole(x + 1, 1, most, &h))
        return 0;
    *width = (uint16_t)w;
    *height = (uint16_t)h;
    return 1;
}
