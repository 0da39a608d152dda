/* SPDX-License-Identifier: MIT */
#include "report/drawing.h"

#include "glint/cli.h"
#include "glint/renderer.h"
#include "scene/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DRAWING_TABLES 4 /* as tests/device/bench.c counts instructions */

/* A display that keeps the picture. */
struct drawing_keeper {
    struct hal_display display;
    uint8_t *pixels;
    size_t row; /* bytes */
};

static int drawing_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    const struct drawing_keeper *keeper = (const struct drawing_keeper *)display;
    for (unsigned row = 0; row < rows; row++)
        memcpy(keeper->pixels + (y + row) * keeper->row, (const uint8_t *)pixels + (size_t)row * stride, keeper->row);
    return 0;
}

static const struct hal_display_ops drawing_ops = {.flush = drawing_flush};

int drawing_make(uint8_t *pixels, const struct scene_header *scene, const char *path, const struct drawing *how,
                 struct glint_stats *stats)
{
    const struct scene_camera *camera = &scene->camera;
    struct drawing_keeper keeper = {{&drawing_ops}, pixels, (size_t)camera->reference_width * (how->colour ? 3 : 1)};
    const struct glint_choice other = {"plan", how->show};
    struct renderer renderer = {.choice = how->method ? renderer_find(how->method) : &other,
                                .config = {.width = camera->reference_width,
                                           .height = camera->reference_height,
                                           .band_rows = camera->reference_height,
                                           .format = how->colour ? GLINT_RGB888 : GLINT_GREY8,
                                           .power = how->power,
                                           .tables = DRAWING_TABLES,
                                           .budget = how->budget_q8}};
    double milliseconds = 0;
    int code = renderer_open(&renderer, scene);
    if (code)
        return code;
    renderer_draw(&renderer, 0, &keeper.display, NULL, &milliseconds);
    if (stats)
        *stats = renderer.frame.stats;
    if (renderer.dropped) {
        fprintf(stderr, "%s: a frame by %s lacks %u triangles\n", path, renderer.choice->name,
                (unsigned)renderer.dropped);
        code = CLI_BAD_DATA;
    }
    renderer_close(&renderer);
    return code;
}

void drawing_compare(const uint8_t *pixels, const struct reference_image *truth, const uint8_t *covered,
                     struct compare_result *error)
{
    size_t count = (size_t)truth->width * truth->height, values = count * truth->channels;
    double *a = model_alloc(2 * values * sizeof *a), *b = a + values;
    for (size_t i = 0; i < values; i++) {
        a[i] = pixels[i];
        b[i] = 255 * truth->value[i];
    }
    compare_values(a, b, covered, count, truth->channels, error);
    free(a);
}
