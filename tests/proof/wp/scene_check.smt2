; SPDX-License-Identifier: MIT
; What cvc4 does not find of scene_check(): products of components. Each question denies what is to be shown: unsat.
; source: firmware/scene/scene_check.c
; code: return square + (1u << 16) >= 1u << 28 && square <= (1u << 28) + (1u << 16) + 4;
; code: length += (uint32_t)(v->normal[k] * v->normal[k]); } if (distance > furthest) furthest = distance; if (!square_ok(length)) return SCENE_E_RANGE; }
; code: dot += a[k] * b[k]; int32_t expected = ((1 << 28) - dot) >> 13;
; shows: check_vertices_loop_invariant_2_preserved
; shows: bend_ok_assert_rte_signed_overflow_7
; shows: bend_ok_assert_rte_signed_overflow_10
(declare-const a Int)
(declare-const b Int)
(declare-const length Int)
(declare-const dot Int)
(declare-const k Int)

; A normal's component: its square is at most the length's, which square_ok() has let through.
(push)
(assert (and (<= (* a a) length) (<= length (+ 268435456 65536 4))))
(assert (not (<= (- 16386) a 16386)))
(check-sat)
(pop)

; The k-th product of two such, and the sum with what is within k times its bound.
(assert (and (<= (- 16386) a 16386) (<= (- 16386) b 16386) (<= 0 k 2)))
(assert (and (<= (* (- k) 536870912) dot) (<= dot (* k 536870912))))
; a b of a, b in a square: what a solver of linear arithmetic is told of products
(define-fun product ((x Int) (y Int)) Bool (=> (and (>= x 0) (>= y 0)) (>= (* x y) 0)))
(assert (and (product (- 16386 a) (- 16386 b)) (product (+ 16386 a) (+ 16386 b))))
(assert (and (product (- 16386 a) (+ 16386 b)) (product (+ 16386 a) (- 16386 b))))
(push)
(assert (not (and (<= (- 536870912) (* a b) 536870912) (<= (- 2147483648) (+ dot (* a b)) 2147483647))))
(check-sat)
(pop)
(push)
(define-fun next () Int (+ dot (* a b)))
(assert (<= (- 536870912) (* a b) 536870912))
(assert (not (and (<= (* (- (+ k 1)) 536870912) next) (<= next (* (+ k 1) 536870912)))))
(check-sat)
(pop)
(push) ; behind the loop
(declare-const all Int)
(assert (<= (* (- 3) 536870912) all (* 3 536870912)))
(assert (not (<= (- 2147483648) (- 268435456 all) 2147483647)))
(check-sat)
(pop)
