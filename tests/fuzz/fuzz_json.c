/* SPDX-License-Identifier: MIT */
/* Scene files: any text becomes a scene that passes the check and is drawn, or one message and exit code 1; nothing is
 * leaked, and no file is written. */
#define _GNU_SOURCE
#include "fuzz/fuzz.h"
#include "glint.h"
#include "pack/pack.h"

#include <sys/mman.h>
#include <unistd.h>

enum { WIDTH = 20, HEIGHT = 14 };

static void draw(const struct pack_result *packed)
{
    struct glint_config config = {
        .width = WIDTH, .height = HEIGHT, .band_rows = HEIGHT, .format = GLINT_RGB888, .method = &glint_auto};
    struct glint_frame frame;
    struct glint_band band;
    FUZZ_CHECK(glint_scene_check(packed->scene, packed->size) == 0);
    glint_fit_stores(&config, packed->scene);
    config.memory_bytes = glint_memory_needed(&config);
    config.memory = fuzz_block(config.memory_bytes);
    config.band[0] = fuzz_block(glint_band_bytes(&config));
    FUZZ_CHECK(glint_init(&frame, &config) == 0);
    FUZZ_CHECK(glint_frame_begin(&frame, packed->scene, 700) == 0);
    while (glint_frame_next_band(&frame, &band))
        ;
    free(config.memory);
    free(config.band[0]);
}

/* A file of these bytes in memory, by a name that ends as a scene's does. */
static int fuzz_file(const uint8_t *data, size_t size, char path[64])
{
    static char folder[] = "/tmp/glint-fuzz-XXXXXX";
    static bool made;
    if (!made && !mkdtemp(folder))
        abort();
    made = true;
    int file = memfd_create("scene", 0);
    FUZZ_CHECK(file >= 0 && write(file, data, size) == (ssize_t)size);
    char target[64];
    snprintf(target, sizeof target, "/proc/self/fd/%d", file);
    snprintf(path, 64, "%s/a.json", folder);
    unlink(path);
    FUZZ_CHECK(symlink(target, path) == 0);
    return file;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char path[64], *told = NULL;
    size_t told_size = 0;
    struct pack_result packed;
    FILE *was = stderr, *heard = open_memstream(&told, &told_size);
    int file = fuzz_file(data, size, path);
    FUZZ_CHECK(heard);
    stderr = heard;
    int code = pack_load(path, NULL, &packed);
    fclose(heard);
    stderr = was;
    close(file);
    unlink(path);
    const char *end = strchr(told, '\n');
    FUZZ_CHECK(code == 0 ? told_size == 0 : code == 1 && end && !end[1] && strncmp(told, path, strlen(path)) == 0);
    for (size_t i = 0; i + 1 < told_size; i++)
        FUZZ_CHECK((unsigned char)told[i] >= ' ');
    if (code == 0)
        draw(&packed);
    pack_free(&packed);
    free(told);
    return 0;
}
