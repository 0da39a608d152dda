/* SPDX-License-Identifier: MIT */
#include "view/meter.h"

#include "view/unpack.h"

#include <string.h>

void meter_picture(struct meter *m, const struct frames_picture *p, double now)
{
    if (m->turned == 0.)
        m->turned = now;
    m->at = now;
    if (m->from == 0.) {
        m->from = now;
        return;
    }
    m->now.pictures++;
    m->now.bytes += p->bytes;
    m->now.plain += unpack_row_bytes(p->format, p->width) * p->height;
    for (unsigned i = 0; i < STREAM_CODECS; i++)
        m->now.bands[i] += p->bands[i];
}

bool meter_turn(struct meter *m, double now)
{
    if (m->turned == 0. || now - m->turned < METER_PERIOD_MS)
        return false;
    m->turned = now;
    bool silent = now - m->at >= METER_SILENT_MS;
    if (m->now.pictures || silent) {
        m->last = m->now;
        m->period_ms = m->at - m->from;
        m->now = (struct meter_sums){0};
        m->from = silent ? 0. : m->at;
    }
    return true;
}

double meter_rate(const struct meter *m, double count)
{
    return m->period_ms > 0. ? count * 1e3 / m->period_ms : 0.;
}

void meter_sent(struct meter *m, uint16_t sequence, double now)
{
    m->sent[m->place].sequence = sequence;
    m->sent[m->place].at = now;
    m->place = (m->place + 1) % METER_REQUESTS;
}

void meter_shown(struct meter *m, const struct frames_picture *p, double now)
{
    if (p->echo == m->echo)
        return;
    m->echo = p->echo;
    for (unsigned i = 0; i < METER_REQUESTS; i++)
        if (p->echo && m->sent[i].sequence == p->echo)
            m->latency_ms = now - m->sent[i].at;
}

void meter_restart(struct meter *m)
{
    memset(m->sent, 0, sizeof m->sent);
    m->echo = 0;
    m->latency_ms = 0.;
}
