/* SPDX-License-Identifier: MIT */
#include "glint/cli.h"
#include "glint/commands.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

struct main_command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *summary;
};

static const struct main_command main_commands[] = {
    {"render", cmd_render, "draw a scene or model as a device would, in integers"},
    {"pack", cmd_pack, "make the scene blob that goes into flash"},
    {"reference", cmd_reference, "draw the truth: per-pixel Phong in double precision"},
    {"compare", cmd_compare, "measure how far two pictures differ"},
    {"info", cmd_info, "say what is in a scene or model"},
    {"methods", cmd_methods, "list the shading methods"},
    {"demo", cmd_demo, "draw a scene's animation by three methods, side by side"},
    {"report", cmd_report, "measure every method on scenes: a page of pictures, errors and costs"},
    {"curve", cmd_curve, "print a method's error as a table to be plotted"},
};

#define MAIN_COMMANDS (sizeof main_commands / sizeof *main_commands)

static int main_help(void)
{
    printf("usage: glint COMMAND [OPTION]... FILE...\n\n");
    for (size_t i = 0; i < MAIN_COMMANDS; i++)
        printf("  %-10s %s\n", main_commands[i].name, main_commands[i].summary);
    printf("\nFILE is a scene (.json), a packed scene (.glt) or a model (.obj .ply .stl .gltf .glb).\n"
           "`glint COMMAND --help` lists the options. Exit code: 0 done, 1 bad data, 2 bad usage, 3 device or I/O.\n");
    return CLI_DONE;
}

static int main_run(int argc, char **argv)
{
    if (argc < 2)
        return cli_usage("glint", "a command is missing");
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
        return main_help();
    if (strcmp(argv[1], "--version") == 0) {
        printf("glint " GLINT_VERSION "\n");
        return CLI_DONE;
    }
    for (size_t i = 0; i < MAIN_COMMANDS; i++)
        if (strcmp(argv[1], main_commands[i].name) == 0)
            return main_commands[i].run(argc - 1, argv + 1);
    return cli_usage("glint", "there is no %s '%s'", argv[1][0] == '-' ? "option" : "command", argv[1]);
}

int main(int argc, char **argv)
{
    /* a reader that leaves or a limit on file size shows as an error where we write, and is reported */
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    int code = main_run(argc, argv);
    if (cli_interrupted()) { /* the caller sees by what */
        signal(cli_interrupted(), SIG_DFL);
        raise(cli_interrupted());
    }
    errno = 0;
    if ((fflush(stdout) != 0 || ferror(stdout)) && code == CLI_DONE) {
        fprintf(stderr, "standard output: %s\n", strerror(errno ? errno : EIO));
        code = CLI_IO;
    }
    return code;
}
