#!/bin/sh
# SPDX-License-Identifier: MIT
# method_list.sh METHODS.C [METHOD...]: firmware/methods.c with only these methods in its list; without names, all.
source=$1
shift
for name in "$@"; do
    grep -q "^    {\"$name\"," "$source" || { echo "method_list.sh: METHODS: there is no method $name" >&2; exit 2; }
done
awk -v names=" $* " 'names !~ /[a-z]/ || !/^    \{"/ { print; next }
    { split($0, part, "\""); if (index(names, " " part[2] " ")) print }' "$source"
