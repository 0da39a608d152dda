#!/bin/bash
# SPDX-License-Identifier: MIT
# Finds which Debian packages a target lacks, says so and installs them. `deps.sh demo|view|test|linux|prove`; DEPS=manual only prints
# the command and fails if something is missing.
set -u

demo="gcc pkg-config libc6-dev libpng-dev libjansson-dev libassimp-dev zlib1g-dev"
view="$demo libusb-1.0-0-dev libsdl2-dev"
test="$view xvfb xdotool libcmocka-dev clang clang-runtime clang-format clang-tidy cppcheck valgrind python3 gcc-arm-none-eabi qemu-system-arm
      gnuplot-nox assimp-testmodels nodejs npm gcc-arm-linux-gnueabihf libc6-dev-armhf-cross device-tree-compiler cpio"
# A Linux board's program is built on the board itself, or crosswise.
linux="$demo $(case $(uname -m) in arm* | aarch64) echo libgpiod-dev ;; *) echo gcc-arm-linux-gnueabihf libc6-dev-armhf-cross ;; esac)"
prove="gcc python3 frama-c-base why3 z3 cvc4 gappa"

# A tool that came by another way than apt serves as well; a library needs its package or its pkg-config file.
have() {
    case $1 in
    device-tree-compiler) command -v dtc ;;
    frama-c-base) command -v frama-c ;;
    gcc-arm-none-eabi) command -v arm-none-eabi-gcc && command -v arm-none-eabi-nm ;;
    nodejs) command -v node ;;
    gcc-arm-linux-gnueabihf) command -v arm-linux-gnueabihf-gcc ;;
    libc6-dev-armhf-cross) [ -e /usr/arm-linux-gnueabihf/include/stdio.h ] ;;
    libgpiod-dev) pkg-config --exists libgpiod ;;
    gnuplot-nox) command -v gnuplot ;;
    libpng-dev) pkg-config --exists libpng ;;
    libjansson-dev) pkg-config --exists jansson ;;
    libusb-1.0-0-dev) pkg-config --exists libusb-1.0 ;;
    libsdl2-dev) pkg-config --exists sdl2 ;;
    xvfb) command -v Xvfb ;;
    libassimp-dev) pkg-config --exists assimp ;;
    libcmocka-dev) pkg-config --exists cmocka ;;
    zlib1g-dev) pkg-config --exists zlib ;;
    libc6-dev) [ -e /usr/include/stdio.h ] ;;
    clang-runtime) [ -e "$(clang -print-file-name="libclang_rt.asan-$(uname -m).a")" ] ;;
    assimp-testmodels) [ -d /usr/share/assimp/models ] ;;
    *) command -v "$1" ;;
    esac >/dev/null 2>&1
}

# The sanitizers' package carries clang's version in its name.
name_of() {
    [ "$1" = clang-runtime ] || { echo "$1"; return; }
    major=$(apt-cache depends clang 2>/dev/null | sed -n 's/.*Depends: clang-\([0-9]*\)$/\1/p')
    echo "libclang-rt-${major:-14}-dev"
}

missing_of() {
    for package in "$@"; do
        have "$package" || printf ' %s' "$(name_of "$package")"
    done
}

case ${1-} in
demo) wanted=$demo ;;
view) wanted=$view ;;
test) wanted=$test ;;
linux) wanted=$linux ;;
prove) wanted=$prove ;;
*)
    echo "usage: deps.sh demo|view|test|linux|prove" >&2
    exit 2
    ;;
esac
# shellcheck disable=SC2086
look() { missing=$(missing_of $wanted); }
look
[ -z "$missing" ] && exit 0

root=
[ "$(id -u)" = 0 ] || root="sudo env DEBIAN_FRONTEND=noninteractive "
export DEBIAN_FRONTEND=noninteractive
command="${root}apt-get install -y --no-install-recommends"
echo "missing packages:$missing" >&2
if [ "${DEPS-}" = manual ]; then
    echo "install them with: $command$missing" >&2
    exit 1
fi
give_up() {
    echo "$1" >&2
    echo "install these packages by hand, then run make again:$missing" >&2
    exit 1
}
run() {
    echo "+ $*" >&2
    "$@" >&2
}
command -v apt-get >/dev/null || give_up "this system has no apt-get: the names are those of Debian"
[ -z "$root" ] || command -v sudo >/dev/null || give_up "not root, and there is no sudo"

# shellcheck disable=SC2086
install() { look && run $command $missing; }
update() { run ${root}apt-get update; }
if ! apt-cache show gcc >/dev/null 2>&1; then # no package lists yet
    update
    install || give_up "apt-get failed: no network, or no right to install?"
elif ! install; then
    update && install || give_up "apt-get failed: no network, or no right to install?"
fi
look
[ -z "$missing" ] || give_up "apt-get succeeded, and yet something is not found"
