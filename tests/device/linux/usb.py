# SPDX-License-Identifier: MIT
"""glint-device as a USB device and glint-view at its host, both on the emulated handheld: FunctionFS, dummy_hcd and libusb
between them are real. What the viewer traces is compared with the host's pictures by their CRC-32."""
import re
import subprocess

GADGET = "/sys/kernel/config/usb_gadget"
TRACE = re.compile(r"(?:(?P<stamp>\d+) )?(?P<number>\d+): (?P<size>\d+x\d+) (?P<format>\w+)(?P<key>, key)?, moment (?P<moment>\d+) ms, "
                   r"(?P<bytes>\d+) bytes, drawn in (?P<drawn>\d+) us, packed in (?P<packed>\d+) us, .*?"
                   r"(?P<skipped>\d+) skipped, crc (?P<crc>[0-9A-F]{8})$")
STEP = 10  # ms of animation from each picture to the next
LOOP = 4000  # of the demo scene
BARE = "--board /dev/null --stream usb"
PLAIN = f"{BARE} --panel none --size 240x240"
DEMO = f"--scene demo --method x --figures=off --step {STEP}"


class Picture:
    """A line of the trace."""

    def __init__(self, found):
        self.size, self.format, self.crc, self.key = found["size"], found["format"], found["crc"], bool(found["key"])
        for name in ("stamp", "number", "moment", "bytes", "drawn", "packed", "skipped"):
            setattr(self, name, int(found[name] or 0))


def trace(text):
    """The pictures of a trace."""
    return [Picture(found) for found in map(TRACE.match, text.splitlines()) if found]


class Pictures:
    """CRC-32s of the host's pictures, as lines of the trace have them."""

    def __init__(self, glint, kind, scene="demo", method="x", more=()):
        self.command = [glint, "render", f"tests/scenes/{scene}.json", "--method", method, "--hash", *kind.split(), *more]
        self.loop = self.hashes("--frames", str(LOOP // STEP), "--fps", str(1000 // STEP)) if scene == "demo" else None

    def hashes(self, *more):
        said = subprocess.run(self.command + list(more), check=True, stdout=subprocess.PIPE, text=True).stdout
        return [line.split()[1].upper() for line in said.splitlines()]

    def at(self, moment):
        return self.hashes("--time", str(moment))[0] if self.loop is None else self.loop[moment % LOOP // STEP]

    def complaint(self, pictures):
        """What is wrong with the first picture that is not the host's of its moment."""
        for index, p in enumerate(pictures):
            if p.crc != self.at(p.moment):
                return f"picture {index} of {len(pictures)}, number {p.number}, moment {p.moment}: {p.crc}, not {self.at(p.moment)}"
        return None


class Usb:
    """A guest's USB, and who is at its ends."""

    def __init__(self, guest, full):
        self.guest = guest
        self.speed = "full speed" if full else "high speed"
        self.device = self.viewer = None  # process numbers
        self.do(f"start_usb is_high_speed={int(not full)}")

    def do(self, line, seconds=60):
        """What a line prints that has to succeed."""
        status, said = self.guest.run(line, seconds)
        if status:
            raise RuntimeError(f"{line}: status {status}: {said}")
        return said

    def wait(self, condition, seconds=5):
        """Waits until the shell finds the condition true: whether it did."""
        return self.guest.run(f"i=0; until {condition}; do i=$((i + 1)); [ $i -lt {seconds * 50} ] || break; usleep 20000; done; "
                              f"[ $i -lt {seconds * 50} ]")[0] == 0

    def udc(self):
        return f"{GADGET}/*/UDC"

    def play(self, options):
        """Starts the device program and waits until the host has configured it: None, or what went wrong. Its words go to /tmp/device."""
        self.device = int(self.do(f"glint-device {options} >/tmp/device 2>&1 & echo $!"))
        if self.wait("ls /sys/bus/usb/devices/*-1:1.0 >/dev/null 2>&1"):
            return None
        return f"no device on USB: {self.do('cat /tmp/device')}"

    def stop(self, signal="TERM"):
        """Ends the device program: its status."""
        status = int(self.do(f"kill -{signal} {self.device}; wait {self.device}; echo $?").split()[-1])
        self.device = None
        return status

    def view(self, options, seconds=120):
        """glint-view from beginning to end: status, pictures, words on stdout and on stderr."""
        status, _ = self.guest.run(f"glint-view usb: --headless --trace {options} >/tmp/trace 2>/tmp/said", seconds)
        text = self.do("cat /tmp/trace")
        return status, trace(text), text, self.do("cat /tmp/said")

    def watch(self, options=""):
        """Starts glint-view."""
        self.viewer = int(self.do(f": >/tmp/trace; glint-view usb: --headless --trace {options} >/tmp/trace 2>/tmp/said & echo $!"))

    def seen(self):
        """The pictures so far of the one that was started."""
        return trace(self.do("cat /tmp/trace"))

    def leave(self, signal="TERM"):
        """Ends it: all its pictures."""
        self.do(f"kill -{signal} {self.viewer}; wait {self.viewer}; true")
        self.viewer = None
        return self.seen()

    def until_pictures(self, count, seconds=10):
        return self.wait(f"[ $(grep -c crc /tmp/trace) -ge {count} ]", seconds)

    def left(self):
        """What a program that ended has left of its gadget."""
        found = self.guest.run(f"ls -d {GADGET}/* 2>/dev/null; grep functionfs /proc/mounts")[1].strip()
        return f"left: {found}" if found else None
