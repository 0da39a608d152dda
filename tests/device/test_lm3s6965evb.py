# SPDX-License-Identifier: MIT
"""test_lm3s6965evb.py IMAGE GLINT: the OLED of the emulated board against the host's pictures of the same moments."""
import os
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from oled import HEIGHT, KEYS, WIDTH, Oled

image, glint = sys.argv[1:3]
failed = 0
TEXT_ROWS = 6  # of a line of figures


def verdict(name, complaint):
    global failed
    if complaint:
        failed += 1
    print(f"FAIL oled: {name}: {complaint}" if complaint else f"ok oled: {name}", flush=True)


def host(scene, method, moment):
    """The host's picture, as 0..15."""
    if method.startswith("subdivide-"):
        options = ["--method", "subdivide", "--subdivide", method[len("subdivide-"):]]
    elif method.endswith("-perspective"):
        options = ["--method", method[:-len("-perspective")], "--perspective"]
    else:
        options = ["--method", method]
    drawn = subprocess.run([glint, "render", f"tests/scenes/{scene}.json", "--format", "grey4", "--dither", "--size",
                            f"{WIDTH}x{HEIGHT}", "--time", moment, "--output-format", "raw", "-o", "-"] + options,
                           check=True, stdout=subprocess.PIPE).stdout
    assert len(drawn) == WIDTH * HEIGHT // 2
    return [grey for byte in drawn for grey in (byte >> 4, byte & 15)]


def levels(pixels):
    """What the screen dump shows, as 0..15: QEMU widens a level by 17."""
    assert all(pixel % 17 == 0 for pixel in pixels), "a grey that is none of 16"
    return [pixel // 17 for pixel in pixels]


def compare(oled, line, first=0, last=HEIGHT):
    """What differs between the OLED and the host's picture of the moment that `line` names."""
    if not line or not line.startswith("frame ") or line.endswith("running"):
        return f"the board says {line!r}"
    _, scene, method, moment = line.split()[:4]
    want, got = host(scene, method, moment), levels(oled.screen())
    if len(set(want)) < 3:
        return "the host's picture is empty"
    differ = [i for i in range(first * WIDTH, last * WIDTH) if want[i] != got[i]]
    return f"{len(differ)} pixels of {line} differ, the first at {divmod(differ[0], WIDTH)}" if differ else None


def prime(oled):
    """The machine's key lines are low until each key was released once."""
    for key in KEYS:
        oled.press(key, wait=False)


def pictures():
    with Oled(image) as oled:
        line = oled.line()
        verdict("starts with a scene, running", None if line and line.endswith("running") else f"{line!r}")
        prime(oled)
        line = oled.press("a")
        complaint = compare(oled, line, TEXT_ROWS, HEIGHT - TEXT_ROWS)
        verdict(f"stopped under figures: {line}", complaint)
        if not complaint:
            verdict("the figures are on the picture", None if compare(oled, line) else "no pixel differs")
        seen = [line]
        for keys in [("a", "up"), ("a", "right"), ("a", "right"), ("a", "left")] + [("right",)] * 8 + [("up",)] * 20:
            line = oled.press(*keys)
            verdict(f"after {'+'.join(keys)}: {line}", compare(oled, line))
            seen.append(line)
        scenes = {line.split()[1] for line in seen if line}
        methods = {line.split()[2] for line in seen if line}
        verdict(f"{len(scenes)} scenes, {len(methods)} methods", None if (len(scenes), len(methods)) == (8, 20) else "fewer")
        dropped = [line for line in seen if not line or "dropped" in line]
        verdict("every triangle found room", ", ".join(map(str, dropped)))
        moments = [line and line.split()[3] for line in seen[1:5]]
        good = int(moments[1]) - int(moments[0]) == 100 and moments[1] == moments[3]
        verdict("steps of 100 ms forth and back", None if good else f"{moments}")


def altered(folder, change):
    """A copy of the image with `change` made to its bytes."""
    with open(image, "rb") as file:
        data = bytearray(file.read())
    change(data)
    path = os.path.join(folder, "altered.elf")
    with open(path, "wb") as file:
        file.write(data)
    return path


def turn_scene_bit(data):
    # magic, then version, 0 and length; the same word also stands in the code that checks it
    at = data.find(b"GLT1")
    while struct.unpack_from("<HH", data, at + 4) != (1, 0) or struct.unpack_from("<I", data, at + 8)[0] > 1 << 16:
        at = data.index(b"GLT1", at + 1)
    data[at + 400] ^= 1


def start_undefined(data):
    # the first segment lies at address 0; its first instruction to run becomes an undefined one
    entry, header = struct.unpack_from("<II", data, 24)
    struct.pack_into("<H", data, struct.unpack_from("<I", data, header + 4)[0] + (entry & ~1), 0xDE00)


def fault():
    with tempfile.TemporaryDirectory() as folder, Oled(altered(folder, start_undefined)) as oled:
        line = oled.line(10)
        verdict(f"a fault is told on the serial line: {line}", None if line and line.startswith("fault ") else f"{line!r}")


def damaged():
    """One bit of the first scene's blob is turned over."""
    with tempfile.TemporaryDirectory() as folder, Oled(altered(folder, turn_scene_bit)) as oled:
        line = oled.line()
        verdict(f"a damaged scene is told on the serial line: {line}",
                None if line and line.startswith("error ") else f"{line!r}")
        prime(oled)
        shown = levels(oled.screen())
        verdict("and on the screen, in black and white",
                None if set(shown) == {0, 15} and shown.count(15) > 50 else f"{sorted(set(shown))}")
        told = line.split()[1].rstrip(":") if line else None
        lines = [oled.press("a"), oled.press("a", "up"), oled.press("right")]
        verdict(f"the next scene is drawn: {lines[-1]}",
                compare(oled, lines[-1]) if lines[-1] and lines[-1].split()[1] != told else f"{lines}")


pictures()
damaged()
fault()
sys.exit(failed != 0)
