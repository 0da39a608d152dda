/* SPDX-License-Identifier: MIT */
#include "view/playback.h"

uint32_t playback_gap(uint32_t from_us, uint32_t to_us)
{
    uint32_t gap = (uint32_t)(((uint64_t)to_us + (UINT64_C(1) << 32) - from_us) & UINT32_MAX);
    return gap < PLAYBACK_GAP_US ? gap : PLAYBACK_GAP_US;
}

uint32_t playback_wait(const struct playback *p, uint32_t time_us, uint64_t now_us)
{
    if (!p->started || p->step)
        return 0;
    if (p->paused)
        return PLAYBACK_NEVER;
    uint64_t due = p->clock_us + playback_gap(p->time_us, time_us);
    return due > now_us ? (uint32_t)(due - now_us) : 0;
}

/* From the moment it was due, not from that at which it was shown: small delays do not add up. */
void playback_shown(struct playback *p, uint32_t time_us, uint64_t now_us)
{
    uint64_t due = p->clock_us + playback_gap(p->time_us, time_us);
    bool anew = !p->started || p->step || now_us > due + PLAYBACK_SLACK_US;
    p->clock_us = anew ? now_us : due;
    p->time_us = time_us;
    p->pause_us = now_us;
    p->started = true;
    p->step = false;
}

void playback_pause(struct playback *p, bool paused, uint64_t now_us)
{
    if (p->paused && !paused)
        p->clock_us += now_us - p->pause_us;
    else if (paused && !p->paused)
        p->pause_us = now_us;
    p->paused = paused;
    p->step = false;
}

void playback_step(struct playback *p)
{
    p->step = p->paused;
}
