/* SPDX-License-Identifier: MIT */
#include "view/session.h"

#include "glint/cli.h"
#include "scene/scene.h"
#include "view/dump.h"
#include "view/unpack.h"
#include "view/words.h"

#include <stdio.h>

#define SESSION_WAIT_MS  100   /* between looks at the clock */
#define SESSION_POLL_MS  1000. /* until a device that has not answered is asked again: for each picture, */
#define SESSION_AGAIN_MS 250.  /* or one that sends them anyway, for a key frame or what else is wanted */

static bool session_enough(const struct session *s)
{
    return s->code != CLI_DONE || ferror(stdout) || (s->options->frames && s->pictures >= s->options->frames);
}

/* What a picture shows is asked for no more where there is a window: the device's own buttons may change it again. */
static bool session_obeyed(struct session *s, const struct frames_picture *p)
{
    const uint32_t shown[SESSION_WISHES] = {p->budget, p->paused, p->scene, p->method};
    bool all = (!s->options->scene && !s->options->method) || s->names.length;
    for (unsigned i = 0; i < SESSION_WISHES; i++)
        if (s->wishes[i] == shown[i] && s->live.window)
            s->wishes[i] = OPTIONS_NONE;
        else if (s->wishes[i] != shown[i] && s->wishes[i] != OPTIONS_NONE)
            all = false;
    return all;
}

/* Each line as its picture comes: behind a pipe, too, somebody waits for it, or does no longer. */
static void session_trace(const struct frames_picture *p)
{
    size_t bytes = unpack_row_bytes(p->format, p->width) * p->height;
    printf("%u: %ux%u %s%s, moment %u ms, %u bytes, drawn in %u us, packed in %u us, %u of %u triangles, %u dropped, "
           "%u skipped, crc %08X\n",
           (unsigned)p->number, p->width, p->height, cli_formats[p->format], p->key ? ", key" : "",
           (unsigned)p->moment_ms, (unsigned)p->bytes, (unsigned)p->draw_us, (unsigned)p->pack_us, (unsigned)p->drawn,
           (unsigned)p->triangles, (unsigned)p->dropped, (unsigned)p->skipped,
           (unsigned)scene_crc32(0, p->pixels, bytes));
    fflush(stdout);
}

static void session_picture(void *context, const struct frames_picture *p)
{
    struct session *s = context;
    const struct options *o = s->options;
    s->obeyed = session_obeyed(s, p);
    s->counts = s->obeyed || (s->counts && s->live.window);
    if (s->live.window)
        live_picture(s, p);
    if (session_enough(s) || !s->counts)
        return;
    s->counted += p->bytes;
    if (o->dump && s->pictures == 0)
        s->code = dump_folder(o->dump);
    if (o->dump && s->code == CLI_DONE)
        s->code = dump_picture(o->dump, s->pictures, p);
    int recorded = s->code ? s->code : record_picture(&s->record, p);
    if (recorded && !live_film_ended(&s->live))
        s->code = recorded;
    s->pictures++;
    if (o->trace)
        session_trace(p);
}

static void session_log(void *context, const char *text, uint32_t length)
{
    struct session *s = context;
    fprintf(stderr, "%s: ", s->port.name);
    words_put(stderr, text, length);
    fputc('\n', stderr);
    if (s->live.window)
        live_log(&s->live, text, length);
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
    if (first && s->options->names) {
        names_print(&s->names);
        fflush(stdout); /* a signal may end this before anything else does */
    }
    if (!first && s->live.window) /* which may have asked for others since */
        return;
    session_choose(s, NAMES_SCENES, s->options->scene, &s->wishes[SESSION_SCENE]);
    session_choose(s, NAMES_METHODS, s->options->method, &s->wishes[SESSION_METHOD]);
}

void session_send(struct session *s, enum stream_type type, uint32_t value)
{
    if (!s->port.asks || !s->port.there || s->ended || s->code != CLI_DONE)
        return;
    s->code = port_ask(&s->port, type, value);
    meter_sent(&s->live.meter, s->port.sequence, cli_clock());
}

void session_wish(struct session *s, enum session_wish wish, uint32_t value)
{
    s->wishes[wish] = value;
    s->obeyed = false;
    if (!s->port.polls) /* which is asked after its next picture anyway */
        s->asked = 0.;
}

/* For a picture, if none would come; and for what is wanted of it, until one shows that all of it has been heard. */
static void session_ask(struct session *s)
{
    static const enum stream_type types[SESSION_WISHES] = {STREAM_BUDGET, STREAM_PAUSE, STREAM_SCENE, STREAM_METHOD};
    for (unsigned i = 0; i < SESSION_WISHES && !s->obeyed; i++)
        if (s->wishes[i] != OPTIONS_NONE)
            session_send(s, types[i], s->wishes[i]);
    if (s->port.polls || s->frames.want_key)
        session_send(s, STREAM_KEY_PLEASE, 0);
}

/* A device has come: all that was heard is of another. It is asked at once. */
static void session_connect(struct session *s)
{
    frames_restart(&s->frames);
    meter_restart(&s->live.meter);
    s->connections = s->port.connections;
    s->obeyed = false;
    s->asked = 0.;
}

/* One that sends only when asked is asked for each picture; any, when it owes an answer. */
static void session_request(struct session *s)
{
    const struct port *port = &s->port;
    double now = cli_clock();
    bool due = now - s->asked >= (port->polls ? SESSION_POLL_MS : SESSION_AGAIN_MS);
    if (!port->asks || !port->there)
        return;
    if (port->polls ? due || s->seen != s->frames.pictures : due && (s->frames.want_key || !s->obeyed)) {
        session_ask(s);
        s->seen = s->frames.pictures;
        s->asked = now;
    }
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
static bool session_hear(struct session *s)
{
    long count = port_read(&s->port, s->bytes, sizeof s->bytes, s->live.window ? LIVE_WAIT_MS : SESSION_WAIT_MS);
    if (count == PORT_FAILED)
        s->code = CLI_IO;
    s->at = 0;
    s->count = count > 0 ? (size_t)count : 0;
    if (count > 0) {
        s->code = s->code ? s->code : save_bytes(&s->save, s->bytes, s->count);
        s->asked = s->port.polls && s->frames.parser.count ? cli_clock() : s->asked; /* it is answering */
    }
    return count >= 0;
}

/* False if there is nothing more to do. */
static bool session_step(struct session *s)
{
    bool window = s->live.window;
    if (s->connections != s->port.connections)
        session_connect(s);
    session_request(s);
    if (s->at == s->count && !s->ended && !live_holds(s) && !session_hear(s)) {
        frames_finish(&s->frames);
        s->ended = true;
    }
    while (s->at < s->count && !live_holds(s)) {
        size_t size = s->count - s->at < LIVE_SLICE || !window ? s->count - s->at : LIVE_SLICE;
        frames_push(&s->frames, s->bytes + s->at, size);
        s->at += size;
    }
    if (s->code == CLI_DONE && session_silent(s)) {
        port_missing(&s->port);
        s->code = CLI_IO;
    }
    if (window && (!s->ended || s->frames.pictures)) /* the last picture stays; without any there is nothing to see */
        return live_step(s);
    return !s->ended;
}

/* What came of it: one line, and the exit code. */
static int session_tell(const struct session *s)
{
    const struct frames *f = &s->frames;
    uint32_t pictures = s->pictures;
    if (s->live.window && !s->ended && pictures == 0) /* closed while it waited */
        return CLI_DONE;
    if (f->parser.out_of_memory) {
        fprintf(stderr, "%s: out of memory\n", s->port.name);
        return CLI_IO;
    }
    if (f->parser.messages == 0 && !f->parser.other_version) {
        fprintf(stderr, "%s: is no stream\n", s->port.name);
        return CLI_BAD_DATA;
    }
    if (pictures == 0 || pictures < s->options->frames) {
        fprintf(stderr, "%s: %s%u picture%s in the stream, %u lost%s\n", s->port.name, pictures ? "only " : "",
                (unsigned)pictures, pictures == 1 ? "" : "s", (unsigned)f->lost,
                f->parser.other_version ? "; part of it is of another version" : "");
        return CLI_BAD_DATA;
    }
    printf("%u picture%s, %u bytes each, %u lost\n", (unsigned)pictures, pictures == 1 ? "" : "s",
           (unsigned)((s->counted + pictures / 2) / pictures), (unsigned)f->lost);
    return CLI_DONE;
}

static int session_open(struct session *s, const struct options *o)
{
    const struct frames_events events = {session_picture, session_hello, session_log, s};
    bool asking = o->scene || o->method || o->budget != OPTIONS_NONE || o->pause != OPTIONS_NONE;
    s->options = o;
    s->wishes[SESSION_BUDGET] = o->budget;
    s->wishes[SESSION_PAUSE] = o->pause;
    s->wishes[SESSION_SCENE] = s->wishes[SESSION_METHOD] = OPTIONS_NONE;
    s->heard = cli_clock();
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
    if (!code && !o->headless)
        code = live_open(s);
    return code;
}

int session_keep(struct session *s)
{
    int recorded = record_close(&s->record, true), saved = save_close(&s->save);
    return recorded ? recorded : saved;
}

int session_run(struct session *s, const struct options *options)
{
    s->code = session_open(s, options);
    while (!session_enough(s) && !cli_interrupted() && !s->frames.parser.out_of_memory && session_step(s))
        ;
    int code = s->code;
    if (!code && !cli_interrupted() && !ferror(stdout)) /* which the caller tells */
        code = session_tell(s);
    int kept = session_keep(s);
    code = code ? code : kept;
    live_close(&s->live);
    frames_close(&s->frames);
    if (s->port.ops)
        port_close(&s->port);
    return code;
}
