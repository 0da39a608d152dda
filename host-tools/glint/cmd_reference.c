/* SPDX-License-Identifier: MIT */
#include "reference/method.h"

#include "glint/cli.h"
#include "glint/commands.h"
#include "glint/output.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

static const char reference_name[] = "glint reference";

static const char reference_help[] =
    "usage: glint reference FILE -o OUT.png [OPTION]...\n\n"
    "Draws the truth that the renderer is measured against: double precision, the normal normalised per pixel.\n\n"
    "  -o, --output FILE      .png, .ppm or .raw; - with --output-format for standard output\n"
    "      --output-format F  png, ppm or raw, whatever the ending\n"
    "      --size WxH         in pixels, each 1..2048; the default is the camera's\n"
    "      --time MS          the moment of the animation, in milliseconds; default 0\n"
    "      --format F         rgb888 (default) or grey8: Rec. 601 luma, shaded as one channel\n"
    "      --method M         phong (default), or what ideal arithmetic makes of another of the methods below\n"
    "      --perspective      the method's form over the triangle in space: M-perspective\n"
    "      --tolerance N      1..255: how far the centre may be off in subdivide-centre, in 1/255; default 4\n"
    "      --area N           1..65535 pixels: how large parts stay in subdivide-recursive and -regular; default 32\n"
    "      --shininess N      1..1023, replaces every material's exponent\n"
    "      --help\n\n"
    "methods:\n";

struct reference_arguments {
    struct reference_options options;
    struct pack_options pack;
    const char *output, *output_format;
    bool perspective;
};

static int reference_print_help(void)
{
    fputs(reference_help, stdout);
    for (int i = 0; i < REFERENCE_METHODS; i++)
        printf("  %-24s %s\n", methods[i].name, methods[i].summary);
    return CLI_DONE;
}

/* Makes the method its perspective-correct form, which phong is already. */
static int reference_perspective(struct reference_options *options)
{
    const struct method *method = methods + options->method;
    char name[64];
    snprintf(name, sizeof name, "%s-perspective", method->name);
    int form = method->perspective ? (int)options->method : method_find(name);
    if (form < 0)
        return cli_usage(reference_name, "%s has no perspective-correct form", method->name);
    options->method = (enum reference_method)form;
    return CLI_DONE;
}

/* The value of one option; false if it is not one. */
static bool reference_value(int option, const char *text, struct reference_arguments *arguments)
{
    struct reference_options *options = &arguments->options;
    uint16_t width, height;
    uint32_t number;
    int choice;
    switch (option) {
    case 's':
        if (!cli_size(text, &width, &height))
            return false;
        options->width = width;
        options->height = height;
        return true;
    case 't':
        return cli_number(text, 0, UINT32_MAX, &options->time_ms);
    case 'f':
        choice = cli_choice(text, cli_formats, 4);
        options->grey = choice == 2;
        return choice == 1 || choice == 2;
    case 'm':
        choice = method_find(text);
        options->method = choice < 0 ? REFERENCE_PHONG : (enum reference_method)choice;
        return choice >= 0;
    case 'e':
        if (!cli_number(text, 1, 255, &number))
            return false;
        options->tolerance = number;
        return true;
    case 'a':
        if (!cli_number(text, 1, 65535, &number))
            return false;
        options->part_area = number;
        return true;
    default:
        if (!cli_number(text, 1, FX_POWER_MAX_EXPONENT, &number))
            return false;
        arguments->pack.shininess = number;
        return true;
    }
}

/* Exit code, or -1 to go on. */
static int reference_parse(int argc, char **argv, struct reference_arguments *arguments)
{
    static const struct option long_options[] = {
        {"output", required_argument, NULL, 'o'}, {"output-format", required_argument, NULL, 'O'},
        {"size", required_argument, NULL, 's'},   {"time", required_argument, NULL, 't'},
        {"format", required_argument, NULL, 'f'}, {"method", required_argument, NULL, 'm'},
        {"perspective", no_argument, NULL, 'p'},  {"tolerance", required_argument, NULL, 'e'},
        {"area", required_argument, NULL, 'a'},   {"shininess", required_argument, NULL, 'n'},
        {"help", no_argument, NULL, 'h'},         {0}};
    int option, index = 0;
    while ((option = getopt_long(argc, argv, "o:h", long_options, &index)) != -1) {
        switch (option) {
        case 'o':
            arguments->output = optarg;
            break;
        case 'O':
            arguments->output_format = optarg;
            break;
        case 'h':
            return reference_print_help();
        case 'p':
            arguments->perspective = true;
            break;
        case '?':
            return CLI_BAD_USAGE;
        default:
            if (!reference_value(option, optarg, arguments))
                return cli_refuse(reference_name, reference_help, long_options[index].name, optarg);
        }
    }
    if (argc - optind != 1)
        return cli_usage(reference_name, "one scene or model is needed");
    if (!arguments->output)
        return cli_usage(reference_name, "-o is missing");
    return arguments->perspective && reference_perspective(&arguments->options) ? CLI_BAD_USAGE : -1;
}

static int reference_write(const struct reference_image *image, struct output *output)
{
    size_t samples = (size_t)image->width * image->height * image->channels;
    uint8_t *bytes = malloc(samples);
    if (!bytes) {
        fprintf(stderr, "%s: out of memory\n", reference_name);
        return CLI_IO;
    }
    for (size_t i = 0; i < samples; i++)
        bytes[i] = reference_byte(image->value[i]);
    int code = output_open(output, (uint16_t)image->width, (uint16_t)image->height,
                           image->channels == 1 ? HAL_GREY8 : HAL_RGB888, 1, 1);
    if (!code)
        code = output_picture(output, 0, 0, bytes, image->width * image->channels);
    int closed = output_close(output, !code);
    free(bytes);
    return code ? code : closed;
}

int cmd_reference(int argc, char **argv)
{
    struct reference_arguments arguments = {0};
    struct reference_image image;
    struct pack_result packed = {0};
    struct output output;
    argv[0] = (char *)reference_name;
    int code = reference_parse(argc, argv, &arguments);
    if (code >= 0)
        return code;
    code = output_choose(&output, reference_name, arguments.output, arguments.output_format);
    if (!code)
        code = pack_load(argv[optind], &arguments.pack, &packed);
    if (code)
        return code;
    if (reference_render(packed.scene, &arguments.options, &image)) {
        code = reference_write(&image, &output);
        reference_free(&image);
    } else {
        fprintf(stderr, "%s: out of memory\n", reference_name);
        code = CLI_IO;
    }
    pack_free(&packed);
    return code;
}
