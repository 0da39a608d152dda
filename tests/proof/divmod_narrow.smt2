; SPDX-License-Identifier: MIT
; The floor by a division of unsigned numbers. Each question denies what is to be shown: unsat.
; source: firmware/fixed/fixed.h
; code: int32_t sign = num >> 31; uint32_t n = fx_u32(num ^ sign), d = fx_u32(den);
; code: uint32_t q = n / d; int32_t r = fx_s32(n - q * d); /* q d <= n */ *quotient = fx_s32(q) ^ sign; *remainder = sign ? den - 1 - r : r; }
; shows: fx_divmod_floor_narrow: signed_overflow: (int32_t)(den - 1) - r ≤ 2147483647
; shows: fx_divmod_floor_narrow: postcondition: floor: *\old(quotient) * \old(den) + *\old(remainder) ≡ \old(num)
; shows: fx_divmod_floor_narrow: postcondition: rest: 0 ≤ *\old(remainder) < \old(den)
; shows: fx_divmod_floor_narrow: postcondition: above: \old(num) ≥ 0 ⇒ 0 ≤ *\old(quotient) ≤ \old(num)
; shows: fx_divmod_floor_narrow: postcondition: below: \old(num) < 0 ⇒ \old(num) ≤ *\old(quotient) ≤ -1
(declare-const num Int)
(declare-const den Int)
(declare-const q Int)  ; n / d
(declare-const qd Int) ; q d
(define-fun flip ((x Int)) Int (ite (< num 0) (- (- 1) x) x)) ; x ^ sign
(define-fun n () Int (flip num))
(define-fun r () Int (- n qd))
(define-fun quotient () Int (flip q))
(define-fun product () Int (ite (< num 0) (- (- den) qd) qd)) ; quotient den
(define-fun remainder () Int (ite (< num 0) (- den 1 r) r))
(assert (and (<= (- 1074266112) num 1074266112) (<= 1 den 1073741824)))
(assert (and (<= 0 q) (= qd (* q den)) (<= 0 r) (< r den)))
(assert (>= (* q (- den 1)) 0))

(push) ; in 32 bits
(assert (not (and (<= 0 n 2147483647) (<= 0 qd n) (<= 0 q n) (<= 0 r 2147483647) (<= (- den 1 r) 2147483647))))
(check-sat)
(pop)
(push)
(assert (not (and (= product (* quotient den)) (= (+ product remainder) num) (<= 0 remainder) (< remainder den))))
(check-sat)
(pop)
(push)
(assert (not (ite (>= num 0) (<= 0 quotient num) (<= num quotient (- 1)))))
(check-sat)
(pop)
