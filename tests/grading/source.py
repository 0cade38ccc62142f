"""The lines of a student's file, as a trace table shows them."""

import io
import linecache
import tokenize
from collections.abc import Iterator
from contextlib import suppress
from typing import Any


class Source:
    """The lines of a file, by their numbers."""

    def __init__(self, file: str):
        self.file = file

    def line(self, number: int) -> str:
        return linecache.getline(self.file, number).rstrip().expandtabs(4)

    def indentation(self, number: int) -> int:
        line = self.line(number)
        return len(line) - len(line.lstrip())

    def head_of(self, node: Any) -> str:
        """Return the code of a statement in one line, without comments; of a block, its head."""
        texts = [without_comment(self.line(node.lineno))]
        body = getattr(node, "body", None) or getattr(node, "cases", None)
        last = node.end_lineno
        if isinstance(body, list):
            last = getattr(body[0], "lineno", node.lineno + 1) - 1
        for number in range(node.lineno + 1, last + 1):
            if body and texts[-1].endswith(":"):
                break  # comments and prints follow
            texts.append(without_comment(self.line(number)).strip())
        return " ".join(text for text in texts if text.strip())

    def lines_with_else(self, node: Any) -> Iterator[int]:
        """Yield the lines with the else and the finally of a statement.

        No statement begins there.
        """
        for name in ("orelse", "finalbody"):
            block = getattr(node, name, None)
            if block:
                for number in reversed(range(node.lineno, block[0].lineno)):
                    if self.line(number).lstrip().startswith(("else", "finally")):
                        yield number
                        break


def without_comment(line: str) -> str:
    """Return a line of code without its comment."""
    code = line.lstrip()
    indentation = len(line) - len(code)
    with suppress(tokenize.TokenError, SyntaxError):
        for token in tokenize.generate_tokens(io.StringIO(code).readline):
            if token.type == tokenize.COMMENT:
                return line[: indentation + token.start[1]].rstrip()
    return line
