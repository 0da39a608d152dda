/* SPDX-License-Identifier: MIT */
#include "host/sink.h"

#include "display.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void sink_release(struct sink *sink)
{
    free(sink->target);
    free(sink->temporary);
    *sink = (struct sink){0};
}

/* A failure inside sink_open(): errno survives the cleaning up. */
static int sink_fail(struct sink *sink, int file)
{
    int reason = errno;
    if (file >= 0) {
        close(file);
        unlink(sink->temporary);
    }
    sink_release(sink);
    errno = reason;
    return HAL_E_IO;
}

/* What a plain open() would have given the file: its old mode, or what the umask leaves. */
static mode_t sink_mode(const struct stat *old)
{
    mode_t mask = umask(0);
    umask(mask);
    return old ? old->st_mode & 0777 : 0666 & ~mask;
}

/* A file beside the target to rename later. */
static int sink_open_beside(struct sink *sink, const char *path, const struct stat *old)
{
    /* a symbolic link stays one: what it points to is replaced */
    sink->target = old ? realpath(path, NULL) : strdup(path);
    size_t size = sink->target ? strlen(sink->target) + sizeof ".XXXXXX" : 0;
    sink->temporary = size ? malloc(size) : NULL;
    if (!sink->temporary)
        return sink_fail(sink, -1);
    snprintf(sink->temporary, size, "%s.XXXXXX", sink->target);
    int file = mkstemp(sink->temporary);
    if (file < 0)
        return sink_fail(sink, -1);
    if (fchmod(file, sink_mode(old)) != 0 || !(sink->stream = fdopen(file, "wb")))
        return sink_fail(sink, file);
    return 0;
}

int sink_open(struct sink *sink, const char *path)
{
    struct stat old;
    *sink = (struct sink){0};
    if (strcmp(path, "-") == 0) {
        sink->stream = stdout;
        return 0;
    }
    if (stat(path, &old) != 0)
        return errno == ENOENT ? sink_open_beside(sink, path, NULL) : HAL_E_IO;
    if (S_ISDIR(old.st_mode)) {
        errno = EISDIR;
        return HAL_E_IO;
    }
    if (S_ISREG(old.st_mode)) {
        /* a rename would get past a file that may not be written */
        return access(path, W_OK) == 0 ? sink_open_beside(sink, path, &old) : HAL_E_IO;
    }
    sink->stream = fopen(path, "wb");
    return sink->stream ? 0 : HAL_E_IO;
}

int sink_write(struct sink *sink, const void *bytes, size_t size)
{
    return fwrite(bytes, 1, size, sink->stream) == size ? 0 : HAL_E_IO;
}

int sink_close(struct sink *sink, int keep)
{
    int result = 0, reason = 0;
    if (!sink->stream)
        return 0;
    if (fflush(sink->stream) != 0 || ferror(sink->stream))
        result = HAL_E_IO, reason = errno;
    if (sink->stream != stdout && fclose(sink->stream) != 0 && !result)
        result = HAL_E_IO, reason = errno;
    if (sink->temporary && keep && !result && rename(sink->temporary, sink->target) != 0)
        result = HAL_E_IO, reason = errno;
    if (sink->temporary && (!keep || result))
        unlink(sink->temporary);
    sink_release(sink);
    errno = reason ? reason : errno;
    return result;
}
