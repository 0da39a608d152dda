/* SPDX-License-Identifier: MIT */
/* Mutations of a scene file by its structure: members come and go, numbers become extremes, parts stand in for others.
 * What is no JSON is mutated as bytes. */
#include "fuzz/fuzz.h"

#include <jansson.h>

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);

enum { MOST_VALUES = 512 };

struct mutate {
    uint32_t dice;
    json_t *value[MOST_VALUES]; /* containers, each with its elements */
    unsigned count;
};

static uint32_t mutate_roll(struct mutate *m, uint32_t sides)
{
    m->dice = (uint32_t)(((uint64_t)m->dice * 747796405u + 2891336453u) & UINT32_MAX);
    return (m->dice >> 8) % sides;
}

/* All containers below, and it. JSON nests at most 2048 deep. */
static void mutate_list(struct mutate *m, json_t *value)
{
    const char *key;
    json_t *element;
    size_t i;
    if (!json_is_object(value) && !json_is_array(value))
        return;
    if (m->count < MOST_VALUES)
        m->value[m->count++] = value;
    json_object_foreach(value, key, element) mutate_list(m, element);
    json_array_foreach(value, i, element) mutate_list(m, element);
}

static json_t *mutate_number(struct mutate *m, double was)
{
    static const double values[] = {0,     1,     -1,  2,   3,    4,    0.5,   1e-3,   1e-6,  1e-12, 89.99, 90,
                                    179.9, 180,   255, 256, 512,  1023, 1024,  4096,   8191,  16382, 16383, 16384,
                                    32767, 65535, 1e6, 1e9, -1e9, 1e30, -1e30, 1e-300, 1e300, -0.5,  360};
    switch (mutate_roll(m, 3)) {
    case 0:
        return json_real(was * (mutate_roll(m, 2) ? 2 : .5));
    case 1:
        return json_real(-was);
    default:
        return json_real(values[mutate_roll(m, sizeof values / sizeof *values)]);
    }
}

/* Any element of any container; null if it has none. */
static json_t *mutate_any(struct mutate *m, json_t **owner, const char **key, size_t *index)
{
    *owner = m->value[mutate_roll(m, m->count)];
    const size_t size = json_is_array(*owner) ? json_array_size(*owner) : json_object_size(*owner);
    *index = size ? mutate_roll(m, (uint32_t)size) : 0;
    *key = NULL;
    if (size && json_is_array(*owner))
        return json_array_get(*owner, *index);
    void *at = json_object_iter(*owner);
    for (size_t i = 0; at && i < *index; i++)
        at = json_object_iter_next(*owner, at);
    *key = at ? json_object_iter_key(at) : NULL;
    return at ? json_object_iter_value(at) : NULL;
}

static void mutate_put(json_t *owner, const char *key, size_t index, json_t *value)
{
    if (key)
        json_object_set_new(owner, key, value);
    else
        json_array_set_new(owner, index, value);
}

static void mutate_once(struct mutate *m)
{
    json_t *owner, *other;
    const char *key, *other_key;
    size_t index, other_index;
    json_t *value = mutate_any(m, &owner, &key, &index);
    if (!value)
        return;
    switch (mutate_roll(m, 8)) {
    case 0:
        if (key)
            json_object_del(owner, key);
        else
            json_array_remove(owner, index);
        return;
    case 1: /* once more */
        if (!key)
            json_array_insert_new(owner, index, json_deep_copy(value));
        return;
    case 2:
    case 3: /* another in its place */
        value = json_deep_copy(mutate_any(m, &other, &other_key, &other_index));
        if (value)
            mutate_put(owner, key, index, value);
        return;
    default:
        if (json_is_number(value))
            mutate_put(owner, key, index, mutate_number(m, json_number_value(value)));
        else if (json_is_boolean(value))
            mutate_put(owner, key, index, json_boolean(!json_is_true(value)));
    }
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed)
{
    struct mutate m = {.dice = seed};
    json_t *root = mutate_roll(&m, 8) ? json_loadb((const char *)data, size, 0, NULL) : NULL;
    if (!root)
        return LLVMFuzzerMutate(data, size, most);
    for (uint32_t times = 1 + mutate_roll(&m, 4); times; times--) {
        m.count = 0;
        mutate_list(&m, root);
        mutate_once(&m);
    }
    const size_t now = json_dumpb(root, (char *)data, most, JSON_COMPACT);
    json_decref(root);
    return now && now <= most ? now : LLVMFuzzerMutate(data, size, most);
}
