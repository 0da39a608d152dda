/* SPDX-License-Identifier: MIT */
#include "view/options.h"

#include "glint/cli.h"
#include "view/controls.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

#define OPTIONS_WAIT_DEFAULT 10 /* seconds */

static const char options_help[] =
    "usage: glint-view [INPUT] [OPTION]...\n\n"
    "Takes pictures from a device's stream: from USB, a board's serial line or `glint render --stream`.\n\n"
    "INPUT is usb: or usb:SERIAL for a device on USB, which may come and go; file:PATH for a recording, - for "
    "standard\n"
    "input, or a serial port as /dev/ttyUSB0 (115200 baud), which is asked for each picture. Without INPUT it is "
    "usb:.\n"
    "Only whole pictures are taken; one that was damaged on the way is left out.\n\n"
    "      --list             list the devices on USB: serial number, product, speed, bus and ports\n"
    "      --serial SERIAL    of several take this one\n"
    "      --wait N           end when nothing has come for N seconds, 1..86400; with --headless 10, else for ever\n"
    "      --dump DIR         write them to DIR/frame-0000.png and so on\n"
    "      --record FILE      make a film of them, by the device's clock: animated PNG (.png, .apng) or YUV4MPEG2 "
    "(.y4m)\n"
    "      --record-fps N     pictures a second of .y4m, 1..1000; the default is 60\n"
    "      --save FILE        keep the stream as it comes, for file:FILE\n"
    "      --frames N         end after N pictures, 1..1000000; the default is all\n"
    "      --headless         open no window; nor do --dump, --frames, --trace and --names\n"
    "      --scale N          of the window: pixels a pixel, 1..6; the default is what fits\n"
    "      --rotate DEGREES   turn the picture clockwise: 0, 90, 180 or 270\n"
    "      --fullscreen       fill the screen\n"
    "      --trace            print a line for each, with the CRC-32 of its bytes as drawn\n"
    "      --names            print what the device offers, scenes and methods; alone it ends with the first picture\n"
    "      --scene NAME       let the device show a scene,\n"
    "      --method NAME      by a method,\n"
    "      --budget N         with a budget of N, 1..255\n"
    "      --pause, --run     stop its animation, or let it go on\n"
    "      --help\n\n"
    "Keys of the window:\n";

static const char options_codes[] =
    "\nExit code: 0 done, 1 no picture, or fewer than asked for, 2 bad usage, 3 device or I/O.\n";

enum options_letter {
    OPTIONS_HELP = 'h',
    OPTIONS_LIST = 256,
    OPTIONS_SERIAL,
    OPTIONS_WAIT,
    OPTIONS_DUMP,
    OPTIONS_RECORD,
    OPTIONS_RECORD_FPS,
    OPTIONS_SAVE,
    OPTIONS_FRAMES,
    OPTIONS_HEADLESS,
    OPTIONS_SCALE,
    OPTIONS_ROTATE,
    OPTIONS_FULLSCREEN,
    OPTIONS_TRACE,
    OPTIONS_NAMES,
    OPTIONS_SCENE,
    OPTIONS_METHOD,
    OPTIONS_BUDGET,
    OPTIONS_PAUSE,
    OPTIONS_RUN,
};

static const struct option options_long[] = {{"list", no_argument, NULL, OPTIONS_LIST},
                                             {"serial", required_argument, NULL, OPTIONS_SERIAL},
                                             {"wait", required_argument, NULL, OPTIONS_WAIT},
                                             {"dump", required_argument, NULL, OPTIONS_DUMP},
                                             {"record", required_argument, NULL, OPTIONS_RECORD},
                                             {"record-fps", required_argument, NULL, OPTIONS_RECORD_FPS},
                                             {"save", required_argument, NULL, OPTIONS_SAVE},
                                             {"frames", required_argument, NULL, OPTIONS_FRAMES},
                                             {"headless", no_argument, NULL, OPTIONS_HEADLESS},
                                             {"scale", required_argument, NULL, OPTIONS_SCALE},
                                             {"rotate", required_argument, NULL, OPTIONS_ROTATE},
                                             {"fullscreen", no_argument, NULL, OPTIONS_FULLSCREEN},
                                             {"trace", no_argument, NULL, OPTIONS_TRACE},
                                             {"names", no_argument, NULL, OPTIONS_NAMES},
                                             {"scene", required_argument, NULL, OPTIONS_SCENE},
                                             {"method", required_argument, NULL, OPTIONS_METHOD},
                                             {"budget", required_argument, NULL, OPTIONS_BUDGET},
                                             {"pause", no_argument, NULL, OPTIONS_PAUSE},
                                             {"run", no_argument, NULL, OPTIONS_RUN},
                                             {"help", no_argument, NULL, OPTIONS_HELP},
                                             {0}};

static void options_flag(struct options *options, int letter)
{
    switch (letter) {
    case OPTIONS_LIST:
        options->list = true;
        break;
    case OPTIONS_SERIAL:
        options->serial = optarg;
        break;
    case OPTIONS_DUMP:
        options->dump = optarg;
        break;
    case OPTIONS_RECORD:
        options->record = optarg;
        break;
    case OPTIONS_SAVE:
        options->save = optarg;
        break;
    case OPTIONS_HEADLESS:
        options->headless = true;
        break;
    case OPTIONS_FULLSCREEN:
        options->fullscreen = true;
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
            controls_print(stdout);
            fputs(options_codes, stdout);
            return CLI_DONE;
        case '?':
            return CLI_BAD_USAGE;
        case OPTIONS_WAIT:
            good = cli_number(optarg, 1, 86400, &options->wait);
            break;
        case OPTIONS_FRAMES:
            good = cli_number(optarg, 1, 1000000, &options->frames);
            break;
        case OPTIONS_RECORD_FPS:
            good = cli_number(optarg, 1, 1000, &options->record_fps);
            break;
        case OPTIONS_SCALE:
            good = cli_number(optarg, 1, 6, &options->scale);
            break;
        case OPTIONS_ROTATE:
            good = cli_number(optarg, 0, 270, &options->rotate) && options->rotate % 90 == 0;
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
    if (argc - optind > !options->list)
        return cli_usage(OPTIONS_NAME, options->list ? "--list takes no input" : "there is more than one input");
    options->input = argc == optind ? "usb:" : argv[optind];
    if (options->serial && strcmp(options->input, "usb:") != 0)
        return cli_usage(OPTIONS_NAME, "--serial goes with the input usb:");
    options->headless |= options->dump || options->frames || options->trace || options->names;
    if (options->names && !options->frames && !options->dump && !options->trace && !options->record && !options->save)
        options->frames = 1;
    if (options->headless && !options->wait)
        options->wait = OPTIONS_WAIT_DEFAULT;
    if (!*options->input || strcmp(options->input, "file:") == 0 || (options->dump && !*options->dump) ||
        (options->serial && !*options->serial) || (options->record && !*options->record) ||
        (options->save && !*options->save))
        return cli_usage(OPTIONS_NAME, "a name is empty");
    return -1;
}
