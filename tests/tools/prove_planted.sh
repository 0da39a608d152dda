#!/bin/bash
# SPDX-License-Identifier: MIT
# prove_planted.sh FOLDER: whether the proofs see faults, each planted into a copy of the sources there by one sed.
set -u
folder=$1
status=0
planted() { # what, proof or `bounds`, file, sed
    rm -rf "$folder/tree" && mkdir -p "$folder/tree/tests/tools" && cp -r firmware hal boards host-tools "$folder/tree" && cp -r tests/proof "$folder/tree/tests" &&
        cp tests/tools/prove.py tests/tools/prove_bounds.py "$folder/tree/tests/tools" && sed -i "$4" "$folder/tree/$3" || exit 1
    if cmp -s "$3" "$folder/tree/$3"; then
        echo "FAIL planted $1: $3 is as it was"
        status=1
    elif (cd "$folder/tree" && if [ "$2" = bounds ]; then tests/tools/prove_bounds.py; else tests/tools/prove.py -o ../out "tests/proof/$2.c"; fi) \
        >"$folder/planted.log" 2>&1 || ! grep -q '^FAIL' "$folder/planted.log"; then
        echo "FAIL planted $1: proven nevertheless"
        status=1
    else
        echo "ok planted $1: $(sed -n 's/^   //p; s/^FAIL gappa //p' "$folder/planted.log" | head -1)"
    fi
}
mkdir -p "$folder"
planted "a shift too far" plane firmware/shade/plane.c 's/(y2 \* y2) << 3/(y2 * y2) << 4/'
planted "a clamp that lets more through" clip firmware/geometry/clip.c 's/down > 18/down > 22/'
planted "a corner more than there is room for" clip firmware/geometry/clip.c 's/(db < 0) \&\& to->count < CLIP/(db < 0) \&\& to->count <= CLIP/'
planted "a coefficient of more bits" placed firmware/geometry/transform.c 's/bits(fx_u64(largest_z)) - 24)/bits(fx_u64(largest_z)) - 44)/'
planted "an extent beyond its radius, in the lemma too" placed tests/proof/placed.smt2 's/(<= 0 whole (\* 8388608 R))/(<= 0 whole (* 8388608 1048576 R))/'
planted "keys of one time, in the lemma too" motion tests/proof/motion.smt2 's/(< time b)/(<= time b)/'
planted "a row more than the table has, in the lemma too" table tests/proof/table.smt2 's/(<= 0 j 127)/(<= 0 j 128)/'
planted "a turn too many" uv firmware/shade/uv.c 's/value\[k\] \*= 1 << 16;/value[k] *= 1 << 17;/'
planted "a place farther than the farthest, in the lemma too" light tests/proof/light.smt2 's/(<= most farthest)/(<= most (* 8 farthest))/'
planted "a unit vector of 16 bits" unit firmware/geometry/object.c 's/fx_clz(largest)) - 17;/fx_clz(largest)) - 16;/'
planted "a cut without a length, in the lemma too" clip tests/proof/clip.smt2 's/(< d1 0)/(<= d1 0)/'
planted "a texture's mask one too large" texture firmware/raster/texture.c 's/(1u << t->log2_height) - 1/(1u << t->log2_height)/'
planted "an index one too far" power firmware/fixed/power.c 's/value\[FX_POWER_STEPS + 1\]/value[FX_POWER_STEPS + 2]/'
planted "a message given before its last byte" parser host-tools/view/parser.c 's/if (count < p->need)/if (count + 1 < p->need)/'
planted "a length of any size" parser host-tools/view/parser.c 's/return m->length <= PARSER_OTHER/return m->length <= 0xffffffffu/'
planted "a ring one byte too long" uart hal/cortexm/uart.c 's/(gone + i) % SERIAL_WAITING/(gone + i) % (SERIAL_WAITING + 1)/'
planted "a row that the texture does not have" scene_effects firmware/scene/texel.c 's/v + 1 < height ?/v < height ?/'
planted "a line more than the menu has" menu firmware/app/menu.c 's/i < CONTROL_LINES/i <= CONTROL_LINES/'
planted "a branch that nothing reaches" power firmware/fixed/power.c 's/if (s <= 0)/if (n > 1023)\n        return 1;\n    if (s <= 0)/'
planted "an entry of a table one too small" bounds firmware/fixed/fixed.c 's/255, 253, 251, 249, 247, 246/255, 253, 251, 249, 247, 245/'
planted "a length one off" receive firmware/stream/receive.c 's/r->count < STREAM_HEADER)$/r->count <= STREAM_HEADER)/'
planted "an index that is not checked" receive firmware/app/remote.c 's/if (value >= count)/if (value > count)/'
planted "a line without room for its end" text firmware/app/text.c 's/sizeof line->text - 1)/sizeof line->text)/'
planted "a table one byte short" tables hal/panels/wire.c 's/i += 2 + count;/i += 3 + count;/'
planted "a line that is not in the menu" control firmware/app/control.c 's/line, CONTROL_LINES)/line, CONTROL_LINES + 1)/'
planted "decimals without end" numbers boards/linux/values.c 's/ \&\& scale <= unit; digit++/; digit++/'
planted "a copy of a byte too many" unpack host-tools/view/unpack.c 's/(u->out_end - u->out))$/(u->out_end - u->out) + 1)/'
planted "room that the buffer does not have" stream firmware/stream/stream.c 's/s->buffer, bytes - 1}/s->buffer, bytes + 1}/'
planted "a round without its room" pack firmware/stream/pack.c 's/PACK_MARGIN 6u/PACK_MARGIN 3u/'
planted "a bit more of an index" spans firmware/raster/spans.h 's/fx_saturated(v->l, 6, 24)/fx_saturated(v->l, 7, 23)/'
planted "a floor that is none" divmod firmware/fixed/fixed.h 's/r + (below & den)/r + (below \& 1)/'
planted "a remainder one off" edge firmware/raster/edges.c 's/rest >= den/rest > den/'
planted "a turn a row late" edges firmware/raster/edges.c 's/if (first < e->middle)/if (first <= e->middle)/'
planted "a row more than there is room for" edges firmware/raster/edges.c 's/} while (++out < end);/} while (++out <= end);/'
planted "a bound that a lemma does not have" edge tests/proof/edge.smt2 's/(<= (- 2048) c 2048)/(<= (- 2047) c 2048)/'
planted "a remainder one off, in the lemma too" edge tests/proof/edge.smt2 's/(>= rest den)/(> rest den)/'
planted "a turn a row late, in the lemma too" edges tests/proof/edges.smt2 's/(<= middle now)/(<= (- middle 1) now)/'
planted "a bulge without its limit" dots firmware/shade/dots.c 's/bulge < -INT32_MAX ? -INT32_MAX/bulge < INT32_MIN ? INT32_MIN/'
planted "a place's weight too wide" part firmware/shade/part.c 's/rest_x \* (1 << 13)/rest_x * (1 << 18)/'
planted "a scale one too large, in the lemma" part_shape tests/proof/part_shape.smt2 's/bvsub n #x0000000000000012/bvsub n #x0000000000000011/'
planted "a place's share beyond 1, in the lemma" part tests/proof/part.smt2 's/(<= 0 v) (<= 0 w)/(<= 0 v)/'
planted "a light without room" part_shade firmware/shade/part.c 's/lights\[2 \* SCENE_MAX_LIGHTS\]/lights[2 * SCENE_MAX_LIGHTS - 1]/'
planted "a bend that does not fit" colours firmware/shade/color6.c 's/(1 << 13);/(1 << 15);/'
planted "a divisor of fewer bits, in the lemma" fine_divide tests/proof/fine_divide.smt2 's/131072 k/1024 k/'
planted "a side's halvings without room" highlight firmware/raster/draw_highlight.c 's/int left\[2\] = {HALVINGS, HALVINGS}/int left[1] = {HALVINGS}/'
planted "a stack without its last part" subdivide tests/proof/subdivide.smt2 's/(=> more (< t depth))/(=> more (<= t depth))/'
planted "a part that there is not" split firmware/raster/split.c 's/(2 \* depth - 2) & 3/(2 * depth - 2) \& 7/'
planted "a part as low as 2 sub-pixels, in the lemma" part_channels tests/proof/part_channels.smt2 's/bvuge height #x0000000000000008/bvuge height #x0000000000000002/'
planted "a product of coordinates too large" part_planes firmware/shade/plane.c 's/(x1 \* y2 + x2 \* y1) \* 4/(x1 * y2 + x2 * y1) * 8/'
planted "a light too many" surface firmware/shade/surface.c 's/i < scene->light_count/i <= scene->light_count/'
planted "a shift of another scale" plane_setup firmware/shade/plane.c 's/up - scale - 14/up - scale - 13/'
planted "a corner outside the box" plane_setup tests/proof/plane_setup.smt2 's/(<= 0 v 32768)/(<= 0 v 32769)/'
planted "a remainder that is none" divmod tests/proof/divmod_narrow.smt2 's/(- den 1 r) r)/(- den r) r)/'
planted "a pixel's place twice as far" exact firmware/shade/plane_wide.c 's/(x - plane->ox) \* 16/(x - plane->ox) * 32/'
planted "weights of more than 1" exact tests/proof/exact.smt2 's/(<= (+ nu nv) m)/(<= nu m) (<= nv m)/'
planted "a chord of the wrong quotient" curve tests/proof/curve.smt2 's/(> range (\* 4 scaled))/(> range scaled)/'
planted "N.L in steps that do not fit" dots_setup firmware/shade/steps.h 's/high < 1 << 15/high < 1 << 17/'
planted "samples of more than unit vectors" dots_setup tests/proof/six_samples.smt2 's/2 36864 (+ xy/2 44816 (+ xy/'
planted "weights without their sum" piece tests/proof/piece.smt2 's/(= (+ wa wb wc) 32768)/(<= (+ wa wb wc) 98304)/'
planted "a place rounded by more" places firmware/shade/piece.c 's/finer\[1\]) >> 8)/finer[1]) * 256)/'
planted "a product of 65 bits" perspective firmware/shade/perspective.c 's/product >> 1)) >> 31/product)) >> 32/'
planted "bends of any normals" x tests/proof/x.smt2 's/(\* 4 (- 1 bend)) 0.0035/4 0.0035/'
planted "a light that there is not" x firmware/shade/x.c 's/in->lights\[k\]\[2 \* light/in->lights[k][3 * light/'
planted "vectors longer than unit ones" normal_quadratic tests/proof/normal_quadratic.smt2 's/(<= (\* v v) 1.0006)/(<= (* v v) 2.0)/'
planted "an edge of the wrong corner" normal_quadratic firmware/shade/normal_quadratic.c 's/\*b = corner\[e == 2 ? 0 : e + 1\]/*b = corner[e + 1]/'
planted "a count of descriptors that are not there" ffs hal/linux/ffs.c 's/super_speed_count = 5/super_speed_count = 6/'
planted "a button more than there are lines" values boards/linux/values.c 's/count == GPIO_LINES/count > GPIO_LINES/'
planted "a list that goes on behind its end" names host-tools/view/names.c 's/at < end; at +=/at <= end; at +=/'
planted "a queue a byte too long" usb_stream hal/linux/usb_stream.c 's/size > u->size - (u->written/size > u->size + 1 - (u->written/'
planted "a turned line that begins a byte late" panels hal/panels/turn.c 's/panel->across - 1u - x : x/panel->across - x : x/'
planted "room for a byte less" wp/parser host-tools/view/parser.c 's/room = 2 \* (p->count + size)/room = p->count + size - 1/'
planted "a band of more rows than are left" frames host-tools/view/frames.c 's/p->height - m->y ||/p->height ||/'
planted "a table of 32 entries" crc32 firmware/scene/crc32.c 's/nibble\[crc \& 15\]/nibble[crc \& 31]/'
planted "columns a bit finer than they fit" fine firmware/raster/fine.c 's/- 8) \* (FINE_ONE \/ 16), hh/- 8) * FINE_ONE, hh/'
planted "a shift by 32" fixed firmware/fixed/exponential.c 's/whole > 17/whole > 40/'
planted "a first step that is forgotten" fog firmware/plan/fog.c 's/    if (down >= 32)$/    if (down > 32)/'
planted "a triple product of whole numbers" highlighted firmware/plan/highlighted.c 's/high += (cross >> 32) \* n\[i\]/high += cross * n[i]/'
planted "a way of a bit more" object firmware/geometry/object.c 's/1 << (fx_clz(largest) - 2)/1 << (fx_clz(largest) - 1)/'
planted "a part's fourth corner" parts firmware/raster/parts.c 's/for (int k = 0; k < 3; k++)/for (int k = 0; k <= 3; k++)/'
planted "a difference of corners in 32 bits" plane_wide firmware/shade/plane_wide.c 's/fx_s64(value\[1\]) - value\[0\], /value[1] - value[0], /'
planted "a queue that is not turned" queue host-tools/view/queue.c 's/(q->first + q->count) % q->room/q->first + q->count/'
planted "a matrix of twice the length" rotation firmware/geometry/rotation.c 's/round_q60(2 \* (x \* y - w/round_q60(4 * (x * y - w/'
planted "a pixel behind the run" runs firmware/raster/runs.c '/raster_divisors/,/^}/s/i < n/i <= n/'
planted "a weight below 0" summit firmware/plan/summit.c 's/- u\[i\]) \* t >> 10/- u[i]) * t >> 9/'
planted "an edge of more columns than there are" fine_edge firmware/raster/fine.c 's/- 1) >> FINE_BITS/- 1) >> (FINE_BITS - 4)/'
planted "a shift by less than nothing" project firmware/geometry/project.c 's/down >= -14/down >= -32/'
planted "a sum after the last" raster_dots firmware/raster/dots.c '/run_folded/,/shade_channels/!s/i < n; i++, sum += 3/i <= n; i++, sum += 3/'
planted "a range of nothing" transform firmware/geometry/transform.c 's/t->range ? t->range : 1/t->range/'
planted "a row twice as long" write firmware/raster/write.c 's/row += x >> 1/row += x/'
exit $status
