#!/bin/bash
# SPDX-License-Identifier: MIT
# readme_example.sh LIBRARY SCENES: the README's first C block compiles as it stands, links and draws: it is a complete
# program with `scene_torus288` linked in, and exits with 0.
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
awk '/^```c$/ { inside = 1; next } /^```/ { if (inside) exit } inside' README.md >"$work/example.c"
lines=$(grep -c . "$work/example.c")
if [ "$lines" -eq 0 ]; then
    echo "FAIL docs: README.md has no C block"
elif ! ${CC:-gcc} -std=c11 -Wall -Wextra -Werror -Ifirmware -Ihal -I. "$work/example.c" "$2/torus288.c" "$1" -o "$work/example"; then
    echo "FAIL docs: the README's example does not compile"
elif ! "$work/example" >"$work/out"; then
    echo "FAIL docs: the README's example fails"
else
    echo "ok docs: the README's example compiles and runs ($lines lines)"
    exit 0
fi
exit 1
