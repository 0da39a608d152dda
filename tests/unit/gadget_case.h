/* SPDX-License-Identifier: MIT */
/* A link to a USB host on the machine of gadget_machine.h, opened, written to and closed. */
#ifndef GADGET_CASE_H
#define GADGET_CASE_H

#include "gadget_machine.h"

#include "display.h"
#include "linux/usb_stream.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <time.h>

#include <cmocka.h>

#include "listen.h"

enum { FRAME = 40000, TEXT = 4096, PATIENCE_MS = 4000 };

static struct usb_stream usb;
static uint8_t queue[2 * FRAME], got[USB_HOST_BYTES];
static char told[TEXT]; /* on standard error */
static uint32_t skipped;

static void pause_ms(unsigned ms)
{
    nanosleep(&(struct timespec){ms / 1000, ms % 1000 * 1000000l}, NULL);
}

static int open_usb(const char *udc)
{
    const struct usb_stream_config config = {
        .gadget = {udc, "Glint model", "4711"}, .queue = queue, .frame_most = FRAME};
    const struct listen errors = listen_begin(STDERR_FILENO);
    int result = usb_stream_open(&usb, &config);
    listen_end(&errors, told, sizeof told);
    return result;
}

static void assert_nothing_left(void)
{
    usb_lock();
    int nodes = usb_machine.nodes, open = 0, mounted = usb_machine.functionfs;
    for (int i = 0; i <= USB_STOP; i++)
        open += usb_machine.open[i];
    usb_unlock();
    assert_int_equal(nodes, 0);
    assert_int_equal(open, 0);
    assert_int_equal(mounted, 0);
}

static int open_quiet(void **state)
{
    (void)state;
    usb_start(got);
    skipped = 0;
    return open_usb(NULL);
}

static int close_usb(void **state)
{
    (void)state;
    usb_stream_close(&usb);
    usb_stream_close(&usb); /* harmless */
    assert_nothing_left();
    return 0;
}

static uint32_t begin(void)
{
    return usb.link.ops->begin(&usb.link, &skipped);
}

/* Waits until somebody is told of, before whom nobody is heard, and begins a picture for him: whether that is taken. */
static uint32_t meet(void)
{
    uint8_t byte;
    int32_t count = 0;
    for (int ms = 0; ms < PATIENCE_MS && !(count = usb.link.ops->read(&usb.link, &byte, 1)); ms++)
        pause_ms(1);
    return count == HAL_LINK_COMES && begin();
}

static int put(uint8_t value, size_t count)
{
    static uint8_t bytes[FRAME];
    memset(bytes, value, count);
    return usb.link.ops->write(&usb.link, bytes, count);
}

#define WITH_DEVICE(test) cmocka_unit_test_setup_teardown(test, open_quiet, close_usb)

#endif
