/* SPDX-License-Identifier: MIT */
#include "pack/palette.h"

#include "scene/model.h"

#include <stdlib.h>
#include <string.h>

/* A colour, and how many pixels have it. */
struct entry {
    uint32_t rgb, pixels;
};

/* Some of the entries, which become one colour of the palette. */
struct box {
    struct entry *first;
    size_t count;
    uint64_t worth; /* pixels times the square of its longest side: what splitting it may gain */
    int axis;       /* of that side */
};

static int field(uint32_t rgb, int axis)
{
    return (int)(rgb >> 8 * axis & 0xff);
}

static int by_colour(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return x < y ? -1 : x > y;
}

static int by_axis(const struct entry *a, const struct entry *b, int axis)
{
    const int d = field(a->rgb, axis) - field(b->rgb, axis);
    return d ? d : by_colour(&a->rgb, &b->rgb);
}
static int by_blue(const void *a, const void *b)
{
    return by_axis(a, b, 0);
}
static int by_green(const void *a, const void *b)
{
    return by_axis(a, b, 1);
}
static int by_red(const void *a, const void *b)
{
    return by_axis(a, b, 2);
}

static void measure(struct box *box)
{
    uint64_t pixels = 0;
    int longest = 0;
    box->axis = 1;
    for (size_t i = 0; i < box->count; i++)
        pixels += box->first[i].pixels;
    for (int axis = 0; axis < 3; axis++) {
        int low = 255, high = 0;
        for (size_t i = 0; i < box->count; i++) {
            const int v = field(box->first[i].rgb, axis);
            low = v < low ? v : low;
            high = v > high ? v : high;
        }
        if (high - low > longest) {
            longest = high - low;
            box->axis = axis;
        }
    }
    box->worth = pixels * (uint64_t)(longest * longest);
}

/* Splits a box of two colours or more where half of its pixels lie on either side. */
static struct box split(struct box *box)
{
    static int (*const order[])(const void *, const void *) = {by_blue, by_green, by_red};
    uint64_t pixels = 0, below = 0;
    size_t at = 0;
    qsort(box->first, box->count, sizeof *box->first, order[box->axis]);
    for (size_t i = 0; i < box->count; i++)
        pixels += box->first[i].pixels;
    while (at < box->count - 1 && (at == 0 || 2 * below < pixels))
        below += box->first[at++].pixels;
    struct box upper = {.first = box->first + at, .count = box->count - at};
    box->count = at;
    measure(box);
    measure(&upper);
    return upper;
}

/* Of a box's pixels, of which there is one at least. */
static uint32_t mean(const struct box *box)
{
    uint64_t sum[3] = {0, 0, 0}, pixels = 0;
    uint32_t rgb = 0;
    for (size_t i = 0; i < box->count; i++) {
        pixels += box->first[i].pixels;
        for (int axis = 0; axis < 3; axis++)
            sum[axis] += (uint64_t)box->first[i].pixels * (uint64_t)field(box->first[i].rgb, axis);
    }
    for (int axis = 0; axis < 3; axis++)
        /* NOLINTNEXTLINE(clang-analyzer-core.DivideZero) */
        rgb |= (uint32_t)((sum[axis] + pixels / 2) / pixels) << 8 * axis;
    return rgb;
}

static unsigned cut(struct entry *entries, size_t count, uint32_t *palette)
{
    struct box boxes[PALETTE_MOST] = {{.first = entries, .count = count}};
    unsigned used = 1;
    measure(&boxes[0]);
    for (; used < PALETTE_MOST; used++) {
        struct box *best = &boxes[0];
        for (unsigned i = 1; i < used; i++)
            best = boxes[i].worth > best->worth ? &boxes[i] : best;
        if (best->worth == 0)
            break; /* every box is one colour */
        boxes[used] = split(best);
    }
    for (unsigned i = 0; i < used; i++)
        palette[i] = mean(&boxes[i]);
    return used;
}

static uint8_t nearest(uint32_t rgb, const uint32_t *palette, unsigned used)
{
    unsigned best = 0;
    int least = INT32_MAX;
    for (unsigned i = 0; i < used && least; i++) {
        int distance = 0;
        for (int axis = 0; axis < 3; axis++) {
            const int d = field(rgb, axis) - field(palette[i], axis);
            distance += d * d;
        }
        if (distance < least) {
            least = distance;
            best = i;
        }
    }
    return (uint8_t)best;
}

/* The colours in ascending order: how many. */
static size_t gather(const uint32_t *rgb, size_t count, struct entry *entries)
{
    uint32_t *sorted = model_alloc(count * sizeof *sorted);
    size_t different = 0;
    memcpy(sorted, rgb, count * sizeof *sorted);
    qsort(sorted, count, sizeof *sorted, by_colour);
    for (size_t i = 0; i < count; i++) {
        if (i == 0 || sorted[i] != sorted[i - 1])
            entries[different++] = (struct entry){sorted[i], 0};
        entries[different - 1].pixels++;
    }
    free(sorted);
    return different;
}

unsigned palette_make(const uint32_t *rgb, size_t count, uint8_t *index, uint32_t *palette, unsigned *different)
{
    struct entry *entries = model_alloc(count * sizeof *entries);
    const size_t colours = gather(rgb, count, entries);
    const unsigned used = cut(entries, colours, palette);
    *different = (unsigned)colours;
    for (size_t i = 0; i < count; i++) /* neighbours are often equal */
        index[i] = i && rgb[i] == rgb[i - 1] ? index[i - 1] : nearest(rgb[i], palette, used);
    free(entries);
    return used;
}
