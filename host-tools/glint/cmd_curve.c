/* SPDX-License-Identifier: MIT */
#include "reference/curve.h"

#include "glint/cli.h"
#include "glint/commands.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

static const char curve_name[] = "glint curve";

static const char curve_help[] =
    "usage: glint curve x-error\n\n"
    "Prints a table to be plotted, comma-separated: how X-shading's error grows with the angle between the normals\n"
    "of an edge, 0 to 120 degrees, beside the quadratic through the true middle (six) and the line (gouraud). Norms\n"
    "are those of the vectors in the middle; errors the largest of N.L along the edge under the worst light.\n\n"
    "  --help\n";

static int curve_x_error(void)
{
    puts("degrees,x_norm,linear_norm,x_error,six_error,linear_error");
    for (int degrees = 0; degrees <= 120; degrees++) {
        struct curve_point p = curve_x(degrees);
        printf("%d,%.6f,%.6f,%.6f,%.6f,%.6f\n", degrees, p.norm, p.linear_norm, p.error, p.six_error, p.linear_error);
    }
    return CLI_DONE;
}

int cmd_curve(int argc, char **argv)
{
    static const struct option long_options[] = {{"help", no_argument, NULL, 'h'}, {0}};
    int option;
    argv[0] = (char *)(uintptr_t)curve_name;
    while ((option = getopt_long(argc, argv, "h", long_options, NULL)) != -1) {
        if (option != 'h')
            return CLI_BAD_USAGE;
        fputs(curve_help, stdout);
        return CLI_DONE;
    }
    if (argc - optind != 1)
        return cli_usage(curve_name, "the name of a curve is needed");
    if (strcmp(argv[optind], "x-error") != 0)
        return cli_usage(curve_name, "there is no curve '%s'", argv[optind]);
    return curve_x_error();
}
