/* SPDX-License-Identifier: MIT */
#include "view/words.h"

/* Bytes of the character at `at`, or 0 if it is none in UTF-8. */
static size_t words_character(const unsigned char *at, size_t count)
{
    size_t size = *at < 0x80 ? 1 : *at < 0xC2 ? 0 : *at < 0xE0 ? 2 : *at < 0xF0 ? 3 : *at < 0xF5 ? 4 : 0;
    if (size > count)
        return 0;
    for (size_t i = 1; i < size; i++)
        if ((at[i] & 0xC0) != 0x80)
            return 0;
    return size;
}

void words_put(FILE *out, const char *text, size_t length)
{
    const unsigned char *at = (const unsigned char *)text, *end = at + length;
    while (at != end) {
        size_t size = words_character(at, (size_t)(end - at));
        int obeyed = size == 0 || *at < 0x20 || *at == 0x7F || (*at == 0xC2 && at[1] < 0xA0);
        size += size == 0;
        if (obeyed)
            fputc('?', out);
        else
            fwrite(at, 1, size, out);
        at += size;
    }
}
