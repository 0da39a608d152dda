/* SPDX-License-Identifier: MIT */
#include "compare/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

bool compare_values(const double *a, const double *b, const uint8_t *mask, size_t pixels, unsigned channels,
                    struct compare_result *result)
{
    double *largest = malloc((pixels ? pixels : 1) * sizeof *largest), squares = 0;
    if (!largest)
        return false;
    *result = (struct compare_result){.psnr_db = INFINITY};
    for (size_t i = 0; i < pixels; i++) {
        double most = 0;
        if (!mask[i])
            continue;
        for (unsigned c = 0; c < channels; c++) {
            double difference = fabs(a[i * channels + c] - b[i * channels + c]);
            squares += difference * difference;
            most = fmax(most, difference);
        }
        largest[result->pixels++] = most;
    }
    if (result->pixels > 0) {
        qsort(largest, result->pixels, sizeof *largest, compare_doubles);
        result->max = largest[result->pixels - 1];
        result->p999 = largest[(result->pixels * 999 + 999) / 1000 - 1];
        result->rms = sqrt(squares / ((double)result->pixels * channels));
        result->psnr_db = result->rms > 0 ? 20 * log10(255 / result->rms) : INFINITY;
    }
    free(largest);
    return true;
}

void compare_background(const struct image *image, uint8_t rgb[3])
{
    size_t right = image->width - 1u, bottom = (size_t)image->width * (image->height - 1u);
    const uint8_t *corner[4] = {image->rgb, image->rgb + 3 * right, image->rgb + 3 * bottom,
                                image->rgb + 3 * (bottom + right)};
    int best = 0, most = 0;
    for (int i = 0; i < 4; i++) {
        int count = 0;
        for (int j = 0; j < 4; j++)
            count += memcmp(corner[i], corner[j], 3) == 0;
        if (count > most)
            best = i, most = count;
    }
    memcpy(rgb, corner[best], 3);
}

bool compare_images(const struct image *a, const struct image *b, const uint8_t background[3],
                    struct compare_result *result)
{
    size_t pixels = (size_t)a->width * a->height;
    double *values = malloc(6 * pixels * sizeof *values);
    uint8_t *mask = malloc(pixels), under_a[3], under_b[3];
    bool done = values && mask;
    compare_background(a, under_a);
    compare_background(b, under_b);
    for (size_t i = 0; done && i < pixels; i++)
        mask[i] = memcmp(a->rgb + 3 * i, background ? background : under_a, 3) != 0 ||
                  memcmp(b->rgb + 3 * i, background ? background : under_b, 3) != 0;
    for (size_t i = 0; done && i < 3 * pixels; i++) {
        values[i] = a->rgb[i];
        values[3 * pixels + i] = b->rgb[i];
    }
    done = done && compare_values(values, values + 3 * pixels, mask, pixels, 3, result);
    free(values);
    free(mask);
    return done;
}

void compare_difference(const struct image *a, const struct image *b, uint8_t *rgb)
{
    for (size_t i = 0; i < (size_t)a->width * a->height * 3; i++) {
        int value = 128 + 8 * (b->rgb[i] - a->rgb[i]);
        rgb[i] = (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
    }
}
