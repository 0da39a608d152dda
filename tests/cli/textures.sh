#!/bin/bash
# SPDX-License-Identifier: MIT
# Textures of scenes and models: read, resampled, drawn, and refused with a reason.
. tests/cli/check.inc

scene() { # material's texture, members besides
    cat >scene.json <<EOF
{"camera": {"focal": 60, "size": [64, 48], "near": 1, "far": 9, "position": [0, 0, 3]},
 "lights": [{"towards": [0, 0, 1]}], "materials": {"m": {"texture": "$1"}}${2:+, $2},
 "meshes": {"p": {"shape": "plane", "size": [2, 2], "axis": "z", "material": "m"}}, "objects": [{"mesh": "p"}]}
EOF
}
refused() { # name, code, pattern
    run "$1" "$2" "$glint" pack scene.json -o out.glt
    matches 'it says why' "$top/err" "$3"
}

fresh
"$glint" render "$scenes/tiny.json" --size 100x48 -o tile.png
mkdir folder
mv tile.png folder
scene folder/tile.png
run 'a PNG file beside the scene is a texture' 0 "$glint" pack scene.json -o a.glt
matches 'what was done to it is told' "$top/out" '^texture .*tile\.png": 128x64, resampled from 100x48'
matches 'and its bytes' "$top/out" '^bytes .* textures [0-9]+'
run 'info counts them too' 0 "$glint" info a.glt
matches 'with their size' "$top/out" '^texture +0: 128x64 rgb565, bilinear'
run 'info as JSON' 0 "$glint" info a.glt --json
matches 'has the same' "$top/out" '"format": "rgb565"'
run 'a packed texture is drawn' 0 "$glint" render a.glt -o a.png
scene t '"textures": {"t": {"file": "folder/tile.png", "format": "palette8", "filter": "nearest", "wrap": ["clamp", "repeat"]}}'
run 'a texture with settings has a name' 0 "$glint" pack scene.json -o b.glt
matches 'its colours are brought down' "$top/out" 'colours'
for kind in affine quadratic split perspective; do
    run "coordinates are interpolated $kind" 0 "$glint" render b.glt --texture $kind --hash
done
run 'statistics tell how' 0 "$glint" render "$scenes/texture-quad.json" --texture quadratic --stats --hash
matches 'of each triangle' "$top/out" '^mapped +2 quadratic$'
run 'in no other way' 2 "$glint" render b.glt --texture cubic --hash
matches 'and all are told' "$top/err" "'cubic' will not do for --texture KIND: .*affine, .*perspective; default: .* allows$"

fresh
scene no.png
refused 'a missing file is reported' 3 '^no\.png: No such file'
scene m '"textures": {"no.png": {"pattern": "checker"}, "t": {"file": "no.png"}}'
refused 'what is only called as a file is not the file' 3 '^no\.png: No such file'
scene m '"bumps": {"no.png": {"relief": "waves"}, "b": {"heights": "no.png"}}'
refused 'nor is a bump map' 3 '^no\.png: No such file'
echo 'not a picture' >bad.png
scene bad.png
refused 'a file that is no PNG is refused' 1 '^bad\.png: not a PNG file$'
printf '\211PNG\r\n\032\n\0\0\0\rIHDR\0\0\0\10' >cut.png
scene cut.png
refused 'a PNG file that is cut short is refused' 1 '^cut\.png: '
printf '\211PNG\r\n\032\n\0\0\0\rIHDR\177\377\377\377\177\377\377\377\10\2\0\0\0\0\0\0\0' >huge.png
scene huge.png
refused 'an absurd size is refused' 1 '^huge\.png: '
mkdir dir.png
scene dir.png
refused 'a directory is no texture' 3 '^dir\.png: '
mkfifo pipe.png
scene pipe.png
refused 'a pipe is not waited for' 3 '^pipe\.png: not a regular file'
scene wood
refused 'a texture needs to be there' 1 'materials\.m\.texture: no texture named "wood"'
scene t '"textures": {"t": {}}'
refused 'a texture is a file or a pattern' 1 'textures\.t: must be an object with either "file" or "pattern"'
scene t '"textures": {"t": {"pattern": "plaid"}}'
refused 'patterns are known ones' 1 'textures\.t\.pattern: "plaid" is none of'
scene t '"textures": {"t": {"pattern": "checker", "size": [0, 8]}}'
refused 'a pattern has a size' 1 'textures\.t\.size'
scene t '"textures": {"t": {"pattern": "checker", "wrap": "mirror"}}'
refused 'borders repeat or go on' 1 'textures\.t\.wrap: "mirror" is none of'
scene t '"textures": {"t": {"pattern": "checker", "colour": [0, 0, 0]}}'
refused 'members are known ones' 1 'textures\.t'

fresh
"$glint" render "$scenes/tiny.json" --size 32x32 -o skin.png
cat >model.obj <<EOF
mtllib model.mtl
usemtl skin
v -1 -1 0
v 1 -1 0
v 1 1 0
vt 0 0
vt 1 0
vt 1 1
f 1/1 2/2 3/3
EOF
printf 'newmtl skin\nKd 1 1 1\nmap_Kd skin.png\n' >model.mtl
run 'a model brings its texture' 0 "$glint" pack model.obj -o m.glt
matches 'which is packed' "$top/out" '^texture .*skin\.png": 32x32'
run 'and drawn' 0 "$glint" render model.obj --hash
printf 'newmtl skin\nKd 1 1 1\nmap_Kd none.png\n' >model.mtl
"$glint" pack model.obj -o n.glt >"$top/out" 2>"$top/err"
if [ $? -eq 0 ]; then say ok 'a model is drawn without a texture that is missing'; else say FAIL 'a missing texture stops a model'; fi
matches 'which is told' "$top/err" '^none\.png: No such file'

# A triangle: places and texture coordinates as floats, the picture named or inside.
gltf() { # image
    local one='\0\0\200\077' none='\0\0\0\0'
    cat >model.gltf <<EOF
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
 "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}], "textures": [{"source": 0}],
 "images": [{"uri": "$1"}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
               {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
 "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,$(
     printf "$none$none$none$one$none$none$none$one$none$none$none$one$none$none$one" | base64 -w 0)"}]}
EOF
}
without() { # name, pattern
    "$glint" render model.gltf --hash >"$top/out" 2>"$top/err"
    local code=$?
    if [ $code -eq 0 ]; then say ok "$1"; else say FAIL "$1" "exit code $code"; fi
    matches 'which is told' "$top/err" "$2"
    matches 'with what comes of it' "$top/err" '^model\.gltf: warning: drawn without this texture$'
}
gltf skin.png
run 'glTF brings the file of its texture' 0 "$glint" render model.gltf --hash
cp "$top/out" beside
gltf "data:image/png;base64,$(base64 -w 0 skin.png)"
run 'or the texture itself' 0 "$glint" render model.gltf --hash
same 'which is drawn alike' "$top/out" beside
run 'and packed' 0 "$glint" pack model.gltf -o inside.glt
matches 'under its number' "$top/out" '^texture .*model\.gltf: image 0": 32x32'
gltf "data:image/png;base64,$(head -c 200 skin.png | base64 -w 0)"
without 'a picture inside that is cut short is left out' '^model\.gltf: image 0: '
gltf "data:image/jpeg;base64,$(printf '\377\330\377\340 no PNG' | base64 -w 0)"
without 'and so is a JPEG' '^model\.gltf: image 0: not a PNG file$'
: >skin.jpg
gltf skin.jpg
"$glint" render model.gltf --hash >"$top/out" 2>"$top/err"
matches 'beside the model too' "$top/err" '^skin\.jpg: warning: no texture: only PNG files are read$'
finish
