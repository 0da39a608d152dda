/* SPDX-License-Identifier: MIT */
#include "report/survey.h"

#include "glint/cli.h"
#include "pack/report.h"
#include "reference/reference.h"
#include "report/drawing.h"
#include "report/picture.h"
#include "report/sweep.h"
#include "scene/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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
        row->difference = model_alloc(pixels);
        int code = survey_price(survey, costs, row);
        if (!code)
            code = drawing_make(row->grey, scene, path, &(struct drawing){.method = row->method}, NULL);
        if (code)
            return code;
        drawing_compare(row->grey, truth, survey->covered, &row->error);
        for (size_t i = 0; i < pixels; i++)
            row->difference[i] =
                (uint8_t)(PICTURE_RIGHT +
                          (survey->covered[i] ? picture_level(row->grey[i] - 255 * truth->value[i]) : 0));
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

/* What the covered pixels take up, and a margin. */
static void survey_frame(struct survey *survey)
{
    unsigned left = survey->width, right = 0, top = survey->height, bottom = 0;
    for (unsigned y = 0; y < survey->height; y++)
        for (unsigned x = 0; x < survey->width; x++)
            if (survey->covered[(size_t)y * survey->width + x]) {
                left = left < x ? left : x;
                right = right > x ? right : x;
                top = top < y ? top : y;
                bottom = y;
            }
    struct survey_box *box = &survey->box;
    box->left = left > SURVEY_MARGIN ? left - SURVEY_MARGIN : 0;
    box->top = top > SURVEY_MARGIN ? top - SURVEY_MARGIN : 0;
    right += SURVEY_MARGIN + 1;
    bottom += SURVEY_MARGIN + 1;
    box->width = (right < survey->width ? right : survey->width) - box->left;
    box->height = (bottom < survey->height ? bottom : survey->height) - box->top;
}

/* Draws the truth and finds the pixels to be compared: those that both the truth and the scene cover. */
static int survey_truth(struct survey *survey, const char *path, const struct scene_header *scene,
                        const struct scene_header *ideal, struct reference_image *truth)
{
    const struct reference_options options = {.grey = true};
    size_t pixels = (size_t)survey->width * survey->height, seen = 0;
    struct reference_image own = {0};
    bool done = reference_render(ideal ? ideal : scene, &options, truth);
    if (!done || (ideal && !reference_render(scene, &options, &own))) {
        fprintf(stderr, "%s: out of memory\n", path);
        if (done)
            reference_free(truth);
        return CLI_IO;
    }
    survey->truth = model_alloc(pixels);
    survey->covered = model_alloc(pixels);
    for (size_t i = 0; i < pixels; i++) {
        survey->truth[i] = reference_byte(truth->value[i]);
        survey->covered[i] = truth->covered[i] && (!ideal || own.covered[i]);
        seen += survey->covered[i];
    }
    if (ideal)
        reference_free(&own);
    if (seen > 0) {
        survey_frame(survey);
        return CLI_DONE;
    }
    fprintf(stderr, "%s: nothing is to be seen\n", path);
    reference_free(truth);
    return CLI_BAD_DATA;
}

/* Loads NAME-ideal.json if it lies beside NAME.json. */
static int survey_ideal(struct survey *survey, const char *path, struct pack_result *ideal)
{
    static const char ending[] = "-ideal.json";
    const char *dot = strrchr(path, '.');
    size_t length = dot && strchr(dot, '/') == NULL ? (size_t)(dot - path) : strlen(path);
    char *beside = model_alloc(length + sizeof ending);
    memcpy(beside, path, length);
    memcpy(beside + length, ending, sizeof ending);
    int code = CLI_DONE;
    if (access(beside, F_OK) == 0) {
        code = pack_load(beside, NULL, ideal);
        const struct scene_camera *camera = code ? NULL : &ideal->scene->camera;
        if (!code && (camera->reference_width != survey->width || camera->reference_height != survey->height)) {
            fprintf(stderr, "%s: %ux%u, but %s is %ux%u\n", beside, camera->reference_width, camera->reference_height,
                    survey->scene, survey->width, survey->height);
            code = CLI_BAD_DATA;
        } else if (!code) {
            survey->ideal_triangles = report_count(ideal->scene).triangles;
        }
    }
    free(beside);
    return code;
}

int survey_open(struct survey *survey, const char *path, const char *const methods[], unsigned count,
                const struct costs *costs)
{
    struct pack_result packed, ideal = {0};
    struct reference_image truth;
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
    code = survey_ideal(survey, path, &ideal);
    if (!code)
        code = survey_truth(survey, path, packed.scene, ideal.scene, &truth);
    if (!code) {
        code = survey_rows(survey, path, packed.scene, &truth, costs);
        if (!code)
            code = sweep_measure(survey, path, packed.scene, &truth, costs);
        reference_free(&truth);
    }
    pack_free(&ideal);
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
    for (unsigned i = 0; i < survey->budget_count; i++)
        free(survey->budgets[i].plan);
    free(survey->budgets);
    free(survey->truth);
    free(survey->covered);
    *survey = (struct survey){0};
}
