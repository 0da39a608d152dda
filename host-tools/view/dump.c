/* SPDX-License-Identifier: MIT */
#include "view/dump.h"

#include "glint/cli.h"
#include "host/displays.h"
#include "view/unpack.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static int dump_problem(const char *path, int result)
{
    if (!cli_interrupted())
        fprintf(stderr, "%s: %s\n", path, result == HAL_E_FULL ? "out of memory" : strerror(errno ? errno : EIO));
    return CLI_IO;
}

int dump_folder(const char *folder)
{
    struct stat there;
    if (mkdir(folder, 0777) == 0)
        return CLI_DONE;
    if (errno != EEXIST || stat(folder, &there) != 0)
        return dump_problem(folder, HAL_E_IO);
    errno = ENOTDIR;
    return S_ISDIR(there.st_mode) ? CLI_DONE : dump_problem(folder, HAL_E_IO);
}

int dump_file(const char *path, const struct frames_picture *p)
{
    struct host_display out = {.display.ops = &png_display, .path = path, .frames = 1};
    struct hal_display *display = &out.display;
    uint32_t stride = (uint32_t)unpack_row_bytes(p->format, p->width);
    errno = 0;
    int result = png_display.open(display, p->width, p->height, (enum hal_pixel_format)p->format);
    if (!result) {
        if (!(result = png_display.frame_begin(display, 0, 0)) &&
            !(result = png_display.flush(display, p->pixels, 0, p->height, stride)))
            result = png_display.frame_end(display);
        int closed = png_display.close(display, result == 0);
        result = result ? result : closed;
    }
    return result ? dump_problem(path, result) : CLI_DONE;
}

int dump_picture(const char *folder, uint32_t index, const struct frames_picture *p)
{
    size_t room = strlen(folder) + sizeof "/frame-4294967295.png";
    char *path = malloc(room);
    if (!path)
        return dump_problem(folder, HAL_E_FULL);
    snprintf(path, room, "%s/frame-%04u.png", folder, (unsigned)index);
    int code = dump_file(path, p);
    free(path);
    return code;
}

void dump_name(char name[DUMP_NAME], const char *kind)
{
    struct stat there;
    for (unsigned i = 0; i < 10000; i++) {
        snprintf(name, DUMP_NAME, "%.16s-%04u.png", kind, i);
        if (lstat(name, &there) != 0 && errno == ENOENT)
            return;
    }
    name[0] = 0;
}
