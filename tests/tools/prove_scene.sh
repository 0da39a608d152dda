#!/bin/sh
# SPDX-License-Identifier: MIT
# prove_scene.sh FOLDER: the contracts of scene_check(), by Frama-C's WP and cvc4. Fails if a goal is not proven that
# tests/proof/wp/scene_check.open does not name, and the lemmas of scene_check.smt2 do not show (as prove.py's do).
set -eu
folder=$1
proof=tests/proof/wp/scene_check
functions=in_range,position_ok,colour_ok,unit_ok,array_ok,square_ok,scene_at,scene_meshes,scene_materials,scene_powers
functions=$functions,scene_lights,scene_objects,scene_keys,scene_textures,check_header,check_camera,check_fog
functions=$functions,check_vertices,bend_ok,check_tangents,mapped,check_triangles,check_mesh,check_power,check_material
functions=$functions,check_texture,check_key,check_motion,check_object,check_light,scene_check
mkdir -p "$folder"
WHY3CONFIG="$folder/why3.conf"
export WHY3CONFIG
test -f "$WHY3CONFIG" || why3 -C "$WHY3CONFIG" config detect >/dev/null 2>&1
frama-c -machdep gcc_x86_32 -c11 "-cpp-extra-args=-Ifirmware -Ihal -I. '-D_Static_assert(...)='" "$proof.c" \
    -wp -wp-rte -wp-model Typed+Cast -wp-prover cvc4 -wp-timeout "${TIMEOUT:-20}" -wp-par 2 -wp-fct "$functions" \
    >"$folder/scene_check.log" 2>&1 || { tail -5 "$folder/scene_check.log"; exit 1; }
sed -n 's/.*Goal typed_cast_\([a-z0-9_]*\) : \(Unknown\|Timeout\|Failed\|Stepout\).*/\1/p' "$folder/scene_check.log" |
    sort >"$folder/scene_check.open"
lemmas=$(z3 -T:120 "$proof.smt2" | sort | uniq -c | tr -s ' ')
test "$lemmas" = " $(grep -c '^(check-sat)' "$proof.smt2") unsat" || { echo "FAIL proof scene_check: z3:$lemmas"; exit 1; }
source=$(tr -s ' \n' ' ' <"$(sed -n 's/^; source: //p' "$proof.smt2")")
sed -n 's/^; code: //p' "$proof.smt2" | while read -r code; do
    case $source in
    *"$code"*) ;;
    *) echo "FAIL proof scene_check: this code is not in its file: $code"; exit 1 ;;
    esac
done
sed -n 's/^; shows: //p' "$proof.smt2" | sort >"$folder/scene_check.shown"
comm -23 "$folder/scene_check.open" "$folder/scene_check.shown" >"$folder/scene_check.left"
mv "$folder/scene_check.left" "$folder/scene_check.open"
grep -v '^#' "$proof.open" | sort >"$folder/scene_check.known"
counts=$(sed -n 's/.*Proved goals: *\([0-9]*\) \/ \([0-9]*\)/\1 of \2 goals/p' "$folder/scene_check.log")
new=$(comm -23 "$folder/scene_check.open" "$folder/scene_check.known")
test -n "$counts" && test -z "$new" || { echo "FAIL proof scene_check: $counts; not proven:"; echo "$new"; exit 1; }
echo "ok proof scene_check: $counts; open: $(wc -l <"$folder/scene_check.open")"
