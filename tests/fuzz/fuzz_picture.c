/* SPDX-License-Identifier: MIT */
/* Pictures: any bytes become one that is whole, or one message and exit code 1; by libpng, with our reading around it.
 */
#include "compare/image.h"
#include "fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *told = NULL;
    size_t told_size = 0;
    struct image image;
    FILE *was = stderr, *heard = open_memstream(&told, &told_size);
    FUZZ_CHECK(heard);
    stderr = heard;
    int code = size ? image_read_png_bytes("a.png", data, size, &image) : 1;
    fclose(heard);
    stderr = was;
    const char *end = strchr(told, '\n');
    FUZZ_CHECK(size == 0 || (code == 0 ? told_size == 0 : code == 1 && end && !end[1] && !image.rgb));
    if (code == 0) {
        uint32_t sum = 0; /* of all bytes: a sanitizer sees one that is not there */
        FUZZ_CHECK(image.width && image.height && image.width <= IMAGE_MAX_SIZE && image.height <= IMAGE_MAX_SIZE);
        for (size_t i = 0; i < 3 * (size_t)image.width * image.height; i++)
            sum ^= image.rgb[i];
        FUZZ_CHECK(sum <= 255);
        image_free(&image);
    }
    free(told);
    return 0;
}
