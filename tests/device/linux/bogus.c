/* SPDX-License-Identifier: MIT */
/*
 * bogus describe                  what the device says of itself, Microsoft's descriptors among it
 * bogus requests SEED COUNT       control requests that no driver would send, and every descriptor at every length; the
 *                                 interface may be somebody else's
 * bogus seize SEED COUNT          the same with the interface its own: class and standard requests to interface and
 * endpoints, too; bytes that are no requests on bulk OUT; both endpoints halted at the end bogus ask TYPE VALUE MS a
 * request of the stream's protocol, and then to stay for so long
 *
 * A guest's program, against the one device of Glint's. A request has to be answered or refused, not left alone. Exit
 * code: 0 done, 1 one was left alone, 2 bad usage, 3 no such device, or it went away.
 */
#include "stream/protocol.h"
#include "view/port.h"

#include <libusb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define VENDOR     0x1209
#define PRODUCT    0x0001
#define IN         0x81
#define OUT        0x01
#define WAIT_MS    2000
#define MOST       4096 /* bytes of a control request that the kernel lets through */
#define GARBAGE    400  /* transfers */
#define TRANSFER   16384
#define CODE(type) ((unsigned)(type)&LIBUSB_ENDPOINT_DIR_MASK ? "in" : "out")

static libusb_device_handle *device;
static uint8_t out_endpoint = OUT;
static uint8_t bytes[TRANSFER];
static uint32_t state;
static unsigned answered, refused, alone;

static uint32_t draw(uint32_t below)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return (uint32_t)((uint64_t)state * below >> 32);
}

static uint16_t hostile(void)
{
    static const uint16_t values[] = {0,     1,     2,     4,     5,     7,      0x81,   0x80,   0xEE,
                                      0x100, 0x200, 0x300, 0x3EE, 0xF00, 0x7FFF, 0x8000, 0xFF00, 0xFFFF};
    return draw(2) ? values[draw(sizeof values / sizeof *values)] : (uint16_t)draw(65536);
}

static void away(int error)
{
    if (error != LIBUSB_ERROR_NO_DEVICE)
        return;
    printf("the device is gone\n");
    exit(3);
}

static int control(uint8_t type, uint8_t request, uint16_t value, uint16_t index, uint16_t length)
{
    int result = libusb_control_transfer(device, type, request, value, index, bytes, length, WAIT_MS);
    away(result);
    if (result == LIBUSB_ERROR_TIMEOUT) {
        alone++;
        printf("left alone: type %02x request %02x value %04x index %04x length %u\n", type, request, value, index,
               length);
    } else if (result >= 0) {
        answered++;
    } else {
        refused++;
    }
    return result;
}

static uint8_t field(void)
{
    return (uint8_t)(draw(2) ? draw(13) : draw(256));
}

/* What would take the device from under its drivers is a good host's to say: its address, its configuration. */
static int sane(uint8_t type, uint8_t request)
{
    return (type & 0x60) != LIBUSB_REQUEST_TYPE_STANDARD ||
           (request != LIBUSB_REQUEST_SET_ADDRESS && request != LIBUSB_REQUEST_SET_CONFIGURATION);
}

/* The kernel lets nobody ask an interface or its endpoints who has not claimed it, but for a vendor's requests. */
static int allowed(uint8_t type, int own)
{
    return own || (type & 0x60) == LIBUSB_REQUEST_TYPE_VENDOR || (type & 0x1F) == LIBUSB_RECIPIENT_DEVICE ||
           (type & 0x1F) > LIBUSB_RECIPIENT_ENDPOINT;
}

static void requests(unsigned count, int own)
{
    for (unsigned i = 0; i < count;) {
        uint8_t type = (uint8_t)(draw(2) << 7 | draw(4) << 5 | (draw(8) ? draw(4) : draw(32))), request = field();
        if (!sane(type, request) || !allowed(type, own))
            continue;
        for (unsigned k = 0; k < 64; k++)
            bytes[k] = (uint8_t)draw(256);
        control(type, request, hostile(), hostile(), (uint16_t)(draw(4) ? draw(65) : draw(MOST + 1)));
        i++;
    }
}

/* Every type, and every length up to where a step over some does as well. */
static void descriptors(void)
{
    static const uint8_t places[] = {0, 1, 3, 0xEE};
    for (unsigned type = 0; type < 256; type++)
        for (unsigned i = 0; i < (type < 24 ? sizeof places : 1); i++) {
            uint16_t most = (uint16_t)(draw(2) ? MOST : draw(40));
            int got = control(LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR, (uint16_t)(type << 8 | places[i]),
                              0x409, most);
            if (got > most)
                printf("more than asked for: type %u, %d of %u\n", type, got, most);
        }
    for (unsigned length = 0; length <= MOST; length += length < 80 ? 1 : 251)
        for (unsigned type = 1; type <= 7; type += type < 3 ? 1 : 3)
            control(LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR, (uint16_t)(type << 8), 0, (uint16_t)length);
}

static void standard(void)
{
    static const uint16_t ends[] = {0x00, 0x80, 0x01, 0x81, 0x02, 0x82, 0x0F, 0x8F, 0x7F, 0xFF, 0x181, 0xFFFF};
    control(LIBUSB_RECIPIENT_INTERFACE, LIBUSB_REQUEST_SET_INTERFACE, 7, 0, 0);
    control(LIBUSB_RECIPIENT_INTERFACE, LIBUSB_REQUEST_SET_INTERFACE, 0, 7, 0);
    control(LIBUSB_RECIPIENT_INTERFACE, LIBUSB_REQUEST_SET_INTERFACE, 0, 0, 0);
    control(LIBUSB_RECIPIENT_DEVICE, LIBUSB_REQUEST_SET_CONFIGURATION, 7, 0, 0);
    for (unsigned i = 0; i < sizeof ends / sizeof *ends; i++)
        for (uint16_t feature = 0; feature < 3; feature++) {
            control(LIBUSB_RECIPIENT_ENDPOINT, LIBUSB_REQUEST_SET_FEATURE, feature, ends[i], 0);
            control(LIBUSB_RECIPIENT_ENDPOINT, LIBUSB_REQUEST_CLEAR_FEATURE, feature, ends[i], 0);
            control(LIBUSB_ENDPOINT_IN | LIBUSB_RECIPIENT_ENDPOINT, LIBUSB_REQUEST_GET_STATUS, feature, ends[i], 2);
        }
}

/* Bytes, pieces of requests, and requests with a bit turned; no whole one, which would be obeyed. */
static void garbage(void)
{
    unsigned long taken = 0;
    for (unsigned i = 0; i < GARBAGE; i++) {
        uint32_t length = draw(4) ? draw(600) : draw(TRANSFER + 1);
        for (uint32_t k = 0; k < length; k++)
            bytes[k] = (uint8_t)draw(256);
        for (uint32_t k = 0; k + STREAM_HEADER <= length; k += STREAM_HEADER / 2 + draw(400)) {
            uint8_t message[STREAM_HEADER];
            port_message(message, (enum stream_type)(STREAM_KEY_PLEASE + draw(8)), draw(256), (uint16_t)i);
            message[draw(STREAM_HEADER)] ^= (uint8_t)(1u << draw(8));
            memcpy(bytes + k, message, STREAM_HEADER);
        }
        int done = 0, result = libusb_bulk_transfer(device, out_endpoint, bytes, (int)length, &done, WAIT_MS);
        away(result);
        if (result == LIBUSB_ERROR_TIMEOUT) {
            alone++;
            printf("left alone: %d of %u bytes taken\n", done, (unsigned)length);
        }
        taken += (unsigned long)done;
    }
    printf("%lu bytes of no sense taken\n", taken);
}

static void text(const char *name, uint8_t place)
{
    int length = place ? libusb_get_string_descriptor_ascii(device, place, bytes, sizeof bytes) : 0;
    printf("%s %.*s\n", name, length > 0 ? length : 0, (const char *)bytes);
}

static void microsoft(void)
{
    int length = control(LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR, 0x3EE, 0, 18);
    uint8_t vendor = bytes[16];
    printf("string ee %d bytes ", length);
    for (int i = 2; i < 16 && i < length; i += 2)
        putchar(bytes[i]);
    length = control(LIBUSB_ENDPOINT_IN | LIBUSB_REQUEST_TYPE_VENDOR, vendor, 0, 4, 64);
    printf("\ncompatible %d bytes, version %02x%02x, functions %u, interface %u, %.8s\n", length, bytes[5], bytes[4],
           bytes[8], bytes[16], (const char *)bytes + 18);
    memset(bytes, 0, 512);
    length = control(LIBUSB_ENDPOINT_IN | LIBUSB_REQUEST_TYPE_VENDOR | LIBUSB_RECIPIENT_INTERFACE, vendor, 0, 5, 512);
    printf("properties %d bytes ", length);
    for (int i = 10; i < length; i++)
        if (bytes[i] >= ' ' && bytes[i] < 127)
            putchar(bytes[i]);
    putchar('\n');
}

static void describe(void)
{
    struct libusb_device_descriptor d;
    struct libusb_config_descriptor *c = NULL;
    if (libusb_get_device_descriptor(libusb_get_device(device), &d) != 0 ||
        libusb_get_active_config_descriptor(libusb_get_device(device), &c) != 0)
        exit(3);
    printf("device %04x:%04x usb %04x speed %d\n", d.idVendor, d.idProduct, d.bcdUSB,
           libusb_get_device_speed(libusb_get_device(device)));
    text("manufacturer", d.iManufacturer);
    text("product", d.iProduct);
    text("serial", d.iSerialNumber);
    for (unsigned i = 0; i < c->bNumInterfaces; i++) {
        const struct libusb_interface_descriptor *f = c->interface[i].altsetting;
        printf("interface %u class %02x subclass %02x protocol %02x\n", i, f->bInterfaceClass, f->bInterfaceSubClass,
               f->bInterfaceProtocol);
        for (unsigned e = 0; e < f->bNumEndpoints; e++)
            printf("endpoint %s %02x %s packet %u\n", CODE(f->endpoint[e].bEndpointAddress),
                   f->endpoint[e].bEndpointAddress,
                   (f->endpoint[e].bmAttributes & 3) == LIBUSB_TRANSFER_TYPE_BULK ? "bulk" : "other",
                   f->endpoint[e].wMaxPacketSize);
    }
    libusb_free_config_descriptor(c);
    microsoft();
}

/* Bulk OUT is where the device says. */
static void find_out(void)
{
    struct libusb_config_descriptor *c = NULL;
    if (libusb_get_active_config_descriptor(libusb_get_device(device), &c) != 0)
        return;
    const struct libusb_interface_descriptor *f = c->interface[0].altsetting;
    for (unsigned e = 0; e < f->bNumEndpoints; e++)
        if (!(f->endpoint[e].bEndpointAddress & LIBUSB_ENDPOINT_IN))
            out_endpoint = f->endpoint[e].bEndpointAddress;
    libusb_free_config_descriptor(c);
}

static void seize(unsigned count)
{
    standard();
    descriptors();
    requests(count, 1);
    libusb_clear_halt(device, out_endpoint);
    libusb_clear_halt(device, IN);
    garbage();
    control(LIBUSB_RECIPIENT_ENDPOINT, LIBUSB_REQUEST_SET_FEATURE, 0, IN, 0);
    control(LIBUSB_RECIPIENT_ENDPOINT, LIBUSB_REQUEST_SET_FEATURE, 0, out_endpoint, 0);
}

static int ask(char **words)
{
    uint8_t message[STREAM_HEADER];
    int done = 0;
    port_message(message, (enum stream_type)strtoul(words[0], NULL, 16), (uint32_t)strtoul(words[1], NULL, 0), 1);
    int result = libusb_bulk_transfer(device, out_endpoint, message, sizeof message, &done, WAIT_MS);
    away(result);
    for (unsigned long left = strtoul(words[2], NULL, 0);
         left > 0 && result == 0;) { /* a host that is there also reads */
        unsigned long piece = left < 10 ? left : 10;
        int got = 0;
        libusb_bulk_transfer(device, IN, bytes, sizeof bytes, &got, (unsigned)piece);
        left -= piece;
    }
    return result == 0 ? 0 : 3;
}

int main(int argc, char **argv)
{
    int asks = argc == 5 && strcmp(argv[1], "ask") == 0, seizes = argc == 4 && strcmp(argv[1], "seize") == 0;
    int asked = argc == 4 && strcmp(argv[1], "requests") == 0,
        described = argc == 2 && strcmp(argv[1], "describe") == 0;
    if (!asks && !seizes && !asked && !described)
        return 2;
    if (libusb_init(NULL) != 0 || !(device = libusb_open_device_with_vid_pid(NULL, VENDOR, PRODUCT))) {
        printf("no device\n");
        return 3;
    }
    if ((asks || seizes) && libusb_claim_interface(device, 0) != 0) {
        printf("the interface is somebody else's\n");
        return 3;
    }
    find_out();
    int code = asks ? ask(argv + 2) : 0;
    if (described)
        describe();
    if (asked || seizes) {
        state = (uint32_t)strtoul(argv[2], NULL, 0) | 1;
        unsigned count = (unsigned)strtoul(argv[3], NULL, 0);
        if (seizes) {
            seize(count);
        } else {
            descriptors();
            requests(count, 0);
        }
        printf("%u answered, %u refused, %u left alone\n", answered, refused, alone);
        code = alone != 0;
    }
    libusb_close(device);
    libusb_exit(NULL);
    return code;
}
