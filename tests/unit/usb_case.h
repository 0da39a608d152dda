/* SPDX-License-Identifier: MIT */
/* glint-view's port to a device on USB, against USB in the test's hands. Include after cmocka.h, once in a program. */
#ifndef USB_CASE_H
#define USB_CASE_H

#include "listen.h"
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
static struct listen case_errors;

static void case_listen(void)
{
    case_errors = listen_begin(STDERR_FILENO);
}

static void case_heard(void)
{
    listen_end(&case_errors, case_told, sizeof case_told);
    case_errors.file = NULL;
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
    if (case_errors.file)
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

#endif
