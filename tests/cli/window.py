# SPDX-License-Identifier: MIT
"""window.py GLINT SCENE DECODER-FOLDER: glint-view's window on an X screen, held pixel by pixel against the host's pictures.
Runs in an empty folder. Prints a line a case, `ok` or `FAIL`."""
import os
import re
import select
import struct
import subprocess
import sys
import threading
import time
import tty
import zlib

from xscreen import Screen, Window, wait_for

glint, scene = sys.argv[1:3]
sys.path.insert(0, sys.argv[3])
import letters  # noqa: E402
import stream  # noqa: E402

WIDTH, HEIGHT, FRAMES = 61, 45, 6
view = glint + "-view"


def verdict(name, problem=None):
    print(f"FAIL {name}: {' '.join(str(problem).split())}" if problem else f"ok {name}", flush=True)


def read(path):
    with open(path, "rb") as file:
        return file.read()


def widened(path, samples):
    """The pictures of a file of PPM or PGM, as RGB."""
    data, size = read(path), WIDTH * HEIGHT * samples
    head = len(data) // FRAMES - size
    pictures = [data[(head + size) * i + head:][:size] for i in range(FRAMES)]
    return pictures if samples == 3 else [bytes(v for v in picture for _ in range(3)) for picture in pictures]


def enlarged(picture, width, scale, turns=0):
    """RGB rows turned clockwise and enlarged."""
    rows = [[picture[3 * (y * width + x):][:3] for x in range(width)] for y in range(len(picture) // 3 // width)]
    for _ in range(turns):
        rows = [list(column) for column in zip(*rows[::-1])]
    return b"".join(b"".join(pixel * scale for pixel in row) * scale for row in rows)


def marks():
    """What the window writes, by its five octal digits."""
    known, sources = letters.glyphs(), os.path.dirname(letters.SOURCE) + "/../.."
    for path, pattern in ((letters.SOURCE, r"case '(.)':\s+return (0[0-7]+)"),
                          (f"{sources}/host-tools/view/overlay.c", r"\{'(\\?.)', (0[0-7]+)\}")):
        known.update({int(number, 8): mark[-1] for mark, number in re.findall(pattern, read(path).decode())})
    return known


def words(window, known):
    """The lines at the window's top."""
    _, _, width, height = window.place()
    pixels, scale, lines = window.pixels(), max(1, min(width, height) // 240), []
    for y in range(2, height // scale - 7, 7):
        bits = [int("".join(str(int(pixels[3 * scale * ((y + i) * width + x + j):][:3] == b"\xff\xff\xff"))
                            for i in range(5) for j in range(3)), 2) for x in range(2, width // scale - 3, 4)]
        lines.append("".join(known.get(b, "\0") for b in bits).split("\0")[0].strip())  # the box ends before the line does
    return lines[:lines.index("")] if "" in lines else lines


class View:
    """glint-view with a window; ends with the block."""

    def __init__(self, screen, *words, stdin=subprocess.DEVNULL):
        self.run = subprocess.Popen([view, *words], env=screen.environment, stdin=stdin, stdout=subprocess.PIPE,
                                    stderr=subprocess.PIPE)
        self.window = Window(screen, self.run.pid)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.run.poll() is None:
            self.run.kill()
        self.run.communicate()

    def shows(self, want):
        return bool(wait_for(lambda: self.window.pixels() == want))

    def feed(self, data):
        """Through its pipe; None: no more."""
        try:
            if data is None:
                self.run.stdin.close()
                self.run.stdin = None
            else:
                self.run.stdin.write(data)
                self.run.stdin.flush()
        except BrokenPipeError:
            self.run.stdin = None
            verdict("the viewer reads its pipe", self.ends())

    def ends(self):
        """Exit code and what was said, once it has been told to end."""
        try:
            out, err = self.run.communicate(timeout=30)
        except subprocess.TimeoutExpired:
            return "does not end", "", ""
        return self.run.returncode, out.decode(), err.decode()


def render(name, frames, form):
    """Pictures of the scene as NAME.stream and as the host shows them."""
    words = [glint, "render", scene, "--size", f"{WIDTH}x{HEIGHT}", "--fps", "10", "--format", form, "--frames", str(frames)]
    kind = "pgm" if form.startswith("grey") else "ppm"
    for output in ("--stream", f"{name}.stream"), ("-o", f"{name}.{'ppm'}"), ("-o", f"{name}/"):
        subprocess.run(words + list(output), check=True)
    return widened(f"{name}.ppm", 1 if kind == "pgm" else 3)


def every_scale_and_rotation_is_exact(screen, pictures):
    last = pictures[-1]
    with View(screen, "file:rgb565.stream", "--scale", "2") as run:
        run.window.keys("o")
        for turns in range(4):
            for scale in range(1, 7):
                run.window.keys(scale)
                verdict(f"scale {scale}, {90 * turns} degrees", None if run.shows(enlarged(last, WIDTH, scale, turns))
                        else f"other pixels: {run.window.place()}")
            run.window.keys("r")
        run.window.keys("shift+r")
        verdict("and back again", None if run.shows(enlarged(last, WIDTH, 6, 3)) else "other pixels")
        verdict("the title says what is shown", None if run.window.title().startswith(f"glint, {WIDTH}x{HEIGHT}, ")
                else run.window.title())
        run.window.keys("q")
        code, out, err = run.ends()
        verdict("q ends it", None if code == 0 and not err and out.startswith(f"{FRAMES} pictures, ") else f"{code}: {out}{err}")


def options_say_how_it_begins(screen, pictures):
    with View(screen, "file:grey4.stream", "--scale", "3", "--rotate", "270") as run:
        run.window.keys("o")
        verdict("--scale and --rotate, in greys", None if run.shows(enlarged(pictures[-1], WIDTH, 3, 3)) else "other pixels")
        run.window.close()
        code, _, err = run.ends()
        verdict("a closed window ends it", None if code == 0 and not err else f"{code}: {err}")


def words_lie_over_the_picture(screen, pictures):
    plain = enlarged(pictures[-1], WIDTH, 6)
    half, white = len(plain) // 2, b"\xff\xff\xff"
    with View(screen, "file:rgb565.stream", "--scale", "6") as run:
        for keys, what, low, high in ((), "figures stand at the top", 100, 500), (("shift+o",), "and all of them", 500, half):
            run.window.keys(*keys)
            good = wait_for(lambda: run.window.pixels()[half:half + 3000] == plain[half:half + 3000] and
                            low < run.window.pixels()[:half].count(white) < high)
            verdict(what, None if good else "no figures, or another picture below")
        run.window.keys("h")
        good = wait_for(lambda: run.window.pixels()[half - 60000:half + 60000].count(white) > 500)
        verdict("the keys in the middle", None if good else "no words")
        run.window.keys("h", "o")
        verdict("and both go again", None if run.shows(plain) else "other pixels")
        run.window.keys("w")
        good = wait_for(lambda: os.path.exists("window-0000.png"))
        verdict("the window is saved", None if good and read("window-0000.png")[16:24] == b"\0\0\1\x6e\0\0\1\x0e" else "no file of its size")


def pictures_are_saved_as_drawn(screen, pictures):
    with open("picture-0000.png", "w", encoding="ascii") as file:
        file.write("mine")
    with View(screen, "file:rgb565.stream", "--scale", "2") as run:
        run.window.keys("o")
        run.shows(enlarged(pictures[-1], WIDTH, 2))
        run.window.keys("s")
        wait_for(lambda: os.path.exists("picture-0001.png"))
        run.window.keys("s")
        wait_for(lambda: os.path.exists("picture-0002.png"))
        run.window.keys("q")
        code, _, err = run.ends()
    want, files = read(f"rgb565/frame-{FRAMES - 1:04}.png"), [f"picture-000{i}.png" for i in (1, 2)]
    verdict("s saves the picture bit for bit", None if [read(f) for f in files] == [want, want] else "another file")
    verdict("and overwrites none", None if code == 0 and not err and read("picture-0000.png") == b"mine" else f"{code}: {err}")


def one_picture_after_another(screen, pictures):
    data = read("rgb565.stream")
    with View(screen, "-", "--scale", "4", stdin=subprocess.PIPE) as run:
        run.window.keys("o")
        mark = stream.picture(b"", 1, 1, 0)[:6]  # of a picture's begin
        head = data.index(mark, data.index(mark) + 1)
        run.feed(data[:head])
        good = run.shows(enlarged(pictures[0], WIDTH, 4))
        verdict("what has come of a pipe is shown", None if good else "other pixels")
        run.window.keys("space")
        run.feed(data[head:])
        run.feed(None)
        for i in range(1, 4):
            run.window.keys("period")
            verdict(f"step {i}", None if run.shows(enlarged(pictures[i], WIDTH, 4)) else "another picture")
        run.window.keys("v", "space")
        verdict("and it goes on to its end", None if run.shows(enlarged(pictures[-1], WIDTH, 4)) else "another picture")
        run.window.keys("v")
        wait_for(lambda: os.path.exists("recording-0000.png"))
        run.window.keys("q")
        code, _, err = run.ends()
    frames = read("recording-0000.png").split(b"acTL")[1][:4] if os.path.exists("recording-0000.png") else b""
    verdict("v records what came in between", None if code == 0 and not err and frames[3:] in (b"\1", b"\2") else f"{frames} {code}: {err}")


def another_size_makes_another_window(screen, pictures):
    subprocess.run([glint, "render", scene, "--size", "20x30", "--format", "grey4", "--stream", "small.stream", "--frames", "1"],
                   check=True)
    subprocess.run([glint, "render", scene, "--size", "20x30", "--format", "grey4", "-o", "small.ppm"], check=True)
    small = bytes(v for v in read("small.ppm")[-600:] for _ in range(3))
    with View(screen, "-", "--scale", "4", stdin=subprocess.PIPE) as run:
        run.window.keys("o")
        run.feed(read("rgb565.stream"))
        run.shows(enlarged(pictures[-1], WIDTH, 4))
        run.feed(read("small.stream"))
        verdict("pictures of another size", None if run.shows(enlarged(small, 20, 4)) else f"other pixels: {run.window.place()}")


def heard(picture, sequence):
    """A picture whose begin says that the device has heard a request."""
    head = picture[:12] + struct.pack("<H", sequence) + picture[14:28]
    crc = zlib.crc32(head)
    return head + struct.pack("<I", crc) + picture[32:44] + struct.pack("<I", zlib.crc32(picture[32:44], crc)) + picture[48:]


class Device(threading.Thread):
    """One on a serial line, that shows white and does what it is asked for."""

    def __init__(self):
        super().__init__()
        self.master, self.slave = os.openpty()
        tty.setraw(self.slave)
        self.asked, self.gone = [], False
        self.is_now = {stream.SCENE: 0, stream.METHOD: 0, stream.BUDGET: 4, stream.PAUSE: 0}

    def run(self):
        hello = b"board\0first\0second\0third\0\0one\0two\0"
        data, sequence = b"", 0
        while not self.gone:
            if not select.select([self.master], [], [], .02)[0]:
                continue
            data += os.read(self.master, 4096)
            for at in range(0, len(data) - 31, 32):
                kind, value = data[at + 5], data[at + 12]
                if kind in self.is_now:
                    self.is_now[kind] = value
                if kind == stream.KEY_PLEASE:
                    white = b"\xff" * (2 * WIDTH * HEIGHT)
                    picture = stream.picture(white, WIDTH, HEIGHT, sequence + 1, 0, *self.is_now.values())
                    picture = heard(picture, data[at + 6] | data[at + 7] << 8)
                    os.write(self.master, stream.message(stream.HELLO, hello, sequence, WIDTH, HEIGHT) + picture)
                    sequence = (sequence + 4) % 65536
                    time.sleep(.02)
                else:
                    self.asked.append((kind, value))
            data = data[len(data) // 32 * 32:]
        os.close(self.slave)
        os.close(self.master)

    def hears(self, kind, value, times=1):
        return wait_for(lambda: self.asked.count((kind, value)) >= times)


def keys_are_the_device_s_buttons(screen):
    device = Device()
    device.start()
    with View(screen, os.ttyname(device.slave), "--scale", "4") as run:
        known = marks()
        good = wait_for(lambda: re.search(r"\n[1-9]\d*\.\d PICTURES/S, LATENCY \d+\.\d MS\n", "\n".join(words(run.window, known))))
        verdict("figures of a device, with its latency", None if good else words(run.window, known))
        verdict("and what it shows", None if "FIRST BY ONE, BUDGET 4/255" in words(run.window, known) else words(run.window, known))
        run.window.keys("o")
        white = b"\xff" * (3 * 16 * WIDTH * HEIGHT)
        verdict("a device on a line is shown", None if run.shows(white) else "other pixels")
        screen.tool("keydown", "Right")
        verdict("a key is held and told again", None if device.hears(stream.BUTTONS, 8, 3) else device.asked)
        screen.tool("keydown", "a")
        verdict("so are two", None if device.hears(stream.BUTTONS, 24) else device.asked)
        screen.tool("keyup", "a", "keyup", "Right")
        device.asked.clear()
        verdict("and let go", None if device.hears(stream.BUTTONS, 0) else device.asked)
        for key, kind, value in (("m", stream.METHOD, 1), ("Next", stream.SCENE, 1), ("minus", stream.BUDGET, 3),
                                 ("p", stream.PAUSE, 1), ("shift+m", stream.METHOD, 0), ("Prior", stream.SCENE, 0),
                                 ("Prior", stream.SCENE, 2)):
            run.window.keys(key)
            verdict(f"{key} asks for another", None if device.hears(kind, value) else device.asked)
            wait_for(lambda: device.is_now[kind] == value)
            time.sleep(.2)  # a picture shows it
        device.gone = True
        device.join()
        good = wait_for(lambda: run.window.pixels()[:3000] == b"\x50" * 3000)
        verdict("a device that goes leaves its picture, darkened", None if good else run.window.pixels()[:6])
        run.window.keys("q")
        code, _, err = run.ends()
        verdict("which stays until it is closed", None if code == 0 and not err else f"{code}: {err}")


def a_screen_that_goes_takes_no_recording_with_it(screen, pictures):
    before = set(os.listdir("."))
    with View(screen, "-", "--record", "kept.png", "--save", "kept.stream", "--scale", "4", stdin=subprocess.PIPE) as run:
        run.window.keys("o")
        run.feed(read("rgb565.stream"))
        run.shows(enlarged(pictures[-1], WIDTH, 4))
        screen.close()
        run.ends()
    verdict("a screen that goes takes no recording with it",
            None if set(os.listdir(".")) - before == {"kept.png", "kept.stream"} and read("kept.png").endswith(b"IEND\xaeB\x60\x82") and
            read("kept.stream") == read("rgb565.stream") else set(os.listdir(".")) - before)


def main():
    folder = os.getcwd() + "/screen"
    os.mkdir(folder)
    screen = Screen(folder, 800)
    try:
        pictures, greys = render("rgb565", FRAMES, "rgb565"), render("grey4", FRAMES, "grey4")
        every_scale_and_rotation_is_exact(screen, pictures)
        options_say_how_it_begins(screen, greys)
        words_lie_over_the_picture(screen, pictures)
        pictures_are_saved_as_drawn(screen, pictures)
        one_picture_after_another(screen, pictures)
        another_size_makes_another_window(screen, pictures)
        keys_are_the_device_s_buttons(screen)
        a_screen_that_goes_takes_no_recording_with_it(screen, pictures)
    finally:
        screen.close()


main()
