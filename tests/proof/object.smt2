; SPDX-License-Identifier: MIT
; Ways to a near point, made 30 bits long. Each question denies what is to be shown: unsat.
; source: firmware/geometry/object.c
; code: largest |= fx_u32(way[i] < 0 ? -way[i] : way[i]); }
; code: const int32_t up = 1 << (fx_clz(largest) - 2); for (int i = 0; i < 3; i++) { way[i] *= up; squared += fx_u32(fx_mulhi_s32(way[i], way[i])); }
; code: const unsigned even = fx_clz(squared) & ~1u; const int32_t inverse = fx_s32(fx_rsqrt_norm(squared << even) >> 1), scale = 1 << (even / 2 - 1); for (int i = 0; i < 3; i++) out[i] = fx_mulhi_s32(way[i], inverse) * scale; }
; shows: object_towards: signed_overflow: -2147483648 ≤ way[i_1] * up
; shows: object_towards: signed_overflow: way[i_1] * up ≤ 2147483647
; shows: proof_clz: user assertion: x ≢ 0
; shows: object_towards: shift: 0 ≤ (unsigned int)((unsigned int)(even / 2) - 1) < 32
; shows: object_towards: signed_overflow: -2147483648 ≤ tmp_6 * scale
; shows: object_towards: signed_overflow: tmp_6 * scale ≤ 2147483647

; Of three numbers, one is at least the largest power of 2 in their bits together, and none is twice that.
(push)
(declare-const a (_ BitVec 32))
(declare-const b (_ BitVec 32))
(declare-const c (_ BitVec 32))
(declare-const power (_ BitVec 32))
(define-fun all () (_ BitVec 32) (bvor a b c))
(assert (and (bvult all #x20000000) (= (bvand power (bvsub power #x00000001)) #x00000000)))
(assert (and (bvuge all power) (bvult all (bvshl power #x00000001))))
(define-fun under ((x (_ BitVec 32))) Bool (bvult x (bvshl power #x00000001)))
(assert (not (and (or (bvuge a power) (bvuge b power) (bvuge c power)) (under a) (under b) (under c))))
(check-sat)
(pop)

; A number below twice the power, times up = 2^29 / power: below 2^30 in size, that one at least 2^29. The high word of
; its square: below 2^28, of that one at least 2^26.
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(declare-const way Int) ; in size
(push)
(declare-const power Int)
(declare-const up Int)
(assert (and (= (* power up) 536870912) (<= 1 up) (<= 1 power) (<= 0 way)))
(assert (and (product (- (* 2 power) way 1) up) (product (- way power) up)))
(assert (not (and (=> (< way (* 2 power)) (< (* way up) 1073741824)) (=> (>= way power) (>= (* way up) 536870912)))))
(check-sat)
(pop)
(push)
(assert (and (<= 0 way 1073741823) (product way way) (product (- 1073741823 way) (+ 1073741823 way))
             (product (- way 536870912) (+ way 536870912))))
(define-fun high () Int (div (* way way) 4294967296))
(assert (not (and (<= 0 high 268435455) (=> (>= way 536870912) (>= high 67108864)))))
(check-sat)
(pop)

; So their sum has 27 to 30 bits: 2 to 5 zeros before them, `even` 2 or 4, `scale` 1 or 2.
(push)
(declare-const squared (_ BitVec 32))
(assert (and (bvuge squared #x04000000) (bvule squared #x30000000)))
(assert (not (and (not (= squared #x00000000)) (bvult squared #x40000000) (bvuge squared #x04000000))))
(check-sat)
(pop)
(push)
(declare-const zeros Int)
(define-fun even () Int (* 2 (div zeros 2)))
(define-fun shift () Int (- (div even 2) 1))
(assert (<= 2 zeros 5))
(assert (not (<= 0 shift 1)))
(check-sat)
(pop)
(push)
(declare-const inverse Int)
(declare-const t Int) ; way * inverse
(declare-const scale Int)
(assert (and (<= 0 way 1073741823) (<= 0 inverse 1073741824) (= t (* way inverse)) (<= 1 scale 2)))
(assert (and (product way inverse) (product (- 1073741823 way) inverse)))
(define-fun high () Int (div t 4294967296))
(define-fun low () Int (div (- t) 4294967296))
(assert (not (and (<= 0 high 268435456) (<= (- 268435456) low 0))))
(check-sat)
(pop)
