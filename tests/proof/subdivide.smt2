; SPDX-License-Identifier: MIT
; The stack of parts: six for five depths, and a part that is split has one above it. What places and shades corners takes
; those that part_corners.smt2 is about. Each question denies what is to be shown: unsat.
; source: firmware/shade/shade.h
; code: struct part_split split[PART_DEPTH + 1];
; code: #define PART_DEPTH 5
; source: firmware/raster/draw_subdivide.c
; code: for (; depth < PART_DEPTH && area > fx_u32(r->split.area) << 9 && height >= SPLIT_LEAST; depth++) {
; code: struct part_split *const bottom = r->setup.parts.split, *top = bottom;
; code: more = fx_u32(top - bottom) < depth; if (more || centre) find_middles(&r->input, part); if (centre) more = more && height_of(r, part) >= SPLIT_LEAST && errs_at_centre(r, part);
; code: top->next = more ? 0 : 4; for (; top->next == 4; top--) if (top == bottom) return drawn; for (int k = 0; k < 3; k++) top[1].corner[k] = top->corner[part_of[top->next][k]]; top->next++; top++; }
; code: return depth ? split(r, e, depth, 0) : draw_gouraud(r, e); }
; code: return split(r, e, PART_DEPTH, 1);
; by part_corners.smt2
; shows: height_of: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: height_of: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: height_of: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: errs_at_centre: precondition of part_shade: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; by what follows
; shows: find_middles: precondition of part_between: there: \valid(out) ∧ \valid_read(a) ∧ \valid_read(b)
; shows: split: mem_access: \valid(&top->next)
; shows: split: mem_access: \valid(&(top + 1)->corner[k])
; shows: split: overlap: &(top + 1)->corner[k] ≡ &top->corner[part_of[top->next][k]] ∨ \separated(&(top + 1)->corner[k], &top->corner[part_of[top->next][k]])
; shows: split: index_bound: top->next < 4
; shows: parts_linear: user assertion: \valid_read(*(corner + 0)) ∧ \valid_read(*(corner + 1)) ∧ \valid_read(*(corner + 2))
(declare-const depth Int)
(declare-const t Int)    ; top - bottom
(declare-const more Bool)
(declare-const below Int) ; the place that is gone back to, if any
(declare-const next Int)  ; what is to be drawn there: of a place that was split, 1 to 4, and here not 4
(assert (and (<= 1 depth 5) (<= 0 t depth) (=> more (< t depth))))
(assert (and (<= 0 below) (< below t) (<= 1 next 4) (not (= next 4))))
(define-fun at () Int (ite more t below))
(define-fun drawn () Int (ite more 0 next))
(push)
(assert (not (and (<= 0 at) (<= (+ at 1) depth) (<= 0 drawn 3) (<= 1 (+ drawn 1) 4))))
(check-sat)
(pop)
