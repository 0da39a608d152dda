/* SPDX-License-Identifier: MIT */
/* A frame from begin to its last band. */
#include "list.h"

#include "raster/raster.h"

/* turn: the user's, or null. */
static void add_object(struct glint_frame *f, const struct view *view, const struct scene_object *source,
                       const struct rotation *turn, uint32_t time_ms)
{
    const struct scene_mesh *mesh = scene_meshes(f->scene) + source->mesh;
    struct transform *transform = &f->raster->begin.transform;
    struct matrix to_eye;
    struct pose pose = pose_at(f->scene, source, time_ms);
    if (turn)
        pose.rotation = rotation_product(turn, &pose.rotation);
    f->stats.triangles += mesh->triangle_count;
    if (!transform_setup(transform, view, mesh, &pose, &to_eye)) {
        f->stats.rejected += mesh->triangle_count;
        return;
    }
    if (f->object_count == f->config.max_objects ||
        mesh->vertex_count > (uint32_t)(f->config.max_vertices - f->vertex_count)) {
        f->stats.dropped += mesh->triangle_count;
        return;
    }
    struct object_state *object = &f->objects[f->object_count];
    object->mesh = mesh;
    object->first_vertex = f->vertex_count;
    object_light_setup(object, f->scene, view, &pose, &to_eye, time_ms);
    int all_placed = object_place_vertices(object, f->scene, transform, f->light_count, list_record(f, f->vertex_count),
                                           f->vertex_stride);
    if (f->config.method->object)
        f->config.method->object(object, f->scene, list_record(f, f->vertex_count), f->vertex_stride, &f->stats);
    list_object(f, transform, f->object_count, all_placed);
    f->vertex_count = (uint16_t)(f->vertex_count + mesh->vertex_count);
    f->object_count++;
}

void glint_turn(struct glint_frame *f, uint16_t yaw, uint16_t pitch)
{
    f->yaw = yaw;
    f->pitch = pitch;
}

int glint_frame_begin(struct glint_frame *f, const void *scene, uint32_t time_ms)
{
    const struct scene_header *header = scene;
    if (!f || !scene)
        return GLINT_E_ARGUMENT;
    if (header->magic != SCENE_MAGIC || header->version != SCENE_VERSION || header->light_count > f->config.max_lights)
        return GLINT_E_SCENE;
    f->scene = header;
    f->light_count = (uint8_t)header->light_count;
    f->vertex_stride = (uint16_t)(VERTEX_LIGHTS + 2 * f->light_count + f->config.method->vertex_words);
    f->vertex_count = f->triangle_count = f->clipped_count = f->object_count = 0;
    f->active = f->queued = f->next_row = 0;
    f->band_index = 0;
    f->stats = (struct glint_stats){0};
    f->raster->surface_material = RASTER_NO_MATERIAL;
    f->raster->input.surface = &f->raster->surface;
    f->raster->surface.form = f->config.power;
    f->raster->input.sampled = f->config.power || header->camera.viewer != VIEWER_INFINITE;
    for (unsigned i = 0; i < header->light_count; i++)
        f->raster->input.sampled |= scene_lights(header)[i].kind == LIGHT_POINT;
    f->raster->input.divides = header->camera.kind == CAMERA_PERSPECTIVE;

    struct view *view = &f->raster->begin.view;
    view_setup(view, header, f->config.width, f->config.height);
    if (header->duration_ms)
        time_ms %= header->duration_ms;
    const int turned = (f->yaw | f->pitch) != 0;
    struct rotation turn = {{0}};
    if (turned)
        turn = rotation_turn(&view->matrix, f->yaw, f->pitch);
    const struct scene_object *object = scene_objects(header);
    for (unsigned i = 0; i < header->object_count; i++)
        add_object(f, view, &object[i], turned ? &turn : 0, time_ms);
    list_sort(f);
    return 0;
}

/* Turns a listed triangle into the rasteriser's input: corners 0, 2, 1, which is clockwise with y down. */
static void gather(struct glint_frame *f, const struct triangle_ref *ref)
{
    struct raster *r = f->raster;
    struct shade_input *in = &r->input;
    const struct object_state *object = &f->objects[ref->object];
    const struct clipped_triangle *piece = ref->clipped ? &f->clipped[ref->index] : 0;
    const struct scene_triangle *triangle = scene_at(f->scene, object->mesh->triangles);
    triangle += piece ? piece->source : ref->index;
    in->object = object;
    in->triangle = triangle;
    in->vertices = scene_at(f->scene, object->mesh->vertices);
    in->weight = 0;
    /* Once a triangle and worth unrolling. */
    const uint32_t stride = f->vertex_stride;
    int16_t *records = list_record(f, object->first_vertex), *corner = records + triangle->corner[0] * stride;
    in->place[0] = corner;
    in->lights[0] = corner + VERTEX_LIGHTS;
    corner = records + triangle->corner[2] * stride;
    in->place[1] = corner;
    in->lights[1] = corner + VERTEX_LIGHTS;
    corner = records + triangle->corner[1] * stride;
    in->place[2] = corner;
    in->lights[2] = corner + VERTEX_LIGHTS;
    if (piece) {
        for (int k = 0; k < 3; k++) {
            in->place[k] = piece->place[SHADE_TURN(k)];
            for (int i = 0; i < 3; i++)
                r->weight[k][i] = piece->weight[SHADE_TURN(k)][SHADE_TURN(i)];
        }
        in->weight = (const uint16_t(*)[3])r->weight;
    }
    if (r->surface_material != triangle->material) {
        r->surface_material = triangle->material;
        surface_setup(&r->surface, f->scene, scene_materials(f->scene) + triangle->material, &r->palette);
        raster_find_table(r);
        in->tabled = r->surface_table != 0;
    }
}

static void draw_triangle(struct glint_frame *f, const struct triangle_ref *ref)
{
    struct raster *r = f->raster;
    const struct glint_method *method = f->config.method;
    struct shade_input *in = &r->input;
    struct shade_setup *setup = &r->setup;
    struct edges edges;
    gather(f, ref);
    if (method->choose)
        method = method->choose(in);
    f->stats.setups++;
    if (!edges_setup(&edges, in->place, r->width, r->height, r->y0, r->y1) ||
        !plane_setup(&setup->plane, in->place, r->width, r->height))
        return;
    const int32_t depth[3] = {(uint16_t)in->place[0][VERTEX_DEPTH], (uint16_t)in->place[1][VERTEX_DEPTH],
                              (uint16_t)in->place[2][VERTEX_DEPTH]};
    plane_linear(&setup->plane, depth, &setup->depth);
    setup->found[0] = setup->found[1] = 0;
    method->setup(setup, in);
    f->stats.pixels[method->id] += method->draw(r, &edges);
    if (ref->first < r->y0)
        return; /* counted with the band above */
    f->stats.drawn[method->id]++;
    f->stats.specular_triangles += setup->specular_lights != 0;
    f->stats.linear_triangles +=
        (method->id == GLINT_X || method->id == GLINT_SIX) && !setup->quadratic && !setup->perspective;
}

int glint_frame_next_band(struct glint_frame *f, struct glint_band *band)
{
    if (!f || !band || !f->scene)
        return GLINT_E_ARGUMENT;
    if (f->next_row == f->config.height)
        return 0;
    struct raster *r = f->raster;
    unsigned rows = f->config.height - f->next_row;
    if (rows > f->config.band_rows)
        rows = f->config.band_rows;
    r->y0 = f->next_row;
    r->y1 = (uint16_t)(f->next_row + rows);
    r->pixels = f->config.band[f->config.band[1] ? f->band_index : 0];
    r->input.no_plan = (f->config.flags & GLINT_NO_PLAN) != 0;
    raster_clear(r, f->scene);

    /* Those that reach down from the band above, in order, then those that begin here; kept if they go on. */
    unsigned kept = 0, at = 0, from = f->active, to = f->triangle_count;
    while (at < from || f->queued < to) {
        unsigned index;
        if (at < from) {
            index = f->order[at++];
        } else {
            if (f->triangles[f->order[f->queued]].first >= r->y1)
                break;
            index = f->order[f->queued++];
        }
        const struct triangle_ref *ref = &f->triangles[index];
        draw_triangle(f, ref);
        if (ref->last > r->y1)
            f->order[kept++] = (uint16_t)index; /* kept <= at + queued: never ahead of what is read */
    }
    f->active = (uint16_t)kept;

    band->pixels = r->pixels;
    band->y = r->y0;
    band->rows = (uint16_t)rows;
    band->stride = r->stride;
    f->next_row = r->y1;
    f->band_index ^= 1;
    return 1;
}
