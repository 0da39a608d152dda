/* SPDX-License-Identifier: MIT */
#include "pack/pack.h"

#include "import/import.h"
#include "pack/blob.h"
#include "pack/frame.h"
#include "pack/report.h"
#include "scene/reader.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define MOST_BLOB (1l << 30)

static int fail(const char *path, const char *reason, int code)
{
    fprintf(stderr, "%s: %s\n", path, reason);
    return code;
}

static int read_blob(const char *path, struct pack_result *result)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return fail(path, strerror(errno), PACK_IO);
    long size = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    rewind(file);
    void *bytes = malloc(size > 0 && size <= MOST_BLOB ? (size_t)size : 1);
    bool complete = size >= 0 && size <= MOST_BLOB && bytes && fread(bytes, 1, (size_t)size, file) == (size_t)size;
    fclose(file);
    if (!complete) {
        free(bytes);
        return fail(path, size > MOST_BLOB ? "larger than 1 GiB" : "cannot be read", PACK_IO);
    }
    enum scene_fault fault = scene_check(bytes, (size_t)size);
    if (fault) {
        free(bytes);
        return fail(path, scene_fault_text(fault), PACK_BAD_DATA);
    }
    result->scene = bytes;
    result->size = result->scene->length; /* less than the file's if something follows */
    return PACK_OK;
}

static int build(const char *path, int (*load)(const char *, struct model *), unsigned shininess,
                 struct pack_result *result)
{
    struct model model;
    int code = load(path, &model);
    if (code)
        return code;
    for (size_t i = 0; shininess && i < model.material_count; i++)
        model.materials[i].shininess = shininess; /* here, so that there is one table */
    code = blob_build(&model, path, result);
    model_free(&model);
    return code;
}

int pack_load(const char *path, const struct pack_options *options, struct pack_result *result)
{
    const char *ending = strrchr(path, '.');
    const unsigned shininess = options ? options->shininess : 0;
    *result = (struct pack_result){0};
    int code = import_check_readable(path);
    if (code)
        return code;
    if (ending && !strcasecmp(ending, ".json"))
        return build(path, reader_load, shininess, result);
    if (import_knows(path))
        return build(path, frame_load, shininess, result);
    if (!ending || strcasecmp(ending, ".glt") != 0)
        return fail(path, "not a kind of file that is known: .json .glt .obj .ply .stl .gltf .glb", PACK_BAD_DATA);
    code = read_blob(path, result);
    if (!code && shininess)
        blob_override_shininess((struct scene_header *)(uintptr_t)result->scene, shininess);
    return code;
}

void pack_free(struct pack_result *result)
{
    free((void *)(uintptr_t)result->scene);
    for (size_t i = 0; result->report && i < result->report->mesh_count; i++)
        free(result->report->meshes[i].name);
    for (size_t i = 0; result->report && i < result->report->texture_count; i++)
        free(result->report->textures[i].name);
    if (result->report) {
        free(result->report->meshes);
        free(result->report->textures);
    }
    free(result->report);
    *result = (struct pack_result){0};
}
