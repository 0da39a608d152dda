#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""film.py FILE: a line `MS CRC WIDTHxHEIGHT+X+Y` for each picture of an animated PNG of 8-bit samples: how long it is
shown, the CRC-32 of what is seen then, and the part of it that the file holds. Ends with 1 at anything that the PNG
specification (third edition) does not have so."""
import struct
import sys
import zlib


def chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    at = 8
    while at < len(data):
        length, = struct.unpack_from(">I", data, at)
        kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        check, = struct.unpack_from(">I", data, at + 8 + length)
        assert check == zlib.crc32(kind + body), "a chunk's CRC"
        at += 12 + length
        yield kind, body
    assert kind == b"IEND", "no end"


def paeth(left, above, corner):
    guess = left + above - corner
    return min((left, above, corner), key=lambda one: abs(guess - one))


def rows(packed, width, height, samples):
    """Of bytes, with their filters undone."""
    data, size = zlib.decompress(packed), width * samples
    assert len(data) == (size + 1) * height, "not its size"
    above = bytes(size)
    for y in range(height):
        kind, *row = data[y * (size + 1):(y + 1) * (size + 1)]
        for i in range(size):
            left, corner = (row[i - samples], above[i - samples]) if i >= samples else (0, 0)
            row[i] = row[i] + (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[kind] & 255
        yield bytes(row)
        above = row


def pictures(data):
    frames, sequence, packed = [], 0, {}
    for kind, body in chunks(data):
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack_from(">IIBB", body)
            assert depth == 8 and colour in (0, 2) and body[10:] == bytes(3), "not 8 bits grey or colour"
        elif kind == b"acTL":
            count, plays = struct.unpack(">II", body)
        elif kind in (b"fcTL", b"fdAT"):
            assert struct.unpack_from(">I", body)[0] == sequence, "sequence"
            sequence += 1
        if kind == b"fcTL":
            frames.append(struct.unpack_from(">IIIIHHBB", body, 4))
        if kind in (b"IDAT", b"fdAT"):
            here = len(frames) - 1
            assert here >= 0 and (kind == b"IDAT") == (here == 0), "data of no picture"
            packed[here] = packed.get(here, b"") + body[0 if kind == b"IDAT" else 4:]
    assert count == len(frames) == len(packed) and plays == 0, "not as many pictures as it says"
    samples = 3 if colour == 2 else 1
    shown = bytearray(width * height * samples)
    for i, (w, h, x, y, part, whole, dispose, blend) in enumerate(frames):
        assert 0 < w <= width - x and 0 < h <= height - y and (i or (w, h) == (width, height)), "a part outside"
        assert (whole, dispose, blend) == (1000, 0, 0), "not milliseconds, or not only replaced"
        for k, row in enumerate(rows(packed[i], w, h, samples)):
            at = ((y + k) * width + x) * samples
            shown[at:at + len(row)] = row
        yield part, zlib.crc32(shown), (w, h, x, y)


if __name__ == "__main__":
    try:
        with open(sys.argv[1], "rb") as file:
            for milliseconds, crc, part in pictures(file.read()):
                print("%d %08x %dx%d+%d+%d" % (milliseconds, crc, *part))
    except (AssertionError, OSError, struct.error, zlib.error) as problem:
        sys.exit("%s: %s" % (sys.argv[1], problem))
