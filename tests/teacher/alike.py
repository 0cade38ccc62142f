"""Solutions without their names and comments: which are the same, and those that a teacher should see."""

import ast
import hashlib
from pathlib import PurePosixPath

from grading.handout import FUNCTIONS

FILES = list(dict.fromkeys(PurePosixPath(function.file).name for function in FUNCTIONS.values()))

ODD = (ValueError, RecursionError, MemoryError)  # code that nobody writes by hand: very deep, or with huge numbers


def tree_of(source) -> ast.Module | None:
    """Return the syntax tree of a file without docstrings and annotations, or None if it is no Python."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, *ODD):
        return None
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            node.body = [part for part in body if not is_text(part)] or [ast.Pass()]
        if isinstance(node, ast.FunctionDef):
            node.returns = None
        if isinstance(node, ast.arg):
            node.annotation = None
    return tree


def is_text(node) -> bool:
    """Return whether a statement is only a text, like a docstring."""
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def fingerprint(files) -> str:
    """Return a text that is the same for solutions that differ only in names, comments and line breaks.

    files are the contents by their paths below src/. The fingerprint is empty if nothing can be read.
    """
    trees = [tree for tree in map(tree_of, (files[file] for file in FILES if file in files)) if tree]
    written = [node for tree in trees for node in tree.body if not isinstance(node, (ast.Import, ast.ImportFrom))]
    text = unnamed(ast.Module(body=written, type_ignores=[])) if written else ""
    return hashlib.sha256(text.encode("utf-8", "backslashreplace")).hexdigest() if text else ""


def unnamed(tree) -> str:
    """Return a tree as text; the names that it gives itself are numbers there, in the order in which they appear."""
    own = {name for part in ast.walk(tree) for name in names_given(part)}
    numbers: dict[str, str] = {}
    for part in ast.walk(tree):
        for field in ("id", "arg", "name"):
            name = getattr(part, field, None)
            if name in own:
                setattr(part, field, numbers.setdefault(name, str(len(numbers))))
    try:
        return ast.dump(tree)
    except ODD:
        return ""


def names_given(node) -> list[str]:
    """Return the names that a node gives to variables, parameters and functions, but for the handout's functions."""
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
        return [node.id]
    if isinstance(node, ast.arg):
        return [node.arg]
    return [node.name] if isinstance(node, ast.FunctionDef) and node.name not in FUNCTIONS else []


def groups_of(fingerprints, starters) -> list[list[str]]:
    """Return the groups of students with the same fingerprint, which is neither empty nor the starter's."""
    groups: dict[str, list[str]] = {}
    for student, of in fingerprints.items():
        groups.setdefault(of, []).append(student)
    return [group for of, group in groups.items() if len(group) > 1 and of not in ("", starters)]


def body_of(function, files, starters) -> str | None:
    """Return the body of a student's function, for a row of wrong_solutions.py, or None if it cannot be found.

    It has no comments and no docstring. What else the function uses, and the starter's files do not have, comes first.
    """
    name_of_file = PurePosixPath(FUNCTIONS[function].file).name
    tree, given = tree_of(files.get(name_of_file, b"")), tree_of(starters.get(name_of_file, b""))
    if tree is None or given is None:
        return None
    try:
        provided = set(map(ast.dump, given.body))
        defined = {name: node for node in tree.body for name in names_defined(node) if ast.dump(node) not in provided}
        if not isinstance(defined.get(function), ast.FunctionDef):
            return None
        used, to_see = [function], [function]
        while to_see:
            names = {part.id for part in ast.walk(defined[to_see.pop()]) if isinstance(part, ast.Name)}
            new = sorted(names.intersection(defined) - set(used) - set(FUNCTIONS))
            used += new
            to_see += new
        others = [node for node in tree.body if any(defined[name] is node for name in used[1:])]
        return ast.unparse(ast.Module(body=others + defined[function].body, type_ignores=[]))
    except ODD:
        return None


def names_defined(node) -> list[str]:
    """Return the names that a statement of a file defines, other than by an import."""
    if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
        return [node.name]
    targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
    return [target.id for target in targets if isinstance(target, ast.Name)]
