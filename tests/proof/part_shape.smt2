; SPDX-License-Identifier: MIT
; A part's shape: what shape_of() asks of scaled(), and what height_of() divides by. Each question denies what is to be
; shown: unsat.
; source: firmware/shade/part.c
; code: return fx_u32(v < 0 ? -v : v); }
; code: x = x * (1 << up) >> down; return x + (x == -(1 << 14)); }
; code: struct shape s = {p[1].x - p[0].x, p[1].y - p[0].y, p[2].x - p[0].x, p[2].y - p[0].y, 0, 0, 0}; const uint32_t largest = size_of(s.x1) | size_of(s.y1) | size_of(s.x2) | size_of(s.y2); const int scale = largest ? fx_s32(fx_clz(largest)) - 18 : 0, down = scale < 0 ? -scale : 0, up = scale > 0 ? scale : 0; s.lost = ((s.x1 | s.y1 | s.x2 | s.y2) & ((1 << down) - 1)) != 0; s.x1 = scaled(s.x1, up, down); s.y1 = scaled(s.y1, up, down); s.x2 = scaled(s.x2, up, down); s.y2 = scaled(s.y2, up, down); s.scale = scale + 15; s.det = s.x1 * s.y2 - s.x2 * s.y1; /* that of a triangle in a box of 2^15: below 2^30 */ return s; }
; code: uint32_t a = size_of(x), b = size_of(y); return a > b ? a + b / 2 : b + a / 2; }
; code: uint32_t a = length_of(s->x1, s->y1), b = length_of(s->x2, s->y2), c = length_of(s->x2 - s->x1, s->y2 - s->y1); a = a > b ? a : b; a = a > c ? a : c; /* below 2^16 */ if (s->det <= 0) return 0; uint32_t height = fx_u32(s->det) / a; return fx_s32(s->scale >= 0 ? height >> s->scale : height << -s->scale); }
; code: const struct shape s = shape_of(p); return height_of(&s); }
; of x1, y1, x2, y2
; shows: shape_of: precondition of scaled: shifts: 0 ≤ up ≤ 13 ∧ 0 ≤ down ≤ 17 ∧ (up ≡ 0 ∨ down ≡ 0)
; shows: shape_of: precondition of scaled: fits: -(0x4000 << down) < x * (1 << up) < 0x4000 << down
; shows: shape_of: precondition of scaled: shifts: 0 ≤ up ≤ 13 ∧ 0 ≤ down ≤ 17 ∧ (up ≡ 0 ∨ down ≡ 0)
; shows: shape_of: precondition of scaled: fits: -(0x4000 << down) < x * (1 << up) < 0x4000 << down
; shows: shape_of: precondition of scaled: shifts: 0 ≤ up ≤ 13 ∧ 0 ≤ down ≤ 17 ∧ (up ≡ 0 ∨ down ≡ 0)
; shows: shape_of: precondition of scaled: fits: -(0x4000 << down) < x * (1 << up) < 0x4000 << down
; shows: shape_of: precondition of scaled: shifts: 0 ≤ up ≤ 13 ∧ 0 ≤ down ≤ 17 ∧ (up ≡ 0 ∨ down ≡ 0)
; shows: shape_of: precondition of scaled: fits: -(0x4000 << down) < x * (1 << up) < 0x4000 << down
; shows: shape_of: postcondition: scale: -2 ≤ \result.scale ≤ 28
; shows: shape_of: postcondition: product: \result.det ≡ \result.x1 * \result.y2 - \result.x2 * \result.y1
; shows: shape_of: postcondition: widest: \result.scale > -2 ∨ \result.det ≤ 0x8000000
; shows: shape_of: postcondition: large: \result.det ≤ 0 ∨ \result.x1 ≥ 0x2000 ∨ \result.y1 ≥ 0x2000 ∨ \result.x2 ≥ 0x2000 ∨ \result.y2 ≥ 0x2000 ∨ \result.x1 ≤ -0x2000 ∨ \result.y1 ≤ -0x2000 ∨ \result.x2 ≤ -0x2000 ∨ \result.y2 ≤ -0x2000
; shows: shape_of: postcondition: within: within((\old(p) + 1)->x - (\old(p) + 0)->x, \result.scale) ∧ within((\old(p) + 1)->y - (\old(p) + 0)->y, \result.scale) ∧ within((\old(p) + 2)->x - (\old(p) + 0)->x, \result.scale) ∧ within((\old(p) + 2)->y - (\old(p) + 0)->y, \result.scale)
; shows: part_height: precondition of height_of: product: product(s)
; shows: part_height: precondition of height_of: large: s->det ≤ 0 ∨ large(s)
; shows: height_of: division_by_zero: a ≢ 0
; shows: height_of: postcondition: range: 0 ≤ \result ≤ 0x3ffff
; shows: height_of: postcondition: least: \result ≡ 0 ∨ 4 * \old(s)->det ≥ \result * (0x2000 << (\old(s)->scale + 2))

; Differences of at most 2^30; n the leading zeros of all their bits, 0 to 31 of what is not 0.
(push)
(define-fun size ((v (_ BitVec 64))) (_ BitVec 64) (ite (bvslt v #x0000000000000000) (bvneg v) v))
(define-fun most () (_ BitVec 64) #x0000000040000000)
(declare-const x (_ BitVec 64))  ; one of the four
(declare-const u (_ BitVec 64))  ; the others
(declare-const v (_ BitVec 64))
(declare-const w (_ BitVec 64))
(declare-const n (_ BitVec 64))
(define-fun largest () (_ BitVec 64) (bvor (size x) (size u) (size v) (size w)))
(assert (and (bvule (size x) most) (bvule (size u) most) (bvule (size v) most) (bvule (size w) most)))
(assert (and (not (= largest #x0000000000000000)) (bvule n #x000000000000001f)
             (= (bvlshr largest (bvsub #x000000000000001f n)) #x0000000000000001)))
(define-fun scale () (_ BitVec 64) (bvsub n #x0000000000000012))
(define-fun up () (_ BitVec 64) (ite (bvsgt scale #x0000000000000000) scale #x0000000000000000))
(define-fun down () (_ BitVec 64) (ite (bvslt scale #x0000000000000000) (bvneg scale) #x0000000000000000))
(define-fun limit () (_ BitVec 64) (bvshl #x0000000000004000 down))
(push)
(assert (not (and (bvsle #xffffffffffffffef scale) (bvsle scale #x000000000000000d)))) ; -17..13
(check-sat)
(pop)
(push)
(assert (not (and (bvslt (bvneg limit) (bvshl x up)) (bvslt (bvshl x up) limit)
                  (= (bvashr (bvshl x up) up) x))))
(check-sat)
(pop)
(push) ; that is |x| < 2^(32 - n), where scale - 15, of the plane's, is n - 18
(assert (not (bvult (size x) (bvshl #x0000000000000001 (bvsub #x0000000000000020 n)))))
(check-sat)
(pop)
(push) ; at the scale of -2, where n is 1, it is 2^13 at most
(assert (= n #x0000000000000001))
(assert (not (bvule (size (bvashr x down)) #x0000000000002000)))
(check-sat)
(pop)
(push) ; what has the leading bit is 2^13 or more in size when it is scaled, and then not -2^14
(assert (= (bvlshr (size x) (bvsub #x000000000000001f n)) #x0000000000000001))
(assert (not (bvsge (size (bvashr (bvshl x up) down)) #x0000000000002000)))
(check-sat)
(pop)
(push) ; and one of the four has it
(define-fun leading ((v (_ BitVec 64))) Bool (= (bvlshr (size v) (bvsub #x000000000000001f n)) #x0000000000000001))
(assert (not (or (leading x) (leading u) (leading v) (leading w))))
(check-sat)
(pop)
(pop)
; So a shape is large, unless all four are 0: then its determinant is 0, its scale 15.

; The longest side, taken as the largest of both and half the other, is 2^13 at least and below 2^16.
(declare-const x1 Int)
(declare-const y1 Int)
(declare-const x2 Int)
(declare-const y2 Int)
(define-fun abs ((v Int)) Int (ite (< v 0) (- v) v))
(define-fun length ((x Int) (y Int)) Int
  (ite (> (abs x) (abs y)) (+ (abs x) (div (abs y) 2)) (+ (abs y) (div (abs x) 2))))
(define-fun longer ((a Int) (b Int)) Int (ite (> a b) a b))
(define-fun a () Int (longer (longer (length x1 y1) (length x2 y2)) (length (- x2 x1) (- y2 y1))))
(push) ; two products of 2^26 at most
(define-fun within ((v Int)) Bool (<= (- 8192) v 8192))
(assert (and (within x1) (within y1) (within x2) (within y2)))
(assert (not (<= (- (* x1 y2) (* x2 y1)) 134217728)))
(check-sat)
(pop)
(push)
(assert (and (<= (abs x1) 16383) (<= (abs y1) 16383) (<= (abs x2) 16383) (<= (abs y2) 16383)))
(assert (or (>= (abs x1) 8192) (>= (abs y1) 8192) (>= (abs x2) 8192) (>= (abs y2) 8192)))
(assert (not (<= 8192 a 65535)))
(check-sat)
(pop)

; det / a, which is not 0, moved by the scale: k = 2^scale, or 2^-scale of a negative one.
(declare-const det Int)
(declare-const side Int)   ; a
(declare-const height Int) ; det / a
(declare-const k Int)
(declare-const moved Int) ; height / k
(assert (and (< 0 det 536870912) (<= 8192 side 65535) (<= 1 k)))
(assert (and (<= (* height side) det) (< det (+ (* height side) side)) (>= height 0)))
(assert (and (<= (* moved k) height) (>= moved 0)))
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (and (product height (- side 8192)) (product moved (- k 1))))
(push)
(assert (not (and (<= (* moved 8192 k) det) (<= moved 65535))))
(check-sat)
(pop)
(push) ; times 4 or 2: 4 det >= result 2^13 2^(scale + 2), where that is 1 or 2
(assert (not (and (>= (* 4 det) (* (* 4 height) 8192)) (>= (* 4 det) (* (* 2 height) 8192 2)) (<= (* 4 height) 262143))))
(check-sat)
(pop)
