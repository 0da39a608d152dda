/* SPDX-License-Identifier: MIT */
/* Pictures wait in a hidden folder inside the one asked for, where they cannot touch an older run's, and move out when
 * all are complete: all of them, or none. */
#include "host/displays.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define FOLDER_STAGE   "/.frames-XXXXXX"
#define FOLDER_PICTURE "/frame-4294967295.png"

struct folder {
    struct host_display picture; /* the one being written: open while its ops are set */
    int made;                    /* the folder was not there before */
    size_t room;                 /* bytes of each name */
    char *stage, *waiting, *older, *target;
};

static void folder_name(struct folder *folder, const char *path, uint32_t index)
{
    snprintf(folder->waiting, folder->room, "%s/frame-%04u.png", folder->stage, (unsigned)index);
    snprintf(folder->older, folder->room, "%s/older-%04u.png", folder->stage, (unsigned)index);
    snprintf(folder->target, folder->room, "%s/frame-%04u.png", path, (unsigned)index);
}

/* The picture takes its place; what was there waits until all have theirs. */
static int folder_move(const struct folder *folder)
{
    struct stat there;
    if (stat(folder->target, &there) == 0 && S_ISDIR(there.st_mode)) {
        errno = EISDIR;
        return HAL_E_IO;
    }
    if (rename(folder->target, folder->older) != 0 && errno != ENOENT)
        return HAL_E_IO;
    return rename(folder->waiting, folder->target) == 0 ? 0 : HAL_E_IO;
}

/* So many pictures that have moved are gone, and what was there before them, and before the next, is there again. */
static void folder_move_back(struct folder *folder, const char *path, uint32_t moved)
{
    for (uint32_t i = 0; i <= moved; i++) {
        folder_name(folder, path, i);
        if (rename(folder->older, folder->target) != 0 && i < moved)
            unlink(folder->target);
    }
}

static int folder_make(struct folder *folder, const char *path)
{
    struct stat old;
    folder->made = mkdir(path, 0777) == 0;
    if (!folder->made && (errno != EEXIST || stat(path, &old) != 0))
        return HAL_E_IO;
    if (!folder->made && !S_ISDIR(old.st_mode)) {
        errno = ENOTDIR;
        return HAL_E_IO;
    }
    if (mkdtemp(folder->stage))
        return 0;
    int reason = errno;
    if (folder->made)
        rmdir(path);
    errno = reason;
    return HAL_E_IO;
}

static int folder_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    struct host_display *host = (struct host_display *)display;
    size_t room = strlen(host->path) + sizeof FOLDER_STAGE + sizeof FOLDER_PICTURE;
    int result = host_display_prepare(host, width, height, format, (uint32_t)(4 * room));
    if (result)
        return result;
    struct folder *folder = host->folder = calloc(1, sizeof *folder);
    result = HAL_E_FULL;
    if (folder) {
        folder->room = room;
        folder->stage = (char *)host->pixels;
        folder->waiting = folder->stage + room;
        folder->older = folder->waiting + room;
        folder->target = folder->older + room;
        snprintf(folder->stage, room, "%s" FOLDER_STAGE, host->path);
        result = folder_make(folder, host->path);
    }
    if (result) {
        free(folder);
        host_display_finish(host, 0);
    }
    return result;
}

static int folder_frame_begin(struct hal_display *display, uint32_t index, uint32_t delay_ms)
{
    struct host_display *host = (struct host_display *)display;
    struct folder *folder = host->folder;
    folder_name(folder, host->path, host->count);
    /* a rename would get past a file that may not be written */
    if (access(folder->target, W_OK) != 0 && errno != ENOENT)
        return HAL_E_IO;
    folder->picture = (struct host_display){.path = folder->waiting, .frames = 1};
    int result = png_display.open(&folder->picture.display, host->width, host->height, host->format);
    if (result)
        return result;
    folder->picture.display.ops = &png_display;
    return png_display.frame_begin(&folder->picture.display, index, delay_ms);
}

static int folder_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct host_display *host = (struct host_display *)display;
    return png_display.flush(&host->folder->picture.display, pixels, y, rows, stride);
}

static int folder_frame_end(struct hal_display *display)
{
    struct host_display *host = (struct host_display *)display;
    struct host_display *picture = &host->folder->picture;
    int result = png_display.frame_end(&picture->display);
    if (result)
        return result;
    picture->display.ops = NULL;
    result = png_display.close(&picture->display, 1);
    host->count += result == 0;
    return result;
}

static int folder_close(struct hal_display *display, int keep)
{
    struct host_display *host = (struct host_display *)display;
    struct folder *folder = host->folder;
    int result = 0, reason = 0;
    if (folder->picture.display.ops)
        png_display.close(&folder->picture.display, 0);
    for (uint32_t i = 0; keep && !result && i < host->count; i++) {
        folder_name(folder, host->path, i);
        if ((result = folder_move(folder)) != 0) {
            reason = errno;
            folder_move_back(folder, host->path, i);
        }
    }
    for (uint32_t i = 0; i < host->count; i++) {
        folder_name(folder, host->path, i);
        unlink(folder->waiting);
        unlink(folder->older);
    }
    rmdir(folder->stage);
    if (folder->made && !(keep && !result))
        rmdir(host->path);
    free(folder);
    host->folder = NULL;
    host_display_finish(host, 0);
    errno = reason ? reason : errno;
    return result;
}

const struct hal_display_ops folder_display = {folder_open, folder_frame_begin, folder_flush, folder_frame_end,
                                               folder_close};
