#!/bin/bash
# SPDX-License-Identifier: MIT
# bench_setup.sh COUNT INTEGERS REAL CPU=CSV...: the set-ups of the papers' tables, by operations, by instructions of the
# boards (the CSV files) and of the host (callgrind), and by this machine's time, beside the papers' own seconds.
set -eu
count=$1 integers=$2 real=$3
shift 3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Rows `cpu,name,instructions a set-up`, the loop taken off; 1024 triangles.
each() { # cpu, the row that does nothing; rows `name,instructions` on standard input
    awk -F, -v cpu="$1" -v nothing="$2" '
        $1 == nothing { base = $2; next }
        { printf "%s,%s,%.1f\n", cpu, $1, ($2 - base) / 1024 }'
}
collected() { # program, names
    local program=$1 name
    shift
    for name in "$@"; do
        printf '%s,' "$name"
        valgrind --tool=callgrind --toggle-collect='bench_run*' --callgrind-out-file=/dev/null "$program" "$name" 2>&1 |
            awk '/Collected :/ { print $4 }'
    done
}
"$count" >"$work/count"
"$real" >"$work/time"
names=$(cut -d, -f1 "$work/count" | grep -v -- '-[12]$')
steps=$(cut -d, -f1 "$work/count" | grep -- '-[12]$')
# shellcheck disable=SC2086
{
    for board in "$@"; do
        each "${board%%=*}" nothing <"${board#*=}"
    done
    collected "$integers" nothing place $names renderer | each host nothing
    collected "$real" nothing $names | each double nothing
    collected "$real" steps-nothing $steps | each double steps-nothing
    sed 's/^/time,/' "$work/time"
} >"$work/rows"
cp "$work/rows" "$BUILD/bench/setup.csv"

awk -F, '
    FILENAME ~ /count$/ { for (i = 2; i <= 9; i++) ops[$1, i] = $i; next }
    { cost[$1, $2] = $3 }
    function cell(cpu, name, against) {
        if (!((cpu, name) in cost)) return sprintf("  %13s", "")
        return sprintf("  %6.1f (%4.2f)", cost[cpu, name], cost[cpu, name] / cost[cpu, against])
    }
    function counts(name) {
        return sprintf("  %4d %4d %3d %3d", ops[name, 2], ops[name, 3], ops[name, 4], ops[name, 5])
    }
    END {
        n = split("lee-jen abbas abbas-safe seiler hast x x-k x-products place renderer", name, " ")
        split("Lee and Jen|Abbas, as printed|Abbas, safe|Seiler, reconstructed|Hast, ortho-normalised|X|X, k from the mesh|X, k, products first|the triangle'"'"'s place|the renderer'"'"'s own", title, "|")
        columns = split("m0plus m3 m4 host double", cpu, " ")
        split("Cortex-M0+|Cortex-M3|Cortex-M4|x86-64|x86-64 in double", cpu_title, "|")
        seconds["lee-jen"] = 40.6; seconds["abbas"] = 42.0; seconds["seiler"] = 49.4; seconds["hast"] = 40.3; seconds["x"] = 12.7

        print "From a triangle'"'"'s corners, normals and light to the coefficients on the screen (tests/setups/README.md)."
        print ""
        print "Operations, by running the formulas on numbers that count, and instructions a set-up; in brackets times X."
        print "Then seconds for 10^8 set-ups: in double on this machine, and of X'"'"'s Table 1 (1.8 GHz Pentium 4)."
        print ""
        printf "%-23s  %-18s %-15s %-15s %-15s %-15s %-15s %-15s %s\n", "", "   +    *   /   v", "  Cortex-M0+", "  Cortex-M3", "  Cortex-M4", "  x86-64", "  x86-64 double", "  time, double", "   Table 1"
        for (i = 1; i <= n; i++) {
            line = sprintf("%-23s", title[i])
            line = line ((name[i], 2) in ops ? counts(name[i]) : sprintf("  %18s", ""))
            for (k = 1; k <= columns; k++) line = line cell(cpu[k], name[i], "x")
            if (("time", name[i]) in cost)
                line = line sprintf("  %6.2f (%4.2f)", cost["time", name[i]] / 10, cost["time", name[i]] / cost["time", "x"])
            if (name[i] in seconds) line = line sprintf("    %4.1f (%4.2f)", seconds[name[i]], seconds[name[i]] / seconds["x"])
            print line
        }
        printf "\nAbbas as printed, from the six samples on: %d additions, %d multiplications, %d divisions; the paper says 25, 51, 5.\n",
            ops["abbas", 6], ops["abbas", 7], ops["abbas", 8]
        print "The renderer has N.L from its vertices, and adds the step to a pixel'"'"'s centre. The place is in every row."

        print "\nX says of itself: about three times faster than previous approaches. Confirmed where all four of them take 2.5 times X"
        print "and more; then what the faster of Lee-Jen and Hast takes of X with k from the mesh and products first:"
        previous = split("lee-jen abbas seiler hast", old, " ")
        split("Lee-Jen Abbas Seiler Hast", short, " ")
        cpu[++columns] = "time"; cpu_title[columns] = "time, double"
        for (k = 1; k <= columns; k++) {
            low = 1e9; each = ""
            for (i = 1; i <= previous; i++) {
                r = cost[cpu[k], old[i]] / cost[cpu[k], "x"]
                if (r < low) low = r
                each = each sprintf("%s %s %.2f", i > 1 ? "," : "", short[i], r)
            }
            best = cost[cpu[k], "lee-jen"]
            if (cost[cpu[k], "hast"] < best) best = cost[cpu[k], "hast"]
            printf "  %-17s %s:%s times X; %.2f\n", cpu_title[k],
                (low >= 2.5 ? "confirmed" : "refuted"), each, best / cost[cpu[k], "x-products"]
        }

        print "What X saves is 3 roots, 3 divisions and 11 additions of the samples; to the screen all go much the same way. In integers a"
        print "root and a reciprocal are a small table and a few products, in double one instruction each, so there is less to save."
        print "Abbas as printed needs numbers with exponents in integers: its denominators are of the sixth degree."

        print "\nThe increments of a quadratic denominator, for one left edge and for two, from the actual triangle and from the"
        print "ortho-normalised one (Hast, Barrera and Bengtsson 2002, Table 1); in brackets actual over ortho-normalised:"
        print ""
        printf "%-33s %-18s %-18s %-18s %s\n", "", "    +    *   /   v", "  x86-64, double", "  time, 10^8", "  Table 1"
        split("actual-1 ortho-1 actual-2 ortho-2", way, " ")
        split("one edge, actual|one edge, ortho-normalised|two edges, actual|two edges, ortho-normalised", way_title, "|")
        split("24.7 16.1 26.2 16.4", paper, " ")
        for (i = 1; i <= 4; i++) {
            s = way[i]; o = way[i + i % 2]
            printf "%-33s%s  %6.1f (%4.2f)     %6.2f (%4.2f)     %4.1f (%4.2f)\n", way_title[i], counts(s), cost["double", s],
                cost["double", s] / cost["double", o], cost["time", s] / 10, cost["time", s] / cost["time", o], paper[i], paper[i] / paper[i + i % 2]
        }
    }' "$work/count" "$work/rows"
echo
echo "rows: $BUILD/bench/setup.csv"
