#!/bin/bash
# SPDX-License-Identifier: MIT
# A stream of every scene: glint-view and the decoder that was made from PROTOCOL.md alone both give the pictures that
# render drew, by the CRC-32 of their bytes.
# shellcheck source=tests/cli/check.inc
. tests/cli/check.inc
view=$glint-view
decoder=$(dirname "$(dirname "$scenes")")/tests/device
others=(rgb888 grey8 grey4)

fresh
cat >decode.py <<'P'
import glob
import sys
import zlib
sys.path.insert(0, sys.argv[1])
import stream
for name in glob.glob("*.stream"):
    with open(name, "rb") as data, open(name.replace(".stream", ".decoded"), "w") as out:
        for _, begin, pixels in stream.pictures(data.read()):
            print("%d %08x" % (int.from_bytes(begin[:4], "little"), zlib.crc32(pixels)), file=out)
P

draw() { # SCENE FORMAT OPTION...
    local name=$1-$2 frames=(--size 64x48 --frames 4 --fps 12 --format "$2" "${@:3}")
    "$glint" render "$scenes/$1.json" "${frames[@]}" --hash >"$name.drawn" 2>>errors
    "$glint" render "$scenes/$1.json" "${frames[@]}" --key 3 --band-rows 16 --stream "$name.stream" 2>>errors
    "$view" "file:$name.stream" --headless --trace 2>>errors |
        sed -nE 's/^([0-9]+): .* crc ([0-9A-F]{8})$/\1 \L\2/p' >"$name.viewed"
}

turn=0
for path in "$scenes"/*.json; do
    name=$(basename "$path" .json)
    draw "$name" rgb565 --dither
    draw "$name" "${others[turn++ % 3]}"
done
for format in "${others[@]}"; do # of two that move, in what has not had its turn
    draw demo "$format" --dither --method phong
    draw spin-teapot "$format" --dither --method phong
done
run 'the other decoder takes all streams' 0 python3 decode.py "$decoder"
for drawn in *.drawn; do
    name=${drawn%.drawn}
    if [ "$(wc -l <"$drawn")" -eq 4 ] && cmp -s "$drawn" "$name.viewed" && cmp -s "$drawn" "$name.decoded"
    then say ok "both decoders see $name"
    else say FAIL "both decoders see $name" \
        "$(head -n 1 errors) $(diff "$drawn" "$name.viewed" | sed -n 2p) $(diff "$drawn" "$name.decoded" | sed -n 2p)"
    fi
done
finish
