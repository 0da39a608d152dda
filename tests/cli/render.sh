#!/bin/bash
# SPDX-License-Identifier: MIT
# What render, reference and compare make of a scene: formats, hashes and their expectation, pictures that must agree.
. tests/cli/check.inc
torus=$scenes/torus288.json
demo=$scenes/demo.json

fresh
for format in rgb888 rgb565 grey8 grey4; do
    run "$format becomes a picture" 0 "$glint" render "$torus" --size 60x48 --format $format -o $format.png
done
# the scene is grey: what is left is half a step of each format, 4.1, .5 and 8.5, and as much again where X-shading leaves
# out a bend that such a step hides
for limit in 'rgb565 8' 'grey8 1' 'grey4 17'; do
    "$glint" compare rgb888.png "${limit% *}.png" --json >numbers
    if python3 -c 'import json,sys; assert 0 <= json.load(open("numbers"))["max"] <= int(sys.argv[1])' "${limit#* }"
    then say ok "${limit% *} is rgb888 rounded"; else say FAIL "${limit% *} is rgb888 rounded" "$(cat numbers)"; fi
done

fresh
for rows in 1 7 16 48; do
    "$glint" render "$torus" --size 60x48 --band-rows $rows -o bands-$rows.raw
    same "bands of $rows rows make the same picture" bands-1.raw bands-$rows.raw
done
"$glint" render "$torus" --size 60x48 --no-plan -o all.raw
same 'computing what cannot be seen changes nothing' bands-1.raw all.raw
size=$(stat -c %s bands-1.raw)
if [ "$size" -eq $((60 * 48 * 3)) ]; then say ok 'raw holds the pixels alone'; else say FAIL 'raw holds the pixels alone' "$size"; fi

fresh
"$glint" render "$demo" --size 40x40 --frames 3 --fps 10 --hash >list
matches 'a hash line is index and 8 digits' list '^2 [0-9a-f]{8}$'
crc=$("$glint" render "$demo" --size 40x40 -o - --output-format raw | gzip -c | tail -c 8 | od -An -tx4 -N4 | tr -d ' ')
matches 'the hash is the CRC-32 of the bytes' list "^0 $crc\$"
expect() { "$glint" render "$demo" --size 40x40 --frames "$1" --fps 10 --expect "$2" "${@:3}"; }
run 'the expected hashes are met' 0 expect 3 list
{
    echo '# frames of the demo'
    echo
    sed 's/$/   # as rendered/' list
} >commented
run 'comments are left out' 0 expect 3 commented
sed '/^1 /s/ ........$/ 00000000/' list >other
run 'another hash fails' 1 expect 3 other -o a.png
matches 'naming the frame' "$top/err" '^other:2: frame 1 is [0-9a-f]{8}, expected 00000000$'
run 'more frames than expected fail' 1 expect 4 list
matches 'naming the first one' "$top/err" 'frame 3 '
run 'fewer frames than expected fail' 1 expect 2 list
matches 'naming the first one missing' "$top/err" 'frame 2 '
{
    printf '# %400s\n' ''
    sed "s/\$/$(printf '%300s # %300s' '' '')/" list
} >wide
run 'a line may be long' 0 expect 3 wide
printf '%300s0 12345678 9\n' '' >bad
run 'but not hold more than a frame' 1 expect 1 bad
for line in '0 1234567' '0 123456789' '0 xyzxyzxy' '1 12345678' 'x' '0 12345678 9' '0' '0 0x123456' '+0 12345678' \
    '012345678' '1234567890 12345678'; do
    echo "$line" >bad
    run "'$line' is no list of hashes" 1 expect 1 bad
    matches 'and its line is named' "$top/err" '^bad:1: '
done
run 'a missing list is reported' 3 expect 1 no-list

fresh
run 'frames become an animation' 0 "$glint" render "$demo" --size 40x40 --frames 3 -o a.png
matches 'which is an animated PNG' a.png 'acTL'
run 'one loop is the default for .apng' 0 "$glint" render "$demo" --size 8x8 --fps 5 -o loop.apng
count=$(grep -ao fcTL loop.apng | wc -l)
if [ "$count" -eq 20 ]; then say ok 'of 4 s at 5 frames a second'; else say FAIL 'of 4 s at 5 frames a second' "$count frames"; fi
run 'or of a format that animates' 0 sh -c \
    "'$glint' render '$demo' --size 8x8 --fps 5 -o - --output-format apng >piped.png"
same 'the same' piped.png loop.apng
run 'a format that does not is one picture' 0 "$glint" render "$demo" --size 8x8 --fps 5 -o one.apng --output-format ppm
size=$(stat -c %s one.apng)
if [ "$size" -eq $((8 * 8 * 3 + 11)) ]; then say ok 'whatever the name'; else say FAIL 'whatever the name' "$size bytes"; fi
run 'a folder gets numbered pictures' 0 "$glint" render "$demo" --size 40x40 --frames 3 --fps 10 -o out/
run 'a moment is a frame' 0 "$glint" render "$demo" --size 40x40 --time 200 -o moment.png
same 'the same that the animation has then' moment.png out/frame-0002.png
run 'a turned object is drawn' 0 "$glint" render "$demo" --size 40x40 --turn 359.995,.0028 -o turned.png
if cmp -s turned.png out/frame-0000.png; then say FAIL 'and looks another way' 'the same picture'; else say ok 'and looks another way'; fi
run 'whole turns' 0 "$glint" render "$demo" --size 40x40 --turn -360,359.999 -o whole.png
same 'are none' whole.png out/frame-0000.png
for turn in 1 1, ,1 1,1,1 1,x 361,0 0,-360.1 nan,0 1e1,0 '1, 2' 0x1,0 ''; do
    run "'$turn' is no turn" 2 "$glint" render "$demo" --turn "$turn" --hash
done
run 'pictures go to a pipe' 0 sh -c "'$glint' render '$demo' --size 40x30 --frames 2 -o - --output-format ppm >two.ppm"
size=$(stat -c %s two.ppm)
if [ "$size" -eq $((2 * (40 * 30 * 3 + 13))) ]; then say ok 'one after the other'; else say FAIL 'one after the other' "$size bytes"; fi

fresh
run 'stats are printed' 0 "$glint" render "$torus" --stats
matches 'with the triangles' "$top/out" '^triangles +288 '
run 'stats are printed as JSON' 0 "$glint" render "$torus" --stats=json --frames 2
if python3 -c 'import json,sys; s=json.load(open(sys.argv[1])); assert s["triangles"]==576 and sum(s["pixels"].values())>50000 and s["largest_error"]<=s["budget"]==2' "$top/out"
then say ok 'that a parser takes'; else say FAIL 'that a parser takes' "$(cat "$top/out")"; fi
run 'auto says what it left out' 0 "$glint" render "$torus" --stats --budget 4.5
matches 'and how far a pixel may be off' "$top/out" '^budget +4.50 '
run 'the plan is drawn' 0 "$glint" render "$torus" --show plan --format rgb888 -o plan.ppm
run 'perspective is auto'"'"'s own' 0 "$glint" render "$torus" --perspective --hash

run 'highlights are counted' 0 "$glint" render "$torus" --method subdivide --subdivide hybrid --stats
matches 'by the triangles tested' "$top/out" '^highlight_tests +288 '
for option in --tolerance=9,centre --area=999,regular --threshold=.05,highlight; do
    mode=${option#*,}
    run "subdivide $mode is drawn" 0 "$glint" render "$torus" --method subdivide --subdivide "$mode" --hash
    cp "$top/out" plain
    run "with ${option%,*} too" 0 "$glint" render "$torus" --method subdivide --subdivide "$mode" "${option%,*}" --hash
    if cmp -s plain "$top/out"; then say FAIL 'and another picture' "$(cat plain)"; else say ok 'and another picture'; fi
done

run 'the truth is drawn' 0 "$glint" reference "$torus" --format grey8 -o truth.png
run 'and ideal arithmetic' 0 "$glint" reference "$torus" --format grey8 --method x -o ideal.png
run 'and integers' 0 "$glint" render "$torus" --format grey8 --method x -o x.png
run 'they can be compared' 0 "$glint" compare truth.png x.png --json --diff difference.png
if python3 -c 'import json,sys; s=json.load(open(sys.argv[1])); assert s["psnr_db"]>47.5 and s["max"]<7 and s["pixels"]==25370' "$top/out"
then say ok 'X is within 47.5 dB of the truth'; else say FAIL 'X is within 47.5 dB of the truth' "$(cat "$top/out")"; fi
"$glint" compare ideal.png x.png >numbers
matches 'and within 1 of ideal arithmetic' numbers '^max +[01]$'
"$glint" compare x.png x.png --json >numbers
matches 'equal pictures have no PSNR in JSON' numbers '"psnr_db": null, "rms": 0\.0+, "max": 0'
"$glint" compare x.png x.png >numbers
matches 'and an infinite one in text' numbers '^psnr_db +inf$'
"$glint" compare truth.png x.png --background 010203 --json >numbers
matches 'with another background all pixels count' numbers '"pixels": 57600'
finish
