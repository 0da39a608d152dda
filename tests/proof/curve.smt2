; SPDX-License-Identifier: MIT
; No chord of the table is below 0 where it is taken. The question denies it: unsat.
; source: firmware/plan/curve.c
; code: {4096, 1656, {{12512, 1049}, {6002, 7559}, {6002, 7559}, {4455, 7946}, {12512, 8075}}}, {8192, 1789, {{14330, 241}, {7316, 7256}, {6334, 7746}, {4525, 8199}, {14330, 8500}}}, {16384, 2143, {{19530, -593}, {14461, 4477}, {6846, 8284}, {2003, 9495}, {19530, 9523}}}, {CURVE_MOST_BEND, 3677, {{47317, -5929}, {45415, -4027}, {25447, 5957}, {-19599, 17218}, {47317, 12748}}},
; source: firmware/plan/curve.h
; code: const struct curve_line *line = curve->lines; const int32_t scaled = fx_s32(fx_u32(v->high) * curve->bend >> 16) + 1, range = v->high - v->low; if (range > 4 * scaled) line += range > 16 * scaled ? 4 : 3; else line += range > 2 * scaled ? 2 : range > scaled;
; code: const int32_t most = line->alpha * scaled + line->beta * range;
; shows: curve_six: unsigned_downcast: 0 ≤ most
(declare-const scaled Int)
(declare-const range Int)
(define-fun line ((alpha Int) (beta Int)) Bool (>= (+ (* alpha scaled) (* beta range)) 0))
(assert (and (>= scaled 1) (>= range 0)))
(assert (not (ite (> range (* 4 scaled))
  (ite (> range (* 16 scaled))
    (and (line 12512 8075) (line 14330 8500) (line 19530 9523) (line 47317 12748))
    (and (line 4455 7946) (line 4525 8199) (line 2003 9495) (line (- 19599) 17218)))
  (ite (> range (* 2 scaled))
    (and (line 6002 7559) (line 6334 7746) (line 6846 8284) (line 25447 5957))
    (ite (> range scaled)
      (and (line 6002 7559) (line 7316 7256) (line 14461 4477) (line 45415 (- 4027)))
      (and (line 12512 1049) (line 14330 241) (line 19530 (- 593)) (line 47317 (- 5929))))))))
(check-sat)
