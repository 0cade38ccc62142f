"""Sentences about what an operation has done that few beginners expect."""

import ast
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

from line_by_line.expressions import operations_in, targets_of, Values


def remarks_on(statement: Any, values: Values) -> Iterator[str]:
    """Yield what is said of a statement at its end."""
    for node in operations_in(statement):
        text = ""
        with suppress(Exception):  # its values are not known, or say nothing of themselves
            if isinstance(node, ast.BinOp):
                text = of_operation(node, values)
            elif isinstance(node, ast.Call):
                text = of_call(node, statement, values)
        if text:
            yield f"Line {node.lineno} {text}"


def of_operation(node: ast.BinOp, values: Values) -> str:
    """Return what is said of an operation, or ""."""
    value = values.of(node)
    if isinstance(node.op, ast.FloorDiv):
        exact = values.of(node.left) / values.of(node.right)
        if exact != value:
            return f"cuts off the digits after the point: // gives {value:g}, / gives {exact:g}."
    if isinstance(node.op, ast.Mult) and isinstance(value, list) and len(value) > 1:
        first = value[0]
        if isinstance(first, (dict, list)) and all(element is first for element in value):
            one = "one dictionary" if isinstance(first, dict) else "one list"
            return f"puts {one} in the list {len(value)} times."
    return ""


def of_call(node: ast.Call, statement: Any, values: Values) -> str:
    """Return what is said of a call, or ""."""
    function = node.func
    value = values.of(node)
    if value is None and getattr(statement, "value", None) is node and targets_of(statement):
        return f"stores None: {ast.unparse(function)} gives nothing back."
    if isinstance(function, ast.Attribute) and function.attr == "index":
        whole = values.of(function.value)
        wanted = values.of(node.args[0])
        if isinstance(whole, list) and whole[value] is not wanted:
            own = [element is wanted for element in whole].index(True)
            return f"gets {value}: index finds the first equal element. This one has {own}."
    return ""
