/* SPDX-License-Identifier: MIT */
#include "glint/cli.h"
#include "glint/commands.h"
#include "pack/summary.h"

#include <getopt.h>

static const char info_command[] = "glint info";

static const char info_help[] =
    "usage: glint info FILE [--json]\n\n"
    "Says what is in a packed scene (.glt), a scene (.json) or a model, as it is packed.\n\n"
    "  --json   as one JSON object\n"
    "  --help\n";

int cmd_info(int argc, char **argv)
{
    static const struct option long_options[] = {
        {"json", no_argument, NULL, 'j'}, {"help", no_argument, NULL, 'h'}, {0}};
    struct pack_result result;
    bool json = false;
    int option;
    argv[0] = (char *)(uintptr_t)info_command;
    while ((option = getopt_long(argc, argv, "h", long_options, NULL)) != -1) {
        if (option == 'h') {
            fputs(info_help, stdout);
            return CLI_DONE;
        }
        if (option != 'j')
            return CLI_BAD_USAGE;
        json = true;
    }
    if (argc - optind != 1)
        return cli_usage(info_command, "one scene or model is needed");
    int code = pack_load(argv[optind], NULL, &result);
    if (code)
        return code;
    (json ? summary_json : summary_print)(stdout, result.scene);
    pack_free(&result);
    return CLI_DONE;
}
