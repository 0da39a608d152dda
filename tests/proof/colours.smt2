; SPDX-License-Identifier: MIT
; Colours at a piece's corners, by weights that sum to 2^15 of corners' colours, at most 2^16 - 1. The question denies what
; is to be shown: unsat.
; source: firmware/frame.c
; code: r->weight[k][SHADE_TURN(2)] = fx_u16((1u << 15) - weight[0] - weight[1]);
; source: firmware/shade/gouraud.c
; code: uint32_t sum = 0; for (int i = 0; i < 3; i++) sum += fx_u32(colour[i][c]) * in->weight[k][i]; value[k] = fx_s32(sum >> 15);
; shows: shade_gouraud: precondition of plane_linear: differences: -65535 ≤ *(value + 1) - *(value + 0) ≤ 65535 ∧ -65535 ≤ *(value + 2) - *(value + 0) ≤ 65535
(declare-const u Int)
(declare-const v Int)
(define-fun w () Int (- 32768 u v))
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (and (<= 0 u) (<= 0 v) (<= 0 w) (<= 0 a 65535) (<= 0 b 65535) (<= 0 c 65535)))
(assert (and (product u a) (product v b) (product w c) (product u (- 65535 a)) (product v (- 65535 b))
             (product w (- 65535 c))))
(define-fun sum () Int (+ (* u a) (* v b) (* w c)))
(assert (not (and (<= sum 4294967295) (<= 0 (div sum 32768) 65535))))
(check-sat)
