/* SPDX-License-Identifier: MIT */
#include "view/record.h"

#include "glint/cli.h"
#include "view/playback.h"
#include "view/record_kinds.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct record_kind *record_find(const char *path)
{
    enum { KINDS = 2 };
    static const struct record_kind *const kinds[KINDS] = {&apng_kind, &y4m_kind};
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    for (size_t i = 0; dot && (!slash || dot > slash + 1) && i < KINDS; i++)
        for (unsigned k = 0; k < 2 && kinds[i]->endings[k]; k++)
            if (dot > path && strcmp(dot + 1, kinds[i]->endings[k]) == 0)
                return kinds[i];
    return NULL;
}

static int record_problem(const char *path, int result)
{
    const char *reason = result == HAL_E_FULL ? "out of memory"
                         : errno == ESPIPE    ? "is no file; an animated PNG needs one, a .y4m does not"
                                              : strerror(errno ? errno : EIO);
    fprintf(stderr, "%s: %s\n", path, reason);
    return CLI_IO;
}

int record_open(struct record *r, const char *path)
{
    *r = (struct record){.rate = r->rate, .kind = record_find(path)};
    if (!r->kind) {
        fprintf(stderr, "%s: a recording ends in .png, .apng or .y4m\n", path);
        return CLI_BAD_USAGE;
    }
    r->path = path;
    return CLI_DONE;
}

/* Not kept after an error. */
static int record_end(struct record *r, bool keep)
{
    int result = 0;
    if (keep)
        result = r->kind->end(r, r->at_us + r->gap_us);
    int reason = errno;
    int closed = r->host.display.ops->close(&r->host.display, keep && !result);
    errno = result ? reason : errno;
    return result ? result : closed;
}

int record_close(struct record *r, bool keep)
{
    const char *path = r->path;
    int result = 0;
    errno = 0;
    if (path && r->pictures)
        result = record_end(r, keep);
    free(r->held);
    free(r->before);
    *r = (struct record){.rate = r->rate};
    return keep && result ? record_problem(path, result) : CLI_DONE;
}

static int record_begin(struct record *r, const struct frames_picture *p)
{
    r->host = (struct host_display){.display.ops = r->kind->ops,
                                    .path = r->path,
                                    .frames = HOST_FRAMES_ANY,
                                    .rate = r->rate ? r->rate : RECORD_RATE};
    return r->kind->ops->open(&r->host.display, p->width, p->height, (enum hal_pixel_format)p->format);
}

static int record_changed(struct record *r, const struct frames_picture *p)
{
    fprintf(stderr, "%s: ends here, %ux%u %s: the pictures are %ux%u %s from now on\n", r->path, r->host.width,
            r->host.height, cli_formats[r->host.format], p->width, p->height, cli_formats[p->format]);
    int code = record_close(r, true);
    return code ? code : CLI_BAD_DATA;
}

int record_picture(struct record *r, const struct frames_picture *p)
{
    int result = 0;
    if (!r->path)
        return CLI_DONE;
    if (r->pictures &&
        (p->width != r->host.width || p->height != r->host.height || p->format != (enum stream_format)r->host.format))
        return record_changed(r, p);
    errno = 0;
    if (r->pictures == 0)
        result = record_begin(r, p);
    if (!result) {
        r->gap_us = r->pictures ? playback_gap(r->time_us, p->time_us) : 0;
        r->at_us += r->gap_us;
        r->time_us = p->time_us;
        r->pictures++;
        result = r->kind->picture(r, p);
    }
    if (!result)
        return CLI_DONE;
    record_problem(r->path, result);
    record_close(r, false);
    return CLI_IO;
}
