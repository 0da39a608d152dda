#!/bin/sh
# SPDX-License-Identifier: MIT
# method_list.sh METHODS.C USES.H [METHOD...]: firmware/methods.c with only these methods in its list; without names, those
# that `glint pack --uses` found of use.
source=$1 uses=$2
shift 2
[ $# -gt 0 ] || set -- $(sed -n 's|^/\* methods:\(.*\) \*/$|\1|p' "$uses")
for name in "$@"; do
    grep -q "^    {\"$name\"," "$source" || { echo "method_list.sh: METHODS: there is no method $name" >&2; exit 2; }
done
awk -v names=" $* " '!/^    \{"/ { print; next }
    { split($0, part, "\""); if (index(names, " " part[2] " ")) print }' "$source"
