# SPDX-License-Identifier: MIT
"""Pictures of a panel as files."""
import struct
import zlib


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def wide(value, bits):
    """A channel's level as 0..255."""
    return value * 255 // ((1 << bits) - 1)


def png(path, pixels, width, greys):
    """RGB565, or greys of 4 bits."""
    height = len(pixels) // width
    if greys:
        rows = [bytes(17 * p for p in pixels[y * width:][:width]) for y in range(height)]
    else:
        rows = [b"".join(bytes((wide(p >> 11, 5), wide(p >> 5 & 63, 6), wide(p & 31, 5))) for p in pixels[y * width:][:width])
                for y in range(height)]
    head = struct.pack(">IIBBBBB", width, height, 8, 0 if greys else 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
                   chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows))) + chunk(b"IEND", b""))


def raw(pixels, greys):
    """The bytes of `glint render --output-format raw`: RGB565 low byte first, or the left pixel in the upper nibble."""
    if not greys:
        return struct.pack(f"<{len(pixels)}H", *pixels)
    return bytes(left << 4 | right for left, right in zip(pixels[::2], pixels[1::2]))
