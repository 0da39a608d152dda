# SPDX-License-Identifier: MIT
"""test_linux.py KERNEL GUEST GLINT [counted|timed|figures]...: the device program on the emulated handheld, judged at its pins.

Two boots of a guest. In the first time is counted in instructions, waits cost nothing and what is measured repeats: it
has the pictures and the faults. In the second time passes: it has delays, keys and signals. `figures` prints speeds.
"""
import os
import re
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import startup
from guest import Guest
from panels import Ili9341, Ssd0323, St7789
from picture import png, raw
from pins import BACKLIGHT, DC, KEY_A, MS, RESET

kernel, folder, glint = sys.argv[1:4]
parts = sys.argv[4:] or ["counted", "timed"]
version = os.path.basename(folder).removeprefix("guest-")
failed = 0

WIRED = "--board /dev/null --chip 9030000.pl061 --dc DC --reset RESET --backlight BACKLIGHT"
BY_SPIDEV = f"{WIRED} --spi /dev/spidev0.0"
BY_LINES = f"{WIRED} --spi gpio --sck SCK --mosi MOSI --cs CS"
UNBIND, BIND = (f"echo spi-panel >/sys/bus/platform/drivers/spi_gpio/{what}" for what in ("unbind", "bind"))
MODELS = {"st7789": St7789, "ili9341": Ili9341, "ssd0323": Ssd0323}
USUAL = {"st7789": (240, 240), "ili9341": (240, 320), "ssd0323": (128, 64)}
STILL = "--scene demo --method x --figures=off --still"


def verdict(name, complaint):
    global failed
    if complaint:
        failed += 1
    print(f"FAIL {version}: {name}: {complaint}" if complaint else f"ok {version}: {name}", flush=True)


class Case:
    """A panel at the pins, and the options that fit it."""

    def __init__(self, guest, name, glass=None, turn=0, options=BY_SPIDEV):
        self.guest, self.name, self.turn, self.greys = guest, name, turn, name == "ssd0323"
        self.glass = glass or USUAL[name] + (0, 0)
        width, height, x, y = self.glass
        self.size = (height, width) if turn % 180 else (width, height)
        self.panel = MODELS[name](*self.glass)
        guest.wires.attach(self.panel)
        self.options = (f"glint-device {options} --panel {name} --size {width}x{height} --offset-x {x} --offset-y {y}"
                        f" --rotate {turn}")

    def run(self, more, seconds=120):
        status, self.said = self.guest.run(f"{self.options} {more}", seconds)
        return None if status == 0 else f"status {status}: {self.said.strip()}"

    def faults(self):
        found = self.guest.wires.faults + self.panel.faults
        return "; ".join(found[:3]) if found else None

    def dark(self):
        """The panel was left in reset, the backlight off, no line taken."""
        level = self.guest.wires.level
        if level[RESET] or level[BACKLIGHT]:
            return f"left with reset {level[RESET]}, backlight {level[BACKLIGHT]}"
        return leaked(self.guest)

    def desktop(self, time, more=()):
        """The host's picture, as numbers."""
        kind = ["--format", "grey4", "--dither"] if self.greys else ["--format", "rgb565", "--tables", "1"]
        data = subprocess.run([glint, "render", "tests/scenes/demo.json", "--method", "x", "--time", str(time), "--size",
                               "{}x{}".format(*self.size), "--output-format", "raw", "-o", "-"] + kind + list(more),
                              check=True, stdout=subprocess.PIPE).stdout
        if self.greys:
            return [level for byte in data for level in (byte >> 4, byte & 15)]
        return [low | high << 8 for low, high in zip(data[::2], data[1::2])]

    def shows(self, wanted):
        """What was seen is what is wanted."""
        seen = self.panel.picture(self.turn)
        if seen is None:
            return "nothing was seen"
        if len(set(wanted)) < 4:
            return "what is wanted is empty"
        differ = [i for i, (a, b) in enumerate(zip(seen, wanted)) if a != b]
        if not differ and len(seen) == len(wanted):
            return None
        path = f"{folder}/{self.name}-{self.turn}.png"
        png(path, seen, self.size[0], self.greys)
        return f"{len(differ)} pixels differ, the first at {divmod(differ[0], self.size[0])}: {path}"


def leaked(guest):
    """Who has a line that was the program's."""
    _, lines = guest.run("cat /sys/kernel/debug/gpio")
    held = re.findall(r"\((\S*) *\|(\S+) *\)", lines)
    held = [f"{name} by {who}" for name, who in held if who.startswith("glint")]
    return ", ".join(held) + " is still held" if held else None


def bars(width, height, greys):
    """The test pattern as hal/README.md describes it."""
    edge, ramp, picture = 2 if greys else 1, height * 3 // 4 & ~1, []
    colours = [0xFFFF, 0xFFE0, 0x07FF, 0x07E0, 0xF81F, 0xF800, 0x001F, 0x0000]
    for y in range(height):
        for x in range(width):
            bar, level = x * 8 // width, x * 32 // width
            if x in (0, width - 1) or not edge <= y < height - edge:
                picture.append(15 if greys else 0xFFFF)
            elif y < ramp:
                picture.append(14 - 2 * bar if greys else colours[bar])
            else:
                ramp_mask = (0xF800, 0x07E0, 0x001F, 0xFFFF)[(y - ramp) * 4 // (height - ramp)]
                picture.append(level // 2 if greys else level * 0x0841 & ramp_mask)
    return picture


def one_picture(case, name, time=300, more="", wanted=None):
    complaint = case.run(f"{STILL} --time {time} --frames 1 {more}")
    verdict(name, complaint or case.faults() or case.shows(wanted or case.desktop(time)) or case.dark())


def small_pictures(guest, names, options):
    glass = {"st7789": (52, 40, 7, 80), "ili9341": (44, 60, 3, 9), "ssd0323": (32, 20, 8, 3)}
    for name in names:
        for turn in (0, 90, 180, 270):
            case = Case(guest, name, glass[name], turn, options)
            one_picture(case, f"{name} {case.size[0]}x{case.size[1]} turned by {turn}")


def colours(guest):
    glass = (40, 24, 0, 0)
    case = Case(guest, "st7789", glass)
    exchanged = [p >> 11 | p & 0x7E0 | (p & 31) << 11 for p in case.desktop(300)]
    one_picture(case, "--bgr exchanges red and blue", more="--bgr", wanted=exchanged)
    case = Case(guest, "ili9341", glass)
    one_picture(case, "--invert gives the complement", more="--invert", wanted=[p ^ 0xFFFF for p in case.desktop(300)])
    # The kernel's spi-gpio lets the clock go to its new rest once while the panel is selected.
    Case(guest, "st7789", glass).run(f"{STILL} --frames 1 --spi-mode 3")
    one_picture(Case(guest, "st7789", glass), "SPI mode 3 and another speed", more="--spi-mode 3 --speed 500k")
    numbers = BY_SPIDEV.replace("--dc DC --reset RESET --backlight BACKLIGHT", "--dc 4 --reset 5 --backlight 6")
    one_picture(Case(guest, "st7789", glass, options=numbers), "lines by number")
    device = BY_SPIDEV.replace("9030000.pl061", "/dev/gpiochip0")
    one_picture(Case(guest, "st7789", glass, options=device), "chip by path")


def changed_rows(guest, name, glass, options, bits):
    """The last of several pictures is right, and fewer bytes were sent for it."""
    sent = {}
    for rows, more in (("all rows", "--whole"), ("changed rows", "")):
        case = Case(guest, name, glass, options=options)
        complaint = case.run(f"--scene demo --method x --figures=off --time 0 --step 40 --frames 6 {more}", 300)
        sent[rows] = guest.wires.bytes
        verdict(f"{name} {glass[0]}x{glass[1]}: {rows} of 6 pictures, {sent[rows] / 6:.0f} bytes a picture",
                complaint or case.faults() or case.shows(case.desktop(200)) or case.dark())
    whole = glass[0] * glass[1] * bits // 8 * 6
    good = sent["changed rows"] < .9 * sent["all rows"] and whole < sent["all rows"] < whole + 600
    verdict(f"{name}: what has not changed is not sent", None if good else f"{sent}, raw {whole}")


def refused(guest, name, line, status, words, before=None, after=None):
    """A run that cannot be: its status, one line that says why, nothing held, the panel dark."""
    if before:
        guest.run(before)
    case = Case(guest, "st7789", (16, 16, 0, 0))
    got, said = guest.run(line)
    if after:
        guest.run(after)
    complaint = None
    if got != status:
        complaint = f"status {got}, not {status}: {said.strip()}"
    elif said.count("\n") != 1 or not re.search(words, said):
        complaint = f"it says {said!r}"
    verdict(f"{name}: {said.strip()}", complaint or case.dark())


def faults(guest):
    tiny = f"--panel st7789 --size 16x16 {STILL} --frames 1"
    run = f"glint-device {BY_SPIDEV} {tiny}"
    export = "/sys/class/gpio/{}"
    base = guest.run("cat /sys/class/gpio/gpiochip*/base")[1].strip()
    dc = int(base) + DC
    refused(guest, "no such chip", run.replace("9030000.pl061", "pinctrl-none"), 3, "pinctrl-none")
    refused(guest, "no such line", run.replace("--dc DC", "--dc NOWHERE"), 3, "NOWHERE")
    refused(guest, "no line of that number", run.replace("--dc DC", "--dc 99"), 3, "99")
    refused(guest, "a line that is taken", run, 3, "line 4 .*taken by .sysfs", f"echo {dc} >{export.format('export')}",
            f"echo {dc} >{export.format('unexport')}")
    refused(guest, "chip select is the kernel's", f"glint-device {BY_LINES} {tiny}", 3, "line 0 .*taken by .sck")
    refused(guest, "no spidev", run.replace("spidev0.0", "spidev7.0"), 3, "spidev7.0")
    refused(guest, "no spidev: a file that is none", run.replace("/dev/spidev0.0", "/dev/null"), 3, "/dev/null")
    refused(guest, "no permission for the chip", f"su -s /bin/sh nobody -c '{run}'", 3, "GPIO chip .*ermission",
            "chmod 666 /dev/spidev0.0", "chmod 600 /dev/spidev0.0")
    refused(guest, "no permission for spidev", f"su -s /bin/sh nobody -c '{run}'", 3, "spidev0.0.*ermission",
            "chmod 666 /dev/gpiochip0", "chmod 600 /dev/gpiochip0")
    refused(guest, "no such panel", run.replace("st7789", "st7790"), 2, "st7790")
    refused(guest, "no such option", f"{run} --frobnicate", 2, "frobnicate")
    refused(guest, "a board file that is not there", run.replace("/dev/null", "/none"), 3, "/none")
    refused(guest, "a board file with a mistake", "glint-device --board /tmp/bad", 1, "/tmp/bad:2: ",
            "printf 'panel st7789\\nwings 2\\n' >/tmp/bad")
    one_picture(Case(guest, "st7789", (16, 16, 0, 0)), "after all those it plays")
    status, text = guest.run("glint-device --list")
    missing = [word for word in ("st7789", "ssd0323", "demo", "9030000.pl061", "/dev/spidev0.0") if word not in text]
    verdict("--list names panels, scenes, chips and SPI devices", f"{status}, without {missing}" if status or missing else None)


def counted():
    # An odd size for what spidev takes at a time: chunks that are not whole pixels.
    with Guest(kernel, folder, counted=0, kernel_options="spidev.bufsiz=1001") as guest:
        small_pictures(guest, ("st7789", "ili9341"), BY_SPIDEV)
        colours(guest)
        faults(guest)
        changed_rows(guest, "st7789", (56, 40, 0, 0), BY_SPIDEV, 16)
        whole = "st7789" if version == "v1" else "ili9341"
        one_picture(Case(guest, whole), "{} {}x{}".format(whole, *USUAL[whole]))
        guest.run(UNBIND)
        refused(guest, "no spidev where the kernel has none", f"glint-device {BY_SPIDEV} --panel st7789", 3, "spidev0.0")
        small_pictures(guest, ("ssd0323",), BY_LINES)
        changed_rows(guest, "ssd0323", (128, 64, 0, 0), BY_LINES, 4)
        one_picture(Case(guest, "st7789", (24, 16, 0, 0), options=BY_LINES), "st7789 24x16, bits by libgpiod")


def clock(guest):
    """What the shell's clock says of a pause lies between what the pins' stamps say: the clock counts 10 ms."""
    base = int(guest.run("cat /sys/class/gpio/gpiochip*/base")[1])
    line = f"/sys/class/gpio/gpio{base + BACKLIGHT}"
    guest.run(f"cd /sys/class/gpio; echo {base + BACKLIGHT} >export; echo out >{line}/direction")
    guest.wires.attach(None)
    _, said = guest.run(f"read a x </proc/uptime; echo 1 >{line}/value; read b x </proc/uptime; usleep 1500000;"
                        f"read c x </proc/uptime; echo 0 >{line}/value; read d x </proc/uptime; echo $a $b $c $d")
    guest.run(f"cd /sys/class/gpio; echo {base + BACKLIGHT} >unexport")
    a, b, c, d = (float(word) for word in said.split())
    pause = (guest.wires.edges[1][0] - guest.wires.edges[0][0]) / 1e6
    good = c - b - .02 <= pause <= d - a + .02 and pause > 1.5
    verdict("the pins' stamps are the guest's time", None if good else f"{pause} s at the pins, {said.strip()} in the guest")


def raise_reset(guest):
    """The panel is out of reset, as somebody may have left it."""
    line = int(guest.run("cat /sys/class/gpio/gpiochip*/base")[1]) + RESET
    guest.run(f"cd /sys/class/gpio; echo {line} >export; echo high >gpio{line}/direction; echo {line} >unexport")


def starts(guest, name, options, wanted):
    raise_reset(guest)
    case = Case(guest, name, (16, 16, 0, 0), options=options)
    complaint = case.run(f"{STILL} --frames 1") or case.faults() or startup.complaint(wanted, case.panel.log)
    verdict(f"{name}: start-up commands and their waits", complaint)
    edges = {(wire, level): now for now, wire, level in guest.wires.edges[::-1]}
    low = (edges["reset", 1] - edges["reset", 0]) / MS
    rest = (guest.wires.first - edges["reset", 1]) / MS
    good = low >= startup.RESET_MS["low"] and rest >= startup.RESET_MS["after"]
    verdict(f"{name}: in reset {low:.0f} ms, first command {rest:.0f} ms after it", None if good else "too short")
    verdict(f"{name}: the backlight comes on behind the picture, and goes off before the panel",
            None if case.panel.lit == [(1, True), (0, True)] else f"{case.panel.lit}")


def in_the_background(guest, case, more):
    _, said = guest.run(f"{case.options} {more} & echo $!")
    return int(said)


def ended(guest, signal, status):
    """A signal while a picture is on its way, to a program in the foreground: in the background a shell has SIGINT
    ignored. What sends it waits for a line on the console."""
    width, height = 120, 80
    case = Case(guest, "st7789", (width, height, 0, 0))
    guest.start(f"(read x </dev/console; kill -{signal} $(pidof glint-device)) & {case.options} --scene demo --figures=off --whole")
    whole = width * height * 2
    while case.panel.dark() or not whole // 4 < guest.wires.bytes % whole < whole // 2:
        guest.listen(5)
    guest.start("")
    got, said = guest.finish()
    complaint = None if got == status else f"status {got}, not {status}: {said.strip()}"
    return case, complaint or case.faults()


def signals(guest):
    for signal in ("TERM", "INT", "HUP"):
        case, complaint = ended(guest, signal, 0)
        verdict(f"SIG{signal} while a picture is on its way: dark and in reset", complaint or case.dark())
    case, complaint = ended(guest, "KILL", 137)
    left = guest.wires.level[RESET] and guest.wires.level[BACKLIGHT] and not case.panel.dark()
    verdict("SIGKILL leaves the panel on, and no line taken", complaint or leaked(guest) or (None if left else "it is dark"))
    complaint = case.run("--off")
    verdict("--off puts it out", complaint or case.dark())


def pattern(guest):
    for name, glass, options in (("st7789", (48, 32, 4, 8), BY_SPIDEV), ("ili9341", (48, 32, 0, 0), BY_SPIDEV)):
        case = Case(guest, name, glass, options=options)
        number = in_the_background(guest, case, "--test-pattern")
        while not guest.wires.level[BACKLIGHT]:
            guest.listen(5)
        status, said = guest.run(f"kill {number}; wait {number}")
        verdict(f"{name}: --test-pattern shows its bars until SIGTERM", (f"status {status}: {said}" if status else None) or
                case.faults() or case.shows(bars(48, 32, case.greys)) or case.dark())


def press(guest, line, bounces):
    """A press and its release, each with bounces of 2 ms that are over within 9; what the program says of it. Where the
    machine under it was too busy to be on time, that was no bouncing, and is done again."""
    for _ in range(30):
        longest = 0
        for level in (1, 0):
            begin = time.monotonic()
            for _ in range(bounces):
                guest.key(line, level)
                guest.rest(.002)
                guest.key(line, 1 - level)
                guest.rest(.001)
            guest.key(line, level)
            longest = max(longest, time.monotonic() - begin)
            guest.rest(.15)
        guest.rest(.5)
        said = guest.lines()
        if longest < .009:
            break
    return said


def keys(guest):
    case = Case(guest, "st7789", (24, 16, 0, 0))
    number = in_the_background(guest, case, f"{STILL} --keys a=KEY_A,b=KEY_B --keys-high")
    first = guest.until(b"\n", 20)
    verdict(f"it says what is shown: {first}", None if first.startswith("frame demo x ") else f"{first!r}")
    for bounces in (0, 1, 2):
        said = [press(guest, KEY_A, bounces), press(guest, KEY_A, bounces)]
        good = [len(lines) for lines in said] == [1, 1] and all(line.startswith("frame ") for lines in said for line in lines)
        verdict(f"a key with {bounces} bounces at each edge is pressed once: {said}", None if good else "not so")
    status, _ = guest.run(f"kill {number}; wait {number}")
    verdict("it ends, and the keys' lines are free", (f"status {status}" if status else None) or case.faults() or case.dark())


def figures():
    """What a picture costs, in the guest's time: an instruction a nanosecond. Lines for tools/board_costs.py."""
    wire = {"st7789": 62.5e6, "ili9341": 40e6, "ssd0323": 4e6}
    count = 10
    with Guest(kernel, folder, counted=0, traced=False) as guest:
        for name in ("st7789", "ili9341", "ssd0323"):
            options = BY_SPIDEV
            if name == "ssd0323":
                guest.run(UNBIND)
                options = BY_LINES
            for rows, more in (("all rows", "--whole"), ("changed rows", "")):
                case = Case(guest, name, options=options)
                counter = "cat /sys/class/spi_master/spi0/statistics/bytes 2>/dev/null || echo 0"  # none of bits by lines
                line = f"time -f 'took %e %U %S' {case.options} --scene demo --figures=off --step 33 --fps 1000 --frames"
                took, sent = [], []
                for frames in (1, 1 + count):  # the start is not theirs
                    before = int(guest.run(counter)[1])
                    status, said = guest.run(f"{line} {frames} {more}", 300)
                    sent.append(int(guest.run(counter)[1]) - before)
                    took.append([float(word) for word in re.search(r"took (\S+) (\S+) (\S+)", said).groups()])
                real, user, system = (round(1e6 * (b - a) / count) for a, b in zip(*took))
                size = "{}x{}".format(*case.size)
                bits = case.size[0] * case.size[1] * (4 if case.greys else 16)
                figures = (("real", "us", real), ("user", "us", user), ("system", "us", system),
                           ("cpu", "percent", round(100 * (user + system) / real)),
                           ("bytes", "bytes", round((sent[1] - sent[0]) / count)),
                           ("wire", "us", round(1e6 * bits / wire[name])))
                for figure, unit, number in figures:
                    print(f"{name} {size} {rows},{figure},{unit},{number}", flush=True)


def timed():
    with Guest(kernel, folder) as guest:
        clock(guest)
        starts(guest, "st7789", BY_SPIDEV, startup.ST7789)
        starts(guest, "ili9341", BY_SPIDEV, startup.ILI9341)
        pattern(guest)
        keys(guest)
        signals(guest)
        guest.run(UNBIND)
        starts(guest, "ssd0323", BY_LINES, startup.SSD0323)


for part in parts:
    {"counted": counted, "timed": timed, "figures": figures}[part]()
sys.exit(failed != 0)
