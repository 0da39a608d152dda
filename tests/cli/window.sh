#!/bin/bash
# SPDX-License-Identifier: MIT
# glint-view's window: where there is none, and what it shows.
here=$(realpath tests/cli)
decoder=$(realpath tests/device)
. tests/cli/check.inc
view=$glint-view
unset DISPLAY WAYLAND_DISPLAY XDG_RUNTIME_DIR SDL_VIDEODRIVER

fresh
"$glint" render "$scenes/demo.json" --size 8x8 --frames 3 --stream good.stream
run 'without a display there is no window' 3 "$view" file:good.stream
matches 'which is said, with what to do' "$top/err" '^display: .*--headless'
run 'headless needs none' 0 "$view" file:good.stream --headless
run 'nor do pictures as files' 0 "$view" file:good.stream --dump pictures
run 'a stream without a picture opens a window for nothing' 1 env SDL_VIDEODRIVER=dummy "$view" file:/dev/null
run 'pixels are 1 to 6 wide' 2 "$view" file:good.stream --scale 7
run 'and pictures turn by right angles' 2 "$view" file:good.stream --rotate 45
run 'the viewer is built without SDL2 and libusb as well' 0 "$(dirname "$glint")/plain/glint-view" file:good.stream --headless
run 'where it opens no window' 3 "$(dirname "$glint")/plain/glint-view" file:good.stream
matches 'says so' "$top/err" '^window: built without SDL2.*--headless'
run 'and finds no device' 3 "$(dirname "$glint")/plain/glint-view" --list
matches 'for want of libusb' "$top/err" '^usb: .*libusb'

fresh
while read -r line; do
    echo "$line"
    case $line in ok*) passed=$((passed + 1)) ;; *) failed=$((failed + 1)) ;; esac
done < <(PYTHONDONTWRITEBYTECODE=1 timeout 300 python3 "$here/window.py" "$glint" "$scenes/demo.json" "$decoder" 2>&1 || echo "FAIL window.py ends early")
finish
