; SPDX-License-Identifier: MIT
; A near point's place: at most 2^28 in size, and one more when it is to be taken as far. Each question denies what is to
; be shown: unsat.
; source: firmware/geometry/light.c
; code: #define FARTHEST (INT64_C(1) << 28)
; code: const int64_t size = quotient[i] < 0 ? -quotient[i] : quotient[i]; largest = size > largest ? size : largest; } largest >>= up; int down = 0, shift = 0; while (largest >> down > FARTHEST) down++; while (shift < 8 && (largest + 1) << (shift + 1) <= FARTHEST) shift++;
; code: out->at[i] = fx_s32(fx_divide_s64(quotient[i] * (1 << shift), 1 << up) >> down); out->near = down == 0;
; code: if (down) { /* so far that the mesh is a point */ q14_t unit[3]; object_unit(out->at, unit);
; shows: near_point: precondition of object_unit: first: -0x7fffffff ≤ *(v + 0)
; shows: near_point: precondition of object_unit: second: -0x7fffffff ≤ *(v + 1)
; shows: near_point: precondition of object_unit: third: -0x7fffffff ≤ *(v + 2)
; shows: near_point: postcondition: first: -0x10004000 ≤ \old(out)->at[0] ≤ 0x10004000
; shows: near_point: postcondition: second: -0x10004000 ≤ \old(out)->at[1] ≤ 0x10004000
; shows: near_point: postcondition: third: -0x10004000 ≤ \old(out)->at[2] ≤ 0x10004000
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(define-fun farthest () Int 268435456)
(declare-const q Int)     ; a quotient, in size, at most the largest one
(declare-const up Int)    ; 2^up, 2^shift, 2^down
(declare-const shift Int)
(declare-const down Int)
(declare-const above Int) ; the largest, moved down by `up`, and 1
(declare-const t Int)     ; q 2^shift / 2^up, rounded to 0
(assert (and (<= 1 up) (<= 1 shift) (<= 1 down) (<= 1 above) (<= 0 q) (< q (* above up))))
(assert (and (<= 0 t) (<= (* t up) (* q shift))))
(assert (and (product (- (* above up) q 1) shift) (product (- t (* above shift)) up)))
(push)
(assert (not (< t (* above shift))))
(check-sat)
(pop)
(assert (< t (* above shift)))
; The first loop leaves at most the farthest above `down`; the second moves up by nothing, or to the farthest at most.
(declare-const most Int)  ; (above - 1) / 2^down
(declare-const place Int) ; t, of either sign, moved down
(assert (and (<= (* most down) (- above 1)) (< (- above 1) (+ (* most down) down)) (<= most farthest)))
(assert (or (= shift 1) (<= (* above shift) farthest)))
(push) ; not moved down
(assert (= down 1))
(assert (not (<= t farthest)))
(check-sat)
(pop)
(push) ; moved down, so the largest is above the farthest, and not moved up
(assert (and (> (- above 1) farthest) (= shift 1)))
(define-fun moved ((x Int)) Bool (and (<= (* place down) x) (< x (+ (* place down) down))))
(assert (or (moved t) (moved (- t))))
(assert (and (product (- place most 1) down) (product (- (- place) most 2) down)))
(assert (not (<= (- (+ farthest 1)) place farthest)))
(check-sat)
(pop)
; The unit vector in place of one: at most 16385 * 2^14.
(push)
(declare-const unit Int)
(assert (<= (- 16385) unit 16385))
(assert (not (<= (- 268451840) (* 16384 unit) 268451840)))
(check-sat)
(pop)
