; SPDX-License-Identifier: MIT
; X-shading's bulges. Each question denies what is to be shown: unsat.
; source: firmware/shade/x.c
; code: out[0] = -(((value[0] + value[1]) * triangle->bend[2]) >> 2); out[1] = -(((value[1] + value[2]) * triangle->bend[1]) >> 2); out[2] = -(((value[2] + value[0]) * triangle->bend[0]) >> 2);
; source: firmware/scene/scene_check.c
; code: return expected - bend < 32 && bend - expected < 32;
; source: firmware/shade/dots.h
; code: int32_t lower = top > bend ? top - bend : 0;
; shows: dots_highlight_slack: shift: 0 ≤ lower
; shows: bulges: signed_overflow: (int32_t)(*(value + 0) + *(value + 1)) * (int32_t)triangle->bend[2] ≤ 2147483647
; shows: bulges: signed_overflow: -2147483648 ≤ (int32_t)(*(value + 0) + *(value + 1)) * (int32_t)triangle->bend[2]
; shows: bulges: signed_overflow: (int32_t)(*(value + 1) + *(value + 2)) * (int32_t)triangle->bend[1] ≤ 2147483647
; shows: bulges: signed_overflow: -2147483648 ≤ (int32_t)(*(value + 1) + *(value + 2)) * (int32_t)triangle->bend[1]
; shows: bulges: signed_overflow: (int32_t)(*(value + 2) + *(value + 0)) * (int32_t)triangle->bend[0] ≤ 2147483647
; shows: bulges: signed_overflow: -2147483648 ≤ (int32_t)(*(value + 2) + *(value + 0)) * (int32_t)triangle->bend[0]

; Ii + Ij is at most s 2^14, s^2 at most 4 (1 - bend) and a little (six_samples.smt2), and a bend less than 2^16.
(push)
(declare-const s Real)
(declare-const bend Real)
(assert (and (<= 0 bend 1) (<= 0 s) (<= (* s s) (+ (* 4 (- 1 bend)) 0.0035))))
(assert (not (< (* s bend) 2)))
(check-sat)
(pop)
(push)
(declare-const top Int)
(declare-const bend Int)
(assert (not (>= (ite (> top bend) (- top bend) 0) 0)))
(check-sat)
(pop)
