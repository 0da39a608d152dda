/* SPDX-License-Identifier: MIT */
#include "drawn.h"
#include "glint/renderer.h"
#include "pack/pack.h"
#include "picture.h"

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

#include "reference/decode.h"
static void explain(struct drawn_scene *d, struct budget_picture *ids, struct budget_view v, uint32_t number,
                    unsigned w, unsigned h, double px, double py)
{
    static struct decode_vertex vs[65536];
    struct decode_view view;
    unsigned o = 0;
    while (o + 1 < d->scene->object_count && d->first[o + 1] <= number)
        o++;
    const struct scene_object *ob = scene_objects(d->scene) + o;
    const struct scene_mesh *mesh = scene_meshes(d->scene) + o;
    const struct scene_triangle *t =
        (const struct scene_triangle *)scene_at(d->scene, mesh->triangles) + (number - d->first[o]);
    decode_view(d->scene, v.time_ms, w, h, &view);
    decode_vertices(d->scene, ob, v.time_ms, vs);
    decode_turn(d->scene, ob, v.time_ms, v.yaw, v.pitch, vs);
    const struct object_state *os = NULL;
    for (unsigned i = 0; i < ids->frame.object_count; i++)
        if (ids->frame.objects[i].mesh == mesh)
            os = &ids->frame.objects[i];
    printf("   pixel %.1f %.1f; bend %u %u %u\n", 16 * (px + .5 - w / 2.), 16 * (py + .5 - h / 2.), t->bend[0],
           t->bend[1], t->bend[2]);
    for (int k = 0; k < 3; k++) {
        struct decode_vertex *q = &vs[t->corner[k]];
        double s = view.perspective ? view.focal / -q->position[2] : view.focal;
        const int16_t *r = ids->frame.vertices + (os->first_vertex + t->corner[k]) * ids->frame.vertex_stride;
        printf("   corner %d: %.4f %.4f z %.5f; integer %d %d %u normal %.4f %.4f %.4f\n", k, 16 * s * q->position[0],
               -16 * s * q->position[1], q->position[2], r[0], r[1], (uint16_t)r[2], q->normal[0], q->normal[1],
               q->normal[2]);
    }
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
        static int16_t placed[400000][2];
        unsigned vbase = 0;
        for (unsigned o = 0; o < d.scene->object_count; o++) {
            const struct scene_mesh *mesh = scene_meshes(d.scene) + o;
            for (unsigned i = 0; i < ids.frame.object_count; i++)
                if (ids.frame.objects[i].mesh == mesh)
                    for (unsigned k = 0; k < mesh->vertex_count; k++) {
                        const int16_t *rec =
                            ids.frame.vertices + (ids.frame.objects[i].first_vertex + k) * ids.frame.vertex_stride;
                        placed[vbase + k][0] = rec[0], placed[vbase + k][1] = rec[1];
                    }
            vbase += mesh->vertex_count;
        }
        struct reference_image truth;
        struct reference_options o = {.time_ms = view.time_ms,
                                      .yaw = view.yaw,
                                      .pitch = view.pitch,
                                      .grey = format == GLINT_GREY8,
                                      .drawn = drawn,
                                      .placed = (const int16_t(*)[2])placed};
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
                           255 * truth.value[at * truth.channels]),
                        explain(&d, &ids, view, drawn[at], w, h, at % w, at / w);
            }
        }
        reference_free(&truth);
    }
    printf("%-32s %ld pixels, %ld missed;", path, total, missed);
    for (int m = 0; m < n; m++)
        printf(" %s %.2f (%ld)", argv[4 + m], worst[m], over[m]);
    puts("");
}
