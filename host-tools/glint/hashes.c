/* SPDX-License-Identifier: MIT */
#include "glint/hashes.h"

#include "glint/cli.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HASHES_MAX   1000000u
#define HASHES_BLANK " \t\r\n"

static int hashes_add(struct hashes *hashes, uint32_t hash, unsigned line)
{
    if ((hashes->count & (hashes->count - 1)) == 0) { /* full at each power of two */
        size_t room = hashes->count ? 2 * hashes->count : 1;
        struct hashes_entry *entry = realloc(hashes->entry, room * sizeof *entry);
        if (!entry) {
            fprintf(stderr, "%s: out of memory\n", hashes->path);
            return CLI_IO;
        }
        hashes->entry = entry;
    }
    hashes->entry[hashes->count++] = (struct hashes_entry){hash, line};
    return CLI_DONE;
}

/* One line of the list, its comment cut off. */
static int hashes_parse(struct hashes *hashes, const char *text, unsigned line)
{
    const char *number = text + strspn(text, HASHES_BLANK);
    size_t length = strspn(number, "0123456789");
    const char *digits = number + length + strspn(number + length, HASHES_BLANK);
    if (!*number)
        return CLI_DONE;
    if (length < 1 || length > 9 || digits == number + length || strspn(digits, "0123456789abcdefABCDEF") != 8 ||
        digits[8 + strspn(digits + 8, HASHES_BLANK)]) {
        fprintf(stderr, "%s:%u: not '<index> <hash of 8 hexadecimal digits>'\n", hashes->path, line);
        return CLI_BAD_DATA;
    }
    unsigned long index = strtoul(number, NULL, 10);
    if (index != hashes->count || index >= HASHES_MAX) {
        fprintf(stderr, "%s:%u: frame %lu where frame %zu was to come\n", hashes->path, line, index, hashes->count);
        return CLI_BAD_DATA;
    }
    return hashes_add(hashes, (uint32_t)strtoul(digits, NULL, 16), line);
}

int hashes_read(const char *path, struct hashes *hashes)
{
    char *text = NULL;
    size_t room = 0;
    int code = CLI_DONE;
    *hashes = (struct hashes){.path = path};
    FILE *file = fopen(path, "r");
    if (!file) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        return CLI_IO;
    }
    for (unsigned line = 1; !code && getline(&text, &room, file) >= 0; line++) {
        text[strcspn(text, "#")] = 0;
        code = hashes_parse(hashes, text, line);
    }
    if (!code && ferror(file)) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        code = CLI_IO;
    }
    free(text);
    fclose(file);
    if (code)
        hashes_free(hashes);
    return code;
}

int hashes_check(const struct hashes *hashes, uint32_t index, uint32_t hash)
{
    if (hashes->entry[index].hash == hash)
        return CLI_DONE;
    fprintf(stderr, "%s:%u: frame %u is %08x, expected %08x\n", hashes->path, hashes->entry[index].line,
            (unsigned)index, (unsigned)hash, (unsigned)hashes->entry[index].hash);
    return CLI_BAD_DATA;
}

int hashes_check_count(const struct hashes *hashes, uint32_t frames)
{
    if (hashes->count == frames)
        return CLI_DONE;
    fprintf(stderr, "%s: has %zu frames, %u are drawn: frame %zu is the first without its like\n", hashes->path,
            hashes->count, (unsigned)frames, hashes->count < frames ? hashes->count : (size_t)frames);
    return CLI_BAD_DATA;
}

void hashes_free(struct hashes *hashes)
{
    free(hashes->entry);
    *hashes = (struct hashes){0};
}
