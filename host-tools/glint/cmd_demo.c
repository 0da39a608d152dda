/* SPDX-License-Identifier: MIT */
#include "compare/compare.h"
#include "glint/cli.h"
#include "glint/commands.h"
#include "glint/label.h"
#include "glint/output.h"
#include "glint/progress.h"
#include "glint/renderer.h"
#include "reference/reference.h"
#include "scene/model.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define DEMO_PANELS 4
#define DEMO_GAP    4u  /* pixels between panels */
#define DEMO_STRIP  28u /* rows for the labels */

static const char demo_name[] = "glint demo";

static const char demo_help[] =
    "usage: glint demo SCENE FOLDER [OPTION]...\n\n"
    "Draws one loop of a scene's animation by Gouraud, X-shading, auto with its budget of 2/255 and per-pixel Phong,\n"
    "side by side, into FOLDER/frame-0000.png ... and the animated FOLDER/demo.png, and prints what each method "
    "costs.\n\n"
    "      --frames N   1..10000, default 48\n"
    "      --height H   of a panel in pixels, 16..1024, default 240; the width follows the camera\n"
    "      --help\n";

static const char *const demo_methods[DEMO_PANELS] = {"gouraud", "x", "auto", "phong"};
static const char *const demo_labels[DEMO_PANELS] = {"GOURAUD", "X-SHADING", "AUTO", "PHONG"};

struct demo {
    const char *path; /* of the scene */
    const struct scene_header *scene;
    struct renderer renderer[DEMO_PANELS];
    double milliseconds[DEMO_PANELS]; /* of the quickest frame: the least disturbed by other work */
    double psnr_db[DEMO_PANELS];
    unsigned panel_width, panel_height, width, height; /* of a panel, and of the picture */
    uint32_t frames, duration_ms;
    uint8_t *picture; /* RGB888 */
    struct output animation, folder;
};

/* A display that puts a renderer's bands into its panel. */
struct demo_panel {
    struct hal_display display;
    const struct demo *demo;
    unsigned left;
};

static int demo_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    const struct demo_panel *panel = (const struct demo_panel *)display;
    const struct demo *demo = panel->demo;
    for (unsigned row = 0; row < rows; row++)
        memcpy(demo->picture + 3 * ((size_t)(y + row) * demo->width + panel->left),
               (const uint8_t *)pixels + (size_t)row * stride, 3 * demo->panel_width);
    return 0;
}

static const struct hal_display_ops demo_ops = {.flush = demo_flush};

static uint32_t demo_moment(const struct demo *demo, uint32_t frame)
{
    return (uint32_t)((uint64_t)demo->duration_ms * frame / demo->frames);
}

static unsigned demo_left(const struct demo *demo, int panel)
{
    return (unsigned)panel * (demo->panel_width + DEMO_GAP);
}

static void demo_draw(struct demo *demo, uint32_t frame)
{
    for (int p = 0; p < DEMO_PANELS; p++) {
        struct demo_panel panel = {{&demo_ops}, demo, demo_left(demo, p)};
        double milliseconds = 0;
        renderer_draw(&demo->renderer[p], demo_moment(demo, frame), &panel.display, NULL, &milliseconds);
        demo->milliseconds[p] = frame ? fmin(demo->milliseconds[p], milliseconds) : milliseconds;
    }
}

/* How close the panels of `frame`, just drawn, come to the truth at that moment. */
static bool demo_measure(struct demo *demo, uint32_t frame)
{
    struct reference_options options = {
        .width = demo->panel_width, .height = demo->panel_height, .time_ms = demo_moment(demo, frame)};
    struct reference_image truth;
    size_t pixels = (size_t)demo->panel_width * demo->panel_height;
    if (!reference_render(demo->scene, &options, &truth))
        return false;
    double *panel = malloc(3 * pixels * sizeof *panel);
    bool done = panel != NULL;
    for (size_t i = 0; i < 3 * pixels; i++)
        truth.value[i] *= 255;
    for (int p = 0; p < DEMO_PANELS && done; p++) {
        struct compare_result result;
        for (size_t i = 0; i < 3 * pixels; i++) {
            size_t row = i / (3 * demo->panel_width), column = i % (3 * demo->panel_width);
            panel[i] = demo->picture[3 * (row * demo->width + demo_left(demo, p)) + column];
        }
        compare_values(panel, truth.value, truth.covered, pixels, 3, &result);
        demo->psnr_db[p] = result.psnr_db;
    }
    free(panel);
    reference_free(&truth);
    return done;
}

static int demo_frames(struct demo *demo)
{
    struct progress progress;
    int code = CLI_DONE;
    progress_begin(&progress, false);
    for (uint32_t i = 0; !code && i < demo->frames; i++) {
        uint32_t delay = demo_moment(demo, i + 1) - demo_moment(demo, i);
        demo_draw(demo, i);
        code = cli_interrupted() ? CLI_IO : output_picture(&demo->folder, i, delay, demo->picture, 3 * demo->width);
        if (!code)
            code = output_picture(&demo->animation, i, delay, demo->picture, 3 * demo->width);
        if (!code && i == demo->frames / 2 && !demo_measure(demo, i)) {
            fprintf(stderr, "%s: out of memory\n", demo_name);
            code = CLI_IO;
        }
        progress_step(&progress, i + 1, demo->frames);
    }
    progress_end(&progress);
    return code;
}

static void demo_report(const struct demo *demo)
{
    printf("%u frames of %ux%u in %sframe-0000.png ..., animated in %s\n\n", (unsigned)demo->frames, demo->width,
           demo->height, demo->folder.host.path, demo->animation.host.path);
    printf("method      ms/frame  cost/Gouraud  dB to double-precision Phong in frame %u\n",
           (unsigned)demo->frames / 2);
    for (int p = 0; p < DEMO_PANELS; p++)
        printf("%-10s  %8.3f  %12.2f  %6.1f\n", demo_labels[p], demo->milliseconds[p],
               demo->milliseconds[p] / demo->milliseconds[0], demo->psnr_db[p]);
    renderer_warn(&demo->renderer[0], demo->path);
}

/* Panels of this height, as wide as the camera's picture is in proportion; the labels below. */
static int demo_layout(struct demo *demo, unsigned height)
{
    const struct scene_camera *camera = &demo->scene->camera;
    unsigned width = (camera->reference_width * height + camera->reference_height / 2) / camera->reference_height;
    demo->panel_width = width < 1 ? 1 : width > GLINT_MAX_SIZE ? GLINT_MAX_SIZE : width;
    demo->panel_height = height;
    demo->width = DEMO_PANELS * demo->panel_width + (DEMO_PANELS - 1) * DEMO_GAP;
    demo->height = height + DEMO_STRIP;
    demo->duration_ms = demo->scene->duration_ms ? demo->scene->duration_ms : 2000;
    demo->picture = calloc(demo->height, 3 * (size_t)demo->width);
    if (!demo->picture) {
        fprintf(stderr, "%s: out of memory\n", demo_name);
        return CLI_IO;
    }
    int code = CLI_DONE;
    for (int p = 0; p < DEMO_PANELS && !code; p++) {
        struct renderer *renderer = &demo->renderer[p];
        *renderer = (struct renderer){.choice = renderer_find(demo_methods[p]),
                                      .config = {.width = (uint16_t)demo->panel_width,
                                                 .height = (uint16_t)height,
                                                 .band_rows = (uint16_t)height,
                                                 .format = GLINT_RGB888}};
        unsigned label = label_width(demo_labels[p]), left = demo_left(demo, p);
        if (label <= demo->panel_width)
            label_draw(demo_labels[p], demo->picture, demo->width, left + (demo->panel_width - label) / 2,
                       height + (DEMO_STRIP - LABEL_HEIGHT) / 2);
        code = renderer_open(renderer, demo->scene);
    }
    return code;
}

/* Opens both outputs; the folder first, since the other lies in it. */
static int demo_open(struct demo *demo, const char *folder, const char *animation)
{
    int code = output_choose(&demo->folder, demo_name, folder, NULL);
    if (!code)
        code = output_choose(&demo->animation, demo_name, animation, NULL);
    if (!code)
        code = output_open(&demo->folder, (uint16_t)demo->width, (uint16_t)demo->height, HAL_RGB888, demo->frames, 1);
    if (!code)
        code =
            output_open(&demo->animation, (uint16_t)demo->width, (uint16_t)demo->height, HAL_RGB888, demo->frames, 1);
    return code;
}

static int demo_run(struct demo *demo, const char *folder, unsigned height)
{
    size_t size = strlen(folder) + sizeof "/demo.png";
    char *with_slash = model_alloc(size), *animation = model_alloc(size);
    snprintf(with_slash, size, "%s%s", folder, folder[strlen(folder) - 1] == '/' ? "" : "/");
    snprintf(animation, size, "%sdemo.png", with_slash);
    const bool made = access(with_slash, F_OK) != 0;
    int code = demo_layout(demo, height);
    if (!code)
        code = demo_open(demo, with_slash, animation);
    if (!code)
        code = demo_frames(demo);
    /* kept, the folder comes first, so that both stay out if it cannot be; discarded, it comes last, empty by then */
    if (!code)
        code = output_close(&demo->folder, true);
    int closed = output_close(&demo->animation, !code);
    output_close(&demo->folder, false);
    code = code ? code : closed;
    if (code && made) /* if there is nothing in it: when the pictures could not move, the animation was */
        rmdir(with_slash);
    if (!code && !cli_interrupted())
        demo_report(demo);
    for (int p = 0; p < DEMO_PANELS; p++)
        renderer_close(&demo->renderer[p]);
    free(demo->picture);
    free(with_slash);
    free(animation);
    return code;
}

int cmd_demo(int argc, char **argv)
{
    static const struct option long_options[] = {{"frames", required_argument, NULL, 'f'},
                                                 {"height", required_argument, NULL, 'H'},
                                                 {"help", no_argument, NULL, 'h'},
                                                 {0}};
    struct demo demo = {.frames = 48};
    struct pack_result packed = {0};
    uint32_t height = 240;
    int option;
    argv[0] = (char *)demo_name;
    while ((option = getopt_long(argc, argv, "h", long_options, NULL)) != -1) {
        if (option == 'h') {
            fputs(demo_help, stdout);
            return CLI_DONE;
        }
        if (option == '?')
            return CLI_BAD_USAGE;
        if (!cli_number(optarg, option == 'f' ? 1 : 16, option == 'f' ? 10000 : 1024,
                        option == 'f' ? &demo.frames : &height))
            return cli_refuse(demo_name, demo_help, option == 'f' ? "frames" : "height", optarg);
    }
    if (argc - optind != 2 || !argv[optind + 1][0])
        return cli_usage(demo_name, "a scene and a folder are needed");
    demo.path = argv[optind];
    int code = pack_load(demo.path, NULL, &packed);
    if (code)
        return code;
    demo.scene = packed.scene;
    code = demo_run(&demo, argv[optind + 1], height);
    pack_free(&packed);
    return code;
}
