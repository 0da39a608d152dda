/* SPDX-License-Identifier: MIT */
/* Pictures to a USB host that comes, goes, and reads or not. */
#include "gadget_case.h"

static void usb_read(int reads)
{
    usb_lock();
    usb_machine.reads = reads;
    usb_unlock();
}

static void usb_send(const void *bytes, size_t size)
{
    usb_lock();
    memcpy(usb_machine.sends + usb_machine.sends_size, bytes, size);
    usb_machine.sends_size += size;
    usb_unlock();
}

static void usb_request(uint8_t type)
{
    usb_lock();
    usb_machine.event[usb_machine.events].u.setup = (struct usb_ctrlrequest){.bRequestType = type, .bRequest = 0x99};
    usb_event(FUNCTIONFS_SETUP);
    usb_unlock();
}

/* Waits until a picture is taken: whether one is. */
static uint32_t begin_soon(void)
{
    uint32_t taken = 0;
    for (int ms = 0; ms < PATIENCE_MS && !(taken = begin()); ms++)
        pause_ms(1);
    return taken;
}

/* Until the host has so many bytes, or has waited long enough. */
static size_t received(size_t count)
{
    size_t size = 0;
    for (int ms = 0; ms < PATIENCE_MS && size < count; ms++) {
        usb_lock();
        size = usb_machine.got_size;
        usb_unlock();
        if (size < count)
            pause_ms(1);
    }
    return size;
}

static void nothing_is_taken_while_nobody_is_there(void **state)
{
    (void)state;
    assert_false(begin());
    assert_int_equal(put(1, 100), HAL_E_IO);
    assert_int_equal(skipped, 0);
}

/* Nothing is added, wherever the writer pauses. */
static void what_is_written_arrives(void **state)
{
    (void)state;
    usb_connect();
    assert_true(meet());
    size_t sum = 0;
    for (uint8_t i = 1; i <= 30; i++) { /* around the queue's end, more than once */
        if (i > 1)
            assert_true(begin_soon());
        assert_int_equal(put(i, 1024u * i), 0);
        if (i % 4 == 0)
            pause_ms(5);
        assert_int_equal(put(0xFF, 64), 0);
        sum += 1024u * i + 64;
    }
    assert_int_equal(received(sum), sum);
    const uint8_t *at = got;
    for (uint8_t i = 1; i <= 30; i++)
        for (size_t k = 0; k < 1024u * i + 64; k++)
            assert_int_equal(*at++, k < 1024u * i ? i : 0xFF);
}

/* A host's transfer ends with a packet that is not full: the last byte goes alone where it would be. */
static void the_last_packet_is_never_full(void **state)
{
    (void)state;
    usb_connect();
    assert_true(meet());
    assert_int_equal(put(7, 1000), 0);
    size_t sum = received(1000);
    for (uint32_t count = 64; count <= 32768; count *= 2) {
        assert_int_equal(put(7, count), 0);
        sum += count;
        assert_int_equal(received(sum), sum);
        assert_int_equal(usb_machine.last_size, 1);
        assert_int_equal(put(7, count - 1), 0);
        sum += count - 1;
        assert_int_equal(received(sum), sum);
        assert_int_not_equal(usb_machine.last_size % 64, 0);
    }
}

static void a_host_that_does_not_read_costs_pictures_not_time(void **state)
{
    (void)state;
    usb_read(0);
    usb_connect();
    assert_true(meet());
    assert_int_equal(put(1, FRAME), 0);
    while (!begin()) /* until the first has begun to leave */
        pause_ms(1);
    assert_int_equal(put(2, FRAME), 0);
    skipped = 0;
    for (int i = 0; i < 60; i++)
        assert_false(begin());
    assert_int_equal(skipped, 60);
    usb_read(1);
    assert_int_equal(received(2 * FRAME), 2 * FRAME);
    assert_true(begin_soon()); /* it is still the same one */
    assert_int_equal(put(3, 10), 0);
}

/* Who does not read takes one transfer nevertheless; the next one waits. */
static void take_one(void)
{
    usb_lock();
    usb_machine.takes = 1;
    usb_unlock();
    for (int ms = 0, waits = 0; ms < PATIENCE_MS && !waits; ms++, pause_ms(1)) {
        usb_lock();
        waits = usb_machine.waits && !usb_machine.takes;
        usb_unlock();
    }
}

/* What has waited for a reader is of another time: he is told of, and gets what is drawn then. Of a picture that he has
 * begun to read he gets the rest. */
static void who_begins_to_read_late_gets_nothing_old(void **state)
{
    (void)state;
    for (int begun = 0; begun < 2; begun++) {
        usb_read(0);
        usb_connect();
        assert_true(meet());
        assert_int_equal(put(1, FRAME), 0);
        while (!begin())
            pause_ms(1);
        if (begun)
            take_one();
        assert_int_equal(put(2, FRAME), 0);
        for (int i = 0; i < 1000; i++)
            assert_false(begin());
        usb_lock();
        usb_machine.got_size = 0;
        usb_unlock();
        usb_read(1);
        assert_true(meet());
        usb_lock();
        size_t old = usb_machine.got_size;
        usb_unlock();
        assert_in_range(old, 1, begun ? FRAME : 152);
        for (size_t i = 0; i < old; i++)
            assert_int_equal(got[i], 1);
        assert_int_equal(put(3, 1000), 0);
        assert_int_equal(received(old + 1000), old + 1000);
        assert_int_equal(got[old], 3);
        usb_disconnect();
        while (begin())
            pause_ms(1);
    }
}

static void no_more_is_taken_than_was_said(void **state)
{
    (void)state;
    usb_read(0);
    usb_connect();
    assert_true(meet());
    assert_int_equal(put(1, FRAME), 0);
    assert_int_equal(put(1, FRAME), 0);
    assert_int_equal(put(1, 1), HAL_E_FULL);
}

/* Waits for so many nines: how many there are, with nothing behind them. */
static size_t nines_at_the_end(size_t count)
{
    size_t nines = 0;
    for (int ms = 0; ms < PATIENCE_MS && nines < count; ms++, pause_ms(1)) {
        usb_lock();
        for (nines = 0; nines < usb_machine.got_size && got[usb_machine.got_size - 1 - nines] == 9;)
            nines++;
        usb_unlock();
    }
    return nines;
}

/* Writes of a picture whose host has gone, until that is noticed: what they are told then. */
static int put_until_refused(void)
{
    int result = 0;
    for (int ms = 0; ms < PATIENCE_MS && !result; ms++, pause_ms(1))
        result = put(1, 1);
    return result;
}

static void a_host_that_comes_again_gets_nothing_of_before(void **state)
{
    (void)state;
    for (int pulled = 0; pulled < 2; pulled++) {
        usb_read(0);
        usb_connect();
        assert_true(meet());
        assert_int_equal(put(1, FRAME), 0);
        if (pulled) {
            usb_disconnect();
            assert_int_equal(put_until_refused(), HAL_E_IO);
            assert_false(begin());
        }
        usb_lock();
        usb_machine.got_size = 0;
        usb_unlock();
        usb_connect();
        assert_int_equal(put_until_refused(), HAL_E_IO);
        assert_true(meet());
        assert_int_equal(put(9, 1000), 0);
        usb_read(1);
        assert_int_equal(nines_at_the_end(1000), 1000);
        assert_in_range(usb_machine.got_size, 1000, 1000 + USB_STREAM_PIECE + 1); /* what was in hand just then */
        assert_true(begin_soon());
        usb_disconnect();
        while (begin())
            pause_ms(1);
    }
}

static void a_transfer_that_fails_makes_it_a_new_beginning(void **state)
{
    (void)state;
    usb_connect();
    assert_true(meet());
    usb_read(0);
    assert_int_equal(put(1, 100), 0);
    pause_ms(20); /* the thread waits for the host */
    usb_lock();
    usb_machine.interrupts = 1;
    usb_unlock();
    usb_read(1);
    assert_true(meet());
    assert_int_equal(put(2, 100), 0);
    received(100);
    assert_int_equal(got[0], 2);
}

static int32_t hear(uint8_t *bytes, uint32_t size)
{
    int32_t count = 0;
    for (int ms = 0; ms < PATIENCE_MS && !count; ms++) {
        count = usb.link.ops->read(&usb.link, bytes, size);
        if (!count)
            pause_ms(1);
    }
    return count;
}

static void what_the_host_says_is_heard_in_order(void **state)
{
    static const char words[] = "key frame please";
    uint8_t bytes[64];
    (void)state;
    usb_connect();
    usb_send(words, sizeof words);
    pause_ms(20);
    assert_true(meet()); /* before any of them */
    assert_int_equal(hear(bytes, 3), 3);
    assert_memory_equal(bytes, words, 3);
    assert_int_equal(hear(bytes, sizeof bytes), sizeof words - 3);
    assert_memory_equal(bytes, words + 3, sizeof words - 3);
}

static void a_host_that_is_not_heard_loses_its_last_words(void **state)
{
    uint8_t bytes[USB_STREAM_HEARD + 1], many[8192];
    (void)state;
    for (size_t i = 0; i < sizeof many; i++)
        many[i] = (uint8_t)(i / 64);
    usb_connect();
    assert_true(meet());
    usb_send(many, sizeof many);
    for (size_t left = 1; left;) {
        usb_lock();
        left = usb_machine.sends_size;
        usb_unlock();
        pause_ms(1);
    }
    assert_int_equal(hear(bytes, sizeof bytes), USB_STREAM_HEARD);
    assert_memory_equal(bytes, many, USB_STREAM_HEARD);
}

static void unknown_requests_are_refused(void **state)
{
    (void)state;
    usb_connect();
    usb_request(USB_DIR_IN | USB_TYPE_VENDOR | USB_RECIP_INTERFACE);
    usb_request(USB_DIR_OUT | USB_TYPE_VENDOR | USB_RECIP_INTERFACE);
    usb_request(USB_DIR_IN | USB_TYPE_CLASS | USB_RECIP_ENDPOINT);
    int in = 0, out = 0;
    for (int ms = 0; ms < PATIENCE_MS && in + out < 3; ms++, pause_ms(1)) {
        usb_lock();
        in = usb_machine.stalls_in, out = usb_machine.stalls_out;
        usb_unlock();
    }
    assert_int_equal(in, 2);
    assert_int_equal(out, 1);
    assert_true(meet()); /* and nothing else has happened */
}

static void the_last_picture_arrives_before_the_end(void **state)
{
    (void)state;
    open_quiet(NULL);
    usb_connect();
    assert_true(meet());
    assert_int_equal(put(5, FRAME), 0);
    close_usb(NULL);
    assert_int_equal(usb_machine.got_size, FRAME);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_DEVICE(nothing_is_taken_while_nobody_is_there),
        WITH_DEVICE(what_is_written_arrives),
        WITH_DEVICE(the_last_packet_is_never_full),
        WITH_DEVICE(a_host_that_does_not_read_costs_pictures_not_time),
        WITH_DEVICE(who_begins_to_read_late_gets_nothing_old),
        WITH_DEVICE(no_more_is_taken_than_was_said),
        WITH_DEVICE(a_host_that_comes_again_gets_nothing_of_before),
        WITH_DEVICE(a_transfer_that_fails_makes_it_a_new_beginning),
        WITH_DEVICE(what_the_host_says_is_heard_in_order),
        WITH_DEVICE(a_host_that_is_not_heard_loses_its_last_words),
        WITH_DEVICE(unknown_requests_are_refused),
        cmocka_unit_test(the_last_picture_arrives_before_the_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
