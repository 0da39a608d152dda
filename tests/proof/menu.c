/* SPDX-License-Identifier: MIT */
/*
 * The menu's lines hold whatever the program shows, any names, numbers and angles, on any band of it. Drawing letters
 * is tests/proof/text.c's.
 *
 *   proves: menu_line menu_draw
 *   assumes: text_draw
 *   options: -eva-precision 2 -eva-slevel-function menu_draw:50,text_add:2000,text_pad:2000,menu_line:50
 */
#include "proof.h"
#include <string.h>

#include "firmware/app/text.h"

/*@ requires valid_read_string(text) && \valid_read(canvas) && \valid_read(canvas->band);
    assigns ((uint8_t *)canvas->band->pixels)[0 .. canvas->band->rows * canvas->band->stride - 1] \from canvas->dark; */
void text_draw(const struct text_canvas *canvas, uint32_t x, uint32_t y, const char *text);

#include "firmware/app/text.c"

#include "firmware/app/menu.c"

#define NAME 40

static char name[NAME];
static const uint32_t word;
const struct program_scene program_scenes[] = {{name, &word, &word}, {name, &word, &word}};
const unsigned program_scene_count = 2;
const struct glint_choice glint_choices[2] = {{.name = name}, {.name = name}};

static void menu(uint16_t width, uint8_t format)
{
    static uint16_t pixels[8 * 320];
    static struct app app;
    const struct glint_band band = {pixels, (uint16_t)any_u32(0, 2048), (uint16_t)any_u32(0, 8),
                                    format == GLINT_RGB565 ? 2u * width : width / 2u};
    const struct text_canvas canvas = {&band, width, format, 0};
    any_bytes(&app.control, sizeof app.control);
    app.control.scene = (uint16_t)any_u32(0, 1);
    app.control.method = (uint16_t)any_u32(0, 1);
    any_bytes(name, sizeof name - 1);
    menu_draw(&app, &canvas);
}

void prove(void)
{
    menu(240, GLINT_RGB565);

    menu(128, GLINT_GREY4);
}
