/* SPDX-License-Identifier: MIT */
/* A frame from begin to its last band. */
#include "list.h"

#include "raster/effects.h"
#include "raster/fogged.h"

/* turn: the user's, or null. */
FX_COLD static void add_object(struct glint_frame *f, const struct view *view, const struct scene_object *source,
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
        mesh->vertex_count > fx_u32(f->config.max_vertices - f->vertex_count)) {
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
    f->vertex_count = fx_u16(f->vertex_count + mesh->vertex_count);
    f->object_count++;
}

/* What a raster keeps while a picture is drawn. */
static void begin_raster(struct raster *r, const struct glint_frame *f)
{
    const struct scene_header *scene = f->scene;
    r->surface_material = RASTER_NO_MATERIAL;
    r->input.plan = (struct shade_plan){0};
    r->surface.form = f->config.power;
    r->budget = f->config.budget ? f->config.budget : PLAN_BUDGET;
    if (USES(USES_FOG))
        fogged_begin(r, scene, f->config.method->choose && !f->config.method->object);
    r->input.surface = &r->surface;
    r->gloss = r->sum[0];
    r->input.texture = f->config.texture;
    r->input.colours = 0;
    r->input.sampled = f->config.power || scene->camera.viewer != VIEWER_INFINITE;
    for (unsigned i = 0; i < scene->light_count; i++)
        r->input.sampled |= scene_lights(scene)[i].kind == LIGHT_POINT;
    r->input.divides = scene->camera.kind == CAMERA_PERSPECTIVE;
    r->input.no_plan = (f->config.flags & GLINT_NO_PLAN) != 0;
    r->input.every_zigzag = (f->config.flags & GLINT_EVERY_ZIGZAG) != 0;
}

void glint_turn(struct glint_frame *f, uint16_t yaw, uint16_t pitch)
{
    f->yaw = yaw;
    f->pitch = pitch;
}

void glint_set_budget(struct glint_frame *f, uint16_t budget_q8)
{
    f->config.budget = budget_q8;
}

FX_COLD int glint_frame_begin(struct glint_frame *f, const void *scene, uint32_t time_ms)
{
    const struct scene_header *header = scene;
    if (!f || !scene)
        return GLINT_E_ARGUMENT;
    if (header->magic != SCENE_MAGIC || header->version != SCENE_VERSION || header->light_count > f->config.max_lights)
        return GLINT_E_SCENE;
    if ((header->effects & ~GLINT_USES) != 0)
        return GLINT_E_SCENE;
    f->scene = header;
    f->light_count = fx_u8(header->light_count);
    f->vertex_stride = fx_u16(VERTEX_LIGHTS + 2 * f->light_count + f->config.method->vertex_words);
    f->vertex_count = f->triangle_count = f->clipped_count = f->object_count = 0;
    f->oldest = f->next_row = 0;
    f->band_index = 0;
    f->stats = (struct glint_stats){0};
    begin_raster(f->raster, f);

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

/* A piece made by clipping: its own places, and their weights in the triangle. */
FX_COLD static void gather_piece(struct raster *r, const struct clipped_triangle *piece)
{
    struct shade_input *in = &r->input;
    in->piece = piece;
    for (int k = 0; k < 3; k++) {
        in->place[k] = piece->place[SHADE_TURN(k)];
        const uint16_t *const weight = piece->weight[SHADE_TURN(k)];
        r->weight[k][SHADE_TURN(0)] = weight[0];
        r->weight[k][SHADE_TURN(1)] = weight[1];
        r->weight[k][SHADE_TURN(2)] = fx_u16((1u << 15) - weight[0] - weight[1]);
    }
    in->weight = (const uint16_t(*)[3])r->weight;
}

/* What is seen from behind, or was cut. */
FX_COLD static void gather_kind(struct glint_frame *f, const struct triangle_ref *ref)
{
    struct raster *r = f->raster;
    if (USES(USES_TWO_SIDED) && ref->kind & LIST_TURNED)
        shade_turn(&r->turned, &r->input, f->config.method->vertex_words);
    if (USES(USES_CLIPPING) && ref->kind & LIST_CLIPPED)
        gather_piece(r, &f->clipped[ref->index]);
}

static void take_material(struct raster *r, const struct scene_header *scene, unsigned material)
{
    r->surface_material = fx_u16(material);
    surface_setup(&r->surface, scene, scene_materials(scene) + material, &r->palette);
    if (USES(USES_TEXTURE | USES_FOG))
        effects_surface(r);
    if (raster_effects(r))
        r->surface.fold = 0; /* runs have N.L itself */
    r->fold = r->surface.fold;
    table_find(r);
    r->input.tabled = r->surface_table != 0 && raster_is(r, GLINT_RGB565);
    r->input.grey_table = r->surface_table != 0 && raster_is(r, GLINT_GREY8);
}

FX_COLD static unsigned source_of(const struct glint_frame *f, const struct triangle_ref *ref)
{
    return f->clipped[ref->index].source;
}

/* Turns a listed triangle into the rasteriser's input: corners 0, 2, 1, which is clockwise with y down. */
static void gather(struct glint_frame *f, const struct triangle_ref *ref)
{
    struct raster *r = f->raster;
    struct shade_input *in = &r->input;
    const struct object_state *object = &f->objects[ref->object];
    const struct scene_triangle *triangle = scene_at(f->scene, object->mesh->triangles);
    triangle += USES(USES_CLIPPING) && ref->kind & LIST_CLIPPED ? source_of(f, ref) : ref->index;
    in->object = object;
    in->triangle = triangle;
    in->vertices = scene_at(f->scene, object->mesh->vertices);
    if (USES(USES_TEXTURE | USES_BUMP))
        in->uvs = scene_at(f->scene, object->mesh->uvs);
    if (USES(USES_BUMP))
        in->tangents = scene_at(f->scene, object->mesh->tangents);
    in->weight = 0;
    in->piece = 0;
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
    if (r->surface_material != triangle->material)
        take_material(r, f->scene, triangle->material);
    if (USES(USES_TWO_SIDED | USES_CLIPPING) && ref->kind)
        gather_kind(f, ref);
}

static inline uint32_t bits(unsigned set)
{
    uint32_t count = set & 1; /* most sets are of one light */
    for (set >>= 1; set; set &= set - 1)
        count++;
    return count;
}

/* What a plan left out. */
static void count_plan(struct glint_stats *stats, const struct shade_plan *plan)
{
    if (plan->none[1]) { /* most leave nothing out */
        stats->hidden_lights += bits(plan->hidden_lights);
        stats->hidden_highlights += bits(plan->hidden_highlights);
        stats->dropped_highlights += bits(plan->dropped_highlights);
        stats->undivided += plan->undivided;
    }
    if (plan->rung == PLAN_LINEAR || plan->rung == PLAN_SIX)
        stats->straightened += bits(plan->diffuse & ~plan->diffuse_bent) + bits(plan->specular & ~plan->specular_bent);
    if (plan->error > stats->largest_error)
        stats->largest_error = plan->error;
}

static void count_fog(struct glint_stats *stats, unsigned kind)
{
    stats->fogged += kind != FOGGED_NOT;
    stats->fogged_by_pixel += kind == FOGGED_BY_PIXEL;
    stats->fogged_wholly += kind == FOGGED_WHOLLY;
}

static void draw_triangle(struct glint_frame *f, const struct triangle_ref *ref)
{
    struct raster *r = f->raster;
    const struct glint_method *method = f->config.method;
    struct shade_input *in = &r->input;
    struct shade_setup *setup = &r->setup;
    struct edges edges;
    gather(f, ref);
    if (USES(USES_FOG) && r->fog.kind && fogged_choose(r) == FOGGED_WHOLLY)
        method = &fogged_wholly;
    else if (method->choose)
        method = method->choose(r);
    f->stats.setups++;
    if (!edges_setup(&edges, in->place, r->width, r->height, r->y0, r->y1) ||
        !plane_setup(&setup->plane, in->place, r->width, r->height))
        return;
    const int32_t depth[3] = {fx_wrap_u16(in->place[0][VERTEX_DEPTH]), fx_wrap_u16(in->place[1][VERTEX_DEPTH]),
                              fx_wrap_u16(in->place[2][VERTEX_DEPTH])};
    plane_linear(&setup->plane, depth, &setup->depth);
    setup->found[0] = setup->found[1] = setup->found[2] = 0;
    method->setup(setup, in);
    f->stats.pixels[method->id] += raster_effects(r) ? effects_triangle(r, &edges, method) : method->draw(r, &edges);
    if (ref->first < r->y0)
        return; /* counted with the band above */
    f->stats.drawn[method->id]++;
    f->stats.specular_triangles += setup->specular_lights != 0;
    f->stats.linear_triangles +=
        (method->id == GLINT_X || method->id == GLINT_SIX) && !setup->quadratic && !setup->perspective;
    if (USES(USES_TEXTURE | USES_BUMP) && setup->uv_kind)
        f->stats.mapped[setup->uv_kind]++;
    if (USES(USES_FOG) && r->fog.kind)
        count_fog(&f->stats, r->fog_plan.kind);
    if (f->config.method->choose)
        count_plan(&f->stats, &in->plan);
}

int glint_frame_band(struct glint_frame *f, unsigned index, void *pixels, struct glint_band *band)
{
    if (!f || !band || !pixels || ((uintptr_t)pixels & 3) || !f->scene)
        return GLINT_E_ARGUMENT;
    if (index >= (f->config.height + f->config.band_rows - 1u) / f->config.band_rows)
        return 0;
    struct raster *r = f->raster;
    const unsigned y0 = index * f->config.band_rows, left = f->config.height - y0;
    const unsigned rows = left < f->config.band_rows ? left : f->config.band_rows;
    r->y0 = fx_u16(y0);
    r->y1 = fx_u16(y0 + rows);
    r->pixels = pixels;
    raster_clear(r, f->scene);

    /* By first row, then as they came, those that end above left out: all before the oldest do. */
    unsigned at = y0 < f->next_row ? 0 : f->oldest;
    const unsigned end = f->rows[r->y1 - 1];
    while (at < end && f->triangles[f->order[at]].last <= y0)
        at++;
    f->oldest = fx_u16(at);
    f->next_row = r->y1;
    for (; at < end; at++) {
        const struct triangle_ref *ref = &f->triangles[f->order[at]];
        if (ref->last > y0)
            draw_triangle(f, ref);
    }

    band->pixels = pixels;
    band->y = r->y0;
    band->rows = fx_u16(rows);
    band->stride = r->stride;
    return 1;
}

int glint_frame_next_band(struct glint_frame *f, struct glint_band *band)
{
    if (!f || !f->scene)
        return GLINT_E_ARGUMENT;
    if (f->next_row == f->config.height)
        return 0;
    void *pixels = f->config.band[f->config.band[1] ? f->band_index : 0];
    f->band_index ^= 1;
    return glint_frame_band(f, f->next_row / f->config.band_rows, pixels, band);
}

void glint_worker_begin(struct glint_frame *worker, struct glint_frame *f)
{
    struct raster *r = f->raster;
    /* Now, as two that found one missing would make it at once. */
    for (unsigned i = 0; i < r->tables && i < f->scene->material_count; i++)
        take_material(r, f->scene, i);
    r->input.colours = r->colours;
    r = worker->raster;
    *worker = *f;
    worker->raster = r;
    worker->depth = r->depth;
    worker->stats = (struct glint_stats){0};
    begin_raster(r, f);
    r->input.colours = r->colours;
}

void glint_worker_end(const struct glint_frame *worker, struct glint_frame *f)
{
    for (unsigned i = 0; i < GLINT_METHODS; i++) {
        f->stats.drawn[i] += worker->stats.drawn[i];
        f->stats.pixels[i] += worker->stats.pixels[i];
    }
    for (unsigned i = 0; i < GLINT_TEXTURES; i++)
        f->stats.mapped[i] += worker->stats.mapped[i];
    f->stats.specular_triangles += worker->stats.specular_triangles;
    f->stats.linear_triangles += worker->stats.linear_triangles;
    f->stats.setups += worker->stats.setups;
    f->stats.fogged += worker->stats.fogged;
    f->stats.fogged_by_pixel += worker->stats.fogged_by_pixel;
    f->stats.fogged_wholly += worker->stats.fogged_wholly;
    f->stats.hidden_lights += worker->stats.hidden_lights;
    f->stats.hidden_highlights += worker->stats.hidden_highlights;
    f->stats.dropped_highlights += worker->stats.dropped_highlights;
    f->stats.straightened += worker->stats.straightened;
    f->stats.undivided += worker->stats.undivided;
    if (worker->stats.largest_error > f->stats.largest_error)
        f->stats.largest_error = worker->stats.largest_error;
}
