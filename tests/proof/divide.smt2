; SPDX-License-Identifier: MIT
; Division a bit at a time. Each question denies what is to be shown: unsat.
; source: firmware/fixed/divide.c
; code: uint64_t quotient = 0, bit = 1; for (; d < n && !(d >> 63); d <<= 1) bit <<= 1; for (; bit; bit >>= 1, d >>= 1) if (n >= d) { n -= d; quotient |= bit; } return quotient; }
; shows: fx_divide_u64: postcondition: quotient: \result ≡ \old(n) / \old(d)
(declare-const n Int)        ; what is left of it
(declare-const d Int)        ; divisor * bit
(declare-const whole Int)    ; n as it was
(declare-const divisor Int)  ; d as it was
(declare-const bit Int)
(declare-const quotient Int)
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(define-fun end () Int 18446744073709551616)
(assert (and (<= 1 divisor) (< d end) (<= 0 n) (< n end)))

; Upwards: d is the divisor times the bit; neither loses one.
(push)
(assert (and (= d (* divisor bit)) (<= 1 bit) (< d 9223372036854775808) (product (- divisor 1) (- bit 1))))
(assert (not (and (= (* 2 d) (* divisor (* 2 bit))) (< (* 2 d) end) (< (* 2 bit) end))))
(check-sat)
(pop)
; In the end it is more than half of n.
(push)
(assert (and (<= 1 d) (or (>= d n) (>= d 9223372036854775808))))
(assert (not (< n (* 2 d))))
(check-sat)
(pop)

; Downwards: quotient * divisor and what is left are the whole, and that is less than d after each step.
(push)
(declare-const product_q Int) ; quotient * divisor
(assert (and (= (+ product_q n) whole) (< n (* 2 d)) (>= d 1)))
(define-fun taken () Bool (>= n d))
(define-fun left () Int (ite taken (- n d) n))
(define-fun product_next () Int (ite taken (+ product_q d) product_q)) ; (quotient + bit) * divisor
(assert (not (and (= (+ product_next left) whole) (<= 0 left) (< left d))))
(check-sat)
(pop)
(push) ; to the next bit, none of d's is lost
(declare-const half Int)
(assert (and (= bit (* 2 half)) (= d (* 2 (* divisor half)))))
(assert (not (= (div d 2) (* divisor half))))
(check-sat)
(pop)
(push) ; the quotient has bits above this one only: one that is set is added
(declare-const q (_ BitVec 64))
(declare-const b (_ BitVec 64))
(define-fun one () (_ BitVec 64) #x0000000000000001)
(assert (and (not (= b #x0000000000000000)) (= (bvand b (bvsub b one)) #x0000000000000000)))
(assert (= (bvand q (bvsub (bvshl b one) one)) #x0000000000000000))
(assert (not (and (= (bvor q b) (bvadd q b)) (= (bvand (bvor q b) (bvsub b one)) #x0000000000000000))))
(check-sat)
(pop)

; At bit 1 less than the divisor is left: it is the quotient.
(push)
(declare-const true_q Int)
(assert (and (= (+ (* quotient divisor) n) whole) (< n divisor)))
(assert (and (<= (* true_q divisor) whole) (< whole (+ (* true_q divisor) divisor))))
(assert (and (product (- quotient true_q 1) divisor) (product (- true_q quotient 1) divisor)))
(assert (not (= quotient true_q)))
(check-sat)
(pop)
