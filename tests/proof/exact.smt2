; SPDX-License-Identifier: MIT
; Barycentric weights: each at most 1 and all of them together 1. Each question denies what is to be shown: unsat.
; source: firmware/shade/plane.c
; code: plane->det = fx_u32(det); plane->up = fx_s32(fx_clz(fx_u32(det))); plane->r = fx_recip_norm(fx_u32(det) << plane->up);
; source: tests/tools/prove_bounds.py
; code: goals = [("fx_recip_norm: within 2^-30.44, above by 2^-30.66 at most",
; source: firmware/shade/plane_wide.c
; code: int32_t det = fx_s32(plane->det); nu = nu < 0 ? 0 : nu > det ? det : nu; nv = nv < 0 ? 0 : nv > det - nu ? det - nu : nv; /* n / det in Q31, then Q16: together at most 65536 and 2^-14, and so at most 65536. */ uint32_t u = fx_mulhi_u32(fx_u32(nu) << plane->up, plane->r) >> 15; uint32_t v = fx_mulhi_u32(fx_u32(nv) << plane->up, plane->r) >> 15; uint32_t w = 65536 - u - v;
; code: fx_wrap_shl(fx_wrap_u32(fx_mulhi_s32(value[0], fx_s32(w << 14)) + fx_mulhi_s32(value[1], fx_s32(u << 14)) + fx_mulhi_s32(value[2], fx_s32(v << 14))), 2);
; code: int32_t bend = fx_mulhi_s32(bulge[0], fx_s32(w * u)) + fx_mulhi_s32(bulge[1], fx_s32(u * v)) + fx_mulhi_s32(bulge[2], fx_s32(v * w));
; shows: exact_value: signed_overflow: (int32_t)(tmp_3 + tmp_4) + tmp_5 ≤ 2147483647
; shows: exact_value: signed_overflow: -2147483648 ≤ (int32_t)(tmp_3 + tmp_4) + tmp_5
; shows: exact_value: signed_overflow: tmp_6 + tmp_7 ≤ 2147483647
; shows: exact_value: signed_overflow: (int32_t)(tmp_6 + tmp_7) + tmp_8 ≤ 2147483647
; shows: exact_value: signed_overflow: -2147483648 ≤ (int32_t)(tmp_6 + tmp_7) + tmp_8
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))

; n / det in Q16, of two n that are in [0, det] together; nu, nv = n << up, m = det << up, r at most 2^63 / m (1 + 2^-30).
(push)
(declare-const nu Int)
(declare-const nv Int)
(declare-const m Int)
(declare-const r Int)
(assert (and (<= 0 nu) (<= 0 nv) (<= (+ nu nv) m) (<= 2147483648 m 4294967295) (<= 0 r 4294967295)))
(assert (<= (* m r) (+ 9223372036854775808 8589934592)))
(assert (and (product (- m nu nv) r) (product nu r) (product nv r)))
(define-fun weight ((n Int)) Int (div (div (* n r) 4294967296) 32768))
(assert (not (and (<= 0 (weight nu)) (<= 0 (weight nv)) (<= (+ (weight nu) (weight nv)) 65536))))
(check-sat)
(pop)

; The third weight.
(declare-const u Int)
(declare-const v Int)
(define-fun w () Int (- 65536 u v))
(assert (and (<= 0 u) (<= 0 v) (<= (+ u v) 65536)))
(push)
(assert (not (and (<= 0 v 65536) (<= 0 w 65536) (= (+ u v w) 65536))))
(check-sat)
(pop)

; The high word of a corner value and a weight in Q30 is within 2^13 times the weight.
(push)
(declare-const value Int)
(declare-const weight Int)
(assert (and (<= (- 2147483648) value 2147483647) (<= 0 weight 65536)))
(assert (and (product (- 2147483648 value) weight) (product (+ 2147483648 value) weight)))
(assert (not (<= (* (- 8192) weight) (div (* value weight 16384) 4294967296) (* 8192 weight))))
(check-sat)
(pop)
(define-fun term ((t Int) (weight Int)) Bool (<= (* (- 8192) weight) t (* 8192 weight)))
(push)
(declare-const tw Int)
(declare-const tu Int)
(declare-const tv Int)
(assert (and (term tw w) (term tu u) (term tv v)))
(assert (not (and (<= (- 2147483648) (+ tw tu) 2147483647) (<= (- 2147483648) (+ tw tu tv) 2147483647))))
(check-sat)
(pop)

; Of two weights the product is at most a quarter, 2^30, and what it takes of a bulge at most a quarter of 2^31.
(push)
(declare-const a Int)
(declare-const b Int)
(declare-const bulge Int)
(declare-const ab Int)
(assert (and (<= 0 a) (<= 0 b) (<= (+ a b) 65536) (= ab (* a b))))
(assert (>= (* (- a b) (- a b)) 0))
(assert (and (product (- 65536 a b) (+ a b)) (product (- 65536 a b) 65536) (product a b)))
(assert (not (<= 0 ab 1073741824)))
(check-sat)
(pop)
(push)
(declare-const ab Int)
(declare-const bulge Int)
(assert (and (<= 0 ab 1073741824) (<= (- 2147483648) bulge 2147483647)))
(assert (and (product (- 2147483648 bulge) ab) (product (+ 2147483648 bulge) ab)))
(define-fun part () Int (div (* ab bulge) 4294967296))
(assert (not (and (<= (- 536870912) part 536870912) (<= (* 3 536870912) 2147483647))))
(check-sat)
(pop)
