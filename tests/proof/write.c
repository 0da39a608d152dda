/* SPDX-License-Identifier: MIT */
/*
 * raster/write.c: any sums, any mask, in each format, dithered or not, into a band of 17 x 3 pixels that fills its
 * memory; and the clearing of any band up to that. A run is at any place of a row that has room for its mask.
 *
 *   proves: level pack put raster_colour write_some write_all raster_write fill raster_clear
 *   options: -eva-precision 1 -eva-slevel 400
 */
#include "proof.h"

#include "firmware/raster/write.c"

#define WIDTH 17
#define ROWS  3

static struct raster raster;
static uint32_t pixels[(3 * WIDTH * ROWS + 3) / 4];
static uint32_t depth[(2 * WIDTH * ROWS + 3) / 4];

void surface_colour(const struct palette *palette, const uint16_t rgb_q15[3], uint32_t *sum)
{
    for (int i = 0; i < 3; i++)
        sum[i] = any_u32(0, 255u << 15);
}

static void any_band(unsigned format, unsigned rows)
{
    static const uint8_t bits[] = {[GLINT_GREY8] = 8, [GLINT_RGB565] = 16, [GLINT_RGB888] = 24, [GLINT_GREY4] = 4};
    struct raster *r = &raster;
    r->width = WIDTH;
    r->format = format;
    r->stride = (WIDTH * bits[format] + 7) / 8;
    r->y0 = 2;
    r->y1 = 2 + rows;
    r->dither = any_flag();
    r->palette.channels = format == GLINT_RGB565 || format == GLINT_RGB888 ? 3 : 1;
    for (unsigned i = 0; i < 3; i++)
        r->palette.top[i] = raster_top(format, i);
    /* The last bytes of the memory: one too many leaves it. */
    r->pixels = (uint8_t *)pixels + (sizeof pixels - (rows * r->stride + 3) / 4 * 4);
    r->depth = (uint16_t *)(depth + (sizeof depth - (rows * 2 * WIDTH + 3) / 4 * 4) / 4);
    for (int i = 0; i < RUN; i++)
        for (int k = 0; k < 3; k++)
            r->sum[i][k] = any_u32(0, (8 * 3 + 1) * 255u << 15);
}

void prove(void)
{
    static const unsigned formats[] = {GLINT_GREY8, GLINT_RGB565, GLINT_RGB888, GLINT_GREY4};
    struct scene_header scene;
    any_bytes(&scene, sizeof scene);
    //@ loop unroll 4;
    for (unsigned i = 0; i < 4; i++)
        //@ loop unroll 3;
        for (unsigned rows = 1; rows <= ROWS; rows++) {
            any_band(formats[i], rows);
            raster_clear(&raster, &scene);
            //@ loop unroll 16;
            for (int n = 1; n <= RUN; n++) {
                const uint32_t all = (1u << n) - 1;
                raster_write(&raster, any_s32(0, WIDTH - n), any_s32(2, 1 + (int)rows), any_u32(1, all));
                raster_write(&raster, any_s32(0, WIDTH - n), any_s32(2, 1 + (int)rows), all);
            }
        }
}
