/* SPDX-License-Identifier: MIT */
/* Where a stream comes from: a file, standard input, or a serial line on which the device can be asked. */
#ifndef VIEW_PORT_H
#define VIEW_PORT_H

#include "stream/protocol.h"

#include <stdbool.h>
#include <stddef.h>

#define PORT_BAUD 115200

struct port {
    const char *name; /* for messages */
    int file;
    bool asks;         /* a device is at the other end */
    uint16_t sequence; /* of the last request, from 1 on; 0: none so far */
};

/* "file:PATH", "-" or the path of a serial line, which is set to PORT_BAUD, 8N1, without any translation. Exit codes as
 * everywhere (cli.h), with a message. */
int port_open(struct port *port, const char *input);

/* Waits at most so long for bytes: how many were read; 0: none yet; PORT_END; or PORT_FAILED, with a message. */
enum { PORT_END = -1, PORT_FAILED = -2 };
long port_read(struct port *port, void *bytes, size_t size, int wait_ms);

/* Sends the device a message: an exit code. Does nothing where there is none. */
int port_ask(struct port *port, enum stream_type type, uint32_t value);

/* A message from host to device. */
void port_message(uint8_t message[STREAM_HEADER], enum stream_type type, uint32_t value, uint16_t sequence);

void port_close(struct port *port);

#endif
