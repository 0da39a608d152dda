; SPDX-License-Identifier: MIT
; Vectors made unit ones, times and keys. Each question denies what is to be shown: unsat.
; source: firmware/geometry/rotation.c
; code: int shift = 0; /* squared = m * 2^(2 shift), m in [2^30, 2^32) */ while (squared >= UINT64_C(1) << 32) { squared >>= 2; shift++; } uint32_t m = fx_u32(squared), r = fx_rsqrt_norm(m);
; code: uint32_t r2 = fx_mulhi_u32(r, r); /* Q30, at most 2^30 */ uint32_t vr2 = fx_mulhi_u32(m, r2) << 2; /* Q28 -> Q30, near 2^30 */ int64_t correction = fx_s64(3u << 30) - vr2; r = fx_u32((fx_s64(r) * correction) >> 31); *exponent = shift; return r; }
; code: squared += fx_u64(fx_s64(v[i]) * v[i]) >> 2;
; code: int down = 31 + 16 + exponent - 30; for (int i = 0; i < terms; i++) { int64_t x = fx_s64(v[i]) * r; out[i] = fx_s32((x + (INT64_C(1) << (down - 1))) >> down); } }
; code: if (!(v[0] | v[1] | v[2])) {
; code: largest |= fx_u32(w[i] < 0 ? -w[i] : w[i]); } const unsigned up = fx_clz(largest) - 1; for (int i = 0; i < 3; i++) w[i] *= 1 << up; normalise(w, 3, out); }
; code: int64_t whole = fx_divide_s64(thousandths, 1000), rest = thousandths - whole * 1000; uint32_t half = fx_wrap_add(fx_wrap_u32(whole * 32768), fx_wrap_u32(fx_divide_s64(rest * 32768, 1000)));
; code: uint32_t t = fx_u32(fx_divide_u64(fx_u64(time_ms - a->time_ms) << 16, b->time_ms - a->time_ms));
; code: dot += (fx_s64(a->rotation[i]) * b->rotation[i]) >> 2; /* a quarter: four products of 2^60 */ int32_t q[4]; for (int i = 0; i < 4; i++) q[i] = mix(a->rotation[i], dot < 0 ? -b->rotation[i] : b->rotation[i], t);
; code: if (time_ms <= key[0].time_ms) return pose_of_key(&key[0]); if (time_ms >= key[last].time_ms) return pose_of_key(&key[last]); unsigned i = 0; while (key[i + 1].time_ms <= time_ms) i++; return pose_between(&key[i], &key[i + 1], time_ms); }
; shows: inverse_length: precondition of fx_rsqrt_norm: m ≥ 0x40000000
; shows: normalise: postcondition: first: -0x40004000 ≤ *(\old(out) + 0) ≤ 0x40004000
; shows: normalise: postcondition: second: -0x40004000 ≤ *(\old(out) + 1) ≤ 0x40004000
; shows: normalise: postcondition: third: -0x40004000 ≤ *(\old(out) + 2) ≤ 0x40004000
; shows: normalise: postcondition: fourth: \old(terms) ≡ 4 ⇒ -0x40004000 ≤ *(\old(out) + 3) ≤ 0x40004000
; shows: proof_clz: user assertion: x ≢ 0
; shows: vector_normalise: signed_overflow: -2147483648 ≤ w[i_0] * (int)(1 << up)
; shows: vector_normalise: signed_overflow: w[i_0] * (int)(1 << up) ≤ 2147483647
; shows: rotation_spin: signed_overflow: -9223372036854775808 ≤ rest * 32768
; shows: rotation_spin: signed_overflow: rest * 32768 ≤ 9223372036854775807
; shows: fx_divide_s64: signed_overflow: -n ≤ 9223372036854775807
; shows: pose_between: precondition of fx_divide_u64: d > 0
; shows: pose_between: precondition of mix: share: t ≤ 65536
; shows: pose_from_keys: mem_access: \valid_read(&(key + (unsigned int)(i + 1))->time_ms)
(define-fun product ((a Int) (b Int)) Bool (=> (and (>= a 0) (>= b 0)) (>= (* a b) 0)))

; Of three numbers that are not all 0, one is at least the largest power of 2 in their bits together, none twice that; so
; moved up by one less than the zeros before them all are below 2^31, and one is 2^30 at least.
(push)
(declare-const a (_ BitVec 32))
(declare-const b (_ BitVec 32))
(declare-const c (_ BitVec 32))
(declare-const power (_ BitVec 32))
(define-fun all () (_ BitVec 32) (bvor a b c))
(push)
(assert (not (and (= a #x00000000) (= b #x00000000) (= c #x00000000))))
(assert (not (not (= all #x00000000))))
(check-sat)
(pop)
(assert (and (bvult all #x80000000) (= (bvand power (bvsub power #x00000001)) #x00000000)))
(assert (and (bvuge all power) (bvult all (bvshl power #x00000001))))
(define-fun under ((x (_ BitVec 32))) Bool (bvult x (bvshl power #x00000001)))
(assert (not (and (or (bvuge a power) (bvuge b power) (bvuge c power)) (under a) (under b) (under c))))
(check-sat)
(pop)
(push)
(declare-const v Int) ; in size
(declare-const power Int)
(declare-const up Int)
(assert (and (= (* power up) 1073741824) (<= 1 up) (<= 1 power) (<= 0 v) (product (- (* 2 power) v 1) up) (product (- v power) up)))
(assert (not (and (=> (< v (* 2 power)) (< (* v up) 2147483648)) (=> (>= v power) (>= (* v up) 1073741824)))))
(check-sat)
(pop)

; A rotation between two of almost unit length, a and b (turned round where their product is negative: 12 above that by
; rounding): (1 - t)^2 a.a + t^2 b.b + 2 t (1 - t) a.b is at least half of the lesser but 12, for t of 65536ths.
(push)
(declare-const aa Int)
(declare-const bb Int)
(declare-const ab Int)
(declare-const t Int)
(define-fun least () Int 1152919305583591424) ; 2^60 (1 - 2^-19)
(define-fun s () Int (- 65536 t))
(assert (and (>= aa least) (>= bb least) (>= ab (- 12)) (<= 0 t 65536)))
(assert (and (product (- aa least) (* s s)) (product (- bb least) (* t t)) (product (+ ab 12) (* s t)) (product s t)
             (>= (* (- s t) (- s t)) 0)))
(assert (not (>= (+ (* s s aa) (* t t bb) (* 2 s t ab)) (* 4294967296 (- (div least 2) 12)))))
(check-sat)
(pop)
(push) ; a component q of it, e rounded by half at most: its square is less by no more than |e| and 1, here of halves
(declare-const q Int)
(declare-const e2 Int) ; 2 e
(assert (and (<= (- 1) (- (* 2 q) e2) 1) (<= (- 4294967296) e2 4294967296)))
(assert (product (+ 1 (- (* 2 q) e2)) (- 1 (- (* 2 q) e2))))
(declare-const gap Int)
(assert (= gap (- (* 2 q) e2)))
(assert (and (product (- 1 gap) (+ 4294967296 e2)) (product (+ 1 gap) (+ 4294967296 e2)) (product (- 1 gap) (- 4294967296 e2))
             (product (+ 1 gap) (- 4294967296 e2)) (>= (* gap gap) 0)))
(assert (not (>= (* 4 q q) (- (* e2 e2) 17179869184))))
(check-sat)
(pop)
(push) ; so four squares, a quarter of each, or one of 2^60, are 2^54 at least
(declare-const squares Int)
(declare-const squared Int)
(assert (or (>= squares 1152921504606846976) (>= squares (- (div 1152919305583591424 2) 12 17179869184))))
(assert (>= (* 4 squared) (- squares 12)))
(assert (not (>= squared 18014398509481984)))
(check-sat)
(pop)

; Moved down by twos it ends from 2^30 on.
(push)
(declare-const squared Int)
(assert (>= squared 4294967296))
(assert (not (>= (div squared 4) 1073741824)))
(check-sat)
(pop)

; The refined root: r = 2^46 / sqrt(m) within 2^-20.6 (tools/prove_bounds.py) times (3 - v r^2) / 2 is below
; (1 + 2^-18) of that, in squares 1 + 2^-16.
(declare-const m Int)
(declare-const r Int)
(declare-const p Int)  ; m r r
(assert (and (<= 1073741824 m 4294967295) (<= 1073741824 r 2147483648)))
(define-fun whole () Int 4951760157141521099596496896) ; 2^92
(assert (<= (- whole 9444732965739290427392) p (+ whole 9444732965739290427392)))
(push)
(declare-const r2 Int)
(declare-const mr2 Int) ; m r2
(declare-const vr2 Int)
(assert (and (< (- p (* 4294967296 mr2)) (* 4294967296 m)) (<= (* 4294967296 mr2) p))) ; r2 = r r / 2^32, rounded down
(assert (= vr2 (* 4 (div mr2 4294967296))))
(assert (not (<= (- 1073741824 4096) vr2 (+ 1073741824 4096))))
(check-sat)
(pop)
(push) ; r' <= r (2^31 + 2^12) / 2^31; times itself and m
(declare-const q Int) ; m r' r'
(assert (<= (* q 4611686018427387904) (* p (* (+ 2147483648 4096) (+ 2147483648 4096)))))
(assert (not (<= q (+ whole 75557863725914323419136))))
(check-sat)
(pop)
(push) ; a component c of 2^-shift: c^2 <= 4 (m + 2), so that (c r')^2 <= 4 m r' r' (1 + 2^-29): below 2^47 (1 + 2^-16)
(declare-const cr Int)
(declare-const q Int)
(define-fun most () Int (+ 140737488355328 2147483648)) ; 2^47 + 2^31
(assert (and (<= 0 q (+ whole 75557863725914323419136)) (<= (* cr cr 268435456) (* 4 q (+ 268435456 1)))))
(assert (and (product (- cr most) (+ cr most)) (product (- (- cr) most) (- most cr))))
(assert (not (<= (- most) cr most)))
(check-sat)
(pop)
(push) ; over 2^17, rounded
(declare-const cr Int)
(assert (<= (- (+ 140737488355328 2147483648)) cr (+ 140737488355328 2147483648)))
(define-fun out () Int (div (+ cr 65536) 131072))
(assert (not (<= (- 1073758208) out 1073758208)))
(check-sat)
(pop)

; Times: what is left of a division by 1000, and of key times that rise.
(push)
(declare-const n Int)
(declare-const q Int) ; of sizes
(assert (and (<= 0 (- n (* 1000 q))) (< (- n (* 1000 q)) 1000) (<= 0 n 72057594037927936)))
(assert (not (< (* 32768 (- n (* 1000 q))) 9223372036854775807)))
(check-sat)
(pop)
(push)
(declare-const a Int)
(declare-const b Int)
(declare-const time Int)
(declare-const t Int)
(assert (and (<= a time) (< time b) (<= (* t (- b a)) (* 65536 (- time a))) (product (- t 65537) (- b a))))
(assert (not (and (< 0 (- b a)) (<= t 65536))))
(check-sat)
(pop)
(push) ; the last key is later, so the search ends there
(declare-const i Int)
(declare-const last Int)
(declare-const time Int)
(declare-const next Int) ; key[i + 1]
(declare-const end Int)  ; key[last]
(assert (and (< i last) (< time end) (=> (= (+ i 1) last) (= next end)) (<= next time)))
(assert (not (< (+ i 1) last)))
(check-sat)
(pop)
