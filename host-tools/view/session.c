/* SPDX-License-Identifier: MIT */
#include "view/session.h"

#include "glint/cli.h"
#include "scene/scene.h"
#include "view/dump.h"
#include "view/unpack.h"
#include "view/words.h"

#include <stdio.h>

#define SESSION_WAIT_MS  100   /* between looks at the clock */
#define SESSION_AGAIN_MS 1000. /* until a device that has not answered is asked again */
#define SESSION_KEY_MS   250.  /* the same for one that sends all the time */

static bool session_enough(const struct session *s)
{
    return s->code != CLI_DONE || (s->options->frames && s->pictures >= s->options->frames);
}

static bool session_obeyed(uint32_t asked, uint32_t is)
{
    return asked == OPTIONS_NONE || asked == is;
}

static void session_trace(const struct frames_picture *p)
{
    size_t bytes = unpack_row_bytes(p->format, p->width) * p->height;
    printf("%u: %ux%u %s%s, moment %u ms, %u bytes, drawn in %u us, packed in %u us, %u of %u triangles, %u dropped, "
           "crc %08X\n",
           (unsigned)p->number, p->width, p->height, cli_formats[p->format], p->key ? ", key" : "",
           (unsigned)p->moment_ms, (unsigned)p->bytes, (unsigned)p->draw_us, (unsigned)p->pack_us, (unsigned)p->drawn,
           (unsigned)p->triangles, (unsigned)p->dropped, (unsigned)scene_crc32(0, p->pixels, bytes));
}

static void session_picture(void *context, const struct frames_picture *p)
{
    struct session *s = context;
    const struct options *o = s->options;
    s->obeyed = ((!o->scene && !o->method) || s->names.length) && session_obeyed(s->scene, p->scene) &&
                session_obeyed(s->method, p->method) && session_obeyed(o->budget, p->budget) &&
                session_obeyed(o->pause, p->paused);
    if (session_enough(s) || !s->obeyed)
        return;
    s->bytes += p->bytes;
    if (o->dump && s->pictures == 0)
        s->code = dump_folder(o->dump);
    if (o->dump && s->code == CLI_DONE)
        s->code = dump_picture(o->dump, s->pictures, p);
    if (s->code == CLI_DONE)
        s->code = record_picture(&s->record, p);
    s->pictures++;
    if (o->trace)
        session_trace(p);
}

static void session_log(void *context, const char *text, uint32_t length)
{
    const struct session *s = context;
    fprintf(stderr, "%s: ", s->port.name);
    words_put(stderr, text, length);
    fputc('\n', stderr);
}

static void session_choose(struct session *s, enum names_list list, const char *name, uint32_t *place)
{
    if (!name || s->code != CLI_DONE)
        return;
    *place = names_find(&s->names, list, name);
    if (!names_at(&s->names, list, *place)) {
        fprintf(stderr, "%s: the device has no %s '%s'; --names lists them\n", s->port.name,
                list == NAMES_METHODS ? "method" : "scene", name);
        s->code = CLI_BAD_USAGE;
    }
}

static void session_hello(void *context, const char *text, uint32_t length)
{
    struct session *s = context;
    bool first = s->names.length == 0;
    names_set(&s->names, text, length);
    if (first && s->options->names)
        names_print(&s->names);
    session_choose(s, NAMES_SCENES, s->options->scene, &s->scene);
    session_choose(s, NAMES_METHODS, s->options->method, &s->method);
}

/* For a picture; and for what is wanted of it, until one shows that all of it has been heard. */
static int session_ask(struct session *s)
{
    const struct {
        enum stream_type type;
        uint32_t value;
    } wishes[] = {{STREAM_BUDGET, s->options->budget},
                  {STREAM_PAUSE, s->options->pause},
                  {STREAM_SCENE, s->scene},
                  {STREAM_METHOD, s->method}};
    int code = CLI_DONE;
    for (unsigned i = 0; i < sizeof wishes / sizeof *wishes && !code && !s->obeyed; i++)
        if (wishes[i].value != OPTIONS_NONE)
            code = port_ask(&s->port, wishes[i].type, wishes[i].value);
    return !code && (s->port.polls || s->frames.want_key) ? port_ask(&s->port, STREAM_KEY_PLEASE, 0) : code;
}

/* One that sends only when asked is asked for each picture; any, when it has not answered. */
static bool session_wants(const struct session *s, double now)
{
    if (s->port.polls)
        return s->seen != s->frames.pictures || now - s->asked >= SESSION_AGAIN_MS;
    return s->port.asks && s->port.there && (s->frames.want_key || !s->obeyed) && now - s->asked >= SESSION_KEY_MS;
}

/* A device has come: all that was heard is of another. It is asked at once. */
static void session_connect(struct session *s)
{
    frames_restart(&s->frames);
    s->connections = s->port.connections;
    s->obeyed = false;
    s->asked = cli_clock() - SESSION_AGAIN_MS;
}

/* True if nobody has said anything for too long. */
static bool session_silent(struct session *s)
{
    double now = cli_clock();
    if (s->messages != s->frames.parser.messages)
        s->heard = now;
    s->messages = s->frames.parser.messages;
    return s->port.asks && s->options->wait && now - s->heard >= 1000. * s->options->wait;
}

/* What the port has to say: false if nothing will follow. */
static bool session_step(struct session *s)
{
    static uint8_t bytes[65536];
    double now = cli_clock();
    if (s->connections != s->port.connections)
        session_connect(s);
    if (session_wants(s, now)) {
        s->code = session_ask(s);
        s->seen = s->frames.pictures;
        s->asked = now;
    }
    long count = port_read(&s->port, bytes, sizeof bytes, SESSION_WAIT_MS);
    if (count == PORT_FAILED)
        s->code = CLI_IO;
    if (count > 0) {
        s->code = s->code ? s->code : save_bytes(&s->save, bytes, (size_t)count);
        frames_push(&s->frames, bytes, (size_t)count);
        s->asked = s->port.polls && s->frames.parser.count ? cli_clock() : s->asked; /* it is answering */
    }
    if (s->code == CLI_DONE && session_silent(s)) {
        port_missing(&s->port);
        s->code = CLI_IO;
    }
    return count >= 0;
}

/* What came of it: one line, and the exit code. */
static int session_tell(const struct session *s)
{
    const struct frames *f = &s->frames;
    uint32_t pictures = s->pictures;
    if (f->parser.out_of_memory) {
        fprintf(stderr, "%s: out of memory\n", s->port.name);
        return CLI_IO;
    }
    if (pictures == 0 || pictures < s->options->frames) {
        fprintf(stderr, "%s: %s%u picture%s in the stream, %u lost%s\n", s->port.name, pictures ? "only " : "",
                (unsigned)pictures, pictures == 1 ? "" : "s", (unsigned)f->lost,
                f->parser.other_version ? "; part of it is of another version" : "");
        return CLI_BAD_DATA;
    }
    printf("%u picture%s, %u bytes each, %u lost\n", (unsigned)pictures, pictures == 1 ? "" : "s",
           (unsigned)((s->bytes + pictures / 2) / pictures), (unsigned)f->lost);
    return CLI_DONE;
}

static int session_open(struct session *s, const struct options *o)
{
    const struct frames_events events = {session_picture, session_hello, session_log, s};
    bool asking = o->scene || o->method || o->budget != OPTIONS_NONE || o->pause != OPTIONS_NONE;
    s->options = o;
    s->scene = s->method = OPTIONS_NONE;
    s->heard = cli_clock();
    s->asked = s->heard - SESSION_AGAIN_MS;
    cli_catch_signals();
    s->save.path = o->save;
    s->record.rate = o->record_fps;
    int code = o->record ? record_open(&s->record, o->record) : CLI_DONE;
    if (!code)
        code = port_open(&s->port, o->input, o->serial);
    if (!code && asking && !s->port.asks)
        code = cli_usage(OPTIONS_NAME, "%s is no device that could be asked for a scene, method, budget or pause",
                         s->port.name);
    if (!code)
        frames_open(&s->frames, &events);
    return code;
}

int session_run(struct session *s, const struct options *options)
{
    int code = session_open(s, options);
    if (code)
        return code;
    while (!session_enough(s) && !cli_interrupted() && !s->frames.parser.out_of_memory && session_step(s))
        ;
    frames_finish(&s->frames);
    code = s->code;
    if (!code && !cli_interrupted())
        code = session_tell(s);
    int recorded = record_close(&s->record, true), saved = save_close(&s->save);
    code = code ? code : recorded ? recorded : saved;
    frames_close(&s->frames);
    port_close(&s->port);
    return code;
}
