/* SPDX-License-Identifier: MIT */
/*
 * What it costs to pack and check a picture for a stream: each scene at 240x240, turned on by a thirtieth of a turn in
 * four seconds, in bands of 30 rows, as PicoSystem does. One CSV line each: scene, format, codec, pixels,
 * bytes, instructions.
 */
#include "stream/stream.h"
#include "tests/device/program.h"

#define SIZE         240u
#define ROWS         30u
#define STEP         546u /* 1/65536 turns */
#define MEMORY       (1024u * 1024u)
#define COUNT(array) (sizeof array / sizeof array[0])

static uint32_t stream_memory[MEMORY / 4], stream_drawn[SIZE * ROWS * 2 / 4], stream_packed[SIZE * ROWS * 2 / 4],
    stream_last[SIZE * SIZE * 2 / 4];

static const struct {
    const char *name;
    const struct pack_format *pixels;
    uint8_t flags;
} kinds[] = {{"rgb565", &pack_rgb565, 0},
             {"rgb565 dithered", &pack_rgb565, GLINT_DITHER},
             {"grey8", &pack_grey8, 0},
             {"grey4 dithered", &pack_grey4, GLINT_DITHER}};

static int stream_count(void *context, const void *bytes, size_t size)
{
    (void)bytes;
    *(uint32_t *)context += size;
    return 0;
}

/* Draws and sends a picture: the instructions that sending took. */
static int stream_picture(struct stream *s, struct glint_frame *f, const void *scene, uint16_t yaw,
                          uint32_t *instructions)
{
    static const struct stream_frame frame = {0};
    static const struct stream_statistics statistics = {0};
    struct glint_band band;
    int error = 0;
    glint_turn(f, yaw, 0);
    if (glint_frame_begin(f, scene, 0) != 0)
        return 1;
    program_count_start();
    error |= stream_frame_begin(s, &frame);
    *instructions = program_count();
    while (glint_frame_next_band(f, &band)) {
        program_count_start();
        error |= stream_band(s, band.pixels, band.y, band.rows);
        *instructions += program_count();
    }
    program_count_start();
    error |= stream_frame_end(s, &statistics);
    *instructions += program_count();
    return error;
}

static int stream_measure(const struct program_scene *scene, unsigned kind, int last)
{
    struct glint_frame frame;
    struct glint_config config = {.width = SIZE,
                                  .height = SIZE,
                                  .band_rows = ROWS,
                                  .format = kinds[kind].pixels->format,
                                  .flags = kinds[kind].flags,
                                  .method = &glint_x,
                                  .band = {stream_drawn},
                                  .memory = stream_memory,
                                  .memory_bytes = sizeof stream_memory};
    uint32_t bytes = 0, before = 0, instructions = 0;
    struct stream s = {.write = stream_count,
                       .context = &bytes,
                       .pixels = kinds[kind].pixels,
                       .width = SIZE,
                       .height = SIZE,
                       .buffer = (uint8_t *)stream_packed,
                       .buffer_bytes = sizeof stream_packed,
                       .last = last ? (uint8_t *)stream_last : 0};
    struct line line = {.length = 0};
    glint_fit_stores(&config, scene->blob);
    if (glint_init(&frame, &config) != 0)
        return 1;
    for (unsigned i = 0; i < 2; i++) {
        before = bytes;
        if (stream_picture(&s, &frame, scene->blob, (uint16_t)(i * STEP), &instructions) != 0)
            return 1;
    }
    line_text(&line, scene->name);
    line_text(&line, ",");
    line_text(&line, kinds[kind].name);
    line_text(&line, last ? ",2," : ",1,");
    line_decimal(&line, SIZE * SIZE);
    line_text(&line, ",");
    line_decimal(&line, bytes - before);
    line_text(&line, ",");
    line_decimal(&line, instructions);
    line_end(&line);
    return 0;
}

int program_main(int argc, char **argv)
{
    (void)argc, (void)argv;
    int bad = 0;
    for (unsigned i = 0; i < program_scene_count; i++)
        for (unsigned kind = 0; kind < COUNT(kinds); kind++)
            for (int last = 0; last < 2; last++)
                bad |= stream_measure(&program_scenes[i], kind, last);
    return bad;
}
