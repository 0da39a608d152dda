/* SPDX-License-Identifier: MIT */
/* Files of any bytes, which are given a name, loaded as `glint` does, and drawn. The file before this has _GNU_SOURCE.
 */
#ifndef LOAD_H
#define LOAD_H

#include "fuzz/fuzz.h"
#include "glint.h"
#include "pack/pack.h"

#include <sys/mman.h>
#include <unistd.h>

enum { LOAD_PATH = 64, LOAD_WIDTH = 20, LOAD_HEIGHT = 14 };

struct load {
    struct pack_result packed; /* if the code is 0 */
    int code;
    char *told; /* what was printed; the size counts no zero byte at its end */
    size_t told_size;
};

static char load_folder[] = "/tmp/glint-fuzz-XXXXXX";
static pid_t load_process; /* whose folder it is */

static void load_leave(void)
{
    if (getpid() == load_process)
        rmdir(load_folder);
}

/* A file of these bytes in memory, as `name` in the folder: its descriptor. */
static int load_file(const char *name, const uint8_t *data, size_t size, char path[LOAD_PATH])
{
    char target[LOAD_PATH];
    if (!load_process) {
        FUZZ_CHECK(mkdtemp(load_folder) && atexit(load_leave) == 0);
        load_process = getpid();
    }
    int file = memfd_create(name, 0);
    FUZZ_CHECK(file >= 0 && write(file, data, size) == (ssize_t)size);
    snprintf(target, sizeof target, "/proc/self/fd/%d", file);
    snprintf(path, LOAD_PATH, "%s/%s", load_folder, name);
    unlink(path);
    FUZZ_CHECK(symlink(target, path) == 0);
    return file;
}

static void load_close(int file, const char *path)
{
    close(file);
    unlink(path);
}

/* What was printed is lines of letters, none that a terminal obeys; what was loaded passes the check. */
static struct load load_path(const char *path)
{
    struct load load = {0};
    FILE *was = stderr, *heard = open_memstream(&load.told, &load.told_size);
    FUZZ_CHECK(heard);
    stderr = heard;
    load.code = pack_load(path, NULL, &load.packed);
    fclose(heard);
    stderr = was;
    for (size_t i = 0; i < load.told_size; i++) {
        const unsigned char *at = (const unsigned char *)load.told + i; /* a zero byte follows the last */
        FUZZ_CHECK((*at >= ' ' && *at != 0x7f) || *at == '\n');
        FUZZ_CHECK(at[0] != 0xc2 || at[1] >= 0xa0);
    }
    FUZZ_CHECK(load.told_size == 0 || load.told[load.told_size - 1] == '\n');
    FUZZ_CHECK(load.code || glint_scene_check(load.packed.scene, load.packed.size) == 0);
    return load;
}

static void load_draw(const struct load *load)
{
    struct glint_config config = {.width = LOAD_WIDTH,
                                  .height = LOAD_HEIGHT,
                                  .band_rows = LOAD_HEIGHT,
                                  .format = GLINT_RGB888,
                                  .method = &glint_auto};
    struct glint_frame frame;
    struct glint_band band;
    glint_fit_stores(&config, load->packed.scene);
    config.memory_bytes = glint_memory_needed(&config);
    config.memory = fuzz_block(config.memory_bytes);
    config.band[0] = fuzz_block(glint_band_bytes(&config));
    FUZZ_CHECK(glint_init(&frame, &config) == 0);
    FUZZ_CHECK(glint_frame_begin(&frame, load->packed.scene, 700) == 0);
    while (glint_frame_next_band(&frame, &band))
        ;
    free(config.memory);
    free(config.band[0]);
}

static void load_free(struct load *load)
{
    pack_free(&load->packed);
    free(load->told);
}

#endif
