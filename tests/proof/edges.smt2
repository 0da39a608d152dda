; SPDX-License-Identifier: MIT
; What edges_setup() and edges_spans() ask of an edge: it falls, and the row crosses it. Each question denies what is to
; be shown: unsat.
; source: firmware/geometry/transform.h
; code: #define GUARD (1024 * 16 - 1)
; source: firmware/raster/edges.c
; code: if (b[1] < a[1] && b[1] <= c[1]) { a = b; b = c; c = spare; } else if (c[1] < a[1]) { a = c; c = b; b = spare; }
; code: const int32_t hw = 8 * fx_s32(width) - 8, hh = 8 * fx_s32(height) - 8; /* centres at 16 i */ const int32_t ax = a[0] + hw, ay = a[1] + hh, bx = b[0] + hw, by = b[1] + hh, cx = c[0] + hw, cy = c[1] + hh; const int right_turns = by < cy; const int32_t first = (ay + 15) >> 4, middle = ((right_turns ? by : cy) + 15) >> 4; int32_t last = ((right_turns ? cy : by) + 15) >> 4; const int32_t row = first > from ? first : from; last = last < to ? last : to; if (row >= last) return 0; e->row = row; e->middle = middle; e->last = last; e->lower_is_left = !right_turns;
; code: e->lower_x = right_turns ? bx : cx; e->lower_y = right_turns ? by : cy; e->lower_dx = right_turns ? cx - bx : bx - cx; e->lower_dy = right_turns ? cy - by : by - cy; if (right_turns || row < middle) edge_setup(&e->left, ax, ay, cx - ax, cy - ay, row << 4); if (!right_turns || row < middle) edge_setup(&e->right, ax, ay, bx - ax, by - ay, row << 4); return 1; }
; code: const struct edge left = e->left, right = e->right; uint32_t x0 = fx_wrap_u32(left.column), rest0 = fx_wrap_u32(left.rest - left.den); uint32_t x1 = fx_wrap_u32(right.column), rest1 = fx_wrap_u32(right.rest - right.den);
; code: step(&x0, &rest0, &left); step(&x1, &rest1, &right);
; code: e->left.column = fx_wrap_s32(x0); e->left.rest = fx_wrap_s32(rest0) + left.den; e->right.column = fx_wrap_s32(x1); e->right.rest = fx_wrap_s32(rest1) + right.den; e->row = stop; }
; code: end = first + count; if (first < e->middle) rows(e, out, e->middle < end ? e->middle : end); if (e->row < end) { if (!e->turned) { edge_setup(e->lower_is_left ? &e->left : &e->right, e->lower_x, e->lower_y, e->lower_dx, e->lower_dy, e->row << 4); e->turned = 1; }
; code: int32_t first = e->row, count = e->last - first < most ? e->last - first : most,
; of the left edge
; shows: edges_setup: precondition of edge_setup: ends: -0x8000 ≤ x ≤ 0x8000 ∧ -0x8000 ≤ x + dx ≤ 0x8000
; shows: edges_setup: precondition of edge_setup: across: -0x8000 ≤ dx ≤ 0x8000
; shows: edges_setup: precondition of edge_setup: falls: 1 ≤ dy ≤ 0x8000
; shows: edges_setup: precondition of edge_setup: crossed: 0 ≤ centre - y ≤ dy
; of the right edge
; shows: edges_setup: precondition of edge_setup: ends: -0x8000 ≤ x ≤ 0x8000 ∧ -0x8000 ≤ x + dx ≤ 0x8000
; shows: edges_setup: precondition of edge_setup: across: -0x8000 ≤ dx ≤ 0x8000
; shows: edges_setup: precondition of edge_setup: falls: 1 ≤ dy ≤ 0x8000
; shows: edges_setup: precondition of edge_setup: crossed: 0 ≤ centre - y ≤ dy
; of the lower edge
; shows: edges_spans: precondition of edge_setup: ends: -0x8000 ≤ x ≤ 0x8000 ∧ -0x8000 ≤ x + dx ≤ 0x8000
; shows: edges_spans: precondition of edge_setup: falls: 1 ≤ dy ≤ 0x8000
; shows: edges_spans: precondition of edge_setup: crossed: 0 ≤ centre - y ≤ dy
; of both sides
; shows: rows: precondition of step: more: 0 ≤ e->rest_step < e->den
; shows: rows: precondition of step: negative: 0x100000000 - e->den ≤ *rest
; shows: rows: precondition of step: more: 0 ≤ e->rest_step < e->den
; shows: rows: precondition of step: negative: 0x100000000 - e->den ≤ *rest

; The top corner comes first, whichever it is.
(push)
(declare-const a Int)
(declare-const b Int)
(declare-const c Int)
(define-fun one () Bool (and (< b a) (<= b c)))
(define-fun two () Bool (and (not one) (< c a)))
(define-fun top () Int (ite one b (ite two c a)))
(assert (not (and (<= top a) (<= top b) (<= top c))))
(check-sat)
(pop)

; Corners, as edges_setup() moves them; row within the triangle, later the one where a side turns.
(define-fun corner ((v Int) (h Int)) Bool (<= (- h 16384) v (+ h 16384)))
(declare-const width Int)
(declare-const height Int)
(define-fun hw () Int (- (* 8 width) 8))
(define-fun hh () Int (- (* 8 height) 8))
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
(define-fun turns () Bool (< by cy))
(define-fun first () Int (div (+ ay 15) 16))
(define-fun middle () Int (div (+ (ite turns by cy) 15) 16))
(define-fun end () Int (div (+ (ite turns cy by) 15) 16))
(define-fun last () Int (ite (< end to) end to))
(define-fun row () Int (ite (> first from) first from))
(assert (< row last))
(define-fun asked ((x Int) (y Int) (dx Int) (dy Int) (centre Int)) Bool
  (and (<= (- 32768) x 32768) (<= (- 32768) (+ x dx) 32768) (<= (- 32768) dx 32768) (<= 1 dy 32768)
       (<= 0 (- centre y) dy)))
(push)
(assert (or turns (< row middle)))
(assert (not (asked ax ay (- cx ax) (- cy ay) (* 16 row))))
(check-sat)
(pop)
(push)
(assert (or (not turns) (< row middle)))
(assert (not (asked ax ay (- bx ax) (- by ay) (* 16 row))))
(check-sat)
(pop)
(push) ; edges_spans() turns at the first of its rows from `middle` on
(declare-const now Int)
(assert (and (<= row now) (<= middle now) (< now last)))
(assert (not (ite turns (asked bx by (- cx bx) (- cy by) (* 16 now)) (asked cx cy (- bx cx) (- by cy) (* 16 now)))))
(check-sat)
(pop)

; An edge keeps rest within [0, den) between rows(): less den it is negative, which a step keeps, and den is added again.
(declare-const den (_ BitVec 32))
(declare-const rest (_ BitVec 32))
(assert (and (bvule #x00000001 den) (bvule den #x40000000)))
(push)
(assert (and (bvult rest den) (not (bvuge (bvsub rest den) (bvneg den)))))
(check-sat)
(pop)
(push)
(assert (and (bvuge rest (bvneg den)) (not (bvult (bvadd rest den) den))))
(check-sat)
(pop)
