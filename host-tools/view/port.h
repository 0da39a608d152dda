/* SPDX-License-Identifier: MIT */
/* Where a stream comes from: a file, standard input, a serial line on which the device can be asked, or USB. */
#ifndef VIEW_PORT_H
#define VIEW_PORT_H

#include "stream/protocol.h"

#include <stdbool.h>
#include <stddef.h>

#define PORT_BAUD 115200
#define PORT_MOST 524288 /* bytes that may wait in a port until they are read */

struct port;

/* What a port does; its functions below go on to these. */
struct port_ops {
    long (*read)(struct port *port, void *bytes, size_t size, int wait_ms);
    int (*send)(struct port *port, const uint8_t message[STREAM_HEADER]);
    void (*missing)(struct port *port);
    void (*close)(struct port *port);
};

/* To be read. Stays where it is while open. */
struct port {
    const char *name;     /* for messages; another once a device is there */
    bool asks;            /* a device is at the other end, or will be */
    bool polls;           /* it sends a picture only when asked */
    bool there;           /* now */
    const char *why;      /* not, in a few words; null: none has been seen */
    unsigned connections; /* counts up when one comes: what is read from then on is another stream */

    const struct port_ops *ops;
    int file;
    struct usb *usb;
    uint16_t sequence; /* of the last request, from 1 on; 0: none so far */
};

/* "file:PATH", "-", the path of a serial line, which is set to PORT_BAUD, 8N1, without any translation, or "usb:" and
 * maybe a serial number, which may also be given as `serial` (else null). Exit codes as everywhere (cli.h), with a
 * message. */
int port_open(struct port *port, const char *input, const char *serial);

/* Waits at most so long for bytes: how many were read; 0: none yet; PORT_END; or PORT_FAILED, with a message. Where
 * devices come and go, 0 is also what is read when one has come. */
enum { PORT_END = -1, PORT_FAILED = -2 };
long port_read(struct port *port, void *bytes, size_t size, int wait_ms);

/* Nobody waits any longer for a device: says on stderr why none is there, or none that answers. */
void port_missing(struct port *port);

/* Sends the device a message: an exit code. Does nothing where there is none. A device on USB that does not
 * listen gets the newest few. */
int port_ask(struct port *port, enum stream_type type, uint32_t value);

/* A message from host to device. */
void port_message(uint8_t message[STREAM_HEADER], enum stream_type type, uint32_t value, uint16_t sequence);

void port_close(struct port *port);

/* Prints a line for each device on USB: an exit code, with a message. */
int port_list(void);

#endif
