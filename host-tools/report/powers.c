/* SPDX-License-Identifier: MIT */
#include "report/powers.h"

#include "glint/cli.h"
#include "glint/renderer.h"
#include "pack/pack.h"
#include "report/drawing.h"
#include "report/plot.h"
#include "report/survey.h"
#include "scene/model.h"
#include "shade/power.h"

#include <math.h>
#include <stdlib.h>

#define POWERS_PLACES (1 << 17) /* at which the function itself is measured */

static const unsigned powers_exponents[] = {5, 20, 50, 200};
static const char *const powers_titles[RENDERER_POWERS] = {"table", "exact", "\u03b3 = 4", "\u03b3 = 8", "\u03b3 = 16"};
static const char *const powers_methods[] = {"x", "phong"};

#define COUNT(array) (sizeof(array) / sizeof *(array))

double powers_error(unsigned form, unsigned exponent)
{
    const struct glint_power *power = renderer_powers[form];
    struct fx_power table;
    double largest = 0;
    fx_power_build(&table, exponent);
    for (int32_t i = 0; i <= POWERS_PLACES; i++) {
        int32_t value = i * ((1 << 30) / POWERS_PLACES);
        if (power)
            power->run(exponent, &value, 1);
        else
            value = (int32_t)fx_power(&table, value);
        largest = fmax(largest, fabs(value / 32768. - pow((double)i / POWERS_PLACES, exponent)));
    }
    return 255 * largest;
}

/* One exponent of the scene. */
struct powers_case {
    const char *path, *scene;
    unsigned exponent;
    struct pack_result packed;
    struct reference_image truth;
    uint8_t *grey;
};

static int powers_cost(FILE *out, const struct powers_case *c, const struct costs *costs, unsigned form)
{
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++) {
        const struct costs_power *cost = costs_find_power(costs, cpu, c->scene, form, c->exponent);
        if (!cost) {
            fprintf(stderr, "%s: no line for %s with power %s and exponent %u on %s\n", costs->powers_path, c->scene,
                    renderer_power_names[form], c->exponent, costs_cpu_names[cpu]);
            return CLI_BAD_DATA;
        }
        fprintf(out, "<td>%.2f</td>", cost->instructions / 1e6);
    }
    return CLI_DONE;
}

static int powers_row(FILE *out, const struct powers_case *c, const struct costs *costs, unsigned form)
{
    int code = CLI_DONE;
    fprintf(out, "<tr%s><td>%u, %s</td><td>%.2f</td>", form ? "" : " class=\"first\"", c->exponent, powers_titles[form],
            powers_error(form, c->exponent));
    for (unsigned m = 0; !code && m < COUNT(powers_methods); m++) {
        struct compare_result error;
        const struct drawing how = {.method = powers_methods[m], .power = renderer_powers[form]};
        code = drawing_make(c->grey, c->packed.scene, c->path, &how, NULL);
        drawing_compare(c->grey, &c->truth, c->truth.covered, &error);
        fprintf(out, "<td>%.1f</td><td>%.1f</td>", plot_decibel(&error), error.max);
    }
    if (!code)
        code = powers_cost(out, c, costs, form);
    fprintf(out, "</tr>\n");
    return code;
}

static int powers_exponent(FILE *out, struct powers_case *c, const struct costs *costs)
{
    const struct reference_options options = {.grey = true};
    int code = pack_load(c->path, &(struct pack_options){.shininess = c->exponent}, &c->packed);
    if (code)
        return code;
    if (reference_render(c->packed.scene, &options, &c->truth)) {
        c->grey = model_alloc((size_t)c->truth.width * c->truth.height);
        for (unsigned form = 0; !code && form < RENDERER_POWERS; form++)
            code = powers_row(out, c, costs, form);
        free(c->grey);
        reference_free(&c->truth);
    } else {
        fprintf(stderr, "%s: out of memory\n", c->path);
        code = CLI_IO;
    }
    pack_free(&c->packed);
    return code;
}

int powers_write(FILE *out, const char *path, const struct costs *costs)
{
    char scene[SURVEY_NAME] = "";
    int code = CLI_DONE;
    survey_name(path, scene);
    fprintf(
        out,
        "<h2 id=\"power\">The highlight\u2019s power</h2>\n"
        "<p>N\u00b7H to the power n by an interpolated table, exactly (integers, rounded to nearest), and free of "
        "powers as max(0, 1 \u2212 (n/\u03b3)(1 \u2212 N\u00b7H))<sup>\u03b3</sup>, whose affine part "
        "is folded into set-up. The function\u2019s own error is the largest over 0..1, in 1/255 of a full highlight; "
        "pictures are %s by x and by phong; instructions, in millions, are those of a frame by x.</p>\n"
        "<div class=\"wide\"><table>\n<tr><th>n, form</th><th>function</th>",
        scene);
    for (unsigned m = 0; m < COUNT(powers_methods); m++)
        fprintf(out, "<th>%s, dB</th><th>largest</th>", powers_methods[m]);
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        fprintf(out, "<th>%s</th>", costs_cpu_titles[cpu]);
    fprintf(out, "</tr>\n");
    for (unsigned e = 0; !code && e < COUNT(powers_exponents); e++) {
        struct powers_case c = {.path = path, .scene = scene, .exponent = powers_exponents[e]};
        code = powers_exponent(out, &c, costs);
    }
    fprintf(out, "</table></div>\n");
    return code;
}
