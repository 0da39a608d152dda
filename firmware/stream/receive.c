/* SPDX-License-Identifier: MIT */
#include "stream/receive.h"

#include "scene/scene.h"

static uint32_t receive_get32(const uint8_t *at)
{
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* Nothing in the bytes so far speaks against a message. */
static int receive_plausible(const struct stream_receiver *r)
{
    for (unsigned i = 0; i < 4 && i < r->count; i++)
        if (r->bytes[i] != (uint8_t)(STREAM_MAGIC >> 8 * i))
            return 0;
    return r->count < STREAM_HEADER ||
           receive_get32(r->bytes + STREAM_AT_CRC) == scene_crc32(0, r->bytes, STREAM_AT_CRC);
}

static void receive_drop_first(struct stream_receiver *r)
{
    r->count--;
    for (unsigned i = 0; i < r->count; i++)
        r->bytes[i] = r->bytes[i + 1];
}

int stream_receive(struct stream_receiver *r, uint8_t byte, struct stream_request *request)
{
    r->bytes[r->count++] = byte;
    while (r->count && !receive_plausible(r))
        receive_drop_first(r);
    if (r->count < STREAM_HEADER)
        return 0;
    r->count = 0;
    request->type = r->bytes[STREAM_AT_TYPE];
    request->sequence = (uint16_t)(r->bytes[STREAM_AT_SEQUENCE] | r->bytes[STREAM_AT_SEQUENCE + 1] << 8);
    request->value = receive_get32(r->bytes + STREAM_AT_X);
    return r->bytes[STREAM_AT_VERSION] == STREAM_VERSION && request->type >= STREAM_KEY_PLEASE;
}
