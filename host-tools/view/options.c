/* SPDX-License-Identifier: MIT */
#include "view/options.h"

#include "glint/cli.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

static const char options_help[] =
    "usage: glint-view INPUT [OPTION]...\n\n"
    "Takes pictures from a device's stream: `glint render --stream`, or a board's serial line.\n\n"
    "INPUT is file:PATH for a recording, - for standard input, or a serial port as /dev/ttyUSB0 (115200 baud), which "
    "is\n"
    "asked for each picture. Only whole pictures are taken; one that was damaged on the way is left out.\n\n"
    "      --dump DIR         write them to DIR/frame-0000.png and so on\n"
    "      --frames N         end after N pictures, 1..1000000; the default is all\n"
    "      --headless         open no window, which it does not so far: pictures are written, counted and listed\n"
    "      --trace            print a line for each, with the CRC-32 of its bytes as drawn\n"
    "      --names            print what the device offers: scenes and methods\n"
    "      --scene NAME       let the device show a scene,\n"
    "      --method NAME      by a method,\n"
    "      --budget N         with a budget of N, 1..255\n"
    "      --pause, --run     stop its animation, or let it go on\n"
    "      --help\n\n"
    "Exit code: 0 done, 1 no picture, or fewer than asked for, 2 bad usage, 3 device or I/O.\n";

enum options_letter {
    OPTIONS_HELP = 'h',
    OPTIONS_DUMP = 256,
    OPTIONS_FRAMES,
    OPTIONS_HEADLESS,
    OPTIONS_TRACE,
    OPTIONS_NAMES,
    OPTIONS_SCENE,
    OPTIONS_METHOD,
    OPTIONS_BUDGET,
    OPTIONS_PAUSE,
    OPTIONS_RUN,
};

static const struct option options_long[] = {
    {"dump", required_argument, NULL, OPTIONS_DUMP},     {"frames", required_argument, NULL, OPTIONS_FRAMES},
    {"headless", no_argument, NULL, OPTIONS_HEADLESS},   {"trace", no_argument, NULL, OPTIONS_TRACE},
    {"names", no_argument, NULL, OPTIONS_NAMES},         {"scene", required_argument, NULL, OPTIONS_SCENE},
    {"method", required_argument, NULL, OPTIONS_METHOD}, {"budget", required_argument, NULL, OPTIONS_BUDGET},
    {"pause", no_argument, NULL, OPTIONS_PAUSE},         {"run", no_argument, NULL, OPTIONS_RUN},
    {"help", no_argument, NULL, OPTIONS_HELP},           {0}};

static void options_flag(struct options *options, int letter)
{
    switch (letter) {
    case OPTIONS_DUMP:
        options->dump = optarg;
        break;
    case OPTIONS_HEADLESS:
        options->headless = true;
        break;
    case OPTIONS_TRACE:
        options->trace = true;
        break;
    case OPTIONS_NAMES:
        options->names = true;
        break;
    case OPTIONS_SCENE:
        options->scene = optarg;
        break;
    case OPTIONS_METHOD:
        options->method = optarg;
        break;
    default: /* OPTIONS_PAUSE, OPTIONS_RUN */
        options->pause = letter == OPTIONS_PAUSE;
    }
}

int options_parse(struct options *options, int argc, char **argv)
{
    int letter, index = 0;
    *options = (struct options){.budget = OPTIONS_NONE, .pause = OPTIONS_NONE};
    argv[0] = (char *)(uintptr_t)OPTIONS_NAME; /* for getopt's messages */
    while ((letter = getopt_long(argc, argv, "h", options_long, &index)) != -1) {
        bool good = true;
        switch (letter) {
        case OPTIONS_HELP:
            fputs(options_help, stdout);
            return CLI_DONE;
        case '?':
            return CLI_BAD_USAGE;
        case OPTIONS_FRAMES:
            good = cli_number(optarg, 1, 1000000, &options->frames);
            break;
        case OPTIONS_BUDGET:
            good = cli_number(optarg, 1, 255, &options->budget);
            break;
        default:
            options_flag(options, letter);
        }
        if (!good)
            return cli_refuse(OPTIONS_NAME, options_help, options_long[index].name, optarg);
    }
    if (argc - optind != 1)
        return cli_usage(OPTIONS_NAME, "one input is needed");
    options->input = argv[optind];
    if (!*options->input || strcmp(options->input, "file:") == 0 || (options->dump && !*options->dump))
        return cli_usage(OPTIONS_NAME, "a name is empty");
    return -1;
}
