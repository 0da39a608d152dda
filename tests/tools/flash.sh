#!/bin/bash
# SPDX-License-Identifier: MIT
# flash.sh CPU...: flash of a program that draws the report's scenes by one method, mem* and libgcc included, from the
# objects in $BUILD. A CSV line a CPU and method of firmware/methods.c, of those that `glint pack --uses` found of use.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
methods=$(tr '\n' ' ' <firmware/methods.c | grep -oE '\{"[^"]+", *&glint_[a-z0-9_]+\}' | sed -E 's/\{"(.*)", *&(.*)\}/\1 \2/')
[ -n "$methods" ] || { echo "flash.sh: no method is found in firmware/methods.c" >&2; exit 1; }

echo cpu,method,bytes
for cpu in "$@"; do
    case $cpu in m0plus) flags=-mcpu=cortex-m0plus ;; *) flags=-mcpu=cortex-$cpu ;; esac
    objects_of=$BUILD/$cpu-report
    mapfile -t objects < <(find "$objects_of/firmware" -name '*.o')
    of_use=$(sed -n 's|^/\* methods:\(.*\) \*/$|\1 |p' "$objects_of/uses.h")
    while read -r name symbol; do
        [[ -z $of_use || $of_use == *" $name "* ]] || continue
        echo "#include \"glint.h\"
            int entry(struct glint_frame *f, struct glint_config *c, const void *scene, struct glint_band *b);
            int entry(struct glint_frame *f, struct glint_config *c, const void *scene, struct glint_band *b)
            {
                c->method = &$symbol;
                glint_fit_stores(c, scene);
                return glint_scene_check(scene, 1) + glint_init(f, c) + glint_frame_begin(f, scene, 0) +
                       glint_frame_next_band(f, b);
            }" >"$work/entry.c"
        arm-none-eabi-gcc "$flags" -mthumb -std=c11 -Os -Ifirmware -ffreestanding -include "$objects_of/uses.h" -nostdlib -Wl,-e,entry,--gc-sections \
            "$work/entry.c" "${objects[@]}" "$objects_of/hal/cortexm/mem.o" "$objects_of/hal/cortexm/divide.o" -lgcc -o "$work/entry.elf"
        echo "$cpu,$name,$(arm-none-eabi-size "$work/entry.elf" | awk 'NR == 2 { print $1 + $2 }')"
    done <<<"$methods"
done
