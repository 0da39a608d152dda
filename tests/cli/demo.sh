#!/bin/bash
# SPDX-License-Identifier: MIT
# The side-by-side animation: what it writes, of whose scenes, and that the README shows what it draws.
. tests/cli/check.inc
picture=$(realpath host-tools/glint/demo.png)
demo=$scenes/demo.json

fresh
run 'a demo is drawn' 0 "$glint" demo "$demo" out --frames 8
cp "$top/out" report
for method in GOURAUD X-SHADING AUTO PHONG; do
    matches "it says what $method costs" "$top/out" "^$method +[0-9]+\\.[0-9]+ +[0-9]+\\.[0-9]+ +[0-9]+\\.[0-9]+\$"
done
matches 'and where the pictures are' "$top/out" '8 frames of 972x268 in out/frame-0000\.png .*out/demo\.png'
if [ "$(ls out | tr '\n' ' ')" = "$(printf 'demo.png '; printf 'frame-%04d.png ' 0 1 2 3 4 5 6 7)" ]; then
    say ok 'eight frames and the animation are there'
else
    say FAIL 'eight frames and the animation are there' "$(ls out | tr '\n' ' ')"
fi
run 'X-shading is nearer to Phong than Gouraud is, and auto no further off than that' 0 awk '
    $1 == "GOURAUD" { gouraud = $4 } $1 == "X-SHADING" { x = $4 } $1 == "AUTO" { auto = $4 }
    END { exit !(x > gouraud + 10 && auto > x) }' report
# half a second into the loop. Anew: make demo && cp build/demo/frame-0006.png host-tools/glint/demo.png
"$glint" compare "$picture" out/frame-0001.png >numbers
run 'the picture of the README is what it draws' 0 awk '/^p999/ { exit !($2 <= 4) }' numbers

fresh
cat >cube.obj <<'END'
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 4 3
f 1 2 4
f 2 3 4
END
run 'a model alone turns once' 0 "$glint" demo cube.obj out --frames 4 --height 60
matches 'in panels of the height asked for' "$top/out" '^4 frames of 332x88 '
if cmp -s out/frame-0000.png out/frame-0002.png; then say FAIL 'it moves'; else say ok 'it moves'; fi

fresh
run 'a missing scene makes no folder' 3 "$glint" demo no.json out
printf 'v 0 0 0\n' >bad.obj
run 'nor does a bad one' 1 "$glint" demo bad.obj out
: >file
run 'a file is no folder for a demo' 3 "$glint" demo "$demo" file --frames 2
run 'a demo reports a file size limit' 3 bash -c "ulimit -f 20; exec '$glint' demo '$demo' out --frames 2"
mkdir -p out/frame-0001.png
echo old | tee out/demo.png >out/frame-0000.png
run 'and a picture that cannot get its name' 3 "$glint" demo "$demo" out --frames 2
same 'without an animation of its own' out/demo.png <(echo old)
if [ "$(ls -A out | tr '\n' ' ')" = 'demo.png frame-0000.png frame-0001.png ' ]; then say ok 'or other traces'
else say FAIL 'or other traces' "$(ls -A out)"; fi

# A panel of strips: more vertices than a frame's 16-bit indices reach.
fresh
awk 'BEGIN { for (i = 0; i < 22000; i++) { printf "v %d 0 0\nv %d 1 0\nv %d 0 1\n", 2 * i, 2 * i + 1, 2 * i
    print "f", 3 * i + 1, 3 * i + 2, 3 * i + 3 } }' >many.obj
"$glint" render many.obj --hash >hash 2>warning
code=$?
if [ $code -eq 0 ]; then say ok 'a model too large for a frame is drawn as far as it goes'
else say FAIL 'a model too large for a frame is drawn as far as it goes' "exit code $code"; fi
matches 'with a warning' warning '^many\.obj: warning: [0-9]+ of 22000 triangles are missing'
finish
