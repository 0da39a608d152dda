/* SPDX-License-Identifier: MIT */
/* The device's ear: of any bytes it hears a request exactly where the last 32 are one, with the right CRC. */
#include "fuzz/fuzz.h"
#include "stream/receive.h"

#include <zlib.h>

static uint32_t number(const uint8_t *at)
{
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* A message's header: what stands here is not looked at again. */
static bool is_message(const uint8_t *at)
{
    return memcmp(at, "\xF6GLS", 4) == 0 && crc32(0, at, STREAM_AT_CRC) == number(at + STREAM_AT_CRC);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct stream_receiver r = {{0}, 0};
    size_t done = 0; /* bytes that belong to messages, and those before them */
    for (size_t i = 0; i < size; i++) {
        struct stream_request heard = {.type = 0};
        int got = stream_receive(&r, data[i], &heard);
        const uint8_t *at = data + i + 1 - STREAM_HEADER;
        bool message = i + 1 >= done + STREAM_HEADER && is_message(at);
        FUZZ_CHECK(r.count < STREAM_HEADER);
        FUZZ_CHECK(!message || r.count == 0);
        FUZZ_CHECK(got == (message && at[STREAM_AT_VERSION] == STREAM_VERSION && at[STREAM_AT_TYPE] >= 0x81));
        FUZZ_CHECK(!got || (heard.type == at[STREAM_AT_TYPE] && heard.value == number(at + STREAM_AT_X) &&
                            heard.sequence == (number(at + STREAM_AT_SEQUENCE) & 0xFFFF)));
        done = message ? i + 1 : done;
    }
    return 0;
}
