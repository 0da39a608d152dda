/* SPDX-License-Identifier: MIT */
/* Scene blobs: what passes the check keeps all that scene.h promises, and what keeps it passes; it is drawn by every
 * method, in every format and in bands of any height, without harm and without a difference; nothing beside the blob is
 * read. Input: a blob, which bytes may follow. */
#include "fuzz/fuzz.h"
#include "fuzz/promises.h"
#include "glint.h"

enum { WIDTH = 20, HEIGHT = 14 };

/* Draws the moment into a picture that is the caller's to free. */
static uint8_t *draw(struct glint_config config, const struct scene_header *scene, uint32_t time_ms, uint32_t turn)
{
    const size_t row = glint_row_bytes(&config);
    struct glint_frame frame;
    struct glint_band band;
    config.memory_bytes = glint_memory_needed(&config);
    FUZZ_CHECK(config.memory_bytes > 0);
    config.memory = fuzz_block(config.memory_bytes);
    config.band[0] = fuzz_block(glint_band_bytes(&config));
    uint8_t *picture = fuzz_block(row * HEIGHT);
    unsigned rows = 0;
    FUZZ_CHECK(glint_init(&frame, &config) == 0);
    glint_turn(&frame, (uint16_t)(turn & 0xFFFF), (uint16_t)(turn >> 16));
    FUZZ_CHECK(glint_frame_begin(&frame, scene, time_ms) == 0);
    for (; glint_frame_next_band(&frame, &band); rows += band.rows) {
        FUZZ_CHECK(band.y == rows && band.y + band.rows <= HEIGHT);
        for (unsigned y = 0; y < band.rows; y++)
            memcpy(picture + (rows + y) * row, (uint8_t *)band.pixels + y * band.stride, row);
    }
    FUZZ_CHECK(rows == HEIGHT);
    FUZZ_CHECK(frame.stats.dropped == 0);
    free(config.memory);
    free(config.band[0]);
    return picture;
}

static void draw_all(const struct scene_header *scene, uint32_t dice)
{
    static const uint32_t moments[] = {0, 1, 500, 1000, 86400000, UINT32_MAX};
    const uint32_t turn = dice & 1 ? dice ^ dice >> 7 : 0, time = moments[(dice >> 4) % 6];
    for (unsigned i = 0; i < glint_choice_count; i++) {
        struct glint_config config = {.width = WIDTH,
                                      .height = HEIGHT,
                                      .band_rows = HEIGHT,
                                      .format = (uint8_t)((dice + i) % GLINT_FORMATS),
                                      .flags = dice & 2 ? GLINT_DITHER : 0,
                                      .tables = dice & 4 ? 1 : 0,
                                      .texture = (uint8_t)((dice >> 8) % GLINT_TEXTURES),
                                      .method = glint_choices[i].method};
        glint_fit_stores(&config, scene);
        uint8_t *whole = draw(config, scene, time, turn);
        config.band_rows = (uint16_t)((dice >> 12) % (HEIGHT - 1) + 1);
        uint8_t *bands = draw(config, scene, time, turn);
        FUZZ_CHECK(memcmp(whole, bands, glint_row_bytes(&config) * HEIGHT) == 0);
        free(whole);
        free(bands);
    }
}

static void judge(const uint8_t *blob, size_t size, enum scene_fault fault)
{
    struct promises promises = {.scene = (const struct scene_header *)(const void *)blob, .size = size};
    const char *broken = promises_broken(&promises);
    if (broken ? fault == SCENE_OK : fault != SCENE_OK && !promises.edge) {
        fprintf(stderr, "broken: fault %d, but %s\n", fault, broken ? broken : "all promises are kept");
        abort();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint8_t *blob = fuzz_block(size); /* aligned for anything */
    *blob = 0;
    if (size)
        memcpy(blob, data, size);
    const enum scene_fault fault = scene_check(blob, size);
    FUZZ_CHECK(scene_fault_text(fault)[0]);
    judge(blob, size, fault);
    FUZZ_CHECK(size < 2 || scene_check(blob + 2, size - 2) == SCENE_E_ALIGN);
    FUZZ_CHECK(glint_scene_check(blob, size) == (fault ? GLINT_E_SCENE : 0));
    if (!fault)
        draw_all((const struct scene_header *)(const void *)blob, scene_crc32(0, blob, (uint32_t)size));
    free(blob);
    return 0;
}
