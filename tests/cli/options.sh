#!/bin/bash
# SPDX-License-Identifier: MIT
# What the command line refuses, and how: one line, the right exit code, nothing left behind.
. tests/cli/check.inc
torus=$scenes/torus288.json

fresh
run 'help is printed' 0 "$glint" --help
matches 'help lists every command' "$top/out" '^  reference '
run 'version is printed' 0 "$glint" --version
matches 'version names the program' "$top/out" '^glint [0-9]+\.[0-9]+'
for command in render pack reference compare info demo report curve; do
    run "$command --help is printed" 0 "$glint" $command --help
    matches "$command --help shows its usage" "$top/out" "^usage: glint $command "
    run "$command refuses an unknown option" 2 "$glint" $command --no-such-option
    run "$command wants its files" 2 "$glint" $command
done
run 'methods prints its list' 0 "$glint" methods
matches 'one name a line' "$top/out" '^x$'
run 'methods takes no arguments' 2 "$glint" methods x
run 'a command is needed' 2 "$glint"
run 'an unknown command is refused' 2 "$glint" paint
run 'an unknown option is refused' 2 "$glint" --paint

# values of render
while read -r option values; do
    for value in $values; do
        run "render refuses --$option=$value" 2 "$glint" render "$torus" -o a.png "--$option=$value"
    done
done <<'END'
method color X flatt x-x
power 5 fast
subdivide nowhere
tolerance 0 256 4.0
budget 0 .001 255.1 -1 1e1 2x .
show plans x
area 0 65536 -1
threshold 0 1 -.3 .3x . 1e-1 0x.8 .001
size 0x1 1x0 2049x1 1x2049 10 10x 10x10x x10 -1x1 +5x5 99999999999x1
frames 0 -1 1.5 1e3 99999999999
fps 0 1001 x
time -1 4294967296 1s
format rgb rgb444
band-rows 0 2049
tables 256 -1
shininess 0 1024
stats xml
output-format jpeg
hash yes
END
run 'a wrong size is refused' 2 "$glint" render "$torus" -o a.png --size 320
matches 'saying which would do' "$top/err" "^glint render: '320' .* --size WxH: .*2048"
run 'a wrong pixel format is refused' 2 "$glint" reference "$torus" -o a.png --format=rgb
matches 'naming those there are' "$top/err" "^glint reference: 'rgb' .* --format F: rgb888 "
run 'render shows the plan of auto alone' 2 "$glint" render "$torus" -o a.png --method x --show plan
matches 'saying so' "$top/err" '^glint render: --show plan is of --method auto'
run 'render needs something to do' 2 "$glint" render "$torus"
run 'render takes one file' 2 "$glint" render "$torus" "$torus" -o a.png
run 'render refuses an ending it does not know' 2 "$glint" render "$torus" -o a.jpg
run 'render refuses -o - without a format' 2 "$glint" render "$torus" -o -
run 'render does not mix hashes into a picture' 2 "$glint" render "$torus" -o - --output-format raw --hash
run 'an option without its value is refused' 2 "$glint" render "$torus" -o

while read -r option values; do
    for value in $values; do
        run "reference refuses --$option=$value" 2 "$glint" reference "$torus" -o a.png "--$option=$value"
    done
done <<'END'
method flat pong
tolerance 0 256 .5
area 0 65536 -1
size 0x0 3000x1
time -5
format rgb565 grey4
shininess 1024 0
END
run 'reference needs -o' 2 "$glint" reference "$torus"
run 'reference refuses a form that a method does not have' 2 "$glint" reference "$torus" -o a.png --method gouraud --perspective
matches 'naming the method' "$top/err" '^glint reference: gouraud has no perspective-correct form'

run 'compare refuses a colour of 5 digits' 2 "$glint" compare a.png b.png --background 12345
run 'compare refuses a colour of other letters' 2 "$glint" compare a.png b.png --background 12345g
run 'compare wants two pictures' 2 "$glint" compare a.png
run 'a curve is printed' 0 "$glint" curve x-error
matches 'from its heading' "$top/out" '^degrees,x_norm,'
run 'an unknown curve is refused' 2 "$glint" curve y-error
run 'demo wants a folder' 2 "$glint" demo "$torus"
run 'demo refuses no frames' 2 "$glint" demo "$torus" out --frames 0
finish
