/* SPDX-License-Identifier: MIT */
#include "glint/streamer.h"

#include "glint/cli.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct pack_format *const streamer_formats[GLINT_FORMATS] = {&pack_rgb565, &pack_rgb888, &pack_grey8,
                                                                          &pack_grey4};

static int streamer_write(void *context, const void *bytes, size_t size)
{
    struct streamer *s = context;
    return sink_write(&s->sink, bytes, size);
}

static int streamer_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct streamer *s = (struct streamer *)display;
    double start = cli_clock();
    (void)stride; /* the renderer leaves no gaps between rows */
    int result = stream_band(&s->stream, pixels, y, rows);
    s->pack_ms += cli_clock() - start;
    return result;
}

static const struct hal_display_ops streamer_ops = {.flush = streamer_flush};

int streamer_step(struct streamer *s, int result)
{
    if (result && !cli_interrupted() && errno != EPIPE) /* whoever looked has seen enough, and closed the window */
        fprintf(stderr, "%s: %s\n", strcmp(s->path, "-") ? s->path : "standard output", strerror(errno ? errno : EIO));
    return result ? CLI_IO : CLI_DONE;
}

int streamer_open(struct streamer *s, const struct renderer *renderer, const char *scene)
{
    const struct glint_config *config = &renderer->config;
    const struct stream_names names = {
        "glint", {&scene, 1, sizeof scene}, {glint_choices, (uint16_t)glint_choice_count, sizeof *glint_choices}};
    size_t row = glint_row_bytes(config);
    cli_catch_signals();
    s->display.ops = &streamer_ops;
    s->stream = (struct stream){.write = streamer_write,
                                .context = s,
                                .pixels = streamer_formats[config->format],
                                .width = config->width,
                                .height = config->height,
                                .buffer = malloc(row * config->band_rows),
                                .buffer_bytes = (uint32_t)(row * config->band_rows),
                                .last = malloc(row * config->height)};
    if (!s->stream.buffer || !s->stream.last)
        errno = ENOMEM;
    s->open = s->stream.buffer && s->stream.last && sink_open(&s->sink, s->path) == 0;
    if (!s->open) {
        free(s->stream.buffer);
        free(s->stream.last);
        return streamer_step(s, HAL_E_IO);
    }
    return streamer_step(s, stream_hello(&s->stream, &names));
}

int streamer_begin(struct streamer *s, const struct renderer *renderer, uint32_t index, uint32_t moment_ms)
{
    const struct stream_frame frame = {.moment_ms = moment_ms,
                                       .method = (uint8_t)(renderer->choice - glint_choices),
                                       .budget = renderer->config.subdivide_tolerance};
    s->pack_ms = 0;
    s->stream.time_us = (uint32_t)((uint64_t)moment_ms * 1000 & UINT32_MAX);
    s->stream.key = s->key_every && index % s->key_every == 0;
    return streamer_step(s, stream_frame_begin(&s->stream, &frame));
}

int streamer_end(struct streamer *s, const struct renderer *renderer, double draw_ms)
{
    const struct glint_stats *stats = &renderer->frame.stats;
    struct stream_statistics statistics = {.draw_us = (uint32_t)(draw_ms * 1e3),
                                           .pack_us = (uint32_t)(s->pack_ms * 1e3),
                                           .triangles = stats->triangles,
                                           .dropped = stats->dropped};
    for (int id = 0; id < GLINT_METHODS; id++)
        statistics.drawn += stats->drawn[id];
    int result = stream_frame_end(&s->stream, &statistics);
    /* who looks at a pipe wants to see each picture when it is there */
    if (!result && !s->sink.target && fflush(s->sink.stream) != 0)
        result = HAL_E_IO;
    return streamer_step(s, result);
}

int streamer_close(struct streamer *s, bool keep)
{
    if (!s->open)
        return CLI_DONE;
    s->open = false;
    keep = keep && !cli_interrupted();
    errno = 0;
    int result = sink_close(&s->sink, keep);
    free(s->stream.buffer);
    free(s->stream.last);
    return keep ? streamer_step(s, result) : CLI_DONE;
}
