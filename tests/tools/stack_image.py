#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Worst-case stack of a whole image: from reset through main(), and on top of it the deepest interrupt.

The objects are those that the linker's map beside IMAGE names, of which what was left out does not count, the interrupts what the image's tables of vectors point
to; see stack.py. All interrupts have one priority, so one at a time comes on top of the program: what the core itself
stores (32 bytes, 4 more where the stack is not at a multiple of 8) and the handler's own. A fault begins the stack anew.
The bound must fit the stack that the image reserves. With --measured, the high-water of a run must reach SHARE percent of the
bound and not pass it.
"""
import argparse
import os
import re
import subprocess
import sys

import stack

ENTRY, NOT_INTERRUPTS = 36, ("start_reset", "start_fault")


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def objects(image):
    with open(os.path.splitext(image)[0] + ".map", encoding="utf-8") as file:
        loaded = re.findall(r"^LOAD (\S+\.o)$", file.read(), re.MULTILINE)
    return [path[:-1] + "ci" for path in loaded if os.path.exists(path[:-1] + "ci")]


def symbols(image):
    """(address, bytes, name) of every sized symbol; and all by name."""
    lines = [line.split() for line in run("arm-none-eabi-nm", "-S", image).splitlines()]
    sized = [(int(line[0], 16), int(line[1], 16), line[3]) for line in lines if len(line) == 4]
    return sized, {line[-1]: int(line[0], 16) for line in lines}


def words(image, begin, size):
    dump = run("arm-none-eabi-objdump", "-s", "-j", ".text", f"--start-address={begin}", f"--stop-address={begin + size}", image)
    data = bytes.fromhex("".join(re.findall(r"^ [0-9a-f]+ ((?:[0-9a-f]+ ){1,4})", dump, re.MULTILINE)).replace(" ", ""))
    return [int.from_bytes(data[i:i + 4], "little") for i in range(0, len(data), 4)]


def interrupts(image, sized):
    """Functions that the tables of vectors point to."""
    targets = {word & ~1 for begin, size, name in sized if name == "vectors" for word in words(image, begin, size)}
    found = {name for begin, _, name in sized if begin & ~1 in targets}
    return sorted(found - set(NOT_INTERRUPTS))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("image")
    parser.add_argument("--name", required=True)
    parser.add_argument("--indirect", required=True)
    parser.add_argument("--measured", type=int)
    parser.add_argument("--share", type=int, default=90)
    parser.add_argument("--paths", action="store_true")
    options = parser.parse_args()
    frames, calls, faults = stack.read_graph(objects(options.image))
    stack.read_helpers((options.image,), frames, calls)
    sized, named = symbols(options.image)
    walker = stack.Walker(frames, calls, stack.read_indirect(options.indirect), named)
    program, path = walker.worst("start_reset")
    handler, above = max((walker.worst(name) for name in interrupts(options.image, sized)), default=(-ENTRY, ()))
    bound, room = program + ENTRY + handler, named["link_stack_top"] - named["link_stack"]
    if options.paths:
        for name in path + ("an interrupt",) + above:
            print(f"    {ENTRY if name == 'an interrupt' else frames.get(name, 0):5d}  {stack.short(name)}")
    bad = bound > room
    print(f"{'FAIL' if bad else 'ok'} stack: {options.name}: the program takes at most {program} bytes, with an interrupt {bound}, of {room}")
    if options.measured is not None:
        low = not bound * options.share <= 100 * options.measured <= 100 * bound
        print(f"{'FAIL' if low else 'ok'} stack: {options.name}: {options.measured} bytes were used, {100 * options.measured // bound} % of the bound")
        bad = bad or low
    for fault in faults + sorted(walker.faults):
        print(f"FAIL stack: {options.name}: {fault}")
        bad = True
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
