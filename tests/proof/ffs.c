/* SPDX-License-Identifier: MIT */
/*
 * What the kernel is told of the USB function is whole: each descriptor is as long as it says, and they end with the
 * bytes that are written, as many as the head counts. Events and requests of any bytes, calls that fail in any way.
 *
 *   proves: ffs_take ffs_tell ffs_open ffs_stall ffs_next ffs_stop ffs_send ffs_receive ffs_drop ffs_close
 *   options: -machdep gcc_x86_64 -eva-precision 3 -eva-slevel 200 -cpp-extra-args=-idirafter/usr/include
 *            -cpp-extra-args=-idirafter/usr/include/x86_64-linux-gnu
 */
#include "proof.h"

#define __BYTE_ORDER__          1234
#define __ORDER_LITTLE_ENDIAN__ 1234
#include <string.h>

#include "linux/files.h"
#include "linux/problem.h"

/*@ assigns \result \from descriptor, event;
    ensures -200 <= \result <= 1; */
int files_wait(int descriptor, int event);
/*@ assigns \result \from event; */
int files_raise(int event);
/*@ assigns \result \from \nothing;
    ensures -200 <= \result; */
int files_event(void);
/*@ requires 0 <= descriptor;
    assigns \nothing; */
void files_close(int descriptor);
/*@ requires \valid_read(path);
    assigns \result \from path[..];
    ensures -200 <= \result; */
int files_open(const char *path, int waits);
/*@ requires \valid(problem) && valid_read_string(format);
    assigns *problem, \result \from *format; */
int problem_set(struct problem *problem, const char *format, ...);

#include "hal/linux/ffs.c"

long files_read(int descriptor, void *bytes, size_t size)
{
    (void)descriptor;
    if (size) {
        //@ assert \valid((uint8_t *)bytes + (0 .. size - 1));
        any_bytes(bytes, size);
    }
    return any_s32(-200, (int32_t)size);
}

static uint32_t word(const uint8_t *at)
{
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* Of the kernel, functionfs' __ffs_data_got_descs(): a head of 12 bytes, a count for each flag, the descriptors. */
static void descriptors(const uint8_t *bytes, size_t size)
{
    uint32_t counts = 0, at = 12 + 4 * 4, plain, extended;
    //@ assert size >= 28;
    plain = word(bytes + 12) + word(bytes + 16) + word(bytes + 20);
    extended = word(bytes + 24);
    //@ assert plain == 11 && extended == 2;
    //@ loop unroll 11;
    for (; counts < plain; counts++) {
        //@ assert at + 2 <= size && bytes[at] >= 2;
        at += bytes[at];
    }
    //@ loop unroll 2;
    for (counts = 0; counts < extended; counts++) {
        //@ assert at + 11 <= size;
        at += word(bytes + at + 1);
    }
    const uint32_t end = at, told = word(bytes + 4);
    //@ assert end == size && told == size;
    (void)end, (void)told;
}

long files_write(int descriptor, const void *bytes, size_t size)
{
    (void)descriptor;
    if (size) {
        //@ assert \valid_read((uint8_t *)bytes + (0 .. size - 1)) && \initialized((uint8_t *)bytes + (0 .. size - 1));
    }
    if (size == sizeof ffs_descriptors)
        descriptors(bytes, size);
    return any_s32(-200, (int32_t)size);
}

void prove(void)
{
    char folder[4], piece[3];
    struct ffs ffs;
    struct problem problem;
    any_bytes(folder, sizeof folder - 1);
    folder[3] = 0;
    any_bytes(piece, sizeof piece);
    ffs_open(&ffs, folder, &problem);
    ffs.control = any_s32(-1, 99), ffs.in = any_s32(-1, 99), ffs.out = any_s32(-1, 99), ffs.stop = any_s32(-1, 99);
    ffs_next(&ffs);
    ffs_stop(&ffs);
    ffs_send(&ffs, piece, sizeof piece);
    ffs_receive(&ffs, piece, sizeof piece);
    ffs_close(&ffs);
}
