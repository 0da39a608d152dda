#!/bin/bash
# SPDX-License-Identifier: MIT
# flash.sh IMAGE.uf2: copies an image to a board that shows itself as the volume RPI-RP2 (RP2040_VOLUME: mounted where),
# or gives it to picotool. DRY_RUN=1 only says what would be done. Exit 2: bad usage, 3: no board, or it failed.
set -u
[ $# -eq 1 ] && [ -r "$1" ] || {
    echo "usage: flash.sh IMAGE.uf2" >&2
    exit 2
}
run() {
    echo "+ $*"
    [ "${DRY_RUN-0}" = 1 ] || "$@" || {
        echo "$1 failed" >&2
        exit 3
    }
}

device=${RP2040_DEVICE-/dev/disk/by-label/RPI-RP2}
volume=${RP2040_VOLUME-$(findmnt -rno TARGET -S LABEL=RPI-RP2 2>/dev/null | head -1)}
for place in "$volume" "/media/${USER-}/RPI-RP2" "/run/media/${USER-}/RPI-RP2" /Volumes/RPI-RP2; do
    # the ROM's volume names itself in this file
    if [ -n "$place" ] && grep -q RPI-RP2 "$place/INFO_UF2.TXT" 2>/dev/null; then
        run cp "$1" "$place/"
        run sync "$place"
        exit 0
    fi
done
if command -v picotool >/dev/null; then
    run picotool load -x "$1"
    exit 0
fi
if [ -e "$device" ]; then
    echo "the board is there as $device, but not mounted: mount it (udisksctl mount -b $device), or install picotool" >&2
    exit 3
fi
if [ "${DRY_RUN-0}" = 1 ]; then
    run cp "$1" RPI-RP2/
    exit 0
fi
echo "no board: no volume RPI-RP2 is mounted, and there is no picotool;" \
    "hold BOOTSEL (on a PicoSystem X) while switching the board on" >&2
exit 3
