/* SPDX-License-Identifier: MIT */
#include "compare/compare.h"
#include "glint/cli.h"
#include "glint/commands.h"
#include "glint/output.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char compare_name[] = "glint compare";

static const char compare_help[] =
    "usage: glint compare A.png B.png [OPTION]...\n\n"
    "Prints how far two pictures differ, in 1/255, over the pixels that either covers.\n\n"
    "  --json                     print {\"psnr_db\", \"rms\", \"max\", \"p999\", \"pixels\"}; psnr_db is null for "
    "equal "
    "pictures\n"
    "  --diff FILE.png            write the difference, 128 + 8 (B - A) a channel\n"
    "  --background RRGGBB|auto   the colour of pixels not covered; auto (the default) takes each picture's most\n"
    "                             frequent corner; if nothing is covered and they differ, all pixels count\n"
    "  --help\n\n"
    "p999: 99.9 % of the pixels differ by no more in any channel.\n";

struct compare_options {
    bool json, has_background;
    const char *difference;
    uint8_t background[3];
};

static bool compare_colour(const char *text, struct compare_options *options)
{
    options->has_background = strcmp(text, "auto") != 0;
    if (!options->has_background)
        return true;
    if (strlen(text) != 6 || strspn(text, "0123456789abcdefABCDEF") != 6)
        return false;
    unsigned long rgb = strtoul(text, NULL, 16);
    for (int i = 0; i < 3; i++)
        options->background[i] = (uint8_t)(rgb >> (16 - 8 * i));
    return true;
}

static void compare_print(const struct compare_result *result, bool json)
{
    char psnr[32];
    bool equal = isinf(result->psnr_db);
    snprintf(psnr, sizeof psnr, "%.4f", result->psnr_db);
    if (json)
        printf("{\"psnr_db\": %s, \"rms\": %.6f, \"max\": %g, \"p999\": %g, \"pixels\": %zu}\n", equal ? "null" : psnr,
               result->rms, result->max, result->p999, result->pixels);
    else
        printf("psnr_db %s\nrms     %.4f\nmax     %g\np999    %g\npixels  %zu\n", equal ? "inf" : psnr, result->rms,
               result->max, result->p999, result->pixels);
}

static int compare_write(const struct image *a, const struct image *b, struct output *output)
{
    uint8_t *rgb = malloc(3 * (size_t)a->width * a->height);
    if (!rgb) {
        fprintf(stderr, "%s: out of memory\n", compare_name);
        return CLI_IO;
    }
    compare_difference(a, b, rgb);
    int code = output_open(output, (uint16_t)a->width, (uint16_t)a->height, HAL_RGB888, 1, 1);
    if (!code)
        code = output_picture(output, 0, 0, rgb, 3u * a->width);
    int closed = output_close(output, !code);
    free(rgb);
    return code ? code : closed;
}

static int compare_pictures(const char *const path[2], const struct image *a, const struct image *b,
                            const struct compare_options *options, struct output *output)
{
    struct compare_result result;
    if (a->width != b->width || a->height != b->height) {
        fprintf(stderr, "%s: %ux%u, but %s is %ux%u\n", path[1], b->width, b->height, path[0], a->width, a->height);
        return CLI_BAD_DATA;
    }
    compare_images(a, b, options->has_background ? options->background : NULL, &result);
    int code = options->difference ? compare_write(a, b, output) : CLI_DONE;
    if (!code)
        compare_print(&result, options->json);
    return code;
}

/* Exit code, or -1 to go on. */
static int compare_parse(int argc, char **argv, struct compare_options *options)
{
    static const struct option long_options[] = {{"json", no_argument, NULL, 'j'},
                                                 {"diff", required_argument, NULL, 'd'},
                                                 {"background", required_argument, NULL, 'b'},
                                                 {"help", no_argument, NULL, 'h'},
                                                 {0}};
    int option;
    while ((option = getopt_long(argc, argv, "h", long_options, NULL)) != -1) {
        switch (option) {
        case 'j':
            options->json = true;
            break;
        case 'd':
            options->difference = optarg;
            break;
        case 'b':
            if (!compare_colour(optarg, options))
                return cli_usage(compare_name, "--background is RRGGBB or auto, not '%s'", optarg);
            break;
        case 'h':
            fputs(compare_help, stdout);
            return CLI_DONE;
        default:
            return CLI_BAD_USAGE;
        }
    }
    return argc - optind == 2 ? -1 : cli_usage(compare_name, "two pictures are needed");
}

int cmd_compare(int argc, char **argv)
{
    struct compare_options options = {0};
    struct output output = {0};
    struct image a = {0}, b = {0};
    argv[0] = (char *)compare_name;
    int code = compare_parse(argc, argv, &options);
    if (code >= 0)
        return code;
    if (options.difference && (code = output_choose(&output, compare_name, options.difference, NULL)))
        return code;
    const char *const path[2] = {argv[optind], argv[optind + 1]};
    code = image_read_png(path[0], &a);
    if (!code)
        code = image_read_png(path[1], &b);
    if (!code)
        code = compare_pictures(path, &a, &b, &options, &output);
    image_free(&a);
    image_free(&b);
    return code;
}
