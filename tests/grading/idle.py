"""What has no effect in the code of a student's function: hints.txt has words for it."""

import ast
from contextlib import suppress
from itertools import pairwise
from textwrap import dedent

ENDS = ast.Return, ast.Raise, ast.Break, ast.Continue
EFFECTS = ast.Call, ast.Constant, ast.Yield, ast.YieldFrom, ast.Await


def idle_in(source, first) -> str:
    """Return what has no effect in the source of a function, a line each; first is the number of its first line.

    "For 13 pend": the for in line 13 sets pend, which no line uses. "BinOp 14 2 * e": this value is not stored.
    """
    with suppress(SyntaxError, ValueError, IndexError, AttributeError, RecursionError, MemoryError):  # also no function
        function = ast.parse(dedent(source)).body[0]
        return "".join(f"{kind} {line + first - 1} {what}\n" for kind, line, what in idle_parts(function))
    return ""


def idle_parts(function):
    """Yield what has no effect in a function: its kind, its line, and a name or code."""
    nodes = [*ast.walk(function)]
    names = sorted((node for node in nodes if isinstance(node, ast.Name)), key=lambda node: -node.lineno)
    read = {"_", *(node.id for node in names if not isinstance(node.ctx, ast.Store))}
    for block in (getattr(node, part, None) for node in nodes for part in ("body", "orelse")):
        for node, after in pairwise([*block, None] if isinstance(block, list) else ()):
            if isinstance(node, ENDS) and after:
                yield "below", after.lineno, ast.unparse(node).split()[0]
            if isinstance(node, ast.Expr) and not isinstance(node.value, EFFECTS):
                yield type(node.value).__name__, node.lineno, ast.unparse(node)
            yield from ((type(node).__name__, node.lineno, names[0]) for names in named_by(node) if not read & {*names})
    for name in [each.arg for each in function.args.args]:
        first = {type(node.ctx): node.lineno for node in names if node.id == name}
        if ast.Load not in first:
            yield "parameter", function.lineno, name
        elif first.get(ast.Store, first[ast.Load]) < first[ast.Load]:
            yield "lost", first[ast.Store], name


def named_by(node) -> list[list[str]]:
    """Return the names that a line with = , for or def gives to a value; a, b = ... has two."""
    targets = [target for target in getattr(node, "targets", [getattr(node, "target", None)]) if target]
    named = [[one.id for one in getattr(target, "elts", [target]) if isinstance(one, ast.Name)] for target in targets]
    return [[node.name]] if isinstance(node, ast.FunctionDef) else [names for names in named if names]
