/* SPDX-License-Identifier: MIT */
#include "glint/cli.h"
#include "glint/commands.h"
#include "pack/order.h"
#include "pack/report.h"
#include "pack/uses.h"

#include <getopt.h>
#include <string.h>
#include <strings.h>

static const char pack_command[] = "glint pack";

static const char pack_help[] =
    "usage: glint pack FILE -o OUT.glt|OUT.c [OPTION]...\n"
    "       glint pack --uses FORMATS FILE...\n\n"
    "Makes the scene blob of a scene (.json) or model, or checks and copies one (.glt), and reports what was welded,\n"
    "dropped and rounded. Without -o it only reports.\n\n"
    "  -o, --output FILE          write the blob (.glt), or the same as const C (.c); - is standard output\n"
    "      --output-format glt|c  whatever the output's name\n"
    "      --name NAME            C identifier of the array (default: from the name of the output file)\n"
    "      --byte-order little|big  of the machine that is to draw it (default: little)\n"
    "      --shininess N          give every material this exponent, 1..1023\n"
    "      --uses FORMATS         print what a program that draws these scenes must be compiled with "
    "(firmware/uses.h);\n"
    "                             FORMATS, apart by commas: rgb565, rgb888, grey8, grey4, and dither\n"
    "      --help\n";

struct pack_arguments {
    const char *output, *name;
    struct pack_options options;
    uint32_t uses; /* formats; 0: not asked */
    int format;    /* index into pack_formats */
    int big;       /* index into pack_orders */
};

static const char *const pack_formats[] = {"glt", "c"};
enum { PACK_GLT, PACK_C };
static const char *const pack_orders[] = {"little", "big"};

static bool pack_ends_with(const char *path, const char *ending)
{
    const char *dot = strrchr(path, '.');
    return dot && !strcasecmp(dot, ending);
}

/* Exit code, or -1 to go on. */
static int pack_parse(int argc, char **argv, struct pack_arguments *a)
{
    static const struct option long_options[] = {{"output", required_argument, NULL, 'o'},
                                                 {"output-format", required_argument, NULL, 'f'},
                                                 {"name", required_argument, NULL, 'n'},
                                                 {"byte-order", required_argument, NULL, 'b'},
                                                 {"shininess", required_argument, NULL, 's'},
                                                 {"uses", required_argument, NULL, 'u'},
                                                 {"help", no_argument, NULL, 'h'},
                                                 {0}};
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
        case 'b':
            if ((a->big = cli_choice(optarg, pack_orders, 2)) < 0)
                return cli_usage(pack_command, "--byte-order is little or big, not '%s'", optarg);
            break;
        case 's':
            if (!cli_number(optarg, 1, FX_POWER_MAX_EXPONENT, &number))
                return cli_usage(pack_command, "--shininess is 1..%u, not '%s'", FX_POWER_MAX_EXPONENT, optarg);
            a->options.shininess = number;
            break;
        case 'u':
            a->uses = uses_find(optarg);
            if (!(a->uses & USES_FORMATS))
                return cli_usage(pack_command, "--uses takes rgb565, rgb888, grey8, grey4 and dither, not '%s'",
                                 optarg);
            break;
        case 'h':
            fputs(pack_help, stdout);
            return CLI_DONE;
        default:
            return CLI_BAD_USAGE;
        }
    }
    if (a->uses && (a->output || a->name || a->format >= 0))
        return cli_usage(pack_command, "--uses writes no scene");
    if (argc - optind != 1 && !(a->uses && optind < argc))
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

/* A C header of its own. */
static int pack_print_uses(char **paths, uint32_t uses, const struct pack_options *options)
{
    for (; *paths; paths++) {
        struct pack_result result;
        int code = pack_load(*paths, options, &result);
        if (code)
            return code;
        uses |= result.scene->effects;
        pack_free(&result);
    }
    printf("#define GLINT_USES 0x%06xu /*", (unsigned)uses);
    uses_print(stdout, uses);
    printf(" */\n/* methods:");
    uses_print_methods(stdout, uses);
    puts(" */");
    return CLI_DONE;
}

static int pack_write(const struct pack_arguments *a, const struct pack_result *result)
{
    char name[128];
    if (a->format == PACK_GLT)
        return pack_write_blob(a->output, result);
    pack_name(a->output, name, sizeof name);
    return pack_write_c(a->output, a->name ? a->name : name, result);
}

int cmd_pack(int argc, char **argv)
{
    struct pack_arguments a = {.format = -1};
    struct pack_result result, swapped = {0};
    argv[0] = (char *)(uintptr_t)pack_command;
    int code = pack_parse(argc, argv, &a);
    if (code >= 0)
        return code;
    if (a.uses)
        return pack_print_uses(argv + optind, a.uses, &a.options);
    code = pack_load(argv[optind], &a.options, &result);
    if (code)
        return code;
    if (a.output)
        cli_catch_signals();
    if (a.big)
        order_swap(&result, &swapped);
    if (a.output)
        code = pack_write(&a, a.big ? &swapped : &result);
    if (!code) /* not among the output's bytes */
        report_print(a.output && !strcmp(a.output, "-") ? stderr : stdout, &result);
    pack_free(&result);
    pack_free(&swapped);
    return code;
}
