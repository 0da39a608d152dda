#!/bin/bash
# SPDX-License-Identifier: MIT
# bench.sh DEVICE.CSV HOST_PROGRAM: adds the host's instructions (callgrind) to the boards' and prints the tables; the
# rows are kept in build/bench/bench.csv.
set -eu
device=$1 program=$2 csv=$BUILD/bench/bench.csv
echo "cpu,scene,method,bands,tables,first,next,memory,band_bytes,triangles,pixels,setups" >"$csv"
grep -v '^#' "$device" >>"$csv"

count() { # arguments of the program
    valgrind --tool=callgrind --toggle-collect=bench_frame --callgrind-out-file=/dev/null "$program" "$@" 2>&1 |
        awk '/Collected :/ { print $4 }'
}
"$program" | grep -v '^#' | while IFS=, read -r scene method bands tables _ _ rest; do
    first=$(count "$scene" "$method" "$bands" "$tables" 1)
    both=$(count "$scene" "$method" "$bands" "$tables" 2)
    echo "x86-64,$scene,$method,$bands,$tables,$first,$((both - first)),$rest" >>"$csv"
done
grep '^#' "$device" | sort -u
awk -F, '
    NR == 1 { next }
    { first[$1, $2, $3, $4, $5] = $6; next_[$1, $2, $3, $4, $5] = $7; ram[$2, $3, $4, $5] = $8 + $9 }
    !(($2, $3, $5) in seen) { seen[$2, $3, $5] = 1; row[++rows] = $2 SUBSEP $3 SUBSEP $5 }
    END {
        cpus = split("m0plus m3 m4 x86-64", cpu, " ")
        for (r = 1; r <= rows; r++) {
            split(row[r], key, SUBSEP)
            if (key[1] != last) {
                last = key[1]
                covered = last == "bench-torus288" ? 36007 : 37968
                printf "\n%s, 320x240, RGB565: million instructions a frame (each covered pixel; first frame; 8 bands)\n", last
                printf "  %-16s", ""
                for (c = 1; c <= cpus; c++) printf "  %-30s", cpu[c]
                printf "  RAM whole / 8 bands\n"
            }
            printf "  %-16s", key[2] (key[3] ? " with table" : "")
            for (c = 1; c <= cpus; c++) {
                one = next_[cpu[c], key[1], key[2], 1, key[3]]
                eight = next_[cpu[c], key[1], key[2], 8, key[3]]
                printf "  %-30s", sprintf("%6.3f (%.1f; %.3f; x%.3f)", one / 1e6, one / covered,
                    first[cpu[c], key[1], key[2], 1, key[3]] / 1e6, one ? eight / one : 0)
            }
            printf "  %d / %d\n", ram[key[1], key[2], 1, key[3]], ram[key[1], key[2], 8, key[3]]
        }
    }' "$csv"
echo
echo "rows: $csv"
