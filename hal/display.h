/* SPDX-License-Identifier: MIT */
/*
 * A display: where the bands of a frame go. A port fills in the table; the null display in hal/host/ is the guide.
 * Calls come in the order open, (frame_begin, flush..., frame_end)..., close. Each returns 0 or a negative HAL_E code;
 * after an error only close is called.
 */
#ifndef HAL_DISPLAY_H
#define HAL_DISPLAY_H

#include <stdint.h>

enum hal_error {
    HAL_E_ARGUMENT = -1, /* a size, format or option that this display does not take */
    HAL_E_IO = -2,       /* the device or file failed; errno says how on a machine that has one */
    HAL_E_FULL = -3,     /* no room left */
};

enum hal_pixel_format { HAL_RGB565, HAL_RGB888, HAL_GREY8, HAL_GREY4 }; /* bits as in glint.h */

struct hal_display;

struct hal_display_ops {
    /* Prepare for pictures of this size and format. */
    int (*open)(struct hal_display *, uint16_t width, uint16_t height, enum hal_pixel_format);
    /* A picture begins; it will be shown for `delay_ms` if this display keeps time. Optional. */
    int (*frame_begin)(struct hal_display *, uint32_t index, uint32_t delay_ms);
    /* Take rows y .. y + rows - 1, top to bottom. May return while the pixels are still on their way: the caller then
     * leaves them alone until the next flush, frame_begin or close returns. Never two bands in flight. */
    int (*flush)(struct hal_display *, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride);
    /* The picture is complete; its last band may still be on its way. Optional. */
    int (*frame_end)(struct hal_display *);
    /* Finish: keep == 0 discards what was made (an error elsewhere). Called once, after open succeeded. */
    int (*close)(struct hal_display *, int keep);
};

/* The first member of every display's own struct. */
struct hal_display {
    const struct hal_display_ops *ops;
};

#endif
