/* SPDX-License-Identifier: MIT */
#include "measure.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "random_scene.h"

#include "glint/renderer.h"

int main(int argc, char **argv)
{
    const unsigned first = argc > 1 ? (unsigned)atoi(argv[1]) : 0, count = argc > 2 ? (unsigned)atoi(argv[2]) : 1000;
    const char *name = argc > 3 ? argv[3] : "phong-perspective";
    const uint8_t format = (uint8_t)(argc > 4 ? atoi(argv[4]) : GLINT_RGB888);
    unsigned over = 0;
    for (unsigned seed = first; seed < first + count; seed++) {
        struct scene_header *scene = random_scene(seed);
        struct measure m;
        measure_open(&m, scene, RANDOM_WIDTH, RANDOM_HEIGHT, format);
        measure_view(&m, (struct budget_view){0});
        struct budget_picture p = {.config = {.width = RANDOM_WIDTH,
                                              .height = RANDOM_HEIGHT,
                                              .format = format,
                                              .method = renderer_find(name)->method}};
        budget_open(&p, scene);
        budget_draw(&p, scene, m.view);
        struct measure_worst w = measure_picture(&m, p.pixels);
        if (w.error > 1) {
            over++;
            printf("seed %u: %.2f at %u %u channel %u triangle %u truth %.2f; %s, %s, lights %u%s, n %u ks %.2f\n", seed,
                   w.error, w.x, w.y, w.channel, w.triangle, w.truth,
                   scene->camera.kind == CAMERA_PERSPECTIVE ? "persp" : "ortho",
                   scene->camera.viewer == VIEWER_LOCAL ? "local" : "far", scene->light_count,
                   scene_lights(scene)->kind == LIGHT_POINT ? " point" : "", scene_materials(scene)->shininess,
                   scene_materials(scene)->ks / 32768.);
        }
        budget_close(&p);
        measure_close(&m);
        free(scene);
    }
    printf("%s: %u of %u scenes beyond\n", name, over, count);
    return 0;
}
