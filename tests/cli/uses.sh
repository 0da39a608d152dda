#!/bin/bash
# SPDX-License-Identifier: MIT
# What scenes need of the renderer, as pack and info say it.
. tests/cli/check.inc
torus=$scenes/torus288.json
method_list=$(realpath tests/tools/method_list.sh)
methods=$(realpath firmware/methods.c)

needs() { # NAME SCENE EFFECTS
    run "info of $1" 0 "$glint" info "$scenes/$2.json"
    matches "$1 is all that it needs" "$top/out" "^effects  $3\$"
}
fresh
needs 'a still scene from far away' torus288 'specular orthographic'
needs 'one without a highlight' plain-torus288 'orthographic'
needs 'two lights' plain-dome-behind 'orthographic several-lights'
needs 'near lights and eye' teapot896 'specular point-light local-viewer perspective several-lights clipping'
needs 'a scene that moves' demo 'specular perspective spin'
for pair in texture:texture-quad bump:bump-torus288 fog:fog-linear two-sided:two-sided-bowl; do
    file=$(find "$scenes" -name "${pair#*:}*.json" | sort | head -n 1)
    run "info of $pair" 0 "$glint" info "$file"
    matches "${pair%:*} is among what it needs" "$top/out" "^effects .* ?${pair%:*}( |\$)"
done
run 'info --json has them too' 0 "$glint" info "$torus" --json
matches 'by name' "$top/out" '^    "orthographic"'
run 'and the methods' 0 "$glint" info "$torus" --json
matches 'of use' "$top/out" '^    "duff"'
if grep -qE '"(x-perspective|bump-linear)"' "$top/out"; then
    say FAIL 'but none for what it does not have'
else
    say ok 'but none for what it does not have'
fi

run 'pack --uses of two scenes' 0 "$glint" pack --uses grey4,dither "$torus" "$scenes/demo.json"
matches 'has the effects of both and the formats' "$top/out" \
    '^#define GLINT_USES 0x180390u /\* specular perspective orthographic spin grey4 dither \*/$'
matches 'and the methods' "$top/out" '^/\* methods: flat .* x-perspective .* \*/$'
"$glint" pack --uses rgb888 "$torus" >uses.h
printf '#include "uses.h"\n' >a.c
run 'what it prints is a header' 0 cc -Wall -Wextra -Werror -c a.c -o a.o
run 'a packed scene needs the same' 0 "$glint" pack "$torus" -o torus.glt
run 'whatever its name' 0 "$glint" pack --uses rgb888 torus.glt
same 'as what it was made of' "$top/out" uses.h
for formats in '' rgb565, ,rgb565 dither specular rgb; do
    run "--uses=$formats is refused" 2 "$glint" pack "--uses=$formats" "$torus"
done
run '--uses wants a scene' 2 "$glint" pack --uses rgb565
run '--uses writes none' 2 "$glint" pack --uses rgb565 "$torus" -o b.glt
run '--uses wants scenes that are there' 3 "$glint" pack --uses rgb565 "$torus" no.json

links() { # WANT METHOD...: the methods that a board's program links
    local want=$1 got
    shift
    got=$("$method_list" "$methods" uses.h "$@" | awk -F '"' '/^    \{"/ { printf "%s ", $2 }')
    if [ "$got" = "$want" ]; then say ok "a program links $want"; else say FAIL "a program links $want" "$got"; fi
}
printf '/* methods: flat x duff */\n' >uses.h
links 'flat x duff '
links 'x auto ' auto x
links 'flat duff ' -x
links 'auto ' x auto -x
run 'it links none that there is not' 2 "$method_list" "$methods" uses.h nosuch
run 'and leaves none out' 2 "$method_list" "$methods" uses.h -nosuch
finish
