/* SPDX-License-Identifier: MIT */
/* Mutations of a stream that keep its checks right: else no bytes but the corpus' own would get past a CRC. */
#include "fuzz/fuzz.h"
#include "scene/scene.h"
#include "stream/protocol.h"

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);

enum { MOST_MESSAGES = 64 };

struct mutate {
    uint8_t *data;
    size_t size, most;
    uint32_t dice;
    size_t at[MOST_MESSAGES], bytes[MOST_MESSAGES]; /* the messages in it */
    unsigned count;
};

/* In 0 .. sides - 1. */
static uint32_t mutate_roll(struct mutate *m, uint32_t sides)
{
    m->dice = (uint32_t)(((uint64_t)m->dice * 747796405u + 2891336453u) & UINT32_MAX);
    return (m->dice >> 8) % sides;
}

static uint32_t mutate_get(const uint8_t *at, unsigned bytes)
{
    uint32_t value = 0;
    for (unsigned i = 0; i < bytes; i++)
        value |= (uint32_t)at[i] << 8 * i;
    return value;
}

static void mutate_put(uint8_t *at, unsigned bytes, uint32_t value)
{
    for (unsigned i = 0; i < bytes; i++)
        at[i] = (uint8_t)(value >> 8 * i & 255);
}

/* From one magic to the next, each as long as it says if that much is there. */
static void mutate_find(struct mutate *m)
{
    m->count = 0;
    for (size_t at = 0; at + STREAM_HEADER <= m->size && m->count < MOST_MESSAGES;) {
        if (mutate_get(m->data + at, 4) != STREAM_MAGIC) {
            at++;
            continue;
        }
        size_t length = mutate_get(m->data + at + STREAM_AT_LENGTH, 4), bytes = STREAM_HEADER;
        if (length && length <= m->size - at - STREAM_HEADER && length + STREAM_CHECK <= m->size - at - STREAM_HEADER)
            bytes += length + STREAM_CHECK;
        m->at[m->count] = at;
        m->bytes[m->count++] = bytes;
        at += bytes;
    }
}

static void mutate_repair(struct mutate *m)
{
    mutate_find(m);
    for (unsigned i = 0; i < m->count; i++) {
        uint8_t *head = m->data + m->at[i], *end = head + m->bytes[i];
        uint32_t crc = scene_crc32(0, head, STREAM_AT_CRC);
        mutate_put(head + STREAM_AT_CRC, 4, crc);
        if (m->bytes[i] > STREAM_HEADER)
            mutate_put(end - STREAM_CHECK, 4,
                       scene_crc32(crc, head + STREAM_HEADER, (uint32_t)(m->bytes[i] - STREAM_HEADER - STREAM_CHECK)));
    }
}

/* Counts on from the first one's. */
static void mutate_number(struct mutate *m)
{
    mutate_find(m);
    for (unsigned i = 1; i < m->count; i++)
        mutate_put(m->data + m->at[i] + STREAM_AT_SEQUENCE, 2,
                   mutate_get(m->data + m->at[0] + STREAM_AT_SEQUENCE, 2) + i);
}

/* Makes data[at .. at + from) `to` bytes long, the end moving; not if there is no room. */
static bool mutate_resize(struct mutate *m, size_t at, size_t from, size_t to)
{
    if (m->size - from + to > m->most)
        return false;
    memmove(m->data + at + to, m->data + at + from, m->size - at - from);
    m->size = m->size - from + to;
    return true;
}

static void mutate_field(struct mutate *m, size_t head)
{
    static const struct {
        uint8_t at, bytes;
    } fields[] = {{STREAM_AT_VERSION, 1}, {STREAM_AT_TYPE, 1},   {STREAM_AT_SEQUENCE, 2}, {STREAM_AT_X, 2},
                  {STREAM_AT_X, 4},       {STREAM_AT_Y, 2},      {STREAM_AT_WIDTH, 2},    {STREAM_AT_HEIGHT, 2},
                  {STREAM_AT_FORMAT, 1},  {STREAM_AT_CODEC, 1},  {STREAM_AT_LENGTH, 4},   {STREAM_HEADER, 4},
                  {STREAM_HEADER + 4, 4}, {STREAM_HEADER + 8, 1}};
    static const uint32_t values[] = {0,    1,    2,    3,    4,     5,     6,     7,     8,         12,
                                      16,   32,   0x81, 0x82, 0x83,  0x84,  0x85,  0x86,  255,       256,
                                      1024, 1025, 2048, 2049, 16384, 16385, 65535, 65536, UINT32_MAX};
    unsigned i = mutate_roll(m, sizeof fields / sizeof *fields), bytes = fields[i].bytes;
    size_t at = head + fields[i].at;
    if (at + bytes > m->size)
        return;
    uint32_t is = mutate_get(m->data + at, bytes), value = values[mutate_roll(m, sizeof values / sizeof *values)];
    if (mutate_roll(m, 2)) /* one more or one less */
        value = (uint32_t)(((uint64_t)is + UINT32_MAX + 2 * mutate_roll(m, 2)) & UINT32_MAX);
    mutate_put(m->data + at, bytes, value);
}

/* The payload by the fuzzer's own means, and the length by it. */
static void mutate_payload(struct mutate *m, unsigned which)
{
    uint8_t payload[1024];
    size_t at = m->at[which] + STREAM_HEADER, had = m->bytes[which] - STREAM_HEADER;
    size_t length = had ? had - STREAM_CHECK : 0;
    if (length > sizeof payload / 2)
        return;
    memcpy(payload, m->data + at, length);
    size_t now = LLVMFuzzerMutate(payload, length, sizeof payload / 2);
    if (!mutate_resize(m, at, had, now ? now + STREAM_CHECK : 0))
        return;
    memcpy(m->data + at, payload, now);
    mutate_put(m->data + m->at[which] + STREAM_AT_LENGTH, 4, (uint32_t)now);
}

/* The message `which` again, in front of any, with its own place left empty or not. */
static void mutate_move(struct mutate *m, unsigned which, bool stay)
{
    uint8_t message[2048];
    size_t bytes = m->bytes[which], to = m->at[mutate_roll(m, m->count)];
    if (bytes > sizeof message)
        return;
    memcpy(message, m->data + m->at[which], bytes);
    if (!stay) {
        mutate_resize(m, m->at[which], bytes, 0);
        to = to > m->at[which] ? to - bytes : to;
    }
    if (mutate_resize(m, to, 0, bytes))
        memcpy(m->data + to, message, bytes);
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed)
{
    struct mutate m = {.data = data, .size = size, .most = most, .dice = seed};
    mutate_find(&m);
    unsigned what = mutate_roll(&m, 8), which = m.count ? mutate_roll(&m, m.count) : 0;
    if (m.count == 0 || what < 2)
        m.size = LLVMFuzzerMutate(data, size, most);
    else if (what < 4)
        mutate_field(&m, m.at[which]);
    else if (what < 6)
        mutate_payload(&m, which);
    else if (what == 6)
        mutate_move(&m, which, mutate_roll(&m, 2));
    else
        mutate_resize(&m, m.at[which], m.bytes[which], 0);
    if (mutate_roll(&m, 2))
        mutate_number(&m);
    if (mutate_roll(&m, 8))
        mutate_repair(&m);
    return m.size;
}
