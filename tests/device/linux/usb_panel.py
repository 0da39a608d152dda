# SPDX-License-Identifier: MIT
"""A panel at the pins and a host on USB, shown the same pictures."""
import subprocess

from panels import Ssd0323, St7789
from picture import raw
from usb import BARE, DEMO, STEP, Pictures

WIRED = f"{BARE} --chip 9030000.pl061 --dc DC --reset RESET --backlight BACKLIGHT"
BY_SPIDEV = "--spi /dev/spidev0.0"
BY_LINES = "--spi gpio --sck SCK --mosi MOSI --cs CS"
FRAMES = 60
STREAMED = 10


def both(usb, glint, name, panel, options, kind):
    """A panel's last picture is the host's of that moment, and so are those that were streamed before."""
    width, height = panel.glass[:2]
    size = f"{width}x{height}"
    usb.guest.wires.attach(panel)
    complaint = usb.play(f"{WIRED} {options} --panel {name} --size {size} --frames {FRAMES} {DEMO}")
    status, shown, text, said = usb.view(f"--frames {STREAMED}")
    if status or len(shown) != STREAMED:
        complaint = complaint or f"status {status}, {len(shown)} pictures: {said}{text[-300:]}"
    yield f"{name} {size}: {len(shown)} pictures go to the host as they do to the panel", \
        complaint or Pictures(glint, f"{kind} --size {size}").complaint(shown)
    status = int(usb.do(f"wait {usb.device}; echo $?", 120))
    command = [glint, "render", "tests/scenes/demo.json", "--method", "x", "--size", size, "--time", str((FRAMES - 1) * STEP),
               "--output-format", "raw", "-o", "-", *kind.split()]
    wanted = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
    seen = panel.picture()
    complaint = f"status {status}: {usb.do('cat /tmp/device')}" if status else "; ".join((usb.guest.wires.faults + panel.faults)[:3])
    if not complaint and (seen is None or raw(seen, name == "ssd0323") != wanted):
        complaint = "nothing was seen" if seen is None else "another picture"
    yield f"{name} {size}: the panel shows all {FRAMES}, and ends dark", complaint or (None if panel.dark() else "it is lit") or usb.left()


def colours(usb, glint):
    yield from both(usb, glint, "st7789", St7789(48, 32), BY_SPIDEV, "--format rgb565 --tables 1")


def greys(usb, glint):
    usb.do("echo spi-panel >/sys/bus/platform/drivers/spi_gpio/unbind")
    yield from both(usb, glint, "ssd0323", Ssd0323(40, 20), BY_LINES, "--format grey4 --dither")


CASES = (colours, greys)
