#!/bin/bash
# SPDX-License-Identifier: MIT
# figures.sh GLINT BENCH.CSV REPORT.CSV README: writes README's figures of quality and cost anew, between its figure marks.
# figures.sh stack: prints the one of them that says how much stack the renderer takes, from $BUILD's objects.
set -eu

stack() {
    local cpu bytes=0 entry= where=
    while read -r cpu name size; do
        [ "$size" -le "$bytes" ] || bytes=$size entry=$name where=$cpu
    done < <(for cpu in m0plus m3 m4; do
        python3 tests/tools/stack.py --cpu $cpu --indirect tests/tools/indirect.txt "$BUILD/$cpu" --limit 1024 |
            sed -n 's/^ok stack: \(.*\): \(.*\) takes at most \([0-9]*\) of .*/\1 \2 \3/p'
    done)
    [ $bytes -gt 0 ] || { echo "figures.sh: no stack figures: see make stack" >&2; exit 1; }
    echo "The worst stack is $bytes bytes, of \`$entry\` on $(echo $where | sed 's/plus/+/; s/m/M/')" \
        "(\`make stack\`); \`make size\` prints flash."
}
if [ "$1" = stack ]; then
    stack
    exit
fi
glint=$1 csv=$2 report=$3 readme=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

difference() { # of picture.png and truth.png
    "$glint" compare "$work/picture.png" "$work/truth.png" --json |
        sed -E 's/.*"psnr_db": *([0-9.]+).*"max": *([0-9.]+).*/\1 \2/' | awk '{ printf " %.1f / %d |", $1, $2 }'
}
quality() { # scene exponent command method
    "$glint" "$3" "tests/scenes/$1.json" --shininess "$2" --method "$4" --format grey8 -o "$work/picture.png"
    difference
}
{
    echo
    echo "Torus of 288 triangles, 240×240, 8-bit grey, against per-pixel Phong in double precision: PSNR in dB / largest"
    echo "difference in 1/255. \"ideal\" is the same method in double precision."
    echo
    echo "| exponent | Gouraud | X | X, ideal | Phong |"
    echo "|---|---|---|---|---|"
    for row in "torus288 5" "torus288 20" "torus288 50" "torus288-persp 20"; do
        set -- $row
        "$glint" reference "tests/scenes/$1.json" --shininess "$2" --format grey8 -o "$work/truth.png"
        printf '| %s%s |' "$2" "$([[ $1 == *persp ]] && echo ', in perspective')"
        quality "$1" "$2" render gouraud
        quality "$1" "$2" render x
        quality "$1" "$2" reference x
        quality "$1" "$2" render phong
        echo
    done
    echo
    echo "    build/glint render tests/scenes/torus288.json --shininess 20 --method x --format grey8 -o x.png"
    echo "    build/glint reference tests/scenes/torus288.json --shininess 20 --format grey8 -o truth.png"
    echo "    build/glint compare x.png truth.png"
    echo
    echo "Every method on that torus with exponent 20, cheapest first. Differences are from the truth before it is rounded (8-bit"
    echo "output alone allows 58.9 dB); instructions of a frame in 8-bit grey, bold where no method that costs no more is closer"
    echo "to the truth. \`make report\` draws this for every scene, with pictures and plots."
    echo
    echo "| method | PSNR, dB | RMS | largest | M3, M instructions | M0+, M instructions | flash on M3 / M0+, bytes |"
    echo "|---|---|---|---|---|---|---|"
    awk -F, '
        function cost(instructions, beaten_by, bold) {
            bold = beaten_by == "" ? "**" : ""
            return sprintf("%s%.2f%s", bold, instructions / 1e6, bold)
        }
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        $column["scene"] == "torus288" {
            printf "| %s | %.1f | %.2f | %.1f | %s | %s | %d / %d |\n", $column["method"], $column["psnr_db"], $column["rms"],
                $column["max"], cost($column["m3_instructions"], $column["m3_beaten_by"]),
                cost($column["m0plus_instructions"], $column["m0plus_beaten_by"]), $column["m3_flash"], $column["m0plus_flash"]
        }' "$report"
    echo
    echo "The benchmark's torus, 320×240 RGB565, colour and a white highlight (565 alone allows about 41 dB):"
    echo
    echo "| triangles | Gouraud | X with a colour table | X without | Phong |"
    echo "|---|---|---|---|---|"
    for triangles in 288 4000; do
        "$glint" reference "tests/scenes/bench-torus$triangles.json" -o "$work/truth.png"
        printf '| %s |' "$triangles"
        for way in "gouraud 0" "x 1" "x 0" "phong 0"; do
            set -- $way
            "$glint" render "tests/scenes/bench-torus$triangles.json" --format rgb565 --method "$1" --tables "$2" -o "$work/picture.png"
            difference
        done
        echo
    done
    echo
    echo "Million instructions a frame: 320×240 RGB565, z-buffered, clear included, diffuse + specular, a torus of 288 and of"
    echo "4000 triangles (\`make bench\`):"
    echo
    echo "| | M0+, 288 | M4, 288 | M0+, 4000 | M4, 4000 | RAM, 288: whole frame / 8 bands |"
    echo "|---|---|---|---|---|---|"
    awk -F, '
        { n[$1, $2, $3, $4, $5] = $7 / 1e6; ram[$2, $3, $4, $5] = int(($8 + $9) / 1024 + .5) }
        $2 == "bench-torus288" && $3 == "x" && $4 == 1 { memory[$1, $5] = $8; extra[$1] = $6 - $7 }
        function row(name, method, table) {
            printf "| %s | %.2f | %.2f | %.2f | %.2f | %d / %d KiB |\n", name, n["m0plus", "bench-torus288", method, 1, table],
                n["m4", "bench-torus288", method, 1, table], n["m0plus", "bench-torus4000", method, 1, table],
                n["m4", "bench-torus4000", method, 1, table], ram["bench-torus288", method, 1, table],
                ram["bench-torus288", method, 8, table]
        }
        END {
            row("flat", "flat", 0); row("Gouraud", "gouraud", 0); row("**X with a colour table**", "x", 1)
            row("X without", "x", 0); row("Phong, normalised per pixel", "phong", 0)
            printf "\nThe colour table takes %d KiB and is built in the first frame, which takes %.2f million instructions more on M0+ and\n",
                (memory["m4", 1] - memory["m4", 0]) / 1024, extra["m0plus"] / 1e6
            printf "%.2f on M4.\n", extra["m4"] / 1e6
        }' "$csv"
    stack
    echo
} >"$work/figures"
tests/tools/paste.sh "$readme" <"$work/figures"
