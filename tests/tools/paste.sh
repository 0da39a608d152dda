#!/bin/bash
# SPDX-License-Identifier: MIT
# paste.sh FILE: puts standard input between FILE's lines `<!-- figures begin ... -->` and `<!-- figures end -->`.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/figures"
awk -v figures="$work/figures" '
    /<!-- figures end -->/ { inside = 0 }
    !inside { print }
    /<!-- figures begin/ { inside = 1; while ((getline line < figures) > 0) print line }' "$1" >"$work/file"
cat "$work/file" >"$1"
