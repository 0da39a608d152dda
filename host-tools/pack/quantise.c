/* SPDX-License-Identifier: MIT */
#include "pack/quantise.h"

#include "import/normals.h"
#include "import/tangents.h"
#include "pack/convert.h"
#include "pack/inflection.h"
#include "scene/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOST_PART 65535u
#define SLOTS     (1u << 17) /* of the welding table: at most half full */

/* All that makes two corners the same vertex. */
struct corner {
    struct scene_vertex vertex;
    int16_t uv[2];
    struct scene_tangent tangent;
};

struct state {
    const struct model_mesh *mesh;
    struct pack_mesh_report *report;
    struct quantise_mesh *out;
    struct scene_mesh grid; /* centre and extent */
    double uv_origin[2];
    bool uvs, tangents;
    struct quantise_part *part;
    uint32_t *slots; /* index + 1 of a vertex of the part; 0: free */
};

/* Centre and extent from the corners that triangles use. */
static const char *choose_grid(struct state *s)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, reach = 0;
    for (size_t i = 0; i < 3 * s->mesh->triangle_count; i++) {
        const double *p = s->mesh->vertices[s->mesh->triangles[i / 3].corner[i % 3]].position;
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], p[k]);
            high[k] = fmax(high[k], p[k]);
        }
    }
    for (int k = 0; k < 3; k++) {
        if (!(fabs(low[k]) < 16383 && fabs(high[k]) < 16383))
            return "reaches further than 16383 units from its origin";
        s->grid.centre[k] = convert_q((low[k] + high[k]) / 2, 16);
        double centre = ldexp(s->grid.centre[k], -16);
        reach = fmax(reach, fmax(high[k] - centre, centre - low[k]));
    }
    /* the furthest coordinate lands on 32767, rounding included */
    s->grid.extent = (int32_t)fmax(ceil(ldexp(reach * 32768 / 32767, 16)), 64);
    return NULL;
}

/* What a material asks of the mesh. */
struct wants {
    bool uvs, clamp[2], tangents;
};

static struct wants find_wants(const struct model *model, const struct model_mesh *mesh, int material)
{
    struct wants wants = {false, {false, false}, false};
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const struct model_material *m =
            &model->materials[material >= 0 ? (uint32_t)material : mesh->triangles[i].material];
        const int maps[2] = {m->texture, m->bump};
        wants.tangents |= m->bump >= 0;
        for (int k = 0; k < 2; k++)
            if (maps[k] >= 0) {
                wants.uvs = true;
                wants.clamp[0] |= model->textures[maps[k]].clamp[0];
                wants.clamp[1] |= model->textures[maps[k]].clamp[1];
            }
    }
    return wants;
}

/* Whole turns of texture coordinates mean nothing where textures repeat, so the range is moved to start within 0..1
 * below the lowest. Returns null, or why textures cannot be drawn. */
static const char *choose_uvs(struct state *s, const struct wants *wants)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    s->uvs = s->mesh->has_uvs && (s->mesh->keeps_uvs || wants->uvs);
    if (wants->uvs && !s->uvs)
        return "has a texture, but no texture coordinates";
    for (size_t i = 0; s->uvs && i < s->mesh->vertex_count; i++)
        for (int k = 0; k < 2; k++) {
            double uv = s->mesh->vertices[i].uv[k];
            low[k] = fmin(low[k], uv);
            high[k] = fmax(high[k], uv);
            s->uvs = s->uvs && isfinite(uv);
        }
    for (int k = 0; s->uvs && k < 2; k++) {
        bool fits = wants->clamp[k] ? low[k] >= -SCENE_MOST_CLAMPED && high[k] <= SCENE_MOST_CLAMPED
                                    : low[k] >= -8 && high[k] < 8 - 1. / 8192;
        s->uv_origin[k] = fits ? 0 : floor(low[k]) + 8;
        s->uvs = fabs(low[k]) < 1e9 && high[k] - s->uv_origin[k] < 8 - 1. / 8192 && (fits || !wants->clamp[k]);
    }
    s->report->uvs_dropped = s->mesh->has_uvs && s->mesh->keeps_uvs && !s->uvs;
    return wants->uvs && !s->uvs
               ? "has texture coordinates that span more than 16, or beyond -6..6 of a clamped texture"
               : NULL;
}

static void quantise_corner(const struct state *s, const struct model_vertex *in, const double normal[3],
                            struct corner *out)
{
    double distance = 0, length = 0, dot = 0;
    memset(out, 0, sizeof *out);
    for (int k = 0; k < 3; k++) {
        double offset = in->position[k] - ldexp(s->grid.centre[k], -16);
        double unit = ldexp(s->grid.extent, -16) / 32768;
        out->vertex.position[k] = (int16_t)floor(offset / unit + 0.5);
        out->vertex.normal[k] = (q14_t)convert_q(normal[k], 14);
        distance = hypot(distance, out->vertex.position[k] * unit - offset);
        length = hypot(length, out->vertex.normal[k]);
        dot += normal[k] * out->vertex.normal[k];
    }
    double tangent[3] = {in->tangent[0], in->tangent[1], in->tangent[2]};
    if (s->tangents)
        tangents_upright(normal, tangent);
    for (int k = 0; s->tangents && k < 3; k++)
        out->tangent.tangent[k] = (q14_t)convert_q(tangent[k], 14);
    out->tangent.sign = s->tangents ? (int16_t)in->sign : 0;
    for (int k = 0; s->uvs && k < 2; k++)
        out->uv[k] = (int16_t)convert_q(in->uv[k] - s->uv_origin[k], 12);
    s->report->position_error = fmax(s->report->position_error, distance);
    s->report->normal_error = fmax(s->report->normal_error, acos(fmin(1, dot / length)) * 180 / M_PI);
}

static bool has_area(const struct corner c[3])
{
    int64_t a[3], b[3]; /* differences below 2^16, their products' below 2^33 */
    for (int k = 0; k < 3; k++) {
        a[k] = c[1].vertex.position[k] - c[0].vertex.position[k];
        b[k] = c[2].vertex.position[k] - c[0].vertex.position[k];
    }
    return a[1] * b[2] != a[2] * b[1] || a[2] * b[0] != a[0] * b[2] || a[0] * b[1] != a[1] * b[0];
}

static void open_part(struct state *s)
{
    s->out->parts = realloc(s->out->parts, (s->out->part_count + 1) * sizeof *s->out->parts);
    if (!s->out->parts)
        abort();
    s->part = &s->out->parts[s->out->part_count++];
    *s->part = (struct quantise_part){.head = s->grid};
    s->part->vertices = model_alloc(MOST_PART * sizeof *s->part->vertices);
    s->part->triangles = model_alloc(MOST_PART * sizeof *s->part->triangles);
    if (s->uvs)
        s->part->uvs = model_alloc(MOST_PART * sizeof *s->part->uvs);
    if (s->tangents)
        s->part->tangents = model_alloc(MOST_PART * sizeof *s->part->tangents);
    memset(s->slots, 0, SLOTS * sizeof *s->slots);
}

/* The index in the part of a vertex equal to the corner, there already or added. FNV-1a over the corner's bytes. */
static uint16_t weld(struct state *s, const struct corner *c)
{
    struct quantise_part *part = s->part;
    uint32_t hash = 2166136261u;
    for (size_t i = 0; i < sizeof *c; i++)
        hash = (hash ^ ((const uint8_t *)c)[i]) * 16777619u;
    for (hash ^= hash >> 15;; hash++) {
        uint32_t *slot = &s->slots[hash % SLOTS], index = *slot - 1;
        if (*slot == 0) {
            index = part->head.vertex_count++;
            part->vertices[index] = c->vertex;
            if (part->uvs)
                memcpy(part->uvs[index], c->uv, sizeof c->uv);
            if (part->tangents)
                part->tangents[index] = c->tangent;
            *slot = index + 1;
            return (uint16_t)index;
        }
        if (!memcmp(&part->vertices[index], &c->vertex, sizeof c->vertex) &&
            (!part->uvs || !memcmp(part->uvs[index], c->uv, sizeof c->uv)) &&
            (!part->tangents || !memcmp(&part->tangents[index], &c->tangent, sizeof c->tangent)))
            return (uint16_t)index;
    }
}

static uint16_t bend(const double a[3], const double b[3])
{
    double k = (1 - vec_dot(a, b)) / 2;
    return (uint16_t)fmin(fmax(floor(k * 65536 + 0.5), 0), 65535);
}

static void add_triangle(struct state *s, const struct model_triangle *in, uint32_t material, bool flat)
{
    double normal[3][3], face[3];
    struct corner corner[3];
    bool has_face = normals_face(s->mesh, in, face);
    for (int k = 0; has_face && k < 3; k++) {
        const struct model_vertex *v = &s->mesh->vertices[in->corner[k]];
        memcpy(normal[k], flat ? face : v->normal, sizeof face);
        if (!vec_normalise(normal[k])) {
            memcpy(normal[k], face, sizeof face);
            s->report->repaired++;
        }
        quantise_corner(s, v, normal[k], &corner[k]);
    }
    if (!has_face || !has_area(corner)) {
        s->report->degenerate++;
        return;
    }
    if (!s->part || s->part->head.vertex_count + 3 > MOST_PART || s->part->head.triangle_count == MOST_PART)
        open_part(s);
    struct scene_triangle *out = &s->part->triangles[s->part->head.triangle_count++];
    for (int k = 0; k < 3; k++) {
        out->corner[k] = weld(s, &corner[k]);
        out->bend[k] = bend(normal[k], normal[(k + 1) % 3]);
    }
    out->material = (uint16_t)material;
}

/* Of what was rounded; one unit more than needed, for scene_check()'s own rounding. */
static void set_radius(struct quantise_part *part)
{
    double furthest = 0;
    for (uint32_t i = 0; i < part->head.vertex_count; i++) {
        const int16_t *p = part->vertices[i].position;
        furthest = fmax(furthest, hypot(hypot(p[0], p[1]), p[2]));
    }
    part->head.radius = (int32_t)ceil((furthest + 1) * part->head.extent / 32768) + 1;
}

/* What tangents may change of a mesh. */
static void copy_mesh(const struct model_mesh *in, struct model_mesh *out)
{
    const size_t vertices = in->vertex_count * sizeof *out->vertices;
    const size_t triangles = in->triangle_count * sizeof *out->triangles;
    *out = *in;
    out->vertices = memcpy(model_alloc(vertices), in->vertices, vertices);
    out->triangles = memcpy(model_alloc(triangles), in->triangles, triangles);
    out->vertex_room = in->vertex_count;
    out->triangle_room = in->triangle_count;
}

const char *quantise_mesh(const struct model *model, const struct model_mesh *mesh, int material,
                          struct quantise_mesh *out, struct pack_mesh_report *report)
{
    struct state s = {.mesh = mesh, .report = report, .out = out};
    *out = (struct quantise_mesh){0};
    report->vertices_in = mesh->vertex_count;
    report->triangles_in = mesh->triangle_count;
    report->normals = mesh->normals;
    const char *reason = mesh->triangle_count == 0 ? "has no triangles" : choose_grid(&s);
    if (reason)
        return reason;
    const struct wants wants = find_wants(model, mesh, material);
    reason = choose_uvs(&s, &wants);
    if (reason)
        return reason;
    struct model_mesh framed = {0};
    if (wants.tangents) {
        copy_mesh(mesh, &framed);
        tangents_make(&framed);
        s.mesh = mesh = &framed;
        s.tangents = true;
    }
    s.slots = model_alloc(SLOTS * sizeof *s.slots);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        uint32_t m = material >= 0 ? (uint32_t)material : mesh->triangles[i].material;
        add_triangle(&s, &mesh->triangles[i], m, model->materials[m].flat);
    }
    free(s.slots);
    free(framed.vertices);
    free(framed.triangles);
    report->parts = out->part_count;
    for (unsigned i = 0; i < out->part_count; i++) {
        struct quantise_part *part = &out->parts[i];
        set_radius(part);
        inflection_mark(part->vertices, part->head.vertex_count, part->triangles, part->head.triangle_count);
        report->vertices_out += out->parts[i].head.vertex_count;
        report->triangles_out += out->parts[i].head.triangle_count;
    }
    return out->part_count ? NULL : "has no triangle with an area";
}

void quantise_free(struct quantise_mesh *mesh)
{
    for (unsigned i = 0; i < mesh->part_count; i++) {
        free(mesh->parts[i].vertices);
        free(mesh->parts[i].triangles);
        free(mesh->parts[i].uvs);
        free(mesh->parts[i].tangents);
    }
    free(mesh->parts);
    *mesh = (struct quantise_mesh){0};
}
