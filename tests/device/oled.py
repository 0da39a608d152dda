# SPDX-License-Identifier: MIT
"""QEMU's lm3s6965evb from outside: its serial line, its keys and what its OLED shows.

As a program: oled.py IMAGE PICTURE runs an image for three seconds and saves the OLED as PNG (512x256, pixels x4).
"""
import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time

WIDTH, HEIGHT, SCALE = 128, 64, 4
KEYS = {"up": "up", "down": "down", "left": "left", "right": "right", "a": "ctrl"}


class Oled:
    """A running image. Use it in a `with`."""

    def __init__(self, image, options=()):
        self.folder = tempfile.mkdtemp()
        self.serial = os.path.join(self.folder, "serial")
        self.seen = 0
        path = os.path.join(self.folder, "qmp")
        server = socket.socket(socket.AF_UNIX)
        server.bind(path)
        server.listen(1)
        server.settimeout(30)
        self.vm = subprocess.Popen(
            ["qemu-system-arm", "-M", "lm3s6965evb", "-display", "none", "-monitor", "none", "-chardev",
             f"socket,id=serial,path={self.serial}.in,server=on,wait=off,logfile={self.serial}", "-serial", "chardev:serial", "-qmp", f"unix:{path}", "-kernel", image]
            + list(options), stdin=subprocess.DEVNULL)
        connection, _ = server.accept()
        connection.settimeout(30)
        server.close()
        self.stream = connection.makefile("rw")
        self.stream.readline()
        self.qmp("qmp_capabilities")
        self.input = socket.socket(socket.AF_UNIX)
        self.input.connect(f"{self.serial}.in")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.input.close()
        self.vm.kill()
        self.vm.wait()
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
        """Sends text to the serial line, and takes what has come from there so that it never fills up."""
        self.input.setblocking(False)
        try:
            while self.input.recv(65536):
                pass
        except BlockingIOError:
            pass
        self.input.setblocking(True)
        self.input.sendall(text.encode())

    def line(self, seconds=30):
        """The next whole line that the image has written, or None if none came."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            with open(self.serial, encoding="ascii", newline="\n") as serial:
                lines = serial.read().split("\n")[:-1]
            if len(lines) > self.seen:
                self.seen += 1
                return lines[self.seen - 1]
            time.sleep(.01)
        return None

    def key(self, name, down):
        event = {"type": "key", "data": {"down": down, "key": {"type": "qcode", "data": KEYS[name]}}}
        self.qmp("input-send-event", events=[event])

    def press(self, *names, wait=True):
        """Presses keys one after the other, releases them in reverse order; returns the line that answers."""
        for name in names:
            self.key(name, True)
            time.sleep(.1)
        for name in reversed(names):
            self.key(name, False)
            time.sleep(.1)
        return self.line(10) if wait else None

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
