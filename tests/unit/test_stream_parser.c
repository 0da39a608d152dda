/* SPDX-License-Identifier: MIT */
/* Headers at the limits of what a device may send: one within is waited for, one beyond is passed over at once. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "stream_tape.h"

struct limit {
    enum stream_type type;
    unsigned width, height, format, codec;
    uint32_t length;
    bool good;
};

static const struct limit limits[] = {
    {STREAM_HELLO, 1, 1, 0, 0, 1, true},
    {STREAM_HELLO, 2048, 2048, 3, 0, 16384, true},
    {STREAM_HELLO, 1, 1, 0, 0, 16385, false},
    {STREAM_HELLO, 1, 1, 0, 0, 0, false},
    {STREAM_HELLO, 0, 1, 0, 0, 9, false},
    {STREAM_HELLO, 1, 0, 0, 0, 9, false},
    {STREAM_HELLO, 2049, 1, 0, 0, 9, false},
    {STREAM_HELLO, 1, 2049, 0, 0, 9, false},
    {STREAM_HELLO, 1, 1, 4, 0, 9, false},
    {STREAM_BEGIN, 1, 2048, 1, 0, 12, true},
    {STREAM_BEGIN, 1, 2049, 1, 0, 12, false},
    {STREAM_BEGIN, 1, 1, 4, 0, 12, false},
    {STREAM_BEGIN, 1, 1, 0, 0, 11, false},
    {STREAM_BEGIN, 1, 1, 0, 0, 13, false},
    {STREAM_BAND, 7, 3, STREAM_RGB565, 2, 42, true},
    {STREAM_BAND, 7, 3, STREAM_RGB565, 2, 43, false},
    {STREAM_BAND, 7, 3, STREAM_RGB888, 1, 63, true},
    {STREAM_BAND, 7, 3, STREAM_RGB888, 1, 64, false},
    {STREAM_BAND, 7, 3, STREAM_GREY8, 0, 21, true},
    {STREAM_BAND, 7, 3, STREAM_GREY8, 0, 22, false},
    {STREAM_BAND, 7, 3, STREAM_GREY4, 0, 12, true},
    {STREAM_BAND, 7, 3, STREAM_GREY4, 0, 13, false},
    {STREAM_BAND, 2048, 2048, STREAM_RGB888, 0, 3 * 2048 * 2048, true},
    {STREAM_BAND, 2048, 2048, STREAM_RGB888, 0, 3 * 2048 * 2048 + 1, false},
    {STREAM_BAND, 7, 3, 0, 3, 9, false},
    {STREAM_BAND, 7, 3, 0, 0, 0, false},
    {STREAM_END, 0, 0, 0, 0, 32, true},
    {STREAM_END, 0, 0, 0, 0, 31, false},
    {STREAM_END, 0, 0, 0, 0, 33, false},
    {STREAM_LOG, 0, 0, 0, 0, 1, true},
    {STREAM_LOG, 0, 0, 0, 0, 1024, true},
    {STREAM_LOG, 0, 0, 0, 0, 1025, false},
    {STREAM_LOG, 0, 0, 0, 0, 0, false},
    {STREAM_LOG + 1, 0, 0, 9, 9, 65536, true},
    {STREAM_LOG + 1, 0, 0, 0, 0, 65537, false},
    {STREAM_LOG + 1, 0, 0, 0, 0, UINT32_MAX, false},
};

struct taken {
    unsigned count;
    uint32_t length;
};

static void take(void *context, const struct parser_message *message)
{
    struct taken *taken = context;
    taken->count++;
    taken->length = message->length;
}

static void head_of(uint8_t head[STREAM_HEADER], const struct limit *l)
{
    memset(head, 0, STREAM_HEADER);
    tape_put(head, 4, STREAM_MAGIC);
    head[STREAM_AT_VERSION] = STREAM_VERSION;
    head[STREAM_AT_TYPE] = (uint8_t)l->type;
    tape_put(head + STREAM_AT_WIDTH, 2, l->width);
    tape_put(head + STREAM_AT_HEIGHT, 2, l->height);
    head[STREAM_AT_FORMAT] = (uint8_t)l->format;
    head[STREAM_AT_CODEC] = (uint8_t)l->codec;
    tape_put(head + STREAM_AT_LENGTH, 4, l->length);
    tape_put(head + STREAM_AT_CRC, 4, scene_crc32(0, head, STREAM_AT_CRC));
}

static void a_header_beyond_the_limits_is_not_waited_for(void **state)
{
    (void)state;
    for (unsigned i = 0; i < sizeof limits / sizeof *limits; i++) {
        struct taken taken = {0};
        struct parser parser = {.take = take, .context = &taken};
        uint8_t head[STREAM_HEADER];
        head_of(head, &limits[i]);
        parser_push(&parser, head, sizeof head);
        assert_int_equal(parser.count, limits[i].good ? STREAM_HEADER : 0);
        assert_int_equal(parser.need, limits[i].good ? STREAM_HEADER + limits[i].length + STREAM_CHECK : 1);
        assert_int_equal(taken.count + parser.damaged + parser.other_version, 0);
        parser_close(&parser);
    }
}

/* The last byte completes it: the payload, none of what follows. */
static void a_message_is_taken_with_its_last_byte(void **state)
{
    (void)state;
    for (unsigned i = 0; i < sizeof limits / sizeof *limits; i++) {
        struct taken taken = {0};
        struct parser parser = {.take = take, .context = &taken};
        uint32_t length = limits[i].length;
        if (!limits[i].good)
            continue;
        uint8_t *bytes = calloc(1, STREAM_HEADER + length + STREAM_CHECK);
        assert_non_null(bytes);
        head_of(bytes, &limits[i]);
        tape_check(bytes);
        parser_push(&parser, bytes, STREAM_HEADER + length + STREAM_CHECK - 1);
        assert_int_equal(taken.count, 0);
        parser_push(&parser, bytes + STREAM_HEADER + length + STREAM_CHECK - 1, 1);
        assert_int_equal(taken.count, 1);
        assert_int_equal(taken.length, length);
        assert_int_equal(parser.count, 0);
        parser_close(&parser);
        free(bytes);
    }
}

static void one_without_a_payload_has_no_second_check(void **state)
{
    static const struct limit empty = {STREAM_KEY_PLEASE, 0, 0, 0, 0, 0, true};
    struct taken taken = {0};
    struct parser parser = {.take = take, .context = &taken};
    uint8_t head[STREAM_HEADER];
    (void)state;
    head_of(head, &empty);
    parser_push(&parser, head, sizeof head);
    assert_int_equal(taken.count, 1);
    parser_close(&parser);
}

static void another_version_is_told_and_passed_over(void **state)
{
    struct taken taken = {0};
    struct parser parser = {.take = take, .context = &taken};
    uint8_t head[STREAM_HEADER];
    (void)state;
    head_of(head, &limits[0]);
    head[STREAM_AT_VERSION]++;
    tape_put(head + STREAM_AT_CRC, 4, scene_crc32(0, head, STREAM_AT_CRC));
    parser_push(&parser, head, sizeof head);
    assert_int_equal(parser.other_version, 1);
    assert_int_equal(taken.count + parser.count, 0);
    parser_close(&parser);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_header_beyond_the_limits_is_not_waited_for),
        cmocka_unit_test(a_message_is_taken_with_its_last_byte),
        cmocka_unit_test(one_without_a_payload_has_no_second_check),
        cmocka_unit_test(another_version_is_told_and_passed_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
