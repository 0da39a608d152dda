#!/bin/bash
# SPDX-License-Identifier: MIT
# lines.sh EXCEPTIONS OBJECTS SOURCE...: after a run of programs built with --coverage, which lines of the sources it did
# not reach. No input can reach those in EXCEPTIONS, lines `source | text of the line | why`.
set -u
exceptions=$1
objects=$2
shift 2
status=0
for source in "$@"; do
    report=$(gcov --stdout --object-file "$objects/${source%.c}.o" "$source" 2>&1 |
        awk -v source="$source" '/ 0:Source:/ { ours = substr($0, length($0) - length(source) + 1) == source } ours')
    excepted=$(sed -n "s,^$source | \(.*\) | .*,\1,p" "$exceptions")
    missed=$(sed -n 's/^ *#####: *\([0-9]*\): */\1 /p' <<<"$report" | while read -r line text; do
        [ -n "$excepted" ] && grep -qxF -- "$text" <<<"$excepted" || echo "$line"
    done | paste -sd ' ')
    reached=$(grep -cE '^ *[0-9]+[*]?: *[0-9]+:' <<<"$report")
    if [ -z "$missed" ] && [ "$reached" -gt 0 ]; then
        echo "ok fuzz: the corpus reaches all $reached lines of $source"
    else
        echo "FAIL fuzz: the corpus reaches $reached lines of $source, not: ${missed:-$(head -n 1 <<<"$report")}"
        status=1
    fi
done
exit $status
