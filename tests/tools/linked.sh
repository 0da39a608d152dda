#!/bin/sh
# SPDX-License-Identifier: MIT
# linked.sh USES.H METHODS.C: what an image was compiled for, and the methods that it links.
sed -n 's|^#define.*/\* \(.*\) \*/$|  for scenes and formats with: \1|p' "$1"
awk -F'"' '/^    \{"/ { names = names " " $2 } END { print "  methods:" names }' "$2"
