; SPDX-License-Identifier: MIT
; What draws parts takes places of corners that part_corners.smt2 is about. The question denies what is to be shown: unsat.
; source: firmware/raster/parts.c
; code: p[k] = part_place(&r->input, corner[k]); }
; source: firmware/shade/part.c
; code: w = fx_s32(PART_ONE) - u - v;
; shows: places: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; Two weights that sum to 2^15 at most leave the third, at least 0.
(declare-const a Int)
(declare-const b Int)
(assert (and (<= 0 a) (<= 0 b) (<= (+ a b) 32768)))
(assert (not (<= 0 (- 32768 a b) 32768)))
(check-sat)
