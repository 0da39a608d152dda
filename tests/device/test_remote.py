# SPDX-License-Identifier: MIT
"""test_remote.py IMAGE GLINT GLINT-VIEW: the emulated OLED board's pictures over its serial line, and what it is asked for,
by glint-view on a pseudo-terminal and by requests made here."""
import os
import subprocess
import sys
import tempfile
import threading
import time
import tty

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import stream
from oled import HEIGHT, WIDTH, Oled

image, glint, view = sys.argv[1:4]
failed = 0
A, UP, LEFT = 16, 1, 4


def verdict(name, complaint):
    global failed
    failed += bool(complaint)
    print(f"FAIL remote: {name}: {complaint}" if complaint else f"ok remote: {name}", flush=True)


class Line:
    """The board's serial line as a pseudo-terminal."""

    def __init__(self, oled):
        self.oled, self.stop, self.at = oled, False, 0
        self.master, self.slave = os.openpty()
        tty.setraw(self.slave)
        self.path = os.ttyname(self.slave)
        self.threads = [threading.Thread(target=self.down), threading.Thread(target=self.up)]
        for thread in self.threads:
            thread.start()

    def down(self):
        while not self.stop:
            new = self.oled.received[self.at:]
            self.at += len(new)
            while new:
                new = new[os.write(self.master, new):]
            time.sleep(.002)

    def up(self):
        try:
            while data := os.read(self.master, 4096):
                self.oled.serial.sendall(data)
        except OSError:
            pass  # the terminal was closed

    def close(self):
        self.stop = True
        self.threads[0].join()
        os.close(self.slave)
        self.threads[1].join()
        os.close(self.master)


def method_options(method):
    if method.startswith("subdivide-"):
        return ["--method", "subdivide", "--subdivide", method[len("subdivide-"):]]
    if method.endswith("-perspective"):
        return ["--method", method[:-len("-perspective")], "--perspective"]
    return ["--method", method]


def host(scene, method, moment, tolerance, output):
    subprocess.run([glint, "render", f"tests/scenes/{scene}.json", "--format", "grey4", "--dither", "--size",
                    f"{WIDTH}x{HEIGHT}", "--time", str(moment), "--tolerance", str(tolerance), "-o", output]
                   + method_options(method), check=True)


def read(path):
    with open(path, "rb") as file:
        return file.read()


def ask(line, *options):
    """What glint-view says: exit code, output, complaints."""
    run = subprocess.run([view, line.path, "--headless"] + list(options), capture_output=True, text=True, timeout=60)
    return run.returncode, run.stdout, run.stderr


def compare(line, folder, scene, method, budget):
    """A picture that glint-view asks for against the host's."""
    code, out, err = ask(line, "--trace", "--dump", folder, "--frames", "1", "--scene", scene, "--method", method,
                         "--budget", str(budget), "--pause")
    if code != 0:
        return f"exit code {code}: {err}"
    moment = out.split("moment ")[1].split(" ")[0]
    host(scene, method, moment, budget, f"{folder}/host.png")
    return None if read(f"{folder}/host.png") == read(f"{folder}/frame-0000.png") else f"another picture: {out}"


def hear(oled, since, seconds=10):
    """The pictures that have come over the line after the first `since` bytes."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = list(stream.pictures(oled.received[since:]))
        if found:
            return found
        time.sleep(.01)
    return []


def send(oled, *requests):
    for kind, value in requests:
        oled.serial.sendall(stream.request(kind, value))
        time.sleep(.1)


def press(oled, *buttons):
    for button in buttons:
        send(oled, (stream.BUTTONS, button), (stream.BUTTONS, 0))


def levels(oled):
    return [pixel // 17 for pixel in oled.screen()]


def shown(pixels):
    return [grey for byte in pixels for grey in (byte >> 4, byte & 15)]


def by_requests(oled):
    send(oled, (stream.PAUSE, 1))
    since = len(oled.received)
    send(oled, (stream.KEY_PLEASE, 0))
    found = hear(oled, since)
    verdict("a key frame please is answered by one picture", None if len(found) == 1 else f"{len(found)}")
    first = shown(found[0][2]) if found else []
    verdict("which is the one on the display, figures and all", None if first == levels(oled) else "another one")
    hello = [payload for head, payload in stream.messages(oled.received[since:]) if head[0] == stream.HELLO]
    names = subprocess.run([glint, "methods"], capture_output=True, text=True, check=True).stdout
    methods = hello[0].split(b"\0\0")[1].decode().rstrip("\0").split("\0") if hello else []
    verdict(f"hello before it names {len(methods)} methods",
            None if len(methods) >= 10 and all(method.split("-")[0] in names for method in methods) else f"{hello}")
    press(oled, A, UP, UP, LEFT, A)  # the menu's line INFO: off
    since = len(oled.received)
    oled.serial.sendall(b"noise \xf6GLS" + stream.request(stream.KEY_PLEASE)[:20] + bytes(40) + b"\xf6")
    send(oled, (stream.KEY_PLEASE, 0))
    found = hear(oled, since)
    second = shown(found[0][2]) if found else []
    verdict("buttons open the menu and put the figures out", None if second and second != first else "no change")
    damaged = bytearray(stream.request(stream.SCENE, 3))
    damaged[12] ^= 1
    since = len(oled.received)
    oled.serial.sendall(damaged)
    send(oled, (stream.METHOD, 200), (stream.BUDGET, 0), (0xF0, 1), (stream.KEY_PLEASE, 0))
    found = hear(oled, since)
    verdict("a damaged request, and ones that ask for what is not there, do nothing",
            None if found and shown(found[0][2]) == second else "another picture")


def by_view(oled, folder):
    line = Line(oled)
    try:
        code, out, _ = ask(line, "--names", "--frames", "1")
        verdict("glint-view lists what the board has", None if code == 0 and "board lm3s6965evb\n" in out
                and "scene torus800\n" in out and "method phong\n" in out else out)
        for scene, method, budget in (("pawn", "phong", 4), ("torus800", "x", 9), ("teapot896", "gouraud", 4),
                                      ("sphere690", "biquadratic", 1), ("bulb", "subdivide-centre", 40)):
            verdict(f"{scene} by {method}, budget {budget}, is the host's picture",
                    compare(line, folder, scene, method, budget))
        code, out, err = ask(line, "--scene", "nowhere", "--frames", "1")
        verdict("a scene that it has not is named", None if code == 2 and err.count("\n") == 1 and "nowhere" in err else err)
        code, out, err = ask(line, "--run", "--trace", "--frames", "4")
        moments = [int(text.split("moment ")[1].split(" ")[0]) for text in out.splitlines() if "moment" in text]
        verdict(f"it goes on when told to: {moments}",
                None if code == 0 and len(moments) == 4 and len(set(moments)) == 4 and moments == sorted(moments) else err)
    finally:
        line.close()


with tempfile.TemporaryDirectory() as place, Oled(image) as board:
    verdict("starts", None if board.line() else "no line")
    by_requests(board)
    by_view(board, place)
sys.exit(failed != 0)
