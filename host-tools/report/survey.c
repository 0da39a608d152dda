/* SPDX-License-Identifier: MIT */
#include "report/survey.h"

#include "glint/cli.h"
#include "glint/renderer.h"
#include "pack/report.h"
#include "reference/reference.h"
#include "scene/model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A display that keeps the picture. */
struct survey_keeper {
    struct hal_display display;
    uint8_t *grey;
    unsigned width;
};

static int survey_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    const struct survey_keeper *keeper = (const struct survey_keeper *)display;
    for (unsigned row = 0; row < rows; row++)
        memcpy(keeper->grey + (size_t)(y + row) * keeper->width, (const uint8_t *)pixels + (size_t)row * stride,
               keeper->width);
    return 0;
}

static const struct hal_display_ops survey_ops = {.flush = survey_flush};

static int survey_draw(const struct survey *survey, const struct scene_header *scene, const char *path,
                       struct survey_row *row)
{
    struct survey_keeper keeper = {{&survey_ops}, row->grey, survey->width};
    struct renderer renderer = {.choice = renderer_find(row->method),
                                .config = {.width = (uint16_t)survey->width,
                                           .height = (uint16_t)survey->height,
                                           .band_rows = (uint16_t)survey->height,
                                           .format = GLINT_GREY8}};
    double milliseconds = 0;
    int code = renderer_open(&renderer, scene);
    if (code)
        return code;
    renderer_draw(&renderer, 0, &keeper.display, NULL, &milliseconds);
    if (renderer.dropped) {
        fprintf(stderr, "%s: a frame by %s lacks %u triangles\n", path, row->method, (unsigned)renderer.dropped);
        code = CLI_BAD_DATA;
    }
    renderer_close(&renderer);
    return code;
}

static void survey_shade(uint8_t rgb[3], double difference)
{
    static const double bright[3] = {1, .6, .2}, dark[3] = {.35, .7, 1};
    double value = fmin(255, SURVEY_GAIN * fabs(difference));
    for (int c = 0; c < 3; c++)
        rgb[c] = (uint8_t)lround(value * (difference > 0 ? bright[c] : dark[c]));
}

static void survey_measure(const struct survey *survey, const struct reference_image *truth, struct survey_row *row)
{
    size_t pixels = (size_t)survey->width * survey->height;
    double *a = model_alloc(2 * pixels * sizeof *a), *b = a + pixels;
    for (size_t i = 0; i < pixels; i++) {
        a[i] = row->grey[i];
        b[i] = 255 * truth->value[i];
        survey_shade(row->difference + 3 * i, a[i] - b[i]);
    }
    compare_values(a, b, truth->covered, pixels, 1, &row->error);
    free(a);
}

static int survey_price(const struct survey *survey, const struct costs *costs, struct survey_row *row)
{
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++) {
        const struct costs_frame *frame = costs_find_frame(costs, cpu, survey->scene, row->method);
        const struct costs_flash *flash = costs_find_flash(costs, cpu, row->method);
        if (!frame) {
            fprintf(stderr, "%s: no line for %s by %s on %s\n", costs->frames_path, survey->scene, row->method,
                    costs_cpu_names[cpu]);
            return CLI_BAD_DATA;
        }
        if (frame->width != survey->width || frame->height != survey->height) {
            fprintf(stderr, "%s:%u: %ux%u, but %s is %ux%u\n", costs->frames_path, frame->line, frame->width,
                    frame->height, survey->scene, survey->width, survey->height);
            return CLI_BAD_DATA;
        }
        if (!flash) {
            fprintf(stderr, "%s: no line for %s on %s\n", costs->flash_path, row->method, costs_cpu_names[cpu]);
            return CLI_BAD_DATA;
        }
        row->instructions[cpu] = frame->instructions;
        row->flash[cpu] = flash->bytes;
    }
    return CLI_DONE;
}

static int survey_order(const void *a, const void *b)
{
    const struct survey_row *x = a, *y = b;
    if (x->instructions[0] != y->instructions[0])
        return x->instructions[0] < y->instructions[0] ? -1 : 1;
    return x->error.rms < y->error.rms ? -1 : x->error.rms > y->error.rms ? 1 : strcmp(x->method, y->method);
}

static bool survey_beats(const struct survey_row *a, const struct survey_row *b, enum costs_cpu cpu)
{
    return a->instructions[cpu] <= b->instructions[cpu] && a->error.rms <= b->error.rms &&
           (a->instructions[cpu] < b->instructions[cpu] || a->error.rms < b->error.rms);
}

/* More exact, or as exact and cheaper: the first of these is in the Pareto set. */
static bool survey_nearer(const struct survey_row *a, const struct survey_row *b, enum costs_cpu cpu)
{
    return a->error.rms != b->error.rms ? a->error.rms < b->error.rms : a->instructions[cpu] < b->instructions[cpu];
}

void survey_rank(struct survey_row *rows, unsigned count)
{
    qsort(rows, count, sizeof *rows, survey_order);
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        for (unsigned i = 0; i < count; i++) {
            const struct survey_row *best = NULL;
            for (unsigned j = 0; j < count; j++)
                if (survey_beats(&rows[j], &rows[i], cpu) && (!best || survey_nearer(&rows[j], best, cpu)))
                    best = &rows[j];
            rows[i].beaten_by[cpu] = best ? best->method : NULL;
        }
}

static int survey_rows(struct survey *survey, const char *path, const struct scene_header *scene,
                       const struct reference_image *truth, const struct costs *costs)
{
    size_t pixels = (size_t)survey->width * survey->height;
    for (unsigned m = 0; m < survey->count; m++) {
        struct survey_row *row = &survey->rows[m];
        row->grey = model_alloc(pixels);
        row->difference = model_alloc(3 * pixels);
        int code = survey_price(survey, costs, row);
        if (!code)
            code = survey_draw(survey, scene, path, row);
        if (code)
            return code;
        survey_measure(survey, truth, row);
    }
    survey_rank(survey->rows, survey->count);
    return CLI_DONE;
}

bool survey_name(const char *path, char name[SURVEY_NAME])
{
    const char *slash = strrchr(path, '/'), *last = slash ? slash + 1 : path, *dot = strrchr(last, '.');
    size_t length = dot && dot > last ? (size_t)(dot - last) : strlen(last);
    if (length == 0 || length >= SURVEY_NAME)
        return false;
    memcpy(name, last, length);
    name[length] = 0;
    return strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") == length;
}

int survey_open(struct survey *survey, const char *path, const char *const methods[], unsigned count,
                const struct costs *costs)
{
    struct pack_result packed;
    *survey = (struct survey){.count = count};
    if (!survey_name(path, survey->scene)) {
        fprintf(stderr, "%s: a scene's name in a report is of letters, digits, - and _\n", path);
        return CLI_BAD_DATA;
    }
    int code = pack_load(path, NULL, &packed);
    if (code)
        return code;
    const struct scene_camera *camera = &packed.scene->camera;
    survey->width = camera->reference_width;
    survey->height = camera->reference_height;
    survey->perspective = camera->kind == CAMERA_PERSPECTIVE;
    survey->triangles = report_count(packed.scene).triangles;
    survey->rows = model_alloc(count * sizeof *survey->rows);
    for (unsigned m = 0; m < count; m++)
        survey->rows[m] = (struct survey_row){.method = methods[m]};
    const struct reference_options options = {.grey = true};
    struct reference_image truth;
    if (reference_render(packed.scene, &options, &truth)) {
        size_t pixels = (size_t)survey->width * survey->height;
        survey->truth = model_alloc(pixels);
        for (size_t i = 0; i < pixels; i++)
            survey->truth[i] = reference_byte(truth.value[i]);
        code = survey_rows(survey, path, packed.scene, &truth, costs);
        if (!code && !truth.coverage) {
            fprintf(stderr, "%s: nothing is to be seen\n", path);
            code = CLI_BAD_DATA;
        }
        reference_free(&truth);
    } else {
        fprintf(stderr, "%s: out of memory\n", path);
        code = CLI_IO;
    }
    pack_free(&packed);
    return code;
}

void survey_free(struct survey *survey)
{
    for (unsigned m = 0; survey->rows && m < survey->count; m++) {
        free(survey->rows[m].grey);
        free(survey->rows[m].difference);
    }
    free(survey->rows);
    free(survey->truth);
    *survey = (struct survey){0};
}
