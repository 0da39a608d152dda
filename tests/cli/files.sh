#!/bin/bash
# SPDX-License-Identifier: MIT
# Files that cannot be read or written.
. tests/cli/check.inc
torus=$scenes/torus288.json
small='--size 32x24'

# $small is several words on purpose
# shellcheck disable=SC2086
{
    fresh
    run 'a missing scene is reported' 3 "$glint" render no.json -o a.png
    matches 'and named' "$top/err" '^no\.json: '
    printf '{"camera\2\33' >binary.json
    run 'a scene that is no text is refused' 1 "$glint" info binary.json
    if LC_ALL=C grep -q '[[:cntrl:]]' "$top/err"; then
        say FAIL 'its message can be shown on a terminal' "$(od -c "$top/err" | head -n 3)"
    else
        say ok 'its message can be shown on a terminal'
    fi
    run 'a directory is no scene' 3 "$glint" render "$scenes/" --hash
    fresh
    mkdir out.png
    run 'a directory is no picture' 3 "$glint" render "$torus" $small -o out.png
    run 'nor for the reference' 3 "$glint" reference "$torus" $small -o out.png
    run 'nor is one without ending' 3 "$glint" render "$torus" $small -o .
    run 'a missing folder is reported' 3 "$glint" render "$torus" $small -o no/a.png
    run 'so is one for numbered pictures' 3 "$glint" render "$torus" $small -o no/no/
    : >file
    run 'a file is no folder' 3 "$glint" render "$torus" $small -o file/
    run 'a file is no folder above one' 3 "$glint" render "$torus" $small -o file/a.png
    for format in png apng ppm y4m raw; do
        run "a full device is reported for $format" 3 \
            "$glint" render "$torus" $small --frames 3 -o /dev/full --output-format $format
        matches "with its reason for $format" "$top/err" '^/dev/full: No space left'
    done
    run 'a full device without format too' 3 "$glint" render "$torus" $small -o /dev/full
    run 'and for the reference' 3 "$glint" reference "$torus" $small -o /dev/full
    if [ -c /dev/full ]; then say ok '/dev/full is still a device'; else say FAIL '/dev/full is gone'; fi
    run 'hashes to a full device are reported' 3 sh -c "'$glint' render '$torus' $small --hash >/dev/full"
    run 'help to a full device is reported' 3 sh -c "'$glint' --help >/dev/full"
    run 'a picture to a full standard output is reported' 3 \
        sh -c "'$glint' render '$torus' -o - --output-format y4m >/dev/full"
    # the reader leaves after one byte: 60 pictures do not fit a pipe's buffer
    run 'a reader that leaves is reported' 3 bash -c \
        "'$glint' render '$torus' --frames 60 -o - --output-format y4m | head -c 1 >/dev/null; exit \${PIPESTATUS[0]}"

    fresh
    run 'a file size limit is reported' 3 bash -c "ulimit -f 8; exec '$glint' render '$torus' -o a.raw"
    matches 'with its reason' "$top/err" '^a\.raw: File too large'
    run 'and for packing' 3 bash -c "ulimit -f 8; exec '$glint' pack '$torus' -o a.c"
    run 'and for the reference' 3 bash -c "ulimit -f 8; exec '$glint' reference '$torus' -o a.ppm"
    "$glint" render "$torus" -o a.png
    "$glint" render "$torus" --method flat -o b.png
    run 'and for a difference' 3 bash -c "ulimit -f 1; exec '$glint' compare a.png b.png --diff c.png"
    rm a.png b.png
    mkdir sealed
    chmod 555 sealed
    if [ "$(id -u)" -ne 0 ]; then
        run 'a folder that cannot be written is reported' 3 "$glint" render "$torus" $small -o sealed/a.png
    fi
    chmod 755 sealed

    for signal in INT TERM HUP QUIT; do
        fresh
        interrupted "a picture leaves nothing after SIG$signal" $signal 'long.raw.*' \
            "$glint" render "$torus" --frames 1000000 -o long.raw
        interrupted "nor does a demo" $signal 'out/.frames-*/frame-0001.png' \
            "$glint" demo "$scenes/demo.json" out --frames 10000
        mkdir out
        echo old >out/frame-0000.png
        interrupted "nor one into a folder that is there" $signal 'out/.frames-*/frame-0001.png' \
            "$glint" demo "$scenes/demo.json" out --frames 10000
        if [ "$(ls -A out)" = frame-0000.png ]; then say ok 'which keeps what it had'
        else say FAIL 'which keeps what it had' "$(ls -A out | head -n 3)"; fi
        run 'as it was' 0 grep -qx old out/frame-0000.png
    done
    fresh
    "$glint" render "$torus" --size 2048x2048 -o a.png
    sed 's/"rings": 12, "sides": 12/"rings": 640, "sides": 400/' "$torus" >large.json
    echo old >large.c # may be replaced by the whole: there is no step between at which packing could turn back
    for signal in INT TERM HUP QUIT; do
        interrupted "a reference leaves nothing after SIG$signal" $signal 'b.png.??????' \
            "$glint" reference "$torus" --size 2048x2048 -o b.png
        interrupted 'nor does a difference' $signal 'b.png.??????' "$glint" compare a.png a.png --diff b.png
        interrupted 'nor does packing' $signal 'large.c.??????' "$glint" pack large.json -o large.c
    done

    fresh
    echo old >a.png
    run 'a failure keeps the old file' 1 "$glint" render "$torus" $small -o a.png --expect /dev/null
    matches 'as it was' a.png '^old$'
    run 'a success replaces it' 0 "$glint" render "$torus" $small -o a.png
    run 'and it is a picture' 0 "$glint" compare a.png a.png

    fresh
    run 'a missing picture is reported' 3 "$glint" compare no.png no.png
    run 'a directory is no picture to compare' 3 "$glint" compare . .
    run 'a scene is no picture' 1 "$glint" compare "$torus" "$torus"
    "$glint" render "$torus" -o a.png
    "$glint" render "$torus" $small -o b.png
    run 'pictures of two sizes are not compared' 1 "$glint" compare a.png b.png
    matches 'and the sizes are named' "$top/err" '32x24.*240x240'
    head -c 1000 a.png >short.png
    run 'a short picture is refused' 1 "$glint" compare a.png short.png
    { head -c 500 a.png; printf X; tail -c +502 a.png; } >broken.png
    run 'a damaged picture is refused' 1 "$glint" compare a.png broken.png
    printf '\211PNG\r\n\032\n\0\0\0\rIHDR\177\377\377\377\177\377\377\377\10\2\0\0\0\0\0\0\0' >huge.png
    run 'an absurd picture is refused' 1 "$glint" compare huge.png huge.png
    run 'a difference on a full device is reported' 3 "$glint" compare a.png a.png --diff /dev/full
}
finish
