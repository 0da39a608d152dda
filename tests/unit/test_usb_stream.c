/* SPDX-License-Identifier: MIT */
/* Pictures to a USB host that comes, goes, and reads or not; on the machine of usb_machine.h. */
#include "usb_machine.h"

#include "display.h"
#include "linux/usb_stream.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

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
    FILE *file = tmpfile();
    int error = dup(2);
    fflush(stderr);
    dup2(fileno(file), 2);
    int result = usb_stream_open(&usb, &config);
    fflush(stderr);
    dup2(error, 2);
    close(error);
    rewind(file);
    told[fread(told, 1, sizeof told - 1, file)] = 0;
    fclose(file);
    return result;
}

static void assert_tells(const char *part)
{
    const char *end = strchr(told, '\n');
    if (!end || end[1] || !strstr(told, part))
        fail_msg("told: '%s', not one line with '%s'", told, part);
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

static enum hal_link_frame begin(void)
{
    return usb.link.ops->begin(&usb.link, &skipped);
}

/* Waits until a picture is taken: how. */
static enum hal_link_frame begin_soon(void)
{
    enum hal_link_frame frame = HAL_LINK_LEAVES;
    for (int ms = 0; ms < PATIENCE_MS && (frame = begin()) == HAL_LINK_LEAVES; ms++)
        pause_ms(1);
    return frame;
}

static int put(uint8_t value, size_t count)
{
    static uint8_t bytes[FRAME];
    memset(bytes, value, count);
    return usb.link.ops->write(&usb.link, bytes, count);
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

/* --- opening --------------------------------------------------------------------------------------------------------
 */

static void the_machine_is_plugged_in_with_its_names(void **state)
{
    (void)state;
    assert_string_equal(usb_machine.plugged, USB_UDC);
    assert_string_equal(usb_machine.node[usb_find(USB_GADGET "/strings/0x409/product")].text, "Glint model");
    assert_string_equal(usb_machine.node[usb_find(USB_GADGET "/strings/0x409/serialnumber")].text, "4711");
    assert_string_equal(usb_machine.node[usb_find(USB_GADGET "/idVendor")].text, "0x1209");
    assert_string_equal(usb_machine.node[usb_find(USB_GADGET "/os_desc/use")].text, "1");
}

static uint32_t told32(size_t at)
{
    uint32_t value;
    memcpy(&value, usb_machine.told + at, 4);
    return value;
}

/* functionfs.h has the layout: header, three counts, the speeds, then what Windows is told. */
static void the_kernel_is_told_of_both_speeds_and_of_winusb(void **state)
{
    const uint8_t *at = usb_machine.told + 24;
    static const uint16_t packets[] = {64, 512};
    (void)state;
    assert_int_equal(told32(0), FUNCTIONFS_DESCRIPTORS_MAGIC_V2);
    assert_int_equal(told32(4), usb_machine.told_size);
    assert_int_equal(told32(8), FUNCTIONFS_HAS_FS_DESC | FUNCTIONFS_HAS_HS_DESC | FUNCTIONFS_HAS_MS_OS_DESC);
    assert_int_equal(told32(12), 3);
    assert_int_equal(told32(16), 3);
    assert_int_equal(told32(20), 2);
    for (int speed = 0; speed < 2; speed++, at += 23) {
        const uint8_t interface[] = {9, 4, 0, 0, 2, 0xFF, 0x47, 1, 1};
        const uint8_t in[] = {7, 5, 0x81, 2, (uint8_t)packets[speed], (uint8_t)(packets[speed] >> 8), 0};
        assert_memory_equal(at, interface, 9);
        assert_memory_equal(at + 9, in, 7);
        assert_int_equal(at[18], 0x02);
    }
    const uint8_t compatible[] = {0, 35, 0, 0, 0, 1, 0, 4, 0, 1, 0, 0, 1, 'W', 'I', 'N', 'U', 'S', 'B', 0, 0};
    assert_memory_equal(at, compatible, sizeof compatible);
    at += 35;
    assert_int_equal(at[7], 5);
    assert_int_equal(at[1], 11 + 14 + 20 + 39);
    assert_string_equal(at + 21, "DeviceInterfaceGUID");
    assert_int_equal(at + at[1] - usb_machine.told, usb_machine.told_size);
}

static void what_a_machine_lacks_is_told(void **state)
{
    (void)state;
    usb_start(got);
    usb_machine.no_udc = 1;
    assert_int_equal(open_usb(NULL), HAL_E_IO);
    assert_tells("dtoverlay=dwc2");
    usb_start(got);
    assert_int_equal(open_usb("other.udc"), HAL_E_IO);
    assert_tells("no USB device controller 'other.udc'; there is 'test.udc'");
    usb_start(got);
    usb_machine.no_composite = 1;
    assert_int_equal(open_usb(USB_UDC), HAL_E_IO);
    assert_tells("modprobe libcomposite");
    for (int mounted = 0; mounted < 2; mounted++) {
        usb_start(got);
        usb_machine.no_root = 1;
        usb_machine.configfs = mounted;
        assert_int_equal(open_usb(USB_UDC), HAL_E_IO);
        assert_tells("it wants root");
    }
    assert_nothing_left();
}

/* After SIGKILL the kernel has closed the files and unplugged; folders, links and the mount are there as they were. */
static void what_a_killed_program_left_is_cleared_away(void **state)
{
    static struct usb_machine then;
    (void)state;
    open_quiet(NULL);
    memcpy(&then, &usb_machine, sizeof then);
    close_usb(NULL);
    memcpy(usb_machine.node, then.node, sizeof then.node);
    usb_machine.nodes = then.nodes;
    usb_machine.functionfs = 1;
    assert_int_equal(open_usb(NULL), 0);
    assert_string_equal(told, "");
    close_usb(NULL);
}

static void another_program_is_not_disturbed(void **state)
{
    (void)state;
    usb_start(got);
    usb_lock();
    usb_machine.configfs = 1;
    usb_add(USB_GADGET, "", 1, 0);
    usb_add(USB_GADGET "/idVendor", "theirs", 0, 0);
    snprintf(usb_machine.plugged, sizeof usb_machine.plugged, "%s", USB_UDC);
    usb_unlock();
    assert_int_equal(open_usb(NULL), HAL_E_IO);
    assert_tells("another glint-device");
    assert_int_equal(usb_machine.nodes, 2);
    usb_machine.nodes = usb_machine.plugged[0] = 0;
}

static void run_with_a_host(void)
{
    usb_connect();
    if (begin_soon() != HAL_LINK_LEAVES)
        put(1, 1000);
    usb_disconnect();
}

/* Whichever call fails, once or from there on: one message and nothing held, or none; and the next run finds no
 * obstacle. */
static void any_call_that_fails_is_told_or_mended(void **state)
{
    int calls = 0;
    (void)state;
    for (int on = 0; on < 2; on++)
        for (int call = 0; call <= calls; call++) {
            usb_start(got);
            usb_machine.configfs = 0;
            usb_machine.fails_at = call;
            usb_machine.fails_on = on;
            int result = open_usb(NULL);
            if (!result && !on)
                run_with_a_host();
            usb_stream_close(&usb);
            if (!call)
                calls = usb_machine.calls;
            if (result ? result != HAL_E_IO || !strchr(told, '\n') || strchr(told, '\n')[1] : told[0])
                fail_msg("call %d of %d, %d: result %d, told '%s'", call, calls, on, result, told);
            for (int i = 0; i <= USB_STOP; i++)
                assert_int_equal(usb_machine.open[i], 0);
            open_quiet(NULL);
            assert_string_equal(told, "");
            close_usb(NULL);
        }
    assert_in_range(calls, 50, 200);
}

/* --- a host ---------------------------------------------------------------------------------------------------------
 */

static void nothing_is_taken_while_nobody_is_there(void **state)
{
    (void)state;
    assert_int_equal(begin(), HAL_LINK_LEAVES);
    assert_int_equal(put(1, 100), HAL_E_IO);
    assert_int_equal(skipped, 0);
}

static void what_is_written_arrives(void **state)
{
    (void)state;
    usb_connect();
    assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
    size_t sum = 0;
    for (uint8_t i = 1; i <= 30; i++) { /* around the queue's end, more than once */
        if (i > 1)
            assert_int_equal(begin_soon(), HAL_LINK_TAKES);
        assert_int_equal(put(i, 1000u * i), 0);
        assert_int_equal(put(0xFF, 4), 0);
        sum += 1000u * i + 4;
    }
    assert_in_range(received(sum), sum, sum + 30);
    size_t at = 0;
    for (uint8_t i = 1; i <= 30; i++) {
        for (; !got[at]; at++) /* padding */
            ;
        for (size_t k = 0; k < 1000u * i + 4; k++, at++)
            assert_int_equal(got[at] ? got[at] : got[++at], k < 1000u * i ? i : 0xFF);
    }
}

/* A host's transfer ends with a packet that is not full. */
static void the_last_packet_is_never_full(void **state)
{
    (void)state;
    usb_connect();
    assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
    size_t sum = 0;
    for (uint32_t count = 64; count <= 1024; count *= 2) {
        assert_int_equal(put(7, count), 0);
        sum += count + 1;
        assert_int_equal(received(sum), sum);
        assert_int_equal(got[sum - 1], 0);
        assert_int_equal(usb_machine.last_size % 64, 1);
        assert_int_equal(put(7, count - 1), 0);
        sum += count - 1;
        assert_int_equal(received(sum), sum);
    }
}

static void a_host_that_does_not_read_costs_pictures_not_time(void **state)
{
    (void)state;
    usb_read(0);
    usb_connect();
    assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
    assert_int_equal(put(1, FRAME), 0);
    while (begin() == HAL_LINK_LEAVES) /* until the first has begun to leave */
        pause_ms(1);
    assert_int_equal(put(2, FRAME), 0);
    skipped = 0;
    for (int i = 0; i < 1000; i++)
        assert_int_equal(begin(), HAL_LINK_LEAVES);
    assert_int_equal(skipped, 1000);
    usb_read(1);
    assert_in_range(received(2 * FRAME), 2 * FRAME, 2 * FRAME + 4);
    assert_int_equal(begin_soon(), HAL_LINK_TAKES); /* it is still the same one */
    assert_int_equal(put(3, 10), 0);
}

static void no_more_is_taken_than_was_said(void **state)
{
    (void)state;
    usb_read(0);
    usb_connect();
    assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
    assert_int_equal(put(1, FRAME), 0);
    assert_int_equal(put(1, FRAME), 0);
    assert_int_equal(put(1, 1), HAL_E_FULL);
}

static void a_host_that_comes_again_gets_nothing_of_before(void **state)
{
    (void)state;
    for (int pulled = 0; pulled < 2; pulled++) {
        usb_read(0);
        usb_connect();
        assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
        assert_int_equal(put(1, FRAME), 0);
        if (pulled) {
            usb_disconnect();
            while (begin() == HAL_LINK_TAKES) /* it notices */
                pause_ms(1);
            assert_int_equal(put(1, 10), HAL_E_IO);
        }
        usb_connect();
        usb_read(1);
        usb_lock();
        usb_machine.got_size = 0;
        usb_unlock();
        while (put(1, 1) == 0) /* of the picture before: refused once the new one is known of */
            pause_ms(1);
        assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
        usb_lock();
        size_t before = usb_machine.got_size; /* what was written while it had not been told of */
        usb_unlock();
        assert_in_range(before, 0, FRAME / 4);
        assert_int_equal(put(9, 1000), 0);
        received(before + 1000);
        assert_int_equal(got[usb_machine.got_size - 1], 9);
        assert_int_equal(begin_soon(), HAL_LINK_TAKES);
        usb_disconnect();
    }
}

static void a_transfer_that_fails_makes_it_a_new_beginning(void **state)
{
    (void)state;
    usb_connect();
    assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
    usb_read(0);
    assert_int_equal(put(1, 100), 0);
    pause_ms(20); /* the thread waits for the host */
    usb_lock();
    usb_machine.interrupts = 1;
    usb_unlock();
    usb_read(1);
    enum hal_link_frame frame = begin_soon();
    for (int ms = 0; ms < PATIENCE_MS && frame == HAL_LINK_TAKES; ms++) {
        pause_ms(1);
        frame = begin_soon();
    }
    assert_int_equal(frame, HAL_LINK_TAKES_FIRST);
    assert_int_equal(put(2, 100), 0);
    received(100);
    assert_int_equal(got[0], 2);
}

static uint32_t hear(uint8_t *bytes, uint32_t size)
{
    uint32_t count = 0;
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
    assert_int_equal(usb.link.ops->read(&usb.link, bytes, 64), 0); /* not before begin told of him */
    assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
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
    assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
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
    assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST); /* and nothing else has happened */
}

static void the_last_picture_arrives_before_the_end(void **state)
{
    (void)state;
    open_quiet(NULL);
    usb_connect();
    assert_int_equal(begin_soon(), HAL_LINK_TAKES_FIRST);
    assert_int_equal(put(5, FRAME), 0);
    close_usb(NULL);
    assert_in_range(usb_machine.got_size, FRAME, FRAME + 1);
}

int main(void)
{
#define WITH_DEVICE(test) cmocka_unit_test_setup_teardown(test, open_quiet, close_usb)
    const struct CMUnitTest tests[] = {
        WITH_DEVICE(the_machine_is_plugged_in_with_its_names),
        WITH_DEVICE(the_kernel_is_told_of_both_speeds_and_of_winusb),
        cmocka_unit_test(what_a_machine_lacks_is_told),
        cmocka_unit_test(what_a_killed_program_left_is_cleared_away),
        cmocka_unit_test(another_program_is_not_disturbed),
        cmocka_unit_test(any_call_that_fails_is_told_or_mended),
        WITH_DEVICE(nothing_is_taken_while_nobody_is_there),
        WITH_DEVICE(what_is_written_arrives),
        WITH_DEVICE(the_last_packet_is_never_full),
        WITH_DEVICE(a_host_that_does_not_read_costs_pictures_not_time),
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
