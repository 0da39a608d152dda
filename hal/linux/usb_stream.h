/* SPDX-License-Identifier: MIT */
/*
 * A link (link.h) to a USB host. What is written is copied into a queue that a thread empties, so nobody waits for a
 * host that does not read: at most one whole picture is in the queue behind the one that is leaving it, and those after
 * them are left out. A host that goes takes the queue's contents with it; one that reads again after long begins anew.
 */
#ifndef HAL_LINUX_USB_STREAM_H
#define HAL_LINUX_USB_STREAM_H

#include "link.h"
#include "linux/ffs.h"
#include "linux/gadget.h"

#include <pthread.h>

#define USB_STREAM_PIECE   16384u /* bytes the kernel is given at a time */
#define USB_STREAM_HEARD   4096u  /* bytes from the host that wait to be read; what finds no room is lost */
#define USB_STREAM_THREADS 3u

struct usb_stream_config {
    struct gadget_config gadget;
    uint8_t *queue;      /* memory for two pictures ... */
    uint32_t frame_most; /* ... of at most so many bytes each, with what is sent beside them */
};

struct usb_stream {
    struct hal_link link;   /* first */
    struct problem problem; /* why it did not open */

    /* its own */
    struct gadget gadget;
    struct ffs ffs;
    pthread_t thread[USB_STREAM_THREADS];
    unsigned threads;
    pthread_mutex_t mutex; /* of all below */
    pthread_cond_t change;
    uint8_t stop, there;
    uint32_t arrived, known; /* connections: how many there were; which one read has told of */
    uint8_t *queue;
    uint32_t size, frame_most; /* bytes; size: of the queue, two of the other */
    uint64_t written, sent;    /* bytes: into the queue, and taken by the host */
    uint64_t leaving;          /* bytes: given to the kernel */
    uint32_t left_out;         /* pictures, since the kernel was given the last bytes */
    uint8_t late;              /* the host took them late: what is in the queue is old */
    uint64_t begun_at;         /* bytes before the last picture */
    uint64_t heard, read;      /* bytes: from the host, and told */
    uint8_t host[USB_STREAM_HEARD];
    uint8_t piece[USB_STREAM_PIECE];
};

/* Plugs the device in: 0, or HAL_E_IO and the problem, with nothing held. The queue is in use until it is closed. */
int usb_stream_open(struct usb_stream *usb, const struct usb_stream_config *config);

/* Waits up to half a second until a host that reads has what was written, unplugs and removes all. Harmless when not
 * open. */
void usb_stream_close(struct usb_stream *usb);

#endif
