; SPDX-License-Identifier: MIT
; One edge: where it crosses a row, and from there to the next. Each question denies what is to be shown: unsat.
; source: firmware/raster/edges.c
; code: int32_t den = dy << 4, down = centre - y, slope, more; fx_divmod_floor(dx, dy, &slope, &more); e->den = den; e->column_step = slope; e->rest_step = more << 4; if (down < 16) {
; code: int32_t whole = x + slope * down; int32_t rest = (whole & 15) * dy + more * down - 1; e->column = (whole >> 4) + 1; if (rest < 0) { rest += den; e->column--; } else if (rest >= den) { rest -= den; e->column++; } e->rest = rest; return; } fx_divmod_floor(x * dy + down * dx + den - 1, den, &e->column, &e->rest); }
; code: fx_step(column, fx_wrap_u32(e->column_step)); fx_step(rest, fx_u32(e->rest_step)); if (fx_wrap_s32(*rest) >= 0) { *rest -= fx_u32(e->den); ++*column; } }
; shows: edge_setup: precondition of fx_divmod_floor: numerator: -0x40080000 ≤ num ≤ 0x40080000
; shows: edge_setup: signed_overflow: (int32_t)((int32_t)(x * dy) + (int32_t)(down * dx)) + den ≤ 2147483647
; shows: edge_setup: signed_overflow: (int32_t)(x * dy) + (int32_t)(down * dx) ≤ 2147483647
; shows: edge_setup: postcondition: rest: 0 ≤ \old(e)->rest < \old(e)->den
; shows: edge_setup: postcondition: more: 0 ≤ \old(e)->rest_step < \old(e)->den
; shows: edge_setup: postcondition: crossing: \old(e)->column * \old(e)->den + \old(e)->rest ≡ ((\old(x) * \old(dy) + (\old(centre) - \old(y)) * \old(dx)) + \old(e)->den) - 1
; shows: edge_setup: postcondition: further: \old(e)->column_step * \old(e)->den + \old(e)->rest_step ≡ 16 * \old(dx)
; shows: step: postcondition: negative: 0x100000000 - \old(e)->den ≤ *\old(rest)
(declare-const x Int)
(declare-const dx Int)
(declare-const dy Int)
(declare-const down Int)
(declare-const slope Int)
(declare-const more Int)
(define-fun den () Int (* 16 dy))
(define-fun crossing () Int (+ (* x dy) (* down dx)))
; What is asked, and what the division gives.
(assert (and (<= (- 32768) x 32768) (<= (- 32768) (+ x dx) 32768) (<= 1 dy 32768) (<= 0 down dy)))
(assert (and (= (+ (* slope dy) more) dx) (<= 0 more) (< more dy)))
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (product (- 32768 x) (- dy down)))
(assert (product (+ 32768 x) (- dy down)))
(assert (product (- 32768 (+ x dx)) down))
(assert (product (+ 32768 (+ x dx)) down))

; The crossing lies between the ends.
(push)
(assert (not (<= (- (* 32768 dy)) crossing (* 32768 dy))))
(check-sat)
(pop)
(push)
(assert (<= (- (* 32768 dy)) crossing (* 32768 dy)))
(assert (not (and (<= (- 1073741824) crossing 1073741824) (<= (+ crossing den) 2147483647)
                  (<= (- 1074266112) (+ crossing den (- 1)) 1074266112))))
(check-sat)
(pop)

; The steps: 16 dx is so many columns and the rest.
(push)
(assert (not (and (<= 0 (* 16 more)) (< (* 16 more) den) (= (+ (* slope den) (* 16 more)) (* 16 dx)))))
(check-sat)
(pop)

; By a comparison or two, down < 16.
(push)
(declare-const high Int) ; whole >> 4
(declare-const low Int)  ; whole & 15
(define-fun whole () Int (+ (* 16 high) low))
(assert (and (< down 16) (<= 0 low 15) (= whole (+ x (* slope down)))))
(assert (= (* dy whole) (+ (* dy x) (* dy slope down))))
(assert (= (* down dx) (+ (* down slope dy) (* down more))))
(assert (and (product low dy) (product (- 15 low) dy)))
(assert (and (product more down) (product (- (- dy 1) more) down) (product (- dy 1) (- 15 down))))
(define-fun rest () Int (+ (* low dy) (* more down) (- 1)))
(define-fun carry () Int (ite (< rest 0) 1 (ite (>= rest den) (- 1) 0)))
(assert (not (and (<= 0 (+ rest (* carry den))) (< (+ rest (* carry den)) den)
                  (= (+ (* 16 high dy) den (- (* carry den)) (+ rest (* carry den))) (+ crossing den (- 1))))))
(check-sat)
(pop)

; The column of a crossing between the ends, c den + rest = crossing + den - 1, is a 16-bit number.
(push)
(declare-const c Int)
(declare-const rest Int)
(assert (and (= (+ (* 16 c dy) rest) (+ crossing den (- 1))) (<= 0 rest) (< rest den)))
(assert (<= (- (* 32768 dy)) crossing (* 32768 dy)))
(assert (and (product (- c 2049) dy) (product (- (- 2049) c) dy)))
(assert (not (<= (- 2048) c 2048)))
(check-sat)
(pop)

; A row further: c den + rest grows by 16 dx, so c is that row's column; what is left over, less den, stays negative.
(push)
(declare-const c Int)
(declare-const cd Int) ; c den
(declare-const sd Int) ; slope den
(declare-const rest Int)
(define-fun next () Int (+ rest (- den) (* 16 more)))
(define-fun over () Int (ite (>= next 0) den 0))
(assert (and (<= 0 rest) (< rest den) (= (+ sd (* 16 more)) (* 16 dx))))
(assert (not (and (= (+ cd sd over (- next over) den) (+ cd rest (* 16 dx))) (<= (- den) (- next over)) (< (- next over) 0))))
(check-sat)
(pop)
(push) ; in 32 bits
(declare-const divisor (_ BitVec 32))
(declare-const left (_ BitVec 32))
(declare-const add (_ BitVec 32))
(define-fun sum () (_ BitVec 32) (bvadd left add))
(assert (and (bvule #x00000001 divisor) (bvule divisor #x40000000) (bvult add divisor) (bvuge left (bvneg divisor))))
(assert (not (bvuge (ite (bvsge sum #x00000000) (bvsub sum divisor) sum) (bvneg divisor))))
(check-sat)
(pop)
