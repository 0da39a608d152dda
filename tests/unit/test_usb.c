/* SPDX-License-Identifier: MIT */
/* What comes from a device on USB, and goes to it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "usb_case.h"

/* Reads until the device has heard so many requests, or there are no more of them. */
static void reader_listen(struct reader *r, struct port *port, unsigned requests)
{
    for (int steps = 0; steps < 500 && machine.heard_count < requests; steps++)
        assert_true(reader_step(r, port) >= 0);
}

static void bytes_come_as_they_were_sent(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    assert_true(port.there && port.asks && !port.polls);
    assert_string_equal(port.name, "usb:A1");
    assert_true(reader_run(&reader, &port, 1, CASE_BYTES));
    assert_int_equal(machine.most_flying, USB_IN);
    port_close(&port);
    case_end();
}

static void who_does_not_read_is_sent_no_more_than_there_is_room_for(void **state)
{
    struct port port;
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    for (int i = 0; i < 2000; i++) {
        assert_false(usb_step(port.usb));
        assert_int_equal(usb_events(port.usb, 1), 0);
    }
    assert_true(port.usb->received.count <= USB_QUEUE);
    assert_true(port.usb->received.count > USB_QUEUE - 2 * USB_BYTES);
    struct reader reader = {.connections = 1, .device = machine.devices};
    assert_true(reader_run(&reader, &port, 1, 2 * USB_QUEUE));
    port_close(&port);
    case_end();
}

static void it_waits_for_a_device(void **state)
{
    (void)state;
    for (int hotplug = 0; hotplug < 2; hotplug++) {
        struct port port;
        struct reader reader = {0};
        case_begin();
        machine.hotplug = hotplug;
        case_listen();
        assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
        for (int i = 0; i < 30; i++)
            reader_step(&reader, &port);
        bool there = port.there;
        machine_plug(1, "B2");
        double since = machine.now;
        assert_true(reader_run(&reader, &port, 1, 1));
        case_heard();
        assert_false(there);
        assert_true(machine.now - since < (hotplug ? 10 : 520));
        assert_string_equal(case_told, "");
        port_close(&port);
        case_end();
    }
}

static void a_device_may_be_pulled_at_every_callback(void **state)
{
    (void)state;
    for (int at = 1; at < 100; at++) {
        struct port port;
        struct reader reader = {0};
        case_begin();
        machine.hotplug = at % 2;
        machine.unplugs_at = at;
        machine_plug(0, "A1");
        assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
        for (int i = 0; i < 3; i++)
            port_ask(&port, STREAM_KEY_PLEASE, 0);
        assert_true(reader_run(&reader, &port, 2, 20000));
        assert_ptr_equal(reader.device, &machine.devices[1]);
        port_close(&port);
        case_end();
    }
}

static void an_endpoint_may_stall_at_every_callback(void **state)
{
    (void)state;
    for (int at = 1; at < 40; at++) {
        struct port port;
        struct reader reader = {0};
        case_begin();
        machine.stalls_at = at;
        machine_plug(0, "A1");
        assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
        for (int i = 0; i < 8; i++)
            port_ask(&port, STREAM_KEY_PLEASE, 0);
        assert_true(reader_run(&reader, &port, 1, 2 * CASE_BYTES));
        assert_int_equal(port.connections, 1);
        assert_true(machine.callbacks > at);
        port_ask(&port, STREAM_PAUSE, 1);
        reader_listen(&reader, &port, machine.heard_count + 8);
        assert_int_equal(machine.heard[machine.heard_count - 1][STREAM_AT_TYPE], STREAM_PAUSE);
        port_close(&port);
        case_end();
    }
}

static void a_device_that_stalls_for_ever_is_let_go_and_tried_again(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine.stalls_at = 1;
    machine.stalls_more = 1000;
    machine_plug(0, "A1");
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    assert_true(reader_run(&reader, &port, 2, 0));
    machine.stalls_more = 0;
    machine.devices[0].stalled_in = false;
    assert_true(reader_run(&reader, &port, 2, CASE_BYTES));
    port_close(&port);
    case_end();
}

/* All that are in flight end so: one stall. */
static void stalls_with_bytes_in_between_are_no_reason_to_leave(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    for (uint32_t i = 1; i <= 3 * USB_STALLS; i++) {
        assert_true(reader_run(&reader, &port, 1, i * 20000));
        machine.devices[0].stalled_in = true;
        for (unsigned k = 0; k < machine.flying_count; k++)
            machine.halted[k] = true;
    }
    machine.devices[0].stalled_in = true;
    machine.stalls_more = USB_STALLS - 1;
    assert_true(reader_run(&reader, &port, 1, reader.bytes + CASE_BYTES));
    assert_int_equal(port.connections, 1);
    port_close(&port);
    case_end();
}

static void after_an_error_the_device_is_opened_anew(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine.breaks_at = 5;
    machine_plug(0, "A1");
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    assert_true(reader_run(&reader, &port, 2, CASE_BYTES));
    port_close(&port);
    case_end();
}

/* Then no transfer is in flight that could end with an error. */
static void a_device_may_be_pulled_while_nobody_reads(void **state)
{
    struct port port;
    (void)state;
    case_begin();
    machine.hotplug = false;
    machine_plug(0, "A1");
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    struct reader reader = {.connections = 1, .device = machine.devices};
    for (int i = 0; i < 2000; i++) {
        usb_step(port.usb);
        usb_events(port.usb, 1);
    }
    assert_int_equal(machine.flying_count, 0);
    machine_replug(0);
    assert_true(reader_run(&reader, &port, 2, CASE_BYTES));
    assert_ptr_equal(reader.device, &machine.devices[1]);
    port_close(&port);
    case_end();
}

static void a_signal_is_no_error(void **state)
{
    (void)state;
    for (int at = 1; at < 20; at++) {
        struct port port;
        struct reader reader = {0};
        case_begin();
        machine.interrupts_at = at;
        machine_plug(0, "A1");
        case_listen();
        assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
        bool good = reader_run(&reader, &port, 1, CASE_BYTES);
        case_heard();
        assert_true(good);
        assert_string_equal(case_told, "");
        port_close(&port);
        case_end();
    }
}

/* Through a pull and a stall. Whatever fails, either there is a message and an end, or it goes on after it. */
static void every_call_may_fail(void **state)
{
    bool failed = true;
    (void)state;
    for (int at = 1; failed; at++) {
        struct port port;
        struct reader reader = {0};
        case_begin();
        machine.seam.fails_at = at;
        machine.unplugs_at = 30;
        machine.stalls_at = 12;
        machine_plug(0, "A1");
        case_listen();
        int code = port_open(&port, "usb:", NULL);
        bool good = false;
        if (code == CLI_DONE) {
            port_ask(&port, STREAM_KEY_PLEASE, 0);
            good = reader_run(&reader, &port, 2, 100000);
            port_close(&port);
        }
        case_heard();
        if (!good)
            assert_int_equal(case_lines("\n"), 1);
        else
            assert_string_equal(case_told, "");
        failed = machine.seam.calls >= at;
        case_end();
    }
}

static void a_transfer_that_never_ends_is_not_freed(void **state)
{
    struct port port;
    (void)state;
    case_begin();
    machine.swallows_at = 1;
    machine_plug(0, "A1");
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    port_read(&port, &(uint8_t){0}, 1, 100);
    struct usb *left = port.usb;
    port_close(&port);
    assert_int_equal(machine.transfers, 9);
    machine.flying_count = 0;
    usb_leave(left);
    libusb_exit(left->context);
    free(left);
    case_end();
}

static void requests_go_one_by_one_and_the_newest_are_kept(void **state)
{
    struct port port;
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    machine.mute = true;
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    for (uint32_t i = 1; i <= 40; i++)
        assert_int_equal(port_ask(&port, STREAM_BUTTONS, i), CLI_DONE);
    machine.mute = false;
    struct reader reader = {.connections = 1, .device = machine.devices};
    reader_listen(&reader, &port, 17);
    assert_int_equal(machine.heard_count, 17);
    for (unsigned i = 0; i < 17; i++) { /* the first was under way */
        assert_int_equal(machine.heard[i][STREAM_AT_X], i ? 40 - 16 + i : 1);
        assert_int_equal(machine.heard[i][STREAM_AT_SEQUENCE], i ? 40 - 16 + i : 1);
    }
    port_close(&port);
    case_end();
}

static void what_was_asked_of_a_device_is_not_told_to_the_next(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    machine.mute = true;
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    for (uint32_t i = 0; i < 10; i++)
        port_ask(&port, STREAM_BUTTONS, i);
    machine_replug(0);
    machine.mute = false;
    assert_true(reader_run(&reader, &port, 2, CASE_BYTES));
    assert_int_equal(machine.heard_count, 0);
    port_close(&port);
    case_end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_come_as_they_were_sent),
        cmocka_unit_test(who_does_not_read_is_sent_no_more_than_there_is_room_for),
        cmocka_unit_test(it_waits_for_a_device),
        cmocka_unit_test(a_device_may_be_pulled_at_every_callback),
        cmocka_unit_test(an_endpoint_may_stall_at_every_callback),
        cmocka_unit_test(a_device_that_stalls_for_ever_is_let_go_and_tried_again),
        cmocka_unit_test(stalls_with_bytes_in_between_are_no_reason_to_leave),
        cmocka_unit_test(after_an_error_the_device_is_opened_anew),
        cmocka_unit_test(a_device_may_be_pulled_while_nobody_reads),
        cmocka_unit_test(a_signal_is_no_error),
        cmocka_unit_test(every_call_may_fail),
        cmocka_unit_test(a_transfer_that_never_ends_is_not_freed),
        cmocka_unit_test(requests_go_one_by_one_and_the_newest_are_kept),
        cmocka_unit_test(what_was_asked_of_a_device_is_not_told_to_the_next),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
