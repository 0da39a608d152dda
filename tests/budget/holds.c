/* SPDX-License-Identifier: MIT */
#include "drawn.h"
#include "pack/pack.h"
#include "picture.h"
#include "glint/renderer.h"

#include <math.h>

static int field(const uint8_t *pixels, unsigned format, size_t i, unsigned c, double *full)
{
    static const int shift[] = {11, 5, 0}, top[] = {31, 63, 31};
    *full = 255;
    if (format == GLINT_GREY8)
        return pixels[i];
    if (format == GLINT_RGB888)
        return pixels[3 * i + c];
    *full = top[c];
    return ((const uint16_t *)(const void *)pixels)[i] >> shift[c] & top[c];
}

int main(int argc, char **argv)
{
    const char *path = argv[1];
    unsigned views = (unsigned)atoi(argv[2]);
    unsigned format = (unsigned)atoi(argv[3]);
    struct pack_result packed;
    struct drawn_scene d;
    if (pack_load(path, NULL, &packed))
        return 1;
    drawn_open(&d, packed.scene);
    unsigned w = packed.scene->camera.reference_width, h = packed.scene->camera.reference_height;
    struct budget_picture ids = {.config = {.width = w, .height = h, .format = GLINT_GREY8, .method = &drawn_method}};
    budget_open(&ids, d.scene);
    uint32_t *drawn = budget_alloc(sizeof *drawn * w * h);
    drawn_from = &d;
    drawn_to = drawn;
    struct budget_picture p[16];
    double worst[16] = {0};
    long over[16] = {0}, missed = 0, total = 0;
    int n = argc - 4;
    for (int m = 0; m < n; m++) {
        p[m] = (struct budget_picture){
            .config = {.width = w, .height = h, .format = format, .method = renderer_find(argv[4 + m])->method}};
        budget_open(&p[m], packed.scene);
    }
    for (unsigned v = 0; v < views; v++) {
        struct budget_view view = {v * 40503u, v * 10007u + (v ? 3000 : 0), v * 137};
        if (!v)
            view.yaw = view.pitch = 0;
        memset(drawn, 0xff, sizeof *drawn * w * h);
        budget_draw(&ids, d.scene, view);
        struct reference_image truth;
        struct reference_options o = {.time_ms = view.time_ms,
                                      .yaw = view.yaw,
                                      .pitch = view.pitch,
                                      .grey = format == GLINT_GREY8,
                                      .drawn = drawn};
        reference_render(packed.scene, &o, &truth);
        for (size_t i = 0; i < w * h; i++) {
            total += drawn[i] != REFERENCE_NOTHING;
            missed += (drawn[i] != REFERENCE_NOTHING) != truth.covered[i];
        }
        for (int m = 0; m < n; m++) {
            budget_draw(&p[m], packed.scene, view);
            double most = 0;
            size_t at = 0;
            for (size_t i = 0; i < w * h; i++)
                if (truth.covered[i])
                    for (unsigned c = 0; c < truth.channels; c++) {
                        double full, got = field(p[m].pixels, format, i, c, &full);
                        double e = fabs(got - full * truth.value[i * truth.channels + c]);
                        over[m] += e > 1.5;
                        if (e > most)
                            most = e, at = i;
                    }
            if (most > worst[m]) {
                worst[m] = most;
                if (getenv("V") && most > 1.5)
                    printf("%s view %u (%u %u %u) pixel %zu %zu triangle %u: %.2f truth %.2f\n", argv[4 + m], v,
                           view.yaw, view.pitch, view.time_ms, at % w, at / w, drawn[at], most,
                           255 * truth.value[at * truth.channels]);
            }
        }
        reference_free(&truth);
    }
    printf("%-32s %ld pixels, %ld missed;", path, total, missed);
    for (int m = 0; m < n; m++)
        printf(" %s %.2f (%ld)", argv[4 + m], worst[m], over[m]);
    puts("");
}
