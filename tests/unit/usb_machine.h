/* SPDX-License-Identifier: MIT */
/*
 * USB in a test's hands: libusb's functions, devices that come and go, and a clock that only waiting moves. Every rule
 * of the library's that a program could break is asserted: nothing is freed, submitted or closed under a transfer in
 * flight, no callback waits, and what was opened is closed. Each call that may fail is counted, and one can be made to.
 */
#ifndef USB_MACHINE_H
#define USB_MACHINE_H

#include "random.h"
#include "tests/faults/seam.h"

#include <libusb.h>
#include <poll.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define MACHINE_DEVICES 3
#define MACHINE_FLYING  16
#define MACHINE_HEARD   64

struct libusb_device {
    bool there, denied, busy;
    const char *maker, *serial;
    int protocol;
    uint32_t sent; /* bytes since it was claimed */
    bool stalled_in, stalled_out;
};

struct libusb_context {
    bool seen[MACHINE_DEVICES]; /* when it was made */
    libusb_hotplug_callback_fn plugged;
    void *user_data;
};

struct libusb_device_handle {
    struct libusb_device *device; /* null: closed */
    bool claimed;
};

struct machine {
    struct libusb_device devices[MACHINE_DEVICES];
    struct libusb_device_handle handles[MACHINE_DEVICES];
    struct libusb_context contexts[1];
    struct libusb_transfer *flying[MACHINE_FLYING];
    bool cancelled[MACHINE_FLYING], halted[MACHINE_FLYING]; /* halted: submitted to an endpoint that was */
    const struct libusb_transfer *swallowed;
    unsigned flying_count, most_flying;
    int contexts_open, lists_open, configs_open, handles_open, transfers; /* how many are held */
    struct seam seam;
    int callbacks, unplugs_at, stalls_at, swallows_at; /* a callback's number from 1; swallows: never comes */
    bool in_callback, hotplug, arrived, mute;          /* mute: the device sends nothing and takes nothing */
    bool none;                                         /* there is no USB */
    unsigned stalls_more;                              /* so often what is cleared stalls again at once */
    int breaks_at, interrupts_at;                      /* a callback, with an error; a wait, by a signal */
    int waits;
    int errors; /* given since it was unplugged */
    double now;
    uint8_t heard[MACHINE_HEARD][32];
    unsigned heard_count;
};
static struct machine machine;

static bool machine_fails(void)
{
    assert_false(machine.in_callback);
    return seam_fails(&machine.seam);
}

/* The stream of a device: no two bytes near to each other are in the same place of two devices'. */
static uint8_t machine_byte(const struct libusb_device *d, uint32_t at)
{
    return (uint8_t)(at * 31 + (at >> 8) * 7 + (uint32_t)(d - machine.devices) * 101);
}

static void machine_plug(unsigned device, const char *serial)
{
    machine.devices[device] = (struct libusb_device){.there = true, .maker = "Glint", .serial = serial, .protocol = 1};
    machine.arrived = true;
}

/* It comes back as another device of the library's. */
static void machine_replug(unsigned device)
{
    machine.devices[device].there = false;
    machine.errors = 0;
    machine_plug(device + 1, machine.devices[device].serial);
}

static double machine_clock(void)
{
    return machine.now += .001;
}

static int machine_poll(struct pollfd *files, nfds_t count, int wait_ms)
{
    assert_int_equal(count, 0);
    (void)files;
    machine.now += wait_ms;
    return 0;
}

int libusb_init(libusb_context **context)
{
    if (machine_fails() || machine.none)
        return LIBUSB_ERROR_OTHER;
    assert_int_equal(machine.contexts_open++, 0);
    *context = &machine.contexts[0];
    **context = (libusb_context){0};
    for (int i = 0; i < MACHINE_DEVICES; i++)
        (*context)->seen[i] = machine.devices[i].there;
    machine.arrived = false;
    return 0;
}

void libusb_exit(libusb_context *context)
{
    assert_ptr_equal(context, &machine.contexts[0]);
    assert_false(machine.in_callback);
    assert_int_equal(machine.handles_open, 0);
    assert_int_equal(machine.lists_open, 0);
    assert_int_equal(machine.transfers, 0); /* each holds the device that it was last submitted to */
    machine.contexts_open--;
}

int libusb_has_capability(uint32_t capability)
{
    return capability == LIBUSB_CAP_HAS_HOTPLUG && machine.hotplug;
}

int libusb_hotplug_register_callback(libusb_context *context, int events, int flags, int vendor, int product, int class,
                                     libusb_hotplug_callback_fn plugged, void *user_data,
                                     libusb_hotplug_callback_handle *handle)
{
    assert_int_equal(events, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED);
    assert_true(machine.hotplug && vendor == 0x1209 && product == 1 && class == LIBUSB_HOTPLUG_MATCH_ANY);
    (void)flags, (void)handle;
    if (machine_fails())
        return LIBUSB_ERROR_NO_MEM;
    context->plugged = plugged;
    context->user_data = user_data;
    return 0;
}

ssize_t libusb_get_device_list(libusb_context *context, libusb_device ***list)
{
    static libusb_device *devices[MACHINE_DEVICES + 1];
    ssize_t count = 0;
    if (machine_fails())
        return LIBUSB_ERROR_NO_MEM;
    for (int i = 0; i < MACHINE_DEVICES; i++)
        if (context->seen[i])
            devices[count++] = &machine.devices[i];
    *list = devices;
    machine.lists_open++;
    return count;
}

void libusb_free_device_list(libusb_device **list, int unreference)
{
    assert_non_null(list);
    assert_true(unreference);
    machine.lists_open--;
}

int libusb_get_device_descriptor(libusb_device *device, struct libusb_device_descriptor *about)
{
    (void)device;
    *about = (struct libusb_device_descriptor){
        .idVendor = 0x1209, .idProduct = 1, .iManufacturer = 1, .iProduct = 2, .iSerialNumber = 3};
    return machine_fails() ? LIBUSB_ERROR_IO : 0;
}

int libusb_get_active_config_descriptor(libusb_device *device, struct libusb_config_descriptor **config)
{
    static const struct libusb_endpoint_descriptor endpoints[] = {
        {.bEndpointAddress = 0x83, .bmAttributes = LIBUSB_TRANSFER_TYPE_INTERRUPT},
        {.bEndpointAddress = 0x82, .bmAttributes = LIBUSB_TRANSFER_TYPE_BULK},
        {.bEndpointAddress = 0x01, .bmAttributes = LIBUSB_TRANSFER_TYPE_BULK}};
    static struct libusb_interface_descriptor setting;
    static const struct libusb_interface interface = {&setting, 1};
    static struct libusb_config_descriptor configuration = {.bNumInterfaces = 1, .interface = &interface};
    if (machine_fails())
        return LIBUSB_ERROR_IO;
    setting = (struct libusb_interface_descriptor){.bInterfaceNumber = 2,
                                                   .bInterfaceClass = 0xFF,
                                                   .bInterfaceSubClass = 0x47,
                                                   .bInterfaceProtocol = (uint8_t)device->protocol,
                                                   .bNumEndpoints = 3,
                                                   .endpoint = endpoints};
    *config = &configuration;
    machine.configs_open++;
    return 0;
}

void libusb_free_config_descriptor(struct libusb_config_descriptor *config)
{
    assert_non_null(config);
    machine.configs_open--;
}

int libusb_open(libusb_device *device, libusb_device_handle **handle)
{
    if (machine_fails())
        return LIBUSB_ERROR_NO_MEM;
    if (!device->there || device->denied)
        return device->there ? LIBUSB_ERROR_ACCESS : LIBUSB_ERROR_NO_DEVICE;
    *handle = &machine.handles[device - machine.devices];
    assert_null((*handle)->device);
    **handle = (libusb_device_handle){.device = device};
    machine.handles_open++;
    return 0;
}

void libusb_close(libusb_device_handle *handle)
{
    assert_false(machine.in_callback);
    assert_non_null(handle->device);
    for (unsigned i = 0; i < machine.flying_count; i++)
        assert_ptr_not_equal(machine.flying[i]->dev_handle, handle);
    handle->device = NULL;
    machine.handles_open--;
}

int libusb_get_string_descriptor_ascii(libusb_device_handle *handle, uint8_t index, unsigned char *text, int size)
{
    const char *strings[] = {handle->device->maker, "Glint virt\033[2J", handle->device->serial};
    assert_true(index >= 1 && index <= 3);
    if (machine_fails() || !handle->device->there)
        return LIBUSB_ERROR_PIPE;
    int count = (int)strlen(strings[index - 1]);
    memcpy(text, strings[index - 1], (size_t)(count < size ? count : size));
    return count < size ? count : size;
}

int libusb_claim_interface(libusb_device_handle *handle, int interface)
{
    assert_int_equal(interface, 2);
    if (machine_fails() || handle->device->busy)
        return LIBUSB_ERROR_BUSY;
    handle->claimed = true;
    handle->device->sent = 0;
    return handle->device->there ? 0 : LIBUSB_ERROR_NO_DEVICE;
}

int libusb_release_interface(libusb_device_handle *handle, int interface)
{
    assert_int_equal(interface, 2);
    assert_true(handle->claimed);
    handle->claimed = false;
    return machine_fails() ? LIBUSB_ERROR_OTHER : 0;
}

int libusb_clear_halt(libusb_device_handle *handle, unsigned char endpoint)
{
    if (machine_fails() || !handle->device->there)
        return LIBUSB_ERROR_NO_DEVICE;
    for (unsigned i = 0; i < machine.flying_count; i++)
        assert_int_not_equal(machine.flying[i]->endpoint, endpoint);
    *(endpoint & LIBUSB_ENDPOINT_IN ? &handle->device->stalled_in : &handle->device->stalled_out) =
        machine.stalls_more != 0;
    machine.stalls_more -= machine.stalls_more != 0;
    return 0;
}

struct libusb_transfer *libusb_alloc_transfer(int packets)
{
    assert_int_equal(packets, 0);
    if (machine_fails())
        return NULL;
    machine.transfers++;
    return calloc(1, sizeof(struct libusb_transfer));
}

void libusb_free_transfer(struct libusb_transfer *t)
{
    for (unsigned i = 0; i < machine.flying_count; i++)
        assert_ptr_not_equal(machine.flying[i], t);
    machine.transfers -= t != NULL;
    free(t);
}

int libusb_submit_transfer(struct libusb_transfer *t)
{
    assert_true(t->dev_handle->claimed);
    assert_int_equal(t->timeout, 0);
    assert_true(t->endpoint == 1 || t->length == 16384);
    for (unsigned i = 0; i < machine.flying_count; i++)
        assert_ptr_not_equal(machine.flying[i], t);
    if (machine_fails() || !t->dev_handle->device->there)
        return LIBUSB_ERROR_NO_DEVICE;
    assert_true(machine.flying_count < MACHINE_FLYING);
    const struct libusb_device *d = t->dev_handle->device;
    machine.cancelled[machine.flying_count] = false;
    machine.halted[machine.flying_count] = t->endpoint & LIBUSB_ENDPOINT_IN ? d->stalled_in : d->stalled_out;
    machine.flying[machine.flying_count++] = t;
    if (machine.flying_count > machine.most_flying)
        machine.most_flying = machine.flying_count;
    return 0;
}

int libusb_cancel_transfer(struct libusb_transfer *t)
{
    if (machine_fails())
        return LIBUSB_ERROR_OTHER;
    for (unsigned i = 0; i < machine.flying_count; i++)
        if (machine.flying[i] == t) {
            bool again = machine.cancelled[i];
            machine.cancelled[i] = true;
            return again ? LIBUSB_ERROR_NOT_FOUND : 0;
        }
    fail_msg("a transfer that is not in flight was cancelled");
    return 0;
}

static void machine_call(unsigned i, enum libusb_transfer_status status, int length)
{
    struct libusb_transfer *t = machine.flying[i];
    struct libusb_device *d = t->dev_handle->device;
    if (++machine.callbacks == machine.swallows_at) {
        machine.swallowed = t;
        return;
    }
    machine.flying_count--;
    for (; i < machine.flying_count; i++) {
        machine.flying[i] = machine.flying[i + 1];
        machine.cancelled[i] = machine.cancelled[i + 1];
        machine.halted[i] = machine.halted[i + 1];
    }
    bool in = t->endpoint & LIBUSB_ENDPOINT_IN;
    for (int k = 0; in && k < length; k++)
        t->buffer[k] = machine_byte(d, d->sent++);
    if (!in && length && machine.heard_count < MACHINE_HEARD)
        memcpy(machine.heard[machine.heard_count++], t->buffer, 32);
    t->status = status;
    t->actual_length = length;
    machine.in_callback = true;
    t->callback(t);
    machine.in_callback = false;
    if (machine.callbacks == machine.unplugs_at && d->there)
        machine_replug((unsigned)(d - machine.devices));
}

/* What becomes of a transfer in flight: false if nothing yet. */
static bool machine_complete(unsigned i)
{
    struct libusb_transfer *t = machine.flying[i];
    struct libusb_device *d = t->dev_handle->device;
    bool in = t->endpoint & LIBUSB_ENDPOINT_IN, *stalled = in ? &d->stalled_in : &d->stalled_out;
    int length = !in ? t->length : random_bits() % 4 ? (int)(random_bits() % 700) : t->length;
    bool early = !d->there && machine.errors++ < 2;
    if (t == machine.swallowed)
        return false;
    if (!d->there)
        machine_call(i, early ? LIBUSB_TRANSFER_ERROR : LIBUSB_TRANSFER_NO_DEVICE, early && in ? 5 : 0);
    else if (machine.cancelled[i])
        machine_call(i, LIBUSB_TRANSFER_CANCELLED, 0);
    else if (machine.halted[i])
        machine_call(i, LIBUSB_TRANSFER_STALL, 0);
    else if (machine.callbacks + 1 == machine.breaks_at)
        machine_call(i, LIBUSB_TRANSFER_ERROR, 0);
    else if (machine.callbacks + 1 == machine.stalls_at && !*stalled)
        *stalled = true, machine_call(i, LIBUSB_TRANSFER_STALL, in ? 64 : 0);
    else if (!machine.mute && !*stalled)
        machine_call(i, LIBUSB_TRANSFER_COMPLETED, length);
    else
        return false;
    return true;
}

int libusb_handle_events_timeout_completed(libusb_context *context, struct timeval *wait, int *completed)
{
    unsigned done = 0, most = 1 + random_bits() % 3;
    assert_true(machine.contexts_open == 1 && !completed);
    assert_true(wait->tv_sec >= 0 && wait->tv_usec >= 0 && wait->tv_usec < 1000000);
    if (machine_fails())
        return LIBUSB_ERROR_IO;
    if (++machine.waits == machine.interrupts_at)
        return LIBUSB_ERROR_INTERRUPTED;
    if (machine.arrived && context->plugged) {
        machine.arrived = false;
        machine.in_callback = true;
        context->plugged(context, NULL, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED, context->user_data);
        machine.in_callback = false;
        return 0;
    }
    for (unsigned i = 0; i < machine.flying_count && done < most;)
        if (machine_complete(i))
            done++;
        else
            i++;
    machine.now += done ? .1 : 1000. * (double)wait->tv_sec + (double)wait->tv_usec / 1000. + .01;
    return 0;
}

int libusb_get_device_speed(libusb_device *device)
{
    return device == machine.devices ? LIBUSB_SPEED_HIGH : LIBUSB_SPEED_FULL;
}

int libusb_get_port_numbers(libusb_device *device, uint8_t *ports, int size)
{
    assert_int_equal(size, 7);
    ports[0] = 4;
    ports[1] = (uint8_t)(device - machine.devices);
    return 2;
}

uint8_t libusb_get_bus_number(libusb_device *device)
{
    return device->there ? 3 : 0;
}

const char *libusb_strerror(int error)
{
    return error == LIBUSB_ERROR_NO_MEM ? "Insufficient memory" : "Some error";
}

#endif
