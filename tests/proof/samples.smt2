; SPDX-License-Identifier: MIT
; What dot products are at most, and in steps. Each question denies what is to be shown: unsat.
; source: firmware/shade/dots.c
; code: struct bounds range = bounds_of(samples.corner[which]); dots_bulges(samples.corner[which], samples.middle[which], factors, bulge); range.low = range.low < 0 ? stretched(range.low, factors->stretch) : range.low; range.high = stretched(range.high, factors->stretch); int32_t bend = stretched(dots_bulge_bend(bulge), factors->stretch); bend = bend < MOST_BEND ? bend : MOST_BEND;
; code: return fx_s32((fx_s64(x) * factor) >> 16);
; source: firmware/shade/steps.h
; code: const int32_t low = range.low - bend, high = range.high + bend, fold = surface->fold; return low > 0 && high < 1 << 15 && (low * fold >> 15) + surface->ambient >= 1 << 7 && (high * fold >> 15)
; source: firmware/shade/dots.h
; code: int32_t lower = top > bend ? top - bend : 0;
; shows: steps_plain: signed_overflow: -2147483648 ≤ high * fold_0
; shows: dots_highlight_slack: shift: 0 ≤ lower

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
