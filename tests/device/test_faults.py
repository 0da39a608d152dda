# SPDX-License-Identifier: MIT
"""test_faults.py FAULTS.elf, or test_faults.py MODULES BOARD FAULTS.uf2: tests/device/faults.c on the emulated LM3S6965
board, or on an RP2040 board: how a program that fails says so, its stack, its serial line and its clock."""
import os
import struct
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import letters
from oled import HEIGHT, WIDTH, Oled
from pico import Pico

failed = 0
WAITING = 512  # SERIAL_WAITING


def verdict(name, complaint):
    global failed
    if complaint:
        failed += 1
    print(f"FAIL faults: {name}: {complaint}" if complaint else f"ok faults: {name}", flush=True)


def expect(name, wanted, got):
    verdict(f"{name}: {got if len(got or '') < 80 else got[:8] + '...' + got[-24:]}", None if wanted(got) else f"the board says {got!r}")


class Lm3s:
    """The board in QEMU; time is its own."""
    name = "lm3s6965evb"
    exceptions = {"undefined": 3, "unaligned": 3, "unserved": 11}

    def __init__(self, image, options=()):
        self.oled = Oled(image, options)

    def __enter__(self):
        return self

    def __exit__(self, *ended):
        self.oled.__exit__(*ended)

    def type(self, text):
        self.oled.type(text)

    def line(self, seconds=10):
        return self.oled.line(seconds)

    def run(self, ms):
        time.sleep(ms / 1000)

    def button(self, held):
        self.oled.key("a", held)

    def read(self):
        return letters.read([int(pixel == 255) for pixel in self.oled.screen()], WIDTH, HEIGHT)

    def complaints(self):
        return None


class Rp2040:
    """The board in rp2040js, which finds no word read at an odd address."""
    exceptions = {"undefined": 3, "unserved": 11}

    def __init__(self, modules, name, image):
        self.name, self.pico = name, Pico(modules, name, image)

    def __enter__(self):
        return self

    def __exit__(self, *ended):
        self.pico.__exit__(*ended)

    def type(self, text):
        """At the pace of the line, 87 us a byte: the emulated receiver takes 32 at any time."""
        for line in text.splitlines(keepends=True):
            for at in range(0, len(line), 16):
                self.pico.ask("type" if line[at:at + 16].endswith("\n") else "feed", line[at:at + 16].rstrip("\n"))
                self.run(2)

    def line(self, seconds=10):
        return self.pico.line(seconds)

    def run(self, ms):
        self.pico.ask("run", ms)

    def button(self, held):
        self.pico.ask("key", "A", int(held))

    def read(self):
        pixels, (width, height) = self.pico.screen()
        return letters.read([int(pixels[i:i + 2] == b"\xff\xff") for i in range(0, len(pixels), 2)], width, height, 2)

    def complaints(self):
        return self.pico.faults() or None


def pressed(board):
    """The line that follows a button's press: again where an emulator that got no time did not see it."""
    for _ in range(3):
        board.button(True)
        board.run(100)
        board.button(False)
        if (line := board.line()) is not None:
            return line
    return None


def restarted(board, line):
    """After a fault told on the serial line as `line`: the same words on the display until a button, and then goes on."""
    wanted = [words.upper() for words in line.split(", ")] + ["PRESS A BUTTON"] if line else None
    for _ in range(10):  # the display's start takes up to .4 s, of a machine that has time for it
        board.run(900)
        if (got := board.read()) == wanted:
            break
    verdict(f"on the display: {got}", None if got == wanted else f"it is not {wanted}")
    expect("it waits", lambda line: line is None, board.line(.3))
    expect("a button starts it anew", lambda line: line == "ready", pressed(board))


def exceptions(board):
    for command, number in board.exceptions.items():
        board.type(command + "\n")
        line = board.line()
        clauses = line.split(", ") if line else []
        places = [int(clause.split(" ")[1], 16) for clause in clauses[1:] if clause.startswith(("at ", "from "))]
        expect(command, lambda _, c=clauses, n=number, p=places: c[:1] == [f"fault {n}"] and len(p) == 2 == len(c) - 1 and
               abs(p[0] - p[1]) < 64, line)  # the call before is near
        restarted(board, line)


def stack(board):
    marks = []
    for depth in (1000, 1040, 40):
        board.type(f"deep {depth}\n")
        line = board.line()
        words = line.split(" ") if line else []
        marks.append(int(words[1]) if words[:1] == ["used"] else 0)
    expect(f"the stack's high-water goes with its depth: {marks}", lambda _: marks[0] > 1000 and marks[1:] == [marks[0] + 40] * 2, line)
    size = int(line.split(" ")[-1])
    for depth in (size, 3 * size):  # the second also smashes variables behind it
        board.type(f"deep {depth}\n")
        line = board.line()
        expect(f"{depth} of {size} bytes used", lambda line: line and line.startswith("fault, stack overflow, at "), line)
        restarted(board, line)


def second(board):
    """The second CPU's faults and its stack, while the first goes on."""
    board.type("second 0\n")
    line = board.line()
    expect("a fault of the second CPU", lambda line: line and line.startswith("fault 3, at 1000"), line)
    restarted(board, line)
    board.type("second 3900\n")
    expect("the second CPU has a stack of its own", lambda line: line and line.startswith("used "), board.line())
    board.type("second 4096\n")
    line = board.line()
    expect("the end of the second CPU's stack is watched", lambda line: line and line.startswith("fault, stack overflow, at "), line)
    restarted(board, line)


def serial(board):
    text = "".join(chr(ord("a") + i % 26) for i in range(WAITING - 12))
    for name, more, wanted in (("what comes while the program is busy waits", "", f"got {text}, lost 0"),
                               ("what finds no room is counted", "x" * 22, f"got {text}{'x' * 12}, lost 10")):
        board.type("busy\n")
        begun = board.line()
        board.type(text + more)
        board.run(1000)  # until all of it has come
        expect(name, lambda line, b=begun, w=wanted: (b, line) == ("busy", w), pressed(board))


def clock(board):
    board.type("clock 400000\n" if board.name == Lm3s.name else "clock 20000\n")
    expect("the clock", lambda line: line == "0 steps back", board.line(60))


def twice(image):
    """Faults before the first was shown end the program: the first instruction becomes an undefined one."""
    with open(image, "rb") as file:
        data = bytearray(file.read())
    entry, header = struct.unpack_from("<II", data, 24)
    struct.pack_into("<H", data, struct.unpack_from("<I", data, header + 4)[0] + (entry & ~1), 0xDE00)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "altered.elf")
        with open(path, "wb") as file:
            file.write(data)
        with Lm3s(path) as board:
            lines = [board.line(2) for _ in range(4)]
    verdict("a fault at each start ends it", None if lines[0] and lines[0].startswith("fault 3, ") and lines[0] == lines[1] and
            lines[2:] == ["exit 3", None] else f"{lines}")


def suite(board):
    expect(f"{board.name} starts", lambda line: line == "ready", board.line())
    serial(board)
    stack(board)
    exceptions(board)
    verdict("nothing to complain of on its wires", board.complaints())


if len(sys.argv) == 2:
    with Lm3s(sys.argv[1]) as on_qemu:
        suite(on_qemu)
    # instructions take a nanosecond each, or the machine's load would show
    with Lm3s(sys.argv[1], ["-icount", "shift=0"]) as counted:
        counted.line()
        clock(counted)
    twice(sys.argv[1])
else:
    with Rp2040(*sys.argv[1:4]) as on_rp2040js:
        suite(on_rp2040js)
        second(on_rp2040js)
        clock(on_rp2040js)
sys.exit(failed != 0)
