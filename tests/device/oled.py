# SPDX-License-Identifier: MIT
"""QEMU's lm3s6965evb from outside: its serial line, its keys and what its OLED shows.

As a program: oled.py IMAGE PICTURE runs an image for three seconds and saves the OLED as PNG (512x256, pixels x4).
"""
import contextlib
import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time

WIDTH, HEIGHT, SCALE = 128, 64, 4
KEYS = {"up": "up", "down": "down", "left": "left", "right": "right", "a": "ctrl"}


class Oled:
    """A running image. Use it in a `with`."""

    def __init__(self, image, options=()):
        self.folder = tempfile.mkdtemp()
        self.seen, self.received = 0, b""
        qmp, serial = self.listen("qmp"), self.listen("serial")
        self.vm = subprocess.Popen(
            ["qemu-system-arm", "-M", "lm3s6965evb", "-display", "none", "-monitor", "none", "-chardev",
             f"socket,id=serial,path={self.folder}/serial", "-serial", "chardev:serial", "-qmp", f"unix:{self.folder}/qmp",
             "-kernel", image] + list(options), stdin=subprocess.DEVNULL)
        self.serial = self.accept(serial)
        self.listener = threading.Thread(target=self.hear)
        self.listener.start()
        connection = self.accept(qmp)
        connection.settimeout(30)
        self.stream = connection.makefile("rw")
        self.stream.readline()
        self.qmp("qmp_capabilities")

    def listen(self, name):
        server = socket.socket(socket.AF_UNIX)
        server.bind(os.path.join(self.folder, name))
        server.listen(1)
        server.settimeout(30)
        return server

    @staticmethod
    def accept(server):
        connection, _ = server.accept()
        server.close()
        return connection

    def hear(self):
        """Takes what comes from the serial line: the image's bytes would wait in its UART."""
        with contextlib.suppress(ConnectionResetError):
            while came := self.serial.recv(65536):
                self.received += came

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.vm.kill()
        self.vm.wait()
        self.listener.join()
        self.serial.close()
        shutil.rmtree(self.folder)

    def qmp(self, command, **arguments):
        self.stream.write(json.dumps({"execute": command, "arguments": arguments}) + "\n")
        self.stream.flush()
        while True:
            reply = json.loads(self.stream.readline())
            if "error" in reply:
                raise RuntimeError(f"{command}: {reply['error']['desc']}")
            if "return" in reply:
                return reply["return"]

    def type(self, text):
        """Sends text to the serial line."""
        self.serial.sendall(text.encode())

    def line(self, seconds=30):
        """The next whole line that the image has written, or None if none came."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            lines = self.received.decode("ascii").split("\n")[:-1]
            if len(lines) > self.seen:
                self.seen += 1
                return lines[self.seen - 1]
            time.sleep(.01)
        return None

    def key(self, name, down):
        event = {"type": "key", "data": {"down": down, "key": {"type": "qcode", "data": KEYS[name]}}}
        self.qmp("input-send-event", events=[event])

    def last(self, seconds):
        """The last line that has come when no other comes for so long, or None."""
        last = None
        while (line := self.line(seconds)) is not None:
            last = line
        return last

    def press(self, name):
        """Presses a key until a line answers, and releases it; returns the last line. A key that is released and pressed
        between two looks of an image that this machine gave no time was not seen, and is pressed again."""
        for _ in range(3):
            self.key(name, True)
            line = self.line(5)
            self.key(name, False)
            if line is not None:
                return self.last(.05) or line
            time.sleep(1)
        raise AssertionError(f"key {name}: no answer")

    def hold(self, names, seconds):
        """Holds keys; returns the line that tells of their end."""
        for name in names:
            self.key(name, True)
        time.sleep(seconds)
        for name in names:
            self.key(name, False)
        return self.line(10)

    def screen(self):
        """The OLED's pixels as 0..255, row by row; an AssertionError if a pixel is not one grey square."""
        path = os.path.join(self.folder, "screen.ppm")
        self.qmp("screendump", filename=path)
        with open(path, "rb") as file:
            magic, width, height, top = (file.readline() + file.readline() + file.readline()).split()
            data = file.read()
        assert (magic, int(width), int(height), int(top)) == (b"P6", WIDTH * SCALE, HEIGHT * SCALE, 255), "picture's form"
        row_bytes = 3 * WIDTH * SCALE
        pixels = []
        for y in range(HEIGHT):
            row = data[y * SCALE * row_bytes:][:row_bytes]
            for below in range(1, SCALE):
                assert row == data[(y * SCALE + below) * row_bytes:][:row_bytes], f"row {y} is not one"
            greys = row[::3 * SCALE]
            assert row == b"".join(bytes([grey]) * 3 * SCALE for grey in greys), f"row {y} has odd pixels"
            pixels += greys
        return pixels


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: oled.py IMAGE PICTURE.png")
    with Oled(sys.argv[1]) as oled:
        print(oled.line())
        time.sleep(3)
        oled.qmp("screendump", filename=os.path.abspath(sys.argv[2]), format="png")
        print(f"{sys.argv[2]}: what the OLED shows after 3 s")


if __name__ == "__main__":
    main()
