/* SPDX-License-Identifier: MIT */
/*
 * The device's ear and what it obeys: of any bytes, in pieces of any size, and of a host that comes again at any time.
 * Between any two bytes its buffer may hold anything (which is more than its bytes can make of it) and the program may
 * have changed what it shows.
 *
 *   proves: receive_get32 receive_plausible receive_drop_first stream_receive remote_choose remote_do
 *           remote_hear remote_buttons
 *   assumes: scene_crc32
 *   options: -eva-precision 3 -eva-split-return auto
 *            -eva-slevel-function stream_receive:1000 -eva-slevel-merge-after-loop stream_receive
 */
#include "bytes.h"
#include "proof.h"

#include "firmware/stream/receive.c"

#include "firmware/app/remote.c"

#define MOST 8 /* bytes: what is proven does not depend on it */

/* `scenes` and `methods` as a program has them. */
static void hear(uint16_t scenes, uint16_t methods)
{
    static struct app app;
    struct control *c = &app.control;
    uint8_t bytes[MOST];
    *c = (struct control){.scenes = scenes, .methods = methods, .budget = 4};
    //@ loop widen_hints app.remote.receiver.count, 31;
    while (any_flag()) {
        any_bytes(app.remote.receiver.bytes, sizeof app.remote.receiver.bytes);
        any_bytes(bytes, sizeof bytes);
        app.remote.held_us = ANY_U32;
        unsigned effect = remote_hear(&app, bytes, any_s32(-1, MOST));
        remote_buttons(&app.remote, ANY_U32);
        //@ assert app.remote.receiver.count < STREAM_HEADER;
        //@ assert c->scene < scenes && c->method < methods && 1 <= c->budget && c->running <= 1;
        //@ assert app.buttons <= 255;
        //@ assert (effect & ~(CONTROL_DRAW | CONTROL_REPORT | CONTROL_READY)) == 0;
    }
}

void prove(void)
{
    hear(1, 1);
    hear(3, 20);
    hear(65535, 65535);
}
