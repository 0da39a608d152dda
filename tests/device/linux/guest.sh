#!/bin/bash
# SPDX-License-Identifier: MIT
# guest.sh DEBIAN VERSION OUT BOARD PROGRAM...: an emulated handheld's OUT/initrd.gz and OUT/guest.dtb, of what fetch.sh left
# in DEBIAN: busybox, the C library of the cross compiler, libgpiod VERSION (v1 or v2), glint-view's libraries, the modules of
# a USB that is all inside (start_usb loads them), the programs in /bin, and the board's file. Its console takes a line of shell
# at a time, and ends what the line printed with \036 and its status (guest.py is the other side).
set -eu
debian=$1 version=$2 out=$3 board=$4
shift 4
root=$out/root
rm -rf "$root"
mkdir -p "$root"/{bin,lib,proc,sys,dev,tmp,etc/glint,modules}
cp "$debian/busybox" "$root/bin/"
for program in "$@"; do
    name=$(basename "$program")
    cp "$program" "$root/bin/${name%-"$version"}"
done
cp "$board" "$root/etc/glint/board.conf"
for library in ld-linux-armhf.so.3 libc.so.6 libm.so.6 libpthread.so.0; do
    cp -L "$(arm-linux-gnueabihf-gcc -print-file-name=$library)" "$root/lib/"
done
cp -a "$debian/$version"/usr/lib/arm-linux-gnueabihf/libgpiod.so.* "$root/lib/"
find "$debian/view" -name 'lib*.so.*' -exec cp -a {} "$root/lib/" \;
cp "$debian"/modules/*.ko "$root/modules/"
echo 'root:x:0:0:root:/:/bin/sh
nobody:x:65534:65534:nobody:/:/bin/sh' >"$root/etc/passwd"
cat >"$root/bin/start_usb" <<'USB'
#!/bin/sh
# start_usb [OPTION OF dummy_hcd...]: a USB host, and a device's end at it
for module in configfs udc-core usbcore "dummy_hcd $*" libcomposite usb_f_fs; do
    name=${module%% *}
    insmod "/modules/$name.ko" ${module#"$name"} || exit
done
mount -t configfs c /sys/kernel/config
USB
cat >"$root/init" <<'INIT'
#!/bin/busybox sh
/bin/busybox --install -s /bin
export PATH=/bin HOME=/tmp
mount -t proc p /proc
mount -t sysfs s /sys
mount -t debugfs d /sys/kernel/debug
mount -t devtmpfs d /dev
stty -echo -onlcr
printf '\0360\n'
while read -r line; do
    eval "$line" </dev/null 2>&1
    printf '\036%d\n' $?
done
poweroff -f
INIT
chmod 755 "$root/init" "$root/bin/start_usb"
(cd "$root" && find . | cpio --quiet -o -H newc | gzip -1) >"$out/initrd.gz"
rm -rf "$root"

qemu-system-arm -M "virt,dumpdtb=$out/virt.dtb" -cpu cortex-a7 -m 256 -nodefaults -display none 2>/dev/null
{
    dtc -q -I dtb -O dts "$out/virt.dtb"
    cat "$(dirname "$0")/handheld.dtsi"
} | dtc -q -I dts -O dtb -o "$out/guest.dtb"
