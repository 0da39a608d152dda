/* SPDX-License-Identifier: MIT */
#ifdef HAVE_LIBUSB
#include "view/usb.h"

#include "glint/cli.h"
#include "view/queue.h"
#include "view/usb_find.h"

#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define USB_IN      8     /* transfers in flight */
#define USB_BYTES   16384 /* each: a multiple of every packet size, so that a packet never ends beyond it */
#define USB_QUEUE   PORT_MOST
#define USB_WAITING 16    /* requests; a newer one takes the oldest's place */
#define USB_LOOK_MS 500.  /* between looks for the device */
#define USB_END_MS  2000. /* that the end waits for the library to give all transfers back */
#define USB_STALLS  8     /* in a row: then the device is let go */

struct usb_transfer {
    struct usb *usb;
    struct libusb_transfer *transfer;
    bool flying; /* from its submission until its callback: then nobody else may touch it or its bytes */
    uint8_t *bytes;
};

struct usb {
    struct port *port;
    libusb_context *context;  /* of the last look; null: it failed */
    struct usb_device device; /* while its handle is not null */
    bool leaving;             /* it is gone, or as good as: once no transfer is in flight it is closed */
    bool in_stalled, out_stalled;
    unsigned stalls; /* since the last byte */
    struct usb_transfer in[USB_IN], out;
    struct queue received, requests;
    char serial[USB_FIND_TEXT]; /* the one wanted; "": any */
    char name[USB_FIND_TEXT + 4];
    bool arrived;      /* the library has seen a device come */
    double look;       /* when to look again */
    int trouble, told; /* what the last look gave, and of that the last that was told */
    uint8_t in_bytes[USB_IN][USB_BYTES], out_bytes[STREAM_HEADER];
    uint8_t received_bytes[USB_QUEUE], request_bytes[USB_WAITING * STREAM_HEADER];
};

/* What a transfer's end says of the device. */
static void usb_judge(struct usb *u, const struct libusb_transfer *t, bool *stalled)
{
    if (t->status == LIBUSB_TRANSFER_STALL) {
        u->stalls += !*stalled; /* all that are in flight end so */
        u->leaving |= u->stalls > USB_STALLS;
        *stalled = true;
    } else if (t->status != LIBUSB_TRANSFER_COMPLETED && t->status != LIBUSB_TRANSFER_CANCELLED) {
        u->leaving = true; /* an unplugged device gives errors before it gives NO_DEVICE */
    }
}

static void LIBUSB_CALL usb_received(struct libusb_transfer *t)
{
    struct usb_transfer *in = t->user_data;
    struct usb *u = in->usb;
    in->flying = false;
    if (t->actual_length > 0) { /* whatever became of the rest: these have come */
        queue_put(&u->received, in->bytes, (size_t)t->actual_length);
        u->stalls = 0;
    }
    usb_judge(u, t, &u->in_stalled);
}

static void LIBUSB_CALL usb_sent(struct libusb_transfer *t)
{
    struct usb_transfer *out = t->user_data;
    out->flying = false;
    usb_judge(out->usb, t, &out->usb->out_stalled);
}

static int LIBUSB_CALL usb_plugged(libusb_context *context, libusb_device *device, libusb_hotplug_event event,
                                   void *user_data)
{
    (void)context, (void)device, (void)event;
    ((struct usb *)user_data)->arrived = true;
    return 0;
}

static unsigned usb_flying(const struct usb *u)
{
    unsigned count = 0;
    for (unsigned i = 0; i < USB_IN; i++)
        count += u->in[i].flying;
    return count;
}

static void usb_submit(struct usb_transfer *t)
{
    t->flying = libusb_submit_transfer(t->transfer) == 0;
    t->usb->leaving |= !t->flying;
}

/* The last first: what the first has taken by then is followed by nothing. A cancellation may fail, so it is asked for
 * as long as it takes. */
static void usb_cancel(struct usb *u, bool in, bool out)
{
    for (unsigned i = USB_IN; in && i-- > 0;)
        if (u->in[i].flying)
            libusb_cancel_transfer(u->in[i].transfer);
    if (out && u->out.flying)
        libusb_cancel_transfer(u->out.transfer);
}

/* A stalled endpoint goes on when nothing is in flight on it. */
static void usb_clear(struct usb *u)
{
    if (u->in_stalled && usb_flying(u) == 0) {
        u->leaving |= libusb_clear_halt(u->device.handle, u->device.in) != 0;
        u->in_stalled = false;
    }
    if (u->out_stalled && !u->out.flying) {
        u->leaving |= libusb_clear_halt(u->device.handle, u->device.out) != 0;
        u->out_stalled = false;
    }
}

/* As many transfers as there will be room for what they bring. */
static void usb_fill(struct usb *u)
{
    unsigned flying = usb_flying(u);
    for (unsigned i = 0; i < USB_IN && !u->in_stalled && !u->leaving; i++)
        if (!u->in[i].flying && queue_free(&u->received) >= (size_t)(flying + 1) * USB_BYTES) {
            usb_submit(&u->in[i]);
            flying++;
        }
    if (!u->out.flying && !u->out_stalled && !u->leaving && u->requests.count) {
        queue_take(&u->requests, u->out.bytes, STREAM_HEADER);
        usb_submit(&u->out);
    }
}

/* A transfer keeps hold of its device even when it has ended, and a device must not outlive its context. */
static void usb_drop(struct usb_transfer *t)
{
    libusb_free_transfer(t->transfer);
    t->transfer = NULL;
}

static void usb_leave(struct usb *u)
{
    for (unsigned i = 0; i < USB_IN; i++)
        usb_drop(&u->in[i]);
    usb_drop(&u->out);
    usb_find_release(&u->device);
    u->leaving = u->in_stalled = u->out_stalled = false;
    u->requests.count = 0;
    u->look = cli_clock() + USB_LOOK_MS;
    u->trouble = LIBUSB_ERROR_NOT_FOUND;
    u->port->there = false;
}

static void usb_take(struct usb *u, struct usb_transfer *t, uint8_t endpoint, int size, libusb_transfer_cb_fn callback)
{
    t->transfer = libusb_alloc_transfer(0);
    if (t->transfer)
        libusb_fill_bulk_transfer(t->transfer, u->device.handle, endpoint, t->bytes, size, callback, t, 0);
    else
        u->leaving = true;
}

static void usb_arrive(struct usb *u, unsigned others)
{
    const struct usb_device *d = &u->device;
    for (unsigned i = 0; i < USB_IN; i++)
        usb_take(u, &u->in[i], d->in, USB_BYTES, usb_received);
    usb_take(u, &u->out, d->out, STREAM_HEADER, usb_sent);
    u->stalls = 0;
    bool any = !*u->serial;
    snprintf(u->serial, sizeof u->serial, "%s", d->serial);
    snprintf(u->name, sizeof u->name, "usb:%s", d->serial);
    if (others && any)
        fprintf(stderr, "%s: taken; there %s %u more, --list lists them and --serial chooses\n", u->name,
                others == 1 ? "is" : "are", others);
    u->told = LIBUSB_ERROR_NOT_FOUND;
    u->port->why = NULL;
    u->port->there = true;
    u->port->connections++;
}

static void usb_tell(struct usb *u)
{
    usb_find_tell(u->name, u->trouble);
    u->told = u->trouble;
    u->port->why = usb_find_reason(u->trouble);
}

/* By a context of its own each time: where no udev daemon runs, the library's list is as old as its context. */
static void usb_look(struct usb *u)
{
    unsigned others = 0;
    int before = u->trouble;
    if (u->context)
        libusb_exit(u->context);
    u->context = NULL;
    u->arrived = false;
    u->look = cli_clock() + USB_LOOK_MS;
    if ((u->trouble = libusb_init(&u->context)) != 0)
        u->context = NULL;
    if (u->context && libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG)) /* if not, looking now and then does as well */
        libusb_hotplug_register_callback(u->context, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED, LIBUSB_HOTPLUG_NO_FLAGS,
                                         USB_FIND_VENDOR, USB_FIND_PRODUCT, LIBUSB_HOTPLUG_MATCH_ANY, usb_plugged, u,
                                         NULL);
    if (u->context)
        u->trouble = usb_find(u->context, *u->serial ? u->serial : NULL, &u->device, &others);
    if (u->trouble == 0) {
        usb_arrive(u, others);
    } else if (u->trouble == LIBUSB_ERROR_NOT_FOUND) {
        u->told = u->trouble;
        u->port->why = NULL;
    } else if (u->trouble == before && u->trouble != u->told) {
        usb_tell(u); /* at the second look: a device that has just come may get its rights a moment later */
    }
}

/* What there is to do now: true if a device came or went. Nothing of the one before is left when one has come. */
static bool usb_step(struct usb *u)
{
    bool there = u->port->there;
    unsigned connections = u->port->connections;
    if (u->device.handle && !u->leaving) {
        usb_cancel(u, u->in_stalled, false);
        usb_clear(u);
        usb_fill(u);
    }
    if (u->device.handle && u->leaving) {
        usb_cancel(u, true, true);
        if (usb_flying(u) == 0 && !u->out.flying)
            usb_leave(u);
    }
    if (!u->device.handle && u->received.count == 0 && (u->arrived || cli_clock() >= u->look))
        usb_look(u);
    return u->port->there != there || u->port->connections != connections;
}

/* Callbacks are called in here alone. */
static int usb_events(struct usb *u, double wait_ms)
{
    struct timeval wait = {.tv_sec = (time_t)(wait_ms / 1000.)};
    wait.tv_usec = (suseconds_t)((wait_ms - 1000. * (double)wait.tv_sec) * 1000.);
    if (u->context)
        return libusb_handle_events_timeout_completed(u->context, &wait, NULL);
    poll(NULL, 0, (int)wait_ms);
    return 0;
}

static long usb_read(struct port *port, void *bytes, size_t size, int wait_ms)
{
    struct usb *u = port->usb;
    double end = cli_clock() + wait_ms;
    for (;;) {
        bool changed = usb_step(u);
        size_t count = queue_take(&u->received, bytes, size);
        if (changed || count)
            return (long)count;
        double now = cli_clock(), until = u->device.handle || end < u->look ? end : u->look;
        int result = usb_events(u, until > now ? until - now : 0);
        if (result && result != LIBUSB_ERROR_INTERRUPTED) {
            fprintf(stderr, "%s: %s\n", u->name, libusb_strerror(result));
            return PORT_FAILED;
        }
        if (u->received.count == 0 && (result || cli_clock() >= end))
            return 0;
    }
}

static int usb_send(struct port *port, const uint8_t message[STREAM_HEADER])
{
    struct usb *u = port->usb;
    uint8_t old[STREAM_HEADER];
    if (!port->there)
        return CLI_DONE;
    if (queue_free(&u->requests) < STREAM_HEADER)
        queue_take(&u->requests, old, sizeof old);
    queue_put(&u->requests, message, STREAM_HEADER);
    if (!u->leaving)
        usb_fill(u);
    return CLI_DONE;
}

static void usb_missing(struct port *port)
{
    struct usb *u = port->usb;
    if (port->there)
        fprintf(stderr, "%s: no answer\n", u->name);
    else if (u->trouble != u->told || u->trouble == LIBUSB_ERROR_NOT_FOUND)
        usb_tell(u);
}

static void usb_close(struct port *port)
{
    struct usb *u = port->usb;
    double end = cli_clock() + USB_END_MS;
    u->leaving = true;
    while (u->device.handle && (usb_flying(u) || u->out.flying)) {
        usb_cancel(u, true, true);
        if (cli_clock() > end)
            return; /* the library may yet write to them: they are left to it */
        if (usb_events(u, 10))
            poll(NULL, 0, 1);
    }
    if (u->device.handle)
        usb_leave(u);
    if (u->context)
        libusb_exit(u->context);
    free(u);
}

int usb_open(struct port *port, const char *serial)
{
    static const struct port_ops ops = {usb_read, usb_send, usb_missing, usb_close};
    struct usb *u = calloc(1, sizeof *u);
    if (!u) {
        fprintf(stderr, "usb: out of memory\n");
        return CLI_IO;
    }
    u->out = (struct usb_transfer){.usb = u, .bytes = u->out_bytes};
    for (unsigned i = 0; i < USB_IN; i++)
        u->in[i] = (struct usb_transfer){.usb = u, .bytes = u->in_bytes[i]};
    u->port = port;
    u->received = (struct queue){.bytes = u->received_bytes, .room = sizeof u->received_bytes};
    u->requests = (struct queue){.bytes = u->request_bytes, .room = sizeof u->request_bytes};
    u->trouble = u->told = LIBUSB_ERROR_NOT_FOUND;
    snprintf(u->serial, sizeof u->serial, "%s", serial ? serial : "");
    snprintf(u->name, sizeof u->name, serial ? "usb:%s" : "usb", u->serial);
    *port = (struct port){.ops = &ops, .usb = u, .name = u->name, .asks = true};
    usb_look(u);
    return CLI_DONE;
}
#endif
