/* SPDX-License-Identifier: MIT */
/* glint-view's port to a device on USB, against USB in the test's hands. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <unistd.h>

#include "usb_machine.h"

/* The port waits by the machine's clock. */
#define cli_clock machine_clock
#define poll      machine_poll
#include "view/usb.c"
#undef poll
#undef cli_clock
#include "view/usb_find.c"

#define CASE_BYTES 150000u /* of a device: more than all transfers hold */

static char case_told[2048];
static int case_error;
static FILE *case_file;

static void case_listen(void)
{
    fflush(NULL);
    case_error = dup(2);
    case_file = tmpfile();
    dup2(fileno(case_file), 2);
}

static void case_heard(void)
{
    fflush(NULL);
    dup2(case_error, 2);
    close(case_error);
    rewind(case_file);
    case_told[fread(case_told, 1, sizeof case_told - 1, case_file)] = 0;
    fclose(case_file);
    case_file = NULL;
}

static unsigned case_lines(const char *text)
{
    unsigned lines = 0;
    for (const char *at = case_told; (at = strstr(at, text)) != NULL; at++)
        lines++;
    return lines;
}

static void case_begin(void)
{
    if (case_file)
        case_heard();
    random_seed(17);
    machine = (struct machine){.hotplug = true};
}

static void case_end(void)
{
    assert_int_equal(machine.contexts_open, 0);
    assert_int_equal(machine.lists_open, 0);
    assert_int_equal(machine.configs_open, 0);
    assert_int_equal(machine.handles_open, 0);
    assert_int_equal(machine.transfers, 0);
    assert_int_equal(machine.flying_count, 0);
}

struct reader {
    unsigned connections;
    const struct libusb_device *device;
    uint32_t bytes; /* of this device */
};

/* What comes is what the device sent, from its first byte on, in its order. */
static long reader_step(struct reader *r, struct port *port)
{
    static uint8_t bytes[5000];
    if (r->connections != port->connections) {
        assert_int_equal(port->connections, r->connections + 1);
        assert_true(port->there);
        *r = (struct reader){.connections = port->connections, .device = port->usb->device.handle->device};
    }
    long count = port_read(port, bytes, 1 + random_bits() % sizeof bytes, 100);
    if (r->connections != port->connections)
        assert_int_equal(count, 0);
    for (long i = 0; i < count; i++, r->bytes++)
        if (bytes[i] != machine_byte(r->device, r->bytes))
            fail_msg("byte %u of device %d is another", r->bytes, (int)(r->device - machine.devices));
    return count;
}

/* Reads until so many bytes of the n-th connection are there: false if that does not come to be. */
static bool reader_run(struct reader *r, struct port *port, unsigned connections, uint32_t bytes)
{
    for (int steps = 0; steps < 3000; steps++) {
        if (reader_step(r, port) < 0)
            return false;
        if (r->connections >= connections && r->bytes >= bytes)
            return true;
    }
    return false;
}

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

/* Through a pull and a stall. Whatever fails, either there is a message and an end, or it goes on after it. */
static void every_call_may_fail(void **state)
{
    bool failed = true;
    (void)state;
    for (int at = 1; failed; at++) {
        struct port port;
        struct reader reader = {0};
        case_begin();
        machine.fails_at = at;
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
        failed = machine.calls >= at;
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
    usb_find_release(&left->device);
    libusb_exit(left->context);
    usb_free(left);
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

static void the_same_serial_number_is_waited_for(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    assert_true(reader_run(&reader, &port, 1, 1000));
    machine.devices[0].there = false;
    machine_plug(1, "B2");
    for (int i = 0; i < 50; i++)
        reader_step(&reader, &port);
    assert_false(port.there);
    machine_plug(2, "A1");
    assert_true(reader_run(&reader, &port, 2, 1000));
    assert_ptr_equal(reader.device, &machine.devices[2]);
    port_close(&port);
    case_end();
}

static void the_serial_number_chooses(void **state)
{
    (void)state;
    for (int named = 0; named < 2; named++) {
        struct port port;
        case_begin();
        machine_plug(0, "A1");
        machine_plug(1, "B2");
        case_listen();
        assert_int_equal(port_open(&port, named ? "usb:B2" : "usb:", named ? NULL : "B2"), CLI_DONE);
        case_heard();
        assert_string_equal(port.name, "usb:B2");
        assert_string_equal(case_told, "");
        port_close(&port);
        case_end();
    }
}

static void of_two_the_first_that_is_free_is_taken_and_named(void **state)
{
    (void)state;
    for (int busy = 0; busy < 2; busy++) {
        struct port port;
        case_begin();
        machine_plug(0, "A1");
        machine_plug(1, "B2");
        machine.devices[0].busy = busy;
        case_listen();
        assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
        case_heard();
        assert_string_equal(port.name, busy ? "usb:B2" : "usb:A1");
        assert_int_equal(case_lines("\n"), 1);
        assert_int_equal(case_lines(port.name), 1);
        assert_int_equal(case_lines("--serial"), 1);
        port_close(&port);
        case_end();
    }
}

static void what_is_not_glints_is_left_alone(void **state)
{
    (void)state;
    for (int other = 0; other < 2; other++) {
        struct port port;
        case_begin();
        machine_plug(0, "A1");
        if (other)
            machine.devices[0].maker = "Glinty";
        else
            machine.devices[0].protocol = 2;
        assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
        assert_false(port.there);
        port_close(&port);
        case_end();
    }
}

/* At the second look: a device that has just come may not have its rights yet. */
static void access_denied_is_told_once_with_its_remedy(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    machine.devices[0].denied = true;
    case_listen();
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    for (int i = 0; i < 100; i++)
        reader_step(&reader, &port);
    port_missing(&port);
    case_heard();
    assert_int_equal(case_lines("\n"), 1);
    assert_int_equal(case_lines("70-glint.rules"), 1);
    machine.devices[0].denied = false;
    assert_true(reader_run(&reader, &port, 1, 1000));
    port_close(&port);
    case_end();
}

static void a_right_that_comes_in_time_is_no_message(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    machine.devices[0].denied = true;
    case_listen();
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    machine.devices[0].denied = false;
    assert_true(reader_run(&reader, &port, 1, 1000));
    case_heard();
    assert_string_equal(case_told, "");
    port_close(&port);
    case_end();
}

static void a_device_of_another_program_is_told_once(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    machine.devices[0].busy = true;
    case_listen();
    assert_int_equal(port_open(&port, "usb:A1", NULL), CLI_DONE);
    for (int i = 0; i < 100; i++)
        reader_step(&reader, &port);
    case_heard();
    assert_string_equal(case_told, "usb:A1: in use by another program\n");
    port_close(&port);
    case_end();
}

static void who_waits_no_longer_says_for_what(void **state)
{
    struct port port;
    (void)state;
    case_begin();
    assert_int_equal(port_open(&port, "usb:A1", NULL), CLI_DONE);
    case_listen();
    port_missing(&port);
    case_heard();
    assert_string_equal(case_told, "usb:A1: no device\n");
    machine_plug(0, "A1");
    struct reader reader = {0};
    assert_true(reader_run(&reader, &port, 1, 1));
    case_listen();
    port_missing(&port);
    case_heard();
    assert_string_equal(case_told, "usb:A1: no answer\n");
    port_close(&port);
    case_end();
}

static void devices_are_listed_without_what_a_terminal_would_obey(void **state)
{
    char text[512];
    (void)state;
    case_begin();
    machine_plug(0, "A1");
    machine_plug(2, "");
    fflush(NULL);
    int out = dup(1);
    FILE *file = tmpfile();
    dup2(fileno(file), 1);
    int code = port_list();
    fflush(NULL);
    dup2(out, 1);
    close(out);
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    assert_int_equal(code, CLI_DONE);
    assert_string_equal(text, "A1  Glint virt?[2J  480 Mbit/s  3.4.0\n-  Glint virt?[2J  12 Mbit/s  3.4.2\n");
    case_end();
}

static void a_list_of_none_says_why(void **state)
{
    (void)state;
    for (int denied = 0; denied < 2; denied++) {
        case_begin();
        if (denied)
            machine_plug(0, "A1");
        machine.devices[0].denied = denied;
        case_listen();
        int code = port_list();
        case_heard();
        assert_int_equal(code, CLI_IO);
        assert_int_equal(case_lines("\n"), 1);
        assert_int_equal(case_lines(denied ? "70-glint.rules" : "no device"), 1);
        case_end();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_come_as_they_were_sent),
        cmocka_unit_test(who_does_not_read_is_sent_no_more_than_there_is_room_for),
        cmocka_unit_test(it_waits_for_a_device),
        cmocka_unit_test(a_device_may_be_pulled_at_every_callback),
        cmocka_unit_test(an_endpoint_may_stall_at_every_callback),
        cmocka_unit_test(every_call_may_fail),
        cmocka_unit_test(a_transfer_that_never_ends_is_not_freed),
        cmocka_unit_test(requests_go_one_by_one_and_the_newest_are_kept),
        cmocka_unit_test(what_was_asked_of_a_device_is_not_told_to_the_next),
        cmocka_unit_test(the_same_serial_number_is_waited_for),
        cmocka_unit_test(the_serial_number_chooses),
        cmocka_unit_test(of_two_the_first_that_is_free_is_taken_and_named),
        cmocka_unit_test(what_is_not_glints_is_left_alone),
        cmocka_unit_test(access_denied_is_told_once_with_its_remedy),
        cmocka_unit_test(a_right_that_comes_in_time_is_no_message),
        cmocka_unit_test(a_device_of_another_program_is_told_once),
        cmocka_unit_test(who_waits_no_longer_says_for_what),
        cmocka_unit_test(devices_are_listed_without_what_a_terminal_would_obey),
        cmocka_unit_test(a_list_of_none_says_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
