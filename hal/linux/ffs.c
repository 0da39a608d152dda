/* SPDX-License-Identifier: MIT */
#include "linux/ffs.h"
#include "display.h"
#include "linux/files.h"

#include <errno.h>
#include <linux/usb/functionfs.h>
#include <stdio.h>
#include <string.h>

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "descriptors are little-endian");

#define FFS_CLASS    0xFF /* a vendor's, */
#define FFS_SUBCLASS 0x47 /* of these */
#define FFS_PROTOCOL 0x01
#define FFS_GUID     "{2e6007df-4c73-46bb-bb7d-4247eb18c4c5}" /* of the interface, for programs of Windows */
#define FFS_GUID_KEY "DeviceInterfaceGUID"

struct ffs_function {
    struct usb_interface_descriptor interface;
    struct usb_endpoint_descriptor_no_audio in, out;
} __attribute__((packed));
struct ffs_super_function {
    struct usb_interface_descriptor interface;
    struct usb_endpoint_descriptor_no_audio in;
    struct usb_ss_ep_comp_descriptor in_beside;
    struct usb_endpoint_descriptor_no_audio out;
    struct usb_ss_ep_comp_descriptor out_beside;
} __attribute__((packed));

#define FFS_ENDPOINT(address, size)                                                                     \
    {                                                                                                   \
        .bLength = sizeof(struct usb_endpoint_descriptor_no_audio), .bDescriptorType = USB_DT_ENDPOINT, \
        .bEndpointAddress = (address), .bmAttributes = USB_ENDPOINT_XFER_BULK, .wMaxPacketSize = (size) \
    }
#define FFS_INTERFACE                                                                                         \
    {                                                                                                         \
        .bLength = USB_DT_INTERFACE_SIZE, .bDescriptorType = USB_DT_INTERFACE, .bNumEndpoints = 2,            \
        .bInterfaceClass = FFS_CLASS, .bInterfaceSubClass = FFS_SUBCLASS, .bInterfaceProtocol = FFS_PROTOCOL, \
        .iInterface = 1                                                                                       \
    }
#define FFS_FUNCTION(size)                                                                     \
    {                                                                                          \
        FFS_INTERFACE, FFS_ENDPOINT(USB_DIR_IN | 1, size), FFS_ENDPOINT(USB_DIR_OUT | 2, size) \
    }
#define FFS_BESIDE                                                                    \
    {                                                                                 \
        .bLength = USB_DT_SS_EP_COMP_SIZE, .bDescriptorType = USB_DT_SS_ENDPOINT_COMP \
    }

static const struct {
    struct usb_functionfs_descs_head_v2 head;
    uint32_t full_speed_count, high_speed_count, super_speed_count, os_count;
    struct ffs_function full_speed, high_speed;
    struct ffs_super_function super_speed;
    struct {
        struct usb_os_desc_header head;
        struct usb_ext_compat_desc id;
    } __attribute__((packed)) compatible;
    struct {
        struct usb_os_desc_header head;
        struct usb_ext_prop_desc property;
        char key[sizeof FFS_GUID_KEY];
        uint32_t length;
        char value[sizeof FFS_GUID];
    } __attribute__((packed)) properties;
} __attribute__((packed)) ffs_descriptors = {
    .head = {.magic = FUNCTIONFS_DESCRIPTORS_MAGIC_V2,
             .length = sizeof ffs_descriptors,
             .flags =
                 FUNCTIONFS_HAS_FS_DESC | FUNCTIONFS_HAS_HS_DESC | FUNCTIONFS_HAS_SS_DESC | FUNCTIONFS_HAS_MS_OS_DESC},
    .full_speed_count = 3,
    .high_speed_count = 3,
    .super_speed_count = 5, /* without them a controller that is faster has no configuration */
    .os_count = 2,
    .full_speed = FFS_FUNCTION(64),
    .high_speed = FFS_FUNCTION(512),
    .super_speed = {FFS_INTERFACE, FFS_ENDPOINT(USB_DIR_IN | 1, 1024), FFS_BESIDE, FFS_ENDPOINT(USB_DIR_OUT | 2, 1024),
                    FFS_BESIDE},
    .compatible = {{.dwLength = sizeof ffs_descriptors.compatible, .bcdVersion = 1, .wIndex = 4, .bCount = 1},
                   {.Reserved1 = 1, .CompatibleID = "WINUSB"}},
    .properties = {{.dwLength = sizeof ffs_descriptors.properties, .bcdVersion = 1, .wIndex = 5, .wCount = 1},
                   {.dwSize = sizeof ffs_descriptors.properties - sizeof(struct usb_os_desc_header),
                    .dwPropertyDataType = 1, /* a string; the kernel makes it UTF-16 */
                    .wPropertyNameLength = sizeof FFS_GUID_KEY},
                   FFS_GUID_KEY,
                   sizeof FFS_GUID,
                   FFS_GUID},
};

static const struct {
    struct usb_functionfs_strings_head head;
    uint16_t language;
    char text[sizeof "Glint stream"];
} __attribute__((packed)) ffs_strings = {
    .head = {.magic = FUNCTIONFS_STRINGS_MAGIC, .length = sizeof ffs_strings, .str_count = 1, .lang_count = 1},
    .language = 0x0409,
    .text = "Glint stream",
};

static int ffs_take(const char *folder, const char *name, int waits, int *descriptor)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    *descriptor = files_open(path, waits);
    return *descriptor < 0 ? *descriptor : 0;
}

static int ffs_tell(int control, const void *bytes, size_t size)
{
    long count = files_write(control, bytes, size);
    return count < 0 ? (int)count : 0;
}

int ffs_open(struct ffs *ffs, const char *folder, struct problem *problem)
{
    *ffs = (struct ffs){-1, -1, -1, -1};
    int result = ffs_take(folder, "ep0", 1, &ffs->control);
    if (!result)
        result = ffs_tell(ffs->control, &ffs_descriptors, sizeof ffs_descriptors);
    if (!result)
        result = ffs_tell(ffs->control, &ffs_strings, sizeof ffs_strings);
    if (!result)
        result = ffs_take(folder, "ep1", 0, &ffs->in);
    if (!result)
        result = ffs_take(folder, "ep2", 0, &ffs->out);
    if (!result)
        result = (ffs->stop = files_event()) < 0 ? ffs->stop : 0;
    if (!result)
        return 0;
    ffs_close(ffs);
    return problem_set(problem, "the USB function in %s: %s", folder, strerror(-result));
}

/* Refuses a request, by an answer in the wrong direction. */
static void ffs_stall(struct ffs *ffs, const struct usb_ctrlrequest *setup)
{
    if (setup->bRequestType & USB_DIR_IN)
        files_read(ffs->control, NULL, 0);
    else
        files_write(ffs->control, NULL, 0);
}

enum ffs_event ffs_next(struct ffs *ffs)
{
    struct usb_functionfs_event event;
    int there = files_wait(ffs->control, ffs->stop);
    if (there <= 0)
        return there ? FFS_BROKEN : FFS_STOPPED;
    long count = files_read(ffs->control, &event, sizeof event);
    if (count != (long)sizeof event)
        return count == -EAGAIN || count == -EINTR || count == -EIDRM ? FFS_NOTHING : FFS_BROKEN;
    switch (event.type) {
    case FUNCTIONFS_ENABLE:
        return FFS_COMES;
    case FUNCTIONFS_DISABLE:
    case FUNCTIONFS_UNBIND:
        return FFS_GOES;
    case FUNCTIONFS_SETUP:
        ffs_stall(ffs, &event.u.setup);
        return FFS_NOTHING;
    default: /* bound, suspended, resumed */
        return FFS_NOTHING;
    }
}

void ffs_stop(struct ffs *ffs)
{
    files_raise(ffs->stop);
}

long ffs_send(struct ffs *ffs, const void *bytes, uint32_t count)
{
    return files_write(ffs->in, bytes, count);
}

long ffs_receive(struct ffs *ffs, void *bytes, uint32_t count)
{
    return files_read(ffs->out, bytes, count);
}

static void ffs_drop(int *descriptor)
{
    if (*descriptor >= 0)
        files_close(*descriptor);
    *descriptor = -1;
}

void ffs_close(struct ffs *ffs)
{
    ffs_drop(&ffs->stop);
    ffs_drop(&ffs->out);
    ffs_drop(&ffs->in);
    ffs_drop(&ffs->control);
}
