"""The code of statements, as a trace table shows it."""

import io
import linecache
import tokenize
from contextlib import suppress
from typing import Any


def head_of(node: Any, file: str) -> str:
    """Return the code of a statement in one line, without comments; of a block, its head."""
    last = node.end_lineno, node.end_col_offset
    block = getattr(node, "body", None) or getattr(node, "cases", None)
    if isinstance(block, list):
        first: Any = getattr(block[0], "pattern", block[0])
        last = first.lineno, first.col_offset
    texts = []
    for number in range(node.lineno, last[0] + 1):
        code = linecache.getline(file, number).encode()
        if number == last[0]:
            code = code[: last[1]]
        if number == node.lineno:
            code = code[node.col_offset :]
        texts.append(without_comment(code.decode().strip()))
    return " ".join(filter(None, texts))


def indentation_of(node: Any, file: str) -> int:
    """Return the columns in front of the line in which a statement begins."""
    line = linecache.getline(file, node.lineno).expandtabs(4)
    return len(line) - len(line.lstrip())


def without_comment(code: str) -> str:
    """Return a line of code without its comment."""
    with suppress(tokenize.TokenError, SyntaxError):
        for token in tokenize.generate_tokens(io.StringIO(code).readline):
            if token.type == tokenize.COMMENT:
                return code[: token.start[1]].rstrip()
    return code
