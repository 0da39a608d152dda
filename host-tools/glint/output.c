/* SPDX-License-Identifier: MIT */
#include "glint/output.h"

#include "glint/cli.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

struct output_kind {
    const char *name;
    const struct hal_display_ops *ops;
    bool animates;
};

static const struct output_kind output_kinds[] = {
    {"png", &png_display, false}, {"apng", &png_display, true}, {"ppm", &ppm_display, false},
    {"pgm", &ppm_display, false}, {"y4m", &y4m_display, true},  {"raw", &raw_display, false},
    {"/", &folder_display, true}, /* only as the end of a path */
};

#define OUTPUT_KINDS (sizeof output_kinds / sizeof *output_kinds)

static bool output_find(struct output *output, const char *name)
{
    for (size_t i = 0; name && i < OUTPUT_KINDS; i++)
        if (strcmp(name, output_kinds[i].name) == 0) {
            output->host.display.ops = output_kinds[i].ops;
            output->animates = output_kinds[i].animates;
            return true;
        }
    return false;
}

static const char *output_ending(const char *path)
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    if (slash && !slash[1])
        return slash;
    return dot && (!slash || dot > slash) ? dot + 1 : NULL;
}

int output_choose(struct output *output, const char *command, const char *path, const char *format)
{
    struct stat there;
    *output = (struct output){.host.path = path};
    if (format && (format[0] == '/' || !output_find(output, format)))
        return cli_usage(command, "--output-format is one of " OUTPUT_FORMATS ", not '%s'", format);
    if (format || output_find(output, output_ending(path)))
        return CLI_DONE;
    if (strcmp(path, "-") == 0)
        return cli_usage(command, "-o - needs --output-format");
    /* a device or pipe has no ending; a folder is refused when it is opened */
    output->host.display.ops = &png_display;
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode))
        return CLI_DONE;
    return cli_usage(command, "-o %s: the ending is none of " OUTPUT_FORMATS " and there is no --output-format", path);
}

static int output_problem(const struct output *output, int result)
{
    const char *path = strcmp(output->host.path, "-") ? output->host.path : "standard output";
    const char *reason = result == HAL_E_FULL       ? "out of memory"
                         : result == HAL_E_ARGUMENT ? "cannot hold this size, format or number of pictures"
                                                    : strerror(errno ? errno : EIO);
    if (!cli_interrupted()) /* which is reason enough, and no news to the one who sent it */
        fprintf(stderr, "%s: %s\n", path, reason);
    return CLI_IO;
}

int output_open(struct output *output, uint16_t width, uint16_t height, enum hal_pixel_format format, uint32_t frames,
                uint32_t rate)
{
    output->host.frames = frames;
    output->host.rate = rate;
    cli_catch_signals();
    errno = 0;
    int result = output->host.display.ops->open(&output->host.display, width, height, format);
    output->open = result == 0;
    return result ? output_problem(output, result) : CLI_DONE;
}

int output_step(struct output *output, int result)
{
    return result ? output_problem(output, result) : CLI_DONE;
}

int output_picture(struct output *output, uint32_t index, uint32_t delay_ms, const void *pixels, uint32_t stride)
{
    const struct hal_display_ops *ops = output->host.display.ops;
    struct hal_display *display = &output->host.display;
    int result = ops->frame_begin ? ops->frame_begin(display, index, delay_ms) : 0;
    if (!result)
        result = ops->flush(display, pixels, 0, output->host.height, stride);
    if (!result && ops->frame_end)
        result = ops->frame_end(display);
    return output_step(output, result);
}

int output_close(struct output *output, bool keep)
{
    if (!output->open)
        return CLI_DONE;
    output->open = false;
    keep = keep && !cli_interrupted();
    errno = 0;
    int result = output->host.display.ops->close(&output->host.display, keep);
    return keep && result ? output_problem(output, result) : CLI_DONE;
}
