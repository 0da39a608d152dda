; SPDX-License-Identifier: MIT
; The fog's offset B, in Q16: within 0..2^30. Each question denies what is to be shown: unsat.
; source: firmware/plan/fog.c
; code: #define ONE (1 << 16)
; code: #define THINNEST 13
; code: if (fog->kind == FOG_LINEAR && fx_u32(from->from) >= far) fog->kind = FOG_NONE; if (fog->kind == FOG_NONE) return; const uint32_t thinnest = (fog->divides ? fx_u32(from->from) : far) >> THINNEST; uint32_t thickness = fx_u32(from->to - from->from); thickness = thickness > thinnest ? thickness : thinnest;
; code: const int64_t to_far = fog->divides ? from->from : fx_s64(far) - from->from; fog->offset = fx_s32(fx_divide_s64(to_far * ONE, thickness));
; shows: fog_begin: precondition of error_of: offset: 0 ≤ fog->offset ≤ 1 << 30
; shows: fx_divide_s64: precondition of fx_divide_u64: d > 0
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(push)
(declare-const from Int)
(declare-const to Int)
(declare-const far Int)
(declare-const divides Bool)
(assert (and (<= 0 from) (< from to 2147483648) (< from far 2147483648)))
(define-fun reach () Int (ite divides from far))
(define-fun thinnest () Int (div reach 8192))
(define-fun thickness () Int (ite (> (- to from) thinnest) (- to from) thinnest))
(define-fun to_far () Int (ite divides from (- far from)))
(push)
(assert (not (>= thickness 1)))
(check-sat)
(pop)
(declare-const offset Int) ; to_far 2^16 / thickness
(declare-const thick Int)
(assert (and (= thick thickness) (<= 0 (- (* 65536 to_far) (* offset thick))) (< (- (* 65536 to_far) (* offset thick)) thick)))
(assert (and (product (- (- offset) 1) thick) (product (- offset 1073741825) thick)))
(assert (not (<= 0 offset 1073741824)))
(check-sat)
(pop)

; Numbers of 32 bits: what they are moved by stays small, as they are made of given ones (0 to 32) by at most three
; products and quotients, one of another.
; code: for (; x >> 32 == 0; down++) x <<= 1; for (; x >> 32; down--) /* at most 31 bits go */ x >>= 1; return (struct scaled){fx_u32(x), down}; }
; code: return scaled_of(fx_u64(a.m) * b.m, a.down + b.down); }
; code: return scaled_of(fx_divide_u64(fx_u64(a.m) << 31, b.m), a.down + 31 - b.down); }
; code: error = q16_of(quotient(exponential ? scaled_of(25, 5) : scaled_of(reach * reach, 32), a)); } else { error = q16_of(a) / 2; }
; code: return product(scaled_of(fog->divides || density < most ? density : most, 24), (struct scaled){LOG2_E, 31}); }
; code: const struct scaled depths = scaled_of(DEPTHS, 0); const struct scaled per_unit = fog->kind == FOG_LINEAR ? quotient(scaled_of(1, 0), scaled_of(thickness, 16)) : density_of(fog, scene); if (fog->divides) return product(product(scaled_of(fx_u32(camera->near_plane), 16), depths), per_unit); return product(quotient(scaled_of(fx_u32(camera->far_plane - camera->near_plane), 16), depths), per_unit); }
; code: fog->offset = q16_of(product(scaled_of(far, 16), density_of(fog, scene)));
; shows: scaled_of: signed_overflow: down + 1 ≤ 2147483647
; shows: scaled_of: signed_overflow: -2147483648 ≤ down - 1
; shows: product: signed_overflow: -2147483648 ≤ a.down + b.down
; shows: product: signed_overflow: a.down + b.down ≤ 2147483647
; shows: quotient: precondition of fx_divide_u64: d > 0
; shows: quotient: signed_overflow: (int)(a.down + 31) - b.down ≤ 2147483647
; shows: quotient: signed_overflow: -2147483648 ≤ (int)(a.down + 31) - b.down
; shows: quotient: signed_overflow: a.down + 31 ≤ 2147483647
; shows: q16_of: signed_overflow: -2147483648 ≤ a.down - 16
(push) ; upwards: a number of 1 and more is at least 2^i after i steps, so it takes 32 at most to 2^32
(declare-const x Int)
(declare-const power Int)
(assert (and (<= 1 power x) (< x 4294967296)))
(assert (not (and (<= (* 2 power) (* 2 x)) (< (* 2 x) 8589934592) (< power 4294967296))))
(check-sat)
(pop)
(push) ; downwards: below 2^(64 - i) after i steps; it ends between 2^31 and 2^32, not 0
(declare-const x Int)
(assert (<= 4294967296 x))
(assert (not (<= 2147483648 (div x 2))))
(check-sat)
(pop)
(define-fun moved ((to Int) (down Int)) Bool (<= (- down 32) to (+ down 32)))
(define-fun given ((d Int)) Bool (or (= d 31) (exists ((down Int)) (and (<= 0 down 32) (moved d down)))))
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
(declare-const d Int)
(declare-const one Int)
(declare-const two Int)
(declare-const three Int)
(define-fun made ((to Int) (p Int) (q Int)) Bool (or (moved to (+ p q)) (moved to (- (+ p 31) q))))
(assert (and (given a) (given b) (given c) (given d) (made one a b)))
(assert (or (made two one c) (made two c one)))
(assert (or (made three two one) (made three two d) (made three d two)))
(define-fun small ((x Int)) Bool (<= (- 1000) x 1000))
(assert (not (and (small a) (small one) (small two) (small three))))
(check-sat)
