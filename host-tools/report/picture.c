/* SPDX-License-Identifier: MIT */
#include "report/picture.h"

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

bool picture_write(FILE *out, const uint8_t *pixels, unsigned width, unsigned height, bool rgb, const char *caption)
{
    png_image image = {.version = PNG_IMAGE_VERSION,
                       .width = width,
                       .height = height,
                       .format = rgb ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY};
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    uint8_t *bytes = malloc(size);
    bool done = bytes && png_image_write_to_memory(&image, bytes, &size, 0, pixels, 0, NULL);
    if (done) {
        fprintf(out, "<img width=\"%u\" height=\"%u\" alt=\"%s\" src=\"data:image/png;base64,", width, height, caption);
        picture_base64(out, bytes, size);
        fputs("\">", out);
    }
    free(bytes);
    return done;
}
