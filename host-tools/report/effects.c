/* SPDX-License-Identifier: MIT */
#include "report/effects.h"

#include "glint/cli.h"
#include "pack/pack.h"
#include "report/drawing.h"
#include "report/picture.h"
#include "report/plot.h"
#include "report/survey.h"
#include "report/sweep.h"
#include "scene/model.h"

#include <math.h>
#include <stdlib.h>

struct effects_case {
    const char *path;
    char scene[SURVEY_NAME];
    struct pack_result packed;
    struct reference_image truth;
    uint8_t *drawn, *rounded, *plan, *difference; /* three in RGB888, and levels */
    struct glint_stats stats;
    struct compare_result error;
};

static int effects_draw(struct effects_case *c)
{
    const struct reference_options options = {0};
    if (!reference_render(c->packed.scene, &options, &c->truth)) {
        c->truth = (struct reference_image){0};
        fprintf(stderr, "%s: out of memory\n", c->path);
        return CLI_IO;
    }
    const size_t pixels = (size_t)c->truth.width * c->truth.height;
    c->drawn = model_alloc(3 * pixels);
    c->rounded = model_alloc(3 * pixels);
    c->plan = model_alloc(3 * pixels);
    c->difference = model_alloc(pixels);
    int code = drawing_make(c->drawn, c->packed.scene, c->path, &(struct drawing){.method = "auto", .colour = true},
                            &c->stats);
    if (!code)
        code = drawing_make(c->plan, c->packed.scene, c->path,
                            &(struct drawing){.show = &glint_auto_shown, .colour = true}, NULL);
    if (code)
        return code;
    drawing_compare(c->drawn, &c->truth, c->truth.covered, &c->error);
    for (size_t i = 0; i < pixels; i++) {
        double most = 0;
        for (size_t k = 3 * i; k < 3 * i + 3; k++) {
            double off = c->drawn[k] - 255 * c->truth.value[k];
            most = fabs(off) > fabs(most) ? off : most;
            c->rounded[k] = reference_byte(c->truth.value[k]);
        }
        c->difference[i] = (uint8_t)(PICTURE_RIGHT + (c->truth.covered[i] ? picture_level(most) : 0));
    }
    return CLI_DONE;
}

static bool effects_picture(FILE *out, const struct effects_case *c, const uint8_t *pixels, enum picture_kind kind,
                            const char *what)
{
    const unsigned width = c->truth.width;
    const struct picture picture = {pixels, kind == PICTURE_RGB ? 3 * width : width, width, c->truth.height, kind};
    char caption[160];
    snprintf(caption, sizeof caption, "%s, %s", c->scene, what);
    fprintf(out, "<figure>");
    bool done = picture_write(out, &picture, caption);
    fprintf(out, "<figcaption>%s</figcaption></figure>\n", what);
    return done;
}

/* Triangles and pixels by what they were drawn by. */
static void effects_figures(FILE *out, const struct effects_case *c)
{
    uint32_t pixels = 0;
    for (unsigned i = 0; i < GLINT_METHODS; i++)
        pixels += c->stats.pixels[i];
    fprintf(out, "<dl><dt>largest difference</dt><dd>%.2f, %.1f dB; bound %.2f</dd><dt>drawn by</dt><dd>", c->error.max,
            plot_decibel(&c->error), c->stats.largest_error / 256.);
    const char *comma = "";
    for (unsigned i = 0; i < GLINT_METHODS; i++)
        if (c->stats.drawn[i]) {
            fprintf(out, "%s%s %u (%.0f %%)", comma, glint_method_names[i], (unsigned)c->stats.drawn[i],
                    pixels ? 100. * c->stats.pixels[i] / pixels : 0.);
            comma = ", ";
        }
    fprintf(out,
            "</dd><dt>not computed</dt><dd>lights hidden %u, highlights hidden %u and dropped %u, dot products "
            "straightened %u, triangles undivided %u</dd></dl>",
            (unsigned)c->stats.hidden_lights, (unsigned)c->stats.hidden_highlights,
            (unsigned)c->stats.dropped_highlights, (unsigned)c->stats.straightened, (unsigned)c->stats.undivided);
}

static int effects_scene(FILE *out, const char *path)
{
    struct effects_case c = {.path = path};
    if (!survey_name(path, c.scene)) {
        fprintf(stderr, "%s: a scene's name in a report is of letters, digits, - and _\n", path);
        return CLI_BAD_DATA;
    }
    int code = pack_load(path, NULL, &c.packed);
    if (code)
        return code;
    code = effects_draw(&c);
    if (!code) {
        fprintf(out, "<div class=\"card\" id=\"effect-%s\"><h3>%s</h3><div class=\"row\">\n", c.scene, c.scene);
        bool done = effects_picture(out, &c, c.drawn, PICTURE_RGB, "auto, budget 2") &&
                    effects_picture(out, &c, c.rounded, PICTURE_RGB, "the truth") &&
                    effects_picture(out, &c, c.difference, PICTURE_DIFFERENCE, "their difference") &&
                    effects_picture(out, &c, c.plan, PICTURE_RGB, "what auto chose");
        fprintf(out, "</div>");
        effects_figures(out, &c);
        fprintf(out, "</div>\n");
        if (!done) {
            fprintf(stderr, "%s: out of memory\n", path);
            code = CLI_IO;
        }
    }
    free(c.drawn);
    free(c.rounded);
    free(c.plan);
    free(c.difference);
    reference_free(&c.truth);
    pack_free(&c.packed);
    return code;
}

int effects_write(FILE *out, const char *const paths[], unsigned count)
{
    int code = CLI_DONE;
    fprintf(out,
            "<h2 id=\"effects\">Effects</h2>\n"
            "<p>Each scene by auto, within 2/255 of per-pixel Phong with the scene\u2019s own effects, in colour. A "
            "difference is that of the channel that is farthest off, in the colours above: from half a step of 255 "
            "on, an octave each. What auto chose, by the triangle, cheapest first:");
    sweep_legend(out);
    fprintf(out, ".</p>\n<div class=\"rows\">\n");
    for (unsigned i = 0; !code && i < count; i++)
        code = effects_scene(out, paths[i]);
    fprintf(out, "</div>\n");
    return code;
}
