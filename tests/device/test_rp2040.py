# SPDX-License-Identifier: MIT
"""test_rp2040.py MODULES GLINT BUILD: the handheld's program on emulated RP2040 boards, its pictures on the wires
against the host's of the same moments."""
import json
import os
import subprocess
import sys
import urllib.parse
import urllib.request

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


def page():
    """The board in a browser: what its page asks for, and a button that is pressed there."""
    server = subprocess.Popen(["node", "tests/device/rp2040/serve.mjs", modules, f"{build}/picosystem/app.uf2", "0"], text=True,
                              env=dict(os.environ, BOARD="picosystem"), stdout=subprocess.PIPE)
    lines, size = [], 0
    try:
        url = next(word for word in server.stdout.readline().split() if word.startswith("http://"))

        def ask(path, data=None):
            with urllib.request.urlopen(url + path, data, timeout=60) as answer:
                return answer.headers, answer.read()

        def look(until):
            nonlocal size
            for _ in range(1000):
                headers, pixels = ask("/picture")
                lines.extend(json.loads(urllib.parse.unquote(headers["X-State"]))["lines"])
                size = len(pixels)
                if until():
                    return
            raise OSError(f"it only said {lines}")
        wires = json.loads(ask("/board")[1])
        missing = [name for name in wires["buttons"] if name.encode() not in ask("/")[1]]
        verdict("a page with the board's buttons", ", ".join(missing))
        look(lambda: lines)
        for held in "10":
            ask("/button?name=A&held=" + held, b"")
        look(lambda: len(lines) > 1)
        verdict(f"A pressed on the page: {lines[-1]}", None if "running" not in lines[-1] and size == 240 * 240 * 2 else f"{size} bytes")
    except (OSError, StopIteration) as error:
        verdict("the page", error or "no address")
    finally:
        server.terminate()
        server.wait()


page()
tour("picosystem", TOUR)
tour("pico-st7789", SHORT)
tour("pico-display2", SHORT)
sys.exit(failed != 0)
