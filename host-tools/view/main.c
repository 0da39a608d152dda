/* SPDX-License-Identifier: MIT */
/* glint-view: the pictures of a stream. */
#include "glint/cli.h"
#include "view/dump.h"
#include "view/frames.h"
#include "view/port.h"
#include "view/words.h"

#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#define MAIN_WAIT_MS  100   /* between looks at the clock */
#define MAIN_AGAIN_MS 1000. /* until a device that has not answered is asked again */
#define MAIN_NONE     UINT32_MAX

static const char main_name[] = "glint-view";

static const char main_help[] =
    "usage: glint-view INPUT [OPTION]...\n\n"
    "Takes pictures from a device's stream: `glint render --stream`, or a board's serial line.\n\n"
    "INPUT is file:PATH for a recording, - for standard input, or a serial port as /dev/ttyUSB0 (115200 baud), which "
    "is\n"
    "asked for each picture. Only whole pictures are taken; one that was damaged on the way is left out.\n\n"
    "      --dump DIR         write them to DIR/frame-0000.png and so on\n"
    "      --frames N         end after N pictures, 1..1000000; the default is all\n"
    "      --headless         open no window, which it does not so far: pictures are written, counted and listed\n"
    "      --list             print a line for each\n"
    "      --names            print what the device offers: scenes and methods\n"
    "      --scene NAME       let the device show a scene,\n"
    "      --method NAME      by a method,\n"
    "      --budget N         with a budget of N, 1..255\n"
    "      --pause, --run     stop its animation, or let it go on\n"
    "      --help\n\n"
    "Exit code: 0 done, 1 no picture, or fewer than asked for, 2 bad usage, 3 device or I/O.\n";

struct view {
    struct frames frames;
    struct port port;
    const char *dump, *scene, *method;
    uint32_t frames_wanted; /* 0: all */
    /* asked of the device, by place in its lists, or MAIN_NONE: pictures from before it obeyed do not count */
    uint32_t scene_index, method_index, budget, pause;
    bool obeyed; /* by the last picture, in all of these */
    bool list, names, named;
    uint32_t pictures; /* that count */
    uint64_t bytes;
    int code;
};

static bool main_enough(const struct view *view)
{
    return view->code != CLI_DONE || (view->frames_wanted && view->pictures >= view->frames_wanted);
}

static bool main_obeyed(uint32_t asked, uint32_t is)
{
    return asked == MAIN_NONE || asked == is;
}

static void main_picture(void *context, const struct frames_picture *p)
{
    struct view *view = context;
    view->obeyed = ((!view->scene && !view->method) || view->named) && main_obeyed(view->scene_index, p->scene) &&
                   main_obeyed(view->method_index, p->method) && main_obeyed(view->budget, p->budget) &&
                   main_obeyed(view->pause, p->paused);
    if (main_enough(view) || !view->obeyed)
        return;
    view->bytes += p->bytes;
    if (view->dump && view->pictures == 0)
        view->code = dump_folder(view->dump);
    if (view->dump && view->code == CLI_DONE)
        view->code = dump_picture(view->dump, view->pictures, p);
    view->pictures++;
    if (view->list)
        printf(
            "%u: %ux%u %s%s, moment %u ms, %u bytes, drawn in %u us, packed in %u us, %u of %u triangles, %u dropped\n",
            (unsigned)p->number, p->width, p->height, cli_formats[p->format], p->key ? ", key" : "",
            (unsigned)p->moment_ms, (unsigned)p->bytes, (unsigned)p->draw_us, (unsigned)p->pack_us, (unsigned)p->drawn,
            (unsigned)p->triangles, (unsigned)p->dropped);
}

static void main_log(void *context, const char *text, uint32_t length)
{
    const struct view *view = context;
    fprintf(stderr, "%s: ", view->port.name);
    words_put(stderr, text, length);
    fputc('\n', stderr);
}

static void main_print(const char *kind, const char *name)
{
    printf("%s ", kind);
    words_put(stdout, name, strlen(name));
    putchar('\n');
}

/* Prints hello's names, or finds one in its list `wanted` (0: scenes, 1: methods): its index, or MAIN_NONE. */
static uint32_t main_names(const char *text, uint32_t length, unsigned wanted, const char *name)
{
    const char *at = text + strlen(text) + 1, *end = text + length;
    unsigned list = 0;
    uint32_t index = 0;
    for (; at < end; at += strlen(at) + 1, index++) {
        if (*at == 0) {
            list++;
            index = MAIN_NONE; /* which the step makes 0 */
            continue;
        }
        if (!name)
            main_print(list ? "method" : "scene", at);
        else if (list == wanted && strcmp(name, at) == 0)
            return index;
    }
    return MAIN_NONE;
}

static void main_choose(struct view *view, const char *text, uint32_t length, enum stream_type type, const char *name)
{
    if (!name || view->code != CLI_DONE)
        return;
    uint32_t index = main_names(text, length, type == STREAM_METHOD, name);
    if (index == MAIN_NONE) {
        fprintf(stderr, "%s: the device has no %s '%s'; --names lists them\n", view->port.name,
                type == STREAM_METHOD ? "method" : "scene", name);
        view->code = CLI_BAD_USAGE;
        return;
    }
    *(type == STREAM_METHOD ? &view->method_index : &view->scene_index) = index;
}

static void main_hello(void *context, const char *text, uint32_t length)
{
    struct view *view = context;
    if (view->named)
        return;
    view->named = true;
    if (view->names) {
        main_print("board", text);
        main_names(text, length, 0, NULL);
    }
    main_choose(view, text, length, STREAM_SCENE, view->scene);
    main_choose(view, text, length, STREAM_METHOD, view->method);
}

enum main_option {
    MAIN_HELP = 'h',
    MAIN_DUMP = 256,
    MAIN_FRAMES,
    MAIN_HEADLESS,
    MAIN_LIST,
    MAIN_NAMES,
    MAIN_SCENE,
    MAIN_METHOD,
    MAIN_BUDGET,
    MAIN_PAUSE,
    MAIN_RUN,
};

static const struct option main_options[] = {
    {"dump", required_argument, NULL, MAIN_DUMP},     {"frames", required_argument, NULL, MAIN_FRAMES},
    {"headless", no_argument, NULL, MAIN_HEADLESS},   {"list", no_argument, NULL, MAIN_LIST},
    {"names", no_argument, NULL, MAIN_NAMES},         {"scene", required_argument, NULL, MAIN_SCENE},
    {"method", required_argument, NULL, MAIN_METHOD}, {"budget", required_argument, NULL, MAIN_BUDGET},
    {"pause", no_argument, NULL, MAIN_PAUSE},         {"run", no_argument, NULL, MAIN_RUN},
    {"help", no_argument, NULL, MAIN_HELP},           {0}};

static void main_flag(struct view *view, int option)
{
    switch (option) {
    case MAIN_DUMP:
        view->dump = optarg;
        break;
    case MAIN_LIST:
        view->list = true;
        break;
    case MAIN_NAMES:
        view->names = true;
        break;
    case MAIN_SCENE:
        view->scene = optarg;
        break;
    case MAIN_METHOD:
        view->method = optarg;
        break;
    case MAIN_PAUSE:
    case MAIN_RUN:
        view->pause = option == MAIN_PAUSE;
        break;
    default: /* MAIN_HEADLESS */
        break;
    }
}

/* Exit code, or -1 to go on. */
static int main_parse(struct view *view, int argc, char **argv)
{
    int option, index = 0;
    while ((option = getopt_long(argc, argv, "h", main_options, &index)) != -1) {
        bool good = true;
        switch (option) {
        case MAIN_HELP:
            fputs(main_help, stdout);
            return CLI_DONE;
        case '?':
            return CLI_BAD_USAGE;
        case MAIN_FRAMES:
            good = cli_number(optarg, 1, 1000000, &view->frames_wanted);
            break;
        case MAIN_BUDGET:
            good = cli_number(optarg, 1, 255, &view->budget);
            break;
        default:
            main_flag(view, option);
        }
        if (!good)
            return cli_refuse(main_name, main_help, main_options[index].name, optarg);
    }
    if (argc - optind != 1)
        return cli_usage(main_name, "one input is needed");
    if (!*argv[optind] || strcmp(argv[optind], "file:") == 0 || (view->dump && !*view->dump))
        return cli_usage(main_name, "a name is empty");
    return -1;
}

/* For a picture; and for what is wanted of it, until one shows that all of it has been heard. */
static int main_ask(struct view *view)
{
    const struct {
        enum stream_type type;
        uint32_t value;
    } wishes[] = {{STREAM_BUDGET, view->budget},
                  {STREAM_PAUSE, view->pause},
                  {STREAM_SCENE, view->scene_index},
                  {STREAM_METHOD, view->method_index}};
    int code = CLI_DONE;
    for (unsigned i = 0; i < sizeof wishes / sizeof *wishes && !code && !view->obeyed; i++)
        if (wishes[i].value != MAIN_NONE)
            code = port_ask(&view->port, wishes[i].type, wishes[i].value);
    return code ? code : port_ask(&view->port, STREAM_KEY_PLEASE, 0);
}

static int main_run(struct view *view)
{
    static uint8_t bytes[65536];
    double asked = cli_clock() - MAIN_AGAIN_MS;
    uint32_t seen = 0;
    long count = 0;
    while (!main_enough(view) && !cli_interrupted() && !view->frames.parser.out_of_memory) {
        double now = cli_clock();
        if (view->port.asks && (seen != view->frames.pictures || now - asked >= MAIN_AGAIN_MS)) {
            view->code = main_ask(view);
            seen = view->frames.pictures;
            asked = now;
        }
        count = port_read(&view->port, bytes, sizeof bytes, MAIN_WAIT_MS);
        if (count < 0)
            break;
        if (count > 0) {
            frames_push(&view->frames, bytes, (size_t)count);
            asked = view->port.asks && view->frames.parser.count ? cli_clock() : asked; /* it is answering */
        }
    }
    if (count == PORT_FAILED)
        return CLI_IO;
    frames_finish(&view->frames);
    return view->code;
}

/* What came of it: one line, and the exit code. */
static int main_tell(const struct view *view)
{
    const struct frames *f = &view->frames;
    uint32_t pictures = view->pictures;
    if (f->parser.out_of_memory) {
        fprintf(stderr, "%s: out of memory\n", view->port.name);
        return CLI_IO;
    }
    if (pictures == 0 || pictures < view->frames_wanted) {
        fprintf(stderr, "%s: %s%u picture%s in the stream, %u lost%s\n", view->port.name, pictures ? "only " : "",
                (unsigned)pictures, pictures == 1 ? "" : "s", (unsigned)f->lost,
                f->parser.other_version ? "; part of it is of another version" : "");
        return CLI_BAD_DATA;
    }
    printf("%u picture%s, %u bytes each, %u lost\n", (unsigned)pictures, pictures == 1 ? "" : "s",
           (unsigned)((view->bytes + pictures / 2) / pictures), (unsigned)f->lost);
    return CLI_DONE;
}

static int main_view(int argc, char **argv)
{
    static struct view view = {
        .scene_index = MAIN_NONE, .method_index = MAIN_NONE, .budget = MAIN_NONE, .pause = MAIN_NONE};
    const struct frames_events events = {main_picture, main_hello, main_log, &view};
    argv[0] = (char *)(uintptr_t)main_name;
    int code = main_parse(&view, argc, argv);
    if (code >= 0)
        return code;
    bool asking = view.scene || view.method || view.budget != MAIN_NONE || view.pause != MAIN_NONE;
    cli_catch_signals();
    if ((code = port_open(&view.port, argv[optind])) != CLI_DONE)
        return code;
    if (asking && !view.port.asks)
        return cli_usage(main_name, "%s is no device that could be asked for a scene, method, budget or pause",
                         view.port.name);
    frames_open(&view.frames, &events);
    code = main_run(&view);
    if (!code && !cli_interrupted())
        code = main_tell(&view);
    frames_close(&view.frames);
    port_close(&view.port);
    return code;
}

int main(int argc, char **argv)
{
    signal(SIGPIPE, SIG_IGN);
    int code = main_view(argc, argv);
    if (cli_interrupted()) { /* the caller sees by what */
        signal(cli_interrupted(), SIG_DFL);
        raise(cli_interrupted());
    }
    if ((fflush(stdout) != 0 || ferror(stdout)) && code == CLI_DONE) {
        fprintf(stderr, "standard output: cannot be written\n");
        code = CLI_IO;
    }
    return code;
}
