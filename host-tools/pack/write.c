/* SPDX-License-Identifier: MIT */
#include "pack/pack.h"

#include "host/sink.h"

#include <ctype.h>
#include <errno.h>
#include <string.h>

static int io_error(const char *path)
{
    fprintf(stderr, "%s: %s\n", path, strerror(errno));
    return PACK_IO;
}

/* Closes, keeping the file if all went well so far. */
static int finish(struct sink *sink, const char *path, int result)
{
    int reason = errno;
    if (sink_close(sink, result == 0) != 0 && !result)
        return io_error(path);
    errno = reason;
    return result ? io_error(path) : PACK_OK;
}

int pack_write_blob(const char *path, const struct pack_result *result)
{
    struct sink sink;
    if (sink_open(&sink, path) != 0)
        return io_error(path);
    return finish(&sink, path, sink_write(&sink, result->scene, result->size));
}

int pack_write_c(const char *path, const char *name, const struct pack_result *result)
{
    struct sink sink;
    if (sink_open(&sink, path) != 0)
        return io_error(path);
    fprintf(sink.stream,
            "/* A Glint scene, made by `glint pack`. */\n"
            "#include <stdint.h>\n\n"
            "extern const uint32_t %s[], %s_length;\n\n"
            "const uint32_t %s_length = %zu; /* bytes */\n\n"
            "_Alignas(4) const uint32_t %s[] = {",
            name, name, name, result->size, name);
    const uint8_t *bytes = (const uint8_t *)result->scene;
    for (size_t i = 0; i < result->size; i += 4) {
        uint32_t word = 0; /* a ready-made blob may end inside a word */
        memcpy(&word, bytes + i, result->size - i < 4 ? result->size - i : 4);
        fprintf(sink.stream, "%s0x%08x,", i % 32 ? " " : "\n    ", (unsigned)word);
    }
    fputs("\n};\n", sink.stream);
    return finish(&sink, path, ferror(sink.stream));
}

void pack_name(const char *path, char *name, size_t size)
{
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path, *dot = strrchr(base, '.');
    size_t length = dot && dot > base ? (size_t)(dot - base) : strlen(base), used = 0;
    if (size > 1 && isdigit((unsigned char)base[0]))
        name[used++] = '_';
    for (size_t i = 0; i < length && used + 1 < size; i++)
        name[used++] = isalnum((unsigned char)base[i]) ? base[i] : '_';
    name[used] = 0;
}
