; SPDX-License-Identifier: MIT
; Bulges of numerators fit 32 bits. Each question denies what is to be shown: unsat.
; source: firmware/shade/perspective.c
; code: p->s[k] = fx_u16(closeness[k] << p->up);
; code: v[k] = fx_s32((fx_s64(value[k]) * square) >> 16);
; code: int64_t middle = fx_s64(value[k] + value[j]) * (1 << 14) - bulge[k]; uint32_t product = fx_u32(p->s[k]) * p->s[j]; b[k] = fx_s32(((fx_s64(v[k]) + v[j]) >> 2) - fx_s64((middle * fx_s64(product >> 1)) >> 31));
; shows: perspective_numerator: signed_downcast: -2147483648 ≤ (int64_t)((int64_t)((int64_t)((int64_t)*(v + k_0) + (int64_t)*(v + j)) >> 2) - (int64_t)((int64_t)(middle * (int64_t)((uint32_t)(product >> 1))) >> 31))
; shows: perspective_numerator: signed_downcast: (int64_t)((int64_t)((int64_t)((int64_t)*(v + k_0) + (int64_t)*(v + j)) >> 2) - (int64_t)((int64_t)(middle * (int64_t)((uint32_t)(product >> 1))) >> 31)) ≤ 2147483647

; In units of 2^31 of Q28, of p = si >= q = sj: B = I p^2 + J q^2 - (I + J - a) p q, |I|, |J| <= 1/4, |a| <= 1.
(declare-const i Real)
(declare-const j Real)
(declare-const a Real)
(declare-const p Real)
(declare-const q Real)
(push)
(assert (not (= (- (+ (* i p p) (* j q q)) (* (+ i j (- a)) p q)) (+ (* i (- (* p p) (* p q))) (* j (- (* q q) (* p q))) (* a p q)))))
(check-sat)
(pop)
(push) ; its three terms; (p - q) (3 p - q) is not below 0
(declare-const ti Real)
(declare-const tj Real)
(declare-const ta Real)
(declare-const pp Real)
(declare-const pq Real)
(declare-const qq Real)
(define-fun term ((t Real) (size Real)) Bool (<= (- size) t size))
(assert (and (<= 0 qq pq) (<= pq pp) (>= (+ (* 3 pp) qq (* (- 4) pq)) 0)))
(assert (and (term ti (/ (- pp pq) 4)) (term tj (/ (- pq qq) 4)) (term ta pq)))
(assert (not (<= (- pp) (+ ti tj ta) pp)))
(check-sat)
(pop)
(push) ; p below 1 by 2^-16 at least, and roundings: 4 of Q28
(assert (and (<= 0 p) (<= p (/ 65535.0 65536)) (>= (* (- (/ 65535.0 65536) p) (+ (/ 65535.0 65536) p)) 0)))
(assert (not (<= (+ (* 2147483648 p p) 4) 2147483647)))
(check-sat)
(pop)
