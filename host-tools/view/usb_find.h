/* SPDX-License-Identifier: MIT */
/* Which of the devices on USB are Glint's. These functions wait for the devices' answers: never from a callback. */
#ifndef VIEW_USB_FIND_H
#define VIEW_USB_FIND_H

#include <libusb.h>
#include <stdbool.h>
#include <stdint.h>

#define USB_FIND_VENDOR  0x1209
#define USB_FIND_PRODUCT 0x0001 /* for tests: the interface and the manufacturer's name decide */
#define USB_FIND_TEXT    128

struct usb_device {
    libusb_device_handle *handle; /* the interface claimed; or null */
    uint8_t interface, in, out;   /* its bulk endpoints */
    char serial[USB_FIND_TEXT], product[USB_FIND_TEXT];
};

/* The device of that serial number, or with null the first that is free. 0; LIBUSB_ERROR_NOT_FOUND: there is none;
 * LIBUSB_ERROR_ACCESS: there may be, but it may not be asked; LIBUSB_ERROR_BUSY: it is another program's, the serial
 * number is filled in; or whatever else the library says. `others`: how many more there are. */
int usb_find(libusb_context *context, const char *serial, struct usb_device *found, unsigned *others);

void usb_find_release(struct usb_device *device);

/* What usb_find() said, in a few words; and as a message, of `name`. */
const char *usb_find_reason(int result);
void usb_find_tell(const char *name, int result);

/* Prints a line for each: an exit code, with a message. */
int usb_find_list(void);

#endif
