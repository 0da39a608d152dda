#!/bin/bash
# SPDX-License-Identifier: MIT
# rp2040.sh GLINT MODULES IMAGE.uf2: what the emulated board's panel shows is, bit for bit, the desktop's picture.
set -u
glint=$1
modules=$2
image=$3
out=$(dirname "$image")
status=0

# SCENE METHOD TABLES ROWS ROTATION MS, as tests/device/rp2040/panel.c takes them: pictures at 0 and at MS
same() {
    local name=$1-$2-$3-$4-$5-$6 file=tests/scenes/$1.json figures good=1
    [ -f "$file" ] || file=tests/golden/$1.json
    figures=$(node tests/device/rp2040/run.mjs "$modules" "$image" "$*" "$out/$name") || good=0
    desktop "$file" "$2" "$3" 0 "$out/$name-first" || good=0
    desktop "$file" "$2" "$3" "$6" "$out/$name" || good=0
    if [ $good = 1 ]; then
        echo "ok rp2040: $figures"
    else
        echo "FAIL rp2040: the pictures on the wires of $name are not the desktop's: $figures"
        status=1
    fi
}

desktop() { # scene file, method, tables, moment, the device's picture
    "$glint" render "$1" --method "$2" --tables "$3" --time "$4" --size 240x240 --format rgb565 --output-format raw \
        -o "$5-desktop.raw" && cmp "$5.raw" "$5-desktop.raw"
}

# The ROM refuses a second stage of which one bit is wrong.
printf '\001' | cat <(head -c 50 "$image") - <(tail -c +52 "$image") >"$out/damaged.uf2"
message=$(node tests/device/rp2040/run.mjs "$modules" "$out/damaged.uf2" "" "$out/damaged" 2>&1)
if [ $? -eq 3 ] && [[ $message == *"refuses the second stage"* ]]; then
    echo "ok rp2040: a damaged second stage is not started"
else
    echo "FAIL rp2040: a damaged second stage: $message"
    status=1
fi
# Flashing: a volume that is the ROM's takes the file, another does not, and nothing happens in a dry run.
volume=$out/volume
rm -rf "$volume" && mkdir -p "$volume"
RP2040_VOLUME=$volume PATH=/usr/bin:/bin hal/rp2040/flash.sh "$image" >/dev/null 2>"$out/flash.txt"
none=$?
printf 'Board-ID: RPI-RP2\n' >"$volume/INFO_UF2.TXT"
DRY_RUN=1 RP2040_VOLUME=$volume hal/rp2040/flash.sh "$image" >/dev/null
left=$(ls "$volume")
RP2040_VOLUME=$volume hal/rp2040/flash.sh "$image" >/dev/null
if [ $none -eq 3 ] && grep -q 'no volume RPI-RP2' "$out/flash.txt" && [ "$left" = INFO_UF2.TXT ] &&
    cmp "$image" "$volume/$(basename "$image")"; then
    echo "ok rp2040: an image goes to the board's volume, and nowhere else"
else
    echo "FAIL rp2040: flashing (status $none without a board, then '$left')"
    status=1
fi
for turn in 0 90 180 270; do
    same demo x 4 24 $turn 300
done
same demo phong 0 15 0 300
same torus800 x 1 24 0 0
same torus800 x 1 60 0 0
same torus800 x 1 7 0 0
same torus800 x 0 24 0 0
same torus800 gouraud 0 24 0 0
same torus288 x 1 24 0 0
same sphere690 x 1 24 0 0
same bench-torus4000 x 1 24 0 0
exit $status
