/* SPDX-License-Identifier: MIT */
/*
 * Lines of text are cut off where they have no room, whatever is added to them in whatever order; letters of any bytes,
 * at any place, are drawn inside the rows of the band.
 *
 *   proves: text_put text_row text_draw text_add text_pad text_add_number text_add_angle text_glyph
 *   options: -eva-precision 3 -eva-slevel-function text_add:2000,add:2000,text_pad:2000
 */
#include "proof.h"

#include "firmware/app/text.c"

#define ROOM 160 /* of struct text_line */

static void add(const char *text)
{
    struct text_line line = {.length = 0};
    //@ loop widen_hints line.length, 159;
    while (any_flag()) {
        switch (any_u32(0, 3)) {
        case 0:
            text_add(&line, text);
            break;
        case 1:
            text_pad(&line, any_u32(0, ROOM - 1));
            break;
        case 2:
            text_add_number(&line, ANY_U32);
            break;
        default:
            text_add_angle(&line, (uint16_t)any_u32(0, 65535));
        }
        //@ assert line.length < ROOM;
    }
}

static void draw(const char *text, uint16_t width, uint8_t format, uint8_t dark)
{
    static uint16_t pixels[8 * 320];
    const struct glint_band band = {pixels, (uint16_t)any_u32(0, 2048), (uint16_t)any_u32(0, 8),
                                    format == GLINT_RGB565 ? 2u * width : width / 2u};
    const struct text_canvas canvas = {&band, width, format, dark};
    text_draw(&canvas, any_u32(0, 2048), any_u32(0, 2048), text);
}

void prove(void)
{
    char text[200];
    any_bytes(text, sizeof text - 1);
    text[sizeof text - 1] = 0;
    add(text);
    draw(text, 240, GLINT_RGB565, 0);
    draw(text, 320, GLINT_RGB565, 1);
    draw(text, 160, GLINT_RGB565, 1);
    draw(text, 128, GLINT_GREY4, 0);
    draw(text, 80, GLINT_GREY4, 1);
}
