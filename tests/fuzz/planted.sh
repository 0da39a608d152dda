#!/bin/bash
# SPDX-License-Identifier: MIT
# planted.sh FOLDER LIBRARIES...: whether the corpus sees faults, each planted by one sed into a copy of a source that goes into the
# target in place of the library's. COMPILE is how, FLAGS_<target> and PART_<target> what that takes besides.
set -u
folder=$1
shift
status=0
mkdir -p "$folder"
planted() { # what, target, source, sed
    local flags=FLAGS_$2 part=PART_$2
    sed "$4" "$3" >"$folder/planted.c"
    if cmp -s "$3" "$folder/planted.c"; then
        echo "FAIL planted $1: $3 is as it was"
        status=1
        return
    fi
    $COMPILE ${!flags-} "tests/fuzz/$2.c" tests/fuzz/replay.c ${!part-} "$folder/planted.c" "${@:5}" "${libraries[@]}" -o "$folder/$2" || exit 1
    if "$folder/$2" "tests/fuzz/corpus/$2" >"$folder/planted.log" 2>&1; then
        echo "FAIL planted $1: $2 takes its inputs nevertheless"
        status=1
    else
        echo "ok planted $1: $2 fails on $(grep -c '^FAIL' "$folder/planted.log"): $(
            grep -m 1 -oE '(broken: |ERROR: |runtime error: ).*' "$folder/planted.log" | cut -c1-90)"
    fi
}
libraries=("$@")
for target in fuzz_scene fuzz_mesh fuzz_json fuzz_picture fuzz_settings; do # before any fault
    "${folder%/planted}/$target" "tests/fuzz/corpus/$target" || exit 1
done

planted "a corner one too far" fuzz_scene firmware/scene/scene_check.c 's/corner\[k\] >= mesh->vertex_count/corner[k] > mesh->vertex_count/'
planted "a material one too far" fuzz_scene firmware/scene/scene_check.c 's/t->material >= s->material_count/t->material > s->material_count/'
planted "keys beyond the last" fuzz_scene firmware/scene/scene_check.c 's/m->key_count > s->key_count - m->first_key/m->key_count > s->key_count/'
planted "a mesh that is not there" fuzz_scene firmware/scene/scene_check.c 's/o->mesh >= s->mesh_count/o->mesh > s->mesh_count/'
planted "a texture one too far" fuzz_scene firmware/scene/scene_check.c 's/m->texture >= s->texture_count/m->texture > s->texture_count/'
planted "a bump map as a texture" fuzz_scene firmware/scene/scene_check.c 's/format == TEXTURE_BUMP8) ||/format == TEXTURE_FORMATS) ||/'
planted "an array four bytes too long" fuzz_scene firmware/scene/scene_check.c 's/element <= s->length - offset/element <= s->length - offset + 4/'
planted "an array over the header" fuzz_scene firmware/scene/scene_check.c 's/offset >= sizeof \*s/offset >= sizeof *s - 4/'
planted "an index of a palette" fuzz_scene firmware/scene/scene_check.c 's/index\[i\] >= t->colours/index[i] > t->colours/'
planted "nine lights" fuzz_scene firmware/scene/scene_check.c 's/s->light_count > SCENE_MAX_LIGHTS/s->light_count > 255/'
planted "keys at one time" fuzz_scene firmware/scene/scene_check.c 's/time_ms >= key\[i\]/time_ms > key[i]/'
planted "a normal of any length" fuzz_scene firmware/scene/scene_check.c 's/if (!square_ok(length))/if (0)/'
planted "a bend of any size" fuzz_scene firmware/scene/scene_check.c 's/bend - expected < 32/1/'
planted "fog that ends where it begins" fuzz_scene firmware/scene/scene_check.c 's/f->from < f->to/f->from <= f->to/'
planted "an effect that is not told" fuzz_scene firmware/scene/scene_effects.c 's/MOTION_SPIN ? USES_SPIN/MOTION_SPIN ? 0/'
planted "a contrast without the other end" fuzz_scene firmware/scene/texel.c 's/TEXTURE_CLAMP_V ? v : 0/TEXTURE_CLAMP_V ? v : v/'

planted "a corner one beyond the vertices" fuzz_mesh host-tools/import/importer.c 's/mIndices\[k\] >= in->mNumVertices/mIndices[k] > in->mNumVertices/'
planted "a material that is not there" fuzz_mesh host-tools/import/importer.c 's/mMaterialIndex >= scene->mNumMaterials/mMaterialIndex > scene->mNumMaterials/'
planted "a place that is not finite" fuzz_mesh host-tools/import/importer.c 's/fabsf(p->y) < MOST_POSITION/!(fabsf(p->y) >= MOST_POSITION)/'
planted "words of a file as they are" fuzz_mesh host-tools/import/importer.c 's/return make_legible(model_copy(path.data))/return model_copy(path.data)/'

planted "a choice that there is not" fuzz_json host-tools/scene/node.c 's/return index < 0 ? 0 : index;/return index;/'
planted "a number out of range" fuzz_json host-tools/scene/node.c 's/!(value >= least \&\& value <= most)/!(value >= least)/'
planted "names as they are" fuzz_json host-tools/scene/node.c 's/!are_legible(file->root)/0/'
planted "a tree that is not given back" fuzz_json host-tools/scene/node.c 's/json_decref(file->root)/(void)0/'
planted "a message too many" fuzz_json host-tools/scene/node.c 's/if (node->file->failed)$/if (0)/'
planted "an index that is not there" fuzz_json host-tools/scene/reader_points.c 's/(unsigned)end - 1, NAN/(unsigned)end, NAN/'
planted "a path one byte too short" fuzz_json host-tools/scene/reader_texture.c 's/folder + strlen(name) + 1)/folder + strlen(name))/'
planted "a picture taken by its name" fuzz_json host-tools/scene/picture.c 's/model->textures\[i\].is_file \&\& //'

planted "a row too few" fuzz_picture host-tools/compare/image.c 's/image->rgb = malloc(row \* image->height)/image->rgb = malloc(row * (image->height - 1))/'
planted "rows that are not given back" fuzz_picture host-tools/compare/image.c 's/free(reader.rows);//'
planted "half a picture" fuzz_picture host-tools/compare/image.c 's/if (!done)$/if (0)/'
planted "a picture of any size" fuzz_picture host-tools/compare/image.c 's/png_set_user_limits(png, IMAGE_MAX_SIZE, IMAGE_MAX_SIZE)/(void)0/'

planted "a division by nothing" fuzz_settings boards/linux/values.c 's/ \&\& scale <= unit; digit++/; digit++/'
planted "a frequency of 0" fuzz_settings boards/linux/values.c 's/hertz < 1 ||/0 ||/'
planted "a line without a name" fuzz_settings boards/linux/values.c 's/if (!\*line)$/if (0)/'
planted "a panel one row larger" fuzz_settings boards/linux/settings.c 's/offset_y + settings->height > controller->rows/offset_y + settings->height > controller->rows + 1/'
exit $status
