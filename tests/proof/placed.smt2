; SPDX-License-Identifier: MIT
; An object's transform: nothing is moved up beyond 63 bits. Each question denies what is to be shown: unsat.
; source: firmware/scene/scene_check.c
; code: return ((uint64_t)(fx_root(furthest) + 1) * (uint32_t)mesh->extent + 32767) >> 15 <= (uint32_t)mesh->radius
; source: firmware/geometry/transform.c
; code: if (down <= 0) return x * (INT64_C(1) << -down); return (x + (INT64_C(1) << (down - 1))) >> down; }
; code: return scaled(x * (m >> cut), down - cut) + scaled(x * (m & ((1 << cut) - 1)), down); }
; code: int64_t m = scaled(c[i], c_exponent - exponent - 14);
; code: row->t = fx_s32(scaled(t, t_exponent - exponent)); }
; code: centre += fx_s64(world.m[i][j]) * mesh->centre[j]; /* Q46, below 2^62 */ centre = scaled(centre, 22); /* Q24 */ offset[i] = long_product(centre, pose->scale, 8, 16) + /* scale in Q16 */ (fx_s64(pose->position[i]) - view->position[i]) * 256;
; code: eye[i] += long_product(offset[j], view->matrix.m[i][j], 16, 30);
; code: int64_t extent = fx_s64(mesh->extent) * pose->scale; /* below 2^54 */ int unit_exponent = 32 + 15; while (extent >= INT64_C(1) << 31) { /* 31 bits are more than a vertex's 16 can show */ extent = (extent + 1) >> 1; unit_exponent--; } int64_t radius = scaled(fx_s64(mesh->radius) * pose->scale, 8) + 1; /* Q24 */ int64_t ahead = -eye[2]; if (ahead + radius < fx_s64(view->near_plane) * 256 || ahead - radius > fx_s64(view->far_plane) * 256) return 0;
; code: int64_t largest_z = magnitude(ahead) + radius; int z_exponent = 29 - (bits(fx_u64(largest_z)) - 24);
; code: if (USES(USES_ORTHOGRAPHIC) && view->kind == CAMERA_ORTHOGRAPHIC && z_exponent > far_exponent) z_exponent = far_exponent;
; code: int64_t side = magnitude(eye[0]) > magnitude(eye[1]) ? magnitude(eye[0]) : magnitude(eye[1]); int side_bits = bits(fx_u64(side + radius)) - 24 + 31 - view->focal_exponent; int xy_exponent = 29 - side_bits;
; code: int64_t c = scaled(fx_s64(to_eye->m[i][j]) * extent, i < 2 ? 31 : 30); if (i < 2) c = scaled(c * view->focal, 16); /* below 2^30, in unit_exponent - 1 */ coefficient[j] = sign * c;
; code: axis_setup(row[i], coefficient, unit_exponent, ahead, 24, z_exponent);
; code: int spare = bits(fx_u64(magnitude(eye[i]))) - 31; spare = spare > 0 ? spare : 0; axis_setup(row[i], coefficient, unit_exponent - 1 + view->focal_exponent - 16, sign * (scaled(eye[i], spare) * view->focal), 24 - spare + view->focal_exponent, xy_exponent);
; code: const int64_t limit = (INT64_C(1) << 30) - 1; int64_t near_z = scaled(fx_s64(view->near_plane), 16 - z_exponent); int64_t far_z = bits(fx_u64(view->far_plane)) + z_exponent - 16 > 30 ? limit : scaled(fx_s64(view->far_plane), 16 - z_exponent); out->near_z = fx_s32(near_z < 1 ? 1 : near_z > limit ? limit : near_z); out->far_z = fx_s32(far_z); out->far_z += !out->far_z;
; shows: scaled: signed_overflow: -9223372036854775808 ≤ x * (long long)(1LL << (int)(-down))
; shows: scaled: signed_overflow: x * (long long)(1LL << (int)(-down)) ≤ 9223372036854775807
; shows: scaled: signed_overflow: x + (long long)(1LL << (int)(down - 1)) ≤ 9223372036854775807
; shows: axis_setup: precondition of scaled: count: -62 ≤ down ≤ 62
; shows: axis_setup: precondition of scaled: up: down ≤ 0 ⇒ -0x7fffffffffffffff ≤ x * (1 << -down) ≤ 0x7fffffffffffffff
; shows: axis_setup: precondition of scaled: count: -62 ≤ down ≤ 62
; shows: axis_setup: precondition of scaled: room: 1 ≤ down ⇒ x ≤ 0x7fffffffffffffff - (1 << (down - 1))
; shows: axis_setup: precondition of scaled: up: down ≤ 0 ⇒ -0x7fffffffffffffff ≤ x * (1 << -down) ≤ 0x7fffffffffffffff
; shows: transform_setup: precondition of long_product: size: -0x700000000000 ≤ x ≤ 0x700000000000
; shows: transform_setup: signed_overflow: sign * (int64_t)((int64_t __attribute__((__cold__)))(tmp_19 * (int64_t __attribute__((__cold__)))view->focal)) ≤ 9223372036854775807
; shows: transform_setup: signed_overflow: -9223372036854775808 ≤ tmp_19 * (int64_t __attribute__((__cold__)))view->focal
; shows: transform_setup: signed_overflow: tmp_19 * (int64_t __attribute__((__cold__)))view->focal ≤ 9223372036854775807
; shows: transform_setup: precondition of scaled: up: down ≤ 0 ⇒ -0x7fffffffffffffff ≤ x * (1 << -down) ≤ 0x7fffffffffffffff
; shows: transform_setup: signed_overflow: out->far_z + (int)(out->far_z ≢ 0? 0: 1) ≤ 2147483647
; shows: transform_setup: signed_overflow: -2147483648 ≤ out->far_z - out->near_z
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))
(define-fun end () Int 9223372036854775808)

; What scaled() does is what its contract speaks of.
(push)
(declare-const x Int)
(declare-const half Int)
(assert (<= x (- end 1 half)))
(assert (not (< (+ x half) end)))
(check-sat)
(pop)

; A mesh's centre in the world: a row of a rotation's matrix is at most 2^30 + 2^14 long, the centre sqrt(3) 2^30, and by
; Cauchy and Schwarz (the difference is a sum of squares) so is their product.
(declare-const m0 Int)
(declare-const m1 Int)
(declare-const m2 Int)
(declare-const c0 Int)
(declare-const c1 Int)
(declare-const c2 Int)
(define-fun square ((x Int)) Int (* x x))
(define-fun row2 () Int (+ (square m0) (square m1) (square m2)))
(define-fun length2 () Int (+ (square c0) (square c1) (square c2)))
(define-fun sum () Int (+ (* m0 c0) (* m1 c1) (* m2 c2)))
(push)
(assert (not (= (- (* row2 length2) (square sum))
                (+ (square (- (* m0 c1) (* m1 c0))) (square (- (* m0 c2) (* m2 c0))) (square (- (* m1 c2) (* m2 c1)))))))
(check-sat)
(pop)
(push)
(declare-const row Int)
(declare-const length Int)
(declare-const s Int)
(declare-const rest Int)
(define-fun turn () Int (+ 1073741824 16384))
(define-fun most () Int 1997090906113605632) ; 1.7322 * 2^60
(assert (and (<= 0 row (* turn turn)) (<= 0 length (* 3 1152921504606846976)) (<= 0 rest)))
(assert (= (* row length) (+ (* s s) rest)))
(assert (and (product (- (* turn turn) row) length) (product (- s most) (+ s most)) (product (- (- s) most) (- most s))))
(assert (not (<= (- most) s most)))
(check-sat)
(pop)
(push) ; times a scale below 2^8, and as far from the eye as positions are: below 7 * 2^44
(declare-const centre Int) ; in size
(declare-const scale Int)
(declare-const away Int)
(declare-const offset Int)
(assert (and (<= 0 centre (+ 1 (div 1997090906113605632 4194304))) (<= 0 scale 16777215) (<= 0 away 2147483647)))
(assert (product (- (+ 1 (div 1997090906113605632 4194304)) centre) scale))
(assert (<= (* 65536 offset) (+ (* centre scale) (* 2 65536) (* 65536 256 away))))
(assert (not (<= offset 123145302310912)))
(check-sat)
(pop)

; The radius, Q24, and the extent, which was halved to K parts and rounded up: at most 2^23 radii and 1.
(declare-const R Int)
(declare-const extent Int)
(declare-const radius Int)
(declare-const scale Int)
(push)
(assert (and (<= 1 scale) (<= extent (* 32768 radius)) (<= (* radius scale) (* 256 R)) (product (- (* 32768 radius) extent) scale)))
(assert (not (<= (* extent scale) (* 8388608 R))))
(check-sat)
(pop)
(declare-const whole Int) ; extent * scale
(declare-const E Int)
(declare-const K Int)  ; 2^0 to 2^23
(declare-const EK Int) ; E K
(declare-const B Int)  ; a power of 2 above what is R at least
(declare-const cK Int) ; a coefficient's size times K
(assert (and (<= 1 R) (< R B) (<= 1 K 8388608) (<= 0 whole (* 8388608 R)) (<= 0 EK (+ whole K))))
(push) ; of z: E (1 + 2^-16) rounded
(assert (<= (* 65536 cK) (+ (* 65537 EK) (* 65536 K))))
(assert (not (<= cK (* 16777216 B))))
(check-sat)
(pop)
(push) ; of x and y: E / 2 (1 + 2^-16) rounded, times a focal length below 2^31, rounded in Q16
(assert (<= (* 65536 cK) (+ (* 16384 65537 EK) (* 65536 32769 K))))
(assert (not (<= cK (* 549755813888 B))))
(check-sat)
(pop)

; Moved up by U = 2^-down it fits. Of z, -down = z_exponent + 14 - 47 + k <= 20 + k - b; of x and y 6 + k - b.
(push)
(declare-const c Int)
(declare-const U Int)
(assert (and (= cK (* c K)) (<= 0 c) (<= 1 U)))
(push)
(assert (and (<= cK (* 16777216 B)) (<= (* U B) (* 1048576 K))))
(assert (and (product c (- (* 1048576 K) (* U B))) (product (- (* c U) 17592186044417) B)))
(assert (not (<= (* c U) 17592186044416)))
(check-sat)
(pop)
(assert (and (<= cK (* 549755813888 B)) (<= (* U B) (* 64 K))))
(assert (and (product c (- (* 64 K) (* U B))) (product (- (* c U) 35184372088833) B)))
(assert (not (<= (* c U) 35184372088832)))
(check-sat)
(pop)

; The places: b bits, at most 49, of |ahead| + R; `up` = z_exponent - 24 <= 29 - b, and |ahead| < 2^b. The near plane, 256
; times it at most ahead + R: up z_exponent - 16.
(declare-const U Int)
(declare-const ahead Int) ; in size
(declare-const near Int)
(push)
(assert (and (<= 0 ahead) (< ahead B) (<= 1 U) (<= (* U B) 536870912) (product (- B ahead) U)))
(assert (not (<= (* ahead U) 536870912)))
(check-sat)
(pop)
(push)
(assert (and (<= 0 near) (< (* 256 near) B) (<= 1 U) (<= (* U B) 137438953472) (product (- B (* 256 near)) U)))
(assert (not (<= (* near U) 536870912)))
(check-sat)
(pop)
(declare-const b Int)     ; bits of |ahead| + R, of side + R
(declare-const k Int)
(declare-const far Int)   ; bits of the far plane
(declare-const z Int)     ; z_exponent
(declare-const focal Int) ; focal_exponent
(declare-const eye Int)   ; bits of |eye[i]|, not more than b
(define-fun spare () Int (ite (> eye 31) (- eye 31) 0))
(define-fun xy () Int (- 29 (- (+ (- b 24) 31) focal)))
(assert (and (<= 1 b 49) (<= 0 k 23) (<= 1 far 31) (<= 0 eye b)))
(assert (let ((own (- 29 (- b 24))) (held (- 30 (- far 16)))) (or (= z own) (and (= z held) (< held own)))))
(define-fun down_c () Int (- 47 k z 14))
(define-fun down_t () Int (- 24 z))
(define-fun down_xy () Int (- (- (+ (- 47 k 1) focal) 16) xy 14))
(define-fun down_txy () Int (- (+ (- 24 spare) focal) xy))
(push)
(assert (not (and (<= (- 62) down_c 62) (<= (- down_c) (+ 20 k (- b))) (<= (- 62) down_t 62) (<= (- down_t) (- 29 b))
                  (<= (- 62) down_xy 62) (<= (- down_xy) (+ 6 k (- b))) (<= 2 down_txy 51) (<= (- z 16) (- 37 b)))))
(check-sat)
(pop)

; x and y of the eye in 31 bits, times the focal length: 2^62, with room for half of 2^51; ahead with half of 2^62.
(push)
(declare-const part Int) ; of |eye[i]|, rounded
(declare-const length Int)
(assert (and (<= 0 part 2147483648) (<= 1073741824 length 2147483647) (product (- 2147483648 part) length)))
(assert (not (<= (* part length) (- end 1 1125899906842624))))
(check-sat)
(pop)

; The far plane is held below 2^30, or of so many bits; the near one is, too.
(push)
(declare-const plane Int) ; of `far` bits
(declare-const power Int) ; 2^far
(declare-const moved Int)
(assert (and (<= 0 plane) (< plane power) (<= 1 U) (<= (* U power) 1073741824) (= moved (* plane U)) (product (- power plane 1) U)))
(assert (not (<= 0 moved 1073741823)))
(check-sat)
(pop)
(push)
(declare-const far_z Int)
(declare-const near_z Int)
(assert (and (<= 0 far_z 1073741824) (<= 1 near_z 1073741823)))
(define-fun held () Int (ite (= far_z 0) 1 far_z))
(assert (not (and (<= held 2147483647) (<= (- 1073741823) (- held near_z) 1073741823))))
(check-sat)
(pop)
