#!/bin/bash
# SPDX-License-Identifier: MIT
# What `make BOARD=... install` puts below a DESTDIR.
. tests/cli/check.inc
install=$(realpath boards/linux/install.sh)
board=$(realpath boards/pi-zero-waveshare13/board.conf)
bare=$(realpath boards/pi-zero-usb/board.conf)
other=$(realpath boards/pi-zero-displayhatmini/board.conf)

fresh
printf '#!/bin/sh\nexit 0\n' >program
run 'it is installed below a folder' 0 "$install" program "$board" /opt/glint "$work/root"
matches 'the message says how to start it' "$top/out" 'systemctl enable --now glint-device$'
run 'six files and no more' 0 test "$(cd root && find . -type f | sort | tr '\n' ' ')" = "./etc/glint/board.conf \
./opt/glint/bin/glint-device ./opt/glint/lib/systemd/system/glint-device-usb.service \
./opt/glint/lib/systemd/system/glint-device.service \
./opt/glint/lib/sysusers.d/glint-device.conf ./opt/glint/lib/udev/rules.d/70-glint-device.rules "
run 'the program can be run' 0 root/opt/glint/bin/glint-device
run 'the board file is the board'"'"'s' 0 cmp root/etc/glint/board.conf "$board"
unit=root/opt/glint/lib/systemd/system/glint-device.service
matches 'the service starts it where it is' "$unit" '^ExecStart=/opt/glint/bin/glint-device$'
matches 'and makes the panel dark after a crash' "$unit" '^ExecStopPost=/opt/glint/bin/glint-device --off$'
run 'no place is left open' 0 awk '/@/ { bad = 1 } END { exit bad }' "$unit"
unit=root/opt/glint/lib/systemd/system/glint-device-usb.service
matches 'another service streams over USB' "$unit" '^ExecStart=/opt/glint/bin/glint-device --stream usb$'
matches 'in its place' "$unit" '^Conflicts=glint-device.service$'
run 'no place is left open there' 0 awk '/@/ { bad = 1 } END { exit bad }' "$unit"

echo '# mine' >>root/etc/glint/board.conf
cp root/etc/glint/board.conf mine
run 'another board is installed over it' 0 "$install" program "$other" /opt/glint "$work/root"
run 'the board file that was there is kept' 0 cmp root/etc/glint/board.conf.old mine
run 'and one without a panel' 0 "$install" program "$bare" /opt/glint "$work/root"
matches 'whose service is the one over USB' "$top/out" 'systemctl enable --now glint-device-usb$'

fresh
printf '#!/bin/sh\n' >program
: >file
run 'a folder that cannot be written is told' 3 "$install" program "$board" /usr/local "$work/file"
matches 'by name' "$top/err" "cannot write $work/file/usr/local/bin/glint-device"
finish
