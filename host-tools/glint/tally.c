/* SPDX-License-Identifier: MIT */
#include "glint/tally.h"

#include "glint/cli.h"

#include <inttypes.h>

void tally_add(struct tally *tally, const struct glint_stats *stats)
{
    tally->frames++;
    tally->triangles += stats->triangles;
    tally->culled += stats->culled;
    tally->rejected += stats->rejected;
    tally->clipped += stats->clipped;
    tally->dropped += stats->dropped;
    tally->setups += stats->setups;
    tally->turned += stats->turned;
    tally->fogged += stats->fogged;
    tally->fogged_by_pixel += stats->fogged_by_pixel;
    tally->fogged_wholly += stats->fogged_wholly;
    tally->highlight_tests += stats->highlight_tests;
    tally->potentially_highlighted += stats->potentially_highlighted;
    tally->specular_triangles += stats->specular_triangles;
    tally->linear_triangles += stats->linear_triangles;
    tally->hidden_lights += stats->hidden_lights;
    tally->hidden_highlights += stats->hidden_highlights;
    tally->dropped_highlights += stats->dropped_highlights;
    tally->straightened += stats->straightened;
    tally->undivided += stats->undivided;
    if (tally->largest_error < stats->largest_error)
        tally->largest_error = stats->largest_error;
    for (int m = 0; m < GLINT_METHODS; m++) {
        tally->drawn[m] += stats->drawn[m];
        tally->pixels[m] += stats->pixels[m];
    }
    for (int t = 0; t < GLINT_TEXTURES; t++)
        tally->mapped[t] += stats->mapped[t];
}

static void tally_count(const char *name, uint64_t count, const char *meaning, bool json)
{
    if (json)
        printf("\"%s\": %" PRIu64 ", ", name, count);
    else
        printf("%-20s %" PRIu64 "%s%s\n", name, count, *meaning ? "  " : "", meaning);
}

static void tally_each(const char *name, const uint64_t *count, const char *const *of, int kinds, bool json)
{
    const char *between = "";
    uint64_t sum = 0;
    printf(json ? "\"%s\": {" : "%-20s", name);
    for (int i = 0; i < kinds; i++)
        if (json) {
            printf("%s\"%s\": %" PRIu64, between, of[i], count[i]);
            between = ", ";
        } else if (count[i]) {
            printf(" %" PRIu64 " %s", count[i], of[i]);
            sum += count[i];
        }
    printf("%s", json ? "}, " : sum ? "\n" : " 0\n");
}

/* What auto left out. */
static void tally_plan(const struct tally *tally, const struct glint_config *config, bool json)
{
    const double budget = (config->budget ? config->budget : GLINT_BUDGET(2, 1)) / 256.0;
    tally_count("hidden_lights", tally->hidden_lights, "not computed: they reach no pixel of a triangle (exact)", json);
    tally_count("hidden_highlights", tally->hidden_highlights, "likewise (exact)", json);
    tally_count("dropped_highlights", tally->dropped_highlights, "too faint for the budget", json);
    tally_count("straightened", tally->straightened, "N.L and N.H that bend too little for it", json);
    tally_count("undivided", tally->undivided, "drawn without perspective correction, which it does not see", json);
    const double error = tally->largest_error / 256.0;
    if (json)
        printf("\"budget\": %.3f, \"largest_error\": %.3f, ", budget, error);
    else
        printf("%-20s %.2f  in 1/255\n%-20s %.2f  the largest bound of a triangle's error\n", "budget", budget,
               "largest_error", error);
}

void tally_print(const struct tally *tally, const struct renderer *renderer, bool json)
{
    const struct glint_config *config = &renderer->config;
    double each = tally->frames ? tally->milliseconds / tally->frames : 0;
    if (json)
        printf("{\"width\": %u, \"height\": %u, \"format\": \"%s\", \"method\": \"%s\", ", config->width,
               config->height, cli_formats[config->format], renderer->choice->name);
    else
        printf("%-20s %ux%u %s, %s\n", "picture", config->width, config->height, cli_formats[config->format],
               renderer->choice->name);
    tally_count("frames", tally->frames, "all counts below are sums over them", json);
    tally_count("band_rows", config->band_rows, "", json);
    tally_count("band_bytes", glint_band_bytes(config), "one band; two of them let one be sent while the next is drawn",
                json);
    tally_count("memory_bytes", config->memory_bytes, "stores, depth and tables beside the bands", json);
    tally_count("triangles", tally->triangles, "in all objects", json);
    tally_count("culled", tally->culled, "facing away or without area", json);
    tally_count("rejected", tally->rejected, "outside the view", json);
    tally_count("clipped", tally->clipped, "", json);
    tally_count("dropped", tally->dropped, "no room for them", json);
    tally_each("drawn", tally->drawn, glint_method_names, GLINT_METHODS, json);
    tally_each("pixels", tally->pixels, glint_method_names, GLINT_METHODS, json);
    tally_count("specular_triangles", tally->specular_triangles, "drawn ones that a highlight can reach", json);
    tally_count("linear_triangles", tally->linear_triangles, "drawn by x or six, their bend too small to show", json);
    tally_count("highlight_tests", tally->highlight_tests, "of triangles, where the method asks for them", json);
    tally_count("potentially_highlighted", tally->potentially_highlighted, "those that passed", json);
    tally_count("setups", tally->setups, "", json);
    tally_count("turned", tally->turned, "of which the back is seen", json);
    tally_each("mapped", tally->mapped + 1, cli_textures + 1, GLINT_TEXTURES - 1, json);
    tally_count("fogged", tally->fogged, "drawn ones that some fog reaches", json);
    tally_count("fogged_by_pixel", tally->fogged_by_pixel, "of them, those whose fog is found at each pixel", json);
    tally_count("fogged_wholly", tally->fogged_wholly, "of them, those that are all fog: unlit", json);
    if (config->method == &glint_auto || config->method == &glint_auto_shown)
        tally_plan(tally, config, json);
    printf(json ? "\"ms_per_frame\": %.3f}\n" : "ms_per_frame         %.3f  on this machine, without output\n", each);
}
