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
import sys
import zlib
sys.path.insert(0, sys.argv[1])
import stream
with open(sys.argv[2], "rb") as data:
    for _, begin, pixels in stream.pictures(data.read()):
        print("%d %08x" % (int.from_bytes(begin[:4], "little"), zlib.crc32(pixels)))
P

agree() { # SCENE FORMAT OPTION...
    local name=$1 format=$2 frames=(--size 64x48 --frames 4 --fps 12 --format "$2" "${@:3}")
    "$glint" render "$scenes/$name.json" "${frames[@]}" --hash >drawn 2>errors
    "$glint" render "$scenes/$name.json" "${frames[@]}" --key 3 --band-rows 16 --stream a.stream 2>>errors
    "$view" file:a.stream --headless --trace 2>>errors |
        sed -nE 's/^([0-9]+): .* crc ([0-9A-F]{8})$/\1 \L\2/p' >viewed
    python3 decode.py "$decoder" a.stream >decoded 2>>errors
    if [ "$(wc -l <drawn)" -eq 4 ] && cmp -s drawn viewed && cmp -s drawn decoded
    then say ok "both decoders see $name in $format"
    else say FAIL "both decoders see $name in $format" "$(head -n 1 errors) $(diff drawn viewed | sed -n 2p) $(diff drawn decoded | sed -n 2p)"; fi
}

turn=0
for path in "$scenes"/*.json; do
    name=$(basename "$path" .json)
    agree "$name" rgb565 --dither
    agree "$name" "${others[turn++ % 3]}"
done
for name in demo spin-teapot; do # which move, in what has not had its turn
    for format in "${others[@]}"; do
        agree $name $format --dither --method phong
    done
done
finish
