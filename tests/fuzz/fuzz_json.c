/* SPDX-License-Identifier: MIT */
/* Scene files: any text becomes a scene that passes the check and is drawn, or one message and exit code 1, or 3 for
 * what it names and is not there; nothing is leaked, and no file is written. Beside it are a.png, and whatever ends in
 * .obj: a triangle, since models are fuzz_mesh's. */
#define _GNU_SOURCE
#include "fuzz/load.h"
#include "import/import.h"

#include <math.h>

static const uint8_t picture[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
    0x00, 0x09, 0x00, 0x00, 0x00, 0x02, 0x01, 0x00, 0x00, 0x00, 0x00, 0xa2, 0x2d, 0xcb, 0x7e, 0x00, 0x00, 0x00,
    0x0e, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x58, 0xd5, 0xc0, 0x14, 0xca, 0x00, 0x00, 0x06, 0x08, 0x01,
    0x82, 0xe5, 0xce, 0x73, 0x65, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

int __wrap_import_file(const char *path, double crease, struct model *model, size_t mesh);
int __wrap_import_file(const char *path, double crease, struct model *model, size_t mesh)
{
    static const double place[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, normal[3] = {0, 0, 1};
    const char *ending = strrchr(path, '.');
    FUZZ_CHECK(crease >= 0 && crease <= M_PI);
    if (!ending || strcmp(ending, ".obj") != 0) {
        fprintf(stderr, "%s: no model\n", path);
        return 3;
    }
    for (int i = 0; i < 3; i++)
        model_add_vertex(&model->meshes[mesh], place[i], normal, place[i][0], place[i][1]);
    model_add_material(model, "a");
    model_add_triangle(&model->meshes[mesh], 0, 1, 2, (uint32_t)model->material_count - 1);
    model->meshes[mesh].has_uvs = true;
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char path[LOAD_PATH], path_beside[LOAD_PATH];
    int file = load_file("a.json", data, size, path);
    int beside = load_file("a.png", picture, sizeof picture, path_beside);
    struct load load = load_path(path);
    load_close(beside, path_beside);
    load_close(file, path);
    const char *end = strchr(load.told, '\n');
    if (load.code == 0) {
        FUZZ_CHECK(load.told_size == 0);
        load_draw(&load);
    } else {
        FUZZ_CHECK(end && !end[1] && (load.code == 3 || strncmp(load.told, path, strlen(path)) == 0));
        FUZZ_CHECK(load.code == 1 || (load.code == 3 && strncmp(load.told, path, strlen(path)) != 0));
    }
    load_free(&load);
    return 0;
}
