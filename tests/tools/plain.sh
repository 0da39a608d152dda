#!/bin/bash
# SPDX-License-Identifier: MIT
# plain.sh table|check QEMU CPU...: what effects cost a scene without them (tests/device/plain.c), in instructions of a frame
# and bytes of flash; check: that they cost a program compiled for it nothing, and one that has everything little.
set -u
mode=$1 qemu=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for cpu in "$@"; do
    for program in plain plain-without plain-all plain-behind; do
        image=$BUILD/$cpu/$program.elf
        flash=$(arm-none-eabi-size "$image" | awk 'NR == 2 { print $1 + $2 }')
        $qemu -icount shift=0 -kernel "$image" | sed "s/^/$cpu,$program,$flash,/" >>"$work/rows"
    done
    arm-none-eabi-objcopy -O binary "$BUILD/$cpu/plain.elf" "$work/a"
    arm-none-eabi-objcopy -O binary "$BUILD/$cpu/plain-without.elf" "$work/b"
    cmp -s "$work/a" "$work/b" && echo "$cpu,same" >>"$work/rows"
done
awk -F, -v mode="$mode" '
    NF == 2 { same[$1] = 1; next }
    !($1 in cpus) { cpus[$1] = ++count; cpu[count] = $1 }
    { flash[$1, $2] = $3; frame[$1, $2, $4, $5, $6] = $7 }
    function verdict(good, text) { printf "%s plain: %s\n", good ? "ok" : "FAIL", text; bad += !good }
    function share(value, base) { return base ? 100 * (value - base) / base : 1e9 }
    # of a program and scene, against those of another
    function more(c, program, scene, base, other, k) {
        return share(frame[c, program, scene, method[k], format[k]], frame[c, base, other, method[k], format[k]])
    }
    function row(c, name, program, scene, base, other,  k) {
        printf "  %-7s %-42s %7d", c, name, flash[c, program]
        for (k = 1; k <= 4; k++)
            printf " %9d %-7s", frame[c, program, scene, method[k], format[k]],
                base == "" ? "" : sprintf("%+.1f %%", more(c, program, scene, base, other, k))
        print ""
    }
    function most(c, program, scene, base, other,  k, worst, s) {
        worst = -1e9
        for (k = 1; k <= 4; k++) {
            s = more(c, program, scene, base, other, k)
            worst = s > worst ? s : worst
        }
        return worst
    }
    END {
        plain = "plain-torus288"; dome = "plain-dome"; behind = dome "-behind"
        split("gouraud gouraud x x", method, " "); split("rgb565 grey8 rgb565 grey8", format, " ")
        if (mode == "table") {
            print "scenes without texture, bump map and highlight, 240x240: flash, scenes included, and instructions a frame"
            printf "  %-7s %-42s %7s", "", "", "flash"
            for (k = 1; k <= 4; k++) printf " %17s", method[k] " " format[k]
            print ""
            for (i = 1; i <= count; i++) {
                row(cpu[i], plain ", compiled for it", "plain", plain)
                row(cpu[i], "  without the files of the effects", "plain-without", plain, "plain", plain)
                row(cpu[i], "  with everything", "plain-all", plain, "plain", plain)
                row(cpu[i], dome ", with everything", "plain-behind", dome)
                row(cpu[i], "  and a light behind all that is seen", "plain-behind", behind, "plain-behind", dome)
            }
            exit
        }
        for (i = 1; i <= count; i++) {
            c = cpu[i]
            verdict(same[c] && flash[c, "plain"] > 0 && most(c, "plain-without", plain, "plain", plain) == 0,
                sprintf("on %s a program for a scene without effects is the one that never had them: %d bytes", c, flash[c, "plain"]))
            worst = most(c, "plain-all", plain, "plain", plain)
            verdict(worst < EVERYTHING, sprintf("on %s a program with everything takes at most %.1f of %.1f %% more a frame", c, worst, EVERYTHING))
            worst = most(c, "plain-behind", behind, "plain-behind", dome)
            verdict(worst < BEHIND, sprintf("on %s a light that reaches nothing takes at most %.1f of %.1f %% more a frame", c, worst, BEHIND))
        }
        exit bad > 0
    }' EVERYTHING=4 BEHIND=3 "$work/rows"
