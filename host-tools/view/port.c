/* SPDX-License-Identifier: MIT */
/* Names as in <termios.h>: raw mode and the baud rate are not in XSI. */
#define _DEFAULT_SOURCE
#include "view/port.h"

#include "glint/cli.h"
#include "scene/scene.h"
#ifdef HAVE_LIBUSB
#include "view/usb.h"
#include "view/usb_find.h"
#else
static int port_no_usb(void)
{
    fprintf(stderr, "usb: built without libusb-1.0 (`make view` has it)\n");
    return CLI_IO;
}
#endif

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

static int port_problem(const struct port *port, int reason)
{
    if (!cli_interrupted())
        fprintf(stderr, "%s: %s\n", port->name, strerror(reason));
    return CLI_IO;
}

/* The line may belong to a terminal program with translations and echo on. */
static int port_set_line(struct port *port)
{
    struct termios line;
    if (tcgetattr(port->file, &line) != 0)
        return -1;
    cfmakeraw(&line);
    line.c_cflag |= CLOCAL | CREAD;
    line.c_cflag &= ~(tcflag_t)(CSTOPB | CRTSCTS);
    cfsetispeed(&line, B115200);
    cfsetospeed(&line, B115200);
    return tcsetattr(port->file, TCSANOW, &line);
}

static long port_file_read(struct port *port, void *bytes, size_t size, int wait_ms)
{
    struct pollfd there = {.fd = port->file, .events = POLLIN};
    int ready = poll(&there, 1, wait_ms);
    if (ready == 0)
        return 0;
    ssize_t count = ready < 0 ? -1 : read(port->file, bytes, size);
    if (count > 0)
        return count;
    if (count == 0 || (port->asks && errno == EIO)) /* the other end of a pseudo-terminal is closed */
        return PORT_END;
    if (errno == EINTR || errno == EAGAIN)
        return 0;
    port_problem(port, errno);
    return PORT_FAILED;
}

static int port_file_send(struct port *port, const uint8_t message[STREAM_HEADER])
{
    size_t sent = 0;
    for (int tries = 0; sent < STREAM_HEADER && tries < 100 && !cli_interrupted();) {
        struct pollfd there = {.fd = port->file, .events = POLLOUT};
        ssize_t count = poll(&there, 1, 20) > 0 ? write(port->file, message + sent, STREAM_HEADER - sent) : 0;
        if (count < 0 && errno == EIO) /* unplugged, as who reads will find */
            return CLI_DONE;
        if (count < 0 && errno != EAGAIN && errno != EINTR)
            return port_problem(port, errno);
        if (count > 0)
            sent += (size_t)count;
        else
            tries++;
    }
    return sent == STREAM_HEADER ? CLI_DONE : port_problem(port, ETIMEDOUT);
}

static void port_file_missing(struct port *port)
{
    fprintf(stderr, "%s: no answer\n", port->name);
}

static void port_file_close(struct port *port)
{
    if (port->file > STDIN_FILENO)
        close(port->file);
    port->file = -1;
}

static int port_file_open(struct port *port, const char *input)
{
    static const struct port_ops ops = {port_file_read, port_file_send, port_file_missing, port_file_close};
    struct stat there;
    *port = (struct port){.name = input, .ops = &ops, .there = true};
    if (strcmp(input, "-") == 0) {
        port->name = "standard input";
        port->file = STDIN_FILENO;
        return CLI_DONE;
    }
    bool plain = strncmp(input, "file:", 5) == 0;
    port->name = plain ? input + 5 : input;
    port->file = open(port->name, plain ? O_RDONLY : O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (port->file < 0 || fstat(port->file, &there) != 0) {
        int code = port_problem(port, errno);
        port_close(port);
        return code;
    }
    port->asks = port->polls = !plain;
    if (plain && S_ISDIR(there.st_mode))
        errno = EISDIR;
    else if (plain || (isatty(port->file) && port_set_line(port) == 0))
        return CLI_DONE;
    if (!plain && errno == ENOTTY)
        fprintf(stderr, "%s: is no serial line; a recording is given as file:%s\n", input, input);
    else
        port_problem(port, errno);
    port_close(port);
    return CLI_IO;
}

int port_open(struct port *port, const char *input, const char *serial)
{
    static const char usb[] = "usb:";
    if (strncmp(input, usb, sizeof usb - 1) != 0)
        return port_file_open(port, input);
#ifdef HAVE_LIBUSB
    return usb_open(port, input[sizeof usb - 1] ? input + sizeof usb - 1 : serial);
#else
    (void)serial;
    return port_no_usb();
#endif
}

int port_list(void)
{
#ifdef HAVE_LIBUSB
    return usb_find_list();
#else
    return port_no_usb();
#endif
}

static void port_put32(uint8_t *at, uint32_t value)
{
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(value >> 8 * i & 255);
}

void port_message(uint8_t message[STREAM_HEADER], enum stream_type type, uint32_t value, uint16_t sequence)
{
    memset(message, 0, STREAM_HEADER);
    port_put32(message + STREAM_AT_MAGIC, STREAM_MAGIC);
    message[STREAM_AT_VERSION] = STREAM_VERSION;
    message[STREAM_AT_TYPE] = (uint8_t)type;
    message[STREAM_AT_SEQUENCE] = (uint8_t)(sequence & 255);
    message[STREAM_AT_SEQUENCE + 1] = (uint8_t)(sequence >> 8);
    port_put32(message + STREAM_AT_X, value);
    port_put32(message + STREAM_AT_CRC, scene_crc32(0, message, STREAM_AT_CRC));
}

long port_read(struct port *port, void *bytes, size_t size, int wait_ms)
{
    return port->ops->read(port, bytes, size, wait_ms);
}

int port_ask(struct port *port, enum stream_type type, uint32_t value)
{
    uint8_t message[STREAM_HEADER];
    if (!port->asks || !port->there)
        return CLI_DONE;
    port->sequence = (uint16_t)(port->sequence == UINT16_MAX ? 1 : port->sequence + 1);
    port_message(message, type, value, port->sequence);
    return port->ops->send(port, message);
}

void port_missing(struct port *port)
{
    port->ops->missing(port);
}

void port_close(struct port *port)
{
    port->ops->close(port);
}
