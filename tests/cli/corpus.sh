#!/bin/bash
# SPDX-License-Identifier: MIT
# glint-view and the decoder that was made from PROTOCOL.md alone show the same pictures of every stream that a fuzzer
# found, or both none.
. tests/cli/check.inc
view=$glint-view
fuzz=$(dirname "$scenes")/fuzz

fresh
python3 "$fuzz/viewer.py" "$view" "$fuzz/corpus" >"$top/out" 2>"$top/err"
cat "$top/out"
passed=$(grep -c '^ok' "$top/out")
failed=$(grep -c '^FAIL' "$top/out")
[ $((passed + failed)) -eq 2 ] || say FAIL 'the second decoder stopped' "$(tail -n 1 "$top/err")"
finish
