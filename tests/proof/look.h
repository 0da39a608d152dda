/* SPDX-License-Identifier: MIT */
/* What a look at the viewer's bytes asks and gives: proven by parser.c, and assumed by wp/parser.c. */
#ifndef PROOF_LOOK_H
#define PROOF_LOOK_H

#include "bytes.h"
#include "view/parser.h"
#include "view/unpack.h"

/*@ requires queue: \valid(p) && p->spare <= 0x10000000;
    requires there: 1 <= count && \valid_read(at + (0 .. count - 1));
    assigns \result, p->need, p->spare, p->damaged, p->other_version, p->messages, p->out_of_memory
        \from *p, at[0 .. count - 1], count;
    ensures done: \result <= count;
    ensures spare: p->spare <= 0x10000000; */
static size_t parser_look(struct parser *p, const uint8_t *at, size_t count);

#endif
