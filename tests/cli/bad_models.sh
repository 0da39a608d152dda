#!/bin/bash
# SPDX-License-Identifier: MIT
# Model files from assimp's own test collection, whole and malformed: a picture's worth of triangles or one line that
# says why not, never a crash, and no output file after a failure.
. tests/cli/check.inc
models=${MODELS:-/usr/share/assimp/models}

if [ ! -d "$models" ]; then
    say FAIL "the model collection is there" "$models: install assimp-testmodels"
    finish
fi

good() { # FILE TRIANGLES
    local name="$1 packs"
    fresh
    if [ ! -f "$models/$1" ]; then
        say FAIL "$name" "not in $models"
    elif ! "$glint" pack "$models/$1" -o out.glt >"$top/out" 2>"$top/err"; then
        say FAIL "$name" "$(head -n 1 "$top/err")"
    elif ! "$glint" info out.glt >"$top/out" 2>"$top/err"; then
        say FAIL "$name" "what was packed does not load: $(head -n 1 "$top/err")"
    elif ! grep -q " $2 triangles a frame" "$top/out"; then
        say FAIL "$name" "not $2 triangles: $(head -n 1 "$top/out")"
    else
        say ok "$name"
    fi
}

bad() { # FILE, relative to the collection or to the case's folder
    local file=$1
    [ "${file#/}" = "$file" ] && [ ! -e "$file" ] && file=$models/$1
    if [ ! -f "$file" ]; then
        say FAIL "$1 is refused" "not in $models"
    elif run "$1 is refused" 1 "$glint" pack "$file" -o out.glt; then
        matches "$1 is named" "$top/err" "^$file:([0-9]+:)? .+"
        run "$1 is not drawn" 1 "$glint" render "$file" -o out.png
    fi
}

good OBJ/box.obj 12
good OBJ/spider.obj 1312
good OBJ/WusonOBJ.obj 3732
good OBJ/concave_polygon.obj 64
good PLY/cube.ply 12
good PLY/cube_binary.ply 12
good PLY/Wuson.ply 3732
good STL/Spider_ascii.stl 1312
good STL/Spider_binary.stl 1312
good STL/sphereWithHole.stl 285
good glTF/TwoBoxes/TwoBoxes.gltf 24
good glTF/CesiumMilkTruck/CesiumMilkTruck.gltf 3624
good glTF2/BoxTextured-glTF/BoxTextured.gltf 12
good glTF2/BoxTextured-glTF-Binary/BoxTextured.glb 12
good glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf 12
good glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb 110327

fresh
for file in invalid/empty.obj invalid/malformed.obj invalid/malformed2.obj invalid/empty.ply \
    OBJ/point_cloud.obj OBJ/testline.obj OBJ/testpoints.obj OBJ/box_UTF16BE.obj PLY/points.ply PLY/issue623.ply \
    glTF2/IndexOutOfRange/IndexOutOfRange.gltf glTF2/IndexOutOfRange/AllIndicesOutOfRange.gltf \
    glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb glTF2/MissingBin/BoxTextured.gltf \
    glTF2/RecursiveNodes/RecursiveNodes.gltf glTF2/SchemaFailures/sceneWrongType.gltf \
    glTF2/TestNoRootNode/NoScene.gltf glTF2/TestNoRootNode/SceneWithoutNodes.gltf \
    glTF2/wrongTypes/badArray.gltf glTF2/wrongTypes/badNumber.gltf glTF2/wrongTypes/badObject.gltf \
    glTF2/wrongTypes/badString.gltf glTF2/wrongTypes/badUint.gltf glTF2/issue_3269/texcoord_crash.gltf; do
    bad "$file"
done

# cut short: the text formats in the middle of a word, the binary ones inside their data
fresh
cut_short() { head -c "$3" "$models/$1" >"$2" && bad "$2"; }
cut_short PLY/cube.ply header.ply 60 # the importer would look for the header's end for ever
cut_short PLY/cube_binary.ply data.ply 300
cut_short STL/Spider_binary.stl facets.stl 5000
cut_short STL/Spider_binary.stl start.stl 50
cut_short glTF2/BoxTextured-glTF-Binary/BoxTextured.glb data.glb 2000
cut_short glTF2/BoxTextured-glTF-Binary/BoxTextured.glb start.glb 10
cut_short glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf text.gltf 1000
for ending in obj ply stl gltf glb json glt; do
    : >nothing.$ending
    bad nothing.$ending
    head -c 3000 "$glint" >program.$ending
    bad program.$ending
done

# not files
fresh
for ending in obj ply stl gltf glb json glt; do
    mkfifo "pipe.$ending"
    run "a pipe ending in $ending is refused" 3 timeout 10 "$glint" pack "pipe.$ending" -o out.glt
    matches 'and called so' "$top/err" "^pipe.$ending: not a regular file"
done
echo '{"camera": {"focal": 9, "near": 1, "far": 2}, "meshes": {"m": {"file": "pipe.obj"}}}' >scene.json
run 'nor can a scene name one' 3 timeout 10 "$glint" pack scene.json -o out.glt
matches 'and it is the pipe that is named' "$top/err" '^pipe.obj: not a regular file'

# many triangles around one vertex, whose normals pair by pair would take a minute
awk 'BEGIN {
    for (n = 100000; i < n; i++) print "v", cos(6.2831853 * i / n), sin(6.2831853 * i / n), sin(i * i) / 3
    print "v 0 0 1"
    for (i = 1; i <= n; i++) print "f", n + 1, i, i % n + 1
}' >fan.obj
run 'a fan of 100000 triangles packs' 0 timeout 30 "$glint" pack fan.obj -o fan.glt

# blobs
fresh
run 'a scene packs' 0 "$glint" pack "$scenes/tiny.json" -o whole.glt
head -c 1000 whole.glt >short.glt
bad short.glt
matches 'a short blob is called so' "$top/err" 'cut short'
tr '\000' '\001' <whole.glt >changed.glt
bad changed.glt

# writing
run 'a full device is reported' 3 "$glint" pack "$scenes/tiny.json" -o /dev/full --output-format glt
run 'and for C' 3 "$glint" pack "$scenes/tiny.json" -o /dev/full --output-format c
run 'a missing folder is reported' 3 "$glint" pack "$scenes/tiny.json" -o no/such.glt
run 'a missing scene is reported' 3 "$glint" pack no.json -o out.glt
run 'a folder is no scene' 3 "$glint" pack "$scenes" -o out.glt
run 'an ending that says nothing is asked about' 2 "$glint" pack "$scenes/tiny.json" -o out.png
run 'a name that C has not is refused' 2 "$glint" pack "$scenes/tiny.json" -o out.c --name 3d
run 'nor one that it keeps for itself' 2 "$glint" pack "$scenes/tiny.json" -o out.c --name int
run 'info wants one file' 2 "$glint" info
run 'packed C compiles by itself' 0 sh -c "'$glint' pack '$scenes/tiny.json' -o tiny.c >/dev/null &&
    ${CC:-cc} -std=c11 -ffreestanding -pedantic -Wall -Wextra -Wmissing-declarations -Werror -c tiny.c -o tiny.o"
run 'under the name of a keyword too' 0 sh -c "'$glint' pack '$scenes/tiny.json' -o int.c >/dev/null &&
    ${CC:-cc} -std=c11 -pedantic -Wall -Wextra -Wmissing-declarations -Werror -c int.c -o int.o"
finish
