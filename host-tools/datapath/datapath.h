/* SPDX-License-Identifier: MIT */
/*
 * The shading hardware of Abbas, Szirmay-Kalos and others, "Quadratic Interpolation in Hardware Rendering" (2001),
 * section 4, register by register and clock by clock. Built from that section's text and algorithm.
 *
 * A register has an input L, taken when its load signal is active, and an input S, taken at each of its clocks:
 *
 *   on the system clock; load: the comparator X + 1 >= X_end, the end of a scan line
 *     X    L X_start    S X + 1         I    L I_start    S I + dI
 *     X_end, Y, 2T5     held            dI   L dI_line    S dI + 2T5
 *   on the edge clock, which is that comparator's output; load: a new horizontal-sided triangle
 *     X_start           S + A_start     I_start   S + dI_start
 *     X_end             S + A_end       dI_start  S + 2(T5 A^2 + T4 A + T3)
 *     rows, Y           S - 1, + 1      dI_line   S + 2 T5 A + T4
 *
 * Values have 22 fraction bits in display units (256 = full intensity), which is Q30, and adders are modulo 2^32: the
 * bits are those of the renderer's plane_values(). Where the paper leaves something open, or would draw other pixels:
 *
 * - A_start is a fraction there, and I is taken at the exact crossing, up to a pixel away from the centre it is shown
 *   at. Here X_start is a whole column with a remainder (struct edge): A is its whole step q, and where the remainder
 *   carries, the edge goes one column further in the same clock: I_start takes dI too, by one more adder, and the
 *   other two choose between two constants.
 * - Its spans include X_end and so have a pixel at least; here they are half open, and a row without a pixel costs the
 *   clock in which the comparator says so.
 * - "While the hardware draws the actual triangle, the software can compute the initial values for the next": edge
 *   registers are a row ahead, and after a triangle's last edge clock they are free for a load while its last row is
 *   drawn. For that 2T5 stands twice, as X_end does; rows of a pixel or none leave no such clock.
 */
#ifndef DATAPATH_H
#define DATAPATH_H

#include "raster/edges.h"
#include "shade/plane.h"

/* What the software computes of a horizontal-sided triangle: the edge registers' L inputs and its constants. */
struct datapath_part {
    int32_t y, rows;
    struct edge start, end;              /* X_start, X_end: column, remainder and their steps A */
    uint32_t i_start, di_start, di_line; /* I, its step along the edge by (q, 1), and along the row, at (X_start, Y) */
    uint32_t ddi;                        /* 2 T5 */
    uint32_t di_line_step[2];            /* 2 T5 A + T4 for A = q and q + 1 */
    uint32_t di_start_step[2];           /* 2 (T5 q^2 + T4 q + T3), and 2 T5 q + T4 more */
};

/* The registers: on the edge clock those of a part, on the system clock these. All zero at reset. */
struct datapath {
    struct datapath_part edge;
    int32_t x, x_end, y;
    uint32_t i, di, ddi;
};

/* Write enable, pixel and value on the outputs. */
struct datapath_pixel {
    int write;
    int32_t x, y;
    uint32_t value;
};

/*
 * The parts, at most two, of a triangle whose corners p are as for plane_setup() and lie in the picture; of its rows
 * only those with a pixel centre. Returns their number.
 */
int datapath_parts(const int16_t *const p[3], unsigned width, unsigned height, const struct plane *plane,
                   const struct polynomial *polynomial, struct datapath_part part[2]);

/* May the load signal be active in this clock? */
static inline int datapath_ready(const struct datapath *d)
{
    return d->edge.rows == 0;
}

/* The outputs before the clock, then the clock. `load` is null while the load signal is inactive. */
struct datapath_pixel datapath_clock(struct datapath *d, const struct datapath_part *load);

#endif
