/* SPDX-License-Identifier: MIT */
#include "linux/usb_stream.h"
#include "display.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <time.h>

#define GATHER      4096u /* bytes that are worth a transfer of their own; fewer wait for others ... */
#define GATHER_US   1000u /* ... no longer than this */
#define PAUSE_US    10000u
#define DRAIN_US    500000u
#define READ_PIECES 512u /* a packet of high speed */
#define FIRST       100u /* bytes of a picture that go alone: fewer than any has, more than a controller takes ahead */
#define LATE        60u  /* pictures: a host that lets so many be left out was not reading */

static struct timespec usb_stream_after(uint32_t us)
{
    struct timespec at;
    clock_gettime(CLOCK_MONOTONIC, &at);
    uint64_t ns = (uint64_t)at.tv_nsec + us * (uint64_t)1000;
    return (struct timespec){at.tv_sec + (time_t)(ns / 1000000000u), (long)(ns % 1000000000u)};
}

/* Until something changes, or the moment is past: 0 then. */
static int usb_stream_wait(struct usb_stream *u, const struct timespec *until)
{
    return until ? pthread_cond_timedwait(&u->change, &u->mutex, until) == 0
                 : pthread_cond_wait(&u->change, &u->mutex) == 0;
}

/* Nothing of what is under way concerns anybody any more. */
static void usb_stream_forget(struct usb_stream *u)
{
    u->sent = u->leaving = u->begun_at = u->written;
    u->read = u->heard;
    u->left_out = u->late = 0;
}

/* An endpoint refused, during the connection of that number. It is over, and the next is told by an event; or it is
 * not, and then something is missing in it: the host shall take it as another. */
static void usb_stream_refused(struct usb_stream *u, long reason)
{
    usb_stream_forget(u);
    if (reason == -EAGAIN || reason == -ESHUTDOWN || reason == -ENODEV)
        u->there = 0;
    else
        u->arrived++;
}

/* What did not go well is not tried again at once. */
static void usb_stream_pause(struct usb_stream *u)
{
    struct timespec until = usb_stream_after(PAUSE_US);
    while (!u->stop && usb_stream_wait(u, &until))
        ;
}

/* --- the threads ----------------------------------------------------------------------------------------------------
 */

static void *usb_stream_events(void *argument)
{
    struct usb_stream *u = argument;
    int stop = 0;
    for (enum ffs_event event; !stop && (event = ffs_next(&u->ffs)) != FFS_STOPPED;) {
        pthread_mutex_lock(&u->mutex);
        if (event == FFS_BROKEN) {
            usb_stream_pause(u);
        } else if (event != FFS_NOTHING) {
            u->there = event == FFS_COMES;
            u->arrived += u->there;
            usb_stream_forget(u);
            pthread_cond_broadcast(&u->change);
        }
        stop = u->stop; /* also where it does not wait */
        pthread_mutex_unlock(&u->mutex);
    }
    return NULL;
}

/* What is to leave next, copied: how many bytes. A transfer of the host's ends with a packet that is not full: where
 * nothing follows yet, the last byte stays behind to make it so, and then goes alone. `first`: of a picture, of which
 * no more goes with it. */
static uint32_t usb_stream_piece(struct usb_stream *u, int first)
{
    uint64_t waiting = u->written - u->sent;
    uint64_t whole = first ? FIRST : u->sent < u->begun_at ? u->begun_at - u->sent : USB_STREAM_PIECE;
    whole = whole < waiting ? whole : waiting;
    uint32_t count = whole < USB_STREAM_PIECE ? (uint32_t)whole : USB_STREAM_PIECE;
    count -= count == waiting && count % FFS_PACKET == 0;
    uint32_t at = (uint32_t)(u->sent % u->size), part = count < u->size - at ? count : u->size - at;
    memcpy(u->piece, u->queue + at, part);
    memcpy(u->piece + part, u->queue, count - part);
    return count;
}

/* Messages are written in small parts: those that come together leave together. */
static void usb_stream_gather(struct usb_stream *u)
{
    struct timespec until = usb_stream_after(GATHER_US);
    while (!u->stop && u->there && u->written - u->sent < GATHER && usb_stream_wait(u, &until))
        ;
}

/* A piece was taken. If only now somebody reads, the pictures that have waited for him are of another time: a picture's
 * first bytes, and none of what is behind them, go to who has read nothing of it. */
static void usb_stream_taken(struct usb_stream *u, uint32_t count, int first)
{
    u->sent += count;
    u->late |= u->left_out > LATE;
    if (u->late && (first || u->sent == u->begun_at)) {
        usb_stream_forget(u);
        u->arrived++;
    } else if (u->sent == u->written) {
        u->late = 0;
    }
}

static void *usb_stream_sends(void *argument)
{
    struct usb_stream *u = argument;
    pthread_mutex_lock(&u->mutex);
    while (!u->stop) {
        if (!u->there || u->written == u->sent) {
            usb_stream_wait(u, NULL);
            continue;
        }
        usb_stream_gather(u);
        if (u->written == u->sent)
            continue;
        int first = u->sent == u->begun_at;
        uint32_t count = usb_stream_piece(u, first), connection = u->arrived;
        u->leaving = u->sent + count;
        u->left_out = 0;
        pthread_mutex_unlock(&u->mutex);
        long result = ffs_send(&u->ffs, u->piece, count);
        pthread_mutex_lock(&u->mutex);
        if (connection != u->arrived || !u->there)
            continue;
        if (result == (long)count)
            usb_stream_taken(u, count, first);
        else
            usb_stream_refused(u, result);
        pthread_cond_broadcast(&u->change);
    }
    pthread_mutex_unlock(&u->mutex);
    return NULL;
}

/* Takes bytes from the host; what finds no room is lost, as on any line. */
static void usb_stream_heard(struct usb_stream *u, const uint8_t *bytes, uint32_t count)
{
    for (uint32_t i = 0; i < count && u->heard - u->read < USB_STREAM_HEARD; i++)
        u->host[u->heard++ % USB_STREAM_HEARD] = bytes[i];
}

static void *usb_stream_hears(void *argument)
{
    struct usb_stream *u = argument;
    uint8_t bytes[READ_PIECES];
    pthread_mutex_lock(&u->mutex);
    while (!u->stop) {
        if (!u->there) {
            usb_stream_wait(u, NULL);
            continue;
        }
        uint32_t connection = u->arrived;
        pthread_mutex_unlock(&u->mutex);
        long count = ffs_receive(&u->ffs, bytes, sizeof bytes);
        pthread_mutex_lock(&u->mutex);
        if (connection != u->arrived)
            continue;
        if (count >= 0) {
            usb_stream_heard(u, bytes, (uint32_t)count);
        } else {
            usb_stream_pause(u);
        }
    }
    pthread_mutex_unlock(&u->mutex);
    return NULL;
}

/* --- the link -------------------------------------------------------------------------------------------------------
 */

/* Somebody is there, of whom the reader was told. */
static int usb_stream_knows(const struct usb_stream *u)
{
    return u->there && u->known == u->arrived;
}

static uint32_t usb_stream_begin(struct hal_link *link, uint32_t *skipped)
{
    struct usb_stream *u = (struct usb_stream *)link;
    pthread_mutex_lock(&u->mutex);
    /* room: the last one has begun to leave, if there is something of it */
    uint32_t knows = usb_stream_knows(u) != 0, takes = knows && (u->leaving > u->begun_at || u->sent == u->written) &&
                                                       u->size - (u->written - u->sent) >= u->frame_most;
    if (takes)
        u->begun_at = u->written;
    *skipped += knows - takes;
    u->left_out += knows - takes;
    pthread_mutex_unlock(&u->mutex);
    return takes;
}

static int usb_stream_write(void *link, const void *bytes, size_t size)
{
    struct usb_stream *u = link;
    int result = 0;
    pthread_mutex_lock(&u->mutex);
    if (!usb_stream_knows(u))
        result = HAL_E_IO;
    else if (size > u->size - (u->written - u->sent))
        result = HAL_E_FULL;
    else {
        uint32_t at = (uint32_t)(u->written % u->size), first = size < u->size - at ? (uint32_t)size : u->size - at;
        memcpy(u->queue + at, bytes, first);
        memcpy(u->queue, (const uint8_t *)bytes + first, size - first);
        u->written += size;
        pthread_cond_broadcast(&u->change);
    }
    pthread_mutex_unlock(&u->mutex);
    return result;
}

static int32_t usb_stream_read(struct hal_link *link, void *bytes, uint32_t size)
{
    struct usb_stream *u = (struct usb_stream *)link;
    int32_t count = 0;
    pthread_mutex_lock(&u->mutex);
    if (u->there && u->known != u->arrived) {
        u->known = u->arrived;
        count = HAL_LINK_COMES;
    } else {
        for (; (uint32_t)count < size && u->read < u->heard; count++)
            ((uint8_t *)bytes)[count] = u->host[u->read++ % USB_STREAM_HEARD];
    }
    pthread_mutex_unlock(&u->mutex);
    return count;
}

static const struct hal_link_ops usb_stream_ops = {usb_stream_read, usb_stream_begin, usb_stream_write};

/* --- open and close -------------------------------------------------------------------------------------------------
 */

/* Signals are the main thread's: one that came to these would end a transfer. */
static int usb_stream_start(struct usb_stream *u)
{
    static void *(*const run[USB_STREAM_THREADS])(void *) = {usb_stream_events, usb_stream_sends, usb_stream_hears};
    sigset_t all, before;
    int result = 0;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    for (; u->threads < USB_STREAM_THREADS && !result; u->threads += !result)
        result = pthread_create(&u->thread[u->threads], NULL, run[u->threads], u);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return result ? problem_set(&u->problem, "the threads of USB: %s", strerror(result)) : 0;
}

int usb_stream_open(struct usb_stream *u, const struct usb_stream_config *config)
{
    pthread_condattr_t monotonic;
    *u = (struct usb_stream){.link.ops = &usb_stream_ops,
                             .ffs = {-1, -1, -1, -1},
                             .queue = config->queue,
                             .size = 2 * config->frame_most,
                             .frame_most = config->frame_most};
    int error = gadget_open(&u->gadget, &config->gadget, &u->problem);
    if (!error)
        error = ffs_open(&u->ffs, GADGET_FILES, &u->problem);
    if (error) {
        gadget_close(&u->gadget);
        return error;
    }
    pthread_condattr_init(&monotonic);
    pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
    pthread_cond_init(&u->change, &monotonic);
    pthread_condattr_destroy(&monotonic);
    pthread_mutex_init(&u->mutex, NULL);
    error = usb_stream_start(u);
    if (!error)
        error = gadget_plug(&u->gadget, &u->problem);
    if (error)
        usb_stream_close(u);
    return error;
}

/* Whoever still reads gets the last picture whole. */
static void usb_stream_drain(struct usb_stream *u)
{
    struct timespec until = usb_stream_after(DRAIN_US);
    pthread_mutex_lock(&u->mutex);
    while (u->there && u->sent != u->written && usb_stream_wait(u, &until))
        ;
    u->stop = 1;
    pthread_cond_broadcast(&u->change);
    pthread_mutex_unlock(&u->mutex);
}

void usb_stream_close(struct usb_stream *u)
{
    if (!u->gadget.made)
        return;
    usb_stream_drain(u);
    gadget_unplug(&u->gadget); /* ends what waits for the host */
    ffs_stop(&u->ffs);
    while (u->threads > 0)
        pthread_join(u->thread[--u->threads], NULL);
    ffs_close(&u->ffs);
    gadget_close(&u->gadget);
    pthread_cond_destroy(&u->change);
    pthread_mutex_destroy(&u->mutex);
}
