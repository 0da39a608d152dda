#!/bin/bash
# SPDX-License-Identifier: MIT
# test_flash_lm3s.sh: hal/lm3s/flash.sh with an OpenOCD that finds a board, finds none, or is not there.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0
image=$folder/app.elf
touch "$image"
mkdir "$folder/none" "$folder/tools"
for tool in bash sed paste tail grep; do ln -s "$(command -v $tool)" "$folder/none/$tool"; done
cat >"$folder/tools/openocd" <<'END'
#!/bin/bash
printf '%s\n' "$@" >>"$0.calls"
[ -e "$0.board" ] && exit 0
printf 'Info : something\nError: no device found\n** OpenOCD init failed **\n' >&2
exit 1
END
chmod +x "$folder/tools/openocd"

# NAME, wanted status, wanted text in what it says, then the command
check() {
    local name=$1 wanted=$2 text=$3 said code
    shift 3
    said=$("$@" 2>&1)
    code=$?
    if [ $code -eq "$wanted" ] && [[ $said == *"$text"* ]] && [ "$(wc -l <<<"$said")" -le 2 ]; then
        echo "ok flash: $name"
    else
        echo "FAIL flash: $name: status $code, '$said'"
        status=1
    fi
}
flash() { PATH=$folder/tools:$PATH hal/lm3s/flash.sh "$@"; }
without() { PATH=$folder/none hal/lm3s/flash.sh "$@"; }

check "without an image it says how" 2 "usage: flash.sh IMAGE.elf" flash
check "without OpenOCD it names the package" 3 "apt-get install openocd" without "$image"
check "a dry run needs none" 0 "+ openocd -f board/ek-lm3s6965.cfg -c 'program {$image} verify reset exit'" \
    env DRY_RUN=1 PATH="$folder/none" hal/lm3s/flash.sh "$image"
check "without a board it says so" 3 "no board: no device found;" flash "$image"
check "nor on a probe" 3 "no board on the probe jlink: no device found;" env PROBE=jlink PATH="$folder/tools:$PATH" hal/lm3s/flash.sh "$image"
rm "$folder/tools/openocd.calls"
touch "$folder/tools/openocd.board"
check "with one it writes" 0 "+ openocd" flash "$image"
check "through a probe too" 0 "-f interface/cmsis-dap.cfg -c 'transport select swd' -f target/stellaris.cfg" \
    env PROBE=cmsis-dap PATH="$folder/tools:$PATH" hal/lm3s/flash.sh "$image"
check "it was told what to write" 0 "2" grep -cxF "program {$image} verify reset exit" "$folder/tools/openocd.calls"
exit $status
