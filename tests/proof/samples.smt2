; SPDX-License-Identifier: MIT
; Dot products over a piece, by their six samples, and what counts in steps. Each question denies what is to be shown:
; unsat.
; source: firmware/shade/dots.c
; code: /* |sum| <= 2^15, |m D| <= 2^15 (1 + 2^-4) as D shrinks where m grows, Q30: below 2^32 before the difference */ int64_t bulge = fx_s64(sum) * (1 << 15) - ((fx_s64(middle[k]) * factors->edge[k]) >> 1); out[k] = bulge > INT32_MAX ? INT32_MAX : bulge < -INT32_MAX ? -INT32_MAX : fx_s32(bulge);
; code: struct bounds range = bounds_of(samples.corner[which]); dots_bulges(samples.corner[which], samples.middle[which], factors, bulge); range.low = range.low < 0 ? stretched(range.low, factors->stretch) : range.low; range.high = stretched(range.high, factors->stretch); int32_t bend = stretched(dots_bulge_bend(bulge), factors->stretch); bend = bend < MOST_BEND ? bend : MOST_BEND;
; code: return fx_s32((fx_s64(x) * factor) >> 16);
; source: firmware/shade/piece.c
; code: bend += fx_mulhi_s32(bulge[i], fx_s32(fx_u32(w[k][i]) * w[k][j])); /* Q28 * Q30: Q26; product <= 2^30 */ } v[k] = (linear >> 15) - (bend >> 12);
; source: firmware/shade/steps.h
; code: const int32_t low = range.low - bend, high = range.high + bend, fold = surface->fold; return low > 0 && high < 1 << 15 && (low * fold >> 15) + surface->ambient >= 1 << 7 && (high * fold >> 15)
; source: firmware/shade/dots.h
; code: int32_t lower = top > bend ? top - bend : 0;
; shows: piece_quadratic: user assertion: short3(value)
; shows: steps_plain: signed_overflow: -2147483648 ≤ high * fold_0
; shows: dots_highlight_slack: shift: 0 ≤ lower

; A bulge is 2 S - 2 M, M = m D, or by saturation of an M nearer to 0, here in 2^-28; so with Ii the corners' values
; v = sum Ii li - sum (2 Ii + 2 Ij - 2 Mij) li lj = sum Ii li (2 li - 1) + 2 sum Mij li lj.
(push)
(declare-const s2 Real) ; 2 S
(declare-const m2 Real) ; 2 M
(define-fun bulge () Real (ite (> (- s2 m2) 8) 8.0 (ite (< (- s2 m2) (- 8)) (- 8.0) (- s2 m2))))
(assert (and (<= (- 4.01) s2 4.01) (<= (- 4.25) m2 4.25)))
(assert (not (<= (- 4.25) (- s2 bulge) 4.25)))
(check-sat)
(pop)
(push)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(declare-const i Real)
(declare-const j Real)
(declare-const k Real)
(declare-const mij Real)
(declare-const mjk Real)
(declare-const mki Real)
(assert (= z (- 1 x y)))
(assert (not (= (- (+ (* i x) (* j y) (* k z)) (* (- (* 2 (+ i j)) (* 2 mij)) x y) (* (- (* 2 (+ j k)) (* 2 mjk)) y z)
                   (* (- (* 2 (+ k i)) (* 2 mki)) z x))
                (+ (* i x (- (* 2 x) 1)) (* j y (- (* 2 y) 1)) (* k z (- (* 2 z) 1))
                   (* 2 mij x y) (* 2 mjk y z) (* 2 mki z x)))))
(check-sat)
(pop)
; |I| <= 16400, |M| <= 2^15 (1 + 2^-4), all in Q14: v, and 4 more for what is rounded, is a 16-bit number. xx is x^2 and
; so on: of x + y + z = 1 times each; no square and no product is below 0.
(push)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(declare-const xx Real)
(declare-const yy Real)
(declare-const zz Real)
(declare-const xy Real)
(declare-const yz Real)
(declare-const zx Real)
(assert (and (<= 0 x) (<= 0 y) (<= 0 z) (= (+ x y z) 1)))
(assert (and (= (+ xx xy zx) x) (= (+ xy yy yz) y) (= (+ zx yz zz) z)))
(assert (and (>= (+ xx yy (* (- 2) xy)) 0) (>= (+ yy zz (* (- 2) yz)) 0) (>= (+ zz xx (* (- 2) zx)) 0)))
(define-fun half ((a Real) (aa Real)) Bool (>= (+ aa (- a) 0.25) 0)) ; (a - 1/2)^2
(assert (and (half x xx) (half y yy) (half z zz) (<= 0 xy) (<= 0 yz) (<= 0 zx)))
(define-fun part ((a Real) (aa Real)) Real (ite (>= a 0.5) (- (* 2 aa) a) (- a (* 2 aa)))) ; a |2 a - 1|
(assert (not (<= (+ (* 16400 (+ (part x xx) (part y yy) (part z zz))) (* 2 34816 (+ xy yz zx))) (- 32767 4))))
(check-sat)
(pop)

; Where N.L is above 0 everywhere, its upper end is.
(push)
(declare-const least Int)
(declare-const most Int)
(declare-const bend Int)
(declare-const factor Int)
(define-fun low () Int (ite (< least 0) (div (* least factor) 65536) least))
(define-fun high () Int (div (* most factor) 65536))
(assert (and (<= least most) (<= 65536 factor 1048576) (<= 0 bend 65535)))
(assert (=> (< least 0) (<= (* least factor) (* least 65536))))
(assert (=> (>= most 0) (>= (* most factor) (* most 65536))))
(assert (and (> (- low bend) 0) (not (>= (+ high bend) 0))))
(check-sat)
(pop)
(push)
(declare-const top Int)
(declare-const bend Int)
(assert (not (>= (ite (> top bend) (- top bend) 0) 0)))
(check-sat)
(pop)
