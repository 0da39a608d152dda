; SPDX-License-Identifier: MIT
; A triangle in a box of 2^15: its determinant, how far apart its corners are, the pixel that is its origin. Each
; question denies what is to be shown: unsat.
; source: firmware/shade/plane.c
; code: int32_t x0 = p[0][0], y0 = p[0][1]; int32_t x1 = p[1][0] - x0, y1 = p[1][1] - y0, x2 = p[2][0] - x0, y2 = p[2][1] - y0;
; code: const int32_t det = x1 * y2 - x2 * y1; if (det <= 0) return 0; plane->whole_x1 = x1; plane->whole_y1 = y1; plane->whole_x2 = x2; plane->whole_y2 = y2; plane->det = fx_u32(det); plane->up = fx_s32(fx_clz(fx_u32(det)));
; code: uint32_t largest = fx_u32(x1 < 0 ? -x1 : x1) | fx_u32(y1 < 0 ? -y1 : y1) | fx_u32(x2 < 0 ? -x2 : x2) | fx_u32(y2 < 0 ? -y2 : y2); /* as good as the maximum for counting bits */ const int scale = fx_s32(fx_clz(largest)) - 18; if (scale >= 0) { x1 *= 1 << scale; y1 *= 1 << scale; x2 *= 1 << scale; y2 *= 1 << scale; } else {
; code: x1 >>= -scale; y1 >>= -scale; x2 >>= -scale; y2 >>= -scale; } plane->x1 = x1; plane->y1 = y1; plane->x2 = x2; plane->y2 = y2; plane->scale = scale;
; code: if (fx_wrap_u32(i) < size) return i; return i < 0 ? 0 : fx_s32(size) - 1;
; code: const int32_t left = x0 + 8 * fx_s32(width), top = y0 + 8 * fx_s32(height); plane->ox = inside(left >> 4, width); plane->oy = inside(top >> 4, height); plane->fx = plane->ox * 16 + 8 - left; plane->fy = plane->oy * 16 + 8 - top;
; shows: plane_setup: signed_overflow: (int32_t)(x1 * y2) - (int32_t)(x2 * y1) ≤ 2147483647
; shows: plane_setup: postcondition: det: \result ≡ 1 ⇒ plane_det(\old(plane))
; shows: clz: user assertion: x ≢ 0
; shows: plane_setup: postcondition: whole: \result ≡ 1 ⇒ plane_whole(\old(plane))
; shows: plane_setup: postcondition: moved: \result ≡ 1 ⇒ plane_moved(\old(plane))
; shows: plane_setup: postcondition: low: \result ≡ 1 ⇒ plane_low(\old(plane))
; shows: plane_setup: postcondition: origin: \result ≡ 1 ⇒ plane_origin(\old(plane))
; shows: plane_setup: postcondition: corner: \result ≡ 1 ⇒ plane_corner(\old(plane))

; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))

; The determinant is a (p - q) + b (q - o) + c (o - p) of corners (a, o), (b, p), (c, q), seen from the box's own: each of
; a, b, c counts at most 2^15 times what of the heights' differences is above 0, whose sum is 0.
(define-fun in ((v Int)) Bool (<= 0 v 32768))
(define-fun above ((d Int)) Int (ite (> d 0) d 0))
(define-fun part ((v Int) (d Int)) Bool (<= (* (- 32768) (above (- d))) v (* 32768 (above d))))
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
(declare-const o Int)
(declare-const p Int)
(declare-const q Int)
(push)
(assert (not (= (- (* (- b a) (- q o)) (* (- c a) (- p o))) (+ (* a (- p q)) (* b (- q o)) (* c (- o p))))))
(check-sat)
(pop)
(push)
(declare-const d Int)
(assert (and (in a) (product a d) (product a (- d)) (product (- 32768 a) d) (product (- 32768 a) (- d))))
(assert (not (part (* a d) d)))
(check-sat)
(pop)
(push)
(declare-const apq Int)
(declare-const bqo Int)
(declare-const cop Int)
(assert (and (in o) (in p) (in q) (part apq (- p q)) (part bqo (- q o)) (part cop (- o p))))
(assert (not (<= (- 1073741824) (+ apq bqo cop) 1073741824)))
(check-sat)
(pop)

; No difference's size is above `largest`, nor is that 0 where the determinant is not.
(push)
(declare-const sx1 (_ BitVec 32))
(declare-const sy1 (_ BitVec 32))
(declare-const sx2 (_ BitVec 32))
(declare-const sy2 (_ BitVec 32))
(define-fun largest () (_ BitVec 32) (bvor (bvor (bvor sx1 sy1) sx2) sy2))
(assert (not (and (bvule sx1 largest) (bvule sy1 largest) (bvule sx2 largest) (bvule sy2 largest))))
(check-sat)
(pop)
(push)
(declare-const x1 Int)
(declare-const y1 Int)
(declare-const x2 Int)
(declare-const y2 Int)
(assert (and (= x1 0) (= y1 0) (= x2 0) (= y2 0) (not (<= (- (* x1 y2) (* x2 y1)) 0))))
(check-sat)
(pop)

; Of `largest` below room = 2^(14 - scale), its next power of two, one difference d: as it is and moved, by 2^scale.
(push)
(declare-const d Int)
(declare-const scale Int)
(declare-const room Int)
(declare-const moved Int) ; 2^scale
(define-fun side () Int (ite (< scale (- 1)) 32768 (- room 1)))
(assert (and (<= (- 32768) d 32768) (< (- room) d room) (<= (- 2) scale 13) (> moved 0)))
(assert (=> (= scale (- 1)) (= room 32768)))
(assert (and (product (- side d) moved) (product (+ side d) moved)))
(assert (not (and (<= (- side) d side)
                  (=> (>= scale 0) (<= (- (* side moved)) (* d moved) (* side moved)))
                  (=> (= scale (- 1)) (<= (- 16384) (div d 2) 16384))
                  (=> (= scale (- 2)) (<= (- 8192) (div d 4) 8192)))))
(check-sat)
(pop)

; By that the determinant is at most twice its square, and `up` 2 scale + 3 at least.
(push)
(declare-const x Int)
(declare-const y Int)
(declare-const side Int)
(assert (and (<= (- side) x side) (<= (- side) y side)))
(assert (and (product (- side x) (+ side y)) (product (+ side x) (- side y))))
(assert (and (product (- side x) (- side y)) (product (+ side x) (+ side y))))
(assert (not (<= (- (* side side)) (* x y) (* side side))))
(check-sat)
(pop)
(push)
(declare-const det (_ BitVec 64))
(declare-const up (_ BitVec 64))
(declare-const scale (_ BitVec 64))
(define-fun power ((n (_ BitVec 64))) (_ BitVec 64) (bvshl #x0000000000000001 n))
(define-fun side () (_ BitVec 64) (bvsub (power (bvsub #x000000000000000e scale)) #x0000000000000001))
(assert (and (bvule scale #x000000000000000d) (bvule up #x000000000000001f)))
(assert (bvule det (bvmul #x0000000000000002 (bvmul side side))))
(assert (bvule (power (bvsub #x000000000000001f up)) det))
(assert (not (bvuge up (bvadd scale scale #x0000000000000003))))
(check-sat)
(pop)

; The origin along one axis: in the picture, and how far from corner 0.
(declare-const at Int)
(declare-const size Int)
(define-fun left () Int (+ at (* 8 size)))
(define-fun i () Int (div left 16))
(define-fun inside () Int (ite (and (<= 0 i) (< i size)) i (ite (< i 0) 0 (- size 1))))
(assert (and (<= (- 16384) at 16384) (<= 1 size 2048)))
(assert (not (and (<= 0 inside 2047) (<= (- 32768) (- (+ (* 16 inside) 8) left) 32768))))
(check-sat)
