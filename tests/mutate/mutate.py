#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whether the tests see small changes of the renderer: each mutant of a sample (operators.py) is compiled, linked into a copy of
the renderer's shared library, and given to the killers that run its line: programs that pass with the renderer as it is.

Not counted are mutants that compilers refuse, those whose code is the original's or another mutant's, and those that are reviewed in
equivalents.txt. Which mutants are taken depends on their text and SEED alone. Results are kept in FOLDER/results.json, by what a mutant
and a killer compile to, so that only what changed runs again. Prints `FAIL` lines and exits with 1 where the score is below --least,
an entry of equivalents.txt fits no mutant or its mutant was killed.
"""
import argparse
import collections
import concurrent.futures
import fnmatch
import glob
import hashlib
import json
import math
import os
import re
import resource
import shlex
import shutil
import subprocess
import sys
import threading

sys.dont_write_bytecode = True
import operators

SOME = 4  # of those that call an inline function, tried first
UNDEFINED = ("-fsanitize=undefined,bounds-strict", "-fsanitize-undefined-trap-on-error")
FIRST = ("golden_mini", "test_random_list", "golden")  # they see most
FOLDERS = ("fixed", "raster", "shade", "plan")
HERE = os.path.dirname(os.path.abspath(__file__))
EQUIVALENTS = os.path.join(HERE, "equivalents.txt")


def digest(*parts):
    hashed = hashlib.sha256()
    for part in parts:
        hashed.update(part if isinstance(part, bytes) else part.encode())
    return hashed.hexdigest()[:24]


def content(path):
    with open(path, "rb") as f:
        return f.read()


class Build:
    """What make has built: objects of the renderer and of the killers, and how each is made."""

    def __init__(self, options):
        self.folder, self.root = os.path.abspath(options.folder), os.getcwd()
        self.core = options.core.split()
        self.tests = options.tests.split()
        self.compile = {True: shlex.split(options.core_cc), False: shlex.split(options.test_cc)}
        self.link = shlex.split(options.link)
        self.uses = collections.defaultdict(set)  # inline function -> sources that call it; .c -> tests that include it
        for source in self.core + self.tests:
            for name in content(self.object(source)[:-2] + ".inline").decode().split():
                self.uses[name].add(source)
        for source in self.tests:
            for path in self.included(source):
                if path.endswith(".c") and path != source:
                    self.uses[path].add(source)
        self.counted = collections.defaultdict(set)  # lines, where code begins
        self.original = {s: content(self.object(s)) for s in self.core + self.tests}

    def object(self, source):
        return os.path.join(self.folder, "obj", source[:-2] + ".o")

    def active(self, path):
        """The lines of a source that are compiled here."""
        users = [path] if path.endswith(".c") else [s for s in self.core if path in self.included(s)]
        lines = set()
        for user in users[:3]:
            out = subprocess.run(self.compile[True] + ["-E", user], check=True, capture_output=True, text=True).stdout
            name, number = "", 0
            for line in out.split("\n"):
                marker = re.match(r'# (\d+) "([^"]*)"', line)
                if marker:
                    number, name = int(marker.group(1)), os.path.normpath(marker.group(2))
                else:
                    if line.strip() and name == path:
                        lines.add(number)
                    number += 1
        return lines

    def included(self, source):
        return content(self.object(source)[:-2] + ".d").decode().split()


class Killer:
    """A program that fails, prints another list, crashes or hangs when a mutant is seen."""

    def __init__(self, build, name, command, objects, listed, place):
        self.name, self.command, self.objects, self.expected = name, command, objects, None
        program = os.path.join(build.folder, "bin", name)
        self.hash = digest(content(program), " ".join(command))
        if listed:
            self.expected = subprocess.run([program], cwd=place, env=dict(os.environ, LD_LIBRARY_PATH=place),
                                           stdout=subprocess.PIPE, check=True).stdout
        self.seconds, self.lines = 0.0, {}

    def limits(self):
        cpu = max(1, math.ceil(5 * self.seconds))
        resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu))
        resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        os.nice(5)

    def run(self, place, program, calibrate=False):
        """'' if it passes, else how it failed. CPU time is limited, as machines may be busy, and real time far beyond."""
        environment = dict(os.environ, LD_LIBRARY_PATH=place, CMOCKA_MESSAGE_OUTPUT="STDOUT")
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [program] + self.command
        if self.expected is not None:
            command = ["stdbuf", "-oL"] + command
        process = subprocess.Popen(command, cwd=place, env=environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE if self.expected is not None else subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, preexec_fn=None if calibrate else self.limits)
        watch = threading.Timer(60 + 100 * self.seconds, process.kill)
        watch.start()
        verdict = ""
        if self.expected is not None:
            lines = iter(self.expected.splitlines(True))
            for line in process.stdout:
                if line != next(lines, None):
                    verdict = "differs"
                    process.kill()
                    break
            else:
                verdict = "differs" if next(lines, None) is not None else ""
            process.stdout.close()
        code = process.wait()
        watch.cancel()
        if calibrate:
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
        if not verdict and code in (-9, -24):
            return "timeout"
        return verdict or ("" if code == 0 else "fails" if code > 0 else "crashes")


    def reaches(self, mutant, build):
        """Whether it runs the mutant's line, or may within itself; of statements of several lines the one that counts."""
        counted, number = build.counted[mutant.path], mutant.number
        while number not in counted and number > 0:
            number -= 1
        return (mutant.function == "-" or number in self.lines.get(mutant.path, ()) or
                any(o in build.uses[mutant.function] or o in build.uses[mutant.path] for o in self.objects))

    def find_lines(self, build, place, known):
        """Which lines it runs, of functions; known from before if neither it nor the renderer has changed."""
        if "lines" + self.hash not in known:
            folder = os.path.join(build.folder, "lines")
            counts = glob.glob(folder + "/firmware/**/*.gcda", recursive=True)
            for path in counts:
                os.remove(path)
            environment = dict(os.environ, LD_LIBRARY_PATH=folder)
            subprocess.run([os.path.join(build.folder, "bin", self.name)] + self.command, cwd=place, env=environment,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            counts = glob.glob(folder + "/firmware/**/*.gcda", recursive=True)
            said = b""  # of a test that includes the source itself
            if counts:
                said = subprocess.run(["gcov", "--json-format", "--stdout"] + counts, capture_output=True, check=True).stdout
            lines = collections.defaultdict(dict)
            for report in said.splitlines():
                for file in json.loads(report)["files"]:
                    for line in file["lines"]:
                        number = str(line["line_number"])
                        lines[file["file"]][number] = lines[file["file"]].get(number, False) or line["count"] > 0
            known["lines" + self.hash] = lines
        for path, own in known["lines" + self.hash].items():
            build.counted[path].update(map(int, own))
            self.lines[path] = {int(number) for number, ran in own.items() if ran}


class Worker:
    """A place of its own: the sources, of which one is changed at a time, and a library."""

    def __init__(self, build, number):
        self.build, self.killers = build, []
        self.place = os.path.join(build.folder, "worker%d" % number)
        shutil.rmtree(self.place, ignore_errors=True)
        os.makedirs(os.path.join(self.place, "obj"))
        shutil.copytree("firmware", os.path.join(self.place, "firmware"))
        for name in ("tests", "hal", "host-tools", "boards", "README.md", "CONTRIBUTING.md"):
            os.symlink(os.path.join(build.root, name), os.path.join(self.place, name))

    def compile(self, source, changed, flags=()):
        out = os.path.join(self.place, "obj", source.replace("/", "_")[:-2] + ".o")
        done = subprocess.run(self.build.compile[source in self.build.core] + list(flags) + ["-c", source, "-o", out],
                              cwd=self.place, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if done.returncode:
            return False
        if content(out) != self.build.original[source]:
            changed[source] = out
        return True

    def library(self, changed):
        objects = [changed.get(s) or self.build.object(s) for s in self.build.core]
        subprocess.run(["gcc", "-shared", "-Wl,-Bsymbolic", "-o", os.path.join(self.place, "libfirmware.so")] + objects, check=True)

    def prepare(self, mutant, original, users, flags=()):
        """Compiles what the mutant changes: the objects that differ, or None where it is refused."""
        path, changed = os.path.join(self.place, mutant.path), {}
        with open(path, "w") as f:
            f.write(mutant.text(original))
        try:
            return changed if all([self.compile(source, changed, flags) for source in users]) else None
        finally:
            with open(path, "w") as f:
                f.write(original)

    def program(self, killer, changed):
        own = os.path.join(self.build.folder, "bin", killer.name)
        if not any(o in changed for o in killer.objects):
            return own
        out = os.path.join(self.place, "program")
        objects = [changed.get(o) or (self.build.object(o) if o in self.build.original else o) for o in killer.objects]
        subprocess.run(self.build.link[:1] + objects + self.build.link[1:] + ["-o", out], cwd=self.build.root, check=True)
        return out

    def judge(self, mutant, original, known, taken):
        """The verdict and its killer: refused, same, twin, killed or survived. What is seen where some of those that call an
        inline function have it is seen where all have."""
        users = [mutant.path] + sorted(self.build.uses[mutant.path])
        if mutant.path.endswith(".h"):
            users = sorted(self.build.uses[mutant.function], key=lambda s: (len(self.build.original[s]), s))
        if len(users) > SOME:
            verdict, by = self.judge_in(mutant, original, users[:SOME], known, taken)
            if verdict in ("refused", "killed"):
                return verdict, by
        return self.judge_in(mutant, original, users, known, taken)

    def judge_in(self, mutant, original, users, known, taken):
        changed = self.prepare(mutant, original, users)
        if changed is None:
            return "refused", ""
        if not changed:
            return "same", ""
        code = digest(*(p for s in sorted(changed) for p in (s, content(changed[s]))))
        if taken.setdefault(code, mutant.key) != mutant.key:
            return "twin", taken[code]
        killers = [k for k in self.killers if k.reaches(mutant, self.build)]
        if not killers:
            return "survived", "not reached"
        for killer in killers:
            if known.get(code + killer.hash):
                return "killed", killer.name + " " + known[code + killer.hash]
        linked = False
        for killer in killers:
            if code + killer.hash in known:
                continue
            if not linked:
                self.library(changed)
                linked = True
            known[code + killer.hash] = how = killer.run(self.place, self.program(killer, changed))
            if how:
                return "killed", killer.name + " " + how
        return self.judge_undefined(mutant, original, users, killers, code, known)

    def judge_undefined(self, mutant, original, users, killers, code, known):
        """What no picture shows may be undefined: the mutant's file once more, stopping there, as under make test-sanitize."""
        key = code + UNDEFINED[0] + "".join(k.hash for k in killers if k.name in FIRST)
        if key not in known:
            core = [s for s in users if s in self.build.core]
            changed, known[key] = self.prepare(mutant, original, core, UNDEFINED), ""
            self.library(changed)
            for killer in killers:
                if killer.name in FIRST and not known[key]:
                    known[key] = killer.run(self.place, os.path.join(self.build.folder, "bin", killer.name))
        return ("killed", "sanitizer " + known[key]) if known[key] else ("survived", "")


def read_equivalents(path):
    entries = {}
    with open(path) as f:
        for line in f:
            if line.strip() and not line.startswith("#"):
                key, _, reason = line.rstrip("\n").rpartition(" | ")
                entries[key] = reason
    return entries


def sample(mutants, counts, seed):
    """Of each folder as many as counts says (None: all): those of the least hashes."""
    chosen = []
    for folder in FOLDERS:
        own = [m for m in mutants if m.path.split("/")[1] == folder]
        own.sort(key=lambda m: digest(m.key, str(seed)))
        chosen += own[:counts[folder]]
    return sorted(chosen, key=lambda m: (m.path, m.number, m.key))


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("folder", "core", "tests", "core-cc", "test-cc", "link", "killers"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--files", default="*", help="patterns of paths")
    parser.add_argument("--sample", type=int, default=800, help="mutants of raster, shade and plan together; 0: all")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--least", type=float, default=95)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--list", action="store_true", help="list the sample, run nothing")
    return parser.parse_args()


def find_killers(build, text, place):
    """`program [argument...] = source...; ...`; golden's list is what it prints as the renderer is (make test-golden)."""
    killers = []
    for part in filter(str.strip, text.split(";")):
        command, _, sources = part.partition("=")
        words = command.split()
        killers.append(Killer(build, words[0], words[1:], sources.split(), words[0].startswith("golden"), place))
    return killers


def calibrate(build, killers, place):
    """Each must pass with the library as it is, and be linked with it at all, or include some of its sources."""
    needed, including = [], set().union(*(tests for path, tests in build.uses.items() if path.endswith(".c")))
    for killer in killers:
        program = os.path.join(build.folder, "bin", killer.name)
        if b"libfirmware.so" not in subprocess.run(["readelf", "-d", program], capture_output=True, check=True).stdout \
                and not including.intersection(killer.objects):
            continue
        how = killer.run(place, program, calibrate=True)
        if how:
            sys.exit("FAIL %s %s with the renderer as it is" % (killer.name, how))
        needed.append(killer)
    return sorted(needed, key=lambda k: (k.name not in FIRST, k.seconds))


def interval(score, size):
    return 1.96 * math.sqrt(score * (1 - score) / size) if size else 0


def main():
    options = parse()
    build = Build(options)
    originals, mutants = {}, []
    for folder in FOLDERS:
        for name in sorted(os.listdir("firmware/" + folder)):
            path = "firmware/%s/%s" % (folder, name)
            if name.endswith((".c", ".h")) and any(fnmatch.fnmatch(path, p) for p in options.files.split()):
                originals[path] = content(path).decode()
                mutants += operators.mutants_of(path, originals[path], build.active(path))
    possible = collections.Counter(m.path.split("/")[1] for m in mutants)
    rest = sum(possible[f] for f in FOLDERS[1:])
    counts = {f: round(options.sample * possible[f] / max(rest, 1)) if options.sample and f != "fixed" else None for f in FOLDERS}
    chosen = sample(mutants, counts, options.seed)
    if options.list:
        print("\n".join("%d: %s" % (m.number, m.key) for m in chosen))
        return 0
    print("%d of %d possible mutants (%s), seed %s" % (
        len(chosen), len(mutants), ", ".join("%s %d" % (f, possible[f]) for f in FOLDERS), options.seed), flush=True)
    workers = [Worker(build, i) for i in range(options.jobs)]
    workers[0].library({})
    killers = calibrate(build, find_killers(build, options.killers, workers[0].place), workers[0].place)
    print("%d killers, %.0f s when all run" % (len(killers), sum(k.seconds for k in killers)), flush=True)
    store = Store(build)
    for killer in killers:
        killer.find_lines(build, workers[0].place, store.known)
    store.save()
    for worker in workers:
        worker.killers = killers
    results = run(workers, chosen, originals, store)
    return report(chosen, mutants, possible, results, options)


class Store:
    """What is known from before, by what it depends on."""

    def __init__(self, build):
        self.path = os.path.join(build.folder, "results.json")
        base = digest(*(build.original[s] for s in build.core))
        self.known = json.loads(content(self.path)) if os.path.exists(self.path) else {}
        if self.known.get("base") != base:
            self.known = {"base": base}

    def save(self):
        kept = json.dumps(dict(self.known))
        with open(self.path + ".part", "w") as f:
            f.write(kept)
        os.replace(self.path + ".part", self.path)


def run(workers, chosen, originals, store):
    taken, results, idle = {}, {}, list(workers)

    def one(mutant):
        worker = idle.pop()
        try:
            return mutant, worker.judge(mutant, originals[mutant.path], store.known, taken)
        finally:
            idle.append(worker)

    with concurrent.futures.ThreadPoolExecutor(len(workers)) as pool:
        for mutant, verdict in pool.map(one, chosen):
            results[mutant.key] = verdict
            if len(results) % 20 == 0:
                store.save()
                counts = collections.Counter(how for how, _ in results.values())
                print("# %d of %d: %s" % (len(results), len(chosen), ", ".join("%s %d" % c for c in sorted(counts.items()))), flush=True)
            if verdict[0] == "survived":
                print("# %s:%d %s %s" % (mutant.path, mutant.number, mutant.change, verdict[1]), flush=True)
    store.save()
    return results


def report(chosen, mutants, possible, results, options):
    entries, bad = read_equivalents(EQUIVALENTS), False
    keys = {m.key for m in mutants}
    files = collections.defaultdict(collections.Counter)
    for mutant in chosen:
        verdict, by = results[mutant.key]
        if mutant.key in entries:
            if verdict == "killed":
                print("FAIL killed by %s, but held to be equivalent: %s" % (by, mutant.key))
                bad = True
            verdict = "equivalent" if verdict == "survived" else verdict
        if verdict == "survived":
            print("survived %s:%d: %s%s" % (mutant.path, mutant.number, mutant.key.split(" | ", 1)[1], by and ", " + by))
        files[mutant.path][verdict] += 1
        if verdict == "killed":
            files[mutant.path][by.rsplit(" ", 1)[-1] if by.endswith("timeout") else by.rsplit(" ", 1)[0]] += 1
    for key in entries:
        if key not in keys and any(fnmatch.fnmatch(key.split(" | ")[0], p) for p in options.files.split()):
            print("FAIL no such mutant: %s" % key)
            bad = True
    return table(files, possible, options) or bad


def table(files, possible, options):
    outside = ("refused", "same", "twin", "equivalent", "killed", "survived")
    print("%-36s %7s %7s %7s %9s %7s  by" % ("file", "refused", "same", "equiv.", "survived", "killed"))
    folders = collections.defaultdict(collections.Counter)
    for path in sorted(files):
        c = files[path]
        folders[path.split("/")[1]].update(c)
        by = ", ".join("%s %d" % (k, n) for k, n in c.most_common() if k not in outside)
        print("%-36s %7d %7d %7d %9d %7d  %s" % (
            path, c["refused"], c["same"] + c["twin"], c["equivalent"], c["survived"], c["killed"], by))
    whole, variance, bad = 0, 0, False
    total = sum(possible[f] for f in folders)
    for folder in FOLDERS:
        c = folders.get(folder)
        if not c or not c["killed"] + c["survived"]:
            continue
        size = c["killed"] + c["survived"]
        score, share = c["killed"] / size, possible[folder] / total
        whole += share * score
        variance += 0 if sum(c[k] for k in outside) == possible[folder] else (share * interval(score, size)) ** 2
        print("%s: %d killed of %d, %.1f %%" % (folder, c["killed"], size, 100 * score))
    bad = 100 * whole < options.least
    print("%s mutation score %.1f %%, 95 %% confidence +-%.1f, least %g %%" % (
        "FAIL" if bad else "ok", 100 * whole, 100 * math.sqrt(variance), options.least))
    return bad


if __name__ == "__main__":
    sys.exit(main())
