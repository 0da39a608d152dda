# SPDX-License-Identifier: MIT
"""play.py KERNEL GUEST BOARD PICTURE SECONDS [OPTION...] [A@MS...]: boots the emulated handheld and plays for so long from
its first picture on; keys A and B of the board (BOARD: its file) are held for a tenth of a second at their moments. Passes on
what the program says, and writes what was read from the pins as PICTURE, a PNG."""
import sys
import time

from guest import Guest
from panels import Ili9341, Ssd0323, St7789
from picture import png
from pins import KEY_A, KEY_B

MODELS = {"st7789": (St7789, 240, 240), "ili9341": (Ili9341, 240, 320), "ssd0323": (Ssd0323, 128, 64)}
KEYS = {"A": KEY_A, "B": KEY_B}
HELD_S = .1


def settings(board, options):
    """What the board's file says, and what options say instead."""
    found = {}
    with open(board, encoding="ascii") as file:
        for line in file:
            name, *value = line.split("#")[0].split() or [None]
            found[name] = " ".join(value)
    for word, value in zip(options, options[1:] + [""]):
        name, _, attached = word[2:].partition("=")
        if word.startswith("--"):
            found[name] = attached or value
    return found


class Player:
    """The program on a running guest, and its panel. Use it in a `with`."""

    def __init__(self, kernel, folder, board, options):
        found = settings(board, options)
        model, width, height = MODELS[found.get("panel")]
        if "size" in found:
            width, height = (int(side) for side in found["size"].split("x"))
        self.turn = int(found.get("rotate", 0))
        self.greys = model is Ssd0323
        self.glass = (width, height)
        self.size = (height, width) if self.turn % 180 else (width, height)
        self.panel = model(width, height, int(found.get("offset-x", 0)), int(found.get("offset-y", 0)))
        self.guest = Guest(kernel, folder)
        self.options = options
        self.ended = None  # the program's status
        self.by_lines = found.get("spi") == "gpio"

    def __enter__(self):
        self.guest.__enter__()
        if self.by_lines:
            self.guest.run("echo spi-panel >/sys/bus/platform/drivers/spi_gpio/unbind")
        self.guest.wires.attach(self.panel)
        self.guest.start(f"glint-device {' '.join(self.options)}")
        return self

    def __exit__(self, *_):
        self.guest.__exit__()

    def lines(self):
        """What the program has said since; its status behind it, which stays."""
        said = self.guest.lines()
        for line in said:
            if line.startswith("\036"):
                self.ended = int(line[1:])
        return [line for line in said if not line.startswith("\036")]

    def pixels(self):
        return self.panel.picture(self.turn) or [0] * (self.size[0] * self.size[1])

    def faults(self):
        return self.guest.wires.faults + self.panel.faults


def main():
    if len(sys.argv) < 6 or not sys.argv[5].isdigit():
        sys.exit("usage: play.py KERNEL GUEST BOARD PICTURE SECONDS [OPTION...] [A@MS...]")
    kernel, folder, board, picture, seconds = sys.argv[1:6]
    presses = [word.split("@") for word in sys.argv[6:] if "@" in word]
    options = [word for word in sys.argv[6:] if "@" not in word]
    moments = sorted((int(at) / 1000 + after, KEYS[name.upper()], level) for name, at in presses
                     for after, level in ((0, 1), (HELD_S, 0)))
    with Player(kernel, folder, board, options) as player:
        while player.panel.dark() and player.ended is None:
            player.guest.listen(1)
            print("".join(line + "\n" for line in player.lines()), end="", flush=True)
        begin = time.monotonic()
        while (now := time.monotonic() - begin) < int(seconds) and player.ended is None:
            while moments and moments[0][0] <= now:
                player.guest.key(*moments.pop(0)[1:])
            player.guest.listen(.02)
            print("".join(line + "\n" for line in player.lines()), end="", flush=True)
        png(picture, player.pixels(), player.size[0], player.greys)
        print(f"{player.guest.wires.bytes} bytes on the wires", *player.faults(), sep="\n")
        sys.exit(player.ended or 0)


if __name__ == "__main__":
    main()
