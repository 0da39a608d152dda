/* SPDX-License-Identifier: MIT */
/*
 * Whether the budget holds: scenes, each from many sides and at many moments of its animation, by glint_auto with
 * budgets from .5 to 32, and by the method that it falls back on, against the truth (measure.h).
 *   holds [--views N] [--OUTPUT] SCENE.json...    outputs: grey8, rgb888, rgb565, and each with -tables; all unless
 * given One line a scene and format, `ok` or `FAIL`: the largest differences by budget.
 */
#include "measure.h"
#include "pack/pack.h"

#define VIEWS 60

static const double budgets[] = {.5, .5, 1, 2, 4, 8, 16, 32}; /* the first: phong-perspective, the fallback, itself */
#define BUDGETS (sizeof budgets / sizeof *budgets)

static const struct {
    const char *name;
    uint8_t format, tables;
} outputs[] = {{"grey8", GLINT_GREY8, 0},           {"rgb888", GLINT_RGB888, 0},
               {"rgb565", GLINT_RGB565, 0},         {"grey8-tables", GLINT_GREY8, 16},
               {"rgb888-tables", GLINT_RGB888, 16}, {"rgb565-tables", GLINT_RGB565, 16}};
#define OUTPUTS (sizeof outputs / sizeof *outputs)

/* What is promised beyond the budget is 1.5: half a step of the output, of 8 bits, and 1. */
#define ROUNDINGS 1.0

struct scene_result {
    struct measure_worst worst[BUDGETS];
    struct budget_view view[BUDGETS];
};

/* From all sides; the first as the scene stands. */
static struct budget_view view_of(unsigned i)
{
    return i == 0 ? (struct budget_view){0, 0, 0}
                  : (struct budget_view){(uint16_t)(i * 40503u), (uint16_t)(i * 10007u), i * 137};
}

static void measure_budgets(struct measure *m, struct budget_picture *p, struct budget_picture *fallback,
                            struct scene_result *result)
{
    for (size_t b = 0; b < BUDGETS; b++) {
        struct budget_picture *by = b == 0 ? fallback : p;
        glint_set_budget(&by->frame, (uint16_t)(budgets[b] * 256));
        budget_draw(by, m->scene, m->view);
        const struct measure_worst worst = measure_picture(m, by->pixels);
        if (worst.error > result->worst[b].error) {
            result->worst[b] = worst;
            result->view[b] = m->view;
        }
    }
}

static int report(const char *path, const char *output, const struct measure *m, const struct scene_result *result,
                  unsigned views)
{
    const double more = ROUNDINGS;
    int bad = m->missed != 0;
    for (size_t b = 0; b < BUDGETS; b++)
        bad |= result->worst[b].error > budgets[b] + more;
    printf("%s %s %s: %u views, beyond half a step: phong %.2f", bad ? "FAIL" : "ok", path, output, views,
           result->worst[0].error);
    for (size_t b = 1; b < BUDGETS; b++)
        printf(", %g: %.2f", budgets[b], result->worst[b].error);
    puts("");
    if (m->missed)
        printf("  %lu pixels drawn by a triangle that the truth does not see there\n", m->missed);
    for (size_t b = 0; b < BUDGETS; b++) {
        const struct measure_worst *w = &result->worst[b];
        const struct budget_view *v = &result->view[b];
        if (w->error <= budgets[b] + more)
            continue;
        printf("  budget %g: %.2f of a truth of %.2f at (%u, %u), channel %u, triangle %u, turned by %u %u at %u ms\n",
               budgets[b], w->error, w->truth, w->x, w->y, w->channel, w->triangle, v->yaw, v->pitch, v->time_ms);
        break;
    }
    fflush(stdout);
    return bad;
}

static int has_bumps(const struct scene_header *scene)
{
    int has = 0;
    for (unsigned m = 0; m < scene->material_count; m++)
        has |= scene_materials(scene)[m].bump != SCENE_NO_TEXTURE;
    return has;
}

static int holds(const char *path, const struct scene_header *scene, size_t output, unsigned views)
{
    const struct scene_camera *camera = &scene->camera;
    struct scene_result result = {0};
    struct measure m;
    measure_open(&m, scene, camera->reference_width, camera->reference_height, outputs[output].format);
    struct budget_picture picture = {.config = {.width = camera->reference_width,
                                                .height = camera->reference_height,
                                                .format = outputs[output].format,
                                                .tables = outputs[output].tables,
                                                .method = &glint_auto}},
                          fallback = picture;
    if (!has_bumps(scene))
        fallback.config.method = &glint_phong_perspective;
    budget_open(&picture, scene);
    budget_open(&fallback, scene);
    for (unsigned v = 0; v < views; v++) {
        measure_view(&m, view_of(v));
        measure_budgets(&m, &picture, &fallback, &result);
    }
    const int bad = report(path, outputs[output].name, &m, &result, views);
    budget_close(&picture);
    budget_close(&fallback);
    measure_close(&m);
    return bad;
}

int main(int argc, char **argv)
{
    unsigned views = VIEWS, wanted = 0;
    int bad = 0, i = 1;
    for (; i < argc && argv[i][0] == '-'; i++) {
        size_t output = 0;
        if (strcmp(argv[i], "--views") == 0 && i + 1 < argc) {
            views = (unsigned)strtoul(argv[++i], NULL, 10);
            continue;
        }
        while (output < OUTPUTS && strcmp(argv[i] + 2, outputs[output].name) != 0)
            output++;
        wanted |= 1u << output;
        if (output == OUTPUTS) {
            fprintf(stderr, "holds [--views N] [--OUTPUT] SCENE.json...\n");
            return 2;
        }
    }
    for (; i < argc; i++) {
        struct pack_result packed;
        int code = pack_load(argv[i], NULL, &packed);
        if (code)
            return code;
        for (size_t output = 0; output < OUTPUTS; output++)
            if (!wanted || wanted >> output & 1)
                bad |= holds(argv[i], packed.scene, output, views);
        pack_free(&packed);
    }
    return bad;
}
