/* SPDX-License-Identifier: MIT */
/* Bytes in the order they came, as many as there is room for. */
#ifndef VIEW_QUEUE_H
#define VIEW_QUEUE_H

#include <stddef.h>
#include <stdint.h>

struct queue {
    uint8_t *bytes; /* the caller's, `room` of them; all else is zero at first */
    size_t room;
    size_t first, count; /* where the oldest is; how many there are */
};

/* How many could be put. */
size_t queue_free(const struct queue *queue);

/* At most queue_free() bytes. */
void queue_put(struct queue *queue, const void *bytes, size_t count);

/* The oldest, at most `size`: how many. */
size_t queue_take(struct queue *queue, void *bytes, size_t size);

#endif
