/* SPDX-License-Identifier: MIT */
#include "list.h"

#include "geometry/clip.h"
#include "geometry/project.h"
#include "raster/raster.h"

/* Notes a triangle to be drawn if it faces the eye, or has two sides, and covers a pixel's row and column of the
 * picture. A template: for a whole mesh one side is constant. */
static inline __attribute__((always_inline)) void list_triangle(struct glint_frame *f, const int16_t *const p[3],
                                                                unsigned object, unsigned index, unsigned kind,
                                                                int two_sided)
{
    /* Differences of |p| <= GUARD are at most 2^15: products 2^30, the determinant at most 2^30. Front faces are
     * counter-clockwise with y up, so negative with y down. */
    int32_t x0 = p[0][VERTEX_X], y0 = p[0][VERTEX_Y];
    int32_t x1 = p[1][VERTEX_X] - x0, y1 = p[1][VERTEX_Y] - y0, x2 = p[2][VERTEX_X] - x0, y2 = p[2][VERTEX_Y] - y0;
    const int32_t determinant = x1 * y2 - x2 * y1;
    if (determinant >= 0) {
        if (!two_sided || determinant == 0) {
            f->stats.culled++;
            return;
        }
        kind |= LIST_TURNED;
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
    if (USES(USES_TWO_SIDED))
        f->stats.turned += (kind & LIST_TURNED) != 0;
    struct triangle_ref *ref = &f->triangles[f->triangle_count++];
    ref->index = fx_u16(index);
    ref->object = fx_u8(object);
    ref->kind = fx_u8(kind);
    ref->first = fx_u16(first);
    ref->last = fx_u16(last);
}

/* Twice the area of a turn, positive for a left one with y up: a front face's. */
static int32_t turn(const int16_t *a, const int16_t *b, const int16_t *c)
{
    /* Differences are at most 2^15: products 2^30, the whole that of a triangle in such a box. */
    return (c[VERTEX_X] - a[VERTEX_X]) * (b[VERTEX_Y] - a[VERTEX_Y]) -
           (b[VERTEX_X] - a[VERTEX_X]) * (c[VERTEX_Y] - a[VERTEX_Y]);
}

static int original(const struct clip_corner *corner)
{
    return corner->weight[0] == Q30(1, 1) || corner->weight[1] == Q30(1, 1) || corner->weight[2] == Q30(1, 1);
}

/*
 * Where to fan the pieces out from. Rounding to sub-pixels can turn a corner of the mesh inwards, one that a cut is
 * close to or with nearly straight edges. Pieces from another corner would then cover what lies beyond one of its
 * edges, which another triangle shares and draws; those from it do not.
 */
static int apex_of(const struct clip_polygon *polygon, int16_t (*place)[3])
{
    const int count = polygon->count;
    for (int i = 0; i < count; i++)
        if (original(&polygon->corner[i]) &&
            turn(place[i ? i - 1 : count - 1], place[i], place[i + 1 == count ? 0 : i + 1]) <= 0)
            return i;
    return 0;
}

FX_COLD static void store_piece(struct glint_frame *f, const struct clip_polygon *polygon, int16_t (*place)[3],
                                const int corners[3], unsigned object, unsigned source, unsigned kind)
{
    struct clipped_triangle *piece = &f->clipped[f->clipped_count];
    piece->source = fx_u16(source);
    for (int c = 0; c < 3; c++) {
        uint16_t rest = 1u << 15; /* the three sum to 1 */
        for (int i = 0; i < 3; i++) {
            q30_t w = polygon->corner[corners[c]].weight[i];
            uint16_t rounded = fx_u16((w + (1 << 14)) >> 15);
            piece->place[c][i] = place[corners[c]][i];
            rounded = rounded > rest ? rest : rounded;
            rest = fx_u16(rest - rounded);
            if (i < 2) {
                const q30_t left =
                    (w - (fx_s32(rounded) << 15)) >> 7; /* |w - rounded| <= 2^14 and what exceeds 1 in sum */
                piece->weight[c][i] = rounded;
                piece->finer[c][i] = fx_s8(left < -128 ? -128 : left > 127 ? 127 : left);
            }
        }
    }
    const int16_t *const p[3] = {piece->place[0], piece->place[1], piece->place[2]};
    unsigned before = f->triangle_count;
    list_triangle(f, p, object, f->clipped_count, kind, 0);
    f->clipped_count = fx_u16(f->clipped_count + (f->triangle_count - before));
}

/* A triangle that may have to be cut. */
struct candidate {
    const struct scene_vertex *vertices; /* of its mesh */
    const struct scene_triangle *triangle;
    unsigned object, index; /* in the mesh */
    int two_sided;
};

/* Twice the polygon's area, negative where its back is seen. The sum of fewer than eight turns, of which those that are
 * not to the same side are slivers of rounding. */
static int64_t area_of(const struct clip_polygon *polygon, int16_t (*place)[3])
{
    int64_t area = 0;
    for (int i = 2; i < polygon->count; i++)
        area += turn(place[0], place[i - 1], place[i]);
    return area;
}

/* Clips a triangle, its corners in the order 0, 2, 1 for its back, and lists the pieces. Returns 0 and lists none if it
 * is the other side that is seen, and to be drawn. */
FX_COLD static int clip_side(struct glint_frame *f, const struct transform *transform, const struct candidate *from,
                             int back)
{
    struct clip_polygon *polygon = &f->raster->begin.polygon[0];
    int16_t(*place)[3] = f->raster->begin.place;
    polygon->count = 3;
    for (int k = 0; k < 3; k++) {
        struct clip_corner *corner = &polygon->corner[k];
        const unsigned vertex = from->triangle->corner[back && k ? 3 - k : k];
        corner->eye = transform_point(transform, from->vertices[vertex].position);
        for (int i = 0; i < 3; i++)
            corner->weight[i] = i == k ? Q30(1, 1) : 0;
    }
    clip_triangle(transform, polygon, &f->raster->begin.polygon[1]);
    if (polygon->count < 3) {
        f->stats.rejected++;
        return 1;
    }
    int fits = 1;
    for (int k = 0; k < polygon->count; k++) {
        struct screen_point point = {0, 0, 0};
        fits &= project_clipped(transform, &polygon->corner[k].eye, &point);
        place[k][VERTEX_X] = point.x;
        place[k][VERTEX_Y] = point.y;
        place[k][VERTEX_DEPTH] = fx_wrap_s16(point.depth);
    }
    if (USES(USES_TWO_SIDED) && fits && from->two_sided && !back && area_of(polygon, place) < 0)
        return 0;
    /* All pieces or none. */
    const int pieces = polygon->count - 2;
    if (!fits || f->clipped_count + pieces > f->config.max_clipped ||
        f->triangle_count + pieces > f->config.max_triangles) {
        f->stats.dropped++;
        return 1;
    }
    f->stats.clipped++;
    const int apex = apex_of(polygon, place);
    for (int k = 1; k <= pieces; k++) {
        const int second = apex + k < polygon->count ? apex + k : apex + k - polygon->count;
        const int corners[3] = {apex, second, second + 1 < polygon->count ? second + 1 : 0};
        store_piece(f, polygon, place, corners, from->object, from->index, LIST_CLIPPED | (back ? LIST_TURNED : 0));
    }
    return 1;
}

/* Rare, so kept out of the loop that calls it. */
FX_COLD static void clip(struct glint_frame *f, const struct transform *transform, const struct candidate *from)
{
    if (!clip_side(f, transform, from, 0) && USES(USES_TWO_SIDED))
        clip_side(f, transform, from, 1);
}

static int unplaced(const int16_t *const p[3])
{
    return p[0][VERTEX_X] == VERTEX_UNPLACED || p[1][VERTEX_X] == VERTEX_UNPLACED || p[2][VERTEX_X] == VERTEX_UNPLACED;
}

/* A template: `sides` is constant, whether some material may have two. */
static inline __attribute__((always_inline)) void list_each(struct glint_frame *f, const struct transform *transform,
                                                            unsigned index, int all_placed, int sides)
{
    const struct object_state *object = &f->objects[index];
    const struct scene_mesh *mesh = object->mesh;
    const struct scene_material *materials = scene_materials(f->scene);
    const struct scene_triangle *triangle = scene_at(f->scene, mesh->triangles);
    const int16_t *records = list_record(f, object->first_vertex);
    const uint32_t stride = f->vertex_stride, count = mesh->triangle_count;
    for (uint32_t i = 0; i < count; i++, triangle++) {
        const int16_t *const p[3] = {records + triangle->corner[0] * stride, records + triangle->corner[1] * stride,
                                     records + triangle->corner[2] * stride};
        const int two_sided = sides && (materials[triangle->material].flags & MATERIAL_TWO_SIDED);
        if (!all_placed && unplaced(p)) {
            if (!USES(USES_CLIPPING)) {
                f->stats.dropped++; /* not in a scene that says truly what it needs */
                continue;
            }
            const struct candidate from = {scene_at(f->scene, mesh->vertices), triangle, index, i, two_sided};
            clip(f, transform, &from);
        } else {
            list_triangle(f, p, index, i, 0, two_sided);
        }
    }
}

FX_COLD static void list_two_sided(struct glint_frame *f, const struct transform *transform, unsigned index,
                                   int all_placed)
{
    list_each(f, transform, index, all_placed, 1);
}

void list_object(struct glint_frame *f, const struct transform *transform, unsigned index, int all_placed)
{
    if (USES(USES_TWO_SIDED) && f->scene->effects & USES_TWO_SIDED)
        list_two_sided(f, transform, index, all_placed);
    else
        list_each(f, transform, index, all_placed, 0);
}

/* A counting sort. */
void list_sort(struct glint_frame *f)
{
    uint16_t *start = f->rows;
    for (unsigned row = 0; row <= f->config.height; row++)
        start[row] = 0;
    for (unsigned i = 0; i < f->triangle_count; i++)
        start[f->triangles[i].first + 1]++; /* first < height */
    for (unsigned row = 0; row < f->config.height; row++)
        start[row + 1] = fx_u16(start[row + 1] + start[row]);
    for (unsigned i = 0; i < f->triangle_count; i++)
        f->order[start[f->triangles[i].first]++] = fx_u16(i);
}
