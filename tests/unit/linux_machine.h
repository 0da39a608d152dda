/* SPDX-License-Identifier: MIT */
/*
 * A Linux machine in a test's hands: one GPIO chip, one SPI device, a clock that only waiting moves, and a panel at the
 * pins. gpiod_v1/ and gpiod_v2/ are libgpiod on it. Each call that a kernel could refuse is counted, and one of them,
 * or all from there on, can be made to fail.
 */
#ifndef LINUX_MACHINE_H
#define LINUX_MACHINE_H

#include "clock.h"
#include "linux/kernel.h"
#include "panel_model.h"
#include "tests/faults/seam.h"

#include <errno.h>
#include <linux/spi/spidev.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>

#define MACHINE_LINES  16
#define MACHINE_EDGES  64
#define MACHINE_CHIP   "/dev/gpiochip0"
#define MACHINE_LABEL  "pinctrl-test"
#define MACHINE_SPI    "/dev/spidev0.0"
#define MACHINE_BUFSIZ 4096

/* What is wired to which line. */
enum machine_line { SCK, MOSI, CS, DC = 4, RESET, BACKLIGHT, KEY_A, KEY_UP, FREE };

struct machine {
    struct seam seam;
    int chips, taken, descriptors;     /* how many are held: lines by bits */
    int refuses;                       /* an errno for every chip, or 0 */
    const char *holder[MACHINE_LINES]; /* who else has a line */
    uint32_t levels;
    struct {
        unsigned line;
        int level;
    } edges[MACHINE_EDGES];
    unsigned edge_first, edge_end;
    uint32_t now;   /* us */
    uint32_t limit; /* bytes the SPI device takes at a time */
    uint32_t speed; /* Hz, and the mode, as they were set */
    uint8_t mode;
    uint32_t largest;     /* bytes sent at a time */
    int quits_in_picture; /* SIGTERM comes with the first pixels */
    struct model panel;
    unsigned bits;            /* of a byte by GPIO lines, under a one */
    int shown;                /* pictures seen: times the panel was turned off */
    uint16_t seen[320 * 240]; /* what it showed then */
};
static struct machine machine;
static pthread_mutex_t machine_wire = PTHREAD_MUTEX_INITIALIZER; /* who holds it keeps the SPI device from sending */

/* Whether this call fails; errno says why. Calls come from two threads. */
static int machine_fails(void)
{
    return seam_fails(&machine.seam);
}

static void machine_look(void)
{
    for (unsigned y = 0; y < 320; y++)
        for (unsigned x = 0; x < 240; x++)
            machine.seen[y * 240 + x] = model_seen(&machine.panel, x, y, 0, 0);
    machine.shown++;
}

static void machine_byte(uint8_t byte)
{
    int data = machine.levels >> DC & 1, off = machine.panel.kind == MODEL_SSD0323 ? 0xAE : 0x28;
    if (!data && byte == off && machine.panel.on && !machine.panel.expects)
        machine_look();
    machine.panel.now = machine.now;
    machine.panel.reset_low = !(machine.levels >> RESET & 1);
    model_byte(&machine.panel, data, byte);
}

/* The output lines of `which` get these levels. */
static void machine_drive(uint32_t which, uint32_t levels)
{
    uint32_t before = machine.levels;
    machine.levels = (before & ~which) | (levels & which);
    if (~before & machine.levels & 1u << RESET)
        model_reset(&machine.panel);
    if (machine.levels >> CS & 1)
        machine.bits = 1;
    machine.panel.backlight = machine.levels >> BACKLIGHT & 1;
    if (~before & machine.levels & 1u << SCK && !(machine.levels >> CS & 1)) {
        machine.bits = machine.bits << 1 | (machine.levels >> MOSI & 1);
        if (machine.bits & 0x100) {
            machine_byte((uint8_t)machine.bits);
            machine.bits = 1;
        }
    }
}

static inline void machine_press(unsigned line, int level)
{
    machine.levels = (machine.levels & ~(1u << line)) | (uint32_t)level << line;
    machine.edges[machine.edge_end].line = line;
    machine.edges[machine.edge_end++].level = level;
}

static void machine_start(enum model_kind kind)
{
    memset(&machine, 0, sizeof machine);
    machine.seam.reason = EIO;
    machine.limit = MACHINE_BUFSIZ;
    machine.bits = 1;
    machine.levels = 1u << KEY_A | 1u << KEY_UP; /* not pressed */
    machine.panel.kind = kind;
    model_reset(&machine.panel);
}

/* --- the kernel -----------------------------------------------------------------------------------------------------
 */

int kernel_open(const char *path)
{
    if (strcmp(path, MACHINE_SPI) != 0)
        return -ENOENT;
    if (machine_fails())
        return -errno;
    machine.descriptors++;
    return 7;
}

void kernel_close(int descriptor)
{
    machine.descriptors -= descriptor == 7;
}

int kernel_ioctl(int descriptor, unsigned long request, void *argument)
{
    if (machine_fails())
        return -errno;
    if (descriptor != 7)
        return -EBADF;
    if (request == SPI_IOC_WR_MODE)
        machine.mode = *(uint8_t *)argument;
    else if (request == SPI_IOC_WR_MAX_SPEED_HZ)
        machine.speed = *(uint32_t *)argument;
    else if (request == SPI_IOC_MESSAGE(1)) {
        const struct spi_ioc_transfer *transfer = argument;
        if (transfer->len > machine.limit)
            return -EMSGSIZE;
        if (machine.quits_in_picture && machine.panel.command == 0x2C && transfer->len > 1)
            raise(SIGTERM);
        machine.largest = transfer->len > machine.largest ? transfer->len : machine.largest;
        pthread_mutex_lock(&machine_wire);
        for (uint32_t i = 0; i < transfer->len; i++)
            machine_byte(((const uint8_t *)(uintptr_t)transfer->tx_buf)[i]);
        pthread_mutex_unlock(&machine_wire);
    }
    return 0;
}

long kernel_number(const char *path)
{
    (void)path;
    return MACHINE_BUFSIZ;
}

uint32_t clock_us(void)
{
    return machine.now;
}

void clock_wait_us(uint32_t us)
{
    machine.now += us;
}

void clock_idle(void)
{
    machine.now += 1000;
}

/* --- what both libgpiods share --------------------------------------------------------------------------------------
 */

static int machine_name(const char *name)
{
    static const char *const names[MACHINE_LINES] = {"sck",   "mosi",  "cs",    "",      "dc",
                                                     "reset", "light", "key-a", "key-up"};
    for (int i = 0; i < MACHINE_LINES; i++)
        if (names[i] && strcmp(names[i], name) == 0)
            return i;
    errno = ENOENT;
    return -1;
}

static int machine_open(const char *path)
{
    if (strcmp(path, MACHINE_CHIP) != 0) {
        errno = ENOENT;
        return -1;
    }
    if (machine_fails())
        return -1;
    if (machine.refuses) {
        errno = machine.refuses;
        return -1;
    }
    machine.chips++;
    return 0;
}

static int machine_take(uint32_t lines)
{
    if (machine_fails())
        return -1;
    for (unsigned i = 0; i < MACHINE_LINES; i++)
        if (lines >> i & 1 && (machine.holder[i] || machine.taken >> i & 1)) {
            errno = EBUSY;
            return -1;
        }
    machine.taken |= (int)lines;
    return 0;
}

/* The first edge of these lines: its place, or -1. */
static int machine_edge(uint32_t lines)
{
    for (unsigned i = machine.edge_first; i < machine.edge_end; i++)
        if (lines >> machine.edges[i].line & 1)
            return (int)i;
    return -1;
}

static void machine_edge_read(int place)
{
    for (int i = place; i > (int)machine.edge_first; i--)
        machine.edges[i] = machine.edges[i - 1];
    machine.edge_first++;
}

#endif
