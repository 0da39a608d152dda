#!/bin/bash
# SPDX-License-Identifier: MIT
# rp2040.sh GLINT MODULES IMAGE.uf2: what the emulated board's panel shows is, bit for bit, the desktop's picture.
set -u
glint=$1
modules=$2
image=$3
out=$(dirname "$image")
status=0

same() { # scene, method, tables, rows a band
    local name=$1-$2-$3-$4 file=tests/scenes/$1.json figures
    [ -f "$file" ] || file=tests/golden/$1.json
    "$glint" render "$file" --method "$2" --tables "$3" --size 240x240 --format rgb565 --output-format raw \
        -o "$out/$name-host.raw" || status=1
    figures=$(node tests/device/rp2040/run.mjs "$modules" "$image" "$1 $2 $3 $4" "$out/$name")
    if [ $? -eq 0 ] && cmp "$out/$name.raw" "$out/$name-host.raw"; then
        echo "ok rp2040: $figures"
    else
        echo "FAIL rp2040: the picture on the wires of $name is not the desktop's: $figures"
        status=1
    fi
}

same torus800 x 1 24
same torus800 x 1 7
same torus800 x 0 24
same torus800 gouraud 0 24
same torus288 x 1 24
same torus288 phong 0 16
same teapot896 x 1 24
same bench-torus4000 x 1 24
exit $status
