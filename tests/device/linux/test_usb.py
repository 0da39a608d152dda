# SPDX-License-Identifier: MIT
"""test_usb.py KERNEL GUEST GLINT [high|full|panel|figures]...: pictures over USB in the emulated handheld.

Time is counted in instructions, so that seconds are the guest's whatever the machine under it does, and waits cost nothing.
A boot for each part: `high` and `full` speed, `panel`s that play the same; `figures` prints what a picture takes.
"""
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import usb_cases as cases
import usb_panel
from guest import Guest
from usb import BARE, Usb

kernel, folder, glint = sys.argv[1:4]
version = os.path.basename(folder).removeprefix("guest-")
parts = sys.argv[4:] or {"v1": ["high"], "v2": ["full", "panel"]}[version]
# The cases of each part. What does not depend on the speed is tried at one of them.
PARTS = {"high": (cases.pictures, cases.cable, cases.two, cases.bogus),
         "full": (cases.pictures, cases.sizes, cases.stopped, cases.requests, cases.starts, cases.faster),
         "panel": usb_panel.CASES}
failed = 0


def verdict(name, complaint):
    global failed
    failed += bool(complaint)
    print(f"FAIL usb {version}: {name}: {complaint}" if complaint else f"ok usb {version}: {name}", flush=True)


def figures():
    """What a picture over USB costs, in the guest's time: an instruction a nanosecond, device and host on one CPU. What full
    speed carries is 1 MB/s on a real bus; the emulated one has no such bound."""
    count = 100
    with Guest(kernel, folder, counted=0, traced=False) as guest:
        usb = Usb(guest, True)
        for scene in ("demo", "spin-torus800", "spin-teapot"):
            for name, more in ((scene, ""), (f"{scene} dithered", "--dither")):
                usb.play(f"{BARE} --panel none --size 240x240 --scene {scene} --figures=off --step 20 --fps 1000 {more}")
                shown = usb.view(f"--frames {20 + count}")[1][-count:]
                usb.stop()
                size = sum(p.bytes for p in shown) // count
                drawn, packed = (sum(getattr(p, what) for p in shown) // count for what in ("drawn", "packed"))
                for figure, unit, number in (("drawn", "us", drawn), ("packed", "us", packed), ("bytes", "bytes", size),
                                             ("full speed", "pictures/s", 1000000 // size)):
                    print(f"usb 240x240 {name},{figure},{unit},{number}", flush=True)


if parts == ["figures"]:
    figures()
    sys.exit()
for part in parts:
    with Guest(kernel, folder, counted=0, traced=part == "panel") as guest:
        usb = Usb(guest, part != "high")
        for case in PARTS[part]:
            begin = time.monotonic()
            try:
                for name, complaint in case(usb, glint):
                    verdict(f"{usb.speed}, {name}" if case is cases.pictures else name, complaint)
            except (RuntimeError, ValueError) as problem:
                verdict(f"{usb.speed}, {case.__name__}", problem)
                break  # what follows would stand on it
            print(f"# {version} {case.__name__}: {time.monotonic() - begin:.0f} s", flush=True)
sys.exit(failed != 0)
