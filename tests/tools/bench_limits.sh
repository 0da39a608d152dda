#!/bin/bash
# SPDX-License-Identifier: MIT
# bench_limits.sh DEVICE.CSV: the instruction counts that x, diffuse and specular, must keep.
set -u
awk -F, '
    function verdict(value, most) {
        if (value > 0 && value <= most) return "ok"
        bad++
        return "FAIL"
    }
    function limit(cpu, scene, most, n) {
        n = next_frame[cpu, scene, 1] / 1e6
        printf "%s bench: %s on %s takes %.2f of at most %.2f M instructions a frame\n", verdict(n, most), scene, cpu, n, most
    }
    function bands(cpu, scene, whole, ratio) {
        whole = next_frame[cpu, scene, 1]
        ratio = whole ? next_frame[cpu, scene, 8] / whole : 0
        printf "%s bench: %s on %s in 8 bands takes %.3f of at most 1.25 of the whole frame\n", verdict(ratio, 1.25), scene,
            cpu, ratio
    }
    # with the colour table, the way meant for RGB565; a frame after the one that builds it
    $3 == "x" && $5 == 1 { next_frame[$1, $2, $4] = $7 }
    END {
        limit("m4", "bench-torus288", 1.35); limit("m0plus", "bench-torus288", 1.9)
        limit("m4", "bench-torus4000", 3.9); limit("m0plus", "bench-torus4000", 6.4)
        for (c = 1; c <= split("m0plus m3 m4", cpu, " "); c++) {
            bands(cpu[c], "bench-torus288"); bands(cpu[c], "bench-torus4000")
        }
        exit bad > 0
    }' "$1"
