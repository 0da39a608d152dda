#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""coverage.py EXCEPTIONS PROFILE OBJECT...: what of firmware/ was reached, by file: lines, branches, MC/DC.

What was not reached has to stand in EXCEPTIONS, lines `file | function | source text, what is missing | reason`, once for
each occurrence; and what stands there has to be missing, unless its reason begins with `in some runs: `. Missing is: a
function `never called`; a condition of && and || that was `never shown to decide alone` (MC/DC: two runs that differ in it
and in the outcome alone); any other condition `never true` or `never false`; a case of a switch `never taken`. Code that
several files include counts once: reached by any of them.
"""
import json, os, re, subprocess, sys
from collections import Counter, defaultdict

TOOL = 'llvm-cov-19'
CODE, BRANCH, MCDC_BRANCH = 0, 4, 6  # kinds of regions
CONSTANT = re.compile(r'^[!(\s]*(USES\([^a-z]*\)|[A-Z_0-9]+|sizeof .*)[)\s]*([=!<>]=? [A-Z0-9_]+)?[)\s]*$')


class Source:
    """The texts of the files, which exceptions are known by: line numbers would change with every edit."""

    def __init__(self):
        self.files = {}

    def lines(self, path):
        if path not in self.files:
            self.files[path] = open(path).read().split('\n')
        return self.files[path]

    def text(self, path, place):
        first, left, last, right = place
        lines = self.lines(path)[first - 1:last]
        if (first, left) == (last, right):  # a macro of the compiler's: what it stands in
            return lines[0].strip()
        lines[-1] = lines[-1][:right - 1]
        lines[0] = lines[0][left - 1:]
        return re.sub(r'\s+', ' ', re.sub(r'/\*.*?\*/', '', ' '.join(lines))).strip()


def conditions(text):
    """The operands of a decision's && and ||, in order."""
    parts, depth, begin, at = [], [], 0, 0
    while at < len(text):
        if text[at] == '(':
            depth.append(bool(re.search(r'[\w)\]]\s*$', text[:at])) and not re.search(r'\breturn\s*$', text[:at]))
        elif text[at] == ')':
            depth and depth.pop()
        elif text[at:at + 2] in ('&&', '||') and not any(depth):
            parts.append(text[begin:at])
            begin = at = at + 2
            continue
        at += 1
    parts.append(text[begin:])
    return [trim(part) for part in parts]


def trim(part):
    """Without the brackets of the whole that were cut open."""
    part = part.strip()
    while part.count('(') > part.count(')') and part.lstrip('!').startswith('('):
        part = part.lstrip('!')[1:].strip()
    while part.count(')') > part.count('('):
        part = part[:-1].strip()
    return part


def is_case(text):
    return re.match(r'(case\b|default\b)', text) is not None


class Cover:
    def __init__(self, data, source, root):
        self.source, self.root = source, root
        self.called = Counter()             # by (file, place) of a function, how often
        self.names = {}                     # of it
        self.code = Counter()               # by (file, function, place)
        self.branches = defaultdict(lambda: [0, 0])
        self.pairs = {}                     # by (file, function, place): a bool a condition
        for function in data['functions']:
            self.add(function)

    def path(self, name):
        name = os.path.relpath(name, self.root)
        return name if name.startswith('firmware/') else None

    def add(self, function):
        files = [self.path(name) for name in function['filenames']]
        if not files[0]:
            return
        first = function['regions'][0]
        key = (files[0], tuple(first[:4]))
        self.called[key] += first[4]
        self.names[key] = function['name'].split(':')[-1]
        for region in function['regions']:
            if region[7] == CODE and files[region[5]]:
                self.code[files[region[5]], key, tuple(region[:4])] += region[4]
        for branch in function['branches']:
            if files[branch[6]]:
                sides = self.branches[files[branch[6]], key, tuple(branch[:4]), branch[8]]
                sides[0] += branch[4]
                sides[1] += branch[5]
        for record in function['mcdc_records']:
            place = (files[0], key, tuple(record[:4]))
            old = self.pairs.get(place, [False] * len(record[6]))
            self.pairs[place] = [a or b for a, b in zip(old, record[6])]

    def decisions(self):
        """(file, function, text, decided, how often the whole was asked) for each condition of && and ||."""
        for (path, key, place), pairs in sorted(self.pairs.items()):
            texts = conditions(self.source.text(path, place))
            if len(texts) != len(pairs):
                sys.exit(f'{path}:{place[0]}: {len(pairs)} conditions, not {texts}')
            for text, decided in zip(texts, pairs):
                if not CONSTANT.match(text):
                    yield path, key, text, decided, self.code.get((path, key, place), 1)

    def sides(self):
        """(file, function, text, kind, true, false) for each condition or case."""
        for (path, key, place, kind), (true, false) in sorted(self.branches.items()):
            text = self.source.text(path, place)
            if not CONSTANT.match(text):
                yield path, key, text, kind, true, false

    def is_constant(self, path, place):
        """Whether code is the side not taken of a constant condition: of USES(), or within a macro."""
        lines = self.source.lines(path)
        return 'USES(' in lines[place[0] - 1] or lines[place[0] - 1].startswith('#define') or lines[place[0] - 2].endswith('\\')

    def missing(self):
        """(file, function, what), as often as it occurs."""
        found = Counter()
        for key, count in self.called.items():
            if not count:
                found[key[0], self.names[key], 'never called'] += 1
        for path, key, text, decided, evaluated in self.decisions():
            if evaluated and not decided:
                found[path, self.names[key], text + ' never shown to decide alone'] += 1
        for path, key, text, kind, true, false in self.sides():
            if kind == BRANCH and self.called[key]:
                if is_case(text):
                    if not true:
                        found[path, self.names[key], text + ' never taken'] += 1
                elif false and not true:
                    found[path, self.names[key], text + ' never true'] += 1
                elif true and not false:
                    found[path, self.names[key], text + ' never false'] += 1
        explained = {(path, name) for path, name, _ in found}
        for (path, key, place), count in self.code.items():
            name = self.names[key]
            line = self.source.lines(path)[place[0] - 1].strip()
            if not count and self.called[key] and (path, name) not in explained and not self.is_constant(path, place):
                found[path, name, line + ' never reached'] += 1
        return found

    def table(self):
        """By file: [reached, all] lines, branches, conditions."""
        rows = defaultdict(lambda: [[0, 0], [0, 0], [0, 0]])
        for path, lines in self.line_counts().items():
            rows[path][0] = [sum(1 for count in lines.values() if count), len(lines)]
        for path, _, text, kind, true, false in self.sides():
            case = is_case(text)
            rows[path][1][0] += (true > 0) + (false > 0 and not case)
            rows[path][1][1] += 1 if case else 2
        for path, _, _, decided, _ in self.decisions():
            rows[path][2][0] += decided
            rows[path][2][1] += 1
        return rows

    def line_counts(self):
        """A line's count is that of the smallest region that begins in it or else holds it."""
        lines = defaultdict(dict)
        for (path, _, place), count in sorted(self.code.items(), key=lambda item: item[0][2][0] - item[0][2][2]):
            for line in range(place[0], place[2] + 1):
                lines[path][line] = count
        for (path, _, place), count in self.code.items():
            lines[path][place[0]] = max(lines[path][place[0]], count)
        return lines


def read_exceptions(path):
    wanted, timely = Counter(), set()
    for number, line in enumerate(open(path), 1):
        if line.strip() and not line.startswith('#'):
            fields = [field.strip() for field in line.split(' | ')]
            if len(fields) != 4 or not fields[3]:
                sys.exit(f'{path}:{number}: not `file | function | what | reason`')
            wanted[tuple(fields[:3])] += 1
            if fields[3].startswith('in some runs: '):
                timely.add(tuple(fields[:3]))
    return wanted, timely


def main():
    exceptions, profile, *objects = sys.argv[1:]
    command = [TOOL, 'export', '-instr-profile', profile]
    for name in objects:
        command += ['-object', name]
    run = subprocess.run(command, stdout=subprocess.PIPE, check=True)
    cover = Cover(json.loads(run.stdout)['data'][0], Source(), os.getcwd())
    missing, (wanted, timely) = cover.missing(), read_exceptions(exceptions)
    failed = set()
    sums = [[0, 0], [0, 0], [0, 0]]
    complaints = []
    for what, count in sorted((missing - wanted).items()):
        failed.add(what[0])
        complaints.append((what, count, 'not reached, and no exception'))
    for what, count in sorted((wanted - missing).items()):
        if what in timely:
            continue
        failed.add(what[0])
        complaints.append((what, count, 'an exception, but reached or not there'))
    rows = cover.table()
    for path in sorted(rows):
        counts = ', '.join(f'{name} {reached} of {every}' for name, (reached, every) in
                           zip(('lines', 'branches', 'MC/DC'), rows[path]) if every)
        listed = sum(count for what, count in wanted.items() if what[0] == path)
        print(f"{'FAIL' if path in failed else 'ok'} {path}: {counts}{f', {listed} exceptions' if listed else ''}")
        for total, row in zip(sums, rows[path]):
            total[0] += row[0]
            total[1] += row[1]
    for (path, function, what), count, why in complaints:
        print(f"# {why}{f', {count} times' if count > 1 else ''}: {path} | {function} | {what} |")
    print('# in all: ' + ', '.join(f'{name} {reached} of {every} ({100 * reached / every:.2f} %)' for name, (reached, every) in
                                   zip(('lines', 'branches', 'MC/DC conditions'), sums)) +
          f', {sum(wanted.values())} exceptions, {sum((missing - wanted).values())} open')
    return 1 if complaints else 0


sys.exit(main())
