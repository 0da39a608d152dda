#!/bin/bash
# SPDX-License-Identifier: MIT
# figures.sh GLINT BENCH.CSV REPORT.CSV TRAFFIC.CSV PACKING.CSV SWEEP.CSV README: writes README's figures of quality and
# cost anew, between its figure marks.
# figures.sh stream TRAFFIC.CSV PACKING.CSV: prints what pictures take as a stream, for host-tools/README.md. Both are
# stream.csv, that of build/report and that of build/bench.
# figures.sh budgets SWEEP.CSV REPORT.CSV: prints what budgets of auto buy, and whether its goals hold.
# figures.sh stack: prints the one of them that says how much stack the renderer takes, from $BUILD's objects; carried: that
# of streams, as `stream`.
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
thousands='function t(n) { n += 0; return n < 1000 ? n : int(n / 1000) "," sprintf("%03d", n % 1000) }'

stream() { # TRAFFIC.CSV PACKING.CSV
    echo
    echo "Bytes a picture as a stream, headers included: alone (codec 1) / as sent, against the picture 20 ms before (codec 2). The"
    echo "mean of 20 pictures over a loop, by x, in four bands; a scene that stands still is given a turn in 4 s. \`make report\`"
    echo "has more: changed rows, the longest picture, pictures a second, and what to choose."
    echo
    echo "| scene | RGB565 240×240 | dithered | GREY8 240×240 | GREY4 240×240, dithered | GREY4 128×64, dithered |"
    echo "|---|---|---|---|---|---|"
    awk -F, "$thousands"'
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        { key = $1 "," $2 "," $3; raw[$2 "," $3] = $column["raw"]; cell[key] = t($column["alone"]) " / " t($column["change"]) }
        !($1 in seen) { seen[$1] = 1; scene[++scenes] = $1 }
        END {
            kinds = split("rgb565,240;rgb565 dithered,240;grey8,240;grey4 dithered,240;grey4 dithered,128", kind, ";")
            printf "| any, raw (codec 0) |"
            for (k = 1; k <= kinds; k++) printf " %s |", t(raw[kind[k]])
            for (s = 1; s <= scenes; s++) {
                printf "\n| `%s` |", scene[s]
                for (k = 1; k <= kinds; k++) printf " %s |", cell[scene[s] "," kind[k]]
            }
            printf "\n"
        }' "$1"
    echo
    echo "What it takes to pack and check a picture of 57,600 pixels in bands of 30 rows, codec 2 with the copy for the next one (\`make bench-stream\`):"
    echo
    tests/tools/bench_stream.sh "$2" markdown
    echo
}
carried() { # the same, in three lines for README
    awk -F, "$thousands"'
        FNR == 1 { file++ }
        file == 1 && FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
        file == 1 && $1 == "torus800" && $3 == 240 { sent[$2] = $column["change"]; raw[$2] = $column["raw"] }
        file == 2 && $2 == "bench-torus288" && $3 == "rgb565" && $4 == 2 { pixel[$1] = $7 / $5 }
        END {
            printf "As a stream ([PROTOCOL.md](firmware/stream/PROTOCOL.md)) a torus of 800 triangles, turning, 240×240 RGB565, takes %s bytes a\n",
                t(sent["rgb565"])
            printf "picture, dithered %s, of %s: %.0f and %.0f pictures a second over 1 MB/s, full-speed USB. To pack them takes %.0f instructions a pixel\n",
                t(sent["rgb565 dithered"]), t(raw["rgb565"]), 1e6 / sent["rgb565"], 1e6 / sent["rgb565 dithered"], pixel["m3"]
            printf "on M3, %.0f on M0+ (`make report`, `make bench-stream`; more in [host-tools/README.md](host-tools/README.md#streams-and-glint-view)).\n",
                pixel["m0plus"]
        }' "$1" "$2"
}
budgets() { # SWEEP.CSV REPORT.CSV
    echo "Error budgets: the method \`auto\` is told how many 255ths a pixel may be off, and takes for each triangle the cheapest way"
    echo "whose bound allows it. Million instructions of a frame on M3 / largest difference, 240×240, 8-bit grey, exponent 20:"
    echo
    awk -F, '
        FNR == 1 { file++; delete column; for (i = 1; i <= NF; i++) column[$i] = i; next }
        function cell(millions, max) { return sprintf(" %.2f / %.1f |", millions / 1e6, max) }
        {
            key = $column["scene"] SUBSEP (file == 1 ? $column["budget"] : $column["method"])
            cost[key] = $column["m3_instructions"]
            most[key] = $column["max"]
        }
        END {
            scenes = split("torus288 torus800 sphere690 teapot896-grey", scene, " ")
            ways = split("gouraud 32 16 8 4 2 1 0.5 duff phong", way, " ")
            printf "| scene |"
            for (w = 1; w <= ways; w++) printf " %s%s |", way[w] ~ /^[0-9]/ ? "auto, " : "", way[w]
            printf "\n|---|"
            for (w = 1; w <= ways; w++) printf "---|"
            printf "\n"
            for (s = 1; s <= scenes; s++) {
                name = scene[s]
                if (!((name, 2) in cost)) { print "figures.sh: no budgets of " name > "/dev/stderr"; exit 1 }
                printf "| `%s` |", name
                for (w = 1; w <= ways; w++) printf "%s", cell(cost[name, way[w]], most[name, way[w]])
                printf "\n"
                less[s] = 100 - 100 * cost[name, 2] / cost[name, "duff"]
                times[s] = cost[name, 8] / cost[name, "gouraud"]
                quick = quick (s > 1 ? ", " : "") sprintf("%.0f", less[s]) (less[s] < 25 ? " (missed)" : "")
                fast = fast (s > 1 ? ", " : "") sprintf("%.2f", times[s]) (times[s] > (name == "torus288" ? 2 : 1.6) ? " (missed)" : "")
            }
            printf "\nAt budget 2, to be a quarter cheaper than duff: %s %% cheaper. At budget 8, to cost at most 1.6 times gouraud\n", quick
            printf "(`torus288`: twice): %s times. Commands, and a plot a scene with all methods:\n", fast
        }' "$1" "$2"
    echo
    echo "    build/glint render tests/scenes/torus288.json --method auto --budget 2 --format grey8 --stats -o auto.png"
    echo "    make report REPORT_SCENES=\"torus288 torus800 sphere690 teapot896-grey\""
    echo
}
if [ "$1" = budgets ] || [ "$1" = stack ] || [ "$1" = stream ] || [ "$1" = carried ]; then
    "$@"
    exit
fi
glint=$1 csv=$2 report=$3 traffic=$4 packing=$5 sweep=$6 readme=$7
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
    budgets "$sweep" "$report"
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
    carried "$traffic" "$packing"
    echo
} >"$work/figures"
tests/tools/paste.sh "$readme" <"$work/figures"
