/* SPDX-License-Identifier: MIT */
/* Back faces. A dot product is negated as it stands: as it was rounded half up, it may be 2^-14 below that with the
 * negated normal, where that lay half-way between two (one in 2^14). */
#include "shade/shade.h"

static int16_t opposite(int16_t dot)
{
    return fx_s16(dot == INT16_MIN / 2 ? -dot - 1 : -dot); /* a record holds -16384..16383 */
}

void shade_turn(struct shade_turned *turned, struct shade_input *in, unsigned words)
{
    const struct scene_triangle *source = in->triangle;
    const unsigned dots = 2u * surface_lights(in->surface);
    /* input corner k is corner SHADE_TURN(k) of the turned triangle, which is corner k of the source */
    int16_t *const lights[3] = {in->lights[0], in->lights[2], in->lights[1]};
    const int16_t *const place = in->place[1];
    in->place[1] = in->place[2];
    in->place[2] = place;
    turned->triangle.material = source->material;
    for (unsigned k = 0; k < 3; k++) {
        const struct scene_vertex *from = &in->vertices[source->corner[k]];
        struct scene_vertex *to = &turned->vertex[SHADE_TURN(k)];
        turned->triangle.corner[k] = fx_u16(k);
        turned->triangle.bend[k] = source->bend[2 - k];
        for (int i = 0; i < 3; i++) {
            to->position[i] = from->position[i];
            to->normal[i] = fx_s16(-from->normal[i]); /* |n| <= 2^14 (1 + 2^-13) */
        }
        for (int i = 0; USES(USES_TEXTURE | USES_BUMP) && i < 2 && in->object->mesh->uvs; i++)
            turned->uv[SHADE_TURN(k)][i] = in->uvs[source->corner[k]][i];
        if (USES(USES_BUMP) && in->object->mesh->tangents) {
            const struct scene_tangent *frame = &in->tangents[source->corner[k]];
            struct scene_tangent *back = &turned->tangent[SHADE_TURN(k)];
            for (int i = 0; i < 3; i++)
                back->tangent[i] = fx_s16(-frame->tangent[i]);
            back->sign = fx_s16(-frame->sign);
        }
        for (unsigned i = 0; i < dots; i++)
            turned->lights[k][i] = opposite(lights[k][i]);
        for (unsigned i = dots; i < dots + words; i++)
            turned->lights[k][i] = 0;
        if (words == SHADE_VERTEX_WORDS) /* the mark: the back's bit comes first */
            turned->lights[k][dots + words - 1] = fx_s16(lights[k][dots + words - 1] >> 1);
        in->lights[k] = turned->lights[k];
    }
    /* bit e is the edge from corner e to the next: 0 and 2 change places */
    turned->triangle.flags = fx_u16((source->flags & 2u) | (source->flags & 1u) << 2 | (source->flags >> 2 & 1u));
    in->triangle = &turned->triangle;
    in->vertices = turned->vertex;
    in->uvs = (const int16_t(*)[2])turned->uv;
    in->tangents = turned->tangent;
}
