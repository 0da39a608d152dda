/* SPDX-License-Identifier: MIT */
#include "report/picture.h"

#include <math.h>
#include <png.h>
#include <stdlib.h>

/* RFC 4648. */
static void picture_base64(FILE *out, const uint8_t *bytes, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < size; i += 3) {
        uint32_t group = (uint32_t)bytes[i] << 16;
        group |= i + 1 < size ? (uint32_t)bytes[i + 1] << 8 : 0;
        group |= i + 2 < size ? bytes[i + 2] : 0;
        const char four[4] = {digits[group >> 18], digits[group >> 12 & 63],
                              i + 1 < size ? digits[group >> 6 & 63] : '=', i + 2 < size ? digits[group & 63] : '='};
        fwrite(four, 1, sizeof four, out);
    }
}

int picture_level(double difference)
{
    int octave;
    if (fabs(difference) < .5)
        return 0;
    frexp(difference, &octave); /* |difference| in [2^(octave - 1), 2^octave) */
    int level = octave + 1 < PICTURE_LEVELS ? octave + 1 : PICTURE_LEVELS;
    return difference > 0 ? level : -level;
}

void picture_colour(int level, uint8_t rgb[3])
{
    static const double bright[3] = {1, .6, .2}, dark[3] = {.35, .7, 1};
    double value = level ? 255. * (abs(level) + 1) / (PICTURE_LEVELS + 1) : 0;
    for (int c = 0; c < 3; c++)
        rgb[c] = (uint8_t)lround(value * (level > 0 ? bright[c] : dark[c]));
}

static void picture_palette(png_structp png, png_infop info)
{
    png_color palette[2 * PICTURE_LEVELS + 1];
    for (int i = 0; i <= 2 * PICTURE_LEVELS; i++) {
        uint8_t rgb[3];
        picture_colour(i - PICTURE_RIGHT, rgb);
        palette[i] = (png_color){rgb[0], rgb[1], rgb[2]};
    }
    png_set_PLTE(png, info, palette, 2 * PICTURE_LEVELS + 1);
}

/* Levels take no filter, the others that which libpng finds best for a row. */
static bool picture_encode(FILE *out, const struct picture *picture)
{
    static const int types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_PALETTE};
    const bool levels = picture->kind == PICTURE_DIFFERENCE;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info || setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_init_io(png, out);
    png_set_compression_level(png, 9);
    png_set_filter(png, 0, levels ? PNG_FILTER_NONE : PNG_ALL_FILTERS);
    png_set_IHDR(png, info, picture->width, picture->height, levels ? 4 : 8, types[picture->kind], PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (levels)
        picture_palette(png, info);
    png_write_info(png, info);
    png_set_packing(png);
    for (unsigned y = 0; y < picture->height; y++)
        png_write_row(png, picture->pixels + (size_t)y * picture->stride);
    png_write_end(png, NULL);
    png_destroy_write_struct(&png, &info);
    return true;
}

bool picture_write(FILE *out, const struct picture *picture, const char *caption)
{
    char *bytes = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&bytes, &size);
    bool done = memory && picture_encode(memory, picture);
    done = memory && fclose(memory) == 0 && done;
    if (done) {
        fprintf(out, "<img loading=\"lazy\" width=\"%u\" height=\"%u\" alt=\"%s\" src=\"data:image/png;base64,",
                picture->width, picture->height, caption);
        picture_base64(out, (const uint8_t *)bytes, size);
        fputs("\">", out);
    }
    free(bytes);
    return done;
}
