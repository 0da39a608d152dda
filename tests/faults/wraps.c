/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE
#include "faults/wraps.h"

#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

struct seam *wraps_seam;
static bool wraps_halves;

static bool fails(void)
{
    return wraps_seam && seam_fails(wraps_seam);
}

static bool fails_memory(void)
{
    bool failed = fails();
    errno = failed ? ENOMEM : errno;
    return failed;
}

/* Defines __wrap_NAME, which returns `lost` when the call fails, else what NAME does. */
#define WRAP(type, lost, failing, name, parameters, arguments) \
    type __real_##name parameters;                             \
    type __wrap_##name parameters;                             \
    type __wrap_##name parameters                              \
    {                                                          \
        return failing() ? (lost) : __real_##name arguments;   \
    }

WRAP(void *, NULL, fails_memory, malloc, (size_t size), (size))
WRAP(void *, NULL, fails_memory, calloc, (size_t count, size_t size), (count, size))
WRAP(void *, NULL, fails_memory, realloc, (void *memory, size_t size), (memory, size))
WRAP(char *, NULL, fails_memory, strdup, (const char *text), (text))
WRAP(char *, NULL, fails, realpath, (const char *path, char *out), (path, out))
WRAP(int, -1, fails, stat, (const char *path, struct stat *status), (path, status))
WRAP(int, -1, fails, fstat, (int file, struct stat *status), (file, status))
WRAP(int, -1, fails, access, (const char *path, int mode), (path, mode))
WRAP(int, -1, fails, mkdir, (const char *path, mode_t mode), (path, mode))
WRAP(char *, NULL, fails, mkdtemp, (char *path), (path))
WRAP(int, -1, fails, mkstemp, (char *path), (path))
WRAP(int, -1, fails, fchmod, (int file, mode_t mode), (file, mode))
WRAP(int, -1, fails, rename, (const char *from, const char *to), (from, to))
WRAP(int, -1, fails, pipe, (int ends[2]), (ends))
WRAP(pid_t, -1, fails, fork, (void), ())
WRAP(FILE *, NULL, fails, tmpfile, (void), ()) /* its descriptor is wanted: no stream of ours */
WRAP(FILE *, NULL, fails_memory, open_memstream, (char **bytes, size_t *size), (bytes, size))

/* --- streams --------------------------------------------------------------------------------------------------------
 */

static size_t wraps_part(size_t size)
{
    return wraps_halves && size > 1 ? size / 2 : size;
}

static ssize_t wraps_stream_read(void *inner, char *bytes, size_t size)
{
    if (fails())
        return -1;
    size_t count = fread(bytes, 1, wraps_part(size), inner);
    return count == 0 && ferror((FILE *)inner) ? -1 : (ssize_t)count;
}

/* Halves of what is to be written are for read() and write() alone: stdio takes less than all for an error. */
static ssize_t wraps_stream_write(void *inner, const char *bytes, size_t size)
{
    if (fails())
        return 0;
    return (ssize_t)fwrite(bytes, 1, size, inner);
}

static int wraps_stream_seek(void *inner, off64_t *offset, int whence)
{
    if (fails() || fseeko(inner, (off_t)*offset, whence) != 0)
        return -1;
    *offset = ftello(inner);
    return 0;
}

static int wraps_stream_close(void *inner)
{
    bool failed = fails();
    int reason = errno, result = fclose(inner);
    errno = failed ? reason : errno;
    return failed ? EOF : result;
}

static FILE *wraps_stream(FILE *inner, const char *mode)
{
    static const cookie_io_functions_t functions = {wraps_stream_read, wraps_stream_write, wraps_stream_seek,
                                                    wraps_stream_close};
    if (!inner || !wraps_seam)
        return inner;
    setvbuf(inner, NULL, _IONBF, 0);
    return fopencookie(inner, mode, functions);
}

FILE *__real_fopen(const char *path, const char *mode);
FILE *__wrap_fopen(const char *path, const char *mode);
FILE *__wrap_fopen(const char *path, const char *mode)
{
    return fails() ? NULL : wraps_stream(__real_fopen(path, mode), mode);
}

FILE *__real_fdopen(int file, const char *mode);
FILE *__wrap_fdopen(int file, const char *mode);
FILE *__wrap_fdopen(int file, const char *mode)
{
    return fails() ? NULL : wraps_stream(__real_fdopen(file, mode), mode);
}

FILE *__real_fmemopen(void *bytes, size_t size, const char *mode);
FILE *__wrap_fmemopen(void *bytes, size_t size, const char *mode);
FILE *__wrap_fmemopen(void *bytes, size_t size, const char *mode)
{
    return fails_memory() ? NULL : wraps_stream(__real_fmemopen(bytes, size, mode), mode);
}

/* --- descriptors ----------------------------------------------------------------------------------------------------
 */

int __real_open(const char *path, int flags, ...);
int __wrap_open(const char *path, int flags, ...);
int __wrap_open(const char *path, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    mode_t mode = flags & O_CREAT ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return fails() ? -1 : __real_open(path, flags, mode);
}

ssize_t __real_read(int file, void *bytes, size_t size);
ssize_t __wrap_read(int file, void *bytes, size_t size);
ssize_t __wrap_read(int file, void *bytes, size_t size)
{
    return fails() ? -1 : __real_read(file, bytes, wraps_part(size));
}

ssize_t __real_write(int file, const void *bytes, size_t size);
ssize_t __wrap_write(int file, const void *bytes, size_t size);
ssize_t __wrap_write(int file, const void *bytes, size_t size)
{
    return fails() ? -1 : __real_write(file, bytes, wraps_part(size));
}

/* --- what zlib allocates --------------------------------------------------------------------------------------------
 */

static void *wraps_zlib_allocate(void *context, unsigned count, unsigned size)
{
    (void)context;
    return __wrap_calloc(count, size);
}

static void wraps_zlib_free(void *context, void *memory)
{
    (void)context;
    free(memory);
}

int __real_deflateInit2_(z_stream *stream, int level, int method, int bits, int memory, int strategy,
                         const char *version, int size);
int __wrap_deflateInit2_(z_stream *stream, int level, int method, int bits, int memory, int strategy,
                         const char *version, int size);
int __wrap_deflateInit2_(z_stream *stream, int level, int method, int bits, int memory, int strategy,
                         const char *version, int size)
{
    stream->zalloc = wraps_zlib_allocate;
    stream->zfree = wraps_zlib_free;
    return __real_deflateInit2_(stream, level, method, bits, memory, strategy, version, size);
}

void wraps_begin(struct seam *seam, bool halves)
{
    wraps_seam = seam;
    wraps_halves = halves;
    stdout = wraps_stream(stdout, "wb");
}
