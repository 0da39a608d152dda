/* SPDX-License-Identifier: MIT */
#include "compare/compare.h"

#include <math.h>
#include <string.h>

#define COMPARE_BINS 256

/* What the figures are made from. In place of sorting: how many pixels differ by how many steps, rounded up. */
struct compare_sums {
    double squares, max;
    size_t pixels, bin[COMPARE_BINS];
};

static void compare_pixel(struct compare_sums *sums, const double *difference, unsigned channels)
{
    double most = 0;
    for (unsigned c = 0; c < channels; c++) {
        sums->squares += difference[c] * difference[c];
        most = fmax(most, fabs(difference[c]));
    }
    sums->max = fmax(sums->max, most);
    sums->bin[(int)fmin(ceil(most), COMPARE_BINS - 1)]++;
    sums->pixels++;
}

static struct compare_result compare_figures(const struct compare_sums *sums, unsigned channels)
{
    struct compare_result result = {.pixels = sums->pixels, .psnr_db = INFINITY, .max = sums->max};
    size_t rank = (sums->pixels * 999 + 999) / 1000, reached = sums->bin[0];
    int step = 0;
    while (reached < rank)
        reached += sums->bin[++step];
    result.p999 = step;
    if (sums->squares > 0) {
        result.rms = sqrt(sums->squares / ((double)sums->pixels * channels));
        result.psnr_db = 20 * log10(255 / result.rms);
    }
    return result;
}

void compare_values(const double *a, const double *b, const uint8_t *mask, size_t pixels, unsigned channels,
                    struct compare_result *result)
{
    struct compare_sums sums = {0};
    for (size_t i = 0; i < pixels; i++) {
        double difference[COMPARE_CHANNELS];
        for (unsigned c = 0; c < channels; c++)
            difference[c] = a[i * channels + c] - b[i * channels + c];
        if (mask[i])
            compare_pixel(&sums, difference, channels);
    }
    *result = compare_figures(&sums, channels);
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

/* The pixels that are `under_a` and `under_b` are left out; null: none is. */
static void compare_covered(const struct image *a, const struct image *b, const uint8_t *under_a,
                            const uint8_t *under_b, struct compare_sums *sums)
{
    for (size_t i = 0; i < (size_t)a->width * a->height; i++) {
        const uint8_t *x = a->rgb + 3 * i, *y = b->rgb + 3 * i;
        if (under_a && memcmp(x, under_a, 3) == 0 && memcmp(y, under_b, 3) == 0)
            continue;
        compare_pixel(sums, (const double[3]){x[0] - y[0], x[1] - y[1], x[2] - y[2]}, 3);
    }
}

void compare_images(const struct image *a, const struct image *b, const uint8_t background[3],
                    struct compare_result *result)
{
    struct compare_sums sums = {0};
    uint8_t under_a[3], under_b[3];
    compare_background(a, under_a);
    compare_background(b, under_b);
    compare_covered(a, b, background ? background : under_a, background ? background : under_b, &sums);
    if (sums.pixels == 0 && memcmp(under_a, under_b, 3) != 0) /* of one colour each, and not the same */
        compare_covered(a, b, NULL, NULL, &sums);
    *result = compare_figures(&sums, 3);
}

void compare_difference(const struct image *a, const struct image *b, uint8_t *rgb)
{
    for (size_t i = 0; i < (size_t)a->width * a->height * 3; i++) {
        int value = 128 + 8 * (b->rgb[i] - a->rgb[i]);
        rgb[i] = (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
    }
}
