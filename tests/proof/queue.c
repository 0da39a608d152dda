/* SPDX-License-Identifier: MIT */
/*
 * The viewer's queue of bytes to a device: pieces of any size that it has room for, taken in pieces of any size.
 *
 *   proves: queue_least queue_free queue_put queue_take
 *   options: -machdep gcc_x86_64 -eva-precision 3 -eva-slevel 20000 -eva-min-loop-unroll 6
 */
#include "proof.h"

#include "host-tools/view/queue.c"

#define ROOM 4

void prove(void)
{
    uint8_t bytes[ROOM], piece[ROOM + 1], taken[ROOM + 1]; /* a copy of nothing begins behind what was taken */
    any_bytes(piece, sizeof piece);
    for (size_t first = 0; first < ROOM; first++)
        for (size_t count = 0; count <= ROOM; count++)
            for (size_t more = 0; more <= ROOM - count; more++)
                for (size_t size = 0; size <= ROOM; size++) {
                    struct queue q = {.bytes = bytes, .room = ROOM, .first = first, .count = count};
                    any_bytes(bytes, sizeof bytes);
                    queue_put(&q, piece, more);
                    queue_take(&q, taken, size);
                    queue_free(&q);
                    //@ assert q.first < ROOM && q.count <= ROOM;
                }
}
