#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The two forms in which an RP2040 takes a program.

  image.py boot2 BOOT2.bin BOOT2.s   the second stage, padded to 252 bytes and closed with the CRC that the ROM checks
  image.py uf2 IMAGE.bin IMAGE.uf2   a flash image as the blocks that are copied to the volume RPI-RP2
"""
import os
import struct
import sys

BOOT2_BYTES = 252
FLASH = 0x10000000
FLASH_BYTES = 16 << 20
UF2_MAGIC = (0x0A324655, 0x9E5D5157, 0x0AB16F30)
UF2_FAMILY_GIVEN = 0x2000
UF2_RP2040 = 0xE48BFF56
UF2_BYTES = 256


def crc32(data):
    """RP2040 datasheet 2.8.1.3.1: polynomial 04C11DB7, highest bit first, from FFFFFFFF, nothing inverted."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ (0x04C11DB7 if crc & 0x80000000 else 0)) & 0xFFFFFFFF
    return crc


def boot2(code):
    if not 0 < len(code) <= BOOT2_BYTES:
        raise ValueError(f"{len(code)} bytes do not make a second stage of 1 to {BOOT2_BYTES}")
    code = code.ljust(BOOT2_BYTES, b"\0")
    code += struct.pack("<I", crc32(code))
    return (".section .boot2, \"a\"\n.byte " + ", ".join(map(str, code)) + "\n").encode()


def uf2(image):
    if not 0 < len(image) <= FLASH_BYTES:
        raise ValueError(f"{len(image)} bytes do not fit the flash")
    count = -(-len(image) // UF2_BYTES)
    blocks = []
    for i in range(count):
        data = image[i * UF2_BYTES:(i + 1) * UF2_BYTES].ljust(UF2_BYTES, b"\0")
        head = struct.pack("<8I", *UF2_MAGIC[:2], UF2_FAMILY_GIVEN, FLASH + i * UF2_BYTES, UF2_BYTES, i, count, UF2_RP2040)
        blocks.append(head + data.ljust(476, b"\0") + struct.pack("<I", UF2_MAGIC[2]))
    return b"".join(blocks)


def main(argv):
    forms = {"boot2": boot2, "uf2": uf2}
    if len(argv) != 4 or argv[1] not in forms:
        print("usage: image.py boot2|uf2 IN OUT", file=sys.stderr)
        return 2
    try:
        with open(argv[2], "rb") as file:
            made = forms[argv[1]](file.read())
        with open(argv[3] + ".part", "wb") as file:
            file.write(made)
        os.replace(argv[3] + ".part", argv[3])
    except ValueError as error:
        print(f"{argv[2]}: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"{error.filename}: {error.strerror}", file=sys.stderr)
        return 3
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
