/* SPDX-License-Identifier: MIT */
/*
 * The budget's promise on scenes made at random (random_scene.h), each at a random budget, format and, of RGB565, with
 * or without colour tables; and that the renderer's fallback keeps it with none.
 *   random [FIRST [COUNT]]    seeds; 5000 from 0
 */
#include "measure.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "random_scene.h"

/* Beyond the budget and half a step of the output. */
#define ROUNDINGS 1.0
#define LEAST     .25 /* budget */

static double measured(const struct measure *m, const struct glint_method *method, double budget)
{
    struct budget_picture p = {.config = {.width = RANDOM_WIDTH,
                                          .height = RANDOM_HEIGHT,
                                          .format = m->format,
                                          .method = method,
                                          .budget = (uint16_t)lrint(budget * 256)}};
    budget_open(&p, m->scene);
    budget_draw(&p, m->scene, m->view);
    const struct measure_worst worst = measure_picture(m, p.pixels);
    if (worst.error > budget + ROUNDINGS)
        printf("  %.2f of a truth of %.2f at (%u, %u), channel %u, triangle %u\n", worst.error, worst.truth, worst.x,
               worst.y, worst.channel, worst.triangle);
    budget_close(&p);
    return worst.error - budget;
}

static int any_point(const struct scene_header *scene)
{
    for (unsigned i = 0; i < scene->light_count; i++)
        if (scene_lights(scene)[i].kind == LIGHT_POINT)
            return 1;
    return 0;
}

static const char *described(const struct scene_header *scene)
{
    static char text[256];
    static const char *const fogs[] = {"", ", linear fog", ", exponential fog"};
    const struct scene_material *m = scene_materials(scene);
    snprintf(text, sizeof text, "%s, %s viewer, %u lights%s, kd %.2f, ks %.2f, n %u%s%s%s%s",
             scene->camera.kind == CAMERA_PERSPECTIVE ? "perspective" : "orthographic",
             scene->camera.viewer == VIEWER_LOCAL ? "near" : "far", scene->light_count,
             any_point(scene) ? ", near ones among them" : "", m->kd / 32768., m->ks / 32768., m->shininess,
             m->texture != SCENE_NO_TEXTURE ? ", texture" : "", m->bump != SCENE_NO_TEXTURE ? ", bump map" : "",
             fogs[scene->fog.kind], m->flags & MATERIAL_TWO_SIDED ? ", two-sided" : "");
    return text;
}

int main(int argc, char **argv)
{
    const unsigned first = argc > 1 ? (unsigned)strtoul(argv[1], NULL, 10) : 0,
                   count = argc > 2 ? (unsigned)strtoul(argv[2], NULL, 10) : 5000;
    unsigned bad = 0;
    double beyond[2] = {0};
    for (unsigned seed = first; seed < first + count; seed++) {
        static const uint8_t formats[] = {GLINT_RGB888, GLINT_RGB888, GLINT_GREY8, GLINT_RGB565};
        struct scene_header *scene = random_scene(seed);
        const double budget = random_magnitude(LEAST, 32);
        const uint8_t format = formats[random_between(0, 3)];
        struct measure m;
        measure_open(&m, scene, RANDOM_WIDTH, RANDOM_HEIGHT, format);
        measure_view(&m, (struct budget_view){0, 0, 0});
        /* what it falls back on; a bump map's, auto alone draws */
        const int bumps = scene_materials(scene)->bump != SCENE_NO_TEXTURE;
        const double phong = LEAST + measured(&m, bumps ? &glint_auto : &glint_phong_perspective, LEAST),
                     planned = measured(&m, &glint_auto, budget);
        beyond[0] = fmax(beyond[0], phong);
        beyond[1] = fmax(beyond[1], planned);
        if (phong > LEAST + ROUNDINGS || planned > ROUNDINGS || m.missed) {
            bad++;
            printf("FAIL seed %u: phong %.2f, budget %.2f exceeded by %.2f beyond half a step; %lu missed; format %u, "
                   "%s\n",
                   seed, phong, budget, planned, m.missed, format, described(scene));
        }
        measure_close(&m);
        free(scene);
    }
    printf("%s random scenes %u to %u: phong within %.2f, the budget kept within %.2f, beyond half a step\n",
           bad ? "FAIL" : "ok", first, first + count - 1, beyond[0], beyond[1]);
    return bad != 0;
}
