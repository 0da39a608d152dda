/* SPDX-License-Identifier: MIT */
#include "measure.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "random_scene.h"

#include "glint/renderer.h"

static int any_point(const struct scene_header *scene)
{
    for (unsigned i = 0; i < scene->light_count; i++)
        if (scene_lights(scene)[i].kind == LIGHT_POINT)
            return 1;
    return 0;
}

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
        if (w.error > .5) {
            over++;
            printf("seed %u: %.2f at %u %u channel %u triangle %u truth %.2f; %s, %s, lights %u%s, n %u ks %.2f\n",
                   seed, w.error, w.x, w.y, w.channel, w.triangle, w.truth,
                   scene->camera.kind == CAMERA_PERSPECTIVE ? "persp" : "ortho",
                   scene->camera.viewer == VIEWER_LOCAL ? "local" : "far", scene->light_count,
                   any_point(scene) ? " point" : "", scene_materials(scene)->shininess,
                   scene_materials(scene)->ks / 32768.);
        }
        if (w.error > .5 && getenv("V")) {
            const struct scene_mesh *mesh = scene_meshes(scene);
            const struct scene_triangle *t =
                (const struct scene_triangle *)scene_at(scene, mesh->triangles) + w.triangle;
            const struct scene_vertex *v = scene_at(scene, mesh->vertices);
            for (int k = 0; k < 3; k++) {
                const struct scene_vertex *q = v + t->corner[k];
                const int16_t *pl = m.placed[t->corner[k]];
                printf("   corner %d: place %d %d position %.4f %.4f %.4f normal %.4f %.4f %.4f bend %u\n", k, pl[0],
                       pl[1], q->position[0] / 32768., q->position[1] / 32768., q->position[2] / 32768.,
                       q->normal[0] / 16384., q->normal[1] / 16384., q->normal[2] / 16384., t->bend[k]);
            }
            printf("   pixel %g %g level %u\n", 16 * (w.x + .5 - m.width / 2.), 16 * (w.y + .5 - m.height / 2.),
                   p.pixels[(w.y * m.width + w.x) * 3 + w.channel]);
            for (unsigned l = 0; l < scene->light_count; l++) {
                const struct scene_light *q = scene_lights(scene) + l;
                double u = q->kind == LIGHT_POINT ? 65536 : 1 << 30;
                printf("   light %d: %.4f %.4f %.4f\n", q->kind, q->vector[0] / u, q->vector[1] / u,
                       (q->vector[2] - (q->kind == LIGHT_POINT ? scene_objects(scene)->position[2] : 0)) / u);
            }
        }
        budget_close(&p);
        measure_close(&m);
        free(scene);
    }
    printf("%s: %u of %u scenes beyond\n", name, over, count);
    return 0;
}
