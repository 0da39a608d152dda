/* SPDX-License-Identifier: MIT */
#include "import/limits.h"

#include "scene/model.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#define MOST_MEMORY (4ul << 30)

static unsigned long file_size(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 ? (unsigned long)status.st_size : 0;
}

/* The file is beside the .gltf. Data inside it, as "data:...", is no file's name. */
static unsigned long buffer_size(const char *path, const json_t *buffer)
{
    const char *uri = json_string_value(json_object_get(buffer, "uri")), *slash = strrchr(path, '/');
    if (!uri || !strncmp(uri, "data:", 5))
        return 0;
    const size_t folder = slash ? (size_t)(slash - path) + 1 : 0;
    char *name = model_alloc(folder + strlen(uri) + 1);
    memcpy(name, path, folder);
    strcpy(name + folder, uri);
    unsigned long size = file_size(name);
    free(name);
    return size;
}

/* An array of them, but in version 1 an object. */
static unsigned long buffers_size(const char *path)
{
    json_t *root = json_load_file(path, 0, NULL), *buffers = json_object_get(root, "buffers"), *buffer;
    unsigned long size = 0;
    const char *key;
    size_t i;
    json_array_foreach(buffers, i, buffer) size += buffer_size(path, buffer);
    json_object_foreach(buffers, key, buffer) size += buffer_size(path, buffer);
    json_decref(root);
    return size;
}

unsigned long limits_seconds(const char *path)
{
    const char *ending = strrchr(path, '.');
    unsigned long size = file_size(path);
    if (ending && !strcasecmp(ending, ".gltf"))
        size += buffers_size(path);
    return 5 + (size >> 20) * 3;
}

void limits_set(const char *path)
{
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    if (!LIMITS_SANITIZED)
        setrlimit(RLIMIT_AS, &(struct rlimit){MOST_MEMORY, MOST_MEMORY});
    const rlim_t seconds = limits_seconds(path);
    setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds});
    alarm((unsigned)(60 + 4 * seconds)); /* in case it waits for a pipe that the file names */
}
