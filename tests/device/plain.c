/* SPDX-License-Identifier: MIT */
/*
 * What effects cost that a scene does not have: draws each scene at its camera's size by a few methods, and prints
 * SCENE,METHOD,FORMAT,INSTRUCTIONS of the second of two frames. tests/tools/plain.sh compares it compiled for its
 * scenes, linked without the effects' files, and with everything.
 */
#include "scene/scene.h"
#include "tests/device/program.h"

#define MEMORY       (512u * 1024u)
#define BAND         (240u * 240u * 2u) /* bytes */
#define COUNT(array) (sizeof array / sizeof array[0])

static const struct glint_choice methods[] = {{"gouraud", &glint_gouraud}, {"x", &glint_x}};
static const struct {
    const char *name;
    uint8_t format, tables;
} formats[] = {{"rgb565", GLINT_RGB565, 1}, {"grey8", GLINT_GREY8, 1}};

static uint32_t plain_memory[MEMORY / 4], plain_band[BAND / 4];

static int plain_frame(struct glint_frame *frame, const void *scene)
{
    struct glint_band band;
    int error = glint_frame_begin(frame, scene, 0);
    while (error == 0 && glint_frame_next_band(frame, &band))
        ;
    return error;
}

static int plain_one(const struct program_scene *scene, unsigned method, unsigned format)
{
    const struct scene_camera *camera = &((const struct scene_header *)scene->blob)->camera;
    struct glint_frame frame;
    struct glint_config config = {.width = camera->reference_width,
                                  .height = camera->reference_height,
                                  .band_rows = camera->reference_height,
                                  .format = formats[format].format,
                                  .tables = formats[format].tables,
                                  .method = methods[method].method,
                                  .band = {plain_band},
                                  .memory = plain_memory,
                                  .memory_bytes = sizeof plain_memory};
    glint_fit_stores(&config, scene->blob);
    int error = glint_band_bytes(&config) > sizeof plain_band ? GLINT_E_MEMORY : glint_init(&frame, &config);
    if (error == 0)
        error = plain_frame(&frame, scene->blob);
    program_count_start();
    if (error == 0)
        error = plain_frame(&frame, scene->blob);
    const uint32_t count = program_count();
    const char *const words[] = {error ? "error," : "", scene->name, ",", methods[method].name, ",",
                                 formats[format].name,  ","};
    struct line line = {.length = 0};
    for (unsigned i = 0; i < COUNT(words); i++)
        line_text(&line, words[i]);
    line_decimal(&line, error ? (uint32_t)-error : count);
    line_end(&line);
    return error != 0;
}

int program_main(int argc, char **argv)
{
    int bad = 0;
    (void)argc;
    (void)argv;
    for (unsigned s = 0; s < program_scene_count; s++)
        for (unsigned m = 0; m < COUNT(methods); m++)
            for (unsigned f = 0; f < COUNT(formats); f++)
                bad |= plain_one(&program_scenes[s], m, f);
    return bad;
}
