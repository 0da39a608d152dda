/* SPDX-License-Identifier: MIT */
/* Which device on USB is taken, and what is said of those that are not. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "usb_case.h"

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
    for (int named = 0; named < 4; named++) {
        struct port port;
        case_begin();
        machine_plug(named < 2, "A1");
        machine_plug(named >= 2, "B2");
        case_listen();
        assert_int_equal(port_open(&port, named % 2 ? "usb:B2" : "usb:", named % 2 ? NULL : "B2"), CLI_DONE);
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
static void access_denied_is_told_once_a_plug_with_its_remedy(void **state)
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
    assert_string_equal(port.why, "access denied");
    machine.devices[0].there = false;
    for (int i = 0; i < 20; i++)
        reader_step(&reader, &port);
    assert_null(port.why);
    machine_plug(0, "A1");
    machine.devices[0].denied = true;
    case_listen();
    for (int i = 0; i < 20; i++)
        reader_step(&reader, &port);
    case_heard();
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

static void where_there_is_no_usb_that_is_told_once(void **state)
{
    struct port port;
    struct reader reader = {0};
    (void)state;
    case_begin();
    machine.none = true;
    case_listen();
    assert_int_equal(port_open(&port, "usb:", NULL), CLI_DONE);
    for (int i = 0; i < 100; i++)
        reader_step(&reader, &port);
    case_heard();
    assert_string_equal(case_told, "usb: Some error\n");
    assert_string_equal(port.why, "Some error");
    machine.none = false;
    machine_plug(0, "A1");
    assert_true(reader_run(&reader, &port, 1, 1000));
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
    const struct listen out = listen_begin(STDOUT_FILENO);
    int code = port_list();
    listen_end(&out, text, sizeof text);
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
        cmocka_unit_test(the_same_serial_number_is_waited_for),
        cmocka_unit_test(the_serial_number_chooses),
        cmocka_unit_test(of_two_the_first_that_is_free_is_taken_and_named),
        cmocka_unit_test(what_is_not_glints_is_left_alone),
        cmocka_unit_test(access_denied_is_told_once_a_plug_with_its_remedy),
        cmocka_unit_test(a_right_that_comes_in_time_is_no_message),
        cmocka_unit_test(a_device_of_another_program_is_told_once),
        cmocka_unit_test(where_there_is_no_usb_that_is_told_once),
        cmocka_unit_test(who_waits_no_longer_says_for_what),
        cmocka_unit_test(devices_are_listed_without_what_a_terminal_would_obey),
        cmocka_unit_test(a_list_of_none_says_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
