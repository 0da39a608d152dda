#!/bin/bash
# SPDX-License-Identifier: MIT
# check_core.sh CPU... -- SOURCE...: what the renderer's objects need and keep.
set -u
cpus=
while [ "$1" != -- ]; do
    cpus="$cpus $1"
    shift
done
shift
objects=$(printf ' %s' "${@%.c}" | sed 's/ \([^ ]*\)/ @\/\1.o/g')
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
arm="arm-none-eabi-"
status=0
verdict() { # name, complaints
    if [ -z "$2" ]; then
        echo "ok core: $1"
    else
        echo "FAIL core: $1"
        printf '%s\n' "$2" | head -20
        status=1
    fi
}

# What is left for libgcc: integer division, 64-bit product and shifts, leading zeros, jump tables of the M0+.
helpers='__aeabi_(u?idiv|u?idivmod|u?ldivmod|lmul|llsl|llsr|lasr|lcmp|ulcmp)|__(clz|ctz|popcount|ffs|bswap)[sd]i2|__gnu_thumb1_case_.*'
memory='(__aeabi_)?mem(cpy|move|set|cmp|clr)[48]?'
for cpu in $cpus; do
    files=${objects//@/$BUILD\/$cpu}
    # shellcheck disable=SC2086
    ${arm}nm $files | awk 'NF == 2 { print $2 }' | sort -u >"$work/wanted"
    # shellcheck disable=SC2086
    ${arm}nm --defined-only $files | awk 'NF == 3 && $2 ~ /[TRDBWVC]/ { print $3 }' | sort -u >"$work/defined"
    outside=$(comm -23 "$work/wanted" "$work/defined")
    # shellcheck disable=SC2086
    verdict "$cpu needs nothing but ($(echo $outside)): no float, allocation or stdio" \
        "$(echo "$outside" | grep -vxE "$helpers|$memory" | sed '/^$/d')"
    # shellcheck disable=SC2086
    verdict "$cpu has no static mutable state" "$(${arm}size -A $files | awk '
        / :$/ || /:$/ { file = $1 } /^\.(data|bss|tbss|tdata)/ && $2 > 0 { print file, $1, $2 " bytes" }')"
done

files=${objects//@/$BUILD\/m3}
provided=
# shellcheck disable=SC2086
if ! link=$(${arm}gcc -mcpu=cortex-m3 -mthumb -nostdlib -Wl,-e,glint_frame_begin $files -lgcc -o "$work/core.elf" 2>&1); then
    provided=$(echo "$link" | grep -oE "undefined reference to .mem[a-z]*" | grep -oE 'mem[a-z]*' | sort -u | tr '\n' ' ')
    link=$(${arm}gcc -mcpu=cortex-m3 -mthumb -nostdlib -Wl,-e,glint_frame_begin $files $BUILD/m3/hal/cortexm/mem.o -lgcc \
        -o "$work/core.elf" 2>&1) && link=
fi
verdict "links for Cortex-M3 with -nostdlib -lgcc alone${provided:+, given $provided}" "$link"

for compiler in gcc clang; do
    complaints=
    for source in "$@"; do
        complaints+=$($compiler -std=c11 -O2 -mgeneral-regs-only -ffreestanding -Wall -Wextra -Werror -Ifirmware -c "$source" \
            -o "$work/x.o" 2>&1)
    done
    verdict "compiles with $compiler -mgeneral-regs-only -ffreestanding -Wall -Wextra -Werror" "$complaints"
done
exit $status
