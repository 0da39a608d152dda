/* SPDX-License-Identifier: MIT */
#include "report/sweep.h"

#include "glint/cli.h"
#include "report/drawing.h"
#include "report/picture.h"
#include "report/plot.h"
#include "scene/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SWEEP_SEEN 2. /* 1/255: a budget that is not seen, auto's default */
#define SWEEP_FAST 8. /* and one for speed */

static int sweep_order(const void *a, const void *b)
{
    const struct survey_budget *x = a, *y = b;
    return x->budget_q8 < y->budget_q8 ? -1 : x->budget_q8 > y->budget_q8;
}

static int sweep_price(struct survey_budget *budget, const struct survey *survey, const struct costs *costs)
{
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++) {
        const struct costs_budget *cost = costs_find_budget(costs, cpu, survey->scene, budget->budget_q8);
        if (!cost) {
            fprintf(stderr, "%s: no line for %s within %u on %s\n", costs->budgets_path, survey->scene,
                    budget->budget_q8, costs_cpu_names[cpu]);
            return CLI_BAD_DATA;
        }
        budget->instructions[cpu] = cost->instructions;
    }
    return CLI_DONE;
}

int sweep_measure(struct survey *survey, const char *path, const struct scene_header *scene,
                  const struct reference_image *truth, const struct costs *costs)
{
    const size_t pixels = (size_t)survey->width * survey->height;
    uint8_t *grey = model_alloc(pixels);
    int code = CLI_DONE;
    survey->budgets = model_alloc((costs->budget_count + 1) * sizeof *survey->budgets);
    for (size_t i = 0; !code && i < costs->budget_count; i++) {
        const struct costs_budget *own = &costs->budgets[i];
        if (own->cpu != COSTS_M3 || strcmp(own->scene, survey->scene) != 0)
            continue;
        struct survey_budget *budget = &survey->budgets[survey->budget_count++];
        *budget = (struct survey_budget){.budget_q8 = own->budget_q8, .plan = model_alloc(3 * pixels)};
        struct drawing how = {.method = "auto", .budget_q8 = (uint16_t)own->budget_q8};
        code = sweep_price(budget, survey, costs);
        if (!code)
            code = drawing_make(grey, scene, path, &how, &budget->stats);
        if (code)
            break;
        drawing_compare(grey, truth, survey->covered, &budget->error);
        how = (struct drawing){.show = &glint_auto_shown, .colour = true, .budget_q8 = how.budget_q8};
        code = drawing_make(budget->plan, scene, path, &how, NULL);
    }
    qsort(survey->budgets, survey->budget_count, sizeof *survey->budgets, sweep_order);
    free(grey);
    return code;
}

/* --- what to choose --------------------------------------------------------------------------------------------- */

static const struct survey_row *sweep_method(const struct survey *survey, const char *method)
{
    for (unsigned i = 0; i < survey->count; i++)
        if (strcmp(survey->rows[i].method, method) == 0)
            return &survey->rows[i];
    return NULL;
}

/* By how many percent it costs less than a method, negative: more. */
static double sweep_saved(const struct survey_budget *budget, const struct survey_row *than)
{
    return 100 - 100. * budget->instructions[COSTS_M3] / than->instructions[COSTS_M3];
}

/* How a budget compares with the methods that its user would take otherwise. */
static void sweep_budget(FILE *out, const struct survey *survey, double wanted, const char *why)
{
    const struct survey_row *duff = sweep_method(survey, "duff"), *gouraud = sweep_method(survey, "gouraud");
    for (unsigned i = 0; i < survey->budget_count; i++) {
        const struct survey_budget *budget = &survey->budgets[i];
        if (budget->budget_q8 != 256 * wanted)
            continue;
        fprintf(out, " %s budget %g: off by at most %.1f, %.1f dB, for %.2f million on M3", why, wanted,
                budget->error.max, plot_decibel(&budget->error), budget->instructions[COSTS_M3] / 1e6);
        if (duff)
            fprintf(out, ", %.0f %% %s than duff", fabs(sweep_saved(budget, duff)),
                    sweep_saved(budget, duff) < 0 ? "more" : "less");
        if (gouraud)
            fprintf(out, " and %.2f times gouraud, which is off by %.0f",
                    (double)budget->instructions[COSTS_M3] / gouraud->instructions[COSTS_M3], gouraud->error.max);
        fprintf(out, ".");
    }
}

/* Whether something of the other sort costs no more on the M3 and errs no more. */
static bool sweep_beaten(const struct survey *survey, uint32_t instructions, double max, bool by_budget)
{
    bool beaten = false;
    for (unsigned i = 0; i < (by_budget ? survey->budget_count : survey->count); i++) {
        uint32_t cost = by_budget ? survey->budgets[i].instructions[COSTS_M3] : survey->rows[i].instructions[COSTS_M3];
        double error = by_budget ? survey->budgets[i].error.max : survey->rows[i].error.max;
        bool same_sort = !by_budget && strcmp(survey->rows[i].method, "auto") == 0;
        beaten = beaten || (!same_sort && cost <= instructions && error <= max);
    }
    return beaten;
}

/* Methods that no budget beats, and that are in their own Pareto set. */
static void sweep_methods(FILE *out, const struct survey *survey)
{
    unsigned count = 0;
    for (unsigned i = 0; i < survey->count; i++) {
        const struct survey_row *row = &survey->rows[i];
        if (row->beaten_by[COSTS_M3] || strcmp(row->method, "auto") == 0 ||
            sweep_beaten(survey, row->instructions[COSTS_M3], row->error.max, true))
            continue;
        fprintf(out, "%s%s (off by %.1f for %.2f)",
                count++ ? ", "
                        : " Worth a thought though they promise nothing, as no budget is both as cheap and as close: ",
                row->method, row->error.max, row->instructions[COSTS_M3] / 1e6);
    }
    fprintf(out, count ? "." : " No method is worth naming: within some budget auto is as cheap and no farther off.");
    count = 0;
    for (unsigned i = 0; i < survey->budget_count; i++) {
        const struct survey_budget *budget = &survey->budgets[i];
        if (sweep_beaten(survey, budget->instructions[COSTS_M3], budget->error.max, false))
            fprintf(out, "%s%g", count++ ? ", " : " A method does at least as well as the budgets ",
                    budget->budget_q8 / 256.);
    }
    fprintf(out, count ? "." : " No method does as well as any of the budgets.");
}

/* --- the table -------------------------------------------------------------------------------------------------- */

/* What auto draws by. */
static const enum glint_method_id sweep_rungs[] = {GLINT_DARK, GLINT_CONSTANT, GLINT_GOURAUD, GLINT_LINEAR,
                                                   GLINT_SIX,  GLINT_DUFF,     GLINT_PHONG};
#define SWEEP_RUNGS (sizeof sweep_rungs / sizeof *sweep_rungs)

static const struct {
    const char *name, *title;
    size_t offset;
} sweep_counts[] = {
    {"hidden_lights", "lights hidden", offsetof(struct glint_stats, hidden_lights)},
    {"hidden_highlights", "highlights hidden", offsetof(struct glint_stats, hidden_highlights)},
    {"dropped_highlights", "highlights dropped", offsetof(struct glint_stats, dropped_highlights)},
    {"straightened", "straightened", offsetof(struct glint_stats, straightened)},
    {"undivided", "undivided", offsetof(struct glint_stats, undivided)},
};
#define SWEEP_COUNTS (sizeof sweep_counts / sizeof *sweep_counts)

static uint32_t sweep_count(const struct glint_stats *stats, unsigned i)
{
    uint32_t count;
    memcpy(&count, (const char *)stats + sweep_counts[i].offset, sizeof count);
    return count;
}

static void sweep_row(FILE *out, const struct survey_budget *budget)
{
    const struct glint_stats *stats = &budget->stats;
    uint32_t pixels = 0;
    for (unsigned i = 0; i < GLINT_METHODS; i++)
        pixels += stats->pixels[i];
    fprintf(out, "<tr><td>%g</td><td>%.2f</td><td>%.2f</td><td>%.2f</td><td>%.1f</td>", budget->budget_q8 / 256.,
            stats->largest_error / 256., budget->error.max, budget->error.rms, plot_decibel(&budget->error));
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        fprintf(out, "<td>%.2f</td>", budget->instructions[cpu] / 1e6);
    for (unsigned i = 0; i < SWEEP_RUNGS; i++)
        fprintf(out, "<td>%u, %.0f %%</td>", (unsigned)stats->drawn[sweep_rungs[i]],
                pixels ? 100. * stats->pixels[sweep_rungs[i]] / pixels : 0.);
    for (unsigned i = 0; i < SWEEP_COUNTS; i++)
        fprintf(out, "<td>%u</td>", (unsigned)sweep_count(stats, i));
    fprintf(out, "</tr>\n");
}

/* What it was drawn by, of every second budget. */
static bool sweep_plans(FILE *out, const struct survey *survey)
{
    const struct survey_box *box = &survey->box;
    bool done = true;
    fprintf(out, "<div class=\"row\">");
    for (unsigned i = 0; i < survey->budget_count && done; i += 2) {
        const struct survey_budget *budget = &survey->budgets[i];
        const struct picture picture = {budget->plan + 3 * ((size_t)box->top * survey->width + box->left),
                                        3 * survey->width, box->width, box->height, PICTURE_RGB};
        char caption[160];
        snprintf(caption, sizeof caption, "what auto chose of %s within %g", survey->scene, budget->budget_q8 / 256.);
        fprintf(out, "<figure>");
        done = picture_write(out, &picture, caption);
        fprintf(out, "<figcaption>within %g</figcaption></figure>\n", budget->budget_q8 / 256.);
    }
    fprintf(out, "</div>\n");
    return done;
}

/* As firmware/raster/draw_shown.c paints. */
static const struct {
    enum glint_method_id id;
    uint8_t rgb[3];
} sweep_colours[] = {
    {GLINT_DARK, {45, 45, 60}},
    {GLINT_CONSTANT, {60, 110, 220}},
    {GLINT_GOURAUD, {60, 170, 75}},
    {GLINT_LINEAR, {200, 215, 70}},
    {GLINT_SIX, {245, 150, 40}},
    {GLINT_DUFF, {215, 50, 50}},
    {GLINT_PHONG, {190, 60, 200}},
    {GLINT_BUMP_LINEAR, {120, 215, 225}},
    {GLINT_BUMP_QUADRATIC, {50, 155, 190}},
    {GLINT_BUMP_NORMALISED, {30, 95, 150}},
};

void sweep_legend(FILE *out)
{
    for (unsigned i = 0; i < sizeof sweep_colours / sizeof *sweep_colours; i++) {
        const uint8_t *rgb = sweep_colours[i].rgb;
        fprintf(out, " <span style=\"background:#%02x%02x%02x;padding:0 .6em\"></span>\u00a0%s", rgb[0], rgb[1], rgb[2],
                glint_method_names[sweep_colours[i].id]);
    }
}

bool sweep_write(FILE *out, const struct survey *survey)
{
    if (!survey->budget_count)
        return true;
    fprintf(out, "<p><b>What to choose.</b>");
    if (survey->ideal_triangles) {
        fprintf(out, " No budget: they are of per-pixel Phong of this very mesh, and the truth here is of the curved "
                     "surface, to which Phong is no nearer.");
    } else {
        sweep_budget(out, survey, SWEEP_SEEN, "Where nothing may be seen,");
        sweep_budget(out, survey, SWEEP_FAST, "Where speed counts,");
        sweep_methods(out, survey);
    }
    fprintf(out, "</p>\n<div class=\"wide\"><table>\n<tr><th>budget</th><th>bound</th><th>largest</th><th>RMS</th>"
                 "<th>dB</th>");
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        fprintf(out, "<th>%s, M</th>", costs_cpu_titles[cpu]);
    for (unsigned i = 0; i < SWEEP_RUNGS; i++)
        fprintf(out, "<th>%s</th>", glint_method_names[sweep_rungs[i]]);
    for (unsigned i = 0; i < SWEEP_COUNTS; i++)
        fprintf(out, "<th>%s</th>", sweep_counts[i].title);
    fprintf(out, "</tr>\n");
    for (unsigned i = 0; i < survey->budget_count; i++)
        sweep_row(out, &survey->budgets[i]);
    fprintf(out, "</table></div>\n");
    return sweep_plans(out, survey);
}

void sweep_csv_head(FILE *out)
{
    fprintf(out, "scene,budget,bound,psnr_db,rms,max,p999");
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        fprintf(out, ",%s_instructions", costs_cpu_names[cpu]);
    for (unsigned i = 0; i < SWEEP_RUNGS; i++)
        fprintf(out, ",%s_triangles,%s_pixels", glint_method_names[sweep_rungs[i]], glint_method_names[sweep_rungs[i]]);
    for (unsigned i = 0; i < SWEEP_COUNTS; i++)
        fprintf(out, ",%s", sweep_counts[i].name);
    fprintf(out, "\n");
}

void sweep_csv(FILE *out, const struct survey *survey)
{
    for (unsigned k = 0; k < survey->budget_count; k++) {
        const struct survey_budget *budget = &survey->budgets[k];
        fprintf(out, "%s,%g,%.4f,%.4f,%.6f,%.4f,%g", survey->scene, budget->budget_q8 / 256.,
                budget->stats.largest_error / 256., plot_decibel(&budget->error), budget->error.rms, budget->error.max,
                budget->error.p999);
        for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
            fprintf(out, ",%u", (unsigned)budget->instructions[cpu]);
        for (unsigned i = 0; i < SWEEP_RUNGS; i++)
            fprintf(out, ",%u,%u", (unsigned)budget->stats.drawn[sweep_rungs[i]],
                    (unsigned)budget->stats.pixels[sweep_rungs[i]]);
        for (unsigned i = 0; i < SWEEP_COUNTS; i++)
            fprintf(out, ",%u", (unsigned)sweep_count(&budget->stats, i));
        fprintf(out, "\n");
    }
}
