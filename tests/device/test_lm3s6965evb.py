# SPDX-License-Identifier: MIT
"""test_lm3s6965evb.py IMAGE GLINT: the OLED of the emulated board against the host's pictures of the same moments."""
import os
import struct
import sys
import tempfile
import time
import zlib

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from oled import HEIGHT, WIDTH, Oled
from told import Told, host, stack_complaint

image, glint = sys.argv[1:3]
failed = 0
TEXT_ROWS = 6  # of a line of text
MENU_LINES, MENU_WIDTH = 8, 19 * 4  # "screen redraw/test "


def verdict(name, complaint):
    global failed
    if complaint:
        failed += 1
    print(f"FAIL oled: {name}: {complaint}" if complaint else f"ok oled: {name}", flush=True)


def levels(pixels):
    """What the screen dump shows, as 0..15: QEMU widens a level by 17."""
    assert all(pixel % 17 == 0 for pixel in pixels), "a grey that is none of 16"
    return [pixel // 17 for pixel in pixels]


def compare(oled, told, inside=lambda x, y: True):
    """What differs between the OLED and the host's picture of the moment that the board told of."""
    if told.running:
        return "it is not stopped"
    drawn = host(glint, told, (WIDTH, HEIGHT), ["--format", "grey4", "--dither"])
    want, got = [grey for byte in drawn for grey in (byte >> 4, byte & 15)], levels(oled.screen())
    if len(set(want)) < 3:
        return "the host's picture is empty"
    differ = [(i % WIDTH, i // WIDTH) for i in range(WIDTH * HEIGHT) if want[i] != got[i]]
    differ = [place for place in differ if inside(*place)]
    return f"{len(differ)} pixels differ, the first at {differ[0]}" if differ else None


def menu_line(line):
    return next((clause[len("menu "):] for clause in line.split(", ") if clause.startswith("menu ")), None)


def choose(oled, wanted):
    """Opens the menu, goes to that line."""
    line = oled.press("a")
    for _ in range(2 * MENU_LINES):
        if menu_line(line) == wanted:
            return
        line = oled.press("down")
    raise AssertionError(f"the menu has no line {wanted}: {line}")


def change(oled, menu, key):
    """Changes a line of the menu by a key and closes it; the board's last line."""
    choose(oled, menu)
    oled.press(key)
    return oled.press("a")


def shows(oled, name, line):
    """The picture that the line tells of is the host's; what is told of it."""
    told = Told(line)
    verdict(f"{name}: {line}", compare(oled, told))
    return told


def below_figures(_x, y):
    return TEXT_ROWS <= y < HEIGHT - TEXT_ROWS


def figures_and_menu(oled):
    told = Told(change(oled, "motion", "left"))
    verdict(f"stopped under figures: {told.line}", compare(oled, told, below_figures))
    verdict("the figures are on the picture", None if compare(oled, told) else "no pixel differs")
    choose(oled, "info")
    told = Told(oled.press("left"))
    menu = [(x, y) for x in range(MENU_WIDTH) for y in range(TEXT_ROWS - 1, (MENU_LINES + 1) * TEXT_ROWS)]
    covered = set(menu)
    verdict("beside the menu is the picture", compare(oled, told, lambda x, y: (x, y) not in covered))
    shown = levels(oled.screen())
    words = [shown[y * WIDTH + x] for x, y in menu if y >= TEXT_ROWS]
    verdict("the menu is black and white", None if set(words) == {0, 15} else f"{sorted(set(words))}")
    chosen = [shown[y * WIDTH + x] for x, y in menu if y // TEXT_ROWS == 7]
    verdict("with the chosen line inverted", None if chosen.count(15) > chosen.count(0) else "it is not")
    shows(oled, "after the menu", oled.press("a"))


def bytes_sent(oled):
    choose(oled, "screen")
    sent = [Told(oled.press(key)).bytes for key in ("left", "up", "down")]
    whole = WIDTH * HEIGHT // 2
    good = sent[0] > whole and sent[1] < whole / 2 and sent[2] < whole / 2
    verdict(f"{sent} bytes are sent for the whole picture and for two lines of the menu", None if good else "not so")
    shows(oled, "after it was sent whole", oled.press("a"))


def steps(oled):
    lines = [change(oled, "time", key) for key in ("right", "right", "left")]
    moments = [int(Told(line).moment) for line in lines]
    good = moments[1] - moments[0] == 100 == moments[1] - moments[2]
    verdict("steps of 100 ms forth and back", None if good else f"{moments}")
    shows(oled, "after them", lines[-1])


def turns(oled):
    told = None
    for keys in (["right"], ["up"], ["left", "up"], ["down"]):
        told = shows(oled, f"turned by {'+'.join(keys)}", oled.hold(keys, .4))
    before = [float(angle) for angle in told.turn.split(",")]
    # how far is a matter of when this machine lets the emulator see the key; test_control.c has the quarter turn a second
    after = [float(angle) for angle in Told(oled.hold(["right"], .5)).turn.split(",")]
    verdict("a key held turns about one axis", None if before[0] != after[0] and before[1] == after[1] else str(after))


def scenes_and_methods(oled):
    seen = [shows(oled, "the next scene", change(oled, "scene", "right")) for _ in range(8)]
    seen += [shows(oled, "the next method", change(oled, "method", "right")) for _ in range(21)]
    scenes, methods = {told.scene for told in seen}, {told.method for told in seen}
    verdict(f"{len(scenes)} scenes, {len(methods)} methods", None if (len(scenes), len(methods)) == (8, 21) else "fewer")
    dropped = [told.line for told in seen if told.dropped]
    verdict("every triangle found room", ", ".join(dropped))
    while Told(line := change(oled, "method", "left")).method != "subdivide-centre":
        pass
    for _ in range(3):
        told = shows(oled, "a larger budget", change(oled, "budget", "right"))
    verdict("is 12/255 in the end", None if told.budget == "12" else told.line)


def display_test(oled):
    choose(oled, "screen")
    oled.key("right", True)
    line = oled.line(10)
    verdict("the test is told", None if line and line.startswith("test lm3s6965evb 128x64, rotation 0, menu screen, ") else line)
    time.sleep(.1)
    shown = levels(oled.screen())
    edge = [shown[y * WIDTH + x] for y in range(HEIGHT) for x in range(WIDTH) if x in (0, WIDTH - 1) or y in (0, HEIGHT - 1)]
    verdict("around its picture is a line", None if set(edge) == {15} else "broken")
    ramp = shown[(HEIGHT - 5) * WIDTH + 1:(HEIGHT - 4) * WIDTH - 1]
    verdict("and below a ramp of 16 greys", None if ramp == sorted(ramp) and set(ramp) == set(range(16)) else f"{ramp}")
    oled.key("right", False)
    oled.line(10)
    shows(oled, "after it", oled.press("a"))


def pictures():
    with Oled(image) as oled:
        told = Told(oled.line())
        verdict("starts with a scene, running", None if told.running else told.line)
        verdict("no key seems held at the start", oled.last(.3))
        figures_and_menu(oled)
        bytes_sent(oled)
        steps(oled)
        turns(oled)
        scenes_and_methods(oled)
        display_test(oled)
    complaint = stack_complaint("lm3s6965evb", image, Told.stack)
    verdict(f"{Told.stack} bytes of stack are 90 to 100 % of the bound", complaint)


def altered(folder, change):
    """A copy of the image with `change` made to its bytes."""
    with open(image, "rb") as file:
        data = bytearray(file.read())
    change(data)
    path = os.path.join(folder, "altered.elf")
    with open(path, "wb") as file:
        file.write(data)
    return path


def scene_in(data):
    # magic, then version, 0 and length; the same word also stands in the code that checks it
    at = data.find(b"GLT1")
    while struct.unpack_from("<HH", data, at + 4) != (2, 0) or struct.unpack_from("<I", data, at + 8)[0] > 1 << 16:
        at = data.index(b"GLT1", at + 1)
    return at


def turn_scene_bit(data):
    data[scene_in(data) + 400] ^= 1


def want_fog(data):
    """The first scene says that it needs fog, which no scene of the board has (struct scene_header: effects)."""
    at = scene_in(data)
    length, = struct.unpack_from("<I", data, at + 8)
    data[at + 60] |= 4
    struct.pack_into("<I", data, at + 12, zlib.crc32(data[at + 16:at + length]))


def damaged(change_scene, reason):
    """The first scene's blob is not one that can be drawn."""
    with tempfile.TemporaryDirectory() as folder, Oled(altered(folder, change_scene)) as oled:
        line = oled.line()
        verdict(f"a scene that cannot be drawn is told on the serial line: {line}",
                None if line and line.startswith("error ") and reason in line else f"{line!r}")
        shown = levels(oled.screen())
        verdict("and on the screen, in black and white",
                None if set(shown) == {0, 15} and shown.count(15) > 50 else f"{sorted(set(shown))}")
        broken = line.split()[1].rstrip(":") if line else None
        change(oled, "motion", "left")
        change(oled, "info", "left")
        told = shows(oled, "the next scene is drawn", change(oled, "scene", "right"))
        verdict("and is another", None if told.scene != broken else told.line)


pictures()
damaged(turn_scene_bit, "damaged")
damaged(want_fog, "compiled without")
sys.exit(failed != 0)
