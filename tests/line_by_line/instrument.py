"""Other code for functions, which does the same, and hands its values to a Watch.

watch.py has the Watch. All lines keep their numbers. Of a function with these lines,

    while i < 3:
        a = b[i]

the body becomes this (with the lines and columns of i < 3 or of b[i] in place of SPAN):

    __watch__.enter(0)
    __watch__.begin_statement(1)
    while __watch__.test(1, __watch__.part(1, SPAN, i < 3)):
        __watch__.turn(1)
        __watch__.begin_statement(2)
        a = __watch__.value(2, __watch__.part(2, SPAN, b[i]))
        __watch__.done(2)
"""

import ast
import linecache
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from copy import deepcopy
from types import CodeType, FunctionType
from typing import Any

from line_by_line.expressions import AS_THEY_ARE, is_part, span_of
from line_by_line.traces import LOOPS, Statement
from line_by_line.watch import Watch

WATCH = "__watch__"  # the name under which the changed code finds the Watch
TRIES = ast.Try, ast.TryStar
STORING = ast.Assign, ast.AugAssign, ast.AnnAssign, ast.Expr
DEFINITIONS = ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef


def hand(method: str, *arguments: Any) -> ast.Call:
    """Return the code that hands these to a method of the Watch: nodes, or plain values."""
    nodes: list[Any] = []
    for argument in arguments:
        nodes.append(argument if isinstance(argument, ast.AST) else ast.Constant(argument))
    return ast.Call(ast.Attribute(ast.Name(WATCH, ast.Load()), method, ast.Load()), nodes, [])


def line_with(node: Any, method: str, number: int) -> ast.Expr:
    """Return a statement that calls a method of the Watch, at the first line of a node."""
    return ast.Expr(
        hand(method, number),
        lineno=node.lineno,
        col_offset=node.col_offset,
        end_lineno=node.lineno,
        end_col_offset=node.col_offset,
    )


class Parts(ast.NodeTransformer):
    """Hands the values of the parts of an expression to the Watch."""

    def __init__(self, number: int, receiver: ast.expr | None = None):
        """number is that of the statement. A method of receiver (a node) is called in it."""
        self.number = number
        self.receiver = receiver

    def visit(self, node: ast.AST) -> Any:
        if isinstance(node, AS_THEY_ARE):
            return node
        new: Any = self.generic_visit(node)
        if isinstance(node, ast.Call):
            new.func = hand("function", self.number, new.func)
        if is_part(node):
            new = hand("part", self.number, span_of(node), new)
        return hand("receiver", self.number, new) if node is self.receiver else new


class Changer:
    """Changes the code of functions, and collects their statements in a Watch."""

    def __init__(self, watch: Watch):
        self.statements = watch.statements

    def function(self, node: ast.FunctionDef) -> None:
        """Change a function (its def)."""
        number = self.add(node, len(self.statements), ())
        node.body = [line_with(node, "enter", number), *self.block(node.body, number, ())]

    def add(self, node: ast.AST, owner: int, loops: tuple[int, ...], is_shown: bool = True) -> int:
        """Add a statement; return its number."""
        self.statements.append(Statement(deepcopy(node), owner, loops, is_shown))
        return len(self.statements) - 1

    def block(self, nodes: list[ast.stmt], owner: int, loops: tuple[int, ...]) -> list[ast.stmt]:
        """Return the changed statements of a block.

        owner is the number of the function, loops are those around the block.
        """
        changed = []
        for node in nodes:
            if isinstance(node, DEFINITIONS) or is_idle(node):
                self.add(node, owner, loops, is_shown=False)
                if isinstance(node, ast.FunctionDef):
                    self.function(node)
                changed.append(node)
            else:
                changed += self.statement(node, owner, loops)
        return changed

    def statement(self, node: Any, owner: int, loops: tuple[int, ...]) -> list[ast.stmt]:
        """Return the statements that take the place of this one."""
        number = self.add(node, owner, loops)
        if isinstance(node, LOOPS):
            loops = (*loops, number)
        self.expressions(node, number)
        self.blocks(node, owner, loops)
        start = line_with(node, "begin_statement", number)
        if isinstance(node, LOOPS):
            node.body.insert(0, line_with(node, "turn", number))
        if isinstance(node, (ast.If, ast.While, ast.Assert)):
            node.test = hand("test", number, node.test)
        elif isinstance(node, ast.For):
            node.iter = hand("value", number, node.iter)
        elif isinstance(node, ast.Return) and node.value:
            node.value = hand("gives", number, hand("value", number, node.value))
        elif isinstance(node, STORING) and node.value:
            node.value = hand("value", number, node.value)
            return [start, node, line_with(node, "done", number)]
        elif isinstance(node, TRIES):
            return [node]
        else:
            return [line_with(node, "ran", number), node]
        return [start, node]

    def expressions(self, node: Any, number: int) -> None:
        """Let the expressions of a statement hand their parts to the Watch."""
        parts = Parts(number, receiver_in(node))
        for name, child in ast.iter_fields(node):
            if isinstance(child, ast.expr) and name != "annotation":
                setattr(node, name, parts.visit(child))
        if isinstance(node, ast.Assign):
            node.targets = [parts.visit(target) for target in node.targets]
        if isinstance(node, ast.With):
            for item in node.items:
                item.context_expr = parts.visit(item.context_expr)

    def blocks(self, node: Any, owner: int, loops: tuple[int, ...]) -> None:
        """Change the blocks of a statement."""
        for name in ("body", "orelse", "finalbody"):
            nodes = getattr(node, name, None)
            if nodes:
                # The else of a loop stands outside of its turns
                is_outside = name == "orelse" and isinstance(node, LOOPS)
                setattr(node, name, self.block(nodes, owner, loops[:-1] if is_outside else loops))
        for handler in getattr(node, "handlers", []):
            number = self.add(handler, owner, loops)
            start = line_with(handler, "caught", number)
            handler.body = [start, *self.block(handler.body, owner, loops)]
        for case in getattr(node, "cases", []):
            case.body = self.block(case.body, owner, loops)


def receiver_in(node: ast.AST) -> ast.expr | None:
    """Return the node whose method gives the value of a statement."""
    value = getattr(node, "value", None)
    if isinstance(node, (ast.Assign, ast.Expr)) and isinstance(value, ast.Call):
        return value.func.value if isinstance(value.func, ast.Attribute) else None
    return None


def is_idle(node: ast.AST) -> bool:
    """Return whether a statement changes nothing: a docstring, or a print."""
    if not isinstance(node, ast.Expr):
        return False
    if isinstance(node.value, ast.Constant):
        return True
    return getattr(getattr(node.value, "func", None), "id", "") == "print"


@contextmanager
def watched(functions: Iterable[FunctionType], watch: Watch) -> Iterator[None]:
    """Let a Watch trace what these functions do, in the with statement."""
    plain_codes = {function: function.__code__ for function in functions}
    try:
        for file in dict.fromkeys(code.co_filename for code in plain_codes.values()):
            codes = changed_codes(file, watch)
            for function, plain_code in plain_codes.items():
                code = codes.get((plain_code.co_name, plain_code.co_firstlineno))
                is_there = code and plain_code.co_filename == file
                if code and is_there and code.co_freevars == plain_code.co_freevars:
                    function.__code__ = code
                    function.__globals__[WATCH] = watch
        yield
    finally:
        put_back(plain_codes)


def put_back(plain_codes: dict[FunctionType, CodeType]) -> None:
    """Give functions their codes back, all of them also if an interrupt comes meanwhile."""
    left = [*plain_codes]
    interrupt = None
    while left:
        try:
            left[-1].__code__ = plain_codes[left[-1]]
            left[-1].__globals__.pop(WATCH, None)
            left.pop()
        except KeyboardInterrupt as error:
            interrupt = error
    if interrupt:
        raise interrupt


def changed_codes(file: str, watch: Watch) -> dict[tuple[str, int], CodeType]:
    """Return the changed code of all functions in a file, by their names and first lines."""
    tree = ast.parse("".join(linecache.getlines(file)))
    changer = Changer(watch)
    blocks = [tree.body, *(node.body for node in tree.body if isinstance(node, ast.ClassDef))]
    for block in blocks:
        for node in block:
            if isinstance(node, ast.FunctionDef):
                changer.function(node)
    found = {}
    left = [compile(ast.fix_missing_locations(tree), file, "exec", dont_inherit=True)]
    while left:
        code = left.pop()
        found[code.co_name, code.co_firstlineno] = code
        left += [inner for inner in code.co_consts if isinstance(inner, CodeType)]
    return found
