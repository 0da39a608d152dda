/* SPDX-License-Identifier: MIT */
#include "app/share.h"
#include "clock.h"

static int share_claim(struct share *s, enum hal_lock lock)
{
    return !s->core || s->core->claim(lock);
}

static void share_release(struct share *s, enum hal_lock lock)
{
    if (s->core)
        s->core->release(lock);
}

static void share_notify(struct share *s)
{
    if (s->core)
        s->core->notify();
}

/* Its buffer: there are two or four. */
static uint32_t share_place(const struct share *s, uint32_t number)
{
    return number & (s->buffers - 1);
}

/* The number's band is drawn. */
static int share_is_due(struct share *s, uint32_t number)
{
    return atomic_load(&s->slot[share_place(s, number)].number) == number + 1;
}

static int share_flush(struct hal_display *display, const struct share_slot *slot)
{
    const struct glint_band *band = &slot->band;
    int error = 0;
    if (band->y == 0 && display->ops->frame_begin)
        error = display->ops->frame_begin(display, 0, 0);
    if (!error)
        error = display->ops->flush(display, band->pixels, band->y, band->rows, band->stride);
    if (!error && slot->last && display->ops->frame_end)
        error = display->ops->frame_end(display);
    return error;
}

/* Sends what is due, unless the other is at it: 1 if something was. Who lets the lock go looks once more: a band that
 * the other brought meanwhile, and could not send, does not lie there. */
static int share_send(struct share *s)
{
    int sent = 0;
    while (share_is_due(s, atomic_load(&s->due)) && share_claim(s, HAL_LOCK_SEND)) {
        uint32_t due = atomic_load(&s->due);
        for (; share_is_due(s, due); due++, sent = 1) {
            if (s->display && !atomic_load(&s->error))
                atomic_store(&s->error, share_flush(s->display, &s->slot[share_place(s, due)]));
            atomic_store(&s->left, due); /* a flush returns when the band before it has left */
            atomic_store(&s->due, due + 1);
            share_notify(s);
        }
        share_release(s, HAL_LOCK_SEND);
    }
    return sent;
}

/* Sends, or sleeps until there may be something new. */
static void share_wait(struct share *s)
{
    if (!share_send(s) && s->core)
        s->core->pause();
}

/* Takes the next band of the picture: 0 if there is none. */
static int share_take(struct share *s, int assisting, uint32_t *number)
{
    while (!share_claim(s, HAL_LOCK_TAKE))
        ;
    int some = s->next != s->end;
    *number = s->next;
    if (some) {
        s->next++;
        if (assisting)
            atomic_store(&s->assisting, 1);
    }
    share_release(s, HAL_LOCK_TAKE);
    return some;
}

/* Draws the next band when a buffer is free for it, and sends what is due: 0 if there is none. */
static int share_band(struct share *s, int assisting)
{
    uint32_t number;
    if (!share_take(s, assisting, &number))
        return 0;
    while (number - atomic_load(&s->left) >= s->buffers)
        share_wait(s);
    const uint32_t place = share_place(s, number);
    struct share_slot *slot = &s->slot[place];
    uint32_t begin = clock_us();
    glint_frame_band(assisting ? &s->worker : &s->frame, number + s->count - s->end, s->band[place], &slot->band);
    if (s->over)
        s->over(s->context, &slot->band, assisting);
    slot->last = number + 1 == s->end;
    atomic_store(&slot->number, number + 1);
    if (assisting)
        atomic_store(&s->assisting, 0);
    else
        s->part_us += clock_us() - begin;
    share_notify(s);
    share_send(s);
    return 1;
}

/* The second CPU's. */
static void share_assist(void *argument)
{
    struct share *s = argument;
    for (;;)
        if (!share_band(s, 1))
            share_wait(s);
}

void share_ready(struct share *s, void *memory, uint32_t bytes)
{
    const struct glint_config *c = &s->frame.config;
    s->buffers = s->band[2] && s->band[3] ? 4 : 2;
    s->count = (c->height + c->band_rows - 1u) / c->band_rows;
    if (!s->core)
        return;
    if (glint_worker_init(&s->worker, &s->frame, memory, bytes) != 0) {
        s->core = 0;
    } else if (!s->started) {
        s->started = 1;
        s->core->start(share_assist, s);
    }
}

int share_begin(struct share *s, const void *scene, uint32_t time_ms)
{
    uint32_t begin = clock_us();
    int error = glint_frame_begin(&s->frame, scene, time_ms);
    if (error)
        return error;
    if (s->core)
        glint_worker_begin(&s->worker, &s->frame);
    s->part_us = clock_us() - begin;
    return 0;
}

int share_draw(struct share *s)
{
    while (!share_claim(s, HAL_LOCK_TAKE))
        ;
    s->end += s->count;
    share_release(s, HAL_LOCK_TAKE);
    share_notify(s);
    while (share_band(s, 0))
        ;
    while (atomic_load(&s->assisting))
        share_wait(s);
    s->draw_us = s->part_us; /* not before: the second CPU's band may show it */
    if (s->core)
        glint_worker_end(&s->worker, &s->frame);
    return atomic_load(&s->error) ? share_finish(s) : 0;
}

int share_finish(struct share *s)
{
    while (atomic_load(&s->due) != s->end)
        share_wait(s);
    int error = atomic_load(&s->error);
    atomic_store(&s->error, 0);
    return error;
}
