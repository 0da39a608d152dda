; SPDX-License-Identifier: MIT
; Dot products over a piece, by their six samples. Each question denies what is to be shown: unsat.
; source: firmware/shade/dots.c
; code: /* |sum| <= 2^15, |m D| <= 2^15 (1 + 2^-3): D shrinks where m grows, but for what bends are off; Q30, < 2^32 */ int64_t bulge = fx_s64(sum) * (1 << 15) - ((fx_s64(middle[k]) * factors->edge[k]) >> 1); out[k] = bulge > INT32_MAX ? INT32_MAX : bulge < -INT32_MAX ? -INT32_MAX : fx_s32(bulge);
; source: firmware/shade/piece.c
; code: bend += fx_mulhi_s32(bulge[i], fx_s32(fx_u32(w[k][i]) * w[k][j])); /* Q28 * Q30: Q26; product <= 2^30 */ } v[k] = (linear >> 15) - (bend >> 12);
; shows: piece_quadratic: user assertion: short3(value)

; Of bends as scene_check() takes them and normals and vectors of at most 1 + 2^-12, s = (Na + Nb).V has s^2 at most
; 4 (1 - bend) and .0035 more; D is 1 / sqrt(1 - bend), of 2^-8 at least, or 1 + bend / 2.
; source: firmware/scene/scene_check.c
; code: return expected - bend < 32 && bend - expected < 32;
(push)
(declare-const s Real)
(declare-const ss Real) ; s^2
(declare-const bend Real)
(define-fun rest () Real (ite (< (- 1 bend) 0.00390625) 0.00390625 (- 1 bend)))
(assert (and (<= 0 bend 1) (<= 0 ss (+ (* 4 (- 1 bend)) 0.0035))))
(assert (not (<= ss (* 2.25 2.25 rest))))
(check-sat)
(pop)
(push)
(declare-const s Real)
(declare-const bend Real)
(assert (and (<= 0 bend 1) (<= 0 s) (<= (* s s) (+ (* 4 (- 1 bend)) 0.0035))))
(assert (not (<= (* s (+ 1 (/ bend 2))) 2.25)))
(check-sat)
(pop)

; A bulge is 2 S - 2 M, M = m D, or by saturation of an M nearer to 0, here in 2^-28; so with Ii the corners' values
; v = sum Ii li - sum (2 Ii + 2 Ij - 2 Mij) li lj = sum Ii li (2 li - 1) + 2 sum Mij li lj.
(push)
(declare-const s2 Real) ; 2 S
(declare-const m2 Real) ; 2 M
(define-fun bulge () Real (ite (> (- s2 m2) 8) 8.0 (ite (< (- s2 m2) (- 8)) (- 8.0) (- s2 m2))))
(assert (and (<= (- 4.01) s2 4.01) (<= (- 4.5) m2 4.5)))
(assert (not (<= (- 4.5) (- s2 bulge) 4.5)))
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
; |I| <= 16400, |M| <= 2^15 (1 + 2^-3), all in Q14: v, and 4 more for what is rounded, is a 16-bit number. xx is x^2 and
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
(assert (not (<= (+ (* 16400 (+ (part x xx) (part y yy) (part z zz))) (* 2 36864 (+ xy yz zx))) (- 32767 4))))
(check-sat)
(pop)
