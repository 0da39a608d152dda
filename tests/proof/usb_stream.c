/* SPDX-License-Identifier: MIT */
/*
 * The queue to a USB host and the bytes from it, under the mutex, by induction: from every state that the numbers
 * allow, here of a queue of 4 bytes wherever it has turned, each step ends in such a state, with nothing copied
 * outside the queue, the piece and what the caller gave.
 *
 *   proves: usb_stream_forget usb_stream_refused usb_stream_piece usb_stream_taken usb_stream_heard usb_stream_knows
 *           usb_stream_begin usb_stream_write usb_stream_read
 *   options: -machdep gcc_x86_64 -eva-precision 3 -eva-slevel 60 -cpp-extra-args=-idirafter/usr/include
 *            -cpp-extra-args=-idirafter/usr/include/x86_64-linux-gnu
 */
#include "proof.h"

#include <pthread.h>
#include <signal.h>
#include <time.h>

/* Of threads, what is opened and closed by; nothing of it runs here. */
/*@ assigns \result, *attributes \from clock; */
int pthread_condattr_setclock(pthread_condattr_t *attributes, clockid_t clock);
/*@ assigns \result, *before \from how, *set; */
int pthread_sigmask(int how, const sigset_t *set, sigset_t *before);

/* Nothing may be copied from one behind the last byte. */
/*@ requires size == 0 || (\valid((uint8_t *)to + (0 .. size - 1)) && \valid_read((uint8_t *)from + (0 .. size - 1)) &&
        \initialized((uint8_t *)from + (0 .. size - 1)) &&
        \separated((uint8_t *)to + (0 .. size - 1), (uint8_t *)from + (0 .. size - 1)));
    assigns ((uint8_t *)to)[0 .. size - 1] \from ((uint8_t *)from)[0 .. size - 1]; */
void copy(void *to, const void *from, size_t size);
#include <string.h>
#define memcpy copy
#include "hal/linux/usb_stream.c"

#define SIZE 4u

static void allowed(const struct usb_stream *u)
{
    //@ assert u->sent <= u->written && u->written - u->sent <= u->size && u->read <= u->heard;
    //@ assert u->heard - u->read <= USB_STREAM_HEARD && u->there <= 1;
    (void)u;
}

/* The queue's first byte and how many wait; those begun are a picture's from one of them on. */
static struct usb_stream any_stream(uint8_t *queue, uint64_t sent, uint64_t waiting, uint64_t begun)
{
    struct usb_stream u = {.queue = queue, .size = SIZE, .frame_most = SIZE / 2, .ffs = {-1, -1, -1, -1}};
    any_bytes(queue, SIZE);
    u.sent = sent, u.written = sent + waiting, u.begun_at = begun;
    u.leaving = any_u64(0, UINT64_MAX);
    u.there = (uint8_t)any_flag(), u.late = (uint8_t)any_flag();
    u.arrived = ANY_U32, u.known = ANY_U32, u.left_out = ANY_U32;
    return u;
}

static void step(uint8_t *queue, uint64_t sent, uint64_t waiting, uint64_t begun)
{
    const struct usb_stream before = any_stream(queue, sent, waiting, begun);
    struct usb_stream u = before;
    uint8_t bytes[SIZE + 1];
    uint32_t skipped = ANY_U32;
    if (waiting) {
        const uint32_t count = usb_stream_piece(&u, u.sent == u.begun_at);
        //@ assert 1 <= count <= waiting && \initialized(u.piece + (0 .. count - 1));
        usb_stream_taken(&u, count, u.sent == u.begun_at);
        allowed(&u);
    }
    u = before;
    usb_stream_refused(&u, any_s32(-200, SIZE));
    allowed(&u);
    u = before;
    usb_stream_begin(&u.link, &skipped);
    allowed(&u);
    any_bytes(bytes, sizeof bytes);
    //@ loop unroll 6;
    for (uint32_t size = 0; size <= SIZE + 1; size++) {
        u = before;
        usb_stream_write(&u, bytes + sizeof bytes - size, size);
        allowed(&u);
    }
}

/* What waits fills a packet: a byte stays behind. And more than the kernel is given at a time. */
static void packets(void)
{
    static uint8_t queue[2 * USB_STREAM_PIECE];
    struct usb_stream u = {.queue = queue, .size = sizeof queue, .sent = sizeof queue - 1};
    u.written = u.sent + FFS_PACKET;
    const uint32_t count = usb_stream_piece(&u, 0);
    //@ assert count == FFS_PACKET - 1;
    u.written = u.sent + USB_STREAM_PIECE + 1;
    const uint32_t most = usb_stream_piece(&u, 0);
    //@ assert most == USB_STREAM_PIECE;
    (void)count, (void)most;
}

/* Bytes from the host, at any place of the ring's turn; a call is given few. */
static void hears(uint64_t read, uint64_t waiting)
{
    static struct usb_stream u;
    uint8_t bytes[3];
    any_bytes(u.host, sizeof u.host);
    any_bytes(bytes, sizeof bytes);
    u.read = read, u.heard = read + waiting;
    u.there = (uint8_t)any_flag(), u.arrived = ANY_U32, u.known = ANY_U32;
    //@ loop unroll 4;
    for (uint32_t count = 0; count <= 3; count++) {
        usb_stream_heard(&u, bytes + 3 - count, count);
        allowed(&u);
    }
    //@ loop unroll 4;
    for (uint32_t count = 0; count <= 3; count++) {
        int32_t got = usb_stream_read(&u.link, bytes + 3 - count, count);
        //@ assert got == HAL_LINK_COMES || 0 <= got <= count;
        allowed(&u);
    }
    usb_stream_read(&u.link, bytes, sizeof bytes); /* more than there is */
    allowed(&u);
}

void prove(void)
{
    uint8_t queue[SIZE];
    const uint64_t turns = UINT64_C(0x100000000);
    //@ loop unroll 5;
    for (uint64_t waiting = 0; waiting <= SIZE; waiting++) {
        step(queue, turns + SIZE - 1, waiting, turns + SIZE - 1);
        step(queue, turns + SIZE - 2, waiting, turns + SIZE - 2 + waiting);
    }
    packets();
    step(queue, turns + SIZE, 2, turns + SIZE + 1);
    step(queue, turns + SIZE, 1, turns);
    hears(turns + USB_STREAM_HEARD - 1, 0);
    hears(turns + USB_STREAM_HEARD - 1, 2);
    hears(turns + 1, USB_STREAM_HEARD);
}
