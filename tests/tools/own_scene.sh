#!/bin/sh
# SPDX-License-Identifier: MIT
# own_scene.sh PACK FILE OUT.c: a scene or a model as C, its symbol as scene_list.sh has it; OUT.c is new only when it differs.
name=$(basename "$3" .c)
case $name in *[!A-Za-z0-9_-]*) echo "$2: a scene's name in a program is of letters, digits, - and _" >&2; exit 2 ;; esac
"$1" pack "$2" -o "$3.new" --output-format c --name "scene_$(echo "$name" | tr - _)" >/dev/null || exit
if cmp -s "$3.new" "$3"; then rm "$3.new"; else mv "$3.new" "$3"; fi
