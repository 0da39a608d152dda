/* SPDX-License-Identifier: MIT */
/*
 * Draws the common benchmark (320x240, RGB565, 16-bit depth, clear included) and counts instructions.
 *   bench                                every scene, principal method and band count: one CSV line each
 *   bench grey8|rgb888 [METHOD...]       every scene by every method, or those, one frame at the camera's size, with
 *                                        tables; the last number is the picture's, the same on every CPU
 *   bench budget                         every scene by auto within each of some budgets, likewise in 8-bit grey
 *   bench power                          the first scene by x, likewise, with each form and some exponents of the
 *                                        highlight's power
 *   bench SCENE METHOD BANDS TABLES N [grey8|rgb888]
 *                                        one of them, N frames, nothing printed: for profilers, which look at the calls
 *                                        of bench_frame()
 * An argument budget=N sets auto's, in 1/255; texture=N is of enum glint_texture.
 */
#include "scene/scene.h"
#include "tests/device/program.h"

#define MEMORY         (1536u * 1024u)
#define BAND           (320u * 240u * 3u) /* bytes */
#define BLOB           (128u * 1024u)     /* bytes: a scene whose exponents are changed */
#define COUNT(array)   (sizeof array / sizeof array[0])
#define CALIBRATE_TURN 1000000u

static const struct glint_choice principal[] = {
    {"flat", &glint_flat}, {"gouraud", &glint_gouraud}, {"x", &glint_x}, {"phong", &glint_phong}};

static const struct {
    const char *name;
    const struct glint_power *power;
} powers[] = {
    {"table", 0}, {"exact", &glint_power_exact}, {"4", &glint_power_4}, {"8", &glint_power_8}, {"16", &glint_power_16}};
static const uint16_t exponents[] = {5, 20, 50, 200};
static const uint16_t budgets[] = {1 << 7, 1 << 8, 2 << 8, 4 << 8, 8 << 8, 16 << 8, 32 << 8};

static uint16_t bench_budget; /* of auto, Q8 in 1/255; 0: its default */
static uint8_t bench_texture; /* enum glint_texture */
static uint32_t bench_memory[MEMORY / 4], bench_band[BAND / 4], bench_blob[BLOB / 4];

int bench_frame(struct glint_frame *frame, const void *scene, uint32_t time_ms);

/* One frame: what the profilers measure. */
__attribute__((noinline)) int bench_frame(struct glint_frame *frame, const void *scene, uint32_t time_ms)
{
    struct glint_band band;
    int error = glint_frame_begin(frame, scene, time_ms);
    if (error == 0)
        while (glint_frame_next_band(frame, &band))
            ;
    return error;
}

static int bench_init(struct glint_frame *frame, struct glint_config *config, const void *scene,
                      const struct glint_choice *method, const struct glint_power *power, enum glint_format format,
                      unsigned bands, uint8_t tables)
{
    const struct scene_camera *camera = &((const struct scene_header *)scene)->camera;
    *config = (struct glint_config){.width = camera->reference_width, .height = camera->reference_height};
    config->format = (uint8_t)format;
    config->method = method->method;
    config->power = power;
    config->budget = bench_budget;
    config->texture = bench_texture;
    config->tables = tables;
    config->band_rows = (uint16_t)((config->height + bands - 1) / bands);
    glint_fit_stores(config, scene);
    config->band[0] = bench_band;
    config->memory = bench_memory;
    config->memory_bytes = sizeof bench_memory;
    return glint_band_bytes(config) > sizeof bench_band ? GLINT_E_MEMORY : glint_init(frame, config);
}

static void bench_fields(struct line *line, const uint32_t *values, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        line_text(line, ",");
        line_decimal(line, values[i]);
    }
    line_end(line);
}

static int bench_complain(const char *scene, const char *method, int error)
{
    struct line line = {.length = 0};
    line_text(&line, "error,");
    line_text(&line, scene);
    line_text(&line, ",");
    line_text(&line, method);
    line_text(&line, ",");
    line_decimal(&line, (uint32_t)-error);
    line_end(&line);
    return 1;
}

/* The cost of one frame that holds every triangle, of many in a row: tables were filled by the one before. */
static int bench_cost(const void *blob, const struct glint_choice *method, const struct glint_power *power,
                      enum glint_format format, struct glint_config *config, uint32_t *instructions)
{
    struct glint_frame frame;
    int error = bench_init(&frame, config, blob, method, power, format, 1, 4);
    for (int i = 0; i < 2 && error == 0; i++) {
        program_count_start();
        error = bench_frame(&frame, blob, 0);
        *instructions = program_count();
    }
    return error == 0 && frame.stats.dropped ? GLINT_E_MEMORY : error;
}

static uint32_t bench_hash(const struct glint_config *config)
{
    uint32_t hash = 2166136261u;
    for (uint32_t i = 0; i < glint_band_bytes(config); i++)
        hash = (hash ^ ((const uint8_t *)bench_band)[i]) * 16777619u;
    return hash;
}

static int bench_whole(const struct program_scene *scene, const struct glint_choice *method, enum glint_format format)
{
    struct glint_config config;
    uint32_t instructions = 0;
    int error = bench_cost(scene->blob, method, 0, format, &config, &instructions);
    if (error != 0)
        return bench_complain(scene->name, method->name, error);
    struct line line = {.length = 0};
    line_text(&line, scene->name);
    line_text(&line, ",");
    line_text(&line, method->name);
    line_text(&line, ",");
    line_decimal(&line, config.width);
    line_text(&line, ",");
    line_decimal(&line, config.height);
    line_text(&line, format == GLINT_GREY8 ? ",grey8," : ",rgb888,");
    line_decimal(&line, instructions);
    line_text(&line, ",");
    line_hex(&line, bench_hash(&config));
    line_end(&line);
    return 0;
}

static int bench_within(const struct program_scene *scene, uint16_t budget)
{
    static const struct glint_choice method = {"auto", &glint_auto};
    struct glint_config config;
    uint32_t instructions = 0;
    bench_budget = budget;
    int error = bench_cost(scene->blob, &method, 0, GLINT_GREY8, &config, &instructions);
    if (error != 0)
        return bench_complain(scene->name, method.name, error);
    struct line line = {.length = 0};
    line_text(&line, scene->name);
    const uint32_t values[] = {budget, instructions};
    bench_fields(&line, values, COUNT(values));
    return 0;
}

/* A copy of the scene in which every material has this exponent. */
static const void *bench_sharpen(const struct program_scene *scene, unsigned exponent)
{
    struct scene_header *copy = (struct scene_header *)bench_blob;
    for (uint32_t i = 0; i < *scene->length / 4; i++)
        bench_blob[i] = scene->blob[i];
    struct scene_material *materials = (struct scene_material *)((uint8_t *)bench_blob + copy->materials);
    if (copy->power_count)
        fx_power_build((struct fx_power *)((uint8_t *)bench_blob + copy->powers), exponent);
    for (unsigned i = 0; copy->power_count && i < copy->material_count; i++) {
        materials[i].shininess = (uint16_t)exponent;
        materials[i].power = 0;
    }
    return bench_blob;
}

static int bench_power(const struct program_scene *scene, unsigned exponent, unsigned form)
{
    static const struct glint_choice x = {"x", &glint_x};
    struct glint_config config;
    uint32_t instructions = 0;
    int error = *scene->length > sizeof bench_blob ? GLINT_E_MEMORY : 0;
    if (error == 0)
        error = bench_cost(bench_sharpen(scene, exponent), &x, powers[form].power, GLINT_GREY8, &config, &instructions);
    if (error != 0)
        return bench_complain(scene->name, powers[form].name, error);
    struct line line = {.length = 0};
    line_text(&line, scene->name);
    line_text(&line, ",");
    line_text(&line, powers[form].name);
    const uint32_t values[] = {exponent, instructions};
    bench_fields(&line, values, COUNT(values));
    return 0;
}

static int bench_one(const struct program_scene *scene, const struct glint_choice *method, unsigned bands,
                     uint8_t tables)
{
    struct glint_config config;
    struct glint_frame frame;
    uint32_t instructions[2] = {0, 0};
    int error = bench_init(&frame, &config, scene->blob, method, 0, GLINT_RGB565, bands, tables);
    for (int i = 0; i < 2 && error == 0; i++) {
        program_count_start();
        error = bench_frame(&frame, scene->blob, 0);
        instructions[i] = program_count();
    }
    if (error != 0)
        return bench_complain(scene->name, method->name, error);
    struct line line = {.length = 0};
    uint32_t drawn = 0, pixels = 0;
    for (int i = 0; i < GLINT_METHODS; i++) {
        drawn += frame.stats.drawn[i];
        pixels += frame.stats.pixels[i];
    }
    line_text(&line, scene->name);
    line_text(&line, ",");
    line_text(&line, method->name);
    const uint32_t values[] = {bands,
                               tables,
                               instructions[0],
                               instructions[1],
                               (uint32_t)glint_memory_needed(&config),
                               (uint32_t)glint_band_bytes(&config),
                               drawn,
                               pixels,
                               frame.stats.setups};
    bench_fields(&line, values, COUNT(values));
    return 0;
}

/* A loop of two instructions a turn shows what a tick of the counter is worth. */
static void bench_calibrate(void)
{
#ifdef __arm__
    uint32_t turns = CALIBRATE_TURN;
    program_count_start();
    __asm volatile("1: sub %0, %0, #1\n cmp %0, #0\n bne 1b" : "+l"(turns) : : "cc");
    uint32_t counted = program_count();
    struct line line = {.length = 0};
    line_text(&line, "# calibration: a loop of ");
    line_decimal(&line, 3 * CALIBRATE_TURN);
    line_text(&line, " instructions is counted as ");
    line_decimal(&line, counted);
    line_end(&line);
#endif
}

/* Whether a method is among those named, or none is. */
static int bench_asked(const char *method, int argc, char **argv)
{
    int asked = argc == 2;
    for (int i = 2; i < argc; i++)
        asked |= text_equal(argv[i], method);
    return asked;
}

/* The number of `NAME=N` among the arguments, 0 without it; `name` ends in =. */
static uint32_t bench_find(const char *name, int argc, char **argv)
{
    uint32_t number = 0;
    for (int i = 1; i < argc; i++) {
        unsigned k = 0;
        while (name[k] && argv[i][k] == name[k])
            k++;
        if (!name[k])
            number = text_number(argv[i] + k);
    }
    return number;
}

static enum glint_format bench_format(const char *name)
{
    return !name ? GLINT_RGB565 : text_equal(name, "grey8") ? GLINT_GREY8 : GLINT_RGB888;
}

static int bench_run(const struct program_scene *scene, const struct glint_choice *method, int argc, char **argv)
{
    struct glint_config config;
    struct glint_frame frame;
    if (bench_init(&frame, &config, scene->blob, method, 0, bench_format(argc > 6 ? argv[6] : 0), text_number(argv[3]),
                   (uint8_t)text_number(argv[4])) != 0)
        return 1;
    for (uint32_t i = text_number(argv[5]); i; i--)
        if (bench_frame(&frame, scene->blob, 0) != 0)
            return 1;
    return 0;
}

int program_main(int argc, char **argv)
{
    int bad = 0;
    bench_budget = (uint16_t)(bench_find("budget=", argc, argv) << 8);
    bench_texture = (uint8_t)bench_find("texture=", argc, argv);
    if (argc >= 2 && (text_equal(argv[1], "grey8") || text_equal(argv[1], "rgb888"))) {
        const enum glint_format format = bench_format(argv[1]);
        for (unsigned s = 0; s < program_scene_count; s++)
            for (unsigned m = 0; m < glint_choice_count; m++)
                if (bench_asked(glint_choices[m].name, argc, argv))
                    bad |= bench_whole(&program_scenes[s], &glint_choices[m], format);
        return bad;
    }
    if (argc == 2 && text_equal(argv[1], "budget")) {
        for (unsigned s = 0; s < program_scene_count; s++)
            for (unsigned b = 0; b < COUNT(budgets); b++)
                bad |= bench_within(&program_scenes[s], budgets[b]);
        return bad;
    }
    if (argc == 2 && text_equal(argv[1], "power")) {
        for (unsigned e = 0; e < COUNT(exponents); e++)
            for (unsigned form = 0; form < COUNT(powers); form++)
                bad |= bench_power(&program_scenes[0], exponents[e], form);
        return bad;
    }
    if (argc < 6) {
        bench_calibrate();
        for (unsigned s = 0; s < program_scene_count; s++)
            for (unsigned m = 0; m < COUNT(principal); m++)
                for (uint8_t bands = 1; bands <= 8; bands += 7)
                    for (uint8_t tables = 0; tables <= (principal[m].method == &glint_x); tables++)
                        bad |= bench_one(&program_scenes[s], &principal[m], bands, tables);
        return bad;
    }
    for (unsigned s = 0; s < program_scene_count; s++)
        for (unsigned m = 0; m < glint_choice_count; m++)
            if (text_equal(argv[1], program_scenes[s].name) && text_equal(argv[2], glint_choices[m].name))
                return bench_run(&program_scenes[s], &glint_choices[m], argc, argv);
    program_write("bench: no such scene or method\n");
    return 2;
}
