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
from told import Told, host, stack_complaint

modules, glint, build = sys.argv[1:4]
failed = 0

# What is pressed, one after the other, or held together (up+left), or a line of the menu to go to; and what of the
# picture is new then. A board without B, X and Y goes by the menu.
TOUR = ([("B", "running"), ("A info left A", "figures"), ("up+left", "turn"), ("right", "turn"), ("A time right A", "moment"),
         ("A budget right A", "budget")] + [("X", "method")] * 20 + [("Y", "scene")] * 9)
SHORT = [("B", "running"), ("A info left A", "figures"), ("Y", "scene"), ("X", "method"), ("up+left", "turn"), ("A time right A", "moment")]
MENU = [("A motion left A", "running"), ("A info left A", "figures"), ("A scene right A", "scene"), ("A method left A", "method"),
        ("down+left", "turn"), ("A time left A", "moment")]
LINES = "scene", "method", "budget", "motion", "time", "turn", "info", "screen"

def verdict(name, complaint):
    global failed
    if complaint:
        failed += 1
    print(f"FAIL rp2040: {name}: {complaint}" if complaint else f"ok rp2040: {name}", flush=True)


def compare(board, told):
    """What differs between the panel and the host's picture of what the board told."""
    if told.running or told.dropped or told.menu:
        return f"running, dropped or a menu: {told.line}"
    got, size = board.screen()
    want = host(glint, told, size, ["--format", "rgb565", "--tables", "1"])
    if len(got) != len(want) or len(set(want)) < 2:
        return f"{len(got)} bytes, not {len(want)} of {len(set(want))} values"
    differ = [i // 2 for i in range(0, len(want), 2) if want[i:i + 2] != got[i:i + 2]]
    return f"{len(differ)} pixels differ, the first at {divmod(differ[0], size[0])}" if differ else None


def step(board, buttons):
    for name in buttons.split():
        if name in LINES:
            while told.menu != name:
                told = Told(board.press("down"))
        else:
            told = Told(board.hold(name.split("+"), 300) if buttons == name else board.press(name))
    return told


def tour(name, script):
    with Pico(modules, name, f"{build}/{name}/app.uf2") as board:
        seen = [Told(board.line())]
        verdict(f"{name} starts with a scene: {seen[0].line}", None if seen[0].running else "it does not run")
        for buttons, new in script:
            told = step(board, buttons)
            complaint = compare(board, told)
            if new == "running": # the figures are still on the picture
                complaint = None if complaint and "pixels differ" in complaint else f"no figures: {complaint}"
            elif new != "figures" and not complaint and getattr(told, new) == getattr(seen[-1], new):
                complaint = f"its {new} is still the same"
            verdict(f"{name} after {buttons}: {told.line}", complaint)
            seen.append(told)
        verdict(f"{name}: {len({s.scene for s in seen})} scenes, {len({s.method for s in seen})} methods on wires without a fault",
                ", ".join(board.faults()))
    if script is TOUR:
        complaint = stack_complaint(name, f"{build}/{name}/app.elf", Told.stack)
        verdict(f"{name}: {Told.stack} bytes of stack are 90 to 100 % of the bound", complaint)


def refusals():
    """What `make run` passes on is checked under the names that it has there."""
    uf2 = f"{build}/picosystem/app.uf2"
    for program, name, value in (("show.mjs", "SECONDS", "abc"), ("show.mjs", "SECONDS", "0"), ("serve.mjs", "PORT", "abc"),
                                 ("serve.mjs", "PORT", "65536")):
        picture = [f"{build}/picosystem/refused"] if program == "show.mjs" else []
        run = subprocess.run(["node", f"tests/device/rp2040/{program}", modules, uf2] + picture + [value], text=True,
                             capture_output=True, timeout=60, env=dict(os.environ, BOARD="picosystem"))
        verdict(f"{name}={value} is refused by its name", None if run.returncode == 2 and run.stderr.count("\n") == 1
                and run.stderr.startswith(f"{name}={value}: ") else f"{run.returncode}: {run.stderr}")


def page():
    """The board in a browser: what its page asks for, and a button that is pressed there."""
    server = subprocess.Popen(["node", "tests/device/rp2040/serve.mjs", modules, f"{build}/picosystem/app.uf2", "0"], text=True,
                              env=dict(os.environ, BOARD="picosystem"), stdout=subprocess.PIPE)
    lines, size = [], 0
    try:
        url = next(word for word in server.stdout.readline().split() if word.startswith("http://"))
        url = url.replace("localhost", "127.0.0.1")  # where it listens, whatever this machine calls that

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
            ask("/button?name=B&held=" + held, b"")
        look(lambda: len(lines) > 1)
        verdict(f"B pressed on the page: {lines[-1]}", None if "running" not in lines[-1] and size == 240 * 240 * 2 else f"{size} bytes")
    except (OSError, StopIteration) as error:
        verdict("the page", error or "no address")
    finally:
        server.terminate()
        server.wait()


refusals()
page()
tour("picosystem", TOUR)
tour("pico-st7789", SHORT)
tour("pico-display2", MENU)
sys.exit(failed != 0)
