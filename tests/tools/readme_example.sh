#!/bin/bash
# SPDX-License-Identifier: MIT
# readme_example.sh LIBRARY SCENES: the README's first C block compiles as it stands, links and draws: it is a complete
# program with `scene_torus288` linked in, and exits with 0. Its CI job installs what it needs before it builds, and its
# figure of the stack is that of the objects in $BUILD.
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
fail() {
    echo "FAIL docs: $1"
    status=1
}

awk '/^```c$/ { inside = 1; next } /^```/ { if (inside) exit } inside' README.md >"$work/example.c"
lines=$(grep -c . "$work/example.c")
if [ "$lines" -eq 0 ]; then
    fail "README.md has no C block"
elif ! ${CC:-gcc} -std=c11 -Wall -Wextra -Werror -Ifirmware -Ihal -I. "$work/example.c" "$2/torus288.c" "$1" -o "$work/example"; then
    fail "the README's example does not compile"
elif ! "$work/example" >"$work/out"; then
    fail "the README's example fails"
else
    echo "ok docs: the README's example compiles and runs ($lines lines)"
fi

# what make would do, in its order: deps.sh installs unless told otherwise
read -r -a job <<<"$(sed -n 's/^ *- run: make -C glint *//p' README.md)"
first=$(env -u MAKEFLAGS make -n "${job[@]}" | grep -m 1 'deps\.sh')
case $first in
'') fail "the README's CI job does not look for packages" ;;
*manual*) fail "the README's CI job installs nothing: $first" ;;
*) echo "ok docs: the README's CI job installs what it builds with" ;;
esac

stack=$(tests/tools/figures.sh stack)
if [ -n "$stack" ] && grep -qxF "$stack" README.md; then
    echo "ok docs: the README's figure of the stack is true"
else
    fail "the README's figure of the stack is not '$stack': make figures"
fi

# of every target that says what it does
listed=$(make -s help | wc -l)
told=$(grep -c '^[^[:space:]#]*:.*## ' Makefile)
if [ "$listed" -eq "$told" ]; then
    echo "ok docs: make help lists all $told targets"
else
    fail "make help lists $listed of $told targets"
fi
exit $status
