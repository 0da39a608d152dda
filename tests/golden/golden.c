/* SPDX-License-Identifier: MIT */
/*
 * Prints the list of picture hashes, one line a picture of every scene by every method: scene, method, format, size,
 * time in ms and the CRC-32 of the frame's bands in order. Every picture is drawn whole, in bands of 1, 7 and 16 rows,
 * and whole without the plan; a hash that differs from the whole picture's is appended with its name, so that no such
 * line equals the list's. GOLDEN_SMALL keeps to what 16 KiB of RAM hold.
 */
#include "scene/scene.h"
#include "tests/device/program.h"

#ifdef GOLDEN_SMALL
#define GOLDEN_MEMORY 10240u
#define GOLDEN_BAND   (32u * 24u * 3u)
#else
#define GOLDEN_MEMORY (512u * 1024u)
#define GOLDEN_BAND   (96u * 72u * 3u)
#endif

struct golden_format {
    const char *name;
    uint8_t format, tables;
    uint8_t flags;
};

struct golden_variant {
    const char *name;
    uint16_t rows; /* 0: all */
    uint8_t flags;
};

static const struct golden_format formats[] = {
    {"rgb565", GLINT_RGB565, 0, 0},       {"rgb565-dither", GLINT_RGB565, 0, GLINT_DITHER},
    {"rgb888", GLINT_RGB888, 0, 0},       {"grey8", GLINT_GREY8, 0, 0},
    {"grey4", GLINT_GREY4, 0, 0},         {"grey4-dither", GLINT_GREY4, 0, GLINT_DITHER},
#ifndef GOLDEN_SMALL
    {"rgb565-table", GLINT_RGB565, 4, 0}, {"rgb888-table", GLINT_RGB888, 4, 0},
    {"grey8-table", GLINT_GREY8, 4, 0},
#endif
};

static const struct golden_variant variants[] = {
    {"whole", 0, 0}, {"rows-1", 1, 0}, {"rows-7", 7, 0}, {"rows-16", 16, 0}, {"no-plan", 0, GLINT_NO_PLAN}};

#define COUNT(array) (sizeof array / sizeof array[0])

static uint32_t golden_memory[GOLDEN_MEMORY / 4], golden_band[GOLDEN_BAND / 4];

/* The loops for one format and all there is to a format are in these methods; for the others two formats do. */
static int golden_wants(const struct glint_choice *method, const struct golden_format *format)
{
    static const struct glint_method *const all[] = {&glint_flat, &glint_gouraud, &glint_x, &glint_phong};
    if (format->tables)
        return method->method == &glint_x || method->method == &glint_six || method->method == &glint_auto ||
               (format->format == GLINT_GREY8 &&
                (method->method == &glint_duff || method->method == &glint_bump_linear ||
                 method->method == &glint_bump_quadratic || method->method == &glint_bump_normalised));
    int wanted = !format->flags && (format->format == GLINT_RGB565 || format->format == GLINT_GREY8);
    for (unsigned i = 0; i < COUNT(all); i++)
        wanted |= method->method == all[i];
    return wanted;
}

/* Hashed is what a little-endian machine holds: pixels of 16 bits are turned round on another. */
static void golden_order(const struct glint_config *config, const struct glint_band *band)
{
    uint16_t *pixels = band->pixels, *end = pixels + band->rows * band->stride / 2;
    if (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__ && config->format == GLINT_RGB565)
        for (; pixels != end; pixels++)
            *pixels = __builtin_bswap16(*pixels);
}

/* The hash of one picture; 0 and a complaint in `line` if it could not be drawn. */
static uint32_t golden_hash(struct glint_config *config, const struct scene_header *scene, uint32_t time_ms,
                            struct line *line)
{
    struct glint_frame frame;
    struct glint_band band;
    uint32_t hash = 0;
    glint_fit_stores(config, scene);
    config->band[0] = golden_band;
    config->memory = golden_memory;
    config->memory_bytes = sizeof golden_memory;
    int error = glint_band_bytes(config) > sizeof golden_band ? GLINT_E_MEMORY : glint_init(&frame, config);
    if (error == 0)
        error = glint_frame_begin(&frame, scene, time_ms);
    if (error != 0) {
        line_text(line, " error-");
        line_decimal(line, (uint32_t)-error);
        return 0;
    }
    while (glint_frame_next_band(&frame, &band)) {
        golden_order(config, &band);
        hash = scene_crc32(hash, band.pixels, band.rows * band.stride);
    }
    if (frame.stats.dropped)
        line_text(line, " dropped");
    return hash;
}

static int golden_picture(const struct program_scene *scene, const struct glint_choice *method,
                          const struct golden_format *format, uint32_t time_ms)
{
    int small = text_equal(scene->name, "mini");
    struct line line = {.length = 0};
    uint32_t whole = 0;
    int bad = 0;
    for (unsigned v = 0; v < COUNT(variants); v++) {
        struct glint_config config = {.width = small ? 32 : 96, .height = small ? 24 : 72, .method = method->method};
        config.format = format->format;
        config.tables = format->tables;
        config.flags = (uint8_t)(format->flags | variants[v].flags);
        config.band_rows = variants[v].rows ? variants[v].rows : config.height;
        if (v == 0) {
            const char *const words[] = {scene->name, " ",          method->name,
                                         " ",         format->name, small ? " 32x24 " : " 96x72 "};
            for (unsigned i = 0; i < COUNT(words); i++)
                line_text(&line, words[i]);
            line_decimal(&line, time_ms);
            line_text(&line, " ");
        }
        uint32_t hash = golden_hash(&config, (const void *)scene->blob, time_ms, &line);
        if (v == 0) {
            whole = hash;
            line_hex(&line, hash);
        } else if (hash != whole) {
            line_text(&line, " ");
            line_text(&line, variants[v].name);
            line_text(&line, "=");
            line_hex(&line, hash);
            bad = 1;
        }
    }
    line_end(&line);
    return bad;
}

int program_main(int argc, char **argv)
{
    (void)argc, (void)argv;
    int bad = 0;
    for (unsigned s = 0; s < program_scene_count; s++) {
        const struct program_scene *scene = &program_scenes[s];
        if (glint_scene_check(scene->blob, *scene->length) != 0) {
            program_write(glint_scene_problem(scene->blob, *scene->length));
            return 1;
        }
        uint32_t duration = ((const struct scene_header *)(const void *)scene->blob)->duration_ms;
        for (unsigned m = 0; m < glint_choice_count; m++)
            for (unsigned f = 0; f < COUNT(formats); f++) {
                if (!golden_wants(&glint_choices[m], &formats[f]))
                    continue;
                bad |= golden_picture(scene, &glint_choices[m], &formats[f], 0);
                if (duration)
                    bad |= golden_picture(scene, &glint_choices[m], &formats[f], duration * 3 / 8);
            }
    }
    return bad;
}
