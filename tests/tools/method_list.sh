#!/bin/sh
# SPDX-License-Identifier: MIT
# method_list.sh METHODS.C USES.H [METHOD...] [-METHOD...]: firmware/methods.c with only these methods in its list; without
# names, those that `glint pack --uses` found of use; in no case those with a - before them.
source=$1 uses=$2 names='' without=' '
shift 2
for name in "$@"; do
    grep -q "^    {\"${name#-}\"," "$source" || { echo "method_list.sh: METHODS: there is no method ${name#-}" >&2; exit 2; }
    case $name in
        -*) without="$without${name#-} " ;;
        *) names="$names $name" ;;
    esac
done
[ "$names" ] || names=$(sed -n 's|^/\* methods:\(.*\) \*/$|\1|p' "$uses")
awk -v names=" $names " -v without="$without" '!/^    \{"/ { print; next }
    { split($0, part, "\""); if (index(names, " " part[2] " ") && !index(without, " " part[2] " ")) print }' "$source"
