/* SPDX-License-Identifier: MIT */
/* How fast pictures come, in how many bytes, and how late. Times are milliseconds of a steady clock, handed in. */
#ifndef VIEW_METER_H
#define VIEW_METER_H

#include "view/frames.h"

#define METER_PERIOD_MS 500.  /* figures are of a period, so that they can be read */
#define METER_SILENT_MS 2000. /* without a picture: until then the last figures hold */
#define METER_REQUESTS  16u

/* Of the pictures that came in a period, from one to another: that which it begins with is none of them. */
struct meter_sums {
    uint32_t pictures;
    uint64_t bytes; /* as sent */
    uint64_t plain; /* the pictures' pixels */
    uint32_t bands[STREAM_CODECS];
};

struct meter {
    double turned;          /* the last look that ended a period, at first the first picture; 0: none so far */
    double from, at;        /* the pictures that `now` begins with (0: the next one) and has last */
    struct meter_sums now;  /* under way */
    struct meter_sums last; /* the last whole period, and how long it was */
    double period_ms;       /* 0: none */
    struct {                /* the last requests */
        uint16_t sequence;  /* 0: none */
        double at;
    } sent[METER_REQUESTS];
    unsigned place;    /* in `sent`, of the next */
    uint16_t echo;     /* of the last picture shown */
    double latency_ms; /* from a request to the first picture shown that answers it; 0: none so far */
};

void meter_picture(struct meter *meter, const struct frames_picture *picture, double now);

/* True when a period has ended: `last` may be new. */
bool meter_turn(struct meter *meter, double now);

/* Of the last period; 0 without one. */
double meter_rate(const struct meter *meter, double count); /* a second, of what there was `count` of */

/* A request has been sent; a picture is on the screen. */
void meter_sent(struct meter *meter, uint16_t sequence, double now);
void meter_shown(struct meter *meter, const struct frames_picture *picture, double now);

/* Another device, or the same again: what was sent before is never answered. */
void meter_restart(struct meter *meter);

#endif
