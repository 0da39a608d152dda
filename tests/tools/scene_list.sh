#!/bin/sh
# SPDX-License-Identifier: MIT
# scene_list.sh SCENE...: the table program_scenes[] of the named scenes, as C.
echo '/* Made by tests/tools/scene_list.sh */'
echo '#include "app/program_scene.h"'
for name in "$@"; do
    symbol=scene_$(echo "$name" | tr - _)
    echo "extern const uint32_t ${symbol}[], ${symbol}_length;"
done
echo 'const struct program_scene program_scenes[] = {'
for name in "$@"; do
    symbol=scene_$(echo "$name" | tr - _)
    echo "    {\"$name\", $symbol, &${symbol}_length},"
done
echo '};'
echo 'const unsigned program_scene_count = sizeof program_scenes / sizeof program_scenes[0];'
