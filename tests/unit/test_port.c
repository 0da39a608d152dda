/* SPDX-License-Identifier: MIT */
/* glint-view's ports but USB, of which this build knows nothing. */
#define _DEFAULT_SOURCE /* as port.c, which is a part of this file */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "pack_case.h"

#undef _DEFAULT_SOURCE
#undef HAVE_LIBUSB
#include "view/port.c"

/* A pseudo-terminal: its other end, and its name. */
static int port_case_terminal(void)
{
    int other = posix_openpt(O_RDWR | O_NOCTTY);
    assert_true(other >= 0);
    assert_int_equal(grantpt(other), 0);
    assert_int_equal(unlockpt(other), 0);
    return other;
}

static char told[512];

static void without_libusb_it_says_so(void **state)
{
    struct port port;
    (void)state;
    const struct listen errors = listen_begin(STDERR_FILENO);
    int code = port_open(&port, "usb:A1", NULL), listed = port_list();
    listen_end(&errors, told, sizeof told);
    assert_int_equal(code, CLI_IO);
    assert_int_equal(listed, CLI_IO);
    assert_string_equal(told, "usb: built without libusb-1.0 (`make view` has it)\n"
                              "usb: built without libusb-1.0 (`make view` has it)\n");
}

static void a_file_is_read_to_its_end_and_asked_nothing(void **state)
{
    struct port port;
    struct case_file file;
    char input[80], bytes[8];
    (void)state;
    case_write(&file, "a.stream", "abcde", 5);
    snprintf(input, sizeof input, "file:%s", file.path);
    assert_int_equal(port_open(&port, input, NULL), CLI_DONE);
    assert_true(port.there && !port.asks && !port.polls);
    assert_string_equal(port.name, file.path);
    assert_int_equal(port_read(&port, bytes, 3, 0), 3);
    assert_int_equal(port_ask(&port, STREAM_KEY_PLEASE, 0), CLI_DONE);
    assert_int_equal(port_read(&port, bytes, 8, 0), 2);
    assert_memory_equal(bytes, "de", 2);
    assert_int_equal(port_read(&port, bytes, 8, 0), PORT_END);
    assert_int_equal(port.sequence, 0);
    port_close(&port);
    case_remove(&file);
}

static void requests_on_a_line_are_counted_from_1_and_0_is_left_out(void **state)
{
    static const uint16_t sequences[] = {1, 2, 65535, 1};
    struct port port;
    uint8_t message[STREAM_HEADER];
    int other = port_case_terminal();
    (void)state;
    assert_int_equal(port_open(&port, ptsname(other), NULL), CLI_DONE);
    assert_true(port.there && port.asks && port.polls);
    for (int i = 0; i < 4; i++) {
        port.sequence = i == 2 ? 65534 : port.sequence;
        assert_int_equal(port_ask(&port, STREAM_SCENE, 0x12345678), CLI_DONE);
        assert_int_equal(read(other, message, sizeof message), STREAM_HEADER);
        assert_int_equal(message[STREAM_AT_SEQUENCE] | message[STREAM_AT_SEQUENCE + 1] << 8, sequences[i]);
        assert_memory_equal(message, "\xF6GLS\x01\x85", 6);
        assert_memory_equal(message + STREAM_AT_X, "\x78\x56\x34\x12", 4);
    }
    port_close(&port);
    close(other);
}

static void a_line_brings_bytes_as_they_are_until_it_is_closed(void **state)
{
    static const uint8_t all[] = {0, 3, 4, 10, 13, 17, 19, 26, 28, 127, 128, 255};
    struct port port;
    uint8_t bytes[32];
    int other = port_case_terminal();
    (void)state;
    assert_int_equal(port_open(&port, ptsname(other), NULL), CLI_DONE);
    assert_int_equal(port_read(&port, bytes, sizeof bytes, 1), 0);
    assert_int_equal(write(other, all, sizeof all), sizeof all);
    assert_int_equal(port_read(&port, bytes, sizeof bytes, 1000), sizeof all);
    assert_memory_equal(bytes, all, sizeof all);
    close(other);
    assert_int_equal(port_read(&port, bytes, sizeof bytes, 1000), PORT_END);
    port_close(&port);
}

static void who_waits_no_longer_says_for_what(void **state)
{
    struct port port;
    char line[80];
    int other = port_case_terminal();
    (void)state;
    assert_int_equal(port_open(&port, ptsname(other), NULL), CLI_DONE);
    const struct listen errors = listen_begin(STDERR_FILENO);
    port_missing(&port);
    listen_end(&errors, told, sizeof told);
    snprintf(line, sizeof line, "%s: no answer\n", ptsname(other));
    assert_string_equal(told, line);
    port_close(&port);
    close(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_libusb_it_says_so),
        cmocka_unit_test(a_file_is_read_to_its_end_and_asked_nothing),
        cmocka_unit_test(requests_on_a_line_are_counted_from_1_and_0_is_left_out),
        cmocka_unit_test(a_line_brings_bytes_as_they_are_until_it_is_closed),
        cmocka_unit_test(who_waits_no_longer_says_for_what),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
