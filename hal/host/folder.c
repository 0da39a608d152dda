/* SPDX-License-Identifier: MIT */
#include "host/displays.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define FOLDER_NAME "/frame-4294967295.png"

static const char *folder_name(struct host_display *host, uint32_t index)
{
    char *name = (char *)host->pixels;
    snprintf(name, strlen(host->path) + sizeof FOLDER_NAME, "%s/frame-%04u.png", host->path, (unsigned)index);
    return name;
}

static int folder_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    struct host_display *host = (struct host_display *)display;
    struct stat old;
    int result = host_display_prepare(host, width, height, format, (uint32_t)(strlen(host->path) + sizeof FOLDER_NAME));
    if (result)
        return result;
    host->picture = calloc(1, sizeof *host->picture);
    if (!host->picture)
        result = HAL_E_FULL;
    else if (mkdir(host->path, 0777) != 0 && errno != EEXIST)
        result = HAL_E_IO;
    else if (stat(host->path, &old) != 0)
        result = HAL_E_IO;
    else if (!S_ISDIR(old.st_mode))
        errno = ENOTDIR, result = HAL_E_IO;
    if (result) {
        free(host->picture);
        host_display_finish(host, 0);
    }
    return result;
}

/* The picture under way is open while its ops are set. */
static int folder_frame_begin(struct hal_display *display, uint32_t index, uint32_t delay_ms)
{
    struct host_display *host = (struct host_display *)display;
    *host->picture = (struct host_display){.path = folder_name(host, host->count), .frames = 1};
    int result = png_display.open(&host->picture->display, host->width, host->height, host->format);
    if (result)
        return result;
    host->picture->display.ops = &png_display;
    return png_display.frame_begin(&host->picture->display, index, delay_ms);
}

static int folder_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct host_display *host = (struct host_display *)display;
    return png_display.flush(&host->picture->display, pixels, y, rows, stride);
}

static int folder_frame_end(struct hal_display *display)
{
    struct host_display *host = (struct host_display *)display;
    int result = png_display.frame_end(&host->picture->display);
    if (result)
        return result;
    host->picture->display.ops = NULL;
    result = png_display.close(&host->picture->display, 1);
    host->count += result == 0;
    return result;
}

static int folder_close(struct hal_display *display, int keep)
{
    struct host_display *host = (struct host_display *)display;
    if (host->picture->display.ops)
        png_display.close(&host->picture->display, 0);
    /* half an animation is no better than half a file */
    while (!keep && host->count > 0)
        unlink(folder_name(host, --host->count));
    free(host->picture);
    return host_display_finish(host, keep);
}

const struct hal_display_ops folder_display = {folder_open, folder_frame_begin, folder_flush, folder_frame_end,
                                               folder_close};
