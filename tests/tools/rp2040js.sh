#!/bin/bash
# SPDX-License-Identifier: MIT
# rp2040js.sh FOLDER: installs the emulator into FOLDER/node_modules unless it is there; DEPS=manual only says how.
set -u
folder=$1
version=1.4.1
there() {
    grep -qs "\"version\": \"$version\"" "$folder/node_modules/rp2040js/package.json"
}
there && exit 0
command="npm install --prefix $folder --no-audit --no-fund --silent rp2040js@$version"
give_up() {
    echo "rp2040js: $1" >&2
    echo "install it with: $command (Node 18 or later), then run make again" >&2
    exit 1
}
[ "${DEPS-}" = manual ] && give_up "the RP2040 emulator is not there"
command -v npm >/dev/null || give_up "there is no npm (Debian: apt-get install nodejs npm)"
echo "+ $command" >&2
mkdir -p "$folder"
# npm 9 can fail to fetch and yet exit with 0.
$command >&2 && there || give_up "npm failed: no network, or no registry?"
