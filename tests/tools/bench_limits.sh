#!/bin/bash
# SPDX-License-Identifier: MIT
# bench_limits.sh DEVICE.CSV: the instruction counts that x, diffuse and specular, must keep.
set -u
awk -F, '
    function limit(cpu, scene, most, n) {
        n = next_frame[cpu, scene, 1]
        printf "%s bench: %s on %s takes %.2f of at most %.2f M instructions a frame\n",
            n > 0 && n <= most * 1e6 ? "ok" : "FAIL", scene, cpu, n / 1e6, most
        bad += !(n > 0 && n <= most * 1e6)
    }
    function bands(cpu, scene, ratio) {
        ratio = next_frame[cpu, scene, 1] ? next_frame[cpu, scene, 8] / next_frame[cpu, scene, 1] : 0
        printf "%s bench: %s on %s in 8 bands takes %.3f of at most 1.25 of the whole frame\n",
            ratio > 0 && ratio <= 1.25 ? "ok" : "FAIL", scene, cpu, ratio
        bad += !(ratio > 0 && ratio <= 1.25)
    }
    # with the colour table, the way meant for RGB565; a frame after the one that builds it
    $3 == "x" && $5 == 1 { next_frame[$1, $2, $4] = $7 }
    END {
        limit("m4", "bench-torus288", 1.6); limit("m0plus", "bench-torus288", 2.5)
        limit("m4", "bench-torus4000", 3.9); limit("m0plus", "bench-torus4000", 6.7)
        for (c = 1; c <= split("m0plus m3 m4", cpu, " "); c++) {
            bands(cpu[c], "bench-torus288"); bands(cpu[c], "bench-torus4000")
        }
        exit bad > 0
    }' "$1"
