/* SPDX-License-Identifier: MIT */
#include "glint/renderer.h"

#include "glint/cli.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const renderer_power_names[RENDERER_POWERS] = {"table", "exact", "4", "8", "16"};
const struct glint_power *const renderer_powers[RENDERER_POWERS] = {NULL, &glint_power_exact, &glint_power_4,
                                                                    &glint_power_8, &glint_power_16};

const struct glint_choice *renderer_find(const char *name)
{
    for (unsigned m = 0; m < glint_choice_count; m++)
        if (strcmp(name, glint_choices[m].name) == 0)
            return &glint_choices[m];
    return NULL;
}

int renderer_open(struct renderer *renderer, const struct scene_header *scene)
{
    struct glint_config *config = &renderer->config;
    renderer->scene = scene;
    config->method = renderer->choice->method;
    glint_fit_stores(config, scene);
    config->memory_bytes = glint_memory_needed(config);
    renderer->memory = malloc(config->memory_bytes);
    config->memory = renderer->memory;
    for (int i = 0; i < 2; i++)
        config->band[i] = renderer->band[i] = malloc(glint_band_bytes(config));
    if (config->memory_bytes > 0 && renderer->memory && renderer->band[0] && renderer->band[1] &&
        glint_init(&renderer->frame, config) == 0)
        return CLI_DONE;
    fprintf(stderr, "glint: the renderer does not take this configuration, or memory ran out\n");
    renderer_close(renderer);
    return CLI_IO;
}

int renderer_draw(struct renderer *renderer, uint32_t time_ms, struct hal_display *display, uint32_t *crc,
                  double *milliseconds)
{
    size_t row_bytes = glint_row_bytes(&renderer->config);
    struct glint_band band;
    double start = cli_clock();
    /* a checked scene and a configuration that glint_init() took: this cannot fail */
    glint_frame_begin(&renderer->frame, renderer->scene, time_ms);
    for (int result = 0; glint_frame_next_band(&renderer->frame, &band) == 1; start = cli_clock()) {
        *milliseconds += cli_clock() - start;
        for (unsigned row = 0; crc && row < band.rows; row++)
            *crc = scene_crc32(*crc, (const uint8_t *)band.pixels + row * band.stride, row_bytes);
        if (display)
            result = display->ops->flush(display, band.pixels, band.y, band.rows, band.stride);
        if (result)
            return result;
    }
    *milliseconds += cli_clock() - start;
    if (renderer->dropped < renderer->frame.stats.dropped)
        renderer->dropped = renderer->frame.stats.dropped;
    return 0;
}

void renderer_warn(const struct renderer *renderer, const char *path)
{
    if (renderer->dropped)
        fprintf(stderr, "%s: warning: %u of %u triangles are missing: a frame holds %u vertices and %u triangles\n",
                path, (unsigned)renderer->dropped, (unsigned)renderer->frame.stats.triangles,
                renderer->config.max_vertices, renderer->config.max_triangles);
}

void renderer_close(struct renderer *renderer)
{
    free(renderer->memory);
    free(renderer->band[0]);
    free(renderer->band[1]);
    *renderer = (struct renderer){0};
}
