; SPDX-License-Identifier: MIT
; Points of a triangle in its mesh, by weights that sum to 2^15 (part_weights(): each, whole). What shades corners and finds
; their places takes those that part_corners.smt2 is about. The question denies what is to be shown: unsat.
; source: firmware/raster/draw_highlight.c
; code: struct highlighted_point point = {{0, 0, 0}, {0, 0, 0}};
; code: part_weights(in, corner, weight); for (int k = 0; k < 3; k++) { const struct scene_vertex *vertex = &in->vertices[in->triangle->corner[SHADE_TURN(k)]]; for (int i = 0; i < 3; i++) { /* weights sum to 2^15: at most 2^30 */ point.place[i] += vertex->position[i] * weight[k]; point.normal[i] += vertex->normal[i] * weight[k]; } } for (int i = 0; i < 3; i++) { point.place[i] >>= 15; point.normal[i] >>= 15; } return point; }
; by part_corners.smt2
; shows: is_short: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: is_short: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: point_of: precondition of part_weights: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: find_summit: precondition of part_shade: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; by what follows
; shows: point_of: signed_overflow: -2147483648 ≤ point.place[i] + (int)((int)vertex->position[i] * (int)weight[k])
; shows: point_of: signed_overflow: point.place[i] + (int)((int)vertex->position[i] * (int)weight[k]) ≤ 2147483647
; shows: find_summit: precondition of summit_find: normals: ∀ ℤ k, ℤ i; 0 ≤ k < 3 ∧ 0 ≤ i < 3 ⇒ -16386 ≤ (corner + k)->normal[i] ≤ 16386
; shows: find_summit: precondition of summit_find: places: ∀ ℤ k, ℤ i; 0 ≤ k < 3 ∧ 0 ≤ i < 3 ⇒ -0x8000 ≤ (corner + k)->place[i] ≤ 0x7fff
(declare-const u Int)
(declare-const v Int)
(define-fun w () Int (- 32768 u v))
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
(declare-const least Int)
(declare-const most Int)
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (and (<= 0 u) (<= 0 v) (<= 0 w) (<= least a most) (<= least b most) (<= least c most)))
(assert (or (and (= least (- 32768)) (= most 32767)) (and (= least (- 16386)) (= most 16386)))) ; places, normals
(assert (and (product u (- 32767 a)) (product v (- 32767 b)) (product w (- 32767 c))
             (product u (+ 32768 a)) (product v (+ 32768 b)) (product w (+ 32768 c))
             (product u (- 16386 a)) (product v (- 16386 b)) (product w (- 16386 c))
             (product u (+ 16386 a)) (product v (+ 16386 b)) (product w (+ 16386 c))))
(define-fun whole () Int (+ (* u a) (* v b) (* w c)))
(assert (not (and (<= (- 1073741824) (* u a) 1073741824) (<= (- 1073741824) (+ (* u a) (* v b)) 1073741824)
                  (<= (- 1073741824) whole 1073741824) (<= least (div whole 32768) most))))
(check-sat)
