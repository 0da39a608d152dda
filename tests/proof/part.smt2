; SPDX-License-Identifier: MIT
; Places and weights by weights that sum to 2^15, the nearest pixel, and what is scaled. Each question denies what is to
; be shown: unsat.
; source: firmware/shade/part.c
; code: const int32_t u = corner->weight[0], v = corner->weight[1], w = fx_s32(PART_ONE) - u - v; const int16_t *a = in->place[0], *b = in->place[1], *c = in->place[2]; return (struct part_place){u * a[0] + v * b[0] + w * c[0], u * a[1] + v * b[1] + w * c[1]}; }
; code: const uint32_t at[3] = {corner->weight[0], corner->weight[1], PART_ONE - corner->weight[0] - corner->weight[1]}; uint32_t rest = PART_ONE; for (int i = 0; i < 3; i++) { uint32_t w = at[i]; if (shade_weight(in)) { /* products of weights that sum to 2^15: at most 2^30 */ w = at[0] * in->weight[0][i] + at[1] * in->weight[1][i] + at[2] * in->weight[2][i]; w = i == 2 ? rest : w >> 15; } weight[i] = fx_u16(w); rest -= w; } }
; code: x = x * (1 << up) >> down; return x + (x == -(1 << 14)); }
; code: *pixel = (at + (1 << 18)) >> 19; int32_t to_centre = *pixel * (1 << 19) - at; /* at most 2^18 */ *sub = (to_centre + (1 << 14)) >> 15; *rest = to_centre - *sub * (1 << 15); }
; shows: part_place: postcondition: box: -0x20000000 ≤ \result.x ≤ 0x20000000 ∧ -0x20000000 ≤ \result.y ≤ 0x20000000
; shows: part_weights: postcondition: each: *(\old(weight) + 0) ≤ 0x8000 ∧ *(\old(weight) + 1) ≤ 0x8000 ∧ *(\old(weight) + 2) ≤ 0x8000
; shows: part_weights: postcondition: whole: (*(\old(weight) + 0) + *(\old(weight) + 1)) + *(\old(weight) + 2) ≡ 0x8000
; shows: scaled: postcondition: small: -0x3fff ≤ \result ≤ 0x3fff
; shows: nearest: postcondition: sub: -8 ≤ *\old(sub) ≤ 8
; shows: nearest: postcondition: rest: -0x4000 ≤ *\old(rest) ≤ 0x4000
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(declare-const u Int)
(declare-const v Int)
(define-fun w () Int (- 32768 u v))
(assert (and (<= 0 u) (<= 0 v) (<= 0 w)))

; A place: three coordinates within 2^14.
(push)
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
(assert (and (product u (- 16384 a)) (product v (- 16384 b)) (product w (- 16384 c))
             (product u (+ 16384 a)) (product v (+ 16384 b)) (product w (+ 16384 c))
             (<= (- 16384) a 16384) (<= (- 16384) b 16384) (<= (- 16384) c 16384)))
(assert (not (<= (- 536870912) (+ (* u a) (* v b) (* w c)) 536870912)))
(check-sat)
(pop)

; Weights: those of the source's corner, or of three that sum to 2^15 each, rounded down but for the last.
(push)
(assert (not (and (<= u 32768) (<= v 32768) (<= w 32768))))
(check-sat)
(pop)
(push)
(declare-const a0 Int)
(declare-const a1 Int)
(declare-const b0 Int)
(declare-const b1 Int)
(declare-const c0 Int)
(declare-const c1 Int)
(define-fun sum () Int (+ (* u a0) (* v b0) (* w c0)))
(define-fun next () Int (+ (* u a1) (* v b1) (* w c1)))
(assert (and (<= 0 a0) (<= 0 a1) (<= (+ a0 a1) 32768) (<= 0 b0) (<= 0 b1) (<= (+ b0 b1) 32768)
             (<= 0 c0) (<= 0 c1) (<= (+ c0 c1) 32768)))
(assert (and (product u a0) (product v b0) (product w c0) (product u a1) (product v b1) (product w c1)
             (product u (- 32768 a0 a1)) (product v (- 32768 b0 b1)) (product w (- 32768 c0 c1))))
(assert (not (and (<= 0 (div sum 32768)) (<= 0 (div next 32768)) (<= 0 (- 32768 (div sum 32768) (div next 32768)))
                  (<= (div sum 32768) 32768) (<= (div next 32768) 32768) (<= sum 1073741824))))
(check-sat)
(pop)

; What is scaled: -2^14 < x 2^up / 2^down < 2^14, rounded down and 1 more at -2^14. k = 2^down; x has been moved up.
(push)
(declare-const x Int)
(declare-const k Int)
(declare-const floor Int)
(assert (and (<= 1 k) (< (* (- 16384) k) x) (< x (* 16384 k)) (<= (* floor k) x) (< x (+ (* floor k) k))))
(assert (and (product (- floor 16384) k) (product (- (- 16385) floor) k)))
(assert (not (<= (- 16383) (ite (= floor (- 16384)) (+ floor 1) floor) 16383)))
(check-sat)
(pop)

; The nearest pixel, of 2^19, and what its centre lacks, in 16 parts of it and 2^15 of those.
(push)
(declare-const at Int)
(define-fun pixel () Int (div (+ at 262144) 524288))
(define-fun centre () Int (- (* pixel 524288) at))
(define-fun sub () Int (div (+ centre 16384) 32768))
(assert (not (and (<= (- 262144) centre 262144) (<= (- 8) sub 8) (<= (- 16384) (- centre (* sub 32768)) 16384))))
(check-sat)
(pop)
