; SPDX-License-Identifier: MIT
; Products of a normal n, of at most 1 + 2^-13, with an edge and with unit vectors. Each question denies what is to be
; shown: unsat.
; source: firmware/geometry/rotation.h
; code: void vector_normalise(const int32_t v[3], q30_t out[3]);
; source: firmware/shade/shade.h
; code: As bij = 3 P (ni + nj) with P a projection on some line, N = sum li (1 - 3 sum lj * Pij) ni, so that |N| <= sum li max(1, 2 - 3 li) <= 7/6, in a piece of the triangle too.
; shows: piece_quadratic: user assertion: short3(value)
; source: firmware/shade/normal_quadratic.c
; code: return fx_mulhi_s32(x, y) * 4;
; code: for (int k = 0; k < 3; k++) sum += fx_mulhi_s32(n[k] * 65536, v[k]); return sum;
; code: const int32_t along = times_q30(3 * (dot(a->normal, g) + dot(b->normal, g)), part);
; code: lean0 += a->normal[k] * edge[k]; lean1 += b->normal[k] * edge[k];
; code: out[k] = b->position[k] - a->position[k];
; shows: size_of: signed_overflow: -x ≤ 2147483647
; shows: times_q30: signed_overflow: -2147483648 ≤ tmp * 4
; shows: times_q30: signed_overflow: tmp * 4 ≤ 2147483647
; shows: bend_edge: signed_overflow: -2147483648 ≤ 3 * (int32_t)(tmp + tmp_0)
; shows: bend_edge: signed_overflow: 3 * (int32_t)(tmp + tmp_0) ≤ 2147483647
; shows: direction: signed_overflow: -2147483648 ≤ lean0 + (int)((int)a->normal[k] * edge[k])
; shows: direction: signed_overflow: lean0 + (int)((int)a->normal[k] * edge[k]) ≤ 2147483647
; shows: direction: signed_overflow: -2147483648 ≤ lean1 + (int)((int)b->normal[k] * edge[k])
; shows: direction: signed_overflow: lean1 + (int)((int)b->normal[k] * edge[k]) ≤ 2147483647
(define-fun square ((a Real) (b Real)) Bool (>= (+ (* a a) (* b b) (* (- 2) (* a b))) 0)) ; (a - b)^2

; |n0| + |n1| + |n2| is at most sqrt(3) |n|: in units of 2^14, and a little more.
(push)
(declare-const a Real)
(declare-const b Real)
(declare-const c Real)
(assert (and (<= 0 a) (<= 0 b) (<= 0 c) (<= (+ (* a a) (* b b) (* c c)) 1.0003)))
(assert (and (square a b) (square b c) (square c a)))
(assert (not (<= (* (+ a b c) (+ a b c)) 3.001)))
(check-sat)
(pop)
(push)
(declare-const sum Real)
(assert (and (<= 0 sum) (<= (* sum sum) 3.001)))
(assert (not (< (* sum 16384 65535) 2147483647)))
(check-sat)
(pop)

; |n.v| is at most |n| |v|: (n.v)^2 and three squares are n^2 v^2.
(push)
(declare-const a Real)
(declare-const b Real)
(declare-const c Real)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(define-fun nv () Real (+ (* a x) (* b y) (* c z)))
(define-fun p () Real (- (* a y) (* b x)))
(define-fun q () Real (- (* b z) (* c y)))
(define-fun r () Real (- (* c x) (* a z)))
(assert (not (= (+ (* nv nv) (* p p) (* q q) (* r r)) (* (+ (* a a) (* b b) (* c c)) (+ (* x x) (* y y) (* z z))))))
(check-sat)
(pop)
; Twice that and thrice, of Q28 and roundings of 3: 32 bits hold it, and a part of it in Q30.
(push)
(declare-const nv Real)
(declare-const mv Real)
(define-fun product ((v Real)) Bool (<= (* v v) 1.0006))
(assert (and (product nv) (product mv) (<= (- 1.1) nv 1.1) (<= (- 1.1) mv 1.1)))
(assert (not (<= (- 1700000000) (* 3 (+ (* nv 268435456) (* mv 268435456) 6)) 1700000000)))
(check-sat)
(pop)
(push)
(declare-const x Int)
(declare-const y Int)
(define-fun size ((a Int)) Int (ite (>= a 0) a (- a)))
(assert (and (<= (size x) 1700000000) (<= (size y) 1073807360)))
(assert (and (>= (* (- 1700000000 x) (+ 1073807360 y)) 0) (>= (* (+ 1700000000 x) (- 1073807360 y)) 0)))
(assert (and (>= (* (- 1700000000 x) (- 1073807360 y)) 0) (>= (* (+ 1700000000 x) (+ 1073807360 y)) 0)))
(assert (not (<= (- 2147483648) (* 4 (div (* x y) 4294967296)) 2147483647)))
(check-sat)
(pop)

; What a piece's normal is at most, as shade.h says: of n with 4 for roundings a 16-bit number.
(push)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(define-fun most ((l Real)) Real (ite (< (* 3 l) 1) (* l (- 2 (* 3 l))) l)) ; l max(1, 2 - 3 l)
(define-fun sixth ((l Real)) Bool (>= (+ (* l l) (- (/ l 3)) (/ 1.0 36)) 0)) ; (l - 1/6)^2
(assert (and (<= 0 x) (<= 0 y) (<= 0 z) (= (+ x y z) 1) (sixth x) (sixth y) (sixth z)))
(assert (not (and (<= (* 6 (+ (most x) (most y) (most z))) 7) (<= (+ (/ (* 7 16386) 6) 4) 32767))))
(check-sat)
(pop)
