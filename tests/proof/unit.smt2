; SPDX-License-Identifier: MIT
; Unit vectors in Q14. Each question denies what is to be shown: unsat.
; source: firmware/geometry/object.c
; code: largest |= fx_u32(v[i] < 0 ? -v[i] : v[i]);
; code: int up = fx_s32(fx_clz(largest)) - 17; int32_t w[3]; uint32_t squared = 0; for (int i = 0; i < 3; i++) { w[i] = up >= 0 ? v[i] * (1 << up) : v[i] >> -up; squared += fx_u32(w[i] * w[i]); } unsigned half_bits = squared >> 30 ? 0 : 1; int32_t inverse = fx_s32(fx_rsqrt_norm(squared << (2 * half_bits)) >> 1);
; code: out[i] = fx_s16(fx_mulhi_s32(w[i] * (1 << (half_bits + 2)), inverse) >> 1); }
; shows: object_unit: precondition of fx_rsqrt_norm: m ≥ 0x40000000
; shows: object_unit: postcondition: first: -16385 ≤ *(\old(out) + 0) ≤ 16385
; shows: object_unit: postcondition: second: -16385 ≤ *(\old(out) + 1) ≤ 16385
; shows: object_unit: postcondition: third: -16385 ≤ *(\old(out) + 2) ≤ 16385

; Of three numbers, one is at least the largest power of 2 in their bits together, and none above twice that.
(push)
(declare-const a (_ BitVec 32))
(declare-const b (_ BitVec 32))
(declare-const c (_ BitVec 32))
(declare-const power (_ BitVec 32))
(define-fun all () (_ BitVec 32) (bvor a b c))
(assert (and (bvult all #x80000000) (= (bvand power (bvsub power #x00000001)) #x00000000)))
(assert (and (bvuge all power) (bvult all (bvshl power #x00000001))))
(define-fun under ((x (_ BitVec 32))) Bool (bvult x (bvshl power #x00000001)))
(assert (not (and (or (bvuge a power) (bvuge b power) (bvuge c power)) (under a) (under b) (under c))))
(check-sat)
(pop)

; Moved by `up` that one has 15 bits, none has more: a sum of squares of 2^28 to 3 * 2^30, in 30 to 32 bits two up.
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(push)
(declare-const v Int)
(declare-const down Int) ; 2^-up
(declare-const w Int)
(assert (and (>= down 1) (<= (* w down) v) (< v (+ (* w down) down))))
(assert (and (product (- w 32768) down) (product (- (- w) 32769) down)))
(assert (and (product (- 16383 w) down) (product (+ w 16383) down)))
(push)
(assert (and (< v (* 32768 down)) (> v (* (- 32768) down))))
(assert (not (<= (- 32768) w 32767)))
(check-sat)
(pop)
(assert (or (>= v (* 16384 down)) (<= v (* (- 16384) down))))
(assert (not (or (>= w 16384) (<= w (- 16384)))))
(check-sat)
(pop)
(declare-const squared Int)
(define-fun m () Int (ite (>= squared 1073741824) squared (* 4 squared)))
(push)
(assert (<= 268435456 squared 3221225472))
(assert (not (<= 1073741824 m 4294967295)))
(check-sat)
(pop)

; With u = w 2^half_bits, u^2 <= m, and r = 2^46 / sqrt(m) within 2^-20.6 (proven by tools/prove_bounds.py), |u r| is at
; most 2^46 (1 + 2^-20), and the result, u (r / 2) 2^-31 rounded down twice, 2^14 and 1.
(declare-const u Int)
(declare-const u2 Int)
(declare-const r2 Int)
(declare-const ur Int)
(declare-const ur2 Int)
(define-fun most () Int (+ 70368744177664 67108864))
(assert (and (= ur2 (* u2 r2)) (= ur2 (* ur ur)) (<= 0 u2 m) (<= 0 r2)))
(assert (<= (* m r2) (+ 4951760157141521099596496896 9444732965739290427392)))
(assert (product (- m u2) r2))
(push)
(assert (and (product (- ur most) (+ ur most)) (product (- (- ur) most) (- most ur))))
(assert (not (<= (- most) ur most)))
(check-sat)
(pop)
(push)
(declare-const half Int) ; u (r >> 1)
(assert (and (<= (- most) ur most) (<= (- most) (* 2 half) most)))
(define-fun result () Int (div (div (* 4 half) 4294967296) 2))
(assert (not (<= (- 16385) result 16385)))
(check-sat)
(pop)
