#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What pictures cost on the emulated boards.

  board_costs.py run BUILD MODULES OUT.csv   runs build/<board>/cost.elf, reads the sizes of app.elf and app-x.elf, runs the Linux guest
  board_costs.py table OUT.csv               the same as tables

A line of the file is `board,what,figure,unit,number`: what is `program`, with PROGRAM's figures in bytes, then `SCENE
METHOD` (and `table` where a colour table is used, `two` where two cores share it) with FIGURES: drawn, drawn and sent whole, one of
many in a row sent whole, and with what has changed 50 ms later (instructions on the LM3S6965, cycles on the RP2040), and the bytes of
the second and the last. Of Linux: microseconds a picture, of them in the program and the kernel, CPU, bytes, and the real wire's limit.
"""
import csv
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../device"))
from pico import Pico

# How many of its unit go by in a microsecond, and the unit. Under -icount shift=0 an instruction takes a nanosecond.
BOARDS = {"lm3s6965evb": (1000, "instructions"), "picosystem": (125, "cycles")}
LINUX = "linux-virt"
LINUX_FIGURES = "real", "user", "system", "cpu", "bytes", "wire"
FIGURES = "drawn", "whole", "row", "changes", "bytes", "bytes_changes"
PROGRAM = "flash", "flash_x", "static", "bands", "renderer", "stack", "stack_used"


def lines_qemu(image):
    with tempfile.TemporaryDirectory() as folder:
        serial = os.path.join(folder, "serial")
        os.mkfifo(serial + ".in")
        os.mkfifo(serial + ".out")
        vm = subprocess.Popen(["qemu-system-arm", "-M", "lm3s6965evb", "-display", "none", "-monitor", "none", "-icount", "shift=0",
                               "-chardev", f"pipe,id=serial,path={serial}", "-serial", "chardev:serial", "-kernel", image],
                              stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            with open(serial + ".out", encoding="ascii") as out:
                for line in out:
                    yield line.strip()
        finally:
            vm.kill()
            vm.wait()


def lines_rp2040(modules, board, image):
    with Pico(modules, board, image) as pico:
        while (line := pico.line(10)) is not None:
            yield line
        yield ""


def measure(build, modules, board):
    """The lines of a board's cost.c."""
    image = f"{build}/{board}/cost"
    lines = lines_qemu(image + ".elf") if board == "lm3s6965evb" else lines_rp2040(modules, board, image + ".uf2")
    for line in lines:
        kind, *words = line.split() or [""]
        if kind == "cost":
            scene, method, table, cores, *numbers = words
            what = f"{scene} {method}" + (" table" if table == "1" else "") + (" two" if cores == "2" else "")
            for figure, number in zip(FIGURES, map(int, numbers)):
                per_us, unit = (1, "bytes") if figure.startswith("bytes") else BOARDS[board]
                yield what, figure, unit, number * per_us
        elif kind == "stack":
            yield "program", "stack_used", "bytes", int(words[0])
        elif kind == "end":
            return
        else:
            raise SystemExit(f"{board}: {line or 'it stopped'}")


def run_lines(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()


def symbols(image):
    for line in run_lines("arm-none-eabi-nm", "-S", image):
        words = line.split()
        yield words[-1], int(words[0], 16), int(words[1], 16) if len(words) == 4 else 0


def sections(image):
    return tuple(map(int, run_lines("arm-none-eabi-size", image)[1].split()[:3]))


def code(image):
    """Flash without the scenes, which are the objects of that name: there are functions too."""
    text, data, _ = sections(image)
    scenes = [line.split() for line in run_lines("arm-none-eabi-objdump", "-t", image) if re.search(r" O \S+\t\S+ scene_", line)]
    return text + data - sum(int(words[-2], 16) for words in scenes)


def sizes(build, board):
    image = f"{build}/{board}/app.elf"
    _, data, bss = sections(image)
    named = {re.sub("^board_", "", name): (at, size) for name, at, size in symbols(image)}
    figures = (code(image), code(f"{build}/{board}/app-x.elf"), data + bss, named["band"][1], named["memory"][1],
               named["link_stack_top"][0] - named["link_stack"][0])
    for figure, number in zip(PROGRAM, figures):
        yield "program", figure, "bytes", number


def run(build, modules, path):
    with open(path + ".part", "w", newline="", encoding="ascii") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["board", "what", "figure", "unit", "number"])
        for board in BOARDS:
            rows = [*sizes(build, board), *measure(build, modules, board)]
            first = {what.removesuffix(" two"): i for i, (what, *_) in reversed([*enumerate(rows)])}
            rows.sort(key=lambda row: (row[0] != "program", first[row[0].removesuffix(" two")]))
            out.writerows([board, *row] for row in rows)
        guest = ["python3", "tests/device/linux/test_linux.py", f"{build}/armhf/debian/kernel", f"{build}/armhf/guest-v1", f"{build}/glint"]
        for line in run_lines(*guest, "figures"):
            out.writerow([LINUX, *line.split(",")])
    os.replace(path + ".part", path)


def table(path):
    rows = {}
    with open(path, encoding="ascii") as file:
        for row in csv.DictReader(file):
            rows.setdefault((row["board"], row["what"]), {})[row["figure"]] = int(row["number"])
    names = {"gouraud": "Gouraud", "x": "X", "phong": "Phong", "table": "with a colour table", "two": "by two cores"}
    for board, (_, unit) in BOARDS.items():
        print(f"\n`{board}`, million {unit} a picture:\n")
        print("| scene | method | drawn | drawn and sent whole | in a row | 50 ms later its changes | bytes | of changes |\n|---|---|---|---|---|---|---|---|")
        for (at, what), figure in rows.items():
            if at == board and what != "program":
                scene, *method = what.split()
                print(f"| {scene} | {' '.join(names[word] for word in method)} |", " | ".join(
                    f"{figure[name] / 1e6:.2f}" for name in FIGURES[:4]), f"| {figure['bytes']} | {figure['bytes_changes']} |")
    print(f"\n`{LINUX}`, milliseconds a picture in the guest's time:\n")
    print("| panel | a picture | in the program | in the kernel | CPU, % | bytes | whole on a real panel's wire |\n|---|---|---|---|---|---|---|")
    for (at, what), figure in rows.items():
        if at == LINUX:
            print(f"| {what} |", " | ".join(
                str(figure[name] or "") if name in ("cpu", "bytes") else f"{figure[name] / 1e3:.1f}" for name in LINUX_FIGURES), "|")
    print("\nBytes of `firmware/app`:\n")
    print("| board | flash without scenes: all methods | X alone | static RAM | bands in it | the renderer's memory in it | stack | of it used |")
    print("|---|---|---|---|---|---|---|---|")
    for board in BOARDS:
        print(f"| {board} |", " | ".join(str(rows[board, "program"][name]) for name in PROGRAM), "|")


def main(argv):
    if len(argv) == 5 and argv[1] == "run":
        run(*argv[2:])
    elif len(argv) == 3 and argv[1] == "table":
        table(argv[2])
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv)
