; SPDX-License-Identifier: MIT
; Cuts: which corner is inside, their share, and what is mixed by it. Each question denies what is to be shown: unsat.
; source: firmware/geometry/clip.c
; code: return fx_s32(a + (((fx_s64(b) - a) * fx_s64(t_q31) + (1 << 30)) >> 31)); }
; code: uint64_t span = fx_u64(d0 - d1), part = fx_u64(d0); /* d0 >= 0 > d1, both below 2^61 in size */ while (span >= UINT64_C(1) << 32) { span >>= 1; part >>= 1; } uint32_t t = fx_u32(fx_divide_u64(part << 31, span)); result->eye.x = mix(in->eye.x, out->eye.x, t);
; code: if ((da < 0) != (db < 0) && to->count < CLIP_MAX_CORNERS) { if (da >= 0) cut(a, da, b, db, &to->corner[to->count++]); else cut(b, db, a, da, &to->corner[to->count++]);
; shows: mix: postcondition: between: (\old(a) ≤ \result ≤ \old(b)) ∨ (\old(b) ≤ \result ≤ \old(a))
; shows: cut: precondition of mix: share: t_q31 ≤ 0x80000000
; a b >= 0 of a, b >= 0: what a solver of linear arithmetic is told of products
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(define-fun one () Int 2147483648) ; of t

; What is mixed lies between its ends.
(push)
(declare-const a Int)
(declare-const b Int)
(declare-const t Int)
(assert (<= 0 t one))
(define-fun rise () Int (- b a))
(assert (and (product rise t) (product rise (- one t)) (product (- rise) t) (product (- rise) (- one t))))
(define-fun mixed () Int (+ a (div (+ (* rise t) 1073741824) one)))
(assert (not (or (<= a mixed b) (<= b mixed a))))
(check-sat)
(pop)

; Of two corners on different sides the one that is not inside is outside.
(push)
(declare-const da Int)
(declare-const db Int)
(assert (not (= (< da 0) (< db 0))))
(assert (not (ite (>= da 0) (and (<= 0 da) (< db 0)) (and (<= 0 db) (< da 0)))))
(check-sat)
(pop)

; The part is never more than the span, which is never 0, halved or not.
(declare-const part Int)
(declare-const span Int)
(push)
(declare-const d0 Int)
(declare-const d1 Int)
(assert (and (<= 0 d0) (< d1 0) (= span (- d0 d1)) (= part d0)))
(assert (not (and (<= 0 part span) (<= 1 span))))
(check-sat)
(pop)
(assert (and (<= 0 part span) (<= 1 span)))
(push)
(assert (<= 4294967296 span))
(assert (not (and (<= 0 (div part 2) (div span 2)) (<= 1 (div span 2)))))
(check-sat)
(pop)

; So no bit of part << 31 is lost, and the share is 1 at most.
(push)
(declare-const t Int)
(assert (< span 4294967296))
(assert (and (<= (* t span) (* part one)) (product (- t one 1) span)))
(assert (not (and (< (* part one) 18446744073709551616) (<= t one))))
(check-sat)
(pop)
