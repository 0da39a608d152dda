; SPDX-License-Identifier: MIT
; Normals and places by weights that sum to 2^15: those of part_weights() (each, whole), asked for by corners' weights
; (part_corners.smt2) and by those of the corners of a piece. Each question denies what is to be shown: unsat.
; source: firmware/list.c
; code: uint16_t rest = 1u << 15; /* the three sum to 1 */
; code: rounded = rounded > rest ? rest : rounded; rest = fx_u16(rest - rounded);
; code: piece->weight[c][i] = rounded;
; source: firmware/frame.c
; code: r->weight[k][SHADE_TURN(0)] = weight[0]; r->weight[k][SHADE_TURN(1)] = weight[1]; r->weight[k][SHADE_TURN(2)] = fx_u16((1u << 15) - weight[0] - weight[1]);
; source: firmware/shade/part.c
; code: int32_t sum[3] = {0, 0, 0}, place[3] = {0, 0, 0}; q14_t normal[3];
; code: part_weights(in, corner, weight); for (int k = 0; k < 3; k++) { const struct scene_vertex *vertex = &in->vertices[in->triangle->corner[SHADE_TURN(k)]]; for (int i = 0; i < 3; i++) { /* below 2^15 (1 + 2^-13) times 2^15 */ sum[i] += vertex->normal[i] * weight[k]; place[i] += vertex->position[i] * weight[k]; } }
; code: sum[i] >>= 1; /* |normals| <= 2^14 (1 + 2^-13): below 2^29 (1 + 2^-13) */ place[i] >>= 15; }
; by part_corners.smt2
; shows: part_shade: precondition of part_weights: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; by what follows
; shows: part_shade: precondition of part_weights: sums: sums(in)
; shows: part_shade: signed_overflow: -2147483648 ≤ place[i] + (int)((int)vertex_0->position[i] * (int)weight[k])
; shows: part_shade: signed_overflow: place[i] + (int)((int)vertex_0->position[i] * (int)weight[k]) ≤ 2147483647
; shows: object_light_at: user assertion: -0x8000 ≤ *(place + i) ≤ 0x7fff

; A piece's weights, any, each held to what is left of 2^15: the first two leave the third.
(push)
(declare-const a Int)
(declare-const b Int)
(define-fun held ((w Int) (rest Int)) Int (ite (> w rest) rest w))
(define-fun first () Int (held a 32768))
(define-fun next () Int (held b (- 32768 first)))
(assert (and (<= 0 a 65535) (<= 0 b 65535)))
(assert (not (and (<= 0 first) (<= 0 next) (<= 0 (- 32768 first next)))))
(check-sat)
(pop)

; A place of three 16-bit ones, each sum on the way too.
(declare-const u Int)
(declare-const v Int)
(define-fun w () Int (- 32768 u v))
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (and (<= 0 u) (<= 0 v) (<= 0 w) (<= (- 32768) a 32767) (<= (- 32768) b 32767) (<= (- 32768) c 32767)))
(assert (and (product u (- 32767 a)) (product v (- 32767 b)) (product w (- 32767 c))
             (product u (+ 32768 a)) (product v (+ 32768 b)) (product w (+ 32768 c))))
(define-fun whole () Int (+ (* u a) (* v b) (* w c)))
(push)
(assert (not (and (<= (- 1073741824) (* u a) 1073741824) (<= (- 1073741824) (+ (* u a) (* v b)) 1073741824)
                  (<= (- 1073741824) whole (* 32767 32768)) (<= (- 32768) (div whole 32768) 32767))))
(check-sat)
(pop)
