#!/bin/bash
# SPDX-License-Identifier: MIT
# fetch.sh FOLDER: what an armhf Linux needs, from Debian, unpacked into FOLDER and not installed:
#     v1/ v2/           libgpiod 1.6 and 2.x: header, library, pkg-config file
#     view/             what glint-view links: libpng, zlib, libusb and its libudev; headers, libraries
#     kernel busybox    Debian's armmp kernel and a static shell
#     modules/          of that kernel: a USB host and a device joined without wires
# apt works with a configuration of its own: the machine's package lists, architectures and cache stay as they are; only
# the address of its Debian mirror is read. What is there is not fetched again, but all of it if a folder of before lacks
# something; DEPS=manual fetches nothing.
set -u
[ $# = 1 ] || { echo "usage: fetch.sh FOLDER" >&2; exit 2; }
mkdir -p "$1" && folder=$(cd "$1" && pwd) || exit 3
view="libpng16-16 libpng-dev zlib1g zlib1g-dev libusb-1.0-0 libusb-1.0-0-dev libudev1"
modules="configfs udc-core usbcore dummy_hcd libcomposite usb_f_fs"
contents="v1 v2 kernel busybox $view $modules"
if [ -e "$folder/complete" ] && [ "$(cat "$folder/complete")" = "$contents" ]; then
    touch "$folder/complete"
    exit 0
fi

give_up() {
    echo "fetch.sh: $1; an emulated Linux handheld needs Debian's armhf kernel and libgpiod in $folder" >&2
    exit 3
}
[ "${DEPS-}" = manual ] && give_up "not there, and DEPS=manual"
for tool in apt-get apt-cache dpkg-deb; do
    command -v $tool >/dev/null || give_up "this system has no $tool"
done
keys=/usr/share/keyrings/debian-archive-keyring.gpg
[ -e $keys ] || give_up "no Debian keyring (package debian-archive-keyring)"
mirror=$(apt-get indextargets --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
    awk '$1 ~ /^(bullseye|bookworm|trixie|forky|sid|stable|oldstable|testing|unstable)$/ && $2 == "main" { print $3; exit }')
[ -n "$mirror" ] || give_up "apt has no source of Debian's own packages to take the address from"

apt=$folder/apt
mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial" "$apt/packages"
: >"$apt/status"
for suite in bookworm bookworm-backports; do
    echo "deb [arch=armhf signed-by=$keys] $mirror $suite main"
done >"$apt/sources.list"
cat >"$apt/apt.conf" <<CONF
APT::Architecture "armhf";
APT::Architectures "armhf";
Dir::Etc::sourcelist "$apt/sources.list";
Dir::Etc::sourceparts "-";
Dir::State::Lists "$apt/lists";
Dir::State::status "$apt/status";
Dir::Cache "$apt/cache";
APT::Sandbox::User "root";
CONF
export APT_CONFIG=$apt/apt.conf

echo "fetching Debian's armhf kernel, busybox, libgpiod 1.6 and 2, libusb and libpng (49 MB) into $folder; nothing is installed" >&2
apt-get -qq -oAPT::Update::Error-Mode=any update >&2 || give_up "apt could not read the mirror's armhf lists"
# The metapackage names the kernel of today.
kernel=$(apt-cache depends linux-image-armmp/bookworm | awk '$1 == "Depends:" && $2 ~ /^linux-image/ { print $2; exit }')
[ -n "$kernel" ] || give_up "the mirror has no armhf kernel"
# shellcheck disable=SC2086
(cd "$apt/packages" && rm -f ./*.deb && apt-get -qq download "$kernel" busybox-static/bookworm libgpiod2/bookworm \
    libgpiod-dev/bookworm libgpiod3/bookworm-backports libgpiod-dev/bookworm-backports ${view// //bookworm }/bookworm >&2) ||
    give_up "apt could not download"

cd "$apt/packages" || exit 3
unpack() { # file or folder to be, packages
    rm -rf "${folder:?}/$1"
    mkdir -p "$folder/$1"
    for package in "${@:2}"; do
        dpkg-deb -x "$package" "$folder/$1" || give_up "$package cannot be unpacked"
    done
}
unpack v1 libgpiod2_* libgpiod-dev_1*
unpack v2 libgpiod3_* libgpiod-dev_2*
# shellcheck disable=SC2046
unpack view $(for package in $view; do echo "${package}_"*; done)
one_file() { # name to be, package, path in it
    dpkg-deb --fsys-tarfile "$2" | tar -x -C "$folder" --wildcards --transform "s:.*:$1:" "$3" || give_up "$2 has no $3"
}
one_file kernel "$kernel"_* './boot/vmlinuz*'
one_file busybox busybox-static_* '*/bin/busybox'
rm -rf "$folder/modules"
mkdir -p "$folder/modules"
for module in $modules; do
    one_file "modules/$module.ko" "$kernel"_* "*/$module.ko"
done
rm -rf "$apt"
echo "$contents" >"$folder/complete"
