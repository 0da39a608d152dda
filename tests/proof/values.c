/* SPDX-License-Identifier: MIT */
/*
 * Switches and buttons in options and board files: any text of up to LONGEST bytes, and as many buttons as there are
 * lines and one more. Numbers are numbers.c's.
 *
 *   proves: values_switch values_button values_keys
 *   options: -machdep gcc_x86_64 -eva-precision 3 -eva-slevel 3000 -eva-split-return full
 */
#include "proof.h"

#include <string.h>

#include "boards/linux/values.h"
#include "host/numbers.h"

/* By cases, so that what lies behind has a known place. */
static size_t before_byte(const char *text, char byte)
{
    size_t length = 0;
    //@ loop unroll 99;
    while (text[length] && text[length] != byte)
        length++;
    return length;
}
static char *find_byte(char *text, char byte)
{
    char *at = text + before_byte(text, byte);
    return *at == byte ? at : 0;
}
#define strcspn(text, bytes) before_byte(text, (bytes)[0])
#define strchr(text, byte)   find_byte(text, byte)
#define strlen(text)         before_byte(text, 0)
#include "boards/linux/values.c"
#undef strlen
#undef strchr
#undef strcspn
#include "hal/host/numbers.c"

#define LONGEST 4

static void keys(char *text)
{
    struct keys_config keys;
    if (values_keys(text, &keys)) {
        //@ assert keys.count <= GPIO_LINES;
        //@ assert keys.count == 0 || \initialized(keys.line + (0 .. keys.count - 1));
        //@ assert keys.count == 0 || \initialized(keys.button + (0 .. keys.count - 1));
    }
}

static void any_text(uint32_t length)
{
    char text[LONGEST + 1];
    uint8_t on;
    any_bytes(text, sizeof text - 1);
    text[LONGEST] = 0;
    values_switch(text + LONGEST - length, &on);
    keys(text + LONGEST - length);
}

void prove(void)
{
    uint8_t on;
    char none[] = "none", most[] = "up=1,down=2,left=3,right=4,a=5,b=6,x=7,y=8,a=9,a=0,a=1,a=2,a=3,a=4,a=5,a=6";
    char more[] = "a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1,a=1";
    values_switch(0, &on);
    values_switch("on", &on);
    values_switch("off", &on);
    keys(none);
    keys(most);
    keys(more);
    //@ loop unroll 5;
    for (uint32_t length = 0; length <= LONGEST; length++)
        any_text(length);
}
