#!/bin/sh
# SPDX-License-Identifier: MIT
# scene_list.sh [--app] SCENE...: the table program_scenes[] of the named scenes, or the app's, as C.
header=tests/device/program.h table=program_scene
[ "$1" != --app ] || { header=app/app.h table=app_scene; shift; }
echo '/* Made by tests/tools/scene_list.sh */'
echo "#include \"$header\""
for name in "$@"; do
    symbol=scene_$(echo "$name" | tr - _)
    echo "extern const uint32_t ${symbol}[], ${symbol}_length;"
done
echo "const struct $table ${table}s[] = {"
for name in "$@"; do
    symbol=scene_$(echo "$name" | tr - _)
    echo "    {\"$name\", $symbol, &${symbol}_length},"
done
echo '};'
echo "const unsigned ${table}_count = sizeof ${table}s / sizeof ${table}s[0];"
