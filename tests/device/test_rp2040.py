# SPDX-License-Identifier: MIT
"""test_rp2040.py MODULES GLINT BUILD: the handheld's program on emulated RP2040 boards, its pictures on the wires
against the host's of the same moments."""
import os
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from pico import Pico

modules, glint, build = sys.argv[1:4]
failed = 0

STOP, FIGURES = ["A"], ["A", "up"]
# What is pressed, and what of the answer then is new: 1 the scene, 2 the method, 3 the moment.
TOUR = ([(["right"], 1)] * 9 + [(["A", "right"], 3)] + [(["up"], 2)] * 19)
SHORT = [(["right"], 1)] * 2 + [(["A", "right"], 3), (["up"], 2)]


def verdict(name, complaint):
    global failed
    if complaint:
        failed += 1
    print(f"FAIL rp2040: {name}: {complaint}" if complaint else f"ok rp2040: {name}", flush=True)


def host(line, size):
    """The host's picture, RGB565, of what a line of the board's names."""
    scene, method, moment = line.split()[1:4]
    options = ["--method", method]
    if method.startswith("subdivide-"):
        options = ["--method", "subdivide", "--subdivide", method[len("subdivide-"):]]
    elif method.endswith("-perspective"):
        options = ["--method", method[:-len("-perspective")], "--perspective"]
    return subprocess.run([glint, "render", f"tests/scenes/{scene}.json", "--format", "rgb565", "--size", "%dx%d" % tuple(size),
                           "--time", moment, "--output-format", "raw", "-o", "-"] + options,
                          check=True, stdout=subprocess.PIPE).stdout


def compare(board, line):
    """What differs between the panel and the host's picture of what `line` names."""
    if not line or not line.startswith("frame ") or "running" in line:
        return f"the board says {line!r}"
    if "dropped" in line:
        return f"triangles found no room: {line}"
    got, size = board.screen()
    want = host(line, size)
    if len(got) != len(want) or len(set(want)) < 2:
        return f"{len(got)} bytes, not {len(want)} of {len(set(want))} values"
    differ = [i // 2 for i in range(0, len(want), 2) if want[i:i + 2] != got[i:i + 2]]
    return f"{len(differ)} pixels of {line} differ, the first at {divmod(differ[0], size[0])}" if differ else None


def tour(name, script):
    with Pico(modules, name, f"{build}/{name}/app.uf2") as board:
        line = board.line()
        verdict(f"{name} starts with a scene: {line}", None if line and line.endswith("running") else f"{line!r}")
        line = board.press(*STOP)
        verdict(f"{name}: figures are on the picture: {line}", None if compare(board, line) else "no pixel differs")
        line = board.press(*FIGURES)
        verdict(f"{name}: {line}", compare(board, line))
        seen = [line.split()]
        for buttons, new in script:
            line = board.press(*buttons)
            complaint = compare(board, line)
            if not complaint and line.split()[new] == seen[-1][new]:
                complaint = f"{seen[-1][new]} is still there"
            verdict(f"{name} after {'+'.join(buttons)}: {line}", complaint)
            seen.append(line.split())
        verdict(f"{name}: {len({s[1] for s in seen})} scenes, {len({s[2] for s in seen})} methods on wires without a fault",
                ", ".join(board.faults()))


tour("picosystem", TOUR)
tour("pico-st7789", SHORT)
tour("pico-display2", SHORT)
sys.exit(failed != 0)
