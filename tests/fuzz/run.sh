#!/bin/bash
# SPDX-License-Identifier: MIT
# run.sh BUILD CORPUS SECONDS TARGET...: fuzzes each target for so long, as many at a time as there are CPUs, from its
# corpus and what earlier runs found, and says what came of it. What broke a target is kept, and named.
set -u
build=$1
corpus=$2
seconds=$3
shift 3
export build corpus seconds

one() {
    local found=$build/found/$1 log=$build/$1.log code
    mkdir -p "$found" "$build/broken"
    case $1 in # bytes, by what they have to hold
    fuzz_view) most=1280 ;;
    fuzz_remote) most=320 ;;
    fuzz_scene) most=4000 ;;
    fuzz_json | fuzz_mesh) most=1600 ;;
    fuzz_picture) most=400 ;;
    *) most=192 ;;
    esac
    ASAN_OPTIONS=quarantine_size_mb=1:malloc_context_size=4:max_allocation_size_mb=1500 "$build/fuzz/$1" -max_total_time="$seconds" -max_len=$most \
        -timeout=10 -reload=0 -print_final_stats=1 -artifact_prefix="$build/broken/$1-" \
        "$found" "$corpus/$1" >"$log" 2>&1
    code=$?
    sed -nE 's/^#([0-9]+)\tDONE +cov: ([0-9]+) .*corp: ([0-9]+).*exec\/s: ([0-9]+).*/\1 executions, \4 a second, \2 edges, \3 inputs/p' \
        "$log" | sed "s/^/$1: /"
    [ $code -eq 0 ] && return 0
    echo "FAIL $1: $(grep -m 1 -E 'broken:|ERROR: |runtime error:' "$log"); $(sed -n 's/.*Test unit written to //p' "$log")"
    return 1
}
export -f one
rm -f "$build"/fuzz_*.log
printf '%s\n' "$@" | nice xargs -P "$(nproc)" -I{} bash -c 'one {}'
status=$?
grep -hE '^#[0-9]+\sDONE' "$build"/fuzz_*.log | awk '{ sum += substr($1, 2) } END { printf "%d executions\n", sum }'
[ $status -eq 0 ]
