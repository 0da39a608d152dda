/* SPDX-License-Identifier: MIT */
#include "report/traffic.h"

#include "glint/cli.h"
#include "glint/renderer.h"
#include "scene/model.h"
#include "stream/stream.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TRAFFIC_BANDS   4u    /* a picture */
#define TRAFFIC_LOOP_MS 4000u /* of a scene that has no duration */
#define TRAFFIC_MESSAGE (STREAM_HEADER + STREAM_CHECK)
#define TRAFFIC_FRAME   (2 * TRAFFIC_MESSAGE + STREAM_FRAME_BEGIN + STREAM_FRAME_END) /* bytes besides its bands */

const struct traffic_kind traffic_kinds[TRAFFIC_KINDS] = {
    {"rgb565", GLINT_RGB565, 240, 240, false}, {"rgb565 dithered", GLINT_RGB565, 240, 240, true},
    {"grey8", GLINT_GREY8, 240, 240, false},   {"grey4 dithered", GLINT_GREY4, 240, 240, true},
    {"grey4", GLINT_GREY4, 128, 64, false},    {"grey4 dithered", GLINT_GREY4, 128, 64, true},
};
const char *const traffic_ways[TRAFFIC_WAYS] = {"raw", "changed_rows", "alone", "change", "least"};

static const struct pack_format *const traffic_formats[GLINT_FORMATS] = {&pack_rgb565, &pack_rgb888, &pack_grey8,
                                                                         &pack_grey4};

/* A display that sends what it is given in two ways. */
struct traffic_sender {
    struct hal_display display;
    struct stream alone, change;
    uint32_t alone_bytes, change_bytes; /* sent so far */
    uint8_t *before;                    /* the picture before */
    uint32_t bytes[TRAFFIC_WAYS];       /* of the picture under way */
};

static int traffic_count(void *context, const void *bytes, size_t size)
{
    (void)bytes;
    *(uint32_t *)context += (uint32_t)size;
    return 0;
}

/* Bytes of the rows that changed, as messages of rows without gaps; takes them as those of the picture before. */
static uint32_t traffic_rows(uint8_t *before, const uint8_t *pixels, uint32_t rows, uint32_t stride)
{
    uint32_t bytes = 0;
    bool open = false;
    for (uint32_t row = 0; row < rows; row++, before += stride, pixels += stride) {
        bool changed = memcmp(before, pixels, stride) != 0;
        if (changed)
            bytes += stride + (open ? 0 : TRAFFIC_MESSAGE);
        open = changed;
        memcpy(before, pixels, stride);
    }
    return bytes;
}

static int traffic_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct traffic_sender *s = (struct traffic_sender *)display;
    uint32_t alone = s->alone_bytes, change = s->change_bytes;
    stream_band(&s->alone, pixels, y, rows); /* traffic_count() never fails */
    stream_band(&s->change, pixels, y, rows);
    alone = s->alone_bytes - alone;
    change = s->change_bytes - change;
    s->bytes[TRAFFIC_RAW] += TRAFFIC_MESSAGE + rows * stride;
    s->bytes[TRAFFIC_ROWS] += traffic_rows(s->before + y * stride, pixels, rows, stride);
    s->bytes[TRAFFIC_ALONE] += alone;
    s->bytes[TRAFFIC_CHANGE] += change;
    s->bytes[TRAFFIC_LEAST] += alone < change ? alone : change;
    return 0;
}

static const struct hal_display_ops traffic_ops = {.flush = traffic_flush};

static void traffic_open(struct traffic_sender *s, const struct traffic_kind *kind, uint32_t stride)
{
    uint32_t band = kind->height / TRAFFIC_BANDS * stride;
    s->display.ops = &traffic_ops;
    s->before = model_alloc((size_t)stride * kind->height);
    s->alone = (struct stream){.write = traffic_count,
                               .context = &s->alone_bytes,
                               .pixels = traffic_formats[kind->format],
                               .width = kind->width,
                               .height = kind->height,
                               .buffer = model_alloc(band),
                               .buffer_bytes = band};
    s->change = s->alone;
    s->change.context = &s->change_bytes;
    s->change.last = model_alloc((size_t)stride * kind->height);
}

static void traffic_close(struct traffic_sender *s)
{
    free(s->before);
    free(s->alone.buffer);
    free(s->change.last);
}

static void traffic_send(struct traffic_sender *s, struct renderer *renderer, uint32_t time_ms)
{
    static const struct stream_frame frame = {0};
    static const struct stream_statistics statistics = {0};
    double milliseconds = 0;
    for (unsigned way = 0; way < TRAFFIC_WAYS; way++)
        s->bytes[way] = TRAFFIC_FRAME;
    stream_frame_begin(&s->alone, &frame);
    stream_frame_begin(&s->change, &frame);
    renderer_draw(renderer, time_ms, &s->display, NULL, &milliseconds);
    stream_frame_end(&s->alone, &statistics);
    stream_frame_end(&s->change, &statistics);
}

/* Gives each object a turn, about an axis that is nothing to it, if the scene stands still. */
static void traffic_stir(struct scene_header *scene)
{
    struct scene_object *objects = (struct scene_object *)((uint8_t *)scene + scene->objects);
    const struct scene_light *lights = (const struct scene_light *)((const uint8_t *)scene + scene->lights);
    bool moves = false;
    for (unsigned i = 0; i < scene->object_count; i++)
        moves = moves || objects[i].motion.kind != MOTION_NONE;
    for (unsigned i = 0; i < scene->light_count; i++)
        moves = moves || lights[i].motion.kind != MOTION_NONE;
    for (unsigned i = 0; i < scene->object_count && !moves; i++)
        objects[i].motion = (struct scene_motion){
            .kind = MOTION_SPIN, .axis = {644245094, 858993459, 0} /* (.6, .8, 0) */, .rate = 65536 / 4};
}

static int traffic_scene(struct traffic *traffic, const char *path, const struct scene_header *scene, unsigned index)
{
    const struct traffic_kind *kind = &traffic_kinds[index];
    uint32_t loop = scene->duration_ms ? scene->duration_ms : TRAFFIC_LOOP_MS;
    uint64_t sum[TRAFFIC_WAYS] = {0};
    struct traffic_sender sender = {0};
    struct renderer renderer = {.choice = renderer_find("x"),
                                .config = {.width = kind->width,
                                           .height = kind->height,
                                           .band_rows = (uint16_t)(kind->height / TRAFFIC_BANDS),
                                           .format = (uint8_t)kind->format,
                                           .flags = kind->dither ? GLINT_DITHER : 0}};
    int code = renderer_open(&renderer, scene);
    if (code)
        return code;
    traffic_open(&sender, kind, glint_row_bytes(&renderer.config));
    memset(traffic->most[index], 0, sizeof traffic->most[index]);
    for (uint32_t i = 0; i < TRAFFIC_MOMENTS; i++) {
        uint32_t moment = (uint32_t)((uint64_t)loop * i / TRAFFIC_MOMENTS);
        traffic_send(&sender, &renderer, moment);
        traffic_send(&sender, &renderer, moment + TRAFFIC_STEP_MS);
        for (unsigned way = 0; way < TRAFFIC_WAYS; way++) {
            uint32_t *most = &traffic->most[index][way];
            sum[way] += sender.bytes[way];
            *most = *most > sender.bytes[way] ? *most : sender.bytes[way];
        }
    }
    for (unsigned way = 0; way < TRAFFIC_WAYS; way++)
        traffic->mean[index][way] = (uint32_t)((sum[way] + TRAFFIC_MOMENTS / 2) / TRAFFIC_MOMENTS);
    renderer_warn(&renderer, path);
    traffic_close(&sender);
    renderer_close(&renderer);
    return CLI_DONE;
}

static int traffic_kinds_of(struct traffic *traffic, const char *path, unsigned first, unsigned end)
{
    struct pack_result packed;
    if (!survey_name(path, traffic->scene)) {
        fprintf(stderr, "%s: a scene's name in a report is of letters, digits, - and _\n", path);
        return CLI_BAD_DATA;
    }
    int code = pack_load(path, NULL, &packed);
    if (code)
        return code;
    traffic_stir((struct scene_header *)(uintptr_t)packed.scene); /* the heap's, and ours */
    for (unsigned kind = first; !code && kind < end; kind++)
        code = traffic_scene(traffic, path, packed.scene, kind);
    pack_free(&packed);
    return code;
}

int traffic_measure_kind(struct traffic *traffic, const char *path, unsigned kind)
{
    return traffic_kinds_of(traffic, path, kind, kind + 1);
}

int traffic_measure(struct traffic *traffic, const char *path)
{
    return traffic_kinds_of(traffic, path, 0, TRAFFIC_KINDS);
}
