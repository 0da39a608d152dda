/* SPDX-License-Identifier: MIT */
/*
 * A kernel that makes USB devices, and a host, in a test's hands: hal/linux/files.h on folders, files and mounts as
 * configfs and FunctionFS have them, refusing what these refuse. Each call is counted, and one of them, or all from
 * there on, can be made to fail.
 */
#ifndef GADGET_MACHINE_H
#define GADGET_MACHINE_H

#include "linux/files.h"
#include "tests/faults/seam.h"

#include <errno.h>
#include <linux/usb/functionfs.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define USB_UDC     "test.udc"
#define USB_CONFIG  "/sys/kernel/config"
#define USB_GADGETS USB_CONFIG "/usb_gadget"
#define USB_GADGET  USB_GADGETS "/glint"

enum { USB_NODES = 64, USB_EVENTS = 16, USB_CONTROL = 3, USB_IN, USB_OUT, USB_STOP, USB_HOST_BYTES = 1 << 20 };

struct usb_machine {
    pthread_mutex_t mutex;
    pthread_cond_t change;
    struct seam seam;
    int no_udc, no_composite, no_root; /* what this machine lacks */
    struct {
        char path[128], text[128];
        int folder, link;
    } node[USB_NODES];
    int nodes, configfs, functionfs; /* configfs, functionfs: how often mounted */
    char plugged[128];               /* the gadget's UDC */
    int open[USB_STOP + 1];
    uint8_t told[1024]; /* to ep0: descriptors, strings */
    size_t told_size;
    int tellings;
    struct usb_functionfs_event event[USB_EVENTS];
    int events, stopped, stalls_in, stalls_out;
    /* the host */
    int configured, reads;       /* configured: the number of this time, or 0; reads: what is sent is taken */
    int connections, interrupts; /* interrupts: so many transfers to the host end without having been */
    int takes, waits;            /* takes: so many go even if it does not read; waits: one does */
    uint8_t *got;                /* room for USB_HOST_BYTES */
    size_t got_size, last_size, transfers;
    uint8_t sends[8192]; /* on its way to the device */
    size_t sends_size;
};
static struct usb_machine usb_machine = {.mutex = PTHREAD_MUTEX_INITIALIZER, .change = PTHREAD_COND_INITIALIZER};

static void usb_lock(void)
{
    pthread_mutex_lock(&usb_machine.mutex);
}

static void usb_unlock(void)
{
    pthread_cond_broadcast(&usb_machine.change);
    pthread_mutex_unlock(&usb_machine.mutex);
}

static int usb_fails(void)
{
    return seam_fails(&usb_machine.seam);
}

/* --- the tree -------------------------------------------------------------------------------------------------------
 */

static int usb_find(const char *path)
{
    for (int i = 0; i < usb_machine.nodes; i++)
        if (strcmp(usb_machine.node[i].path, path) == 0)
            return i;
    return -1;
}

static int usb_under(const char *path, const char *folder)
{
    size_t length = strlen(folder);
    return strncmp(path, folder, length) == 0 && path[length] == '/';
}

/* The kernel's own folders are as good as there; so is what it makes within a gadget's. */
static int usb_is_folder(const char *path)
{
    static const char *const own[] = {"/dev", USB_GADGET "/strings", USB_GADGET "/functions", USB_GADGET "/configs",
                                      USB_GADGET "/os_desc"};
    if (strcmp(path, USB_GADGETS) == 0)
        return usb_machine.configfs && !usb_machine.no_composite;
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (strcmp(own[i], path) == 0)
            return i == 0 || usb_find(USB_GADGET) >= 0;
    return usb_find(path) >= 0 && usb_machine.node[usb_find(path)].folder;
}

static int usb_add(const char *path, const char *text, int folder, int link)
{
    char parent[128];
    snprintf(parent, sizeof parent, "%s", path);
    *strrchr(parent, '/') = 0;
    if (!usb_is_folder(parent))
        return -ENOENT;
    if (usb_find(path) >= 0 && (folder || link))
        return -EEXIST;
    int i = usb_find(path) >= 0 ? usb_find(path) : usb_machine.nodes++;
    snprintf(usb_machine.node[i].path, sizeof usb_machine.node[i].path, "%s", path);
    snprintf(usb_machine.node[i].text, sizeof usb_machine.node[i].text, "%s", text);
    usb_machine.node[i].folder = folder;
    usb_machine.node[i].link = link;
    return 0;
}

static void usb_delete(int i)
{
    usb_machine.node[i] = usb_machine.node[--usb_machine.nodes];
}

/* A folder goes with its attributes, not with folders and links; nor if a link leads to it, or it is in use. */
static int usb_busy(const char *path)
{
    for (int i = 0; i < usb_machine.nodes; i++) {
        const char *other = usb_machine.node[i].path;
        if (usb_under(other, path) && (usb_machine.node[i].folder || usb_machine.node[i].link))
            return 1;
        if (usb_machine.node[i].link && strcmp(usb_machine.node[i].text, path) == 0)
            return 1;
    }
    return (strcmp(path, USB_GADGET) == 0 && usb_machine.plugged[0]) ||
           (strcmp(path, "/dev/glint-usb") == 0 && usb_machine.functionfs);
}

int files_make_folder(const char *path)
{
    usb_lock();
    int result = usb_fails()           ? -usb_machine.seam.reason
                 : usb_machine.no_root ? (usb_machine.configfs ? -EACCES : -ENOENT)
                                       : usb_add(path, "", 1, 0);
    usb_unlock();
    return result;
}

int files_remove_folder(const char *path)
{
    usb_lock();
    int result = usb_fails() ? -usb_machine.seam.reason : usb_find(path) < 0 ? -ENOENT : usb_busy(path) ? -EBUSY : 0;
    for (int i = usb_machine.nodes; !result && i-- > 0;)
        if (usb_under(usb_machine.node[i].path, path) || strcmp(usb_machine.node[i].path, path) == 0)
            usb_delete(i);
    usb_unlock();
    return result;
}

int files_link(const char *target, const char *path)
{
    usb_lock();
    int result = usb_fails()              ? -usb_machine.seam.reason
                 : !usb_is_folder(target) ? -ENOENT
                                          : usb_add(path, target, 0, 1);
    usb_unlock();
    return result;
}

int files_unlink(const char *path)
{
    usb_lock();
    int result = usb_fails() ? -usb_machine.seam.reason : usb_find(path) < 0 ? -ENOENT : 0;
    if (!result)
        usb_delete(usb_find(path));
    usb_unlock();
    return result;
}

int files_mount(const char *source, const char *path, const char *type)
{
    char function[128];
    usb_lock();
    int *mounted = strcmp(type, "configfs") == 0 ? &usb_machine.configfs : &usb_machine.functionfs;
    snprintf(function, sizeof function, USB_GADGET "/functions/ffs.%s", source);
    int result = usb_fails() ? -usb_machine.seam.reason : usb_machine.no_root ? -EPERM : *mounted ? -EBUSY : 0;
    if (!result && mounted == &usb_machine.functionfs && (!usb_is_folder(function) || !usb_is_folder(path)))
        result = -ENODEV;
    *mounted += !result;
    usb_unlock();
    return result;
}

int files_unmount(const char *path)
{
    usb_lock();
    int used = usb_machine.open[USB_CONTROL] | usb_machine.open[USB_IN] | usb_machine.open[USB_OUT];
    int result = usb_fails()                                                      ? -usb_machine.seam.reason
                 : strcmp(path, "/dev/glint-usb") != 0 || !usb_machine.functionfs ? -EINVAL
                 : used                                                           ? -EBUSY
                                                                                  : 0;
    usb_machine.functionfs -= !result;
    usb_unlock();
    return result;
}

int files_first(const char *folder, char *name, size_t size)
{
    usb_lock();
    int result = usb_fails()                                              ? -usb_machine.seam.reason
                 : strcmp(folder, "/sys/class/udc") || usb_machine.no_udc ? -ENOENT
                                                                          : 0;
    snprintf(name, size, "%s", result ? "" : USB_UDC);
    usb_unlock();
    return result;
}

int files_get(const char *path, char *text, size_t size)
{
    usb_lock();
    int gadget = strcmp(path, USB_GADGET "/UDC") == 0 && usb_find(USB_GADGET) >= 0;
    int result = usb_fails()                                                       ? -usb_machine.seam.reason
                 : gadget || strcmp(path, "/sys/class/udc/" USB_UDC "/state") == 0 ? 0
                                                                                   : -ENOENT;
    snprintf(text, size, "%s", gadget ? usb_machine.plugged : "");
    usb_unlock();
    return result;
}

/* --- the bus --------------------------------------------------------------------------------------------------------
 */

/* The lock is held. */
static void usb_event(enum usb_functionfs_event_type type)
{
    if (usb_machine.events < USB_EVENTS)
        usb_machine.event[usb_machine.events++].type = (uint8_t)type;
}

static void usb_unplug_now(void)
{
    if (usb_machine.configured)
        usb_event(FUNCTIONFS_DISABLE);
    usb_event(FUNCTIONFS_UNBIND);
    usb_machine.configured = 0;
    usb_machine.plugged[0] = 0;
    usb_machine.sends_size = 0;
}

static int usb_plug(const char *name)
{
    if (strcmp(name, "\n") == 0) {
        if (!usb_machine.plugged[0])
            return -ENODEV;
        usb_unplug_now();
        return 0;
    }
    if (usb_find(USB_GADGET "/configs/c.1/ffs.glint") < 0 || usb_machine.tellings < 2 || !usb_machine.open[USB_CONTROL])
        return -ENODEV;
    snprintf(usb_machine.plugged, sizeof usb_machine.plugged, "%s", name);
    usb_event(FUNCTIONFS_BIND);
    return 0;
}

int files_put(const char *path, const char *text)
{
    usb_lock();
    int result = usb_fails()                            ? -usb_machine.seam.reason
                 : strcmp(path, USB_GADGET "/UDC") == 0 ? usb_plug(text)
                                                        : usb_add(path, text, 0, 0);
    usb_unlock();
    return result;
}

int files_open(const char *path, int waits)
{
    static const char *const names[] = {"/dev/glint-usb/ep0", "/dev/glint-usb/ep1", "/dev/glint-usb/ep2"};
    usb_lock();
    int result = usb_fails() ? -usb_machine.seam.reason : -ENOENT;
    for (int i = 0; result == -ENOENT && i < 3 && usb_machine.functionfs; i++)
        if (strcmp(path, names[i]) == 0 && (i == 0) == waits && (i == 0 || usb_machine.tellings == 2)) {
            result = USB_CONTROL + i;
            usb_machine.open[result]++;
        }
    usb_unlock();
    return result;
}

int files_event(void)
{
    usb_lock();
    int result = usb_fails() ? -usb_machine.seam.reason : USB_STOP;
    usb_machine.open[USB_STOP] += result == USB_STOP;
    usb_unlock();
    return result;
}

int files_raise(int event)
{
    usb_lock();
    usb_machine.stopped = event == USB_STOP;
    usb_unlock();
    return 0;
}

void files_close(int descriptor)
{
    usb_lock();
    usb_machine.open[descriptor]--;
    if (descriptor == USB_CONTROL) { /* the last of the function's files: the kernel takes the plug out */
        usb_unplug_now();
        usb_machine.tellings = usb_machine.events = 0;
    }
    if (descriptor == USB_STOP)
        usb_machine.stopped = 0;
    usb_unlock();
}

int files_wait(int descriptor, int event)
{
    (void)descriptor, (void)event;
    usb_lock();
    while (!usb_machine.events && !usb_machine.stopped)
        pthread_cond_wait(&usb_machine.change, &usb_machine.mutex);
    int result = usb_fails() ? -usb_machine.seam.reason : !usb_machine.stopped;
    usb_unlock();
    return result;
}

/* From ep0 an event, from ep2 what the host sends. */
long files_read(int descriptor, void *bytes, size_t size)
{
    long result = -EAGAIN;
    usb_lock();
    if (usb_fails()) {
        result = -usb_machine.seam.reason;
    } else if (descriptor == USB_CONTROL && size == 0) {
        usb_machine.stalls_in++;
        result = -EL2HLT;
    } else if (descriptor == USB_CONTROL && usb_machine.events) {
        memcpy(bytes, usb_machine.event, result = sizeof *usb_machine.event);
        memmove(usb_machine.event, usb_machine.event + 1, (size_t)--usb_machine.events * sizeof *usb_machine.event);
    } else if (descriptor == USB_OUT && size % 1024) {
        result = -EOVERFLOW; /* a packet of super speed may be as long */
    } else if (descriptor == USB_OUT && usb_machine.configured) {
        while (usb_machine.configured && !usb_machine.sends_size)
            pthread_cond_wait(&usb_machine.change, &usb_machine.mutex);
        result = -ESHUTDOWN;
        if (usb_machine.configured) {
            size_t count = usb_machine.sends_size < size ? usb_machine.sends_size : size;
            memcpy(bytes, usb_machine.sends, count);
            memmove(usb_machine.sends, usb_machine.sends + count, usb_machine.sends_size -= count);
            result = (long)count;
        }
    }
    usb_unlock();
    return result;
}

/* To ep0 what the function is, to ep1 what the host reads. */
long files_write(int descriptor, const void *bytes, size_t size)
{
    long result = -EAGAIN;
    usb_lock();
    if (usb_fails()) {
        result = -usb_machine.seam.reason;
    } else if (descriptor == USB_CONTROL && size == 0) {
        usb_machine.stalls_out++;
        result = -EL2HLT;
    } else if (descriptor == USB_CONTROL) {
        usb_machine.tellings++;
        result = (long)size;
        if (usb_machine.tellings == 1)
            memcpy(usb_machine.told, bytes, usb_machine.told_size = size);
    } else if (descriptor == USB_IN && usb_machine.configured) {
        int connection = usb_machine.configured;
        while (usb_machine.configured == connection && !usb_machine.reads && !usb_machine.takes) {
            usb_machine.waits = 1;
            pthread_cond_wait(&usb_machine.change, &usb_machine.mutex);
        }
        usb_machine.waits = 0;
        usb_machine.takes -= usb_machine.takes > 0;
        result = -ESHUTDOWN;
        if (usb_machine.configured == connection && usb_machine.interrupts) {
            usb_machine.interrupts--;
            result = -EINTR;
        } else if (usb_machine.configured == connection && usb_machine.got_size + size <= USB_HOST_BYTES) {
            memcpy(usb_machine.got + usb_machine.got_size, bytes, size);
            usb_machine.got_size += size;
            usb_machine.last_size = size;
            usb_machine.transfers++;
            result = (long)size;
        }
    }
    usb_unlock();
    return result;
}

/* --- the host's hands ------------------------------------------------------------------------------------------------
 */

static void usb_start(uint8_t *room)
{
    usb_lock();
    usb_machine.seam = (struct seam){.reason = EIO};
    usb_machine.no_udc = usb_machine.no_composite = usb_machine.no_root = 0;
    usb_machine.stalls_in = usb_machine.stalls_out = 0;
    usb_machine.reads = 1;
    usb_machine.got = room;
    usb_machine.got_size = usb_machine.transfers = 0;
    usb_unlock();
}

/* The device is configured, anew if it is; if it is plugged in at all. */
static void usb_connect(void)
{
    usb_lock();
    if (usb_machine.plugged[0]) {
        if (usb_machine.configured)
            usb_event(FUNCTIONFS_DISABLE);
        usb_event(FUNCTIONFS_ENABLE);
        usb_machine.configured = ++usb_machine.connections;
        usb_machine.sends_size = 0;
    }
    usb_unlock();
}

/* The cable is pulled. */
static void usb_disconnect(void)
{
    usb_lock();
    if (usb_machine.configured)
        usb_event(FUNCTIONFS_DISABLE);
    usb_machine.configured = 0;
    usb_unlock();
}

#endif
