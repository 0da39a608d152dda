#!/bin/bash
# SPDX-License-Identifier: MIT
# glint-view where no device is, or none that answers.
. "$(dirname "$0")/check.inc"
view=$glint-view

fresh
nobody='usb:no-such-device'
run 'a device that does not come is waited for as long as wanted' 3 timeout 20 "$view" $nobody --headless --wait 1
matches 'then it is named' "$top/err" "^$nobody: "
run 'its serial number may be an option' 3 timeout 20 "$view" --serial no-such-device --headless --wait 1
matches 'and is named as well' "$top/err" "^$nobody: "
run 'that goes with USB alone' 2 "$view" file:a.stream --serial A1
run 'and is given once' 2 "$view" usb:A1 --serial B2
run 'an empty one is none' 2 "$view" --serial ''
run 'a list is of all' 2 "$view" usb:A1 --list
run 'a time is one' 2 "$view" --wait 0
matches 'in seconds' "$top/err" '1..86400'

# line.py PERIOD COMMAND...: a serial line on which a board prints, or none, and its viewer
cat >line.py <<'P'
import os, subprocess, sys
master, slave = os.openpty()
view = subprocess.Popen(sys.argv[2:] + [os.ttyname(slave), "--headless", "--wait", "1", "--dump", "pictures"])
while view.poll() is None:
    if sys.argv[1] == "words":
        os.write(master, b"12 frames a second\r\n")
    try:
        view.wait(.1)
    except subprocess.TimeoutExpired:
        pass
sys.exit(view.wait())
P
# board.py COMMAND...: a serial line with a board that answers for 10 s, and its viewer
cat >board.py <<'P'
import os, select, subprocess, sys, time, tty
sys.path.insert(0, os.environ["DECODER"])
import stream
master, slave = os.openpty()
tty.setraw(slave)
view = subprocess.Popen(sys.argv[1:] + [os.ttyname(slave)])
end, sequence = time.monotonic() + 10, 0
while view.poll() is None and time.monotonic() < end:
    if select.select([master], [], [], .02)[0] and stream.KEY_PLEASE in os.read(master, 4096)[5::32]:
        os.write(master, stream.message(stream.HELLO, b"board\0first\0\0one\0", sequence, 4, 4) +
                 stream.picture(b"\xff" * 32, 4, 4, (sequence + 1) % 65536, 0, 0, 0, 4, 0))
        sequence = (sequence + 4) % 65536
if view.poll() is None:
    view.kill()
sys.exit(view.wait())
P
DECODER=$(dirname "$scenes")/device
export DECODER PYTHONDONTWRITEBYTECODE=1
run 'names alone end with the first picture' 0 python3 board.py "$view" --names
matches 'and are printed' "$top/out" '^scene first$'

for board in nothing words; do
    run "a board that says $board is not waited for either" 3 timeout 20 python3 line.py $board "$view"
    matches 'and named' "$top/err" '^/dev/.*: no answer$'
done
finish
