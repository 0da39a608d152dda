#!/bin/bash
# SPDX-License-Identifier: MIT
# bench_stream.sh STREAM.CSV [markdown]: what packing a picture for a stream costs, as a table; in Markdown of the first
# scene alone.
set -eu
awk -F, -v markdown="${2-}" '
    NR == 1 { next }
    { key = $2 "," $3 "," $4; bytes[key] = $6; million[$1, key] = $7 / 1e6; pixel[$1, key] = $7 / $5 }
    !(key in seen) { seen[key] = 1; row[++rows] = key }
    END {
        if (markdown) {
            split(row[1], field, ",")
            printf "| `%s` | codec | bytes | M0+, instructions a pixel | M3 | M0+, million a picture | M3 |\n", field[1]
            print "|---|---|---|---|---|---|---|"
        } else {
            printf "%-32s %5s %6s  %17s  %17s  %17s\n", "240x240: instructions a pixel", "codec", "bytes", "M0+, M a picture",
                "M3, M a picture", "M4, M a picture"
        }
        for (r = 1; r <= rows; r++) {
            k = row[r]
            split(k, field, ",")
            first = first ? first : field[1]
            if (markdown && field[1] == first)
                printf "| %s | %s | %d | %.1f | %.1f | %.2f | %.2f |\n", field[2], field[3], bytes[k],
                    pixel["m0plus", k], pixel["m3", k], million["m0plus", k], million["m3", k]
            else if (markdown)
                continue
            else
                printf "%-32s %5s %6d  %9.1f  %6.2f  %9.1f  %6.2f  %9.1f  %6.2f\n", field[1] " " field[2], field[3], bytes[k],
                    pixel["m0plus", k], million["m0plus", k], pixel["m3", k], million["m3", k], pixel["m4", k], million["m4", k]
        }
    }' "$1"
[ "${2-}" ] || echo "rows: $1"
