; SPDX-License-Identifier: MIT
; Places and normals by weights that sum to 2^10, as each that summit_find() makes does (part_corners.smt2). Each question
; denies what is to be shown: unsat.
; source: firmware/plan/summit.c
; code: int32_t place = SUMMIT_ONE / 2, normal = 0; for (int k = 0; k < 3; k++) { place += weight[k] * s->corner[k].place[i]; normal += weight[k] * s->corner[k].normal[i]; } point.place[i] = place >> 10; point.normal[i] = normal; }
; code: uint16_t at[3][3] = {{SUMMIT_ONE, 0, 0}, {0, SUMMIT_ONE, 0}, {0, 0, SUMMIT_ONE}}, ends[2][3];
; code: from[a] = SUMMIT_ONE;
; code: out[2] = fx_u16(SUMMIT_ONE - out[0] - out[1]); }
; shows: point_at: signed_overflow: -2147483648 ≤ place + (int)((int)*(weight + k) * (s->corner + k)->place[i])
; shows: point_at: signed_overflow: place + (int)((int)*(weight + k) * (s->corner + k)->place[i]) ≤ 2147483647
; shows: point_at: signed_overflow: -2147483648 ≤ normal + (int)((int)*(weight + k) * (s->corner + k)->normal[i])
; shows: point_at: signed_overflow: normal + (int)((int)*(weight + k) * (s->corner + k)->normal[i]) ≤ 2147483647
; shows: highlighted_at: user assertion: -0x8000 ≤ point->place[i] ≤ 0x8000
; shows: highlighted_at: user assertion: -0x2000000 ≤ point->normal[i] ≤ 0x2000000
; shows: object_unit: user assertion: -0x40000000 < *(v + i) < 0x40000000
(declare-const u Int)
(declare-const v Int)
(define-fun w () Int (- 1024 u v))
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (and (<= 0 u) (<= 0 v) (<= 0 w)))
(define-fun within ((x Int) (least Int) (most Int)) Bool (<= least x most))
(push) ; a place, with the half that rounds it
(assert (and (within a (- 32768) 32767) (within b (- 32768) 32767) (within c (- 32768) 32767)))
(assert (and (product u (- 32767 a)) (product v (- 32767 b)) (product w (- 32767 c))
             (product u (+ 32768 a)) (product v (+ 32768 b)) (product w (+ 32768 c))))
(define-fun sum () Int (+ 512 (* u a) (* v b) (* w c)))
(assert (not (and (within (+ 512 (* u a)) (- 33554432) 33554944) (within (+ 512 (* u a) (* v b)) (- 33554432) 33554944)
                  (within sum (- 33554432) 33554944) (within (div sum 1024) (- 32768) 32767))))
(check-sat)
(pop)
(push) ; a normal
(assert (and (within a (- 16386) 16386) (within b (- 16386) 16386) (within c (- 16386) 16386)))
(assert (and (product u (- 16386 a)) (product v (- 16386 b)) (product w (- 16386 c))
             (product u (+ 16386 a)) (product v (+ 16386 b)) (product w (+ 16386 c))))
(assert (not (and (within (* u a) (- 33554432) 33554432) (within (+ (* u a) (* v b)) (- 33554432) 33554432)
                  (within (+ (* u a) (* v b) (* w c)) (- 33554432) 33554432))))
(check-sat)
(pop)
