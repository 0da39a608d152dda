#!/bin/bash
# SPDX-License-Identifier: MIT
# lines.sh OBJECTS SOURCE...: after a run of programs built with --coverage, which lines of the sources it did not reach.
set -u
objects=$1
shift
status=0
for source in "$@"; do
    report=$(gcov --stdout --object-file "$objects/${source%.c}.o" "$source" 2>&1)
    missed=$(sed -n 's/^ *#####: *\([0-9]*\):.*/\1/p' <<<"$report" | paste -sd ' ')
    reached=$(grep -cE '^ *[0-9]+[*]?: *[0-9]+:' <<<"$report")
    if [ -z "$missed" ] && [ "$reached" -gt 0 ]; then
        echo "ok fuzz: the corpus reaches all $reached lines of $source"
    else
        echo "FAIL fuzz: the corpus reaches $reached lines of $source, not: ${missed:-$(head -n 1 <<<"$report")}"
        status=1
    fi
done
exit $status
