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

static void status_what(const struct status *s, struct overlay_text *text)
{
    const struct frames_picture *p = s->picture;
    char budget[24] = "";
    if (p->budget)
        snprintf(budget, sizeof budget, ", budget %u/255", p->budget);
    overlay_add(text, "%s by %s%s%s", status_name(s, NAMES_SCENES, p->scene), status_name(s, NAMES_METHODS, p->method),
                budget, p->paused ? ", stopped" : "");
}

/* What the device says of its picture. */
static void status_picture(const struct status *s, struct overlay_text *text)
{
    const struct frames_picture *p = s->picture;
    char dropped[40] = "";
    if (p->dropped)
        snprintf(dropped, sizeof dropped, ", %u without memory", (unsigned)p->dropped);
    overlay_add(text, "%ux%u %s, picture %u, %u.%03u s", p->width, p->height, cli_formats[p->format],
                (unsigned)p->number, (unsigned)(p->moment_ms / 1000), (unsigned)(p->moment_ms % 1000));
    overlay_add(text, "drawn in %u us, packed in %u us", (unsigned)p->draw_us, (unsigned)p->pack_us);
    overlay_add(text, "%u of %u triangles%s", (unsigned)p->drawn, (unsigned)p->triangles, dropped);
}

static void status_rate(const struct meter *m, struct overlay_text *text)
{
    char latency[32] = "";
    if (m->latency_ms > 0.)
        snprintf(latency, sizeof latency, ", latency %.1f ms", m->latency_ms);
    overlay_add(text, "%.1f pictures/s%s", meter_rate(m, m->last.pictures), latency);
}

/* How they came in the last period. */
static void status_flow(const struct status *s, struct overlay_text *text)
{
    const struct meter_sums *sums = &s->meter->last;
    const double kilobytes = meter_rate(s->meter, (double)sums->bytes) / 1e3;
    const double ratio = (double)sums->plain / (double)(sums->bytes ? sums->bytes : 1);
    const uint32_t all = sums->bands[STREAM_RAW] + sums->bands[STREAM_QOI] + sums->bands[STREAM_CHANGE];
    const double share = all ? 100. / all : 0.;
    const unsigned lost = (unsigned)s->lost, skipped = (unsigned)s->picture->skipped;
    if (sums->pictures && s->details) {
        overlay_add(text, "%.0f bytes a picture, %.0f KB/s", (double)sums->bytes / sums->pictures, kilobytes);
        overlay_add(text, "compressed %.1f:1, raw %.0f, qoi %.0f, change %.0f %%", ratio,
                    share * sums->bands[STREAM_RAW], share * sums->bands[STREAM_QOI],
                    share * sums->bands[STREAM_CHANGE]);
    } else if (sums->pictures) {
        overlay_add(text, "%.0f KB/s, %.1f:1, lost %u, left out %u", kilobytes, ratio, lost, skipped);
    }
    if (s->details)
        overlay_add(text, "lost here %u, left out by the device %u", lost, skipped);
}

void status_figures(const struct status *s, struct overlay_text *text)
{
    if (!s->picture)
        return;
    if (s->details)
        overlay_add(text, "%s, %s", status_board(s), s->port);
    status_what(s, text);
    if (s->details)
        status_picture(s, text);
    status_rate(s->meter, text);
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
