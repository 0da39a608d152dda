/* SPDX-License-Identifier: MIT */
/* Mutations of a scene blob: fields become extremes, each other or a little more, and the checksum is made right, or
 * nothing would get past it. */
#include "fuzz/fuzz.h"
#include "scene/scene.h"

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);

static uint32_t mutate_roll(uint32_t *dice, uint32_t sides)
{
    *dice = (uint32_t)(((uint64_t)*dice * 747796405u + 2891336453u) & UINT32_MAX);
    return (*dice >> 8) % sides;
}

/* A field of 1, 2 or 4 bytes, at a multiple of its size. */
static void mutate_field(uint8_t *data, size_t size, uint32_t *dice)
{
    static const uint32_t values[] = {0,         1,        2,          255,        256,        8192,
                                      16383,     16384,    16385,      32767,      32768,      49152,
                                      65535,     65536,    1 << 20,    1 << 24,    1u << 29,   1u << 30,
                                      INT32_MAX, 1u << 31, UINT32_MAX, 0xFFFF0000, 0xC0000000, 0xFFFFC000};
    const size_t bytes = (size_t)1 << mutate_roll(dice, 3), at = mutate_roll(dice, (uint32_t)(size / bytes)) * bytes;
    uint32_t value = 0;
    memcpy(&value, data + at, bytes);
    const uint64_t is = value;
    switch (mutate_roll(dice, 4)) {
    case 0:
        value = values[mutate_roll(dice, sizeof values / sizeof *values)];
        break;
    case 1: /* little by little */
        value = (uint32_t)((is + (mutate_roll(dice, 2) ? 1 : UINT32_MAX)) & UINT32_MAX);
        break;
    case 2: /* its other sign */
        value = (uint32_t)((((uint64_t)1 << 32) - is) & UINT32_MAX);
        break;
    default: /* twice or half of it */
        value = (uint32_t)((mutate_roll(dice, 2) ? is * 2 : is / 2) & UINT32_MAX);
    }
    memcpy(data + at, &value, bytes);
}

/* What stands in one place also in another: unit vectors, corners and offsets that pass. */
static void mutate_copy(uint8_t *data, size_t size, uint32_t *dice)
{
    static const uint8_t lengths[] = {2, 4, 6, 8, 12, 16};
    const size_t bytes = lengths[mutate_roll(dice, sizeof lengths)];
    const uint32_t places = (uint32_t)((size - bytes) / 2 + 1);
    memmove(data + 2 * mutate_roll(dice, places), data + 2 * mutate_roll(dice, places), bytes);
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed)
{
    struct scene_header *head = (struct scene_header *)(void *)data;
    uint32_t dice = seed;
    if (size < sizeof *head || mutate_roll(&dice, 16) == 0)
        size = LLVMFuzzerMutate(data, size, most);
    for (uint32_t times = 1 + mutate_roll(&dice, 3); times && size >= sizeof *head; times--)
        if (mutate_roll(&dice, 3))
            mutate_field(data, size, &dice);
        else
            mutate_copy(data, size, &dice);
    if (size < sizeof *head || mutate_roll(&dice, 16) == 0)
        return size;
    head->magic = SCENE_MAGIC;
    head->version = SCENE_VERSION;
    head->length = (uint32_t)size;
    head->crc = scene_crc32(0, data + 16, (uint32_t)size - 16);
    return size;
}
