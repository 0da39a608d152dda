/* SPDX-License-Identifier: MIT */
#ifdef HAVE_LIBUSB
#include "view/usb_find.h"

#include "glint/cli.h"

#include <stdio.h>
#include <string.h>

#define USB_FIND_SUBCLASS 'G'
#define USB_FIND_PROTOCOL 1
#define USB_FIND_DEPTH    7 /* hubs */

static const char usb_find_maker[] = "Glint";

/* Text from a device, to be printed: what a terminal would obey is a question mark. */
static bool usb_find_text(libusb_device_handle *handle, uint8_t index, char text[USB_FIND_TEXT])
{
    int count = index ? libusb_get_string_descriptor_ascii(handle, index, (unsigned char *)text, USB_FIND_TEXT - 1) : 0;
    if (count < 0)
        return false;
    text[count] = 0;
    for (char *at = text; *at; at++)
        if (*at < 0x20 || *at > 0x7E)
            *at = '?';
    return true;
}

static bool usb_find_endpoints(const struct libusb_interface_descriptor *i, struct usb_device *d)
{
    d->interface = i->bInterfaceNumber;
    d->in = d->out = 0;
    for (const struct libusb_endpoint_descriptor *e = i->endpoint; e != i->endpoint + i->bNumEndpoints; e++) {
        if ((e->bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != LIBUSB_TRANSFER_TYPE_BULK)
            continue;
        *(e->bEndpointAddress & LIBUSB_ENDPOINT_IN ? &d->in : &d->out) = e->bEndpointAddress;
    }
    return d->in && d->out;
}

/* What can be seen from outside: the numbers, and an interface of the stream's. */
static bool usb_find_interface(libusb_device *device, const struct libusb_device_descriptor *about,
                               struct usb_device *d)
{
    struct libusb_config_descriptor *config;
    bool found = false;
    if (about->idVendor != USB_FIND_VENDOR || about->idProduct != USB_FIND_PRODUCT ||
        libusb_get_active_config_descriptor(device, &config) != 0)
        return false;
    for (int i = 0; i < config->bNumInterfaces && !found; i++) {
        const struct libusb_interface *all = &config->interface[i];
        found = all->num_altsetting && all->altsetting->bInterfaceClass == LIBUSB_CLASS_VENDOR_SPEC &&
                all->altsetting->bInterfaceSubClass == USB_FIND_SUBCLASS &&
                all->altsetting->bInterfaceProtocol == USB_FIND_PROTOCOL && usb_find_endpoints(all->altsetting, d);
    }
    libusb_free_config_descriptor(config);
    return found;
}

static void usb_find_close(struct usb_device *d)
{
    libusb_close(d->handle);
    d->handle = NULL;
}

/* 0: it is one, and open. */
static int usb_find_open(libusb_device *device, struct usb_device *d)
{
    struct libusb_device_descriptor about;
    char maker[USB_FIND_TEXT];
    *d = (struct usb_device){0};
    if (libusb_get_device_descriptor(device, &about) != 0 || !usb_find_interface(device, &about, d))
        return LIBUSB_ERROR_NOT_FOUND;
    int result = libusb_open(device, &d->handle);
    if (result) {
        d->handle = NULL;
        return result == LIBUSB_ERROR_NO_DEVICE ? LIBUSB_ERROR_NOT_FOUND : result;
    }
    if (usb_find_text(d->handle, about.iManufacturer, maker) && strcmp(maker, usb_find_maker) == 0 &&
        usb_find_text(d->handle, about.iProduct, d->product) &&
        usb_find_text(d->handle, about.iSerialNumber, d->serial))
        return 0;
    usb_find_close(d);
    return LIBUSB_ERROR_NOT_FOUND;
}

/* 0: it is the one that is wanted, and claimed. */
static int usb_find_claim(libusb_device *device, const char *serial, struct usb_device *d)
{
    int result = usb_find_open(device, d);
    if (result)
        return result;
    result = serial && strcmp(serial, d->serial) != 0 ? LIBUSB_ERROR_NOT_FOUND
                                                      : libusb_claim_interface(d->handle, d->interface);
    if (result)
        usb_find_close(d);
    return result == LIBUSB_ERROR_NO_DEVICE ? LIBUSB_ERROR_NOT_FOUND : result;
}

int usb_find(libusb_context *context, const char *serial, struct usb_device *found, unsigned *others)
{
    libusb_device **list;
    struct usb_device d;
    ssize_t count = libusb_get_device_list(context, &list);
    int result = LIBUSB_ERROR_NOT_FOUND;
    *others = 0;
    if (count < 0)
        return (int)count;
    for (ssize_t i = 0; i < count; i++) {
        bool have = result == 0; /* then the rest is only counted */
        int one = have ? usb_find_open(list[i], &d) : usb_find_claim(list[i], serial, &d);
        if (have && one == 0)
            usb_find_close(&d);
        *others += (have && one == 0) || one == LIBUSB_ERROR_BUSY;
        if (have || one == LIBUSB_ERROR_NOT_FOUND)
            continue;
        result = one;
        *found = d;
    }
    libusb_free_device_list(list, 1);
    return result;
}

void usb_find_release(struct usb_device *device)
{
    libusb_release_interface(device->handle, device->interface);
    usb_find_close(device);
}

const char *usb_find_reason(int result)
{
    switch (result) {
    case LIBUSB_ERROR_NOT_FOUND:
        return "no device";
    case LIBUSB_ERROR_ACCESS:
        return "access denied";
    case LIBUSB_ERROR_BUSY:
        return "in use by another program";
    default:
        return libusb_strerror(result);
    }
}

void usb_find_tell(const char *name, int result)
{
    fprintf(stderr, "%s: %s%s\n", name, usb_find_reason(result),
            result != LIBUSB_ERROR_ACCESS
                ? ""
                : "; 'sudo cp host-tools/view/70-glint.rules /etc/udev/rules.d/', then plug it in again");
}

static const char *usb_find_speed(libusb_device *device)
{
    switch (libusb_get_device_speed(device)) {
    case LIBUSB_SPEED_LOW:
        return "1.5 Mbit/s";
    case LIBUSB_SPEED_FULL:
        return "12 Mbit/s";
    case LIBUSB_SPEED_HIGH:
        return "480 Mbit/s";
    case LIBUSB_SPEED_SUPER:
        return "5 Gbit/s";
    case LIBUSB_SPEED_SUPER_PLUS:
        return "10 Gbit/s";
    default:
        return "unknown speed";
    }
}

static void usb_find_print(libusb_device *device, const struct usb_device *d)
{
    uint8_t ports[USB_FIND_DEPTH];
    int count = libusb_get_port_numbers(device, ports, USB_FIND_DEPTH);
    printf("%s  %s  %s  %u", *d->serial ? d->serial : "-", d->product, usb_find_speed(device),
           libusb_get_bus_number(device));
    for (int i = 0; i < count; i++)
        printf(".%u", ports[i]);
    putchar('\n');
}

int usb_find_list(void)
{
    libusb_context *context;
    libusb_device **list;
    unsigned found = 0;
    int result = libusb_init(&context), problem = LIBUSB_ERROR_NOT_FOUND;
    if (result) {
        usb_find_tell("usb", result);
        return CLI_IO;
    }
    ssize_t count = libusb_get_device_list(context, &list);
    for (ssize_t i = 0; i < count; i++) {
        struct usb_device d;
        int one = usb_find_open(list[i], &d);
        if (one == 0) {
            found++;
            usb_find_print(list[i], &d);
            usb_find_close(&d);
        } else if (one != LIBUSB_ERROR_NOT_FOUND) {
            problem = one;
        }
    }
    if (count >= 0)
        libusb_free_device_list(list, 1);
    else
        problem = (int)count;
    libusb_exit(context);
    if (!found || problem != LIBUSB_ERROR_NOT_FOUND)
        usb_find_tell("usb", problem);
    return found ? CLI_DONE : CLI_IO;
}
#endif
