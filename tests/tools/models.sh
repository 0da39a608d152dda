#!/bin/bash
# SPDX-License-Identifier: MIT
# models.sh GLINT [FILE...]: draws models, or assimp's own test collection, and compares each with the double-precision
# per-pixel Phong of the same view. Prints PSNR by method. A model fails when X-shading is further from the truth than
# Gouraud, when integer Phong or auto is far from it, when nothing is drawn, or when a command takes 10 s. Those that the tool
# refuses are counted, not drawn: tests/cli/bad_models.sh says which must be.
set -u
glint=$(realpath "${1:?usage: $0 GLINT [FILE...]}")
shift
collection=${MODELS:-/usr/share/assimp/models}
if [ $# -eq 0 ]; then
    mapfile -t files < <(cd "$collection" 2>/dev/null && find OBJ PLY STL glTF glTF2 -type f \
        -regextype egrep -iregex '.*\.(obj|ply|stl|gltf|glb)' | sort)
    cd "$collection" && [ ${#files[@]} -gt 0 ] || { echo "FAIL models: none in $collection; install assimp-testmodels"; exit 1; }
    set -- "${files[@]}"
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
size='--size 320x240'
status=0
refused=0

draw() { timeout 10 "$glint" "$@" 2>"$work/err"; } # seconds of processor and waiting alike
psnr() { "$glint" compare "$work/truth.png" "$work/$1.png" | awk '/^psnr_db/ { print $2 == "inf" ? 99 : $2 }'; }

printf '%-64s %9s %8s %8s %8s %8s\n' 'model, PSNR in dB' triangles gouraud x phong auto
for file in "$@"; do
    # $size is several words on purpose
    # shellcheck disable=SC2086
    draw reference "$file" $size -o "$work/truth.png"
    code=$?
    if [ $code -eq 1 ]; then
        refused=$((refused + 1))
        continue
    fi
    for method in gouraud x phong auto; do
        # shellcheck disable=SC2086
        [ $code -ne 0 ] || draw render "$file" $size --method $method --stats -o "$work/$method.png" >"$work/$method.txt"
        code=$((code | $?))
    done
    if [ $code -ne 0 ]; then
        echo "FAIL $file: exit code $code: $(head -n 1 "$work/err")"
        status=1
        continue
    fi
    awk -v file="$file" -v gouraud="$(psnr gouraud)" -v x="$(psnr x)" -v phong="$(psnr phong)" -v auto="$(psnr auto)" '
        function decibel(value) { return value == 99 ? "equal" : sprintf("%.1f", value) }
        /^triangles/ { triangles = $2 }
        /^dropped/ { dropped = $2 }
        /^pixels/ { pixels = $2 }
        END {
            # a frame that lacks triangles is another picture, and the tool has said so; half a decibel and what lies
            # above 50 is rounding to 8 bits
            bad = !pixels || (!dropped && (phong < 45 || auto < 45 || (x < 50 && x < gouraud - .5)))
            if (length(file) > 58)
                file = "..." substr(file, length(file) - 54)
            printf "%s %-*s %9d %8s %8s %8s %8s%s\n", bad ? "FAIL" : "ok", bad ? 59 : 61, file, triangles, decibel(gouraud),
                decibel(x), decibel(phong), decibel(auto), dropped ? "  " dropped " triangles dropped" : ""
            exit bad
        }' "$work/x.txt" || status=1
done
echo "$refused refused"
exit $status
