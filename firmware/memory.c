/* SPDX-License-Identifier: MIT */
/* How a configuration divides the caller's memory. */
#include "list.h"
#include "raster/raster.h"

/* The bytes that README.md promises, of a program that has everything. */
_Static_assert(sizeof(struct triangle_ref) == 8, "a listed triangle");
_Static_assert(sizeof(struct clipped_triangle) == 40, "a piece made by clipping");
_Static_assert(sizeof(void *) > 4 || GLINT_USES != USES_ALL ||
                   (sizeof(struct object_state) == 248 && sizeof(struct raster) == 3560 && sizeof(struct table) == 28),
               "an object, the working state, a table's head");

static size_t words(size_t bytes)
{
    return (bytes + 3) & ~(size_t)3;
}

/* What this program was built for (uses.h). */
static int built_for(const struct glint_config *c)
{
    return USES(USES_FORMAT(c->format)) && (USES(USES_DITHER) || !(c->flags & GLINT_DITHER)) &&
           (USES(USES_POWERS) || !c->power);
}

static int valid(const struct glint_config *c)
{
    return c && c->width && c->width <= GLINT_MAX_SIZE && c->height && c->height <= GLINT_MAX_SIZE && c->band_rows &&
           c->band_rows <= c->height && c->format < GLINT_FORMATS && c->method && c->max_lights <= SCENE_MAX_LIGHTS &&
           built_for(c);
}

size_t glint_row_bytes(const struct glint_config *c)
{
    switch (c->format) {
    case GLINT_RGB565:
        return 2u * c->width;
    case GLINT_RGB888:
        return 3u * c->width;
    case GLINT_GREY8:
        return c->width;
    default:
        return (c->width + 1u) / 2;
    }
}

size_t glint_band_bytes(const struct glint_config *c)
{
    return words(glint_row_bytes(c) * c->band_rows);
}

static size_t depth_bytes(const struct glint_config *c)
{
    return words((size_t)c->width * c->band_rows * 2);
}

/* Hands out the memory in order; with f null it only counts. What holds pointers comes first, the rest are multiples
 * of 4. */
static size_t divide(const struct glint_config *c, struct glint_frame *f)
{
    uint8_t *base = f ? c->memory : 0;
    size_t at = 0;
#define TAKE(member, bytes)                  \
    do {                                     \
        if (f)                               \
            f->member = (void *)(base + at); \
        at += words(bytes);                  \
    } while (0)
    TAKE(raster, sizeof(struct raster));
    TAKE(objects, c->max_objects * sizeof(struct object_state));
    TAKE(raster->table, c->tables * table_bytes(c->format));
    TAKE(clipped, c->max_clipped * sizeof(struct clipped_triangle));
    TAKE(vertices, (size_t)c->max_vertices * (VERTEX_LIGHTS + 2u * c->max_lights + c->method->vertex_words) * 2);
    TAKE(triangles, c->max_triangles * sizeof(struct triangle_ref));
    TAKE(order, c->max_triangles * 2u);
    TAKE(depth, depth_bytes(c));
    TAKE(rows, (c->height + 1u) * 2u);
#undef TAKE
    return at;
}

size_t glint_memory_needed(const struct glint_config *c)
{
    return valid(c) ? divide(c, 0) : 0;
}

static struct palette palette_of(enum glint_format format)
{
    struct palette palette = {format == GLINT_RGB565 || format == GLINT_RGB888 ? 3 : 1, {0, 0, 0}};
    for (unsigned c = 0; c < palette.channels; c++)
        palette.top[c] = raster_top(format, c);
    return palette;
}

/* What a raster keeps from picture to picture. */
static void ready(struct raster *r, const struct glint_config *c)
{
    r->width = c->width;
    r->height = c->height;
    r->format = c->format;
    r->dither = c->flags & GLINT_DITHER && (c->format == GLINT_RGB565 || c->format == GLINT_GREY4);
    r->stride = fx_u32(glint_row_bytes(c));
    r->palette = palette_of(c->format);
    r->split.area = c->subdivide_area ? c->subdivide_area : SPLIT_AREA;
    r->split.threshold = c->subdivide_threshold ? c->subdivide_threshold : SPLIT_THRESHOLD;
    r->split.tolerance = c->subdivide_tolerance ? c->subdivide_tolerance : SPLIT_TOLERANCE;
    r->tables = c->method->uses_tables && table_bytes(c->format) ? c->tables : 0;
}

int glint_init(struct glint_frame *f, const struct glint_config *c)
{
    if (!f || !valid(c) || !c->band[0] || (((uintptr_t)c->band[0] | (uintptr_t)c->band[1]) & 3))
        return GLINT_E_ARGUMENT;
    if (!c->memory || ((uintptr_t)c->memory & (_Alignof(struct raster) - 1)) || c->memory_bytes < divide(c, 0))
        return GLINT_E_MEMORY;
    *f = (struct glint_frame){0};
    f->config = *c;
    divide(c, f);
    ready(f->raster, c);
    f->raster->depth = f->depth;
    table_clear(f->raster);
    return 0;
}

size_t glint_worker_memory_needed(const struct glint_config *c)
{
    return valid(c) ? words(sizeof(struct raster)) + depth_bytes(c) : 0;
}

int glint_worker_init(struct glint_frame *worker, const struct glint_frame *f, void *memory, size_t bytes)
{
    if (!worker || !f)
        return GLINT_E_ARGUMENT;
    if (!memory || ((uintptr_t)memory & (_Alignof(struct raster) - 1)) ||
        bytes < glint_worker_memory_needed(&f->config))
        return GLINT_E_MEMORY;
    *worker = (struct glint_frame){.config = f->config, .raster = memory};
    worker->depth = (uint16_t *)(void *)((uint8_t *)memory + words(sizeof(struct raster)));
    ready(worker->raster, &f->config);
    worker->raster->depth = worker->depth;
    worker->raster->table = f->raster->table;
    return 0;
}

static uint16_t at_most(uint32_t x, uint32_t limit)
{
    return fx_u16(x < limit ? x : limit);
}

void glint_fit_stores(struct glint_config *c, const void *scene)
{
    const struct scene_header *s = scene;
    const struct scene_object *object = scene_objects(s);
    uint32_t vertices = 0, triangles = 0;
    for (unsigned i = 0; i < s->object_count; i++) {
        const struct scene_mesh *mesh = scene_meshes(s) + object[i].mesh;
        vertices += mesh->vertex_count;
        triangles += mesh->triangle_count;
    }
    /* A triangle that is cut makes up to seven pieces; few are at a time. */
    c->max_clipped = s->effects & USES_CLIPPING ? at_most(triangles / 4 + 64, 1024) : 0;
    c->max_vertices = at_most(vertices, 65535);
    c->max_triangles = at_most(triangles + c->max_clipped, 65535);
    c->max_objects = fx_u8(at_most(s->object_count, SCENE_MAX_OBJECTS));
    c->max_lights = fx_u8(at_most(s->light_count, SCENE_MAX_LIGHTS));
}

int glint_scene_check(const void *scene, size_t size)
{
    return scene_check(scene, size) ? GLINT_E_SCENE : 0;
}

const char *glint_scene_problem(const void *scene, size_t size)
{
    return scene_fault_text(scene_check(scene, size));
}
