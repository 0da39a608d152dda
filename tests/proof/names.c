/* SPDX-License-Identifier: MIT */
/*
 * A device's names, of any bytes that end with a zero: nothing is read behind them, whatever list and place are asked
 * for. All texts of up to LONGEST bytes, which lie at their room's end; longer ones are more of the same words.
 *
 *   proves: names_set names_at names_count names_find words_character words_put
 *   options: -machdep gcc_x86_64 -eva-precision 3 -eva-slevel 3000 -eva-split-return full
 */
#include "proof.h"

#include <string.h>

/* By cases, so that what lies behind a word has a known place. */
static size_t length_of(const char *text)
{
    size_t length = 0;
    //@ loop unroll 8;
    while (text[length])
        length++;
    return length;
}
#define strlen length_of
#include "host-tools/view/names.c"
#undef strlen
#include "host-tools/view/words.c"

#define LONGEST 4

/* Of the bytes behind the text nobody has written any. */
static void names(const char *text, uint32_t length)
{
    struct names n;
    char name[2];
    n.length = 0;
    names_at(&n, NAMES_SCENES, ANY_U32); /* nobody said hello */
    names_set(&n, text, length);
    any_bytes(name, 1);
    name[1] = 0;
    //@ loop unroll 2;
    for (enum names_list list = 0; list < NAMES_LISTS; list++) {
        //@ loop unroll 4;
        for (uint32_t index = 0; index <= 1; index++)
            names_at(&n, list, index);
        names_at(&n, list, any_u32(2, UINT32_MAX));
        names_count(&n, list);
        names_find(&n, list, name);
    }
}

static FILE file;

void prove(void)
{
    //@ loop unroll 4;
    for (uint32_t length = 1; length <= LONGEST; length++) {
        char text[LONGEST];
        any_bytes(text, sizeof text);
        text[LONGEST - 1] = 0;
        names(text + LONGEST - length, length);
        words_put(&file, text + LONGEST - length, length);
    }
}
