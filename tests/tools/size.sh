#!/bin/bash
# SPDX-License-Identifier: MIT
# size.sh CPU...: flash (code and constants) and static RAM of the renderer by part, then the packed scenes.
set -u
for cpu in "$@"; do
    echo "$cpu"
    find "$BUILD/$cpu/firmware" -name '*.o' -exec arm-none-eabi-size {} + | awk -v root="$BUILD/$cpu/firmware/" '
        BEGIN { printf "  %-12s %8s %8s\n", "part", "flash", "RAM" }
        index($6, root) == 1 {
            part = substr($6, length(root) + 1)
            if (!sub(/\/.*/, "", part)) part = "frame"
            flash[part] += $1 + $2; ram[part] += $2 + $3; all += $1 + $2; all_ram += $2 + $3
        }
        END {
            count = split("fixed scene geometry plan shade raster stream frame", order, " ")
            for (i = 1; i <= count; i++)
                if (order[i] in flash) printf "  %-12s %8d %8d\n", order[i], flash[order[i]], ram[order[i]]
            printf "  %-12s %8d %8d\n", "in all", all, all_ram
        }'
done
printf '\nflash of a program that draws by one method, mem* and libgcc included\n'
tests/tools/flash.sh "$@" | awk -F, '
    NR == 1 { next }
    !($1 in cpus) { cpus[$1] = 1; cpu[++columns] = $1 }
    !($2 in methods) { methods[$2] = 1; method[++rows] = $2 }
    { bytes[$1, $2] = $3 }
    END {
        printf "  %-24s", ""
        for (c = 1; c <= columns; c++) printf " %8s", cpu[c]
        for (r = 1; r <= rows; r++) {
            printf "\n  %-24s", method[r]
            for (c = 1; c <= columns; c++) printf " %8d", bytes[cpu[c], method[r]]
        }
        print ""
    }'

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf '\nbytes taken of the memory given, 32-bit CPU\n'
record() { # name expression
    echo "#include \"list.h\"
        #include \"raster/raster.h\"
        char bytes[$2];" >"$work/record.c"
    arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb -std=c11 -Ifirmware -ffreestanding -c "$work/record.c" -o "$work/record.o"
    printf '  %-34s %8d\n' "$1" "0x$(arm-none-eabi-nm -S "$work/record.o" | awk '$4 == "bytes" { print $2 }')"
}
record "a vertex under one light" "2 * (VERTEX_LIGHTS + 2)"
record "a listed triangle, with its order" "sizeof(struct triangle_ref) + 2"
record "a piece made by clipping" "sizeof(struct clipped_triangle)"
record "the set-up of the triangle in hand" "sizeof(struct shade_setup)"
record "working state, set-up included" "sizeof(struct raster)"
record "an object" "sizeof(struct object_state)"
record "a colour table" "sizeof(struct colour_table)"
echo
echo "scenes"
find "$BUILD/m3" -path '*/scenes/*.o' -exec arm-none-eabi-size {} + | awk 'NR > 1 && $6 !~ /_list/ {
    name = $6; sub(/.*\//, "", name); sub(/\.o$/, "", name); printf "  %-20s %8d\n", name, $1 + $2 }'
