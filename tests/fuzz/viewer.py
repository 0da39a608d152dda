# SPDX-License-Identifier: MIT
"""What a viewer shows of any bytes, by PROTOCOL.md's text alone; compared with what glint-view shows of the corpus.

viewer.py VIEW CORPUS: of fuzz_view's inputs as they are, and of fuzz_unpack's bands, each in a stream around it."""
import os
import re
import struct
import subprocess
import sys
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "device"))
import stream  # noqa: E402

FORMATS = ("rgb565", "rgb888", "grey8", "grey4")


def row_bytes(form, width):
    return (width * stream.BITS[form] + 7) // 8


def possible(kind, width, height, form, codec, length):
    sized = 1 <= width <= 2048 and 1 <= height <= 2048 and form < 4
    if kind == stream.HELLO:
        return sized and 1 <= length <= 16384
    if kind == stream.BEGIN:
        return sized and length == 12
    if kind == stream.BAND:
        return sized and codec < 3 and 1 <= length <= row_bytes(form, width) * height
    if kind == stream.END:
        return length == 32
    return 1 <= length <= 1024 if kind == stream.LOG else length <= 65536


def messages(data):
    """As stream.messages(), but passing over what no device sends."""
    at = 0
    while (at := data.find(stream.MAGIC, at)) >= 0 and at + 32 <= len(data):
        head = struct.unpack_from("<BHIHHHHBB", data, at + 5)
        length, check = struct.unpack_from("<II", data, at + 24)
        crc = zlib.crc32(data[at:at + 28])
        end = at + 32 + (length + 4 if length else 0)
        payload = data[at + 32:at + 32 + length]
        if data[at + 4] == 1 and crc == check and possible(head[0], *head[5:], length) and end <= len(data) and \
                (not length or zlib.crc32(payload, crc) == struct.unpack_from("<I", data, end - 4)[0]):
            yield head, payload
            at = end
        else:
            at += 1


class Viewer:
    def __init__(self):
        self.last = None  # (width, height, format, number, pixels) of the picture before, if the next may refer to it
        self.frame = None  # the same of that under way, with its pixels so far
        self.due = None
        self.bands = 0

    def lose(self):
        self.last = self.frame = None

    def begin(self, head, payload):
        kind, number, self.key = (head[5], head[6], head[7]), *struct.unpack_from("<I4xB", payload)
        self.moment = struct.unpack_from("<I", payload, 4)[0]
        if self.frame:
            self.lose()
        follows = self.last and self.last[:3] == kind and number == (self.last[3] + 1) % 2 ** 32
        if not self.key & 1 and not follows:
            self.lose()
            return
        self.frame = (*kind, number, bytearray())
        self.bands = 0

    def band(self, head, payload):
        _, _, _, x, y, width, rows, form, codec = head
        full, height, kind, _, pixels = self.frame
        row = row_bytes(kind, full)
        size, at = row * rows, row * y
        if x or width != full or form != kind or at != len(pixels) or y + rows > height or codec == 2 and self.key & 1:
            return False
        if codec == 0:
            pixels += payload
            return len(payload) == size
        try:
            pixels += stream.unpack(form, payload, row, size, self.last[4][at:at + size] if codec == 2 else None)
        except (AssertionError, IndexError, struct.error):
            return False
        return True

    def take(self, head, payload):
        """A picture if there is one."""
        kind = head[0]
        if kind >= 0x81:
            return None
        if self.due is not None and head[1] != self.due:
            self.lose()
        self.due = (head[1] + 1) % 65536
        if kind == stream.HELLO and self.frame:
            self.lose()
        if kind == stream.BEGIN:
            self.begin(head, payload)
        if kind == stream.BAND and self.frame:
            self.bands += 1
            if not self.band(head, payload):
                self.lose()
        if kind != stream.END or not self.frame:
            return None
        width, height, form, number, pixels = self.frame
        if struct.unpack_from("<II", payload) != (number, self.bands) or len(pixels) != row_bytes(form, width) * height:
            self.lose()
            return None
        self.last, self.frame = (width, height, form, number, bytes(pixels)), None
        return f"{number}: {width}x{height} {FORMATS[form]}{', key' * (self.key & 1)}, moment {self.moment} ms " \
            f"crc {zlib.crc32(pixels):08X}"


def shown(data):
    viewer = Viewer()
    return [line for head, payload in messages(data) if (line := viewer.take(head, payload))]


def shown_by(view, path):
    said = subprocess.run([view, "file:" + path, "--headless", "--trace"], capture_output=True, text=True, timeout=60)
    lines = [re.sub(r"ms, .* crc", "ms crc", line) for line in said.stdout.splitlines() if " crc " in line]
    assert said.returncode == (0 if lines else 1), said.stderr
    return lines


def around(name, data):
    """A stream with a band of fuzz_unpack's: of codec 1, or 2 behind the picture that it refers to."""
    head = list(data[:4]) + [0] * (4 - len(data[:4]))
    form, width, rows, like, code = head[0] & 3, head[1] % 80 + 1, head[2] % 40 + 1, head[3], data[4:]
    size = row_bytes(form, width) * rows
    last = bytes((like + i * (like >> 5)) & 255 for i in range(size))
    frames = [(1, 0, last), (0, 2, code)] if head[0] & 4 else [(1, 1, code)]
    out, sequence = b"", 0
    for number, (key, codec, band) in enumerate(frames):
        for kind, payload in ((stream.BEGIN, struct.pack("<IIB3x", number, 0, key)), (stream.BAND, band),
                              (stream.END, struct.pack("<8I", number, 1, 0, 0, 0, 0, 0, 0))):
            front = struct.pack("<4sBBHI4HBBHI", stream.MAGIC, 1, kind, sequence, 0, 0, 0, width, rows, form,
                                codec if kind == stream.BAND else 0, 0, len(payload))
            crc = zlib.crc32(front)
            out += front + struct.pack("<I", crc) + payload + struct.pack("<I", zlib.crc32(payload, crc))
            sequence += 1
    with open(name, "wb") as file:
        file.write(out)
    return name


def compare(view, title, paths):
    pictures = different = 0
    for path in paths:
        with open(path, "rb") as file:
            mine = shown(file.read())
        if mine != shown_by(view, path):
            print(f"FAIL {title}: {path}: {mine} here, {shown_by(view, path)} there")
            different += 1
        pictures += len(mine)
    if not different and pictures >= 5:
        print(f"ok {title}: {len(paths)} streams, {pictures} pictures")
        return True
    print(f"FAIL {title}: {different} of {len(paths)} streams differ, {pictures} pictures")
    return False


def main(view, corpus):
    files = {target: sorted(os.path.join(corpus, target, name) for name in os.listdir(os.path.join(corpus, target)))
             for target in ("fuzz_view", "fuzz_unpack")}
    good = compare(view, "two decoders show the same of damaged streams", files["fuzz_view"])
    bands = []
    for path in files["fuzz_unpack"]:
        with open(path, "rb") as file:
            data = file.read()
        if len(data) > 4:
            bands.append(around(os.path.basename(path) + ".stream", data))
    return compare(view, "and of any bands", bands) and good


if __name__ == "__main__":
    sys.exit(not main(*sys.argv[1:]))
