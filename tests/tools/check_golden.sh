#!/bin/bash
# SPDX-License-Identifier: MIT
# check_golden.sh NAME all|small COMMAND...: the lines that COMMAND prints are those of tests/golden/hashes.txt (all of
# them, or what fits 16 KiB of RAM).
set -u
name=$1
part=$2
shift 2
want=$(mktemp)
got=$(mktemp)
trap 'rm -f "$want" "$got"' EXIT
if [ "$part" = small ]; then
    grep '^mini ' tests/golden/hashes.txt | grep -v -e '-table ' >"$want"
else
    cp tests/golden/hashes.txt "$want"
fi
timeout 600 "$@" >"$got"
status=$?
if [ $status -eq 0 ] && [ -s "$want" ] && cmp -s "$want" "$got"; then
    echo "ok golden: $(wc -l <"$got") pictures, each whole, in bands and unplanned: $name"
else
    echo "FAIL golden: $name (status $status)"
    diff "$want" "$got" | head -8
    exit 1
fi
