/* SPDX-License-Identifier: MIT */
#include "pack/report.h"

#include "pack/uses.h"

#include <math.h>
#include <stdlib.h>

#define Q(value, bits) ldexp((value), -(bits))

static const char *const normals_names[] = {"given", "smoothed", "flat"};

const char *const report_parts[REPORT_PARTS] = {"header",    "meshes", "vertices", "triangles", "uvs",  "tangents",
                                                "materials", "powers", "lights",   "objects",   "keys", "textures"};

struct report_totals report_count(const struct scene_header *s)
{
    struct report_totals t = {.bytes = {[REPORT_HEADER] = sizeof *s,
                                        [REPORT_MESHES] = s->mesh_count * sizeof(struct scene_mesh),
                                        [REPORT_MATERIALS] = s->material_count * sizeof(struct scene_material),
                                        [REPORT_POWERS] = s->power_count * sizeof(struct fx_power),
                                        [REPORT_LIGHTS] = s->light_count * sizeof(struct scene_light),
                                        [REPORT_OBJECTS] = s->object_count * sizeof(struct scene_object),
                                        [REPORT_KEYS] = s->key_count * sizeof(struct scene_key)}};
    for (unsigned i = 0; i < s->mesh_count; i++) {
        const struct scene_mesh *m = &scene_meshes(s)[i];
        t.bytes[REPORT_VERTICES] += m->vertex_count * sizeof(struct scene_vertex);
        t.bytes[REPORT_TRIANGLES] += m->triangle_count * sizeof(struct scene_triangle);
        t.bytes[REPORT_UVS] += m->uvs ? m->vertex_count * 2 * sizeof(int16_t) : 0;
        t.bytes[REPORT_TANGENTS] += m->tangents ? m->vertex_count * sizeof(struct scene_tangent) : 0;
    }
    for (unsigned i = 0; i < s->texture_count; i++) {
        const struct scene_texture *x = &scene_textures(s)[i];
        const size_t texels = (size_t)1 << (x->log2_width + x->log2_height);
        t.bytes[REPORT_TEXTURES] +=
            sizeof *x + texels * (x->format == TEXTURE_PALETTE8 ? 1 : 2) + x->colours * sizeof(uint32_t);
    }
    for (unsigned i = 0; i < s->object_count; i++) {
        const struct scene_mesh *m = &scene_meshes(s)[scene_objects(s)[i].mesh];
        t.vertices += m->vertex_count;
        t.triangles += m->triangle_count;
    }
    return t;
}

double report_bend_degrees(const struct scene_header *scene, const struct scene_mesh *mesh)
{
    const struct scene_triangle *triangles = scene_at(scene, mesh->triangles);
    unsigned most = 0;
    for (uint32_t i = 0; i < 3 * mesh->triangle_count; i++)
        most = triangles[i / 3].bend[i % 3] > most ? triangles[i / 3].bend[i % 3] : most;
    return acos(1 - 2 * Q(most, 16)) * 180 / M_PI;
}

void report_print_bytes(FILE *out, const struct scene_header *s)
{
    struct report_totals t = report_count(s);
    fprintf(out, "bytes    %u:", (unsigned)s->length);
    for (int i = 0; i < REPORT_PARTS; i++)
        if (t.bytes[i])
            fprintf(out, " %s %zu", report_parts[i], t.bytes[i]);
    fputc('\n', out);
}

static void print_texture(FILE *out, const struct pack_texture_report *t)
{
    fprintf(out, "texture  \"%s\": %ux%u", t->name, t->size[0], t->size[1]);
    if (t->read[0] != t->size[0] || t->read[1] != t->size[1])
        fprintf(out, ", resampled from %ux%u", t->read[0], t->read[1]);
    if (t->colours_read)
        fprintf(out, ", %u colours", t->colours_read);
    if (t->colours_read > 256)
        fputs(" brought down to 256", out);
    fprintf(out, ", %s off by %.2f/255 rms\n", t->normals ? "normals" : "colours", t->error);
}

void report_print_effects(FILE *out, const struct scene_header *s)
{
    fputs("effects ", out);
    uses_print(out, s->effects);
    fputs("\nmethods ", out);
    uses_print_methods(out, s->effects);
    fputc('\n', out);
}

void report_print(FILE *out, const struct pack_result *result)
{
    const struct scene_header *s = result->scene;
    for (size_t i = 0; result->report && i < result->report->mesh_count; i++) {
        const struct pack_mesh_report *m = &result->report->meshes[i];
        fprintf(out, "mesh     \"%s\": %zu vertices (%zu read), %zu triangles (%zu read, %zu without area dropped)\n",
                m->name, m->vertices_out, m->vertices_in, m->triangles_out, m->triangles_in, m->degenerate);
        fprintf(out, "         normals %s, error at most %.4f degrees; position error at most %.2g units\n",
                normals_names[m->normals], m->normal_error, m->position_error);
        if (m->repaired)
            fprintf(out, "         %zu corners without a normal took their face's\n", m->repaired);
        if (m->uvs_dropped)
            fputs("         texture coordinates dropped: they span more than 16\n", out);
        if (m->parts > 1)
            fprintf(out, "         split into %u meshes of at most 65535 vertices and triangles\n", m->parts);
    }
    for (size_t i = 0; result->report && i < result->report->texture_count; i++)
        print_texture(out, &result->report->textures[i]);
    if (result->report && result->report->unused_meshes)
        fprintf(out, "unused   %u meshes that no object shows were left out\n", result->report->unused_meshes);
    fprintf(out, "scene    %u meshes, %u materials, %u power tables, %u lights, %u objects, %u keys", s->mesh_count,
            s->material_count, s->power_count, s->light_count, s->object_count, s->key_count);
    fprintf(out, s->texture_count ? ", %u textures\n" : "\n", s->texture_count);
    report_print_effects(out, s);
    report_print_bytes(out, s);
}
