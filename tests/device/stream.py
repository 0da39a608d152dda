# SPDX-License-Identifier: MIT
"""Streams as firmware/stream/PROTOCOL.md has them, read and asked for in Python, from that text alone."""
import struct
import zlib

MAGIC = b"\xf6GLS"
BITS = (16, 24, 8, 4)
HELLO, BEGIN, BAND, END, LOG = 1, 2, 3, 4, 5
KEY_PLEASE, BUTTONS, METHOD, BUDGET, SCENE, PAUSE = range(0x81, 0x87)


def request(kind, value=0, sequence=0):
    head = struct.pack("<4sBBHII12xI", MAGIC, 1, kind, sequence, 0, value, 0)[:28]
    return head + struct.pack("<I", zlib.crc32(head))


def message(kind, payload, sequence, width=0, height=0):
    """From a device; what is not said is 0."""
    head = struct.pack("<4sBBHI4HBBHI", MAGIC, 1, kind, sequence, 0, 0, 0, width, height, 0, 0, 0, len(payload))
    crc = zlib.crc32(head)
    return head + struct.pack("<I", crc) + payload + struct.pack("<I", zlib.crc32(payload, crc))


def picture(pixels, width, height, sequence, number=0, scene=0, method=0, budget=4, paused=0):
    """A key frame of RGB565 pixels in one band: three messages."""
    begin = struct.pack("<II4B", number, 0, 1 | paused << 1, scene, method, budget)
    return message(BEGIN, begin, sequence, width, height) + message(BAND, pixels, sequence + 1, width, height) + \
        message(END, struct.pack("<8I", number, 1, 0, 0, 0, 0, 0, 0), sequence + 2)


def messages(data):
    """(header, payload) of every whole message: type, sequence, time, x, y, width, height, format, codec; x of a BEGIN is
    the sequence of the last request that the device heard."""
    at = 0
    while (at := data.find(MAGIC, at)) >= 0 and at + 32 <= len(data):
        length, check = struct.unpack_from("<II", data, at + 24)
        crc = zlib.crc32(data[at:at + 28])
        end = at + 32 + (length + 4 if length else 0)
        payload = data[at + 32:at + 32 + length]
        if data[at + 4] != 1 or crc != check or end > len(data) or \
                (length and zlib.crc32(payload, crc) != struct.unpack_from("<I", data, end - 4)[0]):
            at += 1
            continue
        yield struct.unpack_from("<BHIHHHHBB", data, at + 5), payload
        at = end


def signed(value, bits):
    value &= (1 << bits) - 1
    return value - (1 << bits) if value >> (bits - 1) else value


def channels(form, pixel):
    if form == 0:
        word = pixel[0] | pixel[1] << 8
        return [word >> 11, word >> 5 & 63, word & 31]
    return [pixel[0] >> 4, pixel[0] & 15] if form == 3 else list(pixel)


def join(form, parts):
    if form == 0:
        return struct.pack("<H", (parts[0] & 31) << 11 | (parts[1] & 63) << 5 | (parts[2] & 31))
    if form == 3:
        return bytes([(parts[0] & 15) << 4 | (parts[1] & 15)])
    return bytes(part & 255 for part in parts)


def step(form, s):
    if form == 2:
        return [s - 12 if s < 12 else s - 11]
    if form == 3:
        t = s + (s >= 12)
        return [t // 5 - 2, t % 5 - 2]
    if s < 16:
        sign = -1 if s & 8 else 1
        return [sign * (s >> 1 & 1), sign * (1 + (s >> 2 & 1)), sign * (s & 1)]
    t = s - 16 + (s >= 20)
    return [t // 3 - 1, 0, t % 3 - 1]


def unpack(form, code, row, size, last):
    """The bytes of a band of codec 1 or, with the last picture's rows, 2."""
    unit = max(1, BITS[form] // 8)
    out, kind, at = bytearray(), 0, 0

    def add(difference):
        before = out[-unit:] if out else bytes(unit)
        out.extend(join(form, [a + d for a, d in zip(channels(form, before), difference)]))

    def copy(count):
        for _ in range(count):
            begin = len(out)
            assert begin < size, "more pixels than the band has"
            if kind == 1:
                out.extend(out[-unit:] if out else bytes(unit))
            elif kind == 2:
                assert begin >= row, "nothing above"
                out.extend(out[begin - row:begin - row + unit])
            else:
                assert kind == 3 and last is not None, "no such copy"
                out.extend(last[begin:begin + unit])

    while at < len(code):
        byte = code[at]
        at += 1
        if byte >= 0xC0:
            copy(8 * ((byte & 63) + 1))
        elif byte >= 0x80 and form == 2:
            add([signed(byte >> 3, 3)])
            add([signed(byte, 3)])
        elif byte >= 0x80 and form == 3:
            add([signed(byte >> 3, 3), signed(byte, 3)])
        elif byte >= 0x80:
            green, both = signed(byte, 6), code[at]
            level = green >> (form == 0)
            at += 1
            add([level + (both >> 4) - 8, green, level + (both & 15) - 8])
        elif byte & 31 < 24:
            add(step(form, byte & 31))
            if byte >> 5:
                kind = byte >> 5
                copy(1)
        elif byte >> 5:
            kind = byte >> 5
            copy((byte & 7) + 1)
        else:
            assert byte == 0x18, "not used"
            out.extend(code[at:at + unit])
            at += unit
    assert len(out) == size, "not as many pixels as the band has"
    return bytes(out)


def pictures(data):
    """(header of the begin, its payload, pixels) of the pictures of an undamaged stream."""
    last = under_way = None
    for head, payload in messages(data):
        if head[0] == BEGIN:
            begin, under_way, first = (head, payload), bytearray(), last
            if payload[8] & 1:
                first = None
        elif head[0] == BAND:
            row = (head[5] * BITS[head[7]] + 7) // 8
            size, at = row * head[6], row * head[4]
            assert at == len(under_way), "a gap between bands"
            if head[8] == 0:
                assert len(payload) == size, "raw and not its size"
                under_way += payload
            else:
                rows = first[at:at + size] if head[8] == 2 else None
                under_way += unpack(head[7], payload, row, size, rows)
        elif head[0] == END:
            last = bytes(under_way)
            yield begin[0], begin[1], last
