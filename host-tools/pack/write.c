/* SPDX-License-Identifier: MIT */
#include "pack/pack.h"

#include "host/sink.h"
#include "pack/order.h"

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
        word = order_is_swapped(result->scene) ? __builtin_bswap32(word) : word; /* its compiler has that order */
        fprintf(sink.stream, "%s0x%08x,", i % 32 ? " " : "\n    ", (unsigned)word);
    }
    fputs("\n};\n", sink.stream);
    return finish(&sink, path, ferror(sink.stream));
}

/* C11's and C23's keywords, those of GNU C, and what else a file that includes stdint.h cannot define. */
static bool is_taken(const char *name)
{
    static const char words[] =
        " alignas alignof asm auto bool break case char const constexpr continue default do double else enum extern "
        "false float for goto if inline int long main nullptr register restrict return short signed sizeof static "
        "static_assert struct switch thread_local true typedef typeof typeof_unqual union unsigned void volatile while "
        "_Alignas _Alignof _Atomic _BitInt _Bool _Complex _Decimal128 _Decimal32 _Decimal64 _Generic _Imaginary "
        "_Noreturn _Static_assert _Thread_local linux unix "
        "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t intptr_t uintptr_t intmax_t uintmax_t ";
    const size_t length = strlen(name);
    const char *at = words;
    while (length && (at = strstr(at, name)) && !(at[-1] == ' ' && at[length] == ' '))
        at++;
    return length && at;
}

bool pack_is_name(const char *name)
{
    bool ok = (isalpha((unsigned char)*name) || *name == '_') && !is_taken(name);
    for (; ok && *name; name++)
        ok = isalnum((unsigned char)*name) || *name == '_';
    return ok;
}

static void spell(const char *prefix, const char *path, char *name, size_t size)
{
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path, *dot = strrchr(base, '.');
    const size_t length = dot && dot > base ? (size_t)(dot - base) : strlen(base);
    snprintf(name, size, "%s%s%.*s", prefix, isdigit((unsigned char)*base) ? "_" : "", (int)length, base);
    for (; *name; name++)
        *name = isalnum((unsigned char)*name) ? *name : '_';
}

void pack_name(const char *path, char *name, size_t size)
{
    spell("", path, name, size);
    if (!pack_is_name(name))
        spell("scene_", path, name, size);
}
