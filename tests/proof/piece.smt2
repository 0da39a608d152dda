; SPDX-License-Identifier: MIT
; A piece's corner values lie between its source's, as its weights sum to 1. Each question denies what is to be shown:
; unsat.
; source: firmware/shade/piece.h
; code: w[k] are the barycentric weights of the piece's corner k in the triangle, Q15, * of sum 2^15.
; source: firmware/shade/piece.c
; code: int32_t sum = 0; for (int i = 0; i < 3; i++) sum += value[i] * w[k][i]; v[k] = sum >> 15;
; code: linear += value[i] * w[k][i];
; shows: piece_linear: signed_overflow: -2147483648 ≤ sum + (int32_t)(*(value + i) * (int32_t)(*(w + k))[i])
; shows: piece_linear: signed_overflow: sum + (int32_t)(*(value + i) * (int32_t)(*(w + k))[i]) ≤ 2147483647
; shows: piece_linear: postcondition: values: short3(\old(value))
; shows: piece_quadratic: signed_overflow: -2147483648 ≤ linear + (int32_t)(*(value + i) * (int32_t)(*(w + k))[i])
; shows: piece_quadratic: signed_overflow: linear + (int32_t)(*(value + i) * (int32_t)(*(w + k))[i]) ≤ 2147483647
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))

; One term.
(push)
(declare-const value Int)
(declare-const weight Int)
(assert (and (<= (- 32768) value 32767) (<= 0 weight 32768)))
(assert (and (product (+ 32768 value) weight) (product (- 32767 value) weight)))
(assert (not (<= (* (- 32768) weight) (* value weight) (* 32767 weight))))
(check-sat)
(pop)

; One, two and three of them.
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
(declare-const wa Int)
(declare-const wb Int)
(declare-const wc Int)
(define-fun term ((t Int) (w Int)) Bool (<= (* (- 32768) w) t (* 32767 w)))
(define-fun fits ((sum Int)) Bool (<= (- 2147483648) sum 2147483647))
(assert (and (<= 0 wa) (<= 0 wb) (<= 0 wc) (= (+ wa wb wc) 32768) (term a wa) (term b wb) (term c wc)))
(assert (not (and (fits a) (fits (+ a b)) (fits (+ a b c)) (<= (- 32768) (div (+ a b c) 32768) 32767))))
(check-sat)
