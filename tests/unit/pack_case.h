/* SPDX-License-Identifier: MIT */
/* What the tests of scenes and packing share. Include after cmocka.h. */
#ifndef PACK_CASE_H
#define PACK_CASE_H

#include "listen.h"
#include "pack/pack.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A camera that suits anything of about one unit. */
#define CASE_CAMERA "\"camera\": {\"focal\": 100, \"near\": 1, \"far\": 9, \"position\": [0, 0, 5]}"

/* A file in a fresh folder under /tmp. */
struct case_file {
    char folder[32], path[64];
};

static inline void case_write(struct case_file *file, const char *name, const void *bytes, size_t size)
{
    strcpy(file->folder, "/tmp/glint-case-XXXXXX");
    assert_non_null(mkdtemp(file->folder));
    snprintf(file->path, sizeof file->path, "%s/%s", file->folder, name);
    FILE *out = fopen(file->path, "wb");
    assert_non_null(out);
    assert_int_equal(fwrite(bytes, 1, size, out), size);
    assert_int_equal(fclose(out), 0);
}

static inline void case_remove(struct case_file *file)
{
    unlink(file->path);
    rmdir(file->folder);
}

/* pack_load() with standard error caught in said[size]. */
static inline int case_load_path(const char *path, const struct pack_options *options, struct pack_result *result,
                                 char *said, size_t size)
{
    const struct listen errors = listen_begin(STDERR_FILENO);
    int code = pack_load(path, options, result);
    listen_end(&errors, said, size);
    return code;
}

/* The same of a file with this text. */
static inline int case_load(const char *name, const char *text, struct pack_result *result, char *said, size_t size)
{
    struct case_file file;
    case_write(&file, name, text, strlen(text));
    int code = case_load_path(file.path, NULL, result, said, size);
    case_remove(&file);
    return code;
}

/* A scene whose members besides the camera are given; it must load in silence. */
static inline struct pack_result case_scene(const char *members)
{
    char text[4096], said[1024];
    struct pack_result result;
    assert_true((size_t)snprintf(text, sizeof text, "{" CASE_CAMERA ", %s}", members) < sizeof text);
    assert_int_equal(case_load("scene.json", text, &result, said, sizeof said), 0);
    assert_string_equal(said, "");
    return result;
}

#endif
