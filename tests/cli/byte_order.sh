#!/bin/bash
# SPDX-License-Identifier: MIT
# Scenes for machines of the other byte order. That one draws the same from them is in the list of picture hashes.
. "$(dirname "$0")/check.inc"

fresh
for scene in demo texture-teapot bump-brick spin-pawns; do
    "$glint" pack "$scenes/$scene.json" -o little.glt >/dev/null
    run "$scene is packed for a big-endian machine" 0 "$glint" pack "$scenes/$scene.json" -o big.glt --byte-order big
    "$glint" pack little.glt -o again.glt --byte-order big >/dev/null
    same "$scene from a blob of this order too" big.glt again.glt
    python3 - <<'PY' >said
import struct, zlib
big, little = open("big.glt", "rb").read(), open("little.glt", "rb").read()
head = ">IHHII"
magic, version, _, length, crc = struct.unpack_from(head, big)
print(len(big) == len(little) == length, struct.unpack_from(head, big)[:4] == struct.unpack_from("<IHHII", little)[:4],
      crc == zlib.crc32(big[16:length]))
PY
    run "$scene is as long, has the same head, and is sealed" 0 grep -qx 'True True True' said
done
run 'it is written as C words of its own compiler' 0 \
    sh -c "'$glint' pack '$scenes/demo.json' -o big.c --byte-order big >/dev/null && grep -q '^    0x31544c47, 0x00020000, ' big.c"
run 'a machine that is not big-endian refuses it' 1 "$glint" render big.glt -o out.png
matches 'by its order' "$top/err" '^big.glt: not a scene, or one of the other byte order$'
run 'there are two orders' 2 "$glint" pack "$scenes/demo.json" -o out.glt --byte-order middle
finish
