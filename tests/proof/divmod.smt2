; SPDX-License-Identifier: MIT
; The quotient that C rounds to zero, made a floor. Each question denies what is to be shown: unsat.
; source: firmware/fixed/fixed.h
; code: int32_t q = num / den; int32_t r = num - q * den; /* |q den| <= |num|, |r| < den */ int32_t below = r >> 31;
; code: *quotient = q + below; *remainder = r + (below & den);
; shows: fx_divmod_floor: signed_overflow: -2147483648 ≤ q * den
; shows: fx_divmod_floor: signed_overflow: q * den ≤ 2147483647
; shows: fx_divmod_floor: signed_overflow: -2147483648 ≤ num - (int32_t)(q * den)
; shows: fx_divmod_floor: signed_overflow: num - (int32_t)(q * den) ≤ 2147483647
; shows: fx_divmod_floor: signed_overflow: r + (int)(below & den) ≤ 2147483647
; shows: fx_divmod_floor: postcondition: floor: *\old(quotient) * \old(den) + *\old(remainder) ≡ \old(num)
; shows: fx_divmod_floor: postcondition: rest: 0 ≤ *\old(remainder) < \old(den)
; shows: fx_divmod_floor: postcondition: above: \old(num) ≥ 0 ⇒ 0 ≤ *\old(quotient) ≤ \old(num)
; shows: fx_divmod_floor: postcondition: below: \old(num) < 0 ⇒ \old(num) ≤ *\old(quotient) ≤ -1
(declare-const num Int)
(declare-const den Int)
(define-fun size () Int (ite (>= num 0) num (- num)))
(declare-const whole Int) ; size / den
(assert (and (<= size (+ 1073741824 524288)) (<= 1 den 1073741824)))
(assert (and (<= 0 (- size (* whole den))) (< (- size (* whole den)) den)))
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (product (- (- whole) 1) den))
(assert (and (product whole den) (product whole (- den 1))))
(define-fun q () Int (ite (>= num 0) whole (- whole)))
(define-fun qd () Int (ite (>= num 0) (* whole den) (- (* whole den)))) ; q den
(define-fun r () Int (- num qd))
(define-fun quotient () Int (ite (< r 0) (- q 1) q))
(define-fun remainder () Int (ite (< r 0) (+ r den) r))
(push)
(assert (not (and (<= (- size) qd size) (< (- den) r den) (<= (- size) r size))))
(check-sat)
(pop)
(push)
(assert (not (and (<= 0 remainder) (< remainder den)
                  (= (+ (ite (< r 0) (- qd den) qd) remainder) num))))
(check-sat)
(pop)
(push)
(assert (not (ite (>= num 0) (<= 0 quotient num) (<= num quotient (- 1)))))
(check-sat)
(pop)
