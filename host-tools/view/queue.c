/* SPDX-License-Identifier: MIT */
#include "view/queue.h"

#include <string.h>

static size_t queue_least(size_t a, size_t b)
{
    return a < b ? a : b;
}

size_t queue_free(const struct queue *q)
{
    return q->room - q->count;
}

void queue_put(struct queue *q, const void *bytes, size_t count)
{
    size_t at = (q->first + q->count) % q->room, up = queue_least(count, q->room - at);
    memcpy(q->bytes + at, bytes, up);
    memcpy(q->bytes, (const uint8_t *)bytes + up, count - up);
    q->count += count;
}

size_t queue_take(struct queue *q, void *bytes, size_t size)
{
    size_t count = queue_least(size, q->count), up = queue_least(count, q->room - q->first);
    memcpy(bytes, q->bytes + q->first, up);
    memcpy((uint8_t *)bytes + up, q->bytes, count - up);
    q->first = (q->first + count) % q->room;
    q->count -= count;
    return count;
}
