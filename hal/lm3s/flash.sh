#!/bin/bash
# SPDX-License-Identifier: MIT
# flash.sh IMAGE.elf: writes an image to the board by OpenOCD: through the debugger that is on it, or by SWD through
# PROBE, a name of OpenOCD's interface/ scripts (cmsis-dap, stlink, jlink). DRY_RUN=1 only says what would be done. Exit 2:
# bad usage, 3: no OpenOCD, no board, or it failed.
set -u
[ $# -eq 1 ] && [ -r "$1" ] || {
    echo "usage: flash.sh IMAGE.elf" >&2
    exit 2
}
probe=${PROBE-}
if [ -n "$probe" ]; then
    transport=swd
    [ "$probe" = stlink ] && transport=hla_swd
    command=(openocd -f "interface/$probe.cfg" -c "transport select $transport" -f target/stellaris.cfg)
else
    command=(openocd -f board/ek-lm3s6965.cfg)
fi
command+=(-c "program {$1} verify reset exit")

line=+
for word in "${command[@]}"; do
    case $word in *' '*) line+=" '$word'" ;; *) line+=" $word" ;; esac
done
echo "$line"
[ "${DRY_RUN-0}" = 1 ] && exit 0
command -v openocd >/dev/null || {
    echo "there is no openocd (Debian: apt-get install openocd)" >&2
    exit 3
}
log=$("${command[@]}" 2>&1) && exit 0
reason=$(sed -n 's/.*Error: //p' <<<"$log" | paste -sd ';' | sed 's/;/; /g')
if grep -q 'init failed' <<<"$log"; then
    echo "no board${probe:+ on the probe $probe}: ${reason:-openocd found none}; is it plugged in, with a driver's rights?" >&2
else
    echo "openocd failed: ${reason:-$(tail -1 <<<"$log")}" >&2
fi
exit 3
