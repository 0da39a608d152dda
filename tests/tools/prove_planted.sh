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
[ -z "${ALL-}" ] || planted "a texture's mask one too large" texture firmware/raster/texture.c 's/(1u << t->log2_height) - 1/(1u << t->log2_height)/'
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
[ -z "${ALL-}" ] || planted "a line without room for its end" text firmware/app/text.c 's/sizeof line->text - 1)/sizeof line->text)/'
planted "a table one byte short" tables hal/panels/wire.c 's/i += 2 + count;/i += 3 + count;/'
planted "a line that is not in the menu" control firmware/app/control.c 's/line, CONTROL_LINES)/line, CONTROL_LINES + 1)/'
planted "decimals without end" numbers boards/linux/values.c 's/ \&\& scale <= unit; digit++/; digit++/'
planted "a copy of a byte too many" unpack host-tools/view/unpack.c 's/(u->out_end - u->out))$/(u->out_end - u->out) + 1)/'
planted "room that the buffer does not have" stream firmware/stream/stream.c 's/s->buffer, bytes - 1}/s->buffer, bytes + 1}/'
[ -z "${ALL-}" ] || planted "a round without its room" pack firmware/stream/pack.c 's/PACK_MARGIN 6u/PACK_MARGIN 3u/'
[ -z "${ALL-}" ] || planted "a bit more of an index" spans firmware/raster/spans.h 's/fx_saturated(v->l, 6, 24)/fx_saturated(v->l, 7, 23)/'
planted "a floor that is none" divmod firmware/fixed/fixed.h 's/r + (below & den)/r + (below \& 1)/'
planted "a remainder one off" edge firmware/raster/edges.c 's/rest >= den/rest > den/'
planted "a turn a row late" edges firmware/raster/edges.c 's/if (first < e->middle)/if (first <= e->middle)/'
planted "a row more than there is room for" edges firmware/raster/edges.c 's/} while (++out < end);/} while (++out <= end);/'
planted "a bound that a lemma does not have" edge tests/proof/edge.smt2 's/(<= (- 2048) c 2048)/(<= (- 2047) c 2048)/'
planted "a remainder one off, in the lemma too" edge tests/proof/edge.smt2 's/(>= rest den)/(> rest den)/'
planted "a turn a row late, in the lemma too" edges tests/proof/edges.smt2 's/(<= middle now)/(<= (- middle 1) now)/'
planted "a bulge without its limit" dots firmware/shade/dots.c 's/bulge < -INT32_MAX ? -INT32_MAX/bulge < INT32_MIN ? INT32_MIN/'
planted "a place's weight too wide" part firmware/shade/part.c 's/rest_x \* (1 << 13)/rest_x * (1 << 18)/'
[ -z "${ALL-}" ] || planted "a light too many" surface firmware/shade/surface.c 's/i < scene->light_count/i <= scene->light_count/'
planted "a count of descriptors that are not there" ffs hal/linux/ffs.c 's/super_speed_count = 5/super_speed_count = 6/'
planted "a button more than there are lines" values boards/linux/values.c 's/count == GPIO_LINES/count > GPIO_LINES/'
planted "a list that goes on behind its end" names host-tools/view/names.c 's/at < end; at +=/at <= end; at +=/'
[ -z "${ALL-}" ] || planted "a queue a byte too long" usb_stream hal/linux/usb_stream.c 's/size > u->size - (u->written/size > u->size + 1 - (u->written/'
[ -z "${ALL-}" ] || planted "a turned line that begins a byte late" panels hal/panels/turn.c 's/panel->across - 1u - x : x/panel->across - x : x/'
[ -z "${ALL-}" ] || planted "room for a byte less" wp/parser host-tools/view/parser.c 's/room = 2 \* (p->count + size)/room = p->count + size - 1/'
[ -z "${ALL-}" ] || planted "a band of more rows than are left" frames host-tools/view/frames.c 's/p->height - m->y ||/p->height ||/'
exit $status
