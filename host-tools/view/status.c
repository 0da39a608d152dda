/* SPDX-License-Identifier: MIT */
#include "view/status.h"

#include "glint/cli.h"
#include "view/controls.h"

#include <stdio.h>
#include <string.h>

static const char *status_name(const struct status *s, enum names_list list, uint32_t index)
{
    const char *name = names_at(s->names, list, index);
    const char *folder = name ? strrchr(name, '/') : NULL; /* of a scene file */
    return folder ? folder + 1 : name ? name : "?";
}

static const char *status_board(const struct status *s)
{
    return s->names->length ? s->names->text : "?";
}

/* Of a picture: what the device says of it. */
static void status_picture(const struct status *s, struct overlay_text *text)
{
    const struct frames_picture *p = s->picture;
    overlay_add(text, "%s by %s, budget %u/255%s", status_name(s, NAMES_SCENES, p->scene),
                status_name(s, NAMES_METHODS, p->method), p->budget, p->paused ? ", stopped" : "");
    overlay_add(text, "%ux%u %s, picture %u, %u.%03u s", p->width, p->height, cli_formats[p->format],
                (unsigned)p->number, (unsigned)(p->moment_ms / 1000), (unsigned)(p->moment_ms % 1000));
    overlay_add(text, "drawn in %u us, packed in %u us", (unsigned)p->draw_us, (unsigned)p->pack_us);
    overlay_add(text, "%u of %u triangles, %u without memory", (unsigned)p->drawn, (unsigned)p->triangles,
                (unsigned)p->dropped);
}

/* Of the last period: how they come. */
static void status_flow(const struct status *s, struct overlay_text *text)
{
    const struct meter *m = s->meter;
    const struct meter_sums *sums = &m->last;
    const double count = sums->pictures ? sums->pictures : 1, bytes = sums->bytes ? (double)sums->bytes : 1;
    const uint32_t all = sums->bands[STREAM_RAW] + sums->bands[STREAM_QOI] + sums->bands[STREAM_CHANGE];
    const double share = all ? 100. / all : 0.;
    char latency[24] = "-";
    if (m->latency_ms > 0.)
        snprintf(latency, sizeof latency, "%.1f ms", m->latency_ms);
    overlay_add(text, "%.1f pictures/s, latency %s", meter_rate(m, sums->pictures), latency);
    overlay_add(text, "%.0f bytes a picture, %.0f KB/s", (double)sums->bytes / count,
                meter_rate(m, (double)sums->bytes) / 1e3);
    overlay_add(text, "compressed %.1f:1, raw %.0f, qoi %.0f, change %.0f %%", (double)sums->plain / bytes,
                share * sums->bands[STREAM_RAW], share * sums->bands[STREAM_QOI], share * sums->bands[STREAM_CHANGE]);
    overlay_add(text, "lost here %u, left out by the device %u", (unsigned)s->lost, (unsigned)s->picture->skipped);
}

void status_figures(const struct status *s, struct overlay_text *text)
{
    if (!s->picture)
        return;
    overlay_add(text, "%s, %s", status_board(s), s->port);
    status_picture(s, text);
    status_flow(s, text);
}

void status_keys(struct overlay_text *text)
{
    for (const struct controls_help *line = controls_help; line->key; line++)
        overlay_add(text, "%-14s  %s", line->key, line->does);
}

void status_title(const struct status *s, char *title, size_t room)
{
    if (s->picture)
        snprintf(title, room, "%s, %ux%u, %.1f pictures/s - Glint", status_board(s), s->picture->width,
                 s->picture->height, meter_rate(s->meter, s->meter->last.pictures));
    else
        snprintf(title, room, "%s - Glint", s->port);
}

void status_note(struct status_notes *n, const char *text, size_t length, double now)
{
    struct status_note *last = &n->notes[STATUS_NOTES - 1];
    memmove(n->notes, n->notes + 1, sizeof n->notes - sizeof *last);
    length = length < sizeof last->text ? length : sizeof last->text - 1;
    memcpy(last->text, text, length);
    last->text[length] = 0;
    last->until = now + STATUS_NOTE_MS;
}

bool status_forget(struct status_notes *n, double now)
{
    bool any = false;
    for (unsigned i = 0; i < STATUS_NOTES; i++)
        if (n->notes[i].until != 0. && n->notes[i].until <= now) {
            n->notes[i].until = 0.;
            any = true;
        }
    return any;
}

void status_list(const struct status_notes *n, struct overlay_text *text)
{
    for (unsigned i = 0; i < STATUS_NOTES; i++)
        if (n->notes[i].until != 0.)
            overlay_add(text, "%s", n->notes[i].text);
}
