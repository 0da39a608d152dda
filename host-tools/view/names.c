/* SPDX-License-Identifier: MIT */
#include "view/names.h"

#include "view/words.h"

#include <string.h>

void names_set(struct names *names, const char *text, uint32_t length)
{
    memcpy(names->text, text, length);
    names->length = length;
}

/* A list ends with an empty name, the last also with the text. */
const char *names_at(const struct names *names, enum names_list list, uint32_t index)
{
    const char *at = names->text, *end = at + names->length;
    unsigned ends = 0;
    if (at == end)
        return NULL;
    for (at += strlen(at) + 1; at < end; at += strlen(at) + 1) {
        if (*at == 0)
            ends++;
        else if (ends == list && index-- == 0)
            return at;
    }
    return NULL;
}

uint32_t names_count(const struct names *names, enum names_list list)
{
    uint32_t count = 0;
    while (names_at(names, list, count))
        count++;
    return count;
}

uint32_t names_find(const struct names *names, enum names_list list, const char *name)
{
    uint32_t index = 0;
    for (const char *at; (at = names_at(names, list, index)) && strcmp(at, name) != 0;)
        index++;
    return index;
}

static void names_line(const char *kind, const char *name)
{
    printf("%s ", kind);
    words_put(stdout, name, strlen(name));
    putchar('\n');
}

void names_print(const struct names *names)
{
    static const char *const kinds[NAMES_LISTS] = {"scene", "method"};
    names_line("board", names->text);
    for (unsigned list = 0; list < NAMES_LISTS; list++)
        for (uint32_t i = 0; names_at(names, list, i); i++)
            names_line(kinds[list], names_at(names, list, i));
}
