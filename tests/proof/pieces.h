/* SPDX-License-Identifier: MIT */
/* What shade/piece.c and what it calls ask and give: proven by piece.c, plane.c, plane_wide.c and assumed by what calls
 * them. Of weights besides, the sum is 2^15. */
#ifndef PIECES_H
#define PIECES_H

#include "shade/piece.h"

/*@ predicate short3(int32_t *v) = -32768 <= v[0] <= 32767 && -32768 <= v[1] <= 32767 && -32768 <= v[2] <= 32767; */

/*@ requires there: \valid_read(w[0 .. 2] + (0 .. 2)) && \valid(value + (0 .. 2));
    requires values: short3(value);
    assigns value[0 .. 2] \from w[0 .. 2][0 .. 2], value[0 .. 2];
    ensures values: short3(value); */
void piece_linear(const uint16_t (*w)[3], int32_t value[3]);

/*@ requires there: \valid_read(w[0 .. 2] + (0 .. 2)) && \valid(value + (0 .. 2)) && \valid(bulge + (0 .. 2));
    requires values: short3(value);
    assigns value[0 .. 2], bulge[0 .. 2] \from w[0 .. 2][0 .. 2], value[0 .. 2], bulge[0 .. 2];
    ensures bulges: \forall integer k; 0 <= k <= 2 ==> -0x7fffffff <= bulge[k] <= 0x7fffffff; */
void piece_quadratic(const uint16_t (*w)[3], int32_t value[3], int32_t bulge[3]);

/*@ requires there: \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid(channel);
    requires values: short3((int32_t *)value);
    assigns *channel \from *plane, value[0 .. 2]; */
void plane_linear(const struct plane *plane, const int32_t value[3], struct channel *channel);

/*@ requires there: \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid(channel);
    assigns *channel \from *plane, value[0 .. 2]; */
void plane_linear_wide(const struct plane *plane, const int32_t value[3], struct channel *channel);

/*@ requires there: \valid_read(plane) && \valid_read(value_q30 + (0 .. 2)) && \valid_read(bulge + (0 .. 2)) &&
                    \valid(channel);
    assigns *channel \from *plane, value_q30[0 .. 2], bulge[0 .. 2]; */
void plane_quadratic_wide(const struct plane *plane, const int32_t value_q30[3], const int32_t bulge[3],
                          struct channel *channel);

/*@ requires there: \valid_read(p) && \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid(channel);
    requires values: short3((int32_t *)value);
    assigns *channel \from *p, *plane, value[0 .. 2]; */
void perspective_linear(const struct perspective *p, const struct plane *plane, const int32_t value[3],
                        struct channel *channel);

#endif
