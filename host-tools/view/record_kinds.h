/* SPDX-License-Identifier: MIT */
/* What record.c asks of a kind of film. All return 0 or as hal/display.h does. */
#ifndef VIEW_RECORD_KINDS_H
#define VIEW_RECORD_KINDS_H

#include "view/record.h"

struct record_kind {
    const char *endings[2];
    const struct hal_display_ops *ops; /* opens and closes record->host */
    /* The display is open; record->at_us is when this picture begins. */
    int (*picture)(struct record *record, const struct frames_picture *picture);
    /* The last picture ends at `end_us`. */
    int (*end)(struct record *record, uint64_t end_us);
};

extern const struct record_kind apng_kind, y4m_kind;

#endif
