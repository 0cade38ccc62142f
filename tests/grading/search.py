"""Search, in a process of its own, for one change of a student's function with which all of its checks pass.

A rule of rules.py says which code becomes which. A change is made in the syntax tree, in no file, the smallest first.
"""

import ast
import builtins
import json
import os
import re
import subprocess
import sys
from collections import defaultdict
from contextlib import suppress
from copy import deepcopy
from itertools import combinations, pairwise, permutations, product
from numbers import Real
from pathlib import Path
from tempfile import TemporaryDirectory

from grading.begin import ROOT

from vpython import scene

from grading import grader, limits
from grading.evidence import is_idle
from grading.handout import FUNCTIONS
from grading.own_process import OwnProcess, working_in
from grading.rules import EXPRESSIONS, KEYS, LINES, NUMBERS
from support.pendulum import discarded

SECONDS, A_CHANGE = 6.0, 0.5  # s for the whole search, and for one change
SHORT = 48  # characters of code in the words
KINDS = {"n": ast.Name, "o": ast.BinOp, "s": ast.Constant, "z": ast.Constant}  # of what a letter of a rule stands for
TYPES = {"d": dict, "l": (list, tuple, dict), "x": Real}  # of its value, if it is known
BLOCKS = {ast.For: "loop", ast.While: "loop", ast.If: "if"}
HERE, ONE = "One change in this line makes all checks pass: ", "One change makes all checks pass: "


def one_change(check, line=0) -> list | None:
    """Return the line of a change with which all checks of the function pass, and its words; None if none is found.

    check is the first one that fails, and line is the one that stopped it, if so.
    """
    tests = str(ROOT / "tests")
    command = [sys.executable, "-B", "-W", "ignore", "-m", "grading.search", check.function, check.name, str(line)]
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        own = {**os.environ, "PYTHONPATH": tests, **dict.fromkeys(("TMPDIR", "TEMP", "TMP"), folder)}
        options = {"env": own, "cwd": tests, "stdin": subprocess.DEVNULL, "capture_output": True, "timeout": SECONDS}
        with suppress(OSError, ValueError, subprocess.TimeoutExpired):
            return json.loads(subprocess.run(command, check=False, **options).stdout)
    return None


class Quick(OwnProcess):
    """It calls the student's functions, and lets their errors pass."""

    def run(self, function, arguments, times=1):
        try:
            return self.repeated(self.find(function), function, arguments, times)
        finally:
            self.put_back()


def main(function, first, line) -> None:
    """Print what first_change returns, as JSON. first is the name of the check that fails."""
    answer = os.fdopen(os.dup(1), "w")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # for what the student's code prints
    grader.runner = Quick()
    scope = grader.runner.find(function).__globals__
    if function != "extract_and_convert" and "extract_and_convert" in scope:
        scope["extract_and_convert"] = remembering(scope["extract_and_convert"])
    tree = ast.parse((ROOT / FUNCTIONS[function].file).read_bytes())
    own = [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == function][-1]
    with limits.limited_memory(), limits.without_ends(), working_in(grader.runner.folder.name):
        print(json.dumps(first_change(own, scope, first, int(line))), file=answer, flush=True)


def first_change(own, scope, first, line) -> tuple[int, str] | None:
    """Return the line and the words of the first change of a function (its tree own) with which all checks pass."""
    checks = sorted(grader.checks(function=own.name), key=lambda check: check.name != first)
    types = types_in(scope[own.name].__code__, checks[0])
    idle = [place for place in places(own) if isinstance(place[0], ast.Expr) and is_idle(place[0])]
    silent = [(where, key, ast.Pass()) for _, where, key, *_ in idle]

    def is_right(edits):
        return made(own, edits, scope) and all(map(passes, checks))

    if is_right(silent):  # a print can fail, too, and its values can change a list
        words = "Without your prints, all checks pass: a print stops your function, or changes its result."
        return (idle[0][0].lineno, words) if idle else None
    for is_here in (True, False) if line else (False,):  # first in the line that has stopped
        for at, words, edits in changes(own, scope, types):
            if (at == line) == is_here and is_right(silent + edits):
                return at, words if is_right(edits) else f"Without your prints, {words[0].lower()}{words[1:]}"
    return None


def types_in(code, check) -> dict[str, set]:
    """Return the types of the values of the names in a function with this code, while the check runs."""
    types = defaultdict(set)

    def note(frame, *_):
        for name, value in frame.f_locals.items() if frame.f_code is code else ():
            types[name].add(type(value))
        return note if frame.f_code is code else None

    sys.settrace(note)
    passes(check)
    sys.settrace(None)
    return types


def remembering(extract):
    """Return a right extract_and_convert that reads a file once: pandas takes most of the time of a change."""
    known: dict[bytes, list] = {}

    def remembered(relative_filepath):
        content = Path(relative_filepath).read_bytes()
        known[content] = known.get(content) or extract(relative_filepath)
        return deepcopy(known[content])

    return remembered


def made(function, edits, scope) -> bool:
    """Put the function with these edits into its module; return whether Python can compile it."""
    before = [where[key] for where, key, _ in edits]
    try:
        for where, key, new in edits:
            where[key] = ast.fix_missing_locations(new)
        compared = [one for one in ast.walk(function) if isinstance(one, ast.Compare)]
        if any(text(one.left) == text(one.comparators[0]) for one in compared):
            return False  # nobody means a comparison with the same on both sides
        exec(compile(ast.Module([function], []), "<change>", "exec"), scope)
    except Exception:  # also a SystemError: the tree has a form that Python cannot take
        return False
    finally:
        for (where, key, _), old in zip(edits, before, strict=True):
            where[key] = old
    return True


def passes(check) -> bool:
    scene._made.clear()
    discarded.clear()
    try:
        with limits.patience(A_CHANGE):
            check.ask()
    except BaseException:
        return False
    return True


def match(pattern, node, found) -> bool:
    """Return whether a node has the form of a pattern, and note in found what its letters stand for."""
    if isinstance(pattern, list):
        letter = getattr(getattr(pattern[0], "value", None), "id", "") if len(pattern) == 1 else ""
        if letter in ("B", "C"):
            found[letter] = node  # the lines of a block; an elif is none of a block
            return bool(node) and (letter == "B" or node[0].col_offset >= found["B"][0].col_offset)
        return len(pattern) == len(node) and all(match(*pair, found) for pair in zip(pattern, node, strict=True))
    if isinstance(pattern, ast.Name) and len(pattern.id) == 1:
        found[pattern.id] = node
        is_text = isinstance(getattr(node, "value", None), str)
        is_right = (pattern.id == "s") == is_text if pattern.id in "sz" else True
        is_right &= pattern.id != "v" or not isinstance(node, (ast.Constant, ast.Compare, ast.BoolOp, ast.Tuple))
        return is_right and isinstance(node, KINDS.get(pattern.id, ast.expr))
    if not isinstance(pattern, ast.AST):
        found |= {"n": ast.Name(node, ast.Load())} if pattern == "n" else {}  # the name behind a dot
        return pattern in ("n", node)
    fields = [field for field in pattern._fields if field not in ("ctx", "kind", "type_comment", "simple")]
    return type(pattern) is type(node) and all(match(getattr(pattern, f), getattr(node, f), found) for f in fields)


class Filled(ast.NodeTransformer):
    """Puts what letters stand for into the tree of a rule."""

    def __init__(self, letters):
        self.letters = letters

    def visit_Name(self, node):
        if node.id == "Q":  # what a text says
            return ast.parse(self.letters["s"].value, mode="eval").body
        one = self.letters.get(node.id, node)
        if hasattr(one, "ctx") and type(one.ctx) is not type(node.ctx):
            both = ast.parse(f"{ast.unparse(one)} = {ast.unparse(one)}").body[0]
            return both.value if isinstance(node.ctx, ast.Load) else both.targets[0]
        return one

    def visit_Constant(self, node):
        return ast.Constant(self.letters["n"].id) if node.value == "n" else node

    def visit_Expr(self, node):
        one = self.letters.get(getattr(node.value, "id", ""))
        return one if isinstance(one, list) else self.generic_visit(node)


def can_be(node, letter, types) -> bool:
    """Return whether a name can have a value of the type that a letter of a rule stands for."""
    known = types.get(getattr(node, "id", "")) if letter.lower() in TYPES else None
    return not known or any(issubclass(one, TYPES[letter.lower()]) for one in known)


def by_rules(rules, node, choices, types):
    """Yield (kind, new, words) for each rule that fits a node; kind: its number, names, texts, numbers, and choices."""
    for number, (before, after, free, words) in enumerate(rules):
        found: dict = {}
        if match(before, node, found) and all(can_be(one, letter, types) for letter, one in found.items()):
            shown = {letter: text(one) for letter, one in found.items() if not isinstance(one, list)}
            fixed = tuple(shown[letter] for letter in found if letter in "nsz")
            for chosen in product(*(choices[one] for one in free)):
                with suppress(SyntaxError, ValueError):  # a text that is no expression
                    new = Filled({**found, **dict(zip(free, chosen, strict=True))}).visit(deepcopy(after))
                    new = block(new.body) if isinstance(new, ast.Module) else new
                    yield (number, fixed, tuple(map(ast.unparse, chosen))), new, words.format(**shown)


def block(lines):
    """Return lines as one statement."""
    return lines[0] if len(lines) == 1 else ast.If(ast.Constant(True), lines or [ast.Pass()], [])


def text(node) -> str:
    """Return the code of a node in one line, shortened."""
    code = ast.unparse(node).partition("\n")[0]
    return code if len(code) <= SHORT else f"{code[: SHORT - 3]}..."


def choices_in(function, scope, types) -> dict[str, list]:
    """Return the nodes that the search tries for each large letter of a rule."""
    nodes = [*ast.walk(function)]
    names = [node for node in nodes if isinstance(node, ast.Name)]
    own = [*(one.arg for one in function.args.args), *(one.id for one in names if isinstance(one.ctx, ast.Store))]
    own += [one for one in scope if one.isupper() and function.name == "main"]
    ids = {"N": own, "U": [one.id for one in names if one.id not in {*own, *scope, *dir(builtins)}]}
    ids["F"] = [one for one in scope if callable(scope[one]) and not one.startswith("_")]
    found = {letter: [ast.Name(one, ast.Load()) for one in dict.fromkeys(ids[letter])] for letter in ids}
    found["U"] += [ast.Tuple([*found["U"]], ast.Load())] * (len(found["U"]) > 1)
    found |= {letter: [one for one in found["N"] if can_be(one, letter, types)] for letter in "DELX"}
    elements = {ast.unparse(node): deepcopy(node) for node in nodes if isinstance(node, ast.Subscript)}
    return {**found, "K": [*map(ast.Constant, KEYS)], "Z": [*map(ast.Constant, NUMBERS)], "S": [*elements.values()]}


def changes(function, scope, types):
    """Yield the changes of a function (its tree), the smallest first: the line, the words, and the edits, each as a
    place (a list and an index, or the fields of a node and one of them) and the node that is put there.
    """
    choices = choices_in(function, scope, types)
    for rank in range(len(EXPRESSIONS)):
        groups = defaultdict(list)  # the same change at several places: of one kind, in one line, or in two lines
        for node, where, key, around, path, is_printed in places(function):
            is_line = isinstance(node, ast.stmt)
            found = [*by_rules((LINES if is_line else EXPRESSIONS)[rank], node, choices, types)]
            stem = re.sub(r"\d", "", ast.unparse(node))
            for kind, new, words in found + [*of_row(rank, node, choices["N"])]:
                one = node.lineno, words, [(where, key, new)]
                same = [(*kind[::2], how) for how in (node.lineno, (stem, node.lineno), path, re.sub(r"\d", "", path))]
                for group in dict.fromkeys((kind, *same[: 4 * (not is_line)])) if rank < 3 else ():
                    groups[is_line, group].append(one)
                inside = "" if around is node else f"in {text(around)}, "
                if not is_printed:
                    yield node.lineno, f"{HERE}{inside}{words}.", one[2]
            yield from moved(where, key) if rank == 1 and is_line else ()
        lines = sorted({node.lineno for node in ast.walk(function) if isinstance(node, ast.stmt)})
        numbers = {line: sum(begin <= line for begin in lines) for line in range(function.end_lineno + 1)}
        for group in sorted(groups.values(), key=len):  # also two in lines that follow each other
            pairs = [pair for pair in pairwise(group) if numbers[pair[1][0]] - numbers[pair[0][0]] < 2]
            yield from map(together, [group] * (len(group) > 1) + pairs * (len(group) > 2))
        last, pairs = function.body[-1], permutations(choices["X"], 2)
        for value in [*choices["N"], *(ast.Tuple([*pair], ast.Load()) for pair in pairs)]:
            words = f"{ONE}a line with return is missing below this line, at the end of the function."
            if rank == 1 and FUNCTIONS[function.name].returns:
                yield last.end_lineno, words, [(function.body, -1, block([last, ast.Return(value)]))]


def together(group) -> tuple[int, str, list]:
    """Return the same change at several places as one."""
    lines = sorted({line for line, _, _ in group})
    at = f"in lines {', '.join(map(str, lines))}" if len(lines) > 1 else "at several places in this line"
    others = ", and likewise at the others" * (len({words for _, words, _ in group}) > 1)
    words = f"One change, made {at}, makes all checks pass: {group[0][1]}{others}."
    return lines[0], words, [edit for _, _, edits in group for edit in edits]


def places(node, around=None, path="", is_printed=False):
    """Yield each expression and line in a node, its place, what is around it, its path, and whether it is printed."""
    for field, value in ast.iter_fields(node):
        pairs = [(value, i) for i in range(len(value))] if isinstance(value, list) else [(vars(node), field)]
        for where, key in pairs if field != "returns" else ():
            one = where[key]
            if isinstance(one, (ast.expr, ast.stmt, ast.comprehension, ast.keyword)):
                is_line, is_part = isinstance(one, ast.stmt), isinstance(one, ast.expr)
                outer = around if around and len(ast.unparse(around)) <= SHORT else one
                below = "" if is_line else f"{path}.{field}{key if isinstance(where, list) else ''}"
                is_text = isinstance(one, ast.Expr) and isinstance(one.value, ast.Constant)
                is_target = isinstance(getattr(one, "ctx", None), ast.Store)
                is_elif = field == "orelse" and has_elif(node)
                if (is_line or is_part) and not (is_text or is_target or is_elif):
                    yield one, where, key, outer, below, is_printed
                yield from places(one, outer if is_part else None, below, is_printed or is_idle(one))


def has_elif(node) -> bool:
    return isinstance(node, ast.If) and [one.col_offset for one in node.orelse] == [node.col_offset]


def of_row(rank, node, names):
    """Yield the changes of the values of a call or a tuple, as by_rules."""
    if not isinstance(node, (ast.Call, ast.Tuple, ast.List)):
        return
    field, rows, orders = "args" if isinstance(node, ast.Call) else "elts", [], []
    given, place = getattr(node, field), f"in the ( ) of {text(node.func)}" if field == "args" else f"in {text(node)}"
    some, gaps = range(len(given)), range(len(given) + 1)
    if rank == 1:
        rows = [(given[:i] + given[i + 1 :], f"{text(one)} does not belong {place}") for i, one in enumerate(given)]
        orders = [[{i: j, j: i}.get(k, k) for k in some] for i, j in combinations(some, 2)]
        orders += [[*some[:i], *some[j:k], *some[i:j], *some[k:]] for i, j, k in combinations(gaps, 3)]
    if rank == 2:
        rows = [([*given[:i], one, *given[i:]], f"one more value belongs {place}") for i, one in product(gaps, names)]
    if rank == 3 and len(given) < 6:
        orders = permutations(some)
    rows += [([given[k] for k in order], f"another order belongs {place}") for order in orders]
    for number, (values, words) in enumerate(rows):
        yield (field, place, number), changed(node, field, values), words


def changed(node, field, values):
    """Return a node with other values in this field; a block is never empty."""
    values = values or [ast.Pass()] * isinstance(node, ast.stmt)
    return type(node)(**{**vars(node), field: values})


def moved(lines, i):
    """Yield the changes that move lines: below the next one, or into a block, or out of it."""

    def to(some, words, *edits):
        end = some[-1].end_lineno
        what = "this line belongs" if some[0].lineno == end else f"this line and all lines to line {end} belong"
        return some[0].lineno, f"{ONE}{what} {words}.", [*edits]

    line, after = lines[i], lines[i + 1 :]
    for j in range(len(lines)):
        rest = [*lines[:i], *after]
        order = enumerate([*rest[:j], line, *rest[j:]])
        if i != j:
            at, kind = lines[j], BLOCKS.get(type(lines[j]))
            end = f"the {kind} of line {at.lineno}, not in it" if kind else f"line {at.end_lineno}"
            words = f"below {end}" if j > i else f"above line {at.lineno}"
            yield to([line], words, *((lines, k, one) for k, one in order))
    fields = ["body"] if has_elif(line) else ["body", "orelse"]
    fields = [field for field in fields if type(line) in BLOCKS and getattr(line, field)]
    for field, k in product(fields, range(1, 1 + max(len(lines), len(getattr(line, "body", []))))):
        own, above, below = getattr(line, field), lines[max(i - k, 0) : i], after[:k]
        name = f"the {'else that belongs to the ' * (field == 'orelse')}{BLOCKS[type(line)]} of line {line.lineno}"
        if k <= len(own):
            first, last = changed(line, field, own[:-k]), changed(line, field, own[k:])
            yield to(own[-k:], f"below {name}, not in it", (lines, i, block([first, *own[-k:]])))
            yield to(own[:k], f"above {name}, not in it", (lines, i, block([*own[:k], last])))
        for some, body, first in ((above, [*above, *own], i - k), (below, [*own, *below], i + 1)):
            if len(some) == k:
                gone = [(lines, first + j, ast.Pass()) for j in range(k)]
                yield to(some, f"in {name}", (lines, i, changed(line, field, body)), *gone)


if __name__ == "__main__":
    main(*sys.argv[1:])
