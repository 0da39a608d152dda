#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the proofs of tests/proof with Frama-C, one line each: prove.py [-j N] [-t SECONDS] -o FOLDER FILE.c...

A proof holds if every alarm and annotation is proven, every statement of the functions that it names was reached, and
each contract that it assumes is proven by another of the files. Its head says which they are (tests/proof/proof.h).
Those of tests/proof/wp are contracts for bytes of any number, by WP alone: what is reached there is what its smoke
tests, a share of the statements, cannot show to be dead."""
import argparse
import collections
import concurrent.futures
import csv
import os
import re
import subprocess
import sys
import time

COMMON = ["-machdep", "gcc_x86_32", "-c11", "-main", "prove",
          "-kernel-warn-key", "annot:missing-spec=abort,typing:implicit-function-declaration=abort"]
# What Frama-C does not parse, and does not need: assertions and alignments of C11.
CPP = "-Ifirmware -Ihal -Ihost-tools -I. -Itests/proof '-D_Static_assert(...)=' '-D_Alignas(x)='"
EVA = ["-eva", "-metrics", "-metrics-eva-cover"]
WP = ["-wp", "-wp-rte", "-wp-smoke-tests", "-wp-model", "Typed+Cast", "-wp-prover", "cvc4", "-wp-timeout", "20",
      "-wp-par", "2", "-wp-fct"]
# Dead: in code that is not reached; what must be is named.
HELD = {"Valid", "Considered valid", "Dead"}


def head(path):
    """The lists at the head of a proof: {"proves": [...], "assumes": [...], "lemmas": [...], "options": [...], "then": [...]}."""
    lists, name = {"proves": [], "assumes": [], "lemmas": [], "options": [], "then": []}, None
    for line in open(path):
        found = re.match(r" \*\s+(\w+):\s*(.*)", line)
        if found and found.group(1) in lists:
            name = found.group(1)
            lists[name] += found.group(2).split()
        elif name and re.match(r" \*   +\S", line):
            lists[name] += line[2:].split()
        elif line.strip() == "*/":
            break
        elif line.strip() == "*":
            name = None
        elif name:  # a formatter joined two lines: nothing of a list is to be lost by that
            sys.exit(f"{path}: neither a list nor its next line: {line.strip()}")
    return lists


def lemmas(path, names):
    """What the lemmas tests/proof/NAME.smt2 discharge, (function, property) as often as it is met, and what is wrong with
    them: z3 must answer `unsat` to each question, and the code that they rest upon stand in its file exactly once."""
    shown, bad = collections.Counter(), []
    for name in names:
        lemma, source = os.path.join(os.path.dirname(path), name + ".smt2"), ""
        questions = 0
        for line in open(lemma):
            kind, _, text = line.strip().partition(": ")
            if kind == "; source":
                source = " ".join(open(text).read().split())
            elif kind == "; code" and source.count(text) != 1:
                bad.append(f"{lemma}: this code stands {source.count(text)} times in its file: {text}")
            elif kind == "; shows":
                shown[tuple(text.split(": ", 1))] += 1
            questions += line.startswith("(check-sat)")
        answer = subprocess.run(["z3", "-T:120", lemma], capture_output=True, text=True).stdout.split()
        if answer != ["unsat"] * questions or not questions:
            bad.append(f"{lemma}: {' '.join(answer)}, of {questions} questions")
    return shown, bad


def unmade(log):
    """By function, what Frama-C itself puts into it where no path leads: a statement beside a case that but returns a
    constant. Its counts of statements have them."""
    counts = collections.Counter()
    for source, line in re.findall(r"^\[nonterm:dead-code\] (\S+):(\d+): Warning: \s+statement is syntactically", log, re.M):
        heads = [re.match(r"[a-z][^;=]*?\b(\w+)\(", text) for text in open(source).readlines()[:int(line)]]
        counts.update([one.group(1) for one in heads if one][-1:])
    return counts


def complaints(path, base, lists, log):
    """What is left to prove, and what was not reached; with the counts of statements of the named functions."""
    (shown, bad), reached, total = lemmas(path, lists["lemmas"]), 0, 0
    covered = dict((name, (int(done), int(of))) for name, done, of in
                   re.findall(r"^\s+(\w+): (\d+) stmts out of (\d+) ", log, re.M))
    if by_wp(path):
        tests = re.findall(r"^\[wp\] \[(\w+)\] Smoke-test typed_cast_(\w+?)_wp_smoke", log, re.M)
        covered = {name: (tests.count(("Passed", name)), sum(name == of for _, of in tests)) for name in lists["proves"]}
    beside = unmade(log)
    for name in lists["proves"]:
        done, of = covered.get(name, (0, 0))
        of -= beside[name]
        reached, total = reached + done, total + of
        if done != of or not of:
            bad.append(f"{name}: {done} of {of} statements reached")
    if not lists["proves"]:
        bad.append("names no function that it proves")
    held = 0
    with open(base + ".csv") as table:
        for row in csv.reader(table, delimiter="\t", quoting=csv.QUOTE_NONE):
            folder, name, line, function, kind, status, text = (row + [""] * 7)[:7]
            if folder == "directory" or folder.startswith("FRAMAC_SHARE"):
                continue
            if status in HELD:
                held += 1
            elif shown[function, f"{kind}: {text}"]:
                shown[function, f"{kind}: {text}"] -= 1
                held += 1
            elif lists["lemmas"] and status == "Unknown" and (kind == "precondition" or function == "prove" and
                                      kind.removeprefix("precondition of ") in lists["proves"]):
                continue  # the sum of what is asked at each call; prove() calls with more than the contract allows
            elif function in lists["proves"] if by_wp(path) else function not in lists["assumes"]:
                bad.append(f"{name}:{line}: {function}: {kind}: {text} ({status})")
    bad += [f"{': '.join(one)}: shown by a lemma, and no alarm" for one in sorted(+shown)]
    return bad, held, reached, total


def by_wp(path):
    return os.path.basename(os.path.dirname(path)) == "wp"


def prove(path, folder, limit):
    lists, start = head(path), time.time()
    name = os.path.relpath(path, "tests/proof")[:-2]
    base = os.path.join(folder, name.replace("/", "_"))
    options = COMMON + (["-eva-use-spec", ",".join(lists["assumes"])] if lists["assumes"] and not by_wp(path) else []) + \
        lists["options"]
    then = (["-then"] + lists["then"]) if lists["then"] else []
    command = ["frama-c", path, "-cpp-extra-args=" + CPP] + (WP + [",".join(lists["proves"])] if by_wp(path) else EVA) + \
        options + then + ["-then", "-nonterm", "-nonterm-dead-code"] * (not by_wp(path)) + ["-then", "-report-csv", base + ".csv"]
    if os.path.exists(base + ".csv"):
        os.remove(base + ".csv")
    with open(base + ".log", "w") as out:
        try:
            status = subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, timeout=limit,
                                    env=dict(os.environ, WHY3CONFIG=os.path.join(folder, "why3.conf"))).returncode
        except subprocess.TimeoutExpired:
            status = f"no end after {limit} s"
    log = open(base + ".log").read()
    seconds = time.time() - start
    if status != 0:
        return name, [f"Frama-C: {status}"] + log.splitlines()[-5:], 0, 0, 0, seconds, lists
    return (name, *complaints(path, base, lists, log), seconds, lists)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("-j", type=int, default=os.cpu_count())
    parser.add_argument("-t", type=int, default=900)
    parser.add_argument("-o", required=True)
    parser.add_argument("file", nargs="+")
    args = parser.parse_args()
    os.makedirs(args.o, exist_ok=True)
    if not os.path.exists(os.path.join(args.o, "why3.conf")):
        subprocess.run(["why3", "-C", os.path.join(args.o, "why3.conf"), "config", "detect"],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    proven = {name for path in args.file for name in head(path)["proves"]}
    failed, sums = 0, [0, 0, 0]
    with concurrent.futures.ThreadPoolExecutor(args.j) as pool:
        for future in concurrent.futures.as_completed(pool.submit(prove, path, args.o, args.t) for path in args.file):
            name, bad, held, reached, total, seconds, lists = future.result()
            if len(args.file) > 1:
                bad += [f"assumes {f}, which no proof proves" for f in lists["assumes"] if f not in proven]
            print(f"{'FAIL' if bad else 'ok'} proof {name}: {len(lists['proves'])} functions, {reached} of {total} "
                  f"statements, {held} properties, {len(bad)} alarms, {seconds:.0f} s", flush=True)
            for line in bad[:12]:
                print("   " + line)
            failed += bool(bad)
            sums = [sums[0] + len(lists["proves"]), sums[1] + reached, sums[2] + held]
    print(f"# {len(args.file) - failed} of {len(args.file)} proofs: {sums[0]} functions, {sums[1]} statements, "
          f"{sums[2]} properties")
    sys.exit(failed != 0)


main()
