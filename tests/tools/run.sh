#!/bin/bash
# SPDX-License-Identifier: MIT
# Runs the named suites (make targets suite-NAME), streams their output and counts cases: cmocka's closing lines, and
# lines that begin with `ok` or `FAIL`. A suite that fails without naming a case, or that runs none, is one failure.
# The last line is `N passed, N failed`.
set -u
# As many jobs as there are CPUs, however make was called; its variables go on in MAKEFLAGS.
MAKEFLAGS=$(echo "${MAKEFLAGS-}" | sed -E 's/(^| )-j[0-9]*//; s/--jobserver-[a-z]+=[^ ]*//')
export MAKEFLAGS
passed=0
failed=0
log=$(mktemp)
trap 'rm -f "$log"' EXIT

count() { # pattern of a cmocka line, then the word of a plain line
    awk -v cmocka="$1" -v word="$2" '
        index($0, cmocka) == 1 { sum += substr($0, length(cmocka) + 1) + 0 }
        $1 == word || $1 == word ":" { sum++ }
        END { print sum + 0 }' "$log"
}

for suite in "$@"; do
    echo "== $suite"
    begin=$SECONDS
    ${MAKE:-make} -s -j"$(nproc)" --no-print-directory "suite-$suite" 2>&1 | tee "$log"
    status=${PIPESTATUS[0]}
    good=$(count '[  PASSED  ]' ok)
    bad=$(count '[  FAILED  ]' FAIL)
    if [ "$status" -ne 0 ] && [ "$bad" -eq 0 ]; then
        echo "FAIL $suite: stopped with status $status"
        bad=1
    elif [ "$((good + bad))" -eq 0 ]; then
        echo "FAIL $suite: ran no test"
        bad=1
    fi
    echo "-- $suite: $good passed, $bad failed, $((SECONDS - begin)) s"
    passed=$((passed + good))
    failed=$((failed + bad))
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
