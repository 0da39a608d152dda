; SPDX-License-Identifier: MIT
; Frames of parts: from shapes and heights to what plane_linear() and plane_quadratic() ask. What shape_of(), height_of()
; and part_place() give is parts.h's. Each question denies what is to be shown: unsat.
; source: firmware/shade/plane.c
; code: return i < 0 ? 0 : fx_s32(size) - 1; }
; code: const int32_t left = x0 + 8 * fx_s32(width), top = y0 + 8 * fx_s32(height); plane->ox = inside(left >> 4, width); plane->oy = inside(top >> 4, height); plane->fx = plane->ox * 16 + 8 - left; plane->fy = plane->oy * 16 + 8 - top;
; code: return plane->up - 2 * plane->scale; }
; code: uint32_t height = plane->scale > 0 ? plane->det << plane->scale : plane->det >> -plane->scale;
; code: plane->slim = plane->sliver || height < 1u << 12;
; code: | fx_wrap_u32(plane->scale) >> 31) != 0; }
; source: firmware/frame.c
; code: !plane_setup(&setup->plane, in->place, r->width, r->height))
; source: firmware/shade/part.c
; code: const struct shape shape = shape_of(p), *const s = &shape; struct plane *plane = &frame->plane; frame->height = height_of(s); frame->lost = s->lost; if (s->det <= 0) return 0; const int zeros = fx_s32(fx_clz(fx_u32(s->det)));
; code: plane->whole_x1 = (p[1].x - p[0].x) >> 15; plane->whole_y1 = (p[1].y - p[0].y) >> 15; plane->whole_x2 = (p[2].x - p[0].x) >> 15; plane->whole_y2 = (p[2].y - p[0].y) >> 15; plane->scale = s->scale; plane->det = s->scale >= 0 ? fx_u32(s->det) >> 2 * s->scale : fx_u32(s->det) << -2 * s->scale; plane->up = zeros + 2 * s->scale; plane->r = fx_recip_norm(fx_u32(s->det) << zeros); plane->half = fx_s32(plane->r >> 1); plane->shift = zeros + s->scale - 14; plane->sliver = 0;
; code: nearest(p[0].x - (in->place[0][VERTEX_X] + whole->fx) * (1 << 15), &frame->i, &plane->fx, &frame->rest_x); nearest(p[0].y - (in->place[0][VERTEX_Y] + whole->fy) * (1 << 15), &frame->j, &plane->fy, &frame->rest_y);
; code: const int32_t ox = (in->place[0][VERTEX_X] + setup->plane.fx) * (1 << 15), oy = (in->place[0][VERTEX_Y] + setup->plane.fy) * (1 << 15); /* the origin */
; code: int32_t longest = (1 << 19) - 1;
; code: if (fx_s32(size_of(axis)) <= longest) continue; longest = fx_s32(size_of(axis)); steep = axis == y; from = axis > 0 ? k : next; to = axis > 0 ? next : k; } const unsigned up = fx_clz(fx_u32(longest)); const int64_t inverse = fx_recip_norm(fx_u32(longest) << up);
; code: for (int k = 0; k < 3; k++) off += steep ? oy - fx_s64(p[k].y) : ox - fx_s64(p[k].x);
; code: const int32_t first = corner[from]->colour[c] >> 2, last = corner[to]->colour[c] >> 2;
; code: const int64_t slope = (last - first) * inverse >> (28 - up); /* a pixel's, Q22 */
; code: #define MOST_UP_QUADRATIC 9
; code: if (!any || frame.height < 8) { narrow(setup, in, corner); return 1; }
; code: plane_setup_quadratic(&frame.plane); if (frame.height < 32 || frame.plane.up - 2 * frame.plane.scale > MOST_UP_QUADRATIC) return 0; frame.plane.thin = 0;
; code: plane_setup_quadratic(&frame.plane); if (frame.height < 8 || frame.plane.up - 2 * frame.plane.scale > MOST_UP_QUADRATIC) return 0; frame.plane.thin = 0;
; code: const int lost = frame.height < 16 ? 8 : frame.height < 32 ? 6 : 4;
; code: return (colour + (1 << (lost - 1))) >> lost; }
; code: value[k] = rounded(corner[k]->colour[c], lost);
; code: const int32_t ends = value[k] + value[k == 2 ? 0 : k + 1]; bulge[k] = (ends - 2 * rounded(middle[k].colour[c], lost)) * (1 << 15);
; by part_corners.smt2, of three corners each
; shows: frame_setup: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: frame_setup: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: frame_setup: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: narrow: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: narrow: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: narrow: precondition of part_place: weights: corner->weight[0] + corner->weight[1] ≤ 0x8000
; shows: frame_setup: shift: 0 ≤ (int)(2 * s->scale) < 32
; shows: part_linear: precondition of plane_linear: scale: -2 ≤ plane->scale ≤ 13
; by what follows
; shows: frame_setup: precondition of height_of: product: product(s)
; shows: frame_setup: precondition of fx_recip_norm: m ≥ 0x80000000
; shows: frame_setup: precondition of nearest: reach: -0x40000000 ≤ at ≤ 0x40000000
; shows: frame_setup: signed_overflow: p[0].x - (int)((int)((int)*(in->place[0] + 0) + whole->fx) * (int)(1 << 15)) ≤ 2147483647
; shows: frame_setup: precondition of nearest: reach: -0x40000000 ≤ at ≤ 0x40000000
; shows: frame_setup: signed_overflow: p[0].y - (int)((int)((int)*(in->place[0] + 1) + whole->fy) * (int)(1 << 15)) ≤ 2147483647
; shows: fx_clz: precondition of __builtin_clz: x_nonzero: x ≢ 0
; shows: narrow: precondition of fx_recip_norm: m ≥ 0x80000000
; shows: narrow: shift: 0 ≤ (unsigned int)(28 - up) < 64
; shows: narrow: signed_overflow: -9223372036854775808 ≤ slope * off
; shows: narrow: signed_overflow: slope * off ≤ 9223372036854775807
; shows: part_linear: precondition of plane_linear: odd: odd(plane)
; shows: part_linear: precondition of plane_linear: shift: -13 ≤ plane->shift ≤ 17
; shows: part_channel: precondition of plane_quadratic: scale: -2 ≤ plane->scale ≤ 13
; shows: part_channel: precondition of plane_quadratic: zeros: 3 ≤ plane->up - 2 * plane->scale ≤ 9
; shows: part_channel: precondition of plane_quadratic: shift: plane->shift ≡ (plane->up - plane->scale) - 14
; shows: part_channel: precondition of plane_quadratic: far: plane->scale ≥ 0 ∨ plane->far ≢ 0
; shows: part_channel: precondition of plane_quadratic: slim: plane->slim ≡ 0
; shows: part_quadratic: precondition of plane_quadratic: scale: -2 ≤ plane->scale ≤ 13
; shows: part_quadratic: precondition of plane_quadratic: zeros: 3 ≤ plane->up - 2 * plane->scale ≤ 9
; shows: part_quadratic: precondition of plane_quadratic: shift: plane->shift ≡ (plane->up - plane->scale) - 14
; shows: part_quadratic: precondition of plane_quadratic: far: plane->scale ≥ 0 ∨ plane->far ≢ 0
; shows: part_quadratic: precondition of plane_quadratic: slim: plane->slim ≡ 0
; shows: part_quadratic: precondition of plane_quadratic: bulges: bulge(*(bulge + 0)) ∧ bulge(*(bulge + 2)) ∧ -0x20000000 ≤ *(bulge + 1) ≤ 0x20000000

; The set-up's origin is a pixel of the picture: with a part's corner, within 2^30 of each other.
(push)
(declare-const x0 Int)   ; in->place[0]
(declare-const size Int) ; width or height
(declare-const at Int)   ; p[0]
(define-fun left () Int (+ x0 (* 8 size)))
(define-fun pixel () Int
  (let ((i (div left 16))) (ite (and (<= 0 i) (< i size)) i (ite (< i 0) 0 (- size 1)))))
(define-fun origin () Int (+ x0 (- (+ (* 16 pixel) 8) left)))
(assert (and (<= (- 16384) x0 16384) (<= 1 size 2048) (<= (- 536870912) at 536870912)))
(assert (not (and (<= (- 16384) origin 16384) (<= (- 1073741824) (- at (* origin 32768)) 1073741824))))
(check-sat)
(pop)

; In 64 bits: a determinant of z leading zeros (32 bits), a scale, a height, as shape_of() and height_of() give them.
(declare-const det (_ BitVec 64))
(declare-const z (_ BitVec 64))
(declare-const scale (_ BitVec 64))
(declare-const height (_ BitVec 64))
(define-fun two () (_ BitVec 64) #x0000000000000002)
(define-fun up () (_ BitVec 64) (bvadd z (bvshl scale #x0000000000000001)))
(push)
(assert (and (bvsgt det #x0000000000000000) (bvslt det #x0000000020000000)))
(assert (or (bvsgt scale #xfffffffffffffffe) (bvsle det #x0000000008000000)))
(assert (and (bvule z #x000000000000001f) (= (bvlshr det (bvsub #x000000000000001f z)) #x0000000000000001)))
(assert (and (bvsle #xfffffffffffffffe scale) (bvsle scale #x000000000000001c)))
; the reciprocal's number
(push)
(assert (not (bvuge (bvand (bvshl det z) #x00000000ffffffff) #x0000000080000000)))
(check-sat)
(pop)
; From a height of 8 on: the scale is 12 at most, the shift within -13..17; 3 to 9 leading zeros where there are 9 at
; most, by which a quadratic's scale and shift are those of a plane.
(assert (and (bvuge height #x0000000000000008) (bvule height #x000000000003ffff)))
(assert (bvuge (bvshl det two) (bvmul height (bvshl #x0000000000002000 (bvadd scale two)))))
(push)
(assert (not (and (bvsle scale #x000000000000000c) (bvuge z #x0000000000000003)
                  (bvsle #xfffffffffffffff3 (bvsub (bvadd z scale) #x000000000000000e))
                  (bvsle (bvsub (bvadd z scale) #x000000000000000e) #x0000000000000011)
                  (= (bvsub (bvadd z scale) #x000000000000000e) (bvsub (bvsub up scale) #x000000000000000e)))))
(check-sat)
(pop)
; It is not slim: its determinant in whole sub-pixels, times 2^scale or by 2^-scale, in 32 bits, is 2^12 at least.
(define-fun low ((v (_ BitVec 64))) (_ BitVec 64) (bvand v #x00000000ffffffff))
(define-fun twice () (_ BitVec 64) (bvshl (ite (bvsge scale #x0000000000000000) scale (bvneg scale)) #x0000000000000001))
(define-fun whole () (_ BitVec 64) (ite (bvsge scale #x0000000000000000) (bvlshr det twice) (low (bvshl det twice))))
(define-fun tall () (_ BitVec 64)
  (ite (bvsgt scale #x0000000000000000) (low (bvshl whole scale)) (bvlshr whole (bvneg scale))))
(push)
(assert (not (bvuge tall #x0000000000001000)))
(check-sat)
(pop)
; A negative scale's sign bit makes it far.
(push)
(assert (bvslt scale #x0000000000000000))
(assert (not (= (bvlshr (low scale) #x000000000000001f) #x0000000000000001)))
(check-sat)
(pop)
(pop)

; At the scale of -1 differences are below 2^30 (shape_of(): within), whole sub-pixels 2^15 - 1 at most.
(push)
(declare-const d Int)
(assert (and (< (- 1073741824) d 1073741824) (not (<= (- 32768) (div d 32768) 32767))))
(check-sat)
(pop)

; A narrow part: its longest difference from 2^19 - 1 to 2^30, of n leading zeros.
(push)
(declare-const longest (_ BitVec 64))
(declare-const n (_ BitVec 64))
(assert (and (bvule #x000000000007ffff longest) (bvule longest #x0000000040000000)))
(assert (and (bvule n #x000000000000001f) (= (bvlshr longest (bvsub #x000000000000001f n)) #x0000000000000001)))
(assert (not (and (bvule #x0000000000000001 n) (bvule n #x000000000000000d)
                  (bvuge (bvand (bvshl longest n) #x00000000ffffffff) #x0000000080000000))))
(check-sat)
(pop)
; Its slope: of values below 2^14, times less than 2^32, by 2^15 at least; thrice the way to the origin.
(push)
(declare-const difference Int)
(declare-const inverse Int)
(declare-const slope Int)
(declare-const off Int)
(declare-const k Int) ; 2^(28 - up)
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(assert (and (<= (- 16383) difference 16383) (<= 0 inverse 4294967295) (<= (- 3221225472) off 3221225472) (<= 32768 k)))
(assert (and (<= (* slope k) (* difference inverse)) (< (* difference inverse) (+ (* slope k) k))))
(assert (and (product (- 16383 difference) inverse) (product (+ 16383 difference) inverse)
             (product (- slope 1) (- k 32768)) (product (- (- slope) 1) (- k 32768))))
(push)
(assert (not (<= (- 2147483648) slope 2147483648)))
(check-sat)
(pop)
(assert (<= (- 2147483648) slope 2147483648))
(assert (and (product (- 2147483648 slope) (- 3221225472 off)) (product (- 2147483648 slope) (+ 3221225472 off))
             (product (+ 2147483648 slope) (- 3221225472 off)) (product (+ 2147483648 slope) (+ 3221225472 off))))
(assert (not (<= (- 9223372036854775807) (* slope off) 9223372036854775807)))
(check-sat)
(pop)

; Bends of colours rounded by 4 bits or more: two ends less twice a middle, each of 0 to 2^12.
(push)
(declare-const k Int) ; 2^lost
(declare-const a Int)
(declare-const b Int)
(declare-const m Int)
(define-fun rounded ((c Int)) Int (ite (= k 16) (div (+ c 8) 16) (ite (= k 64) (div (+ c 32) 64) (div (+ c 128) 256))))
(assert (and (<= 0 a 65535) (<= 0 b 65535) (<= 0 m 65535)))
(assert (not (<= (- 268435456) (* 32768 (- (+ (rounded a) (rounded b)) (* 2 (rounded m)))) 268435456)))
(check-sat)
(pop)
