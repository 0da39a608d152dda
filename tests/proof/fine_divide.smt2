; SPDX-License-Identifier: MIT
; A quotient by the leading 18 bits of a divisor is off by one at most. Each question denies what is to be shown: unsat.
; source: firmware/raster/fine.c
; code: int down = 14 - fx_s32(fx_clz(fx_u32(d))); int32_t q, unused; down = down < 0 ? 0 : down; fx_divmod_floor(fx_s32(n >> down), d >> down, &q, &unused);
; code: int64_t left = n - fx_s64(q) * d; for (; left < 0; left += d) q--; for (; left >= d; left -= d) q++; *rest = fx_s32(left); return q; }
; shows: divide: signed_overflow: -2147483648 ≤ q - 1
; shows: divide: signed_overflow: q + 1 ≤ 2147483647
; shows: divide: postcondition: rest: 0 ≤ *\old(rest) < \old(d)
; shows: divide: postcondition: quotient: \result * \old(d) + *\old(rest) ≡ \old(n)
(declare-const n Int)
(declare-const d Int)
(declare-const q Int)
(declare-const t Int) ; floor(n / d)
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (and (<= 1 d 1073741824) (<= (* (- 4096) d) n (* 4096 d)) (<= (* t d) n) (< n (+ (* t d) d))))
(assert (and (product (- t 4097) d) (product (- (- 4097) t) d)))

; With k = 2^down the short division is one by D = d >> down << down, of 17 bits at least above the lowest that are lost,
; or the division itself.
(push)
(declare-const k Int)
(declare-const D Int)
(define-fun lost () Int (- d D))
(assert (and (<= 1 k) (<= 0 lost) (< lost k) (>= D (* 131072 k))))
(assert (and (<= (* q D) n) (< n (+ (* q D) D))))
(push)
(assert (and (product (- q 4098) D) (product (- (- 4098) q) D) (= (* q d) (+ (* q D) (* q lost)))))
(assert (not (<= (- 4097) q 4097)))
(check-sat)
(pop)
(assert (<= (- 4097) q 4097))
(assert (= (* q d) (+ (* q D) (* q lost))))
(assert (and (product (- 4097 q) lost) (product (+ 4097 q) lost)))
(assert (and (product (- q t 2) d) (product (- t q 2) d)))
(assert (not (<= (- t 1) q (+ t 1))))
(check-sat)
(pop)
(push)
(assert (and (<= (* q d) n) (< n (+ (* q d) d)) (product (- q t 1) d) (product (- t q 1) d)))
(assert (not (= q t)))
(check-sat)
(pop)

; Each loop turns once at most, and ends at the floor.
(assert (or (= q (- t 1)) (= q t) (= q (+ t 1))))
(define-fun left () Int (- n (* q d)))
(define-fun up () Int (ite (< left 0) (- q 1) q))
(define-fun down () Int (ite (>= (- n (* up d)) d) (+ up 1) up))
(push)
(assert (not (and (<= 0 (- n (* down d))) (< (- n (* down d)) d) (= down t) (<= (- 4098) down 4098))))
(check-sat)
(pop)
