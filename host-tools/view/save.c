/* SPDX-License-Identifier: MIT */
#include "view/save.h"

#include "glint/cli.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static int save_problem(struct save *s)
{
    fprintf(stderr, "%s: %s\n", s->path, strerror(errno ? errno : EIO));
    if (s->open)
        sink_close(&s->sink, 0);
    *s = (struct save){0};
    return CLI_IO;
}

int save_bytes(struct save *s, const void *bytes, size_t size)
{
    if (!s->path)
        return CLI_DONE;
    errno = 0;
    if (!s->open && !(s->open = sink_open(&s->sink, s->path) == 0))
        return save_problem(s);
    return sink_write(&s->sink, bytes, size) ? save_problem(s) : CLI_DONE;
}

int save_close(struct save *s)
{
    int result = s->open ? sink_close(&s->sink, 1) : 0;
    s->open = false;
    return result ? save_problem(s) : CLI_DONE;
}
