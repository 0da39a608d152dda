; SPDX-License-Identifier: MIT
; Texture coordinates of parts: shares that sum to 1 at most, values and bulges as a part's channel takes them. Each
; question denies what is to be shown: unsat.
; source: firmware/shade/perspective.c
; code: closeness[k] = depth > DEPTH_FAR ? depth - DEPTH_FAR : 1;
; source: firmware/shade/uv.c
; code: uv->s[k] = uv->distant ? 0x8000 : perspective.s[k];
; code: const uint32_t sum = si + sj, difference = si > sj ? si - sj : sj - si; /* sum below 2^17 and not 0 */ const unsigned up = fx_clz(sum); const int32_t ratio = fx_s32(fx_mulhi_u32(difference << up, fx_recip_norm(sum << up)) >> 1); return si > sj ? ratio : -ratio; }
; source: firmware/raster/split.c
; code: const uint32_t a = piece->weight[k][0], b = piece->weight[k][1], c = PART_ONE - a - b; const uint32_t wa = a * whole->s[0], wb = b * whole->s[1], wc = c * whole->s[2]; /* Q31, together below 2^31 */ const uint32_t sum = wa + wb + wc; const unsigned up = fx_clz(sum); const uint32_t inverse = fx_recip_norm(sum << up);
; code: const int32_t p = fx_s32(fx_mulhi_u32(wa << up, inverse) >> 1); const int32_t q = fx_s32(fx_mulhi_u32(wb << up, inverse) >> 1);
; code: out->value[axis][k] = fx_s32(rest + (((whole->value[axis][0] - rest) * p + (whole->value[axis][1] - rest) * q) >> 30)); } out->s[k] = fx_u16(sum >> 15); }
; code: const int64_t d = fx_s64(u[k]) - u[0]; most |= d < 0 ? -d : d; } while (most >> down > (1 << 13) - 2) down++;
; code: terms->value[k] = fx_s32((fx_s64(u[k]) - u[0] + (1 << (down - 1))) >> down); terms->bulge[k] = fx_s32(-(((fx_s64(u[k]) - u[next]) * uv_ratio(uv->s[k], uv->s[next])) >> (15 + down)));
; code: more = bad && depth < SPLIT_DEPTH && part_height(place) >= LEAST_HEIGHT;
; code: if (more) { depth++; way <<= 2; continue; } for (; depth && (way & 3) == 3; depth--) way >>= 2; if (!depth) return drawn; way++; }
; by part_corners.smt2
; shows: take_places: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; by what follows
; shows: fx_clz: precondition of __builtin_clz: x_nonzero: x ≢ 0
; shows: find_corners: precondition of fx_recip_norm: m ≥ 0x80000000
; shows: find_corners: signed_overflow: -9223372036854775808 ≤ (int64_t)((int64_t)((int64_t)whole->value[axis][0] - rest) * (int64_t)p) + (int64_t)((int64_t)((int64_t)whole->value[axis][1] - rest) * (int64_t)q)
; shows: find_corners: signed_overflow: (int64_t)((int64_t)((int64_t)whole->value[axis][0] - rest) * (int64_t)p) + (int64_t)((int64_t)((int64_t)whole->value[axis][1] - rest) * (int64_t)q) ≤ 9223372036854775807
; shows: set_part: precondition of part_channel: values: q14(*(value + 0)) ∧ q14(*(value + 1)) ∧ q14(*(value + 2))
; shows: set_part: precondition of part_channel: bulges: q28(*(bulge + 0)) ∧ q28(*(bulge + 2)) ∧ -0x20000000 ≤ *(bulge + 1) ≤ 0x20000000
; shows: find_piece: shift: 0 ≤ (unsigned int)((unsigned int)(2 * depth) - 2) < 32
; shows: uv_ratio: precondition of fx_recip_norm: m ≥ 0x80000000
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))

; What is moved up by its leading zeros has none.
(push)
(declare-const x (_ BitVec 32))
(declare-const n (_ BitVec 32))
(assert (and (bvule n #x0000001f) (= (bvlshr x (bvsub #x0000001f n)) #x00000001)))
(assert (not (bvuge (bvshl x n) #x80000000)))
(check-sat)
(pop)

; Corners' si are at least 1: so is their mean by a part's weights, and below 2^16.
(push)
(declare-const a Int)
(declare-const b Int)
(declare-const s0 Int)
(declare-const s1 Int)
(declare-const s2 Int)
(define-fun c () Int (- 32768 a b))
(define-fun sum () Int (+ (* a s0) (* b s1) (* c s2)))
(assert (and (<= 0 a) (<= 0 b) (<= 0 c) (<= 1 s0 65535) (<= 1 s1 65535) (<= 1 s2 65535)))
(assert (and (product a (- s0 1)) (product b (- s1 1)) (product c (- s2 1))
             (product a (- 65535 s0)) (product b (- 65535 s1)) (product c (- 65535 s2))))
(assert (not (and (<= 1 sum 2147483647) (<= 1 (div sum 32768) 65535))))
(check-sat)
(pop)

; m times its reciprocal passes 2^63 by 2^-30.66 of that at most (tests/tools/prove_bounds.py): so shares of m, rounded
; down to Q30, sum to 1 at most, and a difference's ratio is within 1.
(push)
(declare-const m Int)
(declare-const inverse Int)
(declare-const wa Int)
(declare-const wb Int)
(declare-const p Int)
(declare-const q Int)
(assert (and (<= 2147483648 m 4294967295) (<= 2147483648 inverse 4294967295)
             (<= (* m inverse) (+ 9223372036854775808 5440000000))))
(assert (and (<= 0 wa) (<= 0 wb) (<= (+ wa wb) m) (product (- m wa wb) inverse)))
(assert (and (<= (* p 8589934592) (* wa inverse)) (<= (* q 8589934592) (* wb inverse))))
(assert (not (<= (+ p q) 1073741824)))
(check-sat)
(pop)
(push) ; so what they make of three values is between these
(declare-const p Int)
(declare-const q Int)
(declare-const u Int)
(declare-const v Int)
(declare-const rest Int)
(define-fun value ((u Int)) Bool (<= (- 2147483648) u 2147483647))
(define-fun sum () Int (+ (* (- u rest) p) (* (- v rest) q)))
(assert (and (<= 0 p) (<= 0 q) (<= (+ p q) 1073741824) (value u) (value v) (value rest)))
(define-fun r () Int (- 1073741824 p q))
(assert (and (product (- 2147483647 u) p) (product (+ 2147483648 u) p) (product (- 2147483647 v) q)
             (product (+ 2147483648 v) q) (product (- 2147483647 rest) r) (product (+ 2147483648 rest) r)))
(push)
(assert (and (product (- 4294967295 (- u rest)) p) (product (+ 4294967295 (- u rest)) p)
             (product (- 4294967295 (- v rest)) q) (product (+ 4294967295 (- v rest)) q)))
(assert (not (<= (- 4611686018427387904) sum 4611686018427387904)))
(check-sat)
(pop)
(assert (not (value (+ rest (div sum 1073741824)))))
(check-sat)
(pop)

; Terms: differences from corner 0, of which none moved down by k = 2^down is over 2^13 - 2; a ratio within 1 in Q30.
(push)
(declare-const d Int) ; u1 - u0
(declare-const e Int) ; u2 - u0
(declare-const k Int)
(declare-const ratio Int)
(declare-const bulge Int)
(define-fun size ((x Int)) Int (ite (< x 0) (- x) x))
(assert (and (<= 256 k) (< (size d) (* 8191 k)) (< (size e) (* 8191 k)) (<= (- 1073741824) ratio 1073741824)))
(push)
(declare-const value Int)
(assert (and (<= (* 2 value k) (+ (* 2 d) k)) (< (+ (* 2 d) k) (+ (* 2 value k) (* 2 k)))))
(assert (and (product (- value 8193) k) (product (- (- 8193) value) k)))
(assert (not (<= (- 18432) value 18432)))
(check-sat)
(pop)
(define-fun bulge_of ((x Int)) Bool
  (and (<= (* bulge 32768 k) (* x ratio)) (< (* x ratio) (+ (* bulge 32768 k) (* 32768 k)))
       (product (- 1073741824 ratio) (+ (size x) x)) (product (+ 1073741824 ratio) (+ (size x) x))
       (product (- 1073741824 ratio) (- (size x) x)) (product (+ 1073741824 ratio) (- (size x) x))))
(push)
(assert (bulge_of d))
(assert (and (product (- bulge 268435456) k) (product (- (- 268435456) bulge) k)))
(assert (not (<= (- 268435456) bulge 268435456)))
(check-sat)
(pop)
(push) ; of the edge between the others, whose difference is that of two
(assert (bulge_of (- d e)))
(assert (and (product (- bulge 536870912) k) (product (- (- 536870912) bulge) k)))
(assert (not (<= (- 536870912) bulge 536870912)))
(check-sat)
(pop)
(pop)

; It goes down from depths below SPLIT_DEPTH alone: shifts are at most 2 4 - 2.
(push)
(declare-const depth Int)
(declare-const more Bool)
(assert (and (<= 0 depth 4) (=> more (< depth 4))))
(assert (not (<= 0 (ite more (+ depth 1) depth) 4)))
(check-sat)
(pop)
