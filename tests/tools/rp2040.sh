#!/bin/bash
# SPDX-License-Identifier: MIT
# rp2040.sh GLINT MODULES IMAGE.uf2: what the emulated board's panel shows is, bit for bit, the desktop's picture.
set -u
glint=$1
modules=$2
image=$3
out=$(dirname "$image")
status=0

# SCENE METHOD TABLES ROWS ROTATION MS [CORES], as tests/device/rp2040/panel.c takes them: pictures at 0 and at MS
same() {
    local name=$1-$2-$3-$4-$5-$6${7:+-$7} file=tests/scenes/$1.json good=1
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

# CYCLES: the last pictures of same() were drawn in that many at most.
within() {
    [[ $figures =~ cycles\ ([0-9]+)\ drawn ]] && [ "${BASH_REMATCH[1]}" -le "$1" ]
    message=$figures verdict "drawn in $1 cycles" $?
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
flash() { # what follows: variables
    message=$(env PATH="$out/no-picotool" RP2040_VOLUME="$volume" RP2040_DEVICE="$out/none" "$@" \
        /bin/bash hal/rp2040/flash.sh "$image" 2>&1)
    told=$?
}
verdict() { # name, whether
    if [ "$2" = 0 ]; then
        echo "ok rp2040: $1"
    else
        echo "FAIL rp2040: $1: ${message-}"
        status=1
    fi
}
rm -rf "$volume" "$out/no-picotool" && mkdir -p "$volume" "$out/no-picotool"
for tool in cp sync grep findmnt head; do ln -sf "$(command -v $tool)" "$out/no-picotool/"; done
flash DRY_RUN=0
[ $told -eq 3 ] && [[ $message == *"no volume RPI-RP2 is mounted, and there is no picotool"*BOOTSEL* ]] && [ -z "$(ls "$volume")" ]
verdict "without a board, flashing says what is missing" $?
flash RP2040_DEVICE=/dev/null
[ $told -eq 3 ] && [[ $message == *"there as /dev/null, but not mounted"* ]]
verdict "a board that is not mounted is told" $?
printf 'Board-ID: RPI-RP2\n' >"$volume/INFO_UF2.TXT"
flash DRY_RUN=1
[ $told -eq 0 ] && [[ $message == "+ cp $image $volume/"* ]] && [ "$(ls "$volume")" = INFO_UF2.TXT ]
verdict "a dry run says what flashing would do" $?
flash DRY_RUN=0
[ $told -eq 0 ] && cmp "$image" "$volume/$(basename "$image")"
verdict "an image goes to the board's volume" $?
rm -rf "$volume" && printf '#!/bin/sh\necho "No accessible RP2040 devices in BOOTSEL mode were found."\nexit 249\n' >"$out/no-picotool/picotool"
chmod +x "$out/no-picotool/picotool"
flash DRY_RUN=0
[ $told -eq 3 ] && [[ $message == *"+ picotool load -x $image"*"No accessible"*"picotool failed"* ]]
verdict "picotool is asked where there is no volume, and its failure told" $?
rm "$out/no-picotool/picotool"
printf '#!/bin/sh\nexit 0\n' >"$out/no-picotool/npm"
chmod +x "$out/no-picotool/npm"
message=$(PATH="$out/no-picotool:$PATH" DEPS='' tests/tools/rp2040js.sh "$out/no-node" 2>&1)
[ $? -eq 1 ] && [[ $message == *"npm failed: no network"*"install it with: npm install"* ]]
verdict "an npm that brings nothing is told" $?
rm "$out/no-picotool/npm"
message=$(${MAKE:-make} -s BOARD=none board-flash 2>&1)
[ $? -eq 2 ] && [[ $message == *"give BOARD=, one of: "*picosystem* ]]
verdict "make flash without a board that is known lists them" $?
message=$(RP2040_VOLUME='' DRY_RUN=1 ${MAKE:-make} -s BOARD=picosystem board-flash 2>&1)
[ $? -eq 0 ] && [[ $message == *"/picosystem/app.uf2"* ]]
verdict "make BOARD=picosystem flash DRY_RUN=1 names the image" $?
for turn in 0 90 180 270; do
    same demo x 4 24 $turn 300
done
same demo phong 0 15 0 300
same torus800 x 1 24 0 0
same torus800 x 1 30 0 0 1
same torus800 x 1 30 0 0 2
within 2080000 # a sixtieth of a second at 125 MHz
same torus800 x 1 7 0 0 2
same torus1000 x 1 30 0 0 1
same torus1000 x 1 30 0 0 2
within 2330000
same demo gouraud 0 24 90 300 2
same torus800 x 1 7 0 0
same torus800 x 0 24 0 0
same torus800 gouraud 0 24 0 0
same torus288 x 1 24 0 0
same sphere690 x 1 24 0 0
same bench-torus4000 x 1 24 0 0
exit $status
