#!/bin/bash
# SPDX-License-Identifier: MIT
# glint-view --record and --save: films of a stream's pictures are those that render makes itself.
# shellcheck source=tests/cli/check.inc
. tests/cli/check.inc
demo=$scenes/demo.json
view=$glint-view
root=$(dirname "$(dirname "$scenes")")

film() { # FILE: how long each picture is shown and what is seen, without the part that is stored
    python3 "$root/tests/tools/film.py" "$1" | cut -d ' ' -f 1,2
}

films() { # NAME A B COUNT
    film "$2" >a.list && film "$3" >b.list
    if [ "$(wc -l <a.list)" -eq "$4" ] && cmp -s a.list b.list; then say ok "$1"
    else say FAIL "$1" "$(wc -l <a.list) pictures; $(diff a.list b.list | sed -n 2p)"; fi
}

kept() { # NAME CODE FILE COMMAND...: as it should be in spite of the exit code, and the file is all that is new
    local name=$1 want=$2 file=$3 code before after
    shift 3
    before=$(ls -A)
    "$@" >"$top/out" 2>"$top/err" </dev/null
    code=$?
    after=$(ls -A -I "$file")
    if [ $code -eq "$want" ] && [ "$(wc -l <"$top/err")" -eq 1 ] && [ -f "$file" ] && [ "$before" = "$after" ]
    then say ok "$name"; else say FAIL "$name" "exit code $code: $(head -n 1 "$top/err"); $after"; fi
}

fresh
for format in rgb565 rgb888 grey8 grey4; do
    frames=(--size 61x45 --frames 6 --fps 15 --format $format --dither)
    "$glint" render "$demo" "${frames[@]}" -o want.apng
    "$glint" render "$demo" "${frames[@]}" -o want.y4m
    "$glint" render "$demo" "${frames[@]}" --stream $format.stream
    run "$format becomes an animated PNG" 0 "$view" --headless file:$format.stream --record $format.png --save again.stream
    films 'of the same pictures at the same moments' $format.png want.apng 6
    same 'and its bytes are kept' again.stream $format.stream
    run 'and YUV4MPEG2' 0 "$view" --headless file:$format.stream --record $format.y4m --record-fps 15
    same 'that is the same' $format.y4m want.y4m
done
run 'a film has 60 pictures a second' 0 sh -c "'$glint' render '$demo' --size 61x45 --frames 6 --fps 15 --stream - |
    '$view' --headless - --record film.y4m"
head -n 1 film.y4m >head
if [ "$(cat head)" = 'YUV4MPEG2 W61 H45 F60:1 Ip A1:1 C444 XCOLORRANGE=LIMITED' ] &&
    [ "$(stat -c %s film.y4m)" -eq $(($(stat -c %s head) + 24 * (6 + 3 * 61 * 45))) ]
then say ok 'by repeating those of the stream'; else say FAIL 'by repeating those of the stream' "$(cat head)"; fi
python3 "$root/tests/tools/film.py" rgb565.png | tail -n +2 | sed 's/.* //' >parts
if [ "$(wc -l <parts)" -eq 5 ] && ! grep -q '^61x45' parts; then say ok 'an animated PNG holds only what changed'
else say FAIL 'an animated PNG holds only what changed' "$(head -n 1 parts)"; fi

fresh
"$glint" render "$demo" --size 40x40 --frames 6 --key 3 --fps 10 --stream good.stream
size=$(stat -c %s good.stream)
{ head -c $((size / 3)) good.stream; printf x; tail -c +$((size / 3 + 2)) good.stream; } >damaged.stream
run 'a damaged picture is not in the film' 0 "$view" --headless file:damaged.stream --record damaged.apng --dump damaged
count=$(find damaged -name 'frame-*.png' | wc -l)
film damaged.apng >damaged.list
if [ "$count" -lt 6 ] && [ "$(wc -l <damaged.list)" -eq "$count" ] && grep -qE '^([2-4]00) ' damaged.list
then say ok 'and the one before it lasts longer'
else say FAIL 'and the one before it lasts longer' "$count pictures; $(tr '\n' ' ' <damaged.list)"; fi
kept 'a film is kept of fewer pictures than asked for' 1 few.png "$view" --headless file:good.stream --record few.png --frames 9
films 'as it is' few.png few.png 6
"$glint" render "$demo" --size 41x40 --frames 2 --stream other.stream
cat good.stream other.stream >both.stream
kept 'a film ends where the size changes' 1 first.png "$view" --headless file:both.stream --record first.png
matches 'saying so' "$top/err" '^first.png: ends here, 40x40 rgb888: the pictures are 41x40 rgb888 from now on$'
films 'with what was before' first.png few.png 6

fresh
"$glint" render "$demo" --size 120x120 --frames 8 --dither --stream good.stream
head -c 300 good.stream >short.stream
for kind in png y4m; do
    ln -s /dev/full full.$kind
    run "a full device is reported for $kind" 3 "$view" --headless file:good.stream --record full.$kind
    matches 'with the reason' "$top/err" "^full.$kind: No space left on device\$"
    run 'a file that may grow no more too' 3 bash -c "trap '' XFSZ; ulimit -f 20; exec '$view' --headless file:good.stream --record a.$kind"
    matches 'with its reason' "$top/err" "^a.$kind: File too large\$"
    echo old >old.$kind
    run 'also where there was a file' 3 bash -c "trap '' XFSZ; ulimit -f 20; exec '$view' --headless file:good.stream --record old.$kind"
    matches 'which stays' old.$kind '^old$'
    mkdir folder.$kind
    run 'a folder is no film' 3 "$view" --headless file:good.stream --record folder.$kind
    run 'nor is there one in no folder' 3 "$view" --headless file:good.stream --record none/a.$kind
    run 'without a picture there is none' 1 "$view" --headless file:short.stream --record a.$kind
done
mkfifo pipe.png
run 'a pipe is no place for an animated PNG' 3 bash -c "cat pipe.png >'$top/piped' & exec '$view' --headless file:good.stream --record pipe.png"
matches 'and the message names another' "$top/err" '^pipe.png: .*y4m'
mkfifo pipe.y4m
run 'but for YUV4MPEG2' 0 bash -c "cat pipe.y4m >'$top/piped' & '$view' --headless file:good.stream --record pipe.y4m && wait"
"$view" --headless file:good.stream --record file.y4m >"$top/out"
same 'with the same bytes' "$top/piped" file.y4m
rm file.y4m
run 'a full device is reported for a stream' 3 "$view" --headless file:good.stream --save /dev/full
run 'and no folder' 3 "$view" --headless file:good.stream --save none/a.stream
run 'another ending is refused' 2 "$view" --headless file:good.stream --record a.gif
matches 'with those that are not' "$top/err" '^a.gif: .*\.png, \.apng or \.y4m$'
run 'an empty name is none' 2 "$view" --headless file:good.stream --record ''
run 'nor for a stream' 2 "$view" --headless file:good.stream --save ''
run 'a film has at least a picture a second' 2 "$view" --headless file:good.stream --record a.y4m --record-fps 0

# a stream that goes on until a signal comes: the film so far is whole, and nothing else is there
fresh
"$glint" render "$demo" --size 60x60 --frames 3 --fps 10 --stream good.stream
cat >stopped.py <<'P'
import fcntl
import signal
import struct
import subprocess
import sys
import termios
import time
view, number, film = sys.argv[1], getattr(signal, "SIG" + sys.argv[2]), sys.argv[3]
run = subprocess.Popen([view, "-", "--headless", "--record", film, "--save", "saved.stream"], stdin=subprocess.PIPE)
with open("good.stream", "rb") as file:
    run.stdin.write(file.read())
run.stdin.flush()
for _ in range(4000):
    if struct.unpack("i", fcntl.ioctl(run.stdin, termios.FIONREAD, bytes(4)))[0] == 0:
        break
    time.sleep(.005)
run.send_signal(number)
sys.exit(0 if run.wait() == -number else 1)
P
for signal in INT TERM HUP; do
    run "SIG$signal ends a film" 0 env --default-signal python3 stopped.py "$view" $signal $signal.png
    film $signal.png >$signal.list
    if [ "$(wc -l <$signal.list)" -eq 3 ]; then say ok 'that is whole'; else say FAIL 'that is whole' "$(cat $signal.list)"; fi
    if cmp -s good.stream saved.stream && rm saved.stream; then say ok 'as is the stream'
    else say FAIL 'as is the stream'; fi
done
if [ "$(find . -type f | sort | paste -sd ' ')" = \
    './HUP.list ./HUP.png ./INT.list ./INT.png ./TERM.list ./TERM.png ./good.stream ./stopped.py' ]
then say ok 'nothing else is left'; else say FAIL 'nothing else is left' "$(find . -type f)"; fi
finish
