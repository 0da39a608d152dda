; SPDX-License-Identifier: MIT
; A place of a piece, in Q15, and what its weights were rounded by. Each question denies what is to be shown: unsat.
; source: firmware/shade/piece.h
; code: w[k] are the barycentric weights of the piece's corner k in the triangle, Q15, * of sum 2^15.
; source: firmware/shade/piece.c
; code: const int32_t last = place[SHADE_TURN(2)][axis]; value = place[0][axis] * in->weight[k][0] + place[1][axis] * in->weight[k][1] + place[2][axis] * in->weight[k][2] + (((place[0][axis] - last) * finer[0] + (place[SHADE_TURN(1)][axis] - last) * finer[1]) >> 8);
; shows: piece_place_perspective: signed_overflow: (int)((int)((int)((int)*(place[0] + axis) * (int)(*(in->weight + k))[0]) + (int)((int)*(place[1] + axis) * (int)(*(in->weight + k))[1])) + (int)((int)*(place[2] + axis) * (int)(*(in->weight + k))[2])) + (int)((int)((int)((int)((int)*(place[0] + axis) - last) * (int)*(finer + 0)) + (int)((int)((int)*(place[tmp_2] + axis) - last) * (int)*(finer + 1))) >> 8) ≤ 2147483647
; shows: piece_place_perspective: signed_overflow: -2147483648 ≤ (int)((int)((int)((int)*(place[0] + axis) * (int)(*(in->weight + k))[0]) + (int)((int)*(place[1] + axis) * (int)(*(in->weight + k))[1])) + (int)((int)*(place[2] + axis) * (int)(*(in->weight + k))[2])) + (int)((int)((int)((int)((int)*(place[0] + axis) - last) * (int)*(finer + 0)) + (int)((int)((int)*(place[tmp_2] + axis) - last) * (int)*(finer + 1))) >> 8)
; shows: piece_place_perspective: signed_overflow: (int)((int)((int)*(place[0] + axis) * (int)(*(in->weight + k))[0]) + (int)((int)*(place[1] + axis) * (int)(*(in->weight + k))[1])) + (int)((int)*(place[2] + axis) * (int)(*(in->weight + k))[2]) ≤ 2147483647
; shows: piece_place_perspective: signed_overflow: -2147483648 ≤ (int)((int)((int)*(place[0] + axis) * (int)(*(in->weight + k))[0]) + (int)((int)*(place[1] + axis) * (int)(*(in->weight + k))[1])) + (int)((int)*(place[2] + axis) * (int)(*(in->weight + k))[2])
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(define-fun fits ((sum Int)) Bool (<= (- 2147483648) sum 2147483647))

; One term, of a weight or of what it was rounded by.
(push)
(declare-const place Int)
(declare-const weight Int)
(assert (and (<= (- 32768) place 32767) (<= 0 weight 32768)))
(assert (and (product (+ 32768 place) weight) (product (- 32767 place) weight)))
(assert (not (<= (* (- 32768) weight) (* place weight) (* 32767 weight))))
(check-sat)
(pop)
(push)
(declare-const apart Int)
(declare-const finer Int)
(assert (and (<= (- 65535) apart 65535) (<= (- 128) finer 127)))
(assert (and (product (- 65535 apart) (- 128 finer)) (product (- 65535 apart) (+ 128 finer))))
(assert (and (product (+ 65535 apart) (- 128 finer)) (product (+ 65535 apart) (+ 128 finer))))
(assert (not (<= (- 8388480) (* apart finer) 8388480)))
(check-sat)
(pop)

; All of them.
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
(declare-const wa Int)
(declare-const wb Int)
(declare-const wc Int)
(declare-const finer Int)
(define-fun term ((t Int) (w Int)) Bool (<= (* (- 32768) w) t (* 32767 w)))
(assert (and (<= 0 wa) (<= 0 wb) (<= 0 wc) (= (+ wa wb wc) 32768) (term a wa) (term b wb) (term c wc)))
(assert (<= (* 2 (- 8388480)) finer (* 2 8388480)))
(assert (not (and (fits (+ a b)) (fits (+ a b c)) (fits (+ a b c (div finer 256))))))
(check-sat)
