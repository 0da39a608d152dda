#!/bin/bash
# SPDX-License-Identifier: MIT
# glint render --stream and glint-view: pictures through a file and a pipe are those that render writes itself.
. tests/cli/check.inc
demo=$scenes/demo.json
view=$glint-view
decoder=$(dirname "$(dirname "$scenes")")/tests/device

# the same pictures in two folders
folders() { # NAME A B COUNT
    local count
    count=$(find "$2" -name 'frame-*.png' | wc -l)
    if [ "$count" -eq "$4" ] && diff -rq "$2" "$3" >/dev/null; then say ok "$1"
    else say FAIL "$1" "$count pictures; $(diff -rq "$2" "$3" | head -n 1)"; fi
}

fresh
for format in rgb565 rgb888 grey8 grey4; do
    frames=(--size 61x45 --frames 5 --fps 10 --format $format --dither)
    "$glint" render "$demo" "${frames[@]}" -o want-$format/
    run "$format goes to a stream" 0 "$glint" render "$demo" "${frames[@]}" --band-rows 7 --stream $format.stream
    run 'and comes back' 0 "$view" file:$format.stream --headless --dump got-$format
    folders 'bit for bit' got-$format want-$format 5
    run 'also through a pipe, each a key frame' 0 sh -c "'$glint' render '$demo' ${frames[*]} --key 1 --stream - |
        '$view' - --headless --dump piped-$format --frames 5"
    folders 'as well' piped-$format want-$format 5
    "$glint" render "$demo" "${frames[@]}" -o $format.raw
    if python3 - "$decoder" $format.stream $format.raw <<'P'
import sys
sys.path.insert(0, sys.argv[1])
import stream
with open(sys.argv[2], "rb") as data, open(sys.argv[3], "rb") as raw:
    sys.exit(b"".join(pixels for _, _, pixels in stream.pictures(data.read())) != raw.read())
P
    then say ok 'and by a decoder made from the protocol alone'; else say FAIL 'and by a decoder made from the protocol alone'; fi
done
run 'one loop is the default' 0 "$glint" render "$demo" --size 8x8 --fps 5 --stream loop.stream
run 'of 4 s at 5 frames a second' 0 "$view" file:loop.stream --trace
matches 'that are listed' "$top/out" '^19: 8x8 rgb888, moment 3800 ms, [0-9]+ bytes'
matches 'and counted' "$top/out" '^20 pictures, [0-9]+ bytes each, 0 lost$'
run 'a list that cannot be written is reported' 3 sh -c "'$view' file:loop.stream --trace >/dev/full"
matches 'as standard output' "$top/err" '^standard output: '
run 'names are printed' 0 "$view" file:loop.stream --names --frames 1
matches 'of the methods' "$top/out" '^method x-perspective$'

fresh
"$glint" render "$demo" --size 40x40 --frames 6 --key 3 --stream good.stream
"$glint" render "$demo" --size 40x40 --frames 6 -o want/
size=$(stat -c %s good.stream)
{ echo 'text before'; cat good.stream; } >text.stream
run 'text before a stream is passed over' 0 "$view" file:text.stream --dump text
folders 'and no picture is missing' text want 6
{ head -c $((size / 3)) good.stream; printf x; tail -c +$((size / 3 + 2)) good.stream; } >damaged.stream
run 'a damaged picture is left out' 0 "$view" file:damaged.stream --dump damaged --trace
if grep -qE '^[1-4] pictures?, .* [1-9][0-9]* lost$' "$top/out" && cmp -s damaged/frame-0000.png want/frame-0000.png
then say ok 'and counted'; else say FAIL 'and counted' "$(tail -n 1 "$top/out")"; fi
last=$(find damaged -name 'frame-*.png' | sort | tail -n 1)
same 'the key frame and what follows it are there' "$last" want/frame-0005.png
run 'fewer pictures than asked for fail' 1 "$view" file:good.stream --frames 7
matches 'saying how many there were' "$top/err" '^good.stream: only 6 pictures in the stream, 0 lost$'
head -c $((size / 30)) good.stream >short.stream
run 'a stream without a whole picture fails' 1 "$view" file:short.stream --dump none
echo 'no stream' >words
run 'as does what is none' 1 "$view" file:words --headless
matches 'which is said' "$top/err" '^words: is no stream$'
run 'a missing file is named' 3 "$view" file:nowhere
matches 'with the reason' "$top/err" '^nowhere: No such file'
run 'a file is no serial line' 3 "$view" good.stream
matches 'and is to be named otherwise' "$top/err" 'file:good.stream'
run 'a folder is no stream' 3 "$view" file:want
run 'a file is no folder' 3 "$view" file:good.stream --dump words
run 'a file cannot be asked' 2 "$view" file:good.stream --scene demo
run 'there is one input' 2 "$view" file:good.stream file:good.stream
run 'an empty name is none' 2 "$view" file:
run 'nor is a folder of none' 2 "$view" file:good.stream --dump ''
run 'a number is a number' 2 "$view" file:good.stream --frames 0
run 'help is printed' 0 "$view" --help

fresh
python3 - "$decoder" <<'P'
import sys
sys.path.insert(0, sys.argv[1])
import stream
evil = b"a\x1b[2J\x07\r\nb\xc2\x9bc\x9bd\x7f\xc3\xa4\xe2\x82"
names = b"../" + evil + b"\0" + evil + b"\0\0" + evil + b"\0"
with open("evil.stream", "wb") as file:
    file.write(stream.message(stream.HELLO, names, 0, 4, 2) + stream.message(stream.LOG, evil + b"e", 1)
               + stream.picture(bytes(16), 4, 2, 2))
P
"$view" file:evil.stream --names --dump evil >out 2>err
printf '%s\n' 'board ../a?[2J???b?c?d?ä??' 'scene a?[2J???b?c?d?ä??' 'method a?[2J???b?c?d?ä??' \
    '1 picture, 168 bytes each, 0 lost' >want
same 'names say nothing to the terminal' out want
echo 'evil.stream: a?[2J???b?c?d?ä??e' >want
same 'nor do log messages' err want
if [ "$(find . -type f | sort | paste -sd ' ')" = './err ./evil.stream ./evil/frame-0000.png ./out ./want' ]
then say ok 'nor do they name files'; else say FAIL 'nor do they name files' "$(find . -type f)"; fi

# a device that hears nothing for its first requests, as one that is just being switched on
fresh
cat >deaf.py <<'P'
import os
import select
import subprocess
import sys
import tty
sys.path.insert(0, sys.argv[1])
import stream
deaf = int(sys.argv[2])
master, slave = os.openpty()
tty.setraw(slave)
view = subprocess.Popen(sys.argv[3:4] + [os.ttyname(slave)] + sys.argv[4:])
is_now, sequence, heard, data = {stream.SCENE: 0, stream.METHOD: 0, stream.BUDGET: 4, stream.PAUSE: 0}, 0, 0, b""
while view.poll() is None and sequence < 400:
    if select.select([master], [], [], .05)[0]:
        data += os.read(master, 4096)
        for head, value in [(data[at + 5], data[at + 12]) for at in range(0, len(data) - 31, 32)]:
            heard += 1
            if heard > deaf and head in is_now:
                is_now[head] = value
            if head == stream.KEY_PLEASE:
                hello = stream.message(stream.HELLO, b"b\0s\0t\0\0m\0n\0", sequence, 4, 2)
                os.write(master, hello + stream.picture(bytes(16), 4, 2, sequence + 1, 0, *is_now.values()))
                sequence += 4
        data = data[len(data) // 32 * 32:]
view.terminate()
sys.exit(view.wait())
P
for deaf in 0 1 3 5 9; do
    run "what is asked of a device that misses $deaf requests is asked again" 0 timeout 20 python3 deaf.py "$decoder" $deaf \
        "$view" --scene t --method n --budget 9 --pause --frames 2
done

fresh
run 'render writes a picture or a stream' 2 "$glint" render "$demo" --stream a.stream -o a.png
run 'hashes do not mix with a stream on standard output' 2 "$glint" render "$demo" --stream - --hash
run 'a stream that cannot be written is named' 3 "$glint" render "$demo" --stream none/a.stream
matches 'with the reason' "$top/err" '^none/a.stream: No such file'
run 'a full device too' 3 "$glint" render "$demo" --stream /dev/full
"$glint" render "$demo" --stream - --frames 100000 2>err | head -c 100000 >/dev/null
status=${PIPESTATUS[0]}
if [ "$status" = 3 ] && [ ! -s err ]; then say ok 'a viewer that has seen enough is no error to speak of'
else say FAIL 'a viewer that has seen enough is no error to speak of' "$status: $(cat err)"; fi
interrupted 'a signal takes the stream back' TERM 'a.stream*' "$glint" render "$demo" --frames 100000 --stream a.stream
finish
