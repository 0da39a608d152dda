/* SPDX-License-Identifier: MIT */
#include "glint/cli.h"
#include "glint/commands.h"
#include "pack/report.h"

#include <getopt.h>
#include <string.h>
#include <strings.h>

static const char pack_command[] = "glint pack";

static const char pack_help[] =
    "usage: glint pack FILE -o OUT.glt|OUT.c [OPTION]...\n\n"
    "Makes the scene blob of a scene (.json) or model, or checks and copies one (.glt), and reports what was welded,\n"
    "dropped and rounded. Without -o it only reports.\n\n"
    "  -o, --output FILE          write the blob (.glt), or the same as const C (.c); - is standard output\n"
    "      --output-format glt|c  whatever the output's name\n"
    "      --name NAME            C identifier of the array (default: from the name of the output file)\n"
    "      --shininess N          give every material this exponent, 1..1023\n"
    "      --help\n";

struct pack_arguments {
    const char *output, *name;
    struct pack_options options;
    int format; /* index into pack_formats */
};

static const char *const pack_formats[] = {"glt", "c"};
enum { PACK_GLT, PACK_C };

static bool pack_ends_with(const char *path, const char *ending)
{
    const char *dot = strrchr(path, '.');
    return dot && !strcasecmp(dot, ending);
}

/* Exit code, or -1 to go on. */
static int pack_parse(int argc, char **argv, struct pack_arguments *a)
{
    static const struct option long_options[] = {
        {"output", required_argument, NULL, 'o'}, {"output-format", required_argument, NULL, 'f'},
        {"name", required_argument, NULL, 'n'},   {"shininess", required_argument, NULL, 's'},
        {"help", no_argument, NULL, 'h'},         {0}};
    int option;
    uint32_t number;
    while ((option = getopt_long(argc, argv, "o:h", long_options, NULL)) != -1) {
        switch (option) {
        case 'o':
            a->output = optarg;
            break;
        case 'f':
            if ((a->format = cli_choice(optarg, pack_formats, 2)) < 0)
                return cli_usage(pack_command, "--output-format is glt or c, not '%s'", optarg);
            break;
        case 'n':
            if (!pack_is_name(optarg))
                return cli_usage(pack_command, "--name is a C identifier that is not taken, not '%s'", optarg);
            a->name = optarg;
            break;
        case 's':
            if (!cli_number(optarg, 1, FX_POWER_MAX_EXPONENT, &number))
                return cli_usage(pack_command, "--shininess is 1..%u, not '%s'", FX_POWER_MAX_EXPONENT, optarg);
            a->options.shininess = number;
            break;
        case 'h':
            fputs(pack_help, stdout);
            return CLI_DONE;
        default:
            return CLI_BAD_USAGE;
        }
    }
    if (argc - optind != 1)
        return cli_usage(pack_command, "one scene or model is needed");
    if (a->format < 0 && a->output && pack_ends_with(a->output, ".glt"))
        a->format = PACK_GLT;
    if (a->format < 0 && a->output && pack_ends_with(a->output, ".c"))
        a->format = PACK_C;
    if (a->output && a->format < 0)
        return cli_usage(pack_command, "'%s' ends in neither .glt nor .c: --output-format is needed", a->output);
    if (a->name && !(a->output && a->format == PACK_C))
        return cli_usage(pack_command, "--name is for an output in C");
    return -1;
}

int cmd_pack(int argc, char **argv)
{
    struct pack_arguments a = {.format = -1};
    struct pack_result result;
    char name[128];
    argv[0] = (char *)(uintptr_t)pack_command;
    int code = pack_parse(argc, argv, &a);
    if (code >= 0)
        return code;
    code = pack_load(argv[optind], &a.options, &result);
    if (code)
        return code;
    if (a.output)
        cli_catch_signals();
    if (a.output && a.format == PACK_C) {
        pack_name(a.output, name, sizeof name);
        code = pack_write_c(a.output, a.name ? a.name : name, &result);
    } else if (a.output)
        code = pack_write_blob(a.output, &result);
    if (!code) /* not among the output's bytes */
        report_print(a.output && !strcmp(a.output, "-") ? stderr : stdout, &result);
    pack_free(&result);
    return code;
}
