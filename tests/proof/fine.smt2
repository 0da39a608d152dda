; SPDX-License-Identifier: MIT
; What fine_setup() asks of its edges: they fall, and the row crosses them. Each question denies what is to be shown: unsat.
; source: firmware/raster/fine.c
; code: const int32_t hw = (8 * fx_s32(width) - 8) * (FINE_ONE / 16), hh = (8 * fx_s32(height) - 8) * (FINE_ONE / 16); int top = p[1].y < p[0].y ? 1 : 0; top = p[2].y < p[top].y ? 2 : top;
; code: const struct part_place *at = &p[top + i < 3 ? top + i : top + i - 3]; corner[i] = (struct part_place){at->x + hw, at->y + hh}; } const struct part_place *const a = &corner[0], *const b = &corner[1], *const c = &corner[2]; const int right_turns = b->y < c->y; const int32_t middle = centre_after(right_turns ? b->y : c->y), bottom = centre_after(right_turns ? c->y : b->y); const int32_t first = centre_after(a->y), row = first > from ? first : from; int32_t last = bottom < to ? bottom : to; if (row >= last) return 0; const int upper = row < middle; last = upper && middle < last ? middle : last; side(&e->left, upper || right_turns ? a : c, upper || right_turns ? c : b, row); side(&e->right, upper || !right_turns ? a : b, upper || !right_turns ? b : c, row);
; code: return (y + FINE_ONE - 1) >> FINE_BITS; }
; code: edge_setup(e, from->x, from->y, to->x - from->x, to->y - from->y, row * FINE_ONE); }
; shows: side: precondition of edge_setup: ends: -0x40000000 ≤ x ≤ 0x40000000 ∧ -0x40000000 ≤ x + dx ≤ 0x40000000
; shows: side: precondition of edge_setup: across: -0x40000000 ≤ dx ≤ 0x40000000
; shows: side: precondition of edge_setup: falls: 1 ≤ dy ≤ 0x40000000
; shows: side: precondition of edge_setup: crossed: 0 ≤ centre - y ≤ dy

; The top corner comes first, whichever it is.
(push)
(declare-const p0 Int)
(declare-const p1 Int)
(declare-const p2 Int)
(define-fun one () Int (ite (< p1 p0) p1 p0))
(define-fun top () Int (ite (< p2 one) p2 one))
(assert (not (and (<= top p0) (<= top p1) (<= top p2))))
(check-sat)
(pop)

; Corners, as fine_setup() moves them, and the first row in hand.
(define-fun corner ((v Int) (h Int)) Bool (<= (- h 536870912) v (+ h 536870912)))
(declare-const width Int)
(declare-const height Int)
(define-fun hw () Int (* 32768 (- (* 8 width) 8)))
(define-fun hh () Int (* 32768 (- (* 8 height) 8)))
(declare-const ax Int)
(declare-const ay Int)
(declare-const bx Int)
(declare-const by Int)
(declare-const cx Int)
(declare-const cy Int)
(declare-const from Int)
(declare-const to Int)
(assert (and (<= 1 width 2048) (<= 1 height 2048) (corner ax hw) (corner bx hw) (corner cx hw) (corner ay hh)
             (corner by hh) (corner cy hh) (<= ay by) (<= ay cy)))
(define-fun after ((y Int)) Int (div (+ y 524287) 524288))
(define-fun turns () Bool (< by cy))
(define-fun middle () Int (after (ite turns by cy)))
(define-fun bottom () Int (after (ite turns cy by)))
(define-fun row () Int (ite (> (after ay) from) (after ay) from))
(assert (< row (ite (< bottom to) bottom to)))
(define-fun upper () Bool (< row middle))
(define-fun asked ((x Int) (y Int) (x1 Int) (y1 Int)) Bool
  (and (<= (- 1073741824) x 1073741824) (<= (- 1073741824) x1 1073741824) (<= (- 1073741824) (- x1 x) 1073741824)
       (<= 1 (- y1 y) 1073741824) (<= 0 (- (* 524288 row) y) (- y1 y))))
(push)
(assert (not (ite (or upper turns) (asked ax ay cx cy) (asked cx cy bx by))))
(check-sat)
(pop)
(push)
(assert (not (ite (or upper (not turns)) (asked ax ay bx by) (asked bx by cx cy))))
(check-sat)
(pop)
