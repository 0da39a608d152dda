/* SPDX-License-Identifier: MIT */
#include "report/costs.h"

#include "glint/cli.h"
#include "glint/renderer.h"
#include "report/csv.h"
#include "scene/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const costs_cpu_names[COSTS_CPUS] = {[COSTS_M3] = "m3", [COSTS_M0PLUS] = "m0plus"};
const char *const costs_cpu_titles[COSTS_CPUS] = {[COSTS_M3] = "M3", [COSTS_M0PLUS] = "M0+"};
const char *const costs_stream_cpus[COSTS_STREAM_CPUS] = {"m0plus", "m3", "m4"};
const char *const costs_stream_cpu_titles[COSTS_STREAM_CPUS] = {"M0+", "M3", "M4"};

static const char costs_frames_head[] = "cpu,scene,method,width,height,format,instructions,picture";
static const char costs_flash_head[] = "cpu,method,bytes";
static const char costs_powers_head[] = "cpu,scene,power,exponent,instructions";
static const char costs_budgets_head[] = "cpu,scene,budget_q8,instructions";
static const char costs_streams_head[] = "cpu,scene,format,codec,pixels,bytes,instructions";

static const char *costs_method(char *out, size_t size, const char *text)
{
    return renderer_find(text) ? csv_name(out, size, text, " -_") : "no such method; `glint methods` lists them";
}

static const char *costs_cpu(enum costs_cpu *cpu, const char *text)
{
    int choice = cli_choice(text, costs_cpu_names, COSTS_CPUS);
    *cpu = choice < 0 ? COSTS_M3 : (enum costs_cpu)choice;
    return choice < 0 ? "the cpu is neither m3 nor m0plus" : NULL;
}

static const char *costs_take_frame(void *context, char *field[CSV_FIELDS], unsigned line)
{
    struct costs *costs = context;
    struct costs_frame frame = {.line = line};
    uint32_t width, height;
    const char *problem = costs_cpu(&frame.cpu, field[0]);
    if (!problem)
        problem = csv_name(frame.scene, sizeof frame.scene, field[1], " -_");
    if (!problem)
        problem = costs_method(frame.method, sizeof frame.method, field[2]);
    if (problem)
        return problem;
    if (!cli_number(field[3], 1, GLINT_MAX_SIZE, &width) || !cli_number(field[4], 1, GLINT_MAX_SIZE, &height))
        return "width and height are 1..2048";
    if (strcmp(field[5], "grey8") != 0)
        return "the format is not grey8";
    if (!cli_number(field[6], 1, UINT32_MAX, &frame.instructions))
        return "the instructions are no number above 0";
    problem = csv_name(frame.picture, sizeof frame.picture, field[7], "");
    if (problem)
        return problem;
    if (costs_find_frame(costs, frame.cpu, frame.scene, frame.method))
        return "a second line for this cpu, scene and method";
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++) {
        const struct costs_frame *other = costs_find_frame(costs, cpu, frame.scene, frame.method);
        if (other && strcmp(other->picture, frame.picture) != 0)
            return "another picture than on another cpu";
    }
    frame.width = width;
    frame.height = height;
    costs->frames = model_grow(costs->frames, costs->frame_count, &costs->frame_room, sizeof frame);
    costs->frames[costs->frame_count++] = frame;
    return NULL;
}

static const char *costs_take_flash(void *context, char *field[CSV_FIELDS], unsigned line)
{
    struct costs *costs = context;
    struct costs_flash flash;
    const char *problem = costs_cpu(&flash.cpu, field[0]);
    (void)line;
    if (!problem)
        problem = costs_method(flash.method, sizeof flash.method, field[1]);
    if (problem)
        return problem;
    if (!cli_number(field[2], 1, UINT32_MAX, &flash.bytes))
        return "the bytes are no number above 0";
    if (costs_find_flash(costs, flash.cpu, flash.method))
        return "a second line for this cpu and method";
    costs->flash = model_grow(costs->flash, costs->flash_count, &costs->flash_room, sizeof flash);
    costs->flash[costs->flash_count++] = flash;
    return NULL;
}

static const char *costs_take_budget(void *context, char *field[CSV_FIELDS], unsigned line)
{
    struct costs *costs = context;
    struct costs_budget budget;
    uint32_t q8;
    const char *problem = costs_cpu(&budget.cpu, field[0]);
    (void)line;
    if (!problem)
        problem = csv_name(budget.scene, sizeof budget.scene, field[1], " -_");
    if (problem)
        return problem;
    if (!cli_number(field[2], 1, UINT16_MAX, &q8))
        return "the budget is 1..65535, Q8 of 1/255";
    if (!cli_number(field[3], 1, UINT32_MAX, &budget.instructions))
        return "the instructions are no number above 0";
    budget.budget_q8 = q8;
    if (costs_find_budget(costs, budget.cpu, budget.scene, q8))
        return "a second line for this cpu, scene and budget";
    costs->budgets = model_grow(costs->budgets, costs->budget_count, &costs->budget_room, sizeof budget);
    costs->budgets[costs->budget_count++] = budget;
    return NULL;
}

static const char *costs_take_power(void *context, char *field[CSV_FIELDS], unsigned line)
{
    struct costs *costs = context;
    struct costs_power power;
    const char *problem = costs_cpu(&power.cpu, field[0]);
    int form = cli_choice(field[2], renderer_power_names, RENDERER_POWERS);
    uint32_t exponent;
    (void)line;
    if (!problem)
        problem = csv_name(power.scene, sizeof power.scene, field[1], " -_");
    if (problem)
        return problem;
    if (form < 0)
        return "no such form of the power; `glint render --help` lists them";
    if (!cli_number(field[3], 1, FX_POWER_MAX_EXPONENT, &exponent))
        return "the exponent is 1..1023";
    if (!cli_number(field[4], 1, UINT32_MAX, &power.instructions))
        return "the instructions are no number above 0";
    power.form = (unsigned)form;
    power.exponent = exponent;
    if (costs_find_power(costs, power.cpu, power.scene, power.form, exponent))
        return "a second line for this cpu, scene, power and exponent";
    costs->powers = model_grow(costs->powers, costs->power_count, &costs->power_room, sizeof power);
    costs->powers[costs->power_count++] = power;
    return NULL;
}

static const char *costs_take_stream(void *context, char *field[CSV_FIELDS], unsigned line)
{
    struct costs *costs = context;
    struct costs_stream stream;
    int cpu = cli_choice(field[0], costs_stream_cpus, COSTS_STREAM_CPUS);
    uint32_t codec;
    (void)line;
    if (cpu < 0)
        return "the cpu is none of m0plus, m3 and m4";
    const char *problem = csv_name(stream.scene, sizeof stream.scene, field[1], " -_");
    if (!problem)
        problem = csv_name(stream.format, sizeof stream.format, field[2], " -_");
    if (problem)
        return problem;
    if (!cli_number(field[3], 1, 2, &codec))
        return "the codec is 1 or 2";
    if (!cli_number(field[4], 1, UINT32_MAX, &stream.pixels) || !cli_number(field[5], 1, UINT32_MAX, &stream.bytes) ||
        !cli_number(field[6], 1, UINT32_MAX, &stream.instructions))
        return "pixels, bytes and instructions are numbers above 0";
    stream.cpu = (unsigned)cpu;
    stream.codec = codec;
    if (costs_find_stream(costs, stream.cpu, stream.scene, stream.format, codec))
        return "a second line for this cpu, scene, format and codec";
    costs->streams = model_grow(costs->streams, costs->stream_count, &costs->stream_room, sizeof stream);
    costs->streams[costs->stream_count++] = stream;
    return NULL;
}

int costs_read(struct costs *costs)
{
    const struct {
        const char *path, *head;
        csv_take *take;
    } files[] = {{costs->frames_path, costs_frames_head, costs_take_frame},
                 {costs->flash_path, costs_flash_head, costs_take_flash},
                 {costs->budgets_path, costs_budgets_head, costs_take_budget},
                 {costs->powers_path, costs_powers_head, costs_take_power},
                 {costs->streams_path, costs_streams_head, costs_take_stream}};
    int code = CLI_DONE;
    for (size_t i = 0; !code && i < sizeof files / sizeof *files; i++)
        if (files[i].path)
            code = csv_read(files[i].path, files[i].head, files[i].take, NULL, costs);
    return code;
}

void costs_free(struct costs *costs)
{
    free(costs->frames);
    free(costs->flash);
    free(costs->powers);
    free(costs->streams);
    free(costs->budgets);
    *costs = (struct costs){0};
}

const struct costs_frame *costs_find_frame(const struct costs *costs, enum costs_cpu cpu, const char *scene,
                                           const char *method)
{
    for (size_t i = 0; i < costs->frame_count; i++) {
        const struct costs_frame *frame = &costs->frames[i];
        if (frame->cpu == cpu && strcmp(frame->scene, scene) == 0 && strcmp(frame->method, method) == 0)
            return frame;
    }
    return NULL;
}

const struct costs_flash *costs_find_flash(const struct costs *costs, enum costs_cpu cpu, const char *method)
{
    for (size_t i = 0; i < costs->flash_count; i++)
        if (costs->flash[i].cpu == cpu && strcmp(costs->flash[i].method, method) == 0)
            return &costs->flash[i];
    return NULL;
}

const struct costs_budget *costs_find_budget(const struct costs *costs, enum costs_cpu cpu, const char *scene,
                                             unsigned budget_q8)
{
    for (size_t i = 0; i < costs->budget_count; i++) {
        const struct costs_budget *budget = &costs->budgets[i];
        if (budget->cpu == cpu && budget->budget_q8 == budget_q8 && strcmp(budget->scene, scene) == 0)
            return budget;
    }
    return NULL;
}

const struct costs_power *costs_find_power(const struct costs *costs, enum costs_cpu cpu, const char *scene,
                                           unsigned form, unsigned exponent)
{
    for (size_t i = 0; i < costs->power_count; i++) {
        const struct costs_power *power = &costs->powers[i];
        if (power->cpu == cpu && power->form == form && power->exponent == exponent && strcmp(power->scene, scene) == 0)
            return power;
    }
    return NULL;
}

const struct costs_stream *costs_find_stream(const struct costs *costs, unsigned cpu, const char *scene,
                                             const char *format, unsigned codec)
{
    for (size_t i = 0; i < costs->stream_count; i++) {
        const struct costs_stream *stream = &costs->streams[i];
        if (stream->cpu == cpu && stream->codec == codec && strcmp(stream->scene, scene) == 0 &&
            strcmp(stream->format, format) == 0)
            return stream;
    }
    return NULL;
}
