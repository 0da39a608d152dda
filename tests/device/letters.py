# SPDX-License-Identifier: MIT
"""Reads letters off a picture: 3x5 pixels in cells of 4x6, or twice that, by the tables in firmware/app/text.c."""
import os
import re

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../firmware/app/text.c")


def glyphs():
    """Letters by their five octal digits, a row each."""
    with open(SOURCE, encoding="utf-8") as file:
        text = file.read()
    table = {}
    for name, first in (("text_digits", "0"), ("text_letters", "A")):
        numbers = re.search(name + r"\[\d+\] = \{(.*?)\}", text, re.DOTALL).group(1)
        for i, number in enumerate(re.findall(r"0[0-7]+", numbers)):
            table[int(number, 8)] = chr(ord(first) + i)
    return {0: " ", **table}


def read(lit, width, height, scale=1):
    """The lines of a picture of black and white; `lit` is 1 where a pixel is white. A row of cells is a line where all of
    them are known letters."""
    known, lines, y = glyphs(), [], 0
    while y + 6 * scale <= height:
        line = ""
        for x in range(0, width - 4 * scale + 1, 4 * scale):
            at = [lit[(y + i * scale) * width + x + j * scale] for i in range(5) for j in range(3)]
            line += known.get(int("".join(map(str, at)), 2), "\0")
        good = line.strip() and "\0" not in line
        if good:
            lines.append(line.strip())
        y += 6 * scale if good else 1
    return lines
