# SPDX-License-Identifier: MIT
"""The mutants of one C source: small changes to its tokens, each of which some test ought to see.

Left alone: comments, strings, preprocessor lines, asserts, attributes, declarations in headers, sizes of arrays, and all but each
16th number of a long table. A mutant keeps the line numbers of what it leaves.
"""
import re

TOKEN = re.compile(r'''(?P<skip>/\*.*?\*/|//[^\n]*|\s+|^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*)|(?P<text>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')|
    (?P<number>(?:0[xX][0-9a-fA-F]+|\d+)[uUlL]*)|(?P<name>[A-Za-z_]\w*)|
    (?P<sign><<=|>>=|\.\.\.|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)''', re.S | re.M | re.X)
TYPES = {"void", "char", "short", "int", "long", "unsigned", "signed", "const", "volatile", "struct", "union", "enum", "static",
         "_Bool", "_Thread_local", "raster_run", "extern", "register", "typedef"}
WORDS = {"return", "case", "sizeof", "else", "do", "goto", "_Alignas", "if", "while", "for", "switch", "break", "continue", "default"}
SWAPS = {"+": ["-"], "-": ["+"], "*": ["+"], "/": ["*"], "%": ["/"], "+=": ["-="], "-=": ["+="], "*=": ["+="], "/=": ["*="],
         "++": ["--"], "--": ["++"], "&": ["|"], "|": ["&"], "^": ["|"], "&=": ["|="], "|=": ["&="], "^=": ["|="],
         "<<": [">>"], ">>": ["<<"], "<<=": [">>="], ">>=": ["<<="], "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="],
         ">=": [">", "<"], "==": ["!="], "!=": ["=="], "&&": ["||"], "||": ["&&"]}
NAMES = {"fx_wrap_add": "fx_wrap_sub", "fx_wrap_sub": "fx_wrap_add", "fx_wrap_mul": "fx_wrap_add"}
EITHER = {"+", "-", "*", "&"}  # with one operand or two
ASSIGN = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "++", "--"}
CLOSE = {"(": ")", "[": "]", "{": "}"}
TABLE = 16


class Token:
    def __init__(self, kind, text, at):
        self.kind, self.text, self.at, self.end = kind, text, at, at + len(text)
        self.pair = self.function = None
        self.frozen = False


def tokens_of(text):
    tokens = [Token(m.lastgroup, m.group(), m.start()) for m in TOKEN.finditer(text) if m.lastgroup != "skip"]
    stack = []
    for i, token in enumerate(tokens):
        if token.kind == "sign" and token.text in CLOSE:
            stack.append(i)
        elif token.kind == "sign" and token.text in ")]}" and stack:
            token.pair = stack.pop()
            tokens[token.pair].pair = i
    return tokens


def is_type(token):
    return token.kind == "name" and (token.text in TYPES or token.text.endswith("_t"))


class Source:
    """One file: its tokens, and in which function each is."""

    def __init__(self, text, header):
        self.text, self.tokens = text, tokens_of(text)
        self.mark_functions()
        for i, token in enumerate(self.tokens):
            if header and token.function is None:
                token.frozen = True
            if token.text in ("assert", "_Static_assert", "FX_REQUIRE", "__attribute__", "__asm__", "sizeof", "_Alignas"):
                j = i + 1
                while self.tokens[j].text == "volatile":
                    j += 1
                for t in self.tokens[i:(self.tokens[j].pair or j) + 1]:
                    t.frozen = True
        self.mark_declarations()

    def mark_functions(self):
        tokens, i = self.tokens, 0
        while i < len(tokens):
            if tokens[i].text == "{" and tokens[i].pair:
                if tokens[i - 1].text == ")":
                    name = tokens[tokens[i - 1].pair - 1].text
                    for t in tokens[i:tokens[i].pair + 1]:
                        t.function = name
                elif sum(t.kind == "number" for t in tokens[i:tokens[i].pair]) > TABLE:
                    numbers = [t for t in tokens[i:tokens[i].pair] if t.kind == "number"]
                    for k, t in enumerate(numbers):
                        t.frozen = k % TABLE != 0
                i = tokens[i].pair
            i += 1
        for i, token in enumerate(tokens):  # outside functions only what initialises is of interest
            if token.function is None and token.text in ("struct", "enum", "union") and i + 2 < len(tokens):
                brace = i + 1 if tokens[i + 1].text == "{" else i + 2
                if tokens[brace].text == "{" and tokens[brace].pair:
                    for t in tokens[i:tokens[brace].pair + 1]:
                        t.frozen = True

    def mark_declarations(self):
        """Sizes of arrays, and the stars of pointers."""
        tokens = self.tokens
        for i in range(1, len(tokens)):
            if tokens[i].text == "[" and tokens[i].pair and self.declares(i):
                for t in tokens[i:tokens[i].pair + 1]:
                    t.frozen = True
            if tokens[i].text == "*" and (is_type(tokens[i - 1]) or tokens[i - 2].text in ("struct", "union", "enum")):
                tokens[i].frozen = True

    def declares(self, bracket):
        """Whether what stands before a bracket is a name being declared."""
        i, tokens = bracket - 1, self.tokens
        while tokens[i].text == "]":
            i = tokens[i].pair - 1
        if tokens[i].kind != "name" or i == 0:
            return False
        before = tokens[i - 1]
        if before.kind == "name":
            return before.text not in WORDS
        while i > 0 and tokens[i].text not in (";", "{", "}", "=", "(", "return"):
            i = tokens[i].pair if tokens[i].text in (")", "]") and tokens[i].pair else i
            i -= 1
        return tokens[i].text in (";", "{", "}") and is_type(tokens[i + 1])

    def starts(self):
        """Indices of the first tokens of statements."""
        tokens, found = self.tokens, []
        for i, token in enumerate(tokens[1:], 1):
            before = tokens[i - 1]
            if token.function is None or token.function != before.function:
                continue
            if before.text in ("{", "}", ";", "else", "do"):
                found.append(i)
            elif before.text == ")" and tokens[before.pair - 1].text in ("if", "while", "for", "switch"):
                found.append(i)
            elif before.text == ":" and (tokens[i - 2].text == "default" or tokens[i - 3].text == "case"):
                found.append(i)
        inside = set()
        for i, token in enumerate(tokens):  # the parts of a for are no statements
            if token.text == "for" and tokens[i + 1].pair:
                inside.update(range(i + 1, tokens[i + 1].pair))
        return [i for i in found if i not in inside]

    def is_cast(self, i):
        """Whether the parenthesis that ends here holds a type."""
        first = self.tokens[i].pair
        inner = self.tokens[first + 1:i]
        return bool(inner) and (is_type(inner[0])) and all(t.kind == "name" or t.text == "*" for t in inner)

    def is_binary(self, i):
        before = self.tokens[i - 1]
        if before.kind in ("number", "text"):
            return True
        if before.kind == "name":
            return before.text not in WORDS
        return before.text == "]" or (before.text == ")" and not self.is_cast(i - 1))

    def end_of(self, i, stops):
        """The first token from i, not within brackets, that is one of stops or closes what i is in."""
        tokens, deep = self.tokens, 0
        while i < len(tokens):
            text = tokens[i].text
            if tokens[i].kind == "sign" and text in CLOSE and tokens[i].pair:
                i = tokens[i].pair
            elif text in (")", "]", "}") or (text in stops and not deep):
                return i
            elif text == "?":
                deep += 1
            elif text == ":":
                deep -= 1
            i += 1
        return i


def numbers_near(text, shift):
    body = text.rstrip("uUlL")
    value, suffix = int(body, 0) if body[:2] in ("0x", "0X") else int(body), text[len(body):]
    near = [value + 1] + ([value - 1] if value > 0 else []) + ([0] if value > 1 and not shift else [])
    return [(hex(v) if body[:2] in ("0x", "0X") else str(v)) + suffix for v in near]


def edits(source):
    """Each change as (name, from, to, replacement)."""
    tokens = source.tokens
    for i, t in enumerate(tokens):
        if not t.frozen and t.text in NAMES:
            yield ("operator", t.at, t.end, NAMES[t.text])
        if t.frozen or t.kind in ("text", "name"):
            continue
        if t.kind == "number":
            shift = tokens[i - 1].text in ("<<", ">>", "<<=", ">>=")
            for near in numbers_near(t.text, shift):
                yield ("shift" if shift else "constant", t.at, t.end, near)
            continue
        two = t.text not in EITHER or source.is_binary(i)
        if two and not (t.text == "++" and tokens[i - 1].text == "*"):
            for other in SWAPS.get(t.text, []):
                yield ("operator", t.at, t.end, other)
        elif t.text == "-":
            yield ("sign", t.at, t.end, "")
        if t.text in ("!", "~"):
            yield ("not", t.at, t.end, "")
        if t.text == "?":
            colon = source.end_of(i + 1, (":",))
            end = source.end_of(colon + 1, (",", ";", ":"))
            if colon < len(tokens) and tokens[colon].text == ":" and end > colon + 1:
                yes, no = (source.text[tokens[a].at:tokens[b].end] for a, b in ((i + 1, colon - 1), (colon + 1, end - 1)))
                yield ("branches", tokens[i + 1].at, tokens[end - 1].end,
                       no + source.text[tokens[colon - 1].end:tokens[colon + 1].at] + yes)
        if t.text == "(" and t.pair and i and t.function:
            before = tokens[i - 1]
            if before.text in ("if", "while"):
                yield ("negate", t.end, tokens[t.pair].at, "!(" + source.text[t.end:tokens[t.pair].at] + ")")
            elif before.kind == "name" and before.text not in WORDS and before.text not in TYPES:
                yield from arguments(source, i)
    yield from statements(source)


def arguments(source, i):
    """Neighbours swapped in the call whose parenthesis is token i."""
    tokens, parts, first = source.tokens, [], i + 1
    while first < tokens[i].pair:
        last = source.end_of(first, (",",))
        parts.append((tokens[first].at, tokens[last - 1].end))
        first = last + 1
    for (a, b), (c, d) in zip(parts, parts[1:]):
        if source.text[a:b] != source.text[c:d]:
            yield ("arguments", a, d, source.text[c:d] + source.text[b:c] + source.text[a:b])


def statements(source):
    """Without one statement."""
    tokens = source.tokens
    for i in source.starts():
        t = tokens[i]
        if t.frozen or t.text in ("{", "}", ";") or (t.kind == "name" and (t.text in WORDS - {"break", "continue"} or is_type(t))):
            continue
        end = source.end_of(i, (";",))
        body = tokens[i:end]
        if end >= len(tokens) or tokens[end].text != ";":
            continue
        if t.text in ("break", "continue") or any(b.text in ASSIGN for b in body) or (t.kind == "name" and tokens[i + 1].text == "("):
            yield ("statement", t.at, tokens[end - 1].end, "")


def brief(text):
    return " ".join(text.split())


class Mutant:
    """One change. Its key holds the line, and what in it becomes what; @2: the second of several that read alike."""

    def __init__(self, path, source, function, edit):
        self.kind, self.at, self.end, new = edit
        text = source.text
        start, stop, old = text.rfind("\n", 0, self.at) + 1, text.find("\n", self.end), text[self.at:self.end]
        self.path, self.function, self.number = path, function, text.count("\n", 0, self.at) + 1
        self.new = new + "\n" * (old.count("\n") - new.count("\n"))
        nth = text.count(old, start, self.at) + 1 if old else 1
        self.change = "%s -> %s%s" % (brief(old), brief(new), " @%d" % nth if nth > 1 else "")
        self.key = "%s | %s | %s | %s" % (path, function, brief(text[start:stop]), self.change)

    def text(self, original):
        return original[:self.at] + self.new + original[self.end:]


def mutants_of(path, text, active):
    """All mutants of a file, of the lines in `active`, in the order of the text. Like ones are told apart by #2, #3."""
    source = Source(text, path.endswith(".h"))
    functions = {t.at: t.function for t in source.tokens}
    ats = sorted(functions)
    seen, found = {}, []
    for edit in sorted(edits(source), key=lambda e: (e[1], e[2], e[3])):
        at = next(a for a in ats if a >= edit[1])
        mutant = Mutant(path, source, functions[at] or "-", edit)
        if mutant.number not in active:
            continue
        seen[mutant.key] = seen.get(mutant.key, 0) + 1
        if seen[mutant.key] > 1:
            mutant.key += " #%d" % seen[mutant.key]
        found.append(mutant)
    return found
