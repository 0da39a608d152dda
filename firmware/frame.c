/* SPDX-License-Identifier: MIT */
/* A frame from begin to its last band. */
#include "frame.h"

#include "geometry/clip.h"
#include "geometry/project.h"
#include "raster/raster.h"

static int16_t *record(const struct glint_frame *f, uint32_t vertex)
{
    return f->vertices + vertex * f->vertex_stride;
}

/* Notes a triangle to be drawn if it faces the eye and covers a pixel's row and column of the picture. */
static inline void list_triangle(struct glint_frame *f, const int16_t *const p[3], unsigned object, unsigned index,
                                 int clipped)
{
    /* Differences of |p| <= GUARD are at most 2^15: products 2^30, the determinant at most 2^30. Front faces are
     * counter-clockwise with y up, so negative with y down. */
    int32_t x0 = p[0][VERTEX_X], y0 = p[0][VERTEX_Y];
    int32_t x1 = p[1][VERTEX_X] - x0, y1 = p[1][VERTEX_Y] - y0, x2 = p[2][VERTEX_X] - x0, y2 = p[2][VERTEX_Y] - y0;
    if (x1 * y2 - x2 * y1 >= 0) {
        f->stats.culled++;
        return;
    }
    int32_t top = y1 < y2 ? y1 : y2, bottom = y1 > y2 ? y1 : y2, left = x1 < x2 ? x1 : x2, right = x1 > x2 ? x1 : x2;
    int32_t down = y0 + 8 * f->config.height, across = x0 + 8 * f->config.width;
    int32_t first = edges_first(down + (top < 0 ? top : 0)), last = edges_first(down + (bottom > 0 ? bottom : 0));
    int32_t from = edges_first(across + (left < 0 ? left : 0)), to = edges_first(across + (right > 0 ? right : 0));
    if (first >= last || from >= to) {
        f->stats.culled++; /* between pixel centres */
        return;
    }
    first = first < 0 ? 0 : first;
    last = last > f->config.height ? f->config.height : last;
    if (first >= last || to <= 0 || from >= f->config.width) {
        f->stats.rejected++;
        return;
    }
    if (f->triangle_count == f->config.max_triangles) {
        f->stats.dropped++;
        return;
    }
    struct triangle_ref *ref = &f->triangles[f->triangle_count++];
    ref->index = (uint16_t)index;
    ref->object = (uint8_t)object;
    ref->clipped = (uint8_t)clipped;
    ref->first = (uint16_t)first;
    ref->last = (uint16_t)last;
}

/* Stores one piece of a clipped triangle, or not at all. */
static void list_piece(struct glint_frame *f, const struct transform *transform,
                       const struct clip_corner *const corner[3], unsigned object, unsigned source)
{
    if (f->clipped_count == f->config.max_clipped) {
        f->stats.dropped++;
        return;
    }
    struct clipped_triangle *piece = &f->clipped[f->clipped_count];
    const int16_t *place[3];
    piece->source = (uint16_t)source;
    for (int k = 0; k < 3; k++) {
        struct screen_point point = {0, 0, 0};
        if (!project(transform, corner[k]->eye, &point)) {
            f->stats.dropped++; /* the numbers do not reach this far: a plane's cut is kept inside by a sub-pixel */
            return;
        }
        piece->place[k][VERTEX_X] = point.x;
        piece->place[k][VERTEX_Y] = point.y;
        piece->place[k][VERTEX_DEPTH] = (int16_t)point.depth;
        for (int i = 0; i < 3; i++) {
            q30_t w = corner[k]->weight[i];
            piece->weight[k][i] = (uint16_t)(w < 0 ? 0 : (w + (1 << 14)) >> 15);
        }
        place[k] = piece->place[k];
    }
    unsigned before = f->triangle_count;
    list_triangle(f, place, object, f->clipped_count, 1);
    f->clipped_count = (uint16_t)(f->clipped_count + (f->triangle_count - before));
}

static void clip(struct glint_frame *f, const struct transform *transform, const struct scene_vertex *vertices,
                 const struct scene_triangle *triangle, unsigned object, unsigned source)
{
    struct clip_polygon *polygon = &f->raster->begin.polygon[0];
    polygon->count = 3;
    for (int k = 0; k < 3; k++) {
        struct clip_corner *corner = &polygon->corner[k];
        corner->eye = transform_point(transform, vertices[triangle->corner[k]].position);
        for (int i = 0; i < 3; i++)
            corner->weight[i] = i == k ? Q30(1, 1) : 0;
    }
    clip_triangle(transform, polygon, &f->raster->begin.polygon[1]);
    if (polygon->count < 3) {
        f->stats.rejected++;
        return;
    }
    f->stats.clipped++;
    for (int k = 2; k < polygon->count; k++) {
        const struct clip_corner *corner[3] = {&polygon->corner[0], &polygon->corner[k - 1], &polygon->corner[k]};
        list_piece(f, transform, corner, object, source);
    }
}

static int unplaced(const int16_t *const p[3])
{
    return p[0][VERTEX_X] == VERTEX_UNPLACED || p[1][VERTEX_X] == VERTEX_UNPLACED || p[2][VERTEX_X] == VERTEX_UNPLACED;
}

static void list_object(struct glint_frame *f, const struct transform *transform, unsigned index, int all_placed)
{
    const struct object_state *object = &f->objects[index];
    const struct scene_mesh *mesh = object->mesh;
    const struct scene_triangle *triangle = scene_at(f->scene, mesh->triangles);
    const int16_t *records = record(f, object->first_vertex);
    const uint32_t stride = f->vertex_stride, count = mesh->triangle_count;
    for (uint32_t i = 0; i < count; i++, triangle++) {
        const int16_t *const p[3] = {records + triangle->corner[0] * stride, records + triangle->corner[1] * stride,
                                     records + triangle->corner[2] * stride};
        if (!all_placed && unplaced(p))
            clip(f, transform, scene_at(f->scene, mesh->vertices), triangle, index, i);
        else
            list_triangle(f, p, index, i, 0);
    }
}

static void add_object(struct glint_frame *f, const struct view *view, const struct scene_object *source,
                       uint32_t time_ms)
{
    const struct scene_mesh *mesh = scene_meshes(f->scene) + source->mesh;
    struct transform *transform = &f->raster->begin.transform;
    struct matrix to_eye;
    struct pose pose = pose_at(f->scene, source, time_ms);
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
    int all_placed = object_place_vertices(object, f->scene, transform, f->light_count, record(f, f->vertex_count),
                                           f->vertex_stride);
    list_object(f, transform, f->object_count, all_placed);
    f->vertex_count = (uint16_t)(f->vertex_count + mesh->vertex_count);
    f->object_count++;
}

/* Orders the triangles by first row, equal ones as they came: a counting sort. */
static void sort_by_first_row(struct glint_frame *f)
{
    uint16_t *start = f->rows;
    for (unsigned row = 0; row <= f->config.height; row++)
        start[row] = 0;
    for (unsigned i = 0; i < f->triangle_count; i++)
        start[f->triangles[i].first + 1]++; /* first < height */
    for (unsigned row = 0; row < f->config.height; row++)
        start[row + 1] = (uint16_t)(start[row + 1] + start[row]);
    for (unsigned i = 0; i < f->triangle_count; i++)
        f->order[start[f->triangles[i].first]++] = (uint16_t)i;
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
    f->raster->surface_material = NO_MATERIAL;
    f->raster->input.surface = &f->raster->surface;

    struct view *view = &f->raster->begin.view;
    view_setup(view, header, f->config.width, f->config.height);
    if (header->duration_ms)
        time_ms %= header->duration_ms;
    const struct scene_object *object = scene_objects(header);
    for (unsigned i = 0; i < header->object_count; i++)
        add_object(f, view, &object[i], time_ms);
    sort_by_first_row(f);
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
    int16_t *records = record(f, object->first_vertex), *corner = records + triangle->corner[0] * stride;
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
    f->stats.setups++;
    if (!edges_setup(&edges, in->place, r->width, r->height, r->y0, r->y1) ||
        !plane_setup(&setup->plane, in->place, r->width, r->height))
        return;
    const int32_t depth[3] = {(uint16_t)in->place[0][VERTEX_DEPTH], (uint16_t)in->place[1][VERTEX_DEPTH],
                              (uint16_t)in->place[2][VERTEX_DEPTH]};
    plane_linear(&setup->plane, depth, &setup->depth);
    setup->diffuse_lights = setup->specular_lights = setup->quadratic = 0;
    method->setup(setup, in);
    f->stats.pixels[method->id] += method->draw(r, &edges);
    if (ref->first < r->y0)
        return; /* counted with the band above */
    f->stats.drawn[method->id]++;
    f->stats.specular_triangles += setup->specular_lights != 0;
    f->stats.linear_triangles += method->id == GLINT_X && !setup->quadratic;
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
    r->pixels = f->config.band[f->config.band[1] ? f->band_index & 1 : 0];
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
    f->band_index++;
    return 1;
}
