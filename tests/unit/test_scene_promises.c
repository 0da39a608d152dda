/* SPDX-License-Identifier: MIT */
/* Every field of a scene in turn with other values: the check takes it if, and only if, all that scene.h promises still
 * holds. */
#include "tests/fuzz/promises.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <string.h>

enum { MOST_BYTES = 4096 };

static uint32_t blob[MOST_BYTES / 4];
static struct scene_header *const scene = (struct scene_header *)blob;

/* How often the check said yes, no, and what it likes. */
static struct {
    unsigned good, bad, edge;
} seen;

/* With its effects, or all that there are. */
static void load(const char *name, bool all)
{
    char path[64];
    snprintf(path, sizeof path, "tests/fuzz/corpus/fuzz_scene/%s", name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_in_range(fread(blob, 1, sizeof blob, file), sizeof *scene, sizeof blob - 1);
    fclose(file);
    scene->effects = all ? USES_EFFECTS : scene->effects;
    scene->crc = scene_crc32(0, (uint8_t *)blob + 16, scene->length - 16);
    assert_int_equal(scene_check(blob, scene->length), SCENE_OK);
}

static void look(const char *name, size_t at, size_t bytes, uint32_t value)
{
    struct promises p = {.scene = scene, .size = scene->length};
    uint32_t kept = 0;
    memcpy(&kept, (uint8_t *)blob + at, bytes);
    memcpy((uint8_t *)blob + at, &value, bytes);
    if (at < 12 || at >= 16)
        scene->crc = (uint32_t)crc32(0, (uint8_t *)blob + 16,
                                     scene->length >= 16 && scene->length <= p.size ? scene->length - 16 : 0);
    const enum scene_fault fault = scene_check(blob, p.size);
    const char *broken = promises_broken(&p);
    if (broken ? !fault : fault && !p.edge)
        fail_msg("%s: %zu bytes at %zu are %#x: fault %d, broken: %s", name, bytes, at, value, fault,
                 broken ? broken : "nothing");
    seen.good += !fault;
    seen.bad += fault != 0;
    seen.edge += !broken && p.edge;
    memcpy((uint8_t *)blob + at, &kept, bytes);
}

static void try_field(const char *name, size_t at, size_t bytes)
{
    static const uint32_t steps[] = {1, 2, 4, 31, 32, 33, 256};
    static const uint32_t values[] = {0,        1,          2,          3,          4,          7,          8,
                                      9,        10,         11,         255,        256,        257,        1023,
                                      1024,     2048,       2049,       4095,       4096,       16383,      16384,
                                      16385,    32767,      32768,      32769,      65535,      65536,      0xFFFFFF,
                                      1 << 24,  1 << 28,    1 << 29,    0x10000001, 0x3FFFFFFF, 1 << 30,    INT32_MAX,
                                      1u << 31, 0xC0000000, 0xC0000001, 0xFF000000, 0xFF000001, 0xFFFFC000, UINT32_MAX};
    uint32_t is = 0;
    memcpy(&is, (uint8_t *)blob + at, bytes);
    look(name, at, bytes, 0 - is);
    for (size_t i = 0; i < (bytes == 1 ? 1 : sizeof steps / sizeof *steps); i++) {
        look(name, at, bytes, is + steps[i]);
        look(name, at, bytes, is - steps[i]);
    }
    for (size_t i = 0; bytes > 1 && i < sizeof values / sizeof *values; i++)
        if (bytes == 4 || values[i] <= UINT16_MAX)
            look(name, at, bytes, values[i]);
}

static void every_field_is_taken_or_refused_as_scene_h_promises(void **state)
{
    static const struct {
        const char *name;
        bool all;
    } scenes[] = {{"01", false}, {"09", true}, {"41", false}, {"41", true}}; /* maps, keys; bumps, a palette; plain */
    (void)state;
    for (size_t n = 0; n < sizeof scenes / sizeof *scenes; n++) {
        load(scenes[n].name, scenes[n].all);
        const uint32_t length = scene->length;
        for (size_t bytes = 1; bytes <= 4; bytes *= 2)
            for (size_t at = 0; at + bytes <= length; at += bytes)
                try_field(scenes[n].name, at, bytes);
    }
    print_message("%u scenes, %u good, %u not, %u at a bound\n", seen.good + seen.bad, seen.good, seen.bad, seen.edge);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_field_is_taken_or_refused_as_scene_h_promises)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
