#!/bin/sh
# SPDX-License-Identifier: MIT
# image_size.sh BOARD IMAGE LIMIT SCENE.o...: what an image takes, and whether its flash without the scenes is at most
# LIMIT; 0: any is good; code: that flash alone; -BYTES: and what it saves against another's.
board=$1 image=$2 limit=$3
shift 3
arm-none-eabi-size "$image" "$@" | awk -v board="$board" -v image="${image##*/}" -v limit="$limit" '
    NR == 2 { flash = $1 + $2; ram = $2 + $3 }
    NR > 2 { scenes += $1 + $2 }
    END {
        code = flash - scenes
        if (limit == "code") {
            print code
            exit
        }
        if (limit <= 0) {
            printf "%s %s: flash %d bytes and %d of scenes, static RAM %d", board, image, code, scenes, ram
            printf limit < 0 ? "; %d bytes of code less than app.elf\n" : "\n", -limit - code
            exit
        }
        bad = code > limit
        printf "%s size: %s %s takes %d of at most %d bytes of flash without scenes\n", bad ? "FAIL" : "ok", board, image, code, limit
        exit bad
    }'
