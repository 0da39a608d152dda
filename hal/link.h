/* SPDX-License-Identifier: MIT */
/*
 * A way for pictures to one other end that comes and goes, as a USB host does. Nothing here waits: a picture that
 * cannot be taken whole is left out. hal/linux/usb_stream.h is one.
 *
 * All calls come from one thread: read, before every picture; begin, and if it takes the picture, write as
 * often as there are pieces.
 */
#ifndef HAL_LINK_H
#define HAL_LINK_H

#include <stddef.h>
#include <stdint.h>

#define HAL_LINK_COMES (-1) /* of read: somebody has come, who knows nothing of what was before */

struct hal_link;

struct hal_link_ops {
    /* What the other end has sent, at most `size` bytes: how many. HAL_LINK_COMES, once, before anything of whoever has
     * come to the other end. */
    int32_t (*read)(struct hal_link *, void *bytes, uint32_t size);
    /* A picture is about to be drawn. 1: all of it will be taken; how long the longest is was said when the link was
     * opened. 0: nobody is there that read has told of, or there is no room: then 1 is added to *skipped. */
    uint32_t (*begin)(struct hal_link *, uint32_t *skipped);
    /* Takes a part of the picture that begin took, or of a line behind it: 0, or HAL_E_IO if the other end has gone
     * since, or HAL_E_FULL. `link` is the struct hal_link; the bytes are the caller's again on return. */
    int (*write)(void *link, const void *bytes, size_t size);
};

/* The first member of every link's own struct. */
struct hal_link {
    const struct hal_link_ops *ops;
};

#endif
