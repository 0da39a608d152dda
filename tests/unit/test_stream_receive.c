/* SPDX-License-Identifier: MIT */
/* What a device hears: requests as the viewer writes them, and nothing else. */
#include "scene/scene.h"
#include "stream/receive.h"
#include "view/port.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "random.h"

static const struct stream_request requests[] = {
    {STREAM_KEY_PLEASE, 65535, 0}, {STREAM_BUTTONS, 1, 0xF6}, {STREAM_METHOD, 2, 19}, {STREAM_BUDGET, 3, 255},
    {STREAM_SCENE, 4, 3},          {STREAM_PAUSE, 0x1234, 1}, {0xC3, 0, 0x534C47F6},
};
enum { COUNT = sizeof requests / sizeof *requests };

/* Pushes bytes: how many requests come, the last in `request`. */
static unsigned push(struct stream_receiver *r, const uint8_t *bytes, size_t size, struct stream_request *request)
{
    unsigned heard = 0;
    for (size_t i = 0; i < size; i++)
        heard += (unsigned)stream_receive(r, bytes[i], request);
    return heard;
}

static void every_request_is_heard_once(void **state)
{
    struct stream_receiver r = {{0}, 0};
    struct stream_request heard;
    uint8_t message[STREAM_HEADER];
    (void)state;
    for (unsigned i = 0; i < COUNT; i++) {
        port_message(message, requests[i].type, requests[i].value, requests[i].sequence);
        assert_int_equal(push(&r, message, STREAM_HEADER - 1, &heard), 0);
        assert_int_equal(push(&r, message + STREAM_HEADER - 1, 1, &heard), 1);
        assert_int_equal(heard.type, requests[i].type);
        assert_int_equal(heard.value, requests[i].value);
        assert_int_equal(heard.sequence, requests[i].sequence);
    }
}

static void what_is_before_a_request_does_not_hide_it(void **state)
{
    static const uint8_t magic[] = {0xF6, 0x47, 0x4C, 0x53};
    struct stream_request heard;
    uint8_t message[STREAM_HEADER], other[STREAM_HEADER];
    (void)state;
    for (unsigned i = 0; i < COUNT; i++)
        for (unsigned size = 0; size < STREAM_HEADER; size++) {
            struct stream_receiver r = {{0}, 0};
            port_message(message, requests[i].type, requests[i].value, 5);
            port_message(other, STREAM_SCENE, size, 4);
            assert_int_equal(push(&r, other, size, &heard), 0); /* one that was cut off */
            assert_int_equal(push(&r, magic, size & 3, &heard), 0);
            assert_int_equal(push(&r, message, STREAM_HEADER, &heard), 1);
            assert_int_equal(heard.type, requests[i].type);
            assert_int_equal(heard.value, requests[i].value);
        }
}

static void a_flipped_bit_makes_no_request(void **state)
{
    struct stream_request heard;
    uint8_t message[STREAM_HEADER];
    (void)state;
    for (unsigned bit = 0; bit < 8 * STREAM_HEADER; bit++) {
        struct stream_receiver r = {{0}, 0};
        port_message(message, STREAM_METHOD, 7, 0);
        message[bit / 8] ^= (uint8_t)(1u << bit % 8);
        assert_int_equal(push(&r, message, STREAM_HEADER, &heard), 0);
        message[bit / 8] ^= (uint8_t)(1u << bit % 8);
        assert_int_equal(push(&r, message, STREAM_HEADER, &heard), 1);
    }
}

static void what_a_device_sends_is_no_request(void **state)
{
    struct stream_receiver r = {{0}, 0};
    struct stream_request heard;
    uint8_t message[STREAM_HEADER];
    (void)state;
    for (unsigned type = 0; type < STREAM_KEY_PLEASE; type++) {
        port_message(message, type, 7, 0);
        assert_int_equal(push(&r, message, STREAM_HEADER, &heard), 0);
    }
}

/* Its CRC is right, and yet it is none: of another version, or with another beginning. */
static void a_request_of_another_kind_is_none(void **state)
{
    struct stream_request heard;
    uint8_t message[STREAM_HEADER];
    (void)state;
    for (unsigned at = 0; at <= STREAM_AT_VERSION; at++) {
        struct stream_receiver r = {{0}, 0};
        port_message(message, STREAM_METHOD, 7, 1);
        message[at]++;
        uint32_t crc = scene_crc32(0, message, STREAM_AT_CRC);
        for (unsigned i = 0; i < 4; i++)
            message[STREAM_AT_CRC + i] = (uint8_t)(crc >> 8 * i & 255);
        assert_int_equal(push(&r, message, STREAM_HEADER, &heard), 0);
        port_message(message, STREAM_METHOD, 7, 1);
        assert_int_equal(push(&r, message, STREAM_HEADER, &heard), 1);
    }
}

static void noise_makes_no_request(void **state)
{
    struct stream_receiver r = {{0}, 0};
    struct stream_request heard;
    (void)state;
    random_seed(3);
    for (int i = 0; i < 1000000; i++) {
        static const uint8_t likely[8] = {0xF6, 0x47, 0x4C, 0x53, 1, 0x81, 0, 0};
        uint8_t byte = random_between(0, 1) ? likely[i & 7] : (uint8_t)(random_bits() >> 9 & 255);
        assert_int_equal(stream_receive(&r, byte, &heard), 0);
        assert_true(r.count < STREAM_HEADER);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_request_is_heard_once),
        cmocka_unit_test(what_is_before_a_request_does_not_hide_it),
        cmocka_unit_test(a_flipped_bit_makes_no_request),
        cmocka_unit_test(what_a_device_sends_is_no_request),
        cmocka_unit_test(a_request_of_another_kind_is_none),
        cmocka_unit_test(noise_makes_no_request),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
