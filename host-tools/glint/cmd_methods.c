/* SPDX-License-Identifier: MIT */
#include "glint/cli.h"
#include "glint/commands.h"
#include "glint/renderer.h"

#include <stdio.h>
#include <string.h>

static const char methods_help[] = "usage: glint methods\n\n"
                                   "Lists the names that `glint render --method` takes, one a line. \"a-b\" is also\n"
                                   "`--method a --subdivide b`, and \"a-perspective\" `--method a --perspective`.\n";

int cmd_methods(int argc, char **argv)
{
    if (argc == 2 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)) {
        fputs(methods_help, stdout);
        return CLI_DONE;
    }
    if (argc != 1)
        return cli_usage("glint methods", "it takes no arguments");
    for (unsigned m = 0; m < glint_choice_count; m++)
        printf("%s\n", glint_choices[m].name);
    return CLI_DONE;
}
