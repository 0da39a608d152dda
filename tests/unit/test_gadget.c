/* SPDX-License-Identifier: MIT */
/* How a machine becomes a USB device and ceases to be one, whatever fails. */
#include "gadget_case.h"

static void assert_tells(const char *part)
{
    const char *end = strchr(told, '\n');
    if (!end || end[1] || !strstr(told, part))
        fail_msg("told: '%s', not one line with '%s'", told, part);
}

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

/* functionfs.h has the layout: header, four counts, the speeds, then what Windows is told. */
static void the_kernel_is_told_of_three_speeds_and_of_winusb(void **state)
{
    const uint8_t *at = usb_machine.told + 28;
    static const uint16_t packets[] = {64, 512, 1024};
    static const uint8_t beside[] = {6, 0x30, 0, 0, 0, 0}; /* an endpoint of super speed */
    (void)state;
    assert_int_equal(told32(0), FUNCTIONFS_DESCRIPTORS_MAGIC_V2);
    assert_int_equal(told32(4), usb_machine.told_size);
    assert_int_equal(told32(8), FUNCTIONFS_HAS_FS_DESC | FUNCTIONFS_HAS_HS_DESC | FUNCTIONFS_HAS_SS_DESC |
                                    FUNCTIONFS_HAS_MS_OS_DESC);
    assert_int_equal(told32(12), 3);
    assert_int_equal(told32(16), 3);
    assert_int_equal(told32(20), 5);
    assert_int_equal(told32(24), 2);
    for (int speed = 0; speed < 3; speed++, at += 7) {
        const uint8_t interface[] = {9, 4, 0, 0, 2, 0xFF, 0x47, 1, 1};
        const uint8_t in[] = {7, 5, 0x81, 2, (uint8_t)packets[speed], (uint8_t)(packets[speed] >> 8), 0};
        assert_memory_equal(at, interface, 9);
        const uint8_t out[] = {7, 5, 0x02, 2, (uint8_t)packets[speed], (uint8_t)(packets[speed] >> 8), 0};
        assert_memory_equal(at + 9, in, 7);
        at += 16;
        if (speed == 2) {
            assert_memory_equal(at, beside, 6);
            assert_memory_equal(at + 13, beside, 6);
            at += 6;
        }
        assert_memory_equal(at, out, 7);
    }
    at += 6;
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
    usb_lock();
    memcpy(&then, &usb_machine, sizeof then);
    usb_unlock();
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
    if (meet())
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
            usb_machine.seam.fails_at = call;
            usb_machine.seam.fails_on = on;
            int result = open_usb(NULL);
            if (!result && !on)
                run_with_a_host();
            usb_stream_close(&usb);
            if (!call)
                calls = usb_machine.seam.calls;
            if (result ? result != HAL_E_IO || !strchr(told, '\n') || strchr(told, '\n')[1] : told[0])
                fail_msg("call %d of %d, %d: result %d, told '%s'", call, calls, on, result, told);
            for (int i = 0; i <= USB_STOP; i++)
                assert_int_equal(usb_machine.open[i], 0);
            open_quiet(NULL);
            assert_string_equal(told, "");
            close_usb(NULL);
        }
    assert_in_range(calls, 40, 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_DEVICE(the_machine_is_plugged_in_with_its_names),
        WITH_DEVICE(the_kernel_is_told_of_three_speeds_and_of_winusb),
        cmocka_unit_test(what_a_machine_lacks_is_told),
        cmocka_unit_test(what_a_killed_program_left_is_cleared_away),
        cmocka_unit_test(another_program_is_not_disturbed),
        cmocka_unit_test(any_call_that_fails_is_told_or_mended),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
