"""Other code for a student's functions, which does the same, and hands its values to a Watch
(watch.py).

All lines keep their numbers. Of these lines in a function,

    while i < 3:
        a = b[i]

this becomes (with the place of b[i] in the file in place of PLACE):

    __watch__.begin_statement(1)
    while __watch__.test(1, i < 3):
        __watch__.turn(1)
        __watch__.begin_statement(2)
        a = __watch__.value(2, __watch__.part(2, PLACE, b[i]))
        __watch__.done(2)
"""

import ast
import linecache
import sys
from contextlib import contextmanager
from copy import deepcopy
from types import CodeType, FunctionType

from grading.expressions import AS_THEY_ARE, is_part, place_of
from grading.handout import FUNCTIONS, is_students, module_of
from grading.watch import LOOPS, Statement

WATCH = "__watch__"  # the name under which the changed code finds the Watch
TRIES = ast.Try, getattr(ast, "TryStar", ast.Try)  # except* is there from Python 3.11 on
STORING = ast.Assign, ast.AugAssign, ast.AnnAssign, ast.Expr


def hand(method, *arguments) -> ast.Call:
    """Return the code that hands these to a method of the Watch: nodes, or plain values."""
    nodes = [one if isinstance(one, ast.AST) else ast.Constant(one) for one in arguments]
    return ast.Call(ast.Attribute(ast.Name(WATCH, ast.Load()), method, ast.Load()), nodes, [])


def line_with(node, method, number) -> ast.Expr:
    """Return a statement that calls a method of the Watch, at the first line of a node."""
    end = {"end_lineno": node.lineno, "end_col_offset": node.col_offset}
    return ast.Expr(hand(method, number), lineno=node.lineno, col_offset=node.col_offset, **end)


class Parts(ast.NodeTransformer):
    """Hands the values of the parts of an expression to the Watch."""

    def __init__(self, number, receiver=None):
        """number is that of the statement; a method of receiver (a node, or None) is called in it."""
        self.number, self.receiver = number, receiver

    def visit(self, node):
        if isinstance(node, AS_THEY_ARE):
            return node
        new = self.generic_visit(node)
        if isinstance(node, ast.Call):
            new.func = hand("function", self.number, new.func)
        if is_part(node):
            new = hand("part", self.number, place_of(node), new)
        return hand("receiver", self.number, new) if node is self.receiver else new


class Changer:
    """Changes the code of functions, and collects their statements in a Watch."""

    def __init__(self, watch):
        self.statements = watch.statements

    def function(self, node) -> None:
        """Change a function (its def)."""
        number = self.add(node, len(self.statements), ())
        node.body = [line_with(node, "enter", number), *self.block(node.body, number, ())]

    def add(self, node, owner, loops, is_shown=True) -> int:
        """Note a statement; return its number."""
        self.statements.append(Statement(deepcopy(node), owner, loops, is_shown))
        return len(self.statements) - 1

    def block(self, nodes, owner, loops) -> list[ast.stmt]:
        """Return the changed statements of a block. owner is the number of the function, loops are
        those around it.
        """
        changed = []
        for node in nodes:
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)) or is_idle(
                node
            ):
                self.add(node, owner, loops, is_shown=False)
                if isinstance(node, ast.FunctionDef):
                    self.function(node)
                changed.append(node)
            else:
                changed += self.statement(node, owner, loops)
        return changed

    def statement(self, node, owner, loops) -> list[ast.stmt]:
        """Return the statements that take the place of this one."""
        number = self.add(node, owner, loops)
        if isinstance(node, LOOPS):
            loops = (*loops, number)
        self.expressions(node, number)
        self.blocks(node, owner, loops)
        begin = line_with(node, "begin_statement", number)
        if isinstance(node, LOOPS):
            node.body.insert(0, line_with(node, "turn", number))
        if isinstance(node, (ast.If, ast.While, ast.Assert)):
            node.test = hand("test", number, node.test)
        elif isinstance(node, ast.For):
            node.iter = hand("value", number, node.iter)
        elif isinstance(node, ast.Return) and node.value:
            node.value = hand("gives", number, node.value)
        elif isinstance(node, STORING) and node.value:
            node.value = hand("value", number, node.value)
            return [begin, node, line_with(node, "done", number)]
        elif not isinstance(node, TRIES):
            return [line_with(node, "ran", number), node]
        return [begin, node]

    def expressions(self, node, number) -> None:
        """Let the expressions of a statement hand their parts to the Watch."""
        receiver = None
        if isinstance(node, ast.Expr) and isinstance(
            getattr(node.value, "func", None), ast.Attribute
        ):
            receiver = node.value.func.value
        parts = Parts(number, receiver)
        for name, child in ast.iter_fields(node):
            if isinstance(child, ast.expr) and name != "annotation":
                setattr(node, name, parts.visit(child))
        if isinstance(node, ast.Assign):
            node.targets = [parts.visit(one) for one in node.targets]
        if isinstance(node, ast.With):
            for item in node.items:
                item.context_expr = parts.visit(item.context_expr)

    def blocks(self, node, owner, loops) -> None:
        """Change the blocks of a statement."""
        for name in ("body", "orelse", "finalbody"):
            # The else of a loop stands outside of its turns.
            around = loops[:-1] if name == "orelse" and isinstance(node, LOOPS) else loops
            if getattr(node, name, None):
                setattr(node, name, self.block(getattr(node, name), owner, around))
        for handler in getattr(node, "handlers", []):
            number = self.add(handler, owner, loops)
            handler.body = [
                line_with(handler, "caught", number),
                *self.block(handler.body, owner, loops),
            ]
        for case in getattr(node, "cases", []):
            case.body = self.block(case.body, owner, loops)


def is_idle(node) -> bool:
    """Return whether a statement changes nothing: a docstring, or a print."""
    value = node.value if isinstance(node, ast.Expr) else None
    return (
        isinstance(value, ast.Constant)
        or getattr(getattr(value, "func", None), "id", "") == "print"
    )


@contextmanager
def watched(function, watch):
    """In the body of the with statement, the student's functions for this one have other code,
    which is watched.
    """
    kept = {each: each.__code__ for each in own_functions(function)}
    codes = changed_codes([*kept.values()], watch) if kept else {}
    for each in kept:
        code = codes.get((each.__code__.co_name, each.__code__.co_firstlineno))
        if code and code.co_freevars == each.__code__.co_freevars:
            each.__code__ = code
            each.__globals__[WATCH] = watch
    try:
        yield
    finally:
        for each, code in kept.items():
            each.__code__ = code
            each.__globals__.pop(WATCH, None)


def own_functions(function):
    """Yield this function of the handout, and the student's own functions and methods in its file."""
    module = sys.modules[module_of(FUNCTIONS[function].file)]
    code = getattr(getattr(module, function, None), "__code__", None)
    file = code.co_filename if code else ""
    values = [*vars(module).values()]
    for one in [*values]:
        if isinstance(one, type) and one.__module__ == module.__name__:
            values += vars(one).values()
    for one in values:
        code = one.__code__ if isinstance(one, FunctionType) else None
        if code and code.co_filename == file and is_students(code.co_name, function):
            yield one


def changed_codes(own, watch) -> dict[tuple, CodeType]:
    """Return the changed code of functions in one file, by their names and first lines; own is
    their code.
    """
    file = own[0].co_filename
    names = {code.co_name for code in own}
    tree = ast.parse("".join(linecache.getlines(file)))
    blocks = [tree.body, *(node.body for node in tree.body if isinstance(node, ast.ClassDef))]
    changer = Changer(watch)
    for node in [node for block in blocks for node in block]:
        if isinstance(node, ast.FunctionDef) and node.name in names:
            changer.function(node)
    found, codes = {}, [compile(ast.fix_missing_locations(tree), file, "exec", dont_inherit=True)]
    while codes:
        code = codes.pop()
        found[code.co_name, code.co_firstlineno] = code
        codes += [one for one in code.co_consts if isinstance(one, CodeType)]
    return found
