/* SPDX-License-Identifier: MIT */
/*
 * glint-view ... --trace | cable UDC-FILE TIMES PERIOD_US: pulls the cable between a gadget and its host and puts it in
 * again, so many times.
 *
 * The moments are spread evenly over a picture's period, from the arrival of a picture's end on: the k-th is k / TIMES
 * of a PERIOD_US later. The cable then is out for .2 to 150 ms, and the next is pulled when some pictures have come. A
 * guest's program; its lines have the guest's time in microseconds in front: `out`, `in`, and those of the viewer as
 * they come. Ends with the viewer, or, after the last time, with 0; 1: no picture came for a long time; 3: the gadget
 * is gone.
 */
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define PICTURES 3     /* before the cable is pulled again */
#define LONGEST  10000 /* ms without any */

static char line[65536];
static size_t held;

static long long now_us(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * 1000000LL + t.tv_nsec / 1000;
}

/* Passes on whole lines; how many of them were of pictures, or -1 at the end. */
static int lines(int wait_ms)
{
    struct pollfd there = {.fd = STDIN_FILENO, .events = POLLIN};
    int ready = poll(&there, 1, wait_ms), pictures = 0;
    if (ready <= 0)
        return 0;
    ssize_t count = read(STDIN_FILENO, line + held, sizeof line - 1 - held);
    if (count <= 0)
        return -1;
    held += (size_t)count;
    line[held] = 0;
    char *at = line;
    for (char *end; (end = strchr(at, '\n')) != NULL; at = end + 1) {
        *end = 0;
        printf("%lld %s\n", now_us(), at);
        pictures += strstr(at, " crc ") != NULL;
    }
    held -= (size_t)(at - line);
    memmove(line, at, held);
    return pictures;
}

/* Waits, and passes on what comes meanwhile. */
static void until(long long moment)
{
    for (long long left; (left = moment - now_us()) > 0;) {
        struct timespec t = {0, (left < 1000 ? left : 1000) * 1000};
        nanosleep(&t, NULL);
        lines(0);
    }
}

static int pictures(int wanted)
{
    long long end = now_us() + LONGEST * 1000LL;
    for (int got = 0; got < wanted;) {
        int more = lines(100);
        if (more < 0 || now_us() > end)
            return -1;
        got += more;
    }
    return 0;
}

static void plug(const char *file, const char *name, const char *word)
{
    int udc = open(file, O_WRONLY);
    long long begin = now_us();
    if (udc < 0 || write(udc, name, strlen(name)) < 0) {
        perror(file);
        exit(3);
    }
    close(udc);
    printf("%lld %s, %lld us\n", begin, word, now_us() - begin);
}

int main(int argc, char **argv)
{
    char name[64] = "";
    if (argc != 4)
        return 2;
    int times = atoi(argv[2]), period = atoi(argv[3]), udc = open(argv[1], O_RDONLY);
    if (udc < 0 || read(udc, name, sizeof name - 1) < 2)
        return 3;
    close(udc);
    for (int k = 0; k < times; k++) {
        if (pictures(PICTURES) != 0)
            return 1;
        until(now_us() + (long long)period * k / times);
        plug(argv[1], "\n", "out");
        until(now_us() + 200 + (k * 37 % times) * 150000LL / times);
        plug(argv[1], name, "in");
    }
    return pictures(PICTURES) != 0;
}
