# SPDX-License-Identifier: MIT
"""An RP2040 board in npm's rp2040js from outside: its serial line, its buttons and what its panel shows."""
import json
import os
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))


class Pico:
    """A running image on boards/BOARD. Use it in a `with`. Its time goes on only within these calls."""

    def __init__(self, modules, board, image):
        self.folder = tempfile.TemporaryDirectory()
        self.node = subprocess.Popen(["node", os.path.join(HERE, "rp2040/drive.mjs"), modules, image], text=True,
                                     env=dict(os.environ, BOARD=board), stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.node.stdin.close()
        self.node.stdout.close()
        self.node.wait()
        self.folder.cleanup()

    def ask(self, *words):
        self.node.stdin.write(" ".join(map(str, words)) + "\n")
        self.node.stdin.flush()
        return json.loads(self.node.stdout.readline())

    def line(self, seconds=10):
        """The next line that the image has written, or None if none came in so much of its time."""
        return self.ask("line", seconds)

    def press(self, *names, ms=100):
        """Presses buttons one after the other, releases them in reverse order; returns the line that answers."""
        for name in names:
            self.ask("key", name, 1)
            self.ask("run", ms)
        for name in reversed(names):
            self.ask("key", name, 0)
            self.ask("run", ms)
        return self.line()

    def screen(self, name="screen"):
        """What is seen: RGB565, row by row, and its size."""
        path = os.path.join(self.folder.name, name)
        size = self.ask("picture", path)
        with open(path + ".raw", "rb") as file:
            return file.read(), size

    def faults(self):
        return self.ask("faults")
