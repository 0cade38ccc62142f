"""The expressions in a statement that was watched: their values, in words."""

import ast
import builtins
from contextlib import suppress
from functools import cached_property
from itertools import islice
from numbers import Real
from types import FrameType
from typing import Any, TypeGuard

from line_by_line.words import form_of, in_words, names_in, text_of, TEXTS

# The parts of an expression whose values are traced.
PARTS = ast.Call, ast.Subscript, ast.Attribute, ast.BinOp, ast.UnaryOp, ast.Compare, ast.BoolOp
# Nobody looks into these: they may run later, or many times.
AS_THEY_ARE = ast.Lambda, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp, ast.JoinedStr

Span = tuple[int, int, int, int]  # of code: its first line and column, and its last ones
MOST_KEYS = 8  # that are shown of a dictionary
SIGNS = {
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.In: "in",
    ast.NotIn: "not in",
    ast.Is: "is",
    ast.IsNot: "is not",
}


def is_part(node: ast.AST) -> TypeGuard[ast.expr]:
    """Return whether the value of a node is traced."""
    return isinstance(node, PARTS) and isinstance(getattr(node, "ctx", ast.Load()), ast.Load)


def span_of(node: Any) -> Span:
    """Return where a node begins and ends in its file."""
    return node.lineno, node.col_offset, node.end_lineno, node.end_col_offset


def targets_of(node: ast.AST) -> list[ast.expr]:
    """Return the targets that get a value in a statement, each one of a tuple alone."""
    left = [*node.targets] if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
    found = []
    while left:
        target = left.pop(0)
        if isinstance(target, (ast.Tuple, ast.List)):
            left = [*target.elts, *left]
        elif isinstance(target, ast.Starred):
            left.insert(0, target.value)
        elif target is not None:
            found.append(target)
    return found


def is_inner_statement(node: ast.AST) -> bool:
    """Return whether a node in a statement is a statement of its own."""
    return isinstance(node, (ast.stmt, ast.ExceptHandler))


def used_in_head(node: ast.AST) -> list[ast.Name]:
    """Return the names that a statement or an expression uses, without its inner statements."""
    found = [node] if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) else []
    for child in ast.iter_child_nodes(node):
        if not is_inner_statement(child):
            found += used_in_head(child)
    return found


def names_in_head(node: ast.AST) -> set[str]:
    """Return the names that a statement or an expression uses, as text."""
    return {name.id for name in used_in_head(node)}


def operations_in(node: ast.AST) -> list[ast.expr]:
    """Return the parts in a statement, without those of inner statements, in their order."""
    found = []
    for child in ast.iter_child_nodes(node):
        if not is_inner_statement(child) and not isinstance(child, AS_THEY_ARE):
            found += operations_in(child)
    if is_part(node):
        found.append(node)
    return found


class Values:
    """The values in a statement: of its parts that were traced, and of the names in its frame."""

    def __init__(self, frame: FrameType, parts: dict):
        """parts has the traced values, by their spans."""
        self.frame = frame
        self.parts = parts
        # Whether a method that is called in a condition may have changed something
        self.can_change = False

    @cached_property
    def names(self) -> dict[int, str]:
        """The names of the dictionaries and the lists in the frame; see names_in."""
        return names_in(self.frame)

    def of(self, node: ast.expr) -> Any:
        """Return the value of a node; raise a LookupError if it is not known."""
        if span_of(node) in self.parts:
            return self.parts[span_of(node)]
        if isinstance(node, ast.Constant):
            return node.value
        if isinstance(node, ast.Name):
            return self.of_name(node.id)
        if isinstance(node, ast.Tuple):
            return tuple(self.of(element) for element in node.elts)
        if isinstance(node, (ast.Subscript, ast.Attribute)):
            return self.taken(self.of(node.value), node)
        raise LookupError

    def taken(self, whole: Any, node: ast.Subscript | ast.Attribute) -> Any:
        """Return an element or an attribute of a whole.

        An object of a class that the student wrote is not asked: it could change.
        """
        if isinstance(node, ast.Subscript) and type(whole) in (dict, list, tuple):
            return whole[self.of(node.slice)]
        if isinstance(node, ast.Attribute) and isinstance(whole, tuple(TEXTS)):
            return getattr(whole, node.attr)
        raise LookupError

    def of_name(self, name: str) -> Any:
        """Return the value of a name.

        A name of the function has no value before a line gives it one.
        """
        code = self.frame.f_code
        if name in self.frame.f_locals or name in code.co_varnames or name in code.co_cellvars:
            return self.frame.f_locals[name]
        return {**vars(builtins), **self.frame.f_globals}[name]

    def has(self, name: str) -> bool:
        """Return whether a name has a value."""
        with suppress(LookupError):
            self.of_name(name)
            return True
        return False

    def not_called(self, names: list[ast.Name]) -> list[ast.Name]:
        """Return the names that are no functions, of those that have a value."""
        return [node for node in names if self.has(node.id) and not callable(self.of_name(node.id))]

    def operands_at_stop(self, statement: ast.AST) -> list[ast.expr]:
        """Return the operands of the operation that did not come to its end."""
        for node in operations_in(statement):
            try:
                self.of(node)
            except Exception:
                parts = [part for part in ast.iter_child_nodes(node) if isinstance(part, ast.expr)]
                return [part for part in parts if self.is_operand(part, node)]
        return []

    def is_operand(self, part: ast.expr, node: ast.expr) -> bool:
        """Return whether the value of a part says something: not a constant, or what is called."""
        if isinstance(part, ast.Constant):
            return False
        if isinstance(node, ast.Call) and part is node.func:
            with suppress(Exception):
                return not callable(self.of(part))
        return True

    def operand(self, node: ast.expr) -> str:
        """Return the value of an operand in words; of a dictionary, its keys; "" if it has none."""
        code = ast.unparse(node)
        try:
            value = self.of(node)
        except Exception:
            return ""
        if isinstance(value, dict):
            keys = [text_of(key) for key in islice(value, MOST_KEYS)]
            if len(value) > MOST_KEYS:
                keys.append("...")
            return f"the keys of {code} are {', '.join(keys) or 'none'}"
        text = in_words(value, self.names_but(node))
        form = form_of(value)
        if callable(value) or isinstance(value, Real) or form in text:
            return f"{code} is {text}"
        return f"{code} is {text}, {form}"

    def names_but(self, node: ast.AST) -> dict[int, str]:
        """Return the names of dictionaries and lists, without the one that is this node."""
        code = ast.unparse(node)
        return {key: name for key, name in self.names.items() if name != code}

    def condition(self, node: ast.expr, value: Any) -> str:
        """Return a condition that has this value: both sides of each comparison, and its truth."""
        calls = [part for part in operations_in(node) if isinstance(part, ast.Call)]
        self.can_change = any(isinstance(call.func, ast.Attribute) for call in calls)
        text = ""
        with suppress(Exception):  # its values are not known
            text = self.with_values(node)
        if text in ("True", "False", ""):
            return f"{bool(value)}"
        if isinstance(node, (ast.Compare, ast.BoolOp)):
            return f"{text} {bool(value)}"
        return f"{text}, so {bool(value)}"

    def with_values(self, node: ast.expr) -> str:
        """Return a condition, or a part of it, with values in place of the code."""
        if isinstance(node, ast.Compare):
            text = self.with_values(node.left)
            for sign, side in zip(node.ops, node.comparators, strict=True):
                text += f" {SIGNS[type(sign)]} {self.with_values(side)}"
            return text
        if isinstance(node, ast.BoolOp):
            is_and = isinstance(node.op, ast.And)
            parts = []
            for part in node.values:
                parts.append(self.with_values(part))
                if bool(self.of(part)) != is_and:
                    break  # Python has not looked at the others
            return (" and " if is_and else " or ").join(parts)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            return f"not {self.with_values(node.operand)}"
        value = self.of(node)
        if isinstance(value, (list, dict)) and self.can_change:
            raise LookupError  # it may have been another one when Python looked at it
        return in_words(value, self.names_but(node))
