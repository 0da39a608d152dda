; SPDX-License-Identifier: MIT
; Corners of parts, wherever they are made: their two weights sum to 2^15 at most, and a part is a sub-pixel wide or high
; at least. What follows from that, part_channels.smt2 and part_shade.smt2 name. Each question denies what is to be shown: unsat.
; source: firmware/shade/part.c
; code: corner->weight[0] = k == 0 ? PART_ONE : 0; corner->weight[1] = k == 1 ? PART_ONE : 0;
; code: for (int i = 0; i < 2; i++) out->weight[i] = fx_u16((a->weight[i] + b->weight[i]) >> 1);
; code: const struct shape shape = shape_of(p), *const s = &shape;
; source: firmware/raster/draw_subdivide.c
; code: #define SPLIT_LEAST 16
; code: centre.weight[i] = fx_u16((fx_u32(corner[0].weight[i]) + corner[1].weight[i] + corner[2].weight[i]) / 3);
; code: for (; depth < PART_DEPTH && area > fx_u32(r->split.area) << 9 && height >= SPLIT_LEAST; depth++) { area >>= 2; height >>= 1; }
; code: more = more && height_of(r, part) >= SPLIT_LEAST && errs_at_centre(r, part);
; source: firmware/raster/split.c
; code: const unsigned a = whole->weight[corner[i][k][0]][c], b = whole->weight[corner[i][k][1]][c]; part.weight[k][c] = fx_u16((a + b) >> 1);
; code: *piece = (struct piece){{{PART_ONE, 0}, {0, PART_ONE}, {0, 0}}};
; code: more = bad && depth < SPLIT_DEPTH && part_height(place) >= LEAST_HEIGHT;
; source: firmware/plan/summit.c
; code: out[i] = fx_u16(u[i] + ((v[i] - u[i]) * t >> 10)); out[2] = fx_u16(SUMMIT_ONE - out[0] - out[1]); }
; code: across[b] = fx_u16((weight[b] * SUMMIT_ONE + others / 2) / others); across[c] = fx_u16(SUMMIT_ONE - across[b]);
; source: firmware/raster/draw_highlight.c
; code: corner.weight[0] = fx_u16(weight[0] * (PART_ONE / SUMMIT_ONE)); corner.weight[1] = fx_u16(weight[1] * (PART_ONE / SUMMIT_ONE));
; code: #define LEAST_LENGTH 4 << 19
; code: return x < LEAST_LENGTH && y < LEAST_LENGTH; }
; code: if (is_short(r, peak, end)) return 0; part_between(&r->input, peak, end, middle);
; code: const struct part_corner *const rest[3] = {peak, &end[0], &end[1]}, *const cut[3] = {&middle, &end[0], &end[1]};
; code: return draw_fan(r, e, a, b, c); uint32_t drawn = draw_fan(r, e, peak, a, b) + draw_fan(r, e, peak, c, a); return place == SUMMIT_EDGE ? drawn : drawn + draw_fan(r, e, peak, b, c); }
(define-fun share ((a Int) (b Int) (one Int)) Bool (and (<= 0 a) (<= 0 b) (<= (+ a b) one)))

; Half-way between two corners, a third of three.
(push)
(declare-const a0 Int)
(declare-const a1 Int)
(declare-const b0 Int)
(declare-const b1 Int)
(declare-const c0 Int)
(declare-const c1 Int)
(assert (and (share a0 a1 32768) (share b0 b1 32768) (share c0 c1 32768)))
(assert (not (and (share (div (+ a0 b0) 2) (div (+ a1 b1) 2) 32768)
                  (share (div (+ a0 b0 c0) 3) (div (+ a1 b1 c1) 3) 32768))))
(check-sat)
(pop)

; A highlight's summit, in weights that sum to 2^10: t / 2^10 of the way from u to v, and on an edge.
(push)
(declare-const u0 Int)
(declare-const u1 Int)
(declare-const v0 Int)
(declare-const v1 Int)
(declare-const t Int)
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (and (share u0 u1 1024) (share v0 v1 1024) (<= 0 t 1024)))
(assert (and (product u0 (- 1024 t)) (product v0 t) (product u1 (- 1024 t)) (product v1 t)
             (product (- 1024 u0 u1) (- 1024 t)) (product (- 1024 v0 v1) t)))
(assert (not (share (+ u0 (div (* (- v0 u0) t) 1024)) (+ u1 (div (* (- v1 u1) t) 1024)) 1024)))
(check-sat)
(pop)
(push)
(declare-const w Int)      ; weight[b]
(declare-const others Int) ; and weight[c] with it
(declare-const q Int)      ; the quotient
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(define-fun from () Int (+ (* 1024 w) (div others 2)))
(assert (and (<= 0 w others) (<= 1 others 1024) (<= (* q others) from) (< from (+ (* q others) others))))
(assert (and (product (- q 1025) others) (product (- (- q) 1) others)))
(assert (not (<= 0 q 1024)))
(check-sat)
(pop)
(push)
(declare-const a Int)
(declare-const b Int)
(assert (and (share a b 1024) (not (share (* 32 a) (* 32 b) 32768))))
(check-sat)
(pop)

; Extents: the largest difference between two corners, one way or the other, in 2^-15 sub-pixels. A triangle that has an
; area, of corners at whole sub-pixels, has three edges of 2^15 at least; each part that a new corner makes keeps one
; of them, or has half of an edge that was not short (2^21): its middle lies within half a weight of each of two.
(push)
(declare-const p Int)
(declare-const q Int)
(declare-const m Int)
(declare-const near Int) ; (corner 0 less corner 2) times what the middle's first weight was rounded down by, 1 or 0 halves
(declare-const far Int)  ; and of corner 1
(assert (and (<= (- 32768) near 32768) (<= (- 32768) far 32768) (= (* 2 m) (- (+ p q) near far))))
(assert (or (>= (- p q) 2097152) (>= (- q p) 2097152)))
(assert (not (and (or (>= (- m q) 32768) (>= (- q m) 32768)) (or (>= (- m p) 32768) (>= (- p m) 32768)))))
(check-sat)
(pop)
; A part that is split is 16 sub-pixels high or more by det / a, where a, its longest side, is at least its extent L, and
; det at most 2 L^2. So L is 8 sub-pixels or more, and half of that, exactly, its parts'; all halvings of a whole
; triangle together are of an L that lets each have 4.
(push)
(declare-const L Int)
(declare-const side Int)
(declare-const height Int)
(assert (and (<= 0 height) (<= 1 L side) (<= (* height side) (* 2 L L))))
(assert (=> (>= (- height (* 2 L)) 1) (>= (* (- height (* 2 L) 1) L) 0)))
(assert (=> (>= height 0) (>= (* height (- side L)) 0)))
(assert (not (<= height (* 2 L))))
(check-sat)
(pop)

; n leading zeros of the differences' bits and a scale of n - 3 (shape_of(): within): from 2^15 on that is 13 at most.
(declare-const scale Int)
(declare-const largest Int)
(define-fun above () Int (ite (>= scale 15) 16384 (ite (= scale 14) 32768 2147483648)))
(assert (and (<= (- 2) scale 28) (<= 32768 largest 1073741824) (< largest above)))
(push)
(assert (not (<= (- 2) scale 13)))
(check-sat)
(pop)
