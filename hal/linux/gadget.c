/* SPDX-License-Identifier: MIT */
#include "linux/gadget.h"
#include "display.h"
#include "linux/files.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#define GADGET_CONFIGFS "/sys/kernel/config"
#define GADGET_ALL      GADGET_CONFIGFS "/usb_gadget"
#define GADGET          GADGET_ALL "/glint"
#define GADGET_UDC      GADGET "/UDC"
#define GADGET_UDCS     "/sys/class/udc"
#define GADGET_FUNCTION GADGET "/functions/ffs.glint"
#define GADGET_SOURCE   "glint" /* what stands behind ffs. */

/* What it consists of, in the order in which it is made; taken away backwards. Windows learns from os_desc that it is
 * to ask for the function's own descriptors (ffs.c), by the vendor's request 47. */
static const struct gadget_part {
    enum { GADGET_FOLDER, GADGET_TEXT, GADGET_LINK, GADGET_PRODUCT, GADGET_SERIAL, GADGET_MOUNT } kind;
    const char *path, *text;
} gadget_parts[] = {
    {GADGET_FOLDER, GADGET, NULL},
    {GADGET_TEXT, GADGET "/idVendor", "0x1209"}, /* pid.codes: for tests */
    {GADGET_TEXT, GADGET "/idProduct", "0x0001"},
    {GADGET_TEXT, GADGET "/bcdDevice", "0x0100"},
    {GADGET_FOLDER, GADGET "/strings/0x409", NULL},
    {GADGET_TEXT, GADGET "/strings/0x409/manufacturer", "Glint"},
    {GADGET_PRODUCT, GADGET "/strings/0x409/product", NULL},
    {GADGET_SERIAL, GADGET "/strings/0x409/serialnumber", NULL},
    {GADGET_FOLDER, GADGET "/configs/c.1", NULL},
    {GADGET_TEXT, GADGET "/configs/c.1/MaxPower", "500"}, /* mA: a Pi Zero and a panel */
    {GADGET_TEXT, GADGET "/os_desc/b_vendor_code", "0x47"},
    {GADGET_TEXT, GADGET "/os_desc/qw_sign", "MSFT100"},
    {GADGET_TEXT, GADGET "/os_desc/use", "1"},
    {GADGET_FOLDER, GADGET_FUNCTION, NULL},
    {GADGET_LINK, GADGET "/configs/c.1/ffs.glint", GADGET_FUNCTION},
    {GADGET_LINK, GADGET "/os_desc/c.1", GADGET "/configs/c.1"},
    {GADGET_FOLDER, GADGET_FILES, NULL},
    {GADGET_MOUNT, GADGET_FILES, GADGET_SOURCE},
};
#define GADGET_PARTS (sizeof gadget_parts / sizeof *gadget_parts)

static int gadget_make(const struct gadget_part *part, const struct gadget_config *config)
{
    switch (part->kind) {
    case GADGET_FOLDER:
        return files_make_folder(part->path);
    case GADGET_LINK:
        return files_link(part->text, part->path);
    case GADGET_MOUNT:
        return files_mount(part->text, part->path, "functionfs");
    default:
        return files_put(part->path, part->kind == GADGET_PRODUCT  ? config->product
                                     : part->kind == GADGET_SERIAL ? config->serial
                                                                   : part->text);
    }
}

/* What is not there need not be removed. */
static void gadget_remove(const struct gadget_part *part)
{
    if (part->kind == GADGET_FOLDER)
        files_remove_folder(part->path);
    else if (part->kind == GADGET_LINK)
        files_unlink(part->path);
    else if (part->kind == GADGET_MOUNT)
        files_unmount(part->path);
}

static int gadget_no(struct problem *problem, const char *path, int reason)
{
    const char *hint = reason == -EACCES || reason == -EPERM ? "; it wants root" : "";
    return problem_set(problem, "%s: %s%s", path, strerror(-reason), hint);
}

/* The controller that is asked for, or the first. */
static int gadget_find(struct gadget *gadget, const char *udc, struct problem *problem)
{
    char path[sizeof GADGET_UDCS + GADGET_NAME + 8], state[GADGET_NAME];
    if (files_first(GADGET_UDCS, gadget->udc, sizeof gadget->udc) != 0)
        return problem_set(problem, "no USB device controller; is dtoverlay=dwc2 in config.txt?");
    if (!udc)
        return 0;
    snprintf(path, sizeof path, "%s/%s/state", GADGET_UDCS, udc);
    if (strlen(udc) >= sizeof gadget->udc || files_get(path, state, sizeof state) != 0)
        return problem_set(problem, "no USB device controller '%s'; there is '%s'", udc, gadget->udc);
    snprintf(gadget->udc, sizeof gadget->udc, "%s", udc);
    return 0;
}

/* Takes away what a crash left, plugged in by nobody. */
static int gadget_clear(struct problem *problem)
{
    char holder[GADGET_NAME];
    if (files_get(GADGET_UDC, holder, sizeof holder) == 0 && holder[0])
        return problem_set(problem, "another glint-device streams over USB already, by '%s'", holder);
    for (unsigned i = GADGET_PARTS; i > 0; i--)
        gadget_remove(&gadget_parts[i - 1]);
    return 0;
}

/* The folder in which the kernel puts all others. */
static int gadget_begin(struct problem *problem)
{
    int result = files_make_folder(GADGET);
    if (result == -ENOENT) {
        result = files_mount("config", GADGET_CONFIGFS, "configfs");
        if (result == -EPERM)
            return gadget_no(problem, GADGET_CONFIGFS, result);
        result = files_make_folder(GADGET);
    }
    if (result == -ENOENT)
        return problem_set(problem, "the kernel makes no USB devices: is libcomposite loaded (modprobe libcomposite)?");
    return result ? gadget_no(problem, GADGET, result) : 0;
}

int gadget_open(struct gadget *gadget, const struct gadget_config *config, struct problem *problem)
{
    *gadget = (struct gadget){.made = 0};
    int error = gadget_find(gadget, config->udc, problem);
    if (!error)
        error = gadget_clear(problem);
    if (!error)
        error = gadget_begin(problem);
    if (error)
        return error;
    for (gadget->made = 1; gadget->made < GADGET_PARTS; gadget->made++) {
        const struct gadget_part *part = &gadget_parts[gadget->made];
        int result = gadget_make(part, config);
        if (result) {
            gadget_no(problem, part->path, result);
            gadget_close(gadget);
            return HAL_E_IO;
        }
    }
    return 0;
}

int gadget_plug(struct gadget *gadget, struct problem *problem)
{
    int result = files_put(GADGET_UDC, gadget->udc);
    if (result == -EBUSY)
        return problem_set(problem, "the USB device controller '%s' is taken by another gadget", gadget->udc);
    return result ? gadget_no(problem, GADGET_UDC, result) : 0;
}

void gadget_unplug(struct gadget *gadget)
{
    /* twice: who waits for a host is woken by nothing else */
    if (gadget->made && files_put(GADGET_UDC, "\n") != 0)
        files_put(GADGET_UDC, "\n");
}

void gadget_close(struct gadget *gadget)
{
    while (gadget->made > 0)
        gadget_remove(&gadget_parts[--gadget->made]);
}
