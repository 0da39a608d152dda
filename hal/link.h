/* SPDX-License-Identifier: MIT */
/*
 * A way for pictures to one other end that comes and goes, as a USB host does. Nothing here waits: a picture that
 * cannot be taken whole is left out. One is linked to a board, or none; hal/linux/usb_stream.h is one.
 *
 * Calls come in the order begin, then, if it takes the picture, write as often as there are pieces; read at any time.
 * All by one thread.
 */
#ifndef HAL_LINK_H
#define HAL_LINK_H

#include <stddef.h>
#include <stdint.h>

enum hal_link_frame {
    HAL_LINK_LEAVES, /* nobody is there, or there is no room: what is written now is refused */
    HAL_LINK_TAKES,
    HAL_LINK_TAKES_FIRST, /* the first one for somebody who has just come, and knows nothing of those before */
};

struct hal_link;

struct hal_link_ops {
    /* A picture is about to be drawn: will all of it be taken? How long the longest is was said when the link was
     * opened. One that is left for want of room while somebody is there is added to *skipped. */
    enum hal_link_frame (*begin)(struct hal_link *, uint32_t *skipped);
    /* Takes a part of the picture that begin took, or of a line behind it: 0, or HAL_E_IO if the other end has gone
     * since, or HAL_E_FULL. `link` is the struct hal_link; the bytes are the caller's again on return. */
    int (*write)(void *link, const void *bytes, size_t size);
    /* Takes what the other end has sent, at most `size` bytes: how many. Nothing of one who has just come is told
     * before begin has told of him. */
    uint32_t (*read)(struct hal_link *, void *bytes, uint32_t size);
};

/* The first member of every link's own struct. */
struct hal_link {
    const struct hal_link_ops *ops;
};

#endif
