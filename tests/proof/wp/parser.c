/* SPDX-License-Identifier: MIT */
/*
 * The viewer's queue of bytes, for pieces, queues and messages of any length: from any state that QUEUE allows one call
 * ends in such a state, memory may be had or not, and a round of looking ends. What a look does is
 * tests/proof/parser.c's.
 *
 *   proves: parser_run parser_push parser_finish
 *   assumes: parser_look
 *   options: -machdep gcc_x86_64 -warn-unsigned-overflow
 */
#include "look.h"

#include <stdlib.h>
#include <string.h>

#define HAD   0x4000000000000000 /* bytes: the most that can be had in one piece */
#define PIECE 0x0800000000000000 /* the most that is pushed at once */

/* clang-format off */
#define QUEUE(p)                                                                                   \
    (\valid(p) && (p)->count <= (p)->room <= HAD && (p)->spare <= 0x10000000 &&                    \
     ((p)->room == 0 || (\valid((p)->bytes + (0 .. (p)->room - 1)) &&                              \
                         \separated(p, (p)->bytes + (0 .. (p)->room - 1)))))
/* clang-format on */

/*@ requires QUEUE(p);
    assigns p->count, p->need, p->spare, p->damaged, p->other_version, p->messages, p->out_of_memory,
        p->bytes[0 .. p->count - 1];
    ensures QUEUE(p) && p->count <= \old(p->count);
    ensures last && !p->out_of_memory ==> p->count == 0; */
static void parser_run(struct parser *p, bool last);

/*@ requires QUEUE(p) && size <= PIECE && (size == 0 || \valid_read((const uint8_t *)bytes + (0 .. size - 1)));
    requires \separated(p, (const uint8_t *)bytes + (0 .. size - 1));
    requires p->room == 0 ||
        \separated(p->bytes + (0 .. p->room - 1), (const uint8_t *)bytes + (0 .. size - 1));
    ensures QUEUE(p); */
void parser_push(struct parser *p, const void *bytes, size_t size);

/*@ requires QUEUE(p);
    ensures QUEUE(p) && (!p->out_of_memory ==> p->count == 0); */
void parser_finish(struct parser *p);

/*@ assigns \result \from format, width; */
size_t unpack_row_bytes(enum stream_format format, uint32_t width);

/* Of the library, for bytes. */
/*@ requires size == 0 || (\valid(to + (0 .. size - 1)) && \valid_read(from + (0 .. size - 1)));
    assigns to[0 .. size - 1]; */
void move_bytes(uint8_t *to, const uint8_t *from, size_t size);
#define memmove(to, from, size) move_bytes(to, from, size)
/*@ requires size == 0 || (\valid(to + (0 .. size - 1)) && \valid_read(from + (0 .. size - 1)));
    requires size == 0 || \separated(to + (0 .. size - 1), from + (0 .. size - 1));
    assigns to[0 .. size - 1]; */
void copy_bytes(uint8_t *to, const uint8_t *from, size_t size);
#define memcpy(to, from, size) copy_bytes(to, from, size)

/* A block of its own, or null: it lies apart from the queue's struct and the piece that is pushed. */
/*@ requires 1 <= room;
    assigns \nothing;
    ensures \result == \null ||
        (room <= HAD && \valid(\result + (0 .. room - 1)) && \separated(p, \result + (0 .. room - 1)) &&
         \separated(piece + (0 .. size - 1), \result + (0 .. room - 1))); */
uint8_t *more_bytes(struct parser *p, const uint8_t *piece, size_t size, size_t room);
#define realloc(old, room) more_bytes(p, bytes, size, room)

#include "host-tools/view/parser.c"
