#!/bin/bash
# SPDX-License-Identifier: MIT
# profile.sh QEMU IMAGE SCENE METHOD BANDS TABLES FRAME: instructions of one frame (1: the first, 2: the one after) by
# function, counted by letting QEMU log every instruction. LINES=1: by source line too, those that inlining brought
# included; ARGUMENTS: more for the
# program, as "grey8 budget=8"; FUNCTION=name: that function's disassembly with a count beside each instruction.
set -eu
qemu=$1 image=$2 scene=$3 method=$4 bands=$5 tables=$6 frame=$7
arm="arm-none-eabi-"
out=$BUILD/bench/profile
mkdir -p "$BUILD/bench"
symbol() { ${arm}nm -S "$image" | awk -v name="$1" '$4 == name { print $1, $2 }'; }
read -r begin _ <<<"$(symbol bench_frame)"
read -r main size <<<"$(symbol program_main)"
main_end=$(printf '%08x' $((0x$main + 0x$size)))

# A line is `Trace 0: <host address> [<flags>/<pc>/...] <symbol>`. bench_frame() is entered at its first instruction and
# left when program_main() goes on.
# shellcheck disable=SC2086
$qemu "$image" -append "$scene $method $bands $tables $frame ${ARGUMENTS-}" -singlestep -d exec,nochain -D /dev/stderr 2>&1 >/dev/null |
    awk -F / -v begin="$begin" -v main="$main" -v main_end="$main_end" -v frame="$frame" '
        { pc = "@" $2 } # never a number: 000012e4 would be one
        pc == "@" begin { inside = ++entered == frame }
        inside && pc >= "@" main && pc < "@" main_end { inside = 0 }
        inside && /^Trace/ { count[$2]++ } # not "Stopped execution", which -icount brings
        END { for (pc in count) print pc, count[pc] }' | sort >"$out.pc"
[ -s "$out.pc" ] || { echo "profile: nothing was counted" >&2; exit 1; }

${arm}nm -n "$image" | awk '$2 ~ /[tTwW]/ { print $1, $3 }' | sort -k1,1 >"$out.symbols"
awk 'NR == FNR { address[++n] = $1; name[n] = $2; next }
     { while (i < n && address[i + 1] "" <= $1 "") i++; sum[name[i]] += $2; all += $2 }
     END { for (f in sum) printf "%10d %5.1f %%  %s\n", sum[f], 100 * sum[f] / all, f
           printf "%10d 100.0 %%  in all\n", all }' "$out.symbols" "$out.pc" | sort -rn

if [ -n "${LINES-}" ] && [ "${LINES-}" = 1 ]; then
    echo
    cut -d ' ' -f 1 "$out.pc" | ${arm}addr2line -e "$image" | sed "s|^$PWD/||" | paste -d ' ' - "$out.pc" |
        awk '{ sub(/ \(disc.*\)/, ""); sum[$1] += $NF } END { for (l in sum) printf "%10d  %s\n", sum[l], l }' | sort -rn | head -40
fi
if [ -n "${FUNCTION-}" ]; then
    ${arm}objdump -d --no-show-raw-insn --disassemble="$FUNCTION" "$image" |
        awk 'NR == FNR { sub(/^0+/, "", $1); count[$1] = $2; next }
             /^ *[0-9a-f]+:/ { a = $1; sub(/:/, "", a); printf "%10s %s\n", count[a], $0 }' "$out.pc" -
fi
