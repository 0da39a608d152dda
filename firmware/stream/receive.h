/* SPDX-License-Identifier: MIT */
/* What the other end wants: messages from host to device (PROTOCOL.md), from bytes as they come. */
#ifndef STREAM_RECEIVE_H
#define STREAM_RECEIVE_H

#include "stream/protocol.h"

/* All zeros at first. */
struct stream_receiver {
    uint8_t bytes[STREAM_HEADER]; /* what may be the beginning of a message */
    uint8_t count;
};

struct stream_request {
    uint8_t type; /* STREAM_KEY_PLEASE ... STREAM_PAUSE, or one that a later host knows */
    uint16_t sequence;
    uint32_t value;
};

/* Takes a byte: 1 if it completes a message, else 0. What is not one, or is damaged, is passed over. */
int stream_receive(struct stream_receiver *receiver, uint8_t byte, struct stream_request *request);

#endif
