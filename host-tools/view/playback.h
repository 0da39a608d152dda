/* SPDX-License-Identifier: MIT */
/*
 * When the pictures of a recording are to be shown: as far apart as the device drew them. Nothing here waits or looks
 * at a clock; `now_us` is the caller's, steady and of any origin.
 */
#ifndef VIEW_PLAYBACK_H
#define VIEW_PLAYBACK_H

#include <stdbool.h>
#include <stdint.h>

#define PLAYBACK_GAP_US   2000000u /* a longer gap is cut to this: a device that was off, or asked for nothing */
#define PLAYBACK_SLACK_US 100000u  /* a picture that is later than this moves all after it; an earlier one does not */
#define PLAYBACK_NEVER    UINT32_MAX

/* All zero at first, and to begin anew. */
struct playback {
    bool started, paused, step;
    uint32_t time_us;  /* the device's, of the last picture shown */
    uint64_t clock_us; /* when that was due */
    uint64_t pause_us; /* since when it is paused */
};

/* Microseconds between two of a device's times, which count modulo 2^32. */
uint32_t playback_gap(uint32_t from_us, uint32_t to_us);

/* Microseconds to wait before the picture of this time is shown: 0: now, and playback_shown() is to be told;
 * PLAYBACK_NEVER: until playback goes on. */
uint32_t playback_wait(const struct playback *playback, uint32_t time_us, uint64_t now_us);
void playback_shown(struct playback *playback, uint32_t time_us, uint64_t now_us);

/* What was left of the wait when it began is waited for after a pause. */
void playback_pause(struct playback *playback, bool paused, uint64_t now_us);

/* While paused: lets one picture through. */
void playback_step(struct playback *playback);

#endif
