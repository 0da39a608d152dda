#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Worst-case stack of the renderer's entry points on one CPU.

Frames come from gcc's -fcallgraph-info=su (the .ci files beside the objects under FOLDER/firmware), those of libgcc's
helpers from the disassembly of FOLDER/bench.elf or FOLDER/golden.elf. A call through a pointer must be declared in the
--indirect file, one line a caller: `caller: target target ...` (names without the file that gcc puts before a static
function's, or of a target with it: `file.c:name`; `*` matches any text; `-`: it is never made; `before > caller: ...` is
instead of that where `before` is among what has called). Recursion, a frame whose size is not constant and an undeclared pointer
call are failures. Prints `ok` and `FAIL` lines.
"""
import argparse
import fnmatch
import glob
import re
import subprocess
import sys

LIMITED = ("glint_frame_begin", "glint_frame_next_band")
OTHERS = ("glint_init", "glint_scene_check", "glint_fit_stores", "glint_memory_needed")
NODE = re.compile(r'node: \{ title: "([^"]+)" label: "([^"]*)"')
EDGE = re.compile(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"')


def short(name):
    return name.rsplit(":", 1)[-1]


def read_graph(paths):
    frames, calls, faults = {}, {}, []
    for path in sorted(paths):
        with open(path, encoding="utf-8") as file:
            for line in file:
                if node := NODE.match(line):
                    name, label = node.groups()
                    if size := re.search(r"(\d+) bytes \(([a-z,]+)\)", label):
                        frames[name] = int(size.group(1))
                        if size.group(2) != "static":
                            faults.append(f"{name}: a frame of changing size ({size.group(2)})")
                elif edge := EDGE.match(line):
                    calls.setdefault(edge.group(1), set()).add(edge.group(2))
    return frames, calls, faults


def read_indirect(path):
    with open(path, encoding="utf-8") as file:
        lines = [line.split("#")[0].split(": ", 1) for line in file]
    return [(line[0].strip(), line[1].split()) for line in lines if len(line) == 2]


def read_helpers(images, frames, calls):
    """Frames of what only the linked image has: pushes and the stack pointer's steps, calls and tail calls."""
    for image in images:
        run = subprocess.run(["arm-none-eabi-objdump", "-d", "--no-show-raw-insn", image], capture_output=True, text=True)
        if run.returncode == 0:
            break
    else:
        return
    # Of a naked function the compiler says 0.
    name, known = None, {short(n) for n in frames if frames[n] or ":" in n}
    for line in run.stdout.splitlines():
        if head := re.match(r"[0-9a-f]+ <([^>]+)>:", line):
            name = None if head.group(1) in known else head.group(1)
            if name:
                frames[name] = 0
        elif name:
            if push := re.search(r"\t(?:push|stmdb\tsp!,).*\{(.*)\}", line):
                for item in push.group(1).split(","):
                    ends = re.findall(r"[a-z]+(\d+)", item) if "-" in item else []
                    frames[name] += 4 * (int(ends[1]) - int(ends[0]) + 1 if ends else 1)
            elif step := re.search(r"\tsub(?:\.w)?\tsp, (?:sp, )?#(\d+)", line):
                frames[name] += int(step.group(1))
            elif step := re.search(r"\tstr(?:\.w)?\t\w+, \[sp, #-(\d+)\]!", line):
                frames[name] += int(step.group(1))
            elif call := re.search(r"\tb[a-z.]*\t[0-9a-f]+ <([^>+]+)>", line):
                if call.group(1) != name:
                    calls.setdefault(name, set()).add(call.group(1))
    symbols = subprocess.run(["arm-none-eabi-nm", image], capture_output=True, text=True).stdout.split("\n")
    names = {}
    for address, kind, symbol in (line.split() for line in symbols if len(line.split()) == 3):
        if kind in "tTwW":
            names.setdefault(address, []).append(symbol)
    for group in names.values():  # the disassembly heads a function by one of its names only
        for name in group:
            for other in group:
                if name in frames and other not in frames:
                    frames[other], calls[other] = frames[name], calls.get(name, set())


class Walker:
    """`linked`: the image's symbols; what is not among them is never called. None: all may be."""
    def __init__(self, frames, calls, indirect, linked=None):
        self.linked = linked
        self.frames, self.calls, self.indirect = frames, calls, indirect
        self.by_short = {short(name): name for name in frames}
        self.special = [before.strip() for caller, _ in indirect for before in caller.split(">")[:-1]]
        self.done, self.faults = {}, set()

    def among(self, path):
        """Which patterns that stand before a `>` have called."""
        return frozenset(p for p in self.special for name in path if fnmatch.fnmatch(short(name), p))

    def targets(self, name, special):
        for target in sorted(self.calls.get(name, ())):
            if target != "__indirect_call":
                yield target
                continue
            lines = [(caller.split(" > "), ts) for caller, ts in self.indirect
                     if fnmatch.fnmatch(short(name), caller.split(" > ")[-1])]
            wanted = ([t for caller, ts in lines if caller[0] in special for t in ts] or
                      [t for caller, ts in lines if len(caller) == 1 for t in ts])
            found = [n for n in self.frames for t in wanted if fnmatch.fnmatch(n if ":" in t else short(n), "*/" + t if ":" in t else t)]
            if not found and "-" not in wanted:
                self.faults.add(f"{name}: a call through a pointer whose targets are not declared")
            yield from found

    def worst(self, name, path=()):
        """(bytes, path) of the deepest chain from name."""
        name = name if name in self.frames else self.by_short.get(short(name), name)
        if name in path:
            self.faults.add("recursion: " + " > ".join(map(short, path[path.index(name):] + (name,))))
            return 0, ()
        special = self.among(path)
        if (name, special) in self.done:
            return self.done[name, special]
        if self.linked is not None and short(name) not in self.linked:
            return 0, ()
        if name not in self.frames:
            self.faults.add(f"{name}: called by {short(path[-1]) if path else 'nobody'}, frame unknown")
            return 0, (name,)
        best = max((self.worst(t, path + (name,)) for t in self.targets(name, special)), default=(0, ()))
        self.done[name, special] = (self.frames[name] + best[0], (name,) + best[1])
        return self.done[name, special]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--cpu", required=True)
    parser.add_argument("--indirect", required=True)
    parser.add_argument("--limit", type=int, required=True)
    parser.add_argument("--paths", action="store_true")
    options = parser.parse_args()
    folder = options.folder
    frames, calls, faults = read_graph(glob.glob(folder + "/firmware/**/*.ci", recursive=True) + glob.glob(folder + "/hal/**/*.ci"))
    read_helpers((folder + "/bench.elf", folder + "/golden.elf"), frames, calls)
    walker = Walker(frames, calls, read_indirect(options.indirect))
    bad = 0
    for entry in LIMITED + OTHERS:
        if entry not in frames:
            print(f"FAIL stack: {options.cpu}: {entry} is not in the objects")
            bad += 1
            continue
        size, path = walker.worst(entry)
        over = entry in LIMITED and size > options.limit
        bad += over
        if entry in LIMITED or options.paths:
            verdict = "FAIL" if over else "ok"
            limit = f" of {options.limit}" if entry in LIMITED else ""
            print(f"{verdict} stack: {options.cpu}: {entry} takes at most {size}{limit} bytes")
        if options.paths or over:
            for name in path:
                print(f"    {frames.get(name, 0):5d}  {short(name)}")
    faults += sorted(walker.faults)
    for fault in faults:
        print(f"FAIL stack: {options.cpu}: {fault}")
    if not faults:
        print(f"ok stack: {options.cpu}: no recursion, no frame of changing size, every call's target known")
    return 1 if bad or faults else 0


if __name__ == "__main__":
    sys.exit(main())
