/* SPDX-License-Identifier: MIT */
/* A folder for a run, and what is in it: names, modes and contents as one text. */
#ifndef PLACE_H
#define PLACE_H

#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

enum { PLACE_TEXT = 8192, PLACE_NAME = 512, PLACE_PATH = 2048, PLACE_FILES = 64 };

struct place_text {
    char text[PLACE_TEXT];
    size_t length;
};

static inline void place_fail(const char *what)
{
    perror(what);
    abort();
}

static inline void place_path(char path[PLACE_PATH], const char *folder, const char *name)
{
    if (snprintf(path, PLACE_PATH, "%s/%s", folder, name) >= PLACE_PATH)
        abort();
}

static inline unsigned long place_sum(const char *path)
{
    unsigned char bytes[65536];
    unsigned long sum = crc32(0, NULL, 0);
    FILE *file = fopen(path, "rb");
    for (size_t count; file && (count = fread(bytes, 1, sizeof bytes, file)) > 0;)
        sum = crc32(sum, bytes, (unsigned)count);
    if (file)
        fclose(file);
    return sum;
}

static int place_by_name(const void *a, const void *b)
{
    return strcmp(a, b);
}

/* The names in a folder, sorted: how many. */
static inline size_t place_names(const char *folder, char name[PLACE_FILES][PLACE_NAME])
{
    size_t count = 0;
    DIR *entries = opendir(folder);
    if (!entries)
        place_fail(folder);
    for (struct dirent *entry; (entry = readdir(entries));)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0) {
            if (count == PLACE_FILES)
                abort();
            snprintf(name[count++], PLACE_NAME, "%s", entry->d_name);
        }
    closedir(entries);
    qsort(name, count, PLACE_NAME, place_by_name);
    return count;
}

/* Adds a line for each file below a folder. */
static inline void place_add(const char *folder, struct place_text *out)
{
    char name[PLACE_FILES][PLACE_NAME], path[PLACE_PATH];
    size_t count = place_names(folder, name);
    for (size_t i = 0; i < count; i++) {
        struct stat status;
        place_path(path, folder, name[i]);
        if (lstat(path, &status) != 0)
            place_fail(path);
        const bool inner = S_ISDIR(status.st_mode);
        int length = snprintf(out->text + out->length, PLACE_TEXT - out->length, "%s%s %o %lx\n", path,
                              inner ? "/" : "", (unsigned)(status.st_mode & 07777), inner ? 0 : place_sum(path));
        if (length < 0 || (out->length += (size_t)length) >= PLACE_TEXT)
            abort();
        if (inner)
            place_add(path, out);
    }
}

static inline void place_look(const char *folder, struct place_text *out)
{
    out->length = 0;
    out->text[0] = 0;
    place_add(folder, out);
}

/* Whether what is there has no other names than those of `all`, whatever is in the files. */
static inline bool place_is_part(const struct place_text *there, const struct place_text *all)
{
    for (const char *line = there->text; *line; line = strchr(line, '\n') + 1) {
        const size_t length = strcspn(line, " ") + 1;
        const char *found = all->text;
        while (*found && strncmp(found, line, length) != 0)
            found = strchr(found, '\n') + 1;
        if (!*found)
            return false;
    }
    return true;
}

/* Removes all below a folder. */
static inline void place_clear(const char *folder)
{
    char name[PLACE_FILES][PLACE_NAME], path[PLACE_PATH];
    size_t count = place_names(folder, name);
    for (size_t i = 0; i < count; i++) {
        struct stat status;
        place_path(path, folder, name[i]);
        if (lstat(path, &status) == 0 && S_ISDIR(status.st_mode)) {
            place_clear(path);
            rmdir(path);
        } else {
            unlink(path);
        }
    }
}

/* Makes the folder, too, if it is in one. */
static inline void place_write(const char *path, const char *text)
{
    char folder[PLACE_NAME];
    snprintf(folder, sizeof folder, "%s", path);
    if (strchr(folder, '/') && folder[0] != '.') {
        *strchr(folder, '/') = 0;
        mkdir(folder, 0777);
    }
    FILE *file = fopen(path, "wb");
    if (!file || fputs(text, file) < 0 || fclose(file) != 0)
        place_fail(path);
}

#endif
