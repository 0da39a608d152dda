; SPDX-License-Identifier: MIT
; Entries of a table: within its bytes. Each question denies what is to be shown: unsat.
; source: firmware/raster/raster.h
; code: #define TABLE_DIFFUSE 64 #define TABLE_HIGHLIGHT 128 #define TABLE_BITS 10
; source: firmware/raster/table.c
; code: for (uint32_t j = 0; j < TABLE_HIGHLIGHT; j++) {
; code: for (uint32_t i = 0; i < TABLE_DIFFUSE; i++) { uint32_t sum[3]; for (int c = 0; c < 3; c++) sum[c] = s->base[c] + surface_diffuse(diffuse_of(i), s->light[0].diffuse[c]) + surface_diffuse(power, s->light[0].specular[c]); *entry++ = fx_u16(raster_colour(r, sum)); } } }
; code: const unsigned bits = TABLE_BITS - 7; /* FX_POWER_STEPS are 2^7 */
; code: for (unsigned i = 0; i < FX_POWER_STEPS; i++) {
; code: for (unsigned k = 0; k < 1u << bits; k++, entry += apart, value += step) *entry = fx_u16(ambient + (value >> 16)); } *first = fx_u16(ambient); }
; code: if (raster_is(r, GLINT_RGB565)) { make_colours(r, table->entry); return; } const unsigned channels = surface_channels(s); for (unsigned c = 0; c < channels; c++) make_highlights(s, c, table->entry + c, channels == 1 ? 1 : 4); }
; code: if (uses_format(format, GLINT_RGB565)) return head + 2 * TABLE_HIGHLIGHT * TABLE_DIFFUSE; if (uses_format(format, GLINT_GREY8)) return head + (2 << TABLE_BITS); return uses_format(format, GLINT_RGB888) ? head + (8 << TABLE_BITS) : 0; }
; shows: make_colours: mem_access: \valid(tmp_4)
; shows: make_highlights: mem_access: \valid(entry)
(declare-const i Int)
(declare-const j Int)
(declare-const c Int)
(push) ; row j, column i
(assert (and (<= 0 j 127) (<= 0 i 63)))
(assert (not (<= 0 (* 2 (+ (* 64 j) i)) (- (* 2 128 64) 2))))
(check-sat)
(pop)
(push) ; step i of the power, entry j of it; alone, or channel c of 4 numbers
(assert (and (<= 0 i 127) (<= 0 j 7) (<= 0 c 2)))
(define-fun entry () Int (+ (* 8 i) j))
(assert (not (and (<= 0 (* 2 entry) (- 2048 2)) (<= 0 (* 2 (+ (* 4 entry) c)) (- 8192 2)))))
(check-sat)
(pop)
