/* SPDX-License-Identifier: MIT */
#include "pack/summary.h"

#include "glint.h"
#include "pack/report.h"
#include "pack/uses.h"

#include <jansson.h>
#include <math.h>

#define Q(value, bits) ldexp((value), -(bits))

static const char *const motion_names[] = {"still", "spin", "keys"};
static const char *const light_names[] = {"directional", "point"};
static const char *const camera_names[] = {"perspective", "orthographic"};
static const char *const viewer_names[] = {"infinite", "local"};

static const char *const texture_names[TEXTURE_FORMATS] = {"rgb565", "palette8", "bump8"};
static const char *const wrap_names[] = {"repeat", "clamp"};

static const char *filter_name(const struct scene_texture *t)
{
    return t->flags & TEXTURE_BILINEAR ? "bilinear" : "nearest";
}

static void print_camera(FILE *out, const struct scene_header *s)
{
    const struct scene_camera *c = &s->camera;
    fprintf(out, "camera   %s, %ux%u, focal %g, near %g, far %g, at (%g, %g, %g), viewer %s\n", camera_names[c->kind],
            c->reference_width, c->reference_height, Q(c->focal, 16), Q(c->near_plane, 16), Q(c->far_plane, 16),
            Q(c->position[0], 16), Q(c->position[1], 16), Q(c->position[2], 16), viewer_names[c->viewer]);
    fprintf(out, "ambient  (%.3g, %.3g, %.3g), background (%.3g, %.3g, %.3g)\n", Q(s->ambient[0], 15),
            Q(s->ambient[1], 15), Q(s->ambient[2], 15), Q(s->background[0], 15), Q(s->background[1], 15),
            Q(s->background[2], 15));
}

static void print_motion(FILE *out, const struct scene_motion *m)
{
    if (m->kind == MOTION_SPIN)
        fprintf(out, ", spins %g turns/s about (%.3g, %.3g, %.3g)", Q(m->rate, 16), Q(m->axis[0], 30),
                Q(m->axis[1], 30), Q(m->axis[2], 30));
    else if (m->kind == MOTION_KEYS)
        fprintf(out, ", %u keys", m->key_count);
    fputc('\n', out);
}

void summary_print(FILE *out, const struct scene_header *s)
{
    struct report_totals t = report_count(s);
    fprintf(out, "scene    version %u, %u bytes, CRC-32 %08x, %g s; %lu vertices, %lu triangles a frame\n", s->version,
            (unsigned)s->length, (unsigned)s->crc, s->duration_ms / 1000., t.vertices, t.triangles);
    print_camera(out, s);
    for (unsigned i = 0; i < s->mesh_count; i++) {
        const struct scene_mesh *m = &scene_meshes(s)[i];
        fprintf(out, "mesh     %u: %u vertices, %u triangles, radius %.4g, grid %.3g units, bend %.1f degrees%s\n", i,
                (unsigned)m->vertex_count, (unsigned)m->triangle_count, Q(m->radius, 16), Q(m->extent, 31),
                report_bend_degrees(s, m), m->uvs ? ", texture coordinates" : "");
    }
    for (unsigned i = 0; i < s->material_count; i++) {
        const struct scene_material *m = &scene_materials(s)[i];
        fprintf(
            out,
            "material %u: diffuse (%.3g, %.3g, %.3g), specular (%.3g, %.3g, %.3g), ka %.3g, kd %.3g, ks %.3g, n %u%s",
            i, Q(m->diffuse[0], 15), Q(m->diffuse[1], 15), Q(m->diffuse[2], 15), Q(m->specular[0], 15),
            Q(m->specular[1], 15), Q(m->specular[2], 15), Q(m->ka, 15), Q(m->kd, 15), Q(m->ks, 15), m->shininess,
            m->flags & MATERIAL_FLAT ? ", flat" : "");
        fprintf(out, m->texture == SCENE_NO_TEXTURE ? "\n" : ", texture %u\n", m->texture);
    }
    for (unsigned i = 0; i < s->texture_count; i++) {
        const struct scene_texture *t = &scene_textures(s)[i];
        fprintf(out, "texture  %u: %ux%u %s, %s, %s in u, %s in v", i, 1u << t->log2_width, 1u << t->log2_height,
                texture_names[t->format], filter_name(t), wrap_names[(t->flags & TEXTURE_CLAMP_U) != 0],
                wrap_names[(t->flags & TEXTURE_CLAMP_V) != 0]);
        if (t->colours)
            fprintf(out, ", %u colours", t->colours);
        fputc('\n', out);
    }
    for (unsigned i = 0; i < s->light_count; i++) {
        const struct scene_light *l = &scene_lights(s)[i];
        const int bits = l->kind == LIGHT_POINT ? 16 : 30;
        fprintf(out, "light    %u: %s (%.4g, %.4g, %.4g), colour (%.3g, %.3g, %.3g)", i, light_names[l->kind],
                Q(l->vector[0], bits), Q(l->vector[1], bits), Q(l->vector[2], bits), Q(l->colour[0], 15),
                Q(l->colour[1], 15), Q(l->colour[2], 15));
        print_motion(out, &l->motion);
    }
    for (unsigned i = 0; i < s->object_count; i++) {
        const struct scene_object *o = &scene_objects(s)[i];
        fprintf(out, "object   %u: mesh %u at (%.4g, %.4g, %.4g), scale %.4g", i, o->mesh, Q(o->position[0], 16),
                Q(o->position[1], 16), Q(o->position[2], 16), Q(o->scale, 16));
        print_motion(out, &o->motion);
    }
    report_print_effects(out, s);
    report_print_bytes(out, s);
}

static json_t *json_vector(const int32_t v[3], int bits)
{
    return json_pack("[f, f, f]", Q(v[0], bits), Q(v[1], bits), Q(v[2], bits));
}

static json_t *json_colour(const uint16_t c[3])
{
    return json_pack("[f, f, f]", Q(c[0], 15), Q(c[1], 15), Q(c[2], 15));
}

static json_t *json_motion(const struct scene_motion *m)
{
    if (m->kind == MOTION_SPIN)
        return json_pack("{s:s, s:o, s:f}", "kind", motion_names[m->kind], "axis", json_vector(m->axis, 30), "rate",
                         Q(m->rate, 16));
    return json_pack("{s:s, s:i}", "kind", motion_names[m->kind], "keys", (int)m->key_count);
}

static json_t *json_meshes(const struct scene_header *s)
{
    json_t *array = json_array();
    for (unsigned i = 0; i < s->mesh_count; i++) {
        const struct scene_mesh *m = &scene_meshes(s)[i];
        json_array_append_new(array,
                              json_pack("{s:i, s:i, s:o, s:f, s:f, s:f, s:b}", "vertices", (int)m->vertex_count,
                                        "triangles", (int)m->triangle_count, "centre", json_vector(m->centre, 16),
                                        "radius", Q(m->radius, 16), "grid", Q(m->extent, 31), "bend_degrees",
                                        report_bend_degrees(s, m), "uvs", (int)(m->uvs != 0)));
    }
    return array;
}

static json_t *json_materials(const struct scene_header *s)
{
    json_t *array = json_array();
    for (unsigned i = 0; i < s->material_count; i++) {
        const struct scene_material *m = &scene_materials(s)[i];
        json_array_append_new(array, json_pack("{s:o, s:o, s:f, s:f, s:f, s:i, s:b}", "diffuse",
                                               json_colour(m->diffuse), "specular", json_colour(m->specular), "ka",
                                               Q(m->ka, 15), "kd", Q(m->kd, 15), "ks", Q(m->ks, 15), "shininess",
                                               (int)m->shininess, "flat", (int)(m->flags & MATERIAL_FLAT)));
        if (m->texture != SCENE_NO_TEXTURE)
            json_object_set_new(json_array_get(array, i), "texture", json_integer(m->texture));
    }
    return array;
}

static json_t *json_textures(const struct scene_header *s)
{
    json_t *array = json_array();
    for (unsigned i = 0; i < s->texture_count; i++) {
        const struct scene_texture *t = &scene_textures(s)[i];
        json_array_append_new(array,
                              json_pack("{s:[i, i], s:s, s:s, s:[s, s], s:i}", "size", 1 << t->log2_width,
                                        1 << t->log2_height, "format", texture_names[t->format], "filter",
                                        filter_name(t), "wrap", wrap_names[(t->flags & TEXTURE_CLAMP_U) != 0],
                                        wrap_names[(t->flags & TEXTURE_CLAMP_V) != 0], "colours", (int)t->colours));
    }
    return array;
}

static json_t *json_lights(const struct scene_header *s)
{
    json_t *array = json_array();
    for (unsigned i = 0; i < s->light_count; i++) {
        const struct scene_light *l = &scene_lights(s)[i];
        json_array_append_new(array, json_pack("{s:s, s:o, s:o, s:o}", "type", light_names[l->kind],
                                               l->kind == LIGHT_POINT ? "position" : "towards",
                                               json_vector(l->vector, l->kind == LIGHT_POINT ? 16 : 30), "colour",
                                               json_colour(l->colour), "motion", json_motion(&l->motion)));
    }
    return array;
}

static json_t *json_objects(const struct scene_header *s)
{
    json_t *array = json_array();
    for (unsigned i = 0; i < s->object_count; i++) {
        const struct scene_object *o = &scene_objects(s)[i];
        json_array_append_new(array, json_pack("{s:i, s:[f, f, f, f], s:o, s:f, s:o}", "mesh", (int)o->mesh, "rotation",
                                               Q(o->rotation[0], 30), Q(o->rotation[1], 30), Q(o->rotation[2], 30),
                                               Q(o->rotation[3], 30), "position", json_vector(o->position, 16), "scale",
                                               Q(o->scale, 16), "motion", json_motion(&o->motion)));
    }
    return array;
}

static json_t *json_camera(const struct scene_camera *c)
{
    return json_pack("{s:s, s:s, s:[i, i], s:f, s:f, s:f, s:o, s:[f, f, f, f]}", "type", camera_names[c->kind],
                     "viewer", viewer_names[c->viewer], "size", (int)c->reference_width, (int)c->reference_height,
                     "focal", Q(c->focal, 16), "near", Q(c->near_plane, 16), "far", Q(c->far_plane, 16), "position",
                     json_vector(c->position, 16), "rotation", Q(c->rotation[0], 30), Q(c->rotation[1], 30),
                     Q(c->rotation[2], 30), Q(c->rotation[3], 30));
}

static json_t *json_effects(const struct scene_header *s)
{
    json_t *array = json_array();
    for (const struct uses_name *n = uses_names; n->name; n++)
        if (s->effects & n->bit)
            json_array_append_new(array, json_string(n->name));
    return array;
}

static json_t *json_methods(const struct scene_header *s)
{
    json_t *array = json_array();
    for (unsigned i = 0; i < glint_choice_count; i++)
        if (uses_method(s->effects, glint_choices[i].name))
            json_array_append_new(array, json_string(glint_choices[i].name));
    return array;
}

void summary_json(FILE *out, const struct scene_header *s)
{
    struct report_totals t = report_count(s);
    json_t *bytes = json_pack("{s:i}", "total", (int)s->length);
    for (int i = 0; i < REPORT_PARTS; i++)
        json_object_set_new(bytes, report_parts[i], json_integer((json_int_t)t.bytes[i]));
    json_t *root =
        json_pack("{s:i, s:f, s:i, s:i, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "version", (int)s->version,
                  "duration", s->duration_ms / 1000., "frame_vertices", (int)t.vertices, "frame_triangles",
                  (int)t.triangles, "ambient", json_colour(s->ambient), "background", json_colour(s->background),
                  "camera", json_camera(&s->camera), "meshes", json_meshes(s), "materials", json_materials(s), "lights",
                  json_lights(s), "objects", json_objects(s), "bytes", bytes);
    json_object_set_new(root, "textures", json_textures(s));
    json_object_set_new(root, "effects", json_effects(s));
    json_object_set_new(root, "methods", json_methods(s));
    json_dumpf(root, out, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
    fputc('\n', out);
    json_decref(root);
}
