/* SPDX-License-Identifier: MIT */
/* The film's picture number n is that which the device shows at n / rate, to the nearest: half a picture's time is room
 * for times that are not quite regular. hal/host/y4m.c keeps the picture, so that it can be written again. */
#include "view/record_kinds.h"
#include "view/unpack.h"

static int y4m_until(struct record *r, uint64_t pictures)
{
    int result = 0;
    for (; r->written < pictures && !result; r->written++)
        result = r->host.display.ops->frame_end(&r->host.display);
    return result;
}

/* at_us counts gaps of 2 s, 2^32 of them at the most: below 2^53, times the rate below 2^63. */
static uint64_t y4m_number(const struct record *r, uint64_t at_us)
{
    return (at_us * r->host.rate + 500000) / 1000000;
}

static int y4m_picture(struct record *r, const struct frames_picture *p)
{
    int result = y4m_until(r, y4m_number(r, r->at_us));
    uint32_t stride = (uint32_t)unpack_row_bytes(p->format, p->width);
    return result ? result : r->host.display.ops->flush(&r->host.display, p->pixels, 0, p->height, stride);
}

static int y4m_end(struct record *r, uint64_t end_us)
{
    uint64_t number = y4m_number(r, end_us), least = (uint64_t)r->written + 1;
    return y4m_until(r, number > least ? number : least);
}

const struct record_kind y4m_kind = {{"y4m"}, &y4m_display, y4m_picture, y4m_end};
