; SPDX-License-Identifier: MIT
; An edge between places of 28.19: where it crosses a row, and the first column that is not left of that. Each question
; denies what is to be shown: unsat.
; source: firmware/raster/fine.c
; code: #define FINE_BITS 19
; code: int64_t crossing = (fx_s64(x) * dy + fx_s64(dx) * (centre - y) - 1) >> FINE_BITS; e->column = divide(crossing, dy, &e->rest) + 1; fx_divmod_floor(dx, dy, &e->column_step, &e->rest_step); e->den = dy; /* rest + rest_step < 2^31 */ }
; shows: edge_setup: precondition of divide: numerator: -0x1000 * d ≤ n ≤ 0x1000 * d
; shows: edge_setup: signed_overflow: tmp + 1 ≤ 2147483647
; shows: edge_setup: postcondition: divisor: \old(e)->den ≡ \old(dy)
; shows: edge_setup: postcondition: rest: 0 ≤ \old(e)->rest < \old(e)->den
; shows: edge_setup: postcondition: more: 0 ≤ \old(e)->rest_step < \old(e)->den
; shows: edge_setup: postcondition: further: \old(e)->column_step * \old(e)->den + \old(e)->rest_step ≡ \old(dx)
; shows: edge_setup: postcondition: least: ((\old(e)->column - 1) * \old(e)->den) * 0x80000 < \old(x) * \old(dy) + (\old(centre) - \old(y)) * \old(dx)
; shows: edge_setup: postcondition: first: \old(x) * \old(dy) + (\old(centre) - \old(y)) * \old(dx) ≤ (\old(e)->column * \old(e)->den) * 0x80000
(declare-const x Int)
(declare-const dx Int)
(declare-const dy Int)
(declare-const down Int)
(define-fun top () Int 1073741824)
(define-fun crossing () Int (+ (* x dy) (* down dx)))
(define-fun n () Int (div (- crossing 1) 524288))
(assert (and (<= (- top) x top) (<= (- top) (+ x dx) top) (<= 1 dy top) (<= 0 down dy)))
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (product (- top x) (- dy down)))
(assert (product (+ top x) (- dy down)))
(assert (product (- top (+ x dx)) down))
(assert (product (+ top (+ x dx)) down))

; The crossing lies between the ends: 2^11 columns of 2^19 either way.
(push)
(assert (not (<= (* (- 2049) dy) n (* 2048 dy))))
(check-sat)
(pop)
(declare-const quotient Int) ; the column before
(declare-const rest Int)
(assert (and (<= (* (- 2049) dy) n (* 2048 dy)) (= (+ (* quotient dy) rest) n) (<= 0 rest) (< rest dy)))
(push)
(assert (and (product (- quotient 2049) dy) (product (- (- 2051) quotient) dy)))
(assert (not (<= (- 2050) quotient 2048)))
(check-sat)
(pop)

; It is left of the crossing, the next is not.
(push)
(define-fun column () Int (+ quotient 1))
(assert (= (* column dy) (+ (* quotient dy) dy)))
(assert (not (and (< (* (* quotient dy) 524288) crossing) (<= crossing (* (* column dy) 524288)))))
(check-sat)
(pop)
