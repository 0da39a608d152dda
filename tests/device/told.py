# SPDX-License-Identifier: MIT
"""What the handheld's program says on its serial line (firmware/app/app.h), and the host's picture of it."""
import subprocess


class Told:
    """A line that tells of the picture on show; an AssertionError if it is none."""
    stack = 0  # of the last line: it never gets less

    def __init__(self, line):
        clauses = line.split(", ") if line and line.startswith("frame ") else []
        assert len(clauses) >= 5, f"the board says {line!r}"
        self.line = line
        _, self.scene, self.method, self.moment, _ = clauses[0].split(" ")
        self.turn = clauses[2][len("turn "):]
        self.budget = clauses[3][len("budget "):]
        self.bytes = int(clauses[4].split(" ")[0])
        self.running = "running" in clauses[5:]
        self.dropped = any(clause.endswith(" dropped") for clause in clauses[5:])
        self.menu = next((clause[len("menu "):] for clause in clauses if clause.startswith("menu ")), None)
        Told.stack = int(clauses[-1][len("stack "):])


def host(glint, told, size, options):
    """The bytes of the host's picture of the same moment."""
    method = ["--method", told.method]
    if told.method.startswith("subdivide-"):
        method = ["--method", "subdivide", "--subdivide", told.method[len("subdivide-"):]]
    elif told.method.endswith("-perspective"):
        method = ["--method", told.method[:-len("-perspective")], "--perspective"]
    return subprocess.run([glint, "render", f"tests/scenes/{told.scene}.json", "--size", "%dx%d" % tuple(size), "--time", told.moment,
                           "--turn", told.turn, "--tolerance", told.budget, "--budget", told.budget, "--output-format", "raw", "-o", "-"] + method + options,
                          check=True, stdout=subprocess.PIPE).stdout


def stack_complaint(board, image, used):
    """What is wrong with the stack that was used over all scenes and methods, by the bound of stack_image.py. The deepest
    calls are then made; that an interrupt comes right there is not sure."""
    command = ["python3", "tests/tools/stack_image.py", image, "--name", board, "--indirect", "tests/tools/indirect.txt",
               "--measured", str(used)]
    said = subprocess.run(command, check=False, stdout=subprocess.PIPE, text=True)
    return said.stdout if said.returncode else None
