#!/bin/sh
# SPDX-License-Identifier: MIT
# install.sh PROGRAM BOARD_FILE PREFIX DESTDIR: the program, its board file, and what makes it a service that needs no
# root, or one that streams over USB. Below a DESTDIR only files are written; else what there is of systemd and udev is told.
set -eu
program=$1 board=$2 prefix=$3 root=$4
here=$(dirname "$0")
fail() {
    echo "install: $1" >&2
    exit 3
}
put() { # mode, file, path
    mkdir -p "$root$(dirname "$3")" 2>/dev/null && install -m "$1" "$2" "$root$3" 2>/dev/null ||
        fail "cannot write $root$3: no right to? (sudo make ... install)"
}
unit=$(mktemp)
trap 'rm -f "$unit"' EXIT

put 755 "$program" "$prefix/bin/glint-device"
for service in glint-device.service glint-device-usb.service; do
    sed "s|@PREFIX@|$prefix|g" "$here/$service" >"$unit"
    put 644 "$unit" "$prefix/lib/systemd/system/$service"
done
put 644 "$here/70-glint-device.rules" "$prefix/lib/udev/rules.d/70-glint-device.rules"
put 644 "$here/glint-device.sysusers" "$prefix/lib/sysusers.d/glint-device.conf"
conf=/etc/glint/board.conf
if [ -e "$root$conf" ] && ! cmp -s "$board" "$root$conf"; then
    cp "$root$conf" "$root$conf.old" || fail "cannot write $root$conf.old"
    echo "$root$conf.old: the board file that was there"
fi
put 644 "$board" "$conf"

tell() { # a command that may not be there
    ! command -v "$1" >/dev/null || "$@" || echo "install: '$*' failed" >&2
}
if [ -z "$root" ]; then
    tell systemd-sysusers
    tell udevadm control --reload
    tell udevadm trigger --subsystem-match=gpio --subsystem-match=spidev
    [ ! -d /run/systemd/system ] || tell systemctl daemon-reload
fi
service=glint-device
! grep -qE '^[[:space:]]*stream[[:space:]]' "$board" || service=glint-device-usb
echo "$root$prefix/bin/glint-device: installed; start it now and at every boot: sudo systemctl enable --now $service"
