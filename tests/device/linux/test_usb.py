# SPDX-License-Identifier: MIT
"""test_usb.py KERNEL GUEST GLINT [high|full|panel|figures]...: pictures over USB in the emulated handheld.

Time is counted in instructions, so that seconds are the guest's whatever the machine under it does, and waits cost nothing.
A boot for each part: `high` and `full` speed, `panel`s that play the same; `figures` prints speeds.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import usb_cases as cases
import usb_panel
from guest import Guest
from usb import Usb

kernel, folder, glint = sys.argv[1:4]
version = os.path.basename(folder).removeprefix("guest-")
parts = sys.argv[4:] or {"v1": ["high"], "v2": ["full", "panel"]}[version]
# The cases of each part. What does not depend on the speed is tried at one of them.
PARTS = {"high": (cases.pictures, cases.cable, cases.two, cases.bogus),
         "full": (cases.pictures, cases.sizes, cases.stopped, cases.requests, cases.starts),
         "panel": usb_panel.CASES}
failed = 0


def verdict(name, complaint):
    global failed
    failed += bool(complaint)
    print(f"FAIL usb {version}: {name}: {complaint}" if complaint else f"ok usb {version}: {name}", flush=True)


for part in parts:
    with Guest(kernel, folder, counted=0, traced=part == "panel") as guest:
        usb = Usb(guest, part != "high")
        for case in PARTS[part]:
            for name, complaint in case(usb, glint):
                verdict(f"{usb.speed}, {name}" if case is cases.pictures else name, complaint)
sys.exit(failed != 0)
