"""What each statement of a call did, by Python's own tracing (sys.settrace).

Before and after each line, a snapshot is taken of what the names of the function reach. The
difference is what the line has set.
"""

import ast
import linecache
import sys
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from copy import deepcopy
from numbers import Real
from types import CodeType, FrameType
from typing import Any, NamedTuple

from line_by_line.words import Words

MOST_EVENTS = 10_000  # lines that are watched
MOST_ELEMENTS = 50  # of a list that are looked at
DEPTH = 3  # of what a name reaches: a list, a dictionary in it, its value
DEFINITIONS = ast.FunctionDef, ast.ClassDef
ASSIGNMENTS = ast.Assign, ast.AugAssign, ast.AnnAssign
BLOCKS = ast.stmt, ast.excepthandler, ast.match_case  # parts of a statement that hold others
# Statements that are no rows: they give nothing.
SILENT = *DEFINITIONS, ast.Import, ast.ImportFrom, ast.Global, ast.Nonlocal, ast.Pass, ast.Try
CONDITIONAL = ast.If, ast.While
PLAIN = Real, str, tuple, type(None)  # values that cannot change
CONDITIONS = ast.Compare, ast.BoolOp, ast.Not, ast.cmpop, ast.boolop

# The id of a call, a dictionary, a list or an object, and a name or a key in it
Key = tuple[int, Any]


class Cell(NamedTuple):
    """A place that has a value, such as pend["omega"]."""

    place: str
    value: Any
    size: int  # of a list


class Visit:
    """What a statement did in one turn."""

    def __init__(self) -> None:
        self.texts: list[str] = []  # what it gave
        self.keys: list[Key] = []  # of the cells that it has set
        self.values: list[Any] = []  # that it gave
        self.calls: list[Call] = []  # of functions that are named, and not watched
        self.error: BaseException | None = None  # that it raised


class Call:
    """A call of a function: its arguments as they arrived, and what its statements did."""

    def __init__(self, frame: FrameType, statements: dict[int, ast.stmt]):
        self.frame = frame
        self.code = frame.f_code
        self.name = self.code.co_qualname.rpartition("<locals>.")[2]
        self.statements = statements  # by their lines; none if it is not watched
        self.head = ""  # the call in words
        self.gave = ""  # its result in words
        self.is_open = True
        self.visits: defaultdict[int, list[Visit]] = defaultdict(list)  # by the first line
        self.visit = Visit()  # the present one
        self.line = 0  # the first one of the present statement
        self.condition = ""  # the present one, with values
        self.cells: dict[Key, Cell] = {}
        self.holders: set[int] = set()  # the ids of those whose parts are among the cells

    def name_of(self, value: Any, but: str) -> str:
        """Return another place of a dictionary or a list, or another name of an object, or ""."""
        is_long = isinstance(value, (dict, list))
        if isinstance(value, PLAIN) or not (is_long or but.isidentifier()):
            return ""
        for place, other, _ in reversed(self.cells.values()):
            if other is value and place != but and (is_long or place.isidentifier()):
                return place
        return ""

    def all_visits(self) -> list[Visit]:
        """Return what all statements did."""
        return [visit for visits in self.visits.values() for visit in visits]


class Trace:
    """What functions do while it is on."""

    def __init__(
        self,
        words: Words,
        is_watched: Callable[[CodeType], bool],
        is_named: Callable[[CodeType], bool] = lambda code: False,
    ):
        """The lines of a function are watched if is_watched(code) is true.

        If is_named(code) is true, only its arguments and its result are kept.
        """
        self.words = words
        self.is_watched = is_watched
        self.is_named = is_named
        self.known: dict[CodeType, dict[int, ast.stmt]] = {}
        self.all_calls: dict[Any, Call] = {}  # by their frames
        # Pairs of a function that is named, and not watched, and what it has given
        self.given: list[tuple[str, Any]] = []
        self.events = 0
        self.fault: Exception | None = None  # in this module
        self.error: BaseException | None = None  # that has stopped the first call

    @contextmanager
    def on(self) -> Iterator[None]:
        """Watch what is called in the body of the with statement, and forget what was before.

        A trace function that was there before has its place back at the end.
        """
        self.all_calls.clear()
        self.given.clear()
        self.events = 0
        self.error = None
        before = sys.gettrace()
        sys.settrace(self)
        try:
            yield
        except BaseException as error:
            self.error = error
            for call in self.calls:
                # Its own event may be lost, with too many calls
                if call.is_open and not self.is_full:
                    call.visit.error = error
            raise
        finally:
            sys.settrace(before)

    @property
    def calls(self) -> list[Call]:
        """The calls that were watched, in their order."""
        return [call for call in self.all_calls.values() if call.statements]

    @property
    def is_full(self) -> bool:
        """Whether nothing more is watched."""
        return self.events > MOST_EVENTS or self.fault is not None

    def has_set(self, key: Key) -> bool:
        """Return whether a statement has set a cell."""
        return any(key in visit.keys for call in self.calls for visit in call.all_visits())

    # --- what Python calls ---

    def __call__(self, frame: FrameType, event: str, argument: Any) -> "Trace | None":
        """Something happens in a function: return this object if it is looked at further."""
        self.events += event != "call"  # of functions that are not watched, there is no other one
        if self.is_full:
            frame.f_trace_lines = False
            return None
        try:
            if event != "call":
                self.goes_on(self.all_calls[frame], event, argument)
            elif not self.is_begun(frame):
                return None
        except RecursionError:  # the function calls itself too often, and gets this error, too
            return self if frame in self.all_calls else None
        except Exception as fault:  # it is never one of the function
            self.fault = fault
        return self

    def is_begun(self, frame: FrameType) -> bool:
        """A call begins: return whether it is looked at."""
        if frame in self.all_calls:  # a generator goes on
            return True
        caller = self.all_calls.get(frame.f_back)
        code = frame.f_code
        if code.co_name.startswith("<") and code.co_name != "<module>":  # it is in a statement
            return False
        statements = self.statements_of(code) if self.is_watched(code) else {}
        if not statements and not (caller and self.is_named(code)):
            return False
        call = self.all_calls[frame] = Call(frame, statements)
        call.head = f"{call.name}({', '.join(self.arguments_of(call, caller))})"
        if statements:
            self.look_at(call)
        elif caller:
            frame.f_trace_lines = False
            caller.visit.calls.append(call)
        return True

    def arguments_of(self, call: Call, caller: Call | None) -> Iterator[str]:
        """Yield the arguments as they arrived, by name."""
        count = call.code.co_argcount + call.code.co_kwonlyargcount
        for name in call.code.co_varnames[:count]:
            if name in call.frame.f_locals and name not in ("self", "cls"):
                value = call.frame.f_locals[name]
                is_long = isinstance(value, (dict, list))
                place = caller.name_of(value, name) if caller and is_long else ""
                yield f"{name}={place or self.words.in_words(value)}"

    def goes_on(self, call: Call, event: str, argument: Any) -> None:
        """Keep what the last statement did; see what happens now."""
        previous = call.statements.get(call.line)
        statement = call.statements.get(call.frame.f_lineno)
        # It stays in a statement of several lines, or with a comprehension
        is_same = statement and statement is previous and not hasattr(statement, "body")
        if event == "line" and is_same:
            return
        if event == "exception":
            call.visit.error = argument[1]
        elif isinstance(previous, CONDITIONAL) and not call.visit.error:
            call.visit.texts.append(truth_of(previous, call))
        if call.statements:
            self.finish(call)
        if event == "line":
            self.begin(call, statement)
        elif event == "return" and not call.visit.error:
            call.is_open = False
            call.visit.values += [argument, *(argument if isinstance(argument, tuple) else ())]
            if not call.statements:
                self.given.append((call.name, argument))
            if isinstance(statement, ast.Return) or argument is not None:  # a generator's, too
                call.gave = self.words.in_words(argument, call.name_of(argument, ""))
                call.visit.texts.append(f"gives {call.gave}")

    def begin(self, call: Call, statement: ast.stmt | None) -> None:
        """A statement begins."""
        call.line = statement.lineno if statement else 0
        call.visit = Visit()
        if statement:
            call.visits[call.line].append(call.visit)
        if isinstance(statement, CONDITIONAL):
            call.condition = ast.unparse(Sides(self, call).visit(deepcopy(statement.test)))

    def finish(self, call: Call) -> None:
        """Keep what the statement that ran has set."""
        before, holders = call.cells, call.holders
        statement = call.statements.get(call.line)
        self.look_at(call, statement)
        keys: list[Key] = []
        if isinstance(statement, ASSIGNMENTS) and not call.visit.error:
            keys = self.targets_of(statement, call)
        for key, cell in call.cells.items():
            if key[0] in holders and has_changed(before.get(key), cell):
                keys.append(key)
        whole = set()  # the ids of those that are said as a whole
        for key in keys:
            value = call.cells[key].value
            if id(value) not in holders or isinstance(value, list):
                whole.add(id(value))
        for key in dict.fromkeys(keys):
            place, value, _ = call.cells[key]
            call.visit.keys.append(key)
            call.visit.values.append(value)
            if key[0] not in whole:
                text = self.words.in_words(value, call.name_of(value, place))
                call.visit.texts.append(f"{place} = {text}")

    # --- snapshots ---

    def look_at(self, call: Call, statement: ast.stmt | None = None) -> None:
        """Take a snapshot: the cells that the names of a call reach.

        The names in a statement come first, then the newest ones.
        """
        call.cells = {}
        frame = call.frame
        call.holders = {id(call), id(frame.f_globals)}

        def add(key: Key, place: str, value: Any, depth: int) -> None:
            if key in call.cells:
                return
            call.cells[key] = Cell(place, value, len(value) if isinstance(value, list) else 0)
            if depth:
                call.holders.add(id(value))
                for part_key, code, part in self.parts_of(value, frame):
                    add((id(value), part_key), f"{place}{code}", part, depth - 1)

        nodes = ast.walk(statement) if statement else []
        used = [node.id for node in nodes if isinstance(node, ast.Name)]
        values = {**frame.f_locals}
        for name in [*used, *reversed(values)]:
            if name in values and not name.startswith("__"):
                add((id(call), name), name, values[name], DEPTH)
        for name in call.code.co_names:
            value = frame.f_globals.get(name)
            if isinstance(value, (dict, list, Real)) and name not in values:
                add((id(frame.f_globals), name), name, value, DEPTH)

    def parts_of(self, value: Any, frame: FrameType) -> list[tuple[Any, str, Any]]:
        """Return the parts of a value: the key of each, the code that takes it, and its value."""
        if isinstance(value, dict):
            return [(key, f"[{quoted(key)}]", part) for key, part in value.items()]
        if isinstance(value, (list, tuple)):
            return [(i, f"[{i}]", part) for i, part in enumerate(value[:MOST_ELEMENTS])]
        names = self.words.attributes.get(type(value), ())
        if type(value).__module__ == frame.f_globals.get("__name__"):  # an object of its own
            names = tuple(getattr(value, "__dict__", ()))
        return [(name, f".{name}", getattr(value, name)) for name in names]

    # --- statements ---

    def statements_of(self, code: CodeType) -> dict[int, ast.stmt]:
        """Return the statements of a function, or of a module, by their lines."""
        if code not in self.known:
            tree = ast.parse("".join(linecache.getlines(code.co_filename)))
            nodes: list = [tree]
            if code.co_name != "<module>":
                nodes = [node for node in ast.walk(tree) if begin_of(node) == code.co_firstlineno]
            self.known[code] = lines_of(nodes[0]) if nodes else {}
        return self.known[code]

    def targets_of(self, statement: ast.stmt, call: Call) -> list[Key]:
        """Return the keys of the cells that an assignment sets, also if it sets the old value."""
        found = []
        for node in ast.walk(statement):
            if isinstance(getattr(node, "ctx", None), ast.Store):
                with suppress(Exception):  # its names have other values now, or it is no cell
                    key = self.key_of(node, call)
                    if key in call.cells:
                        found.append(key)
        return found

    def key_of(self, target: Any, call: Call) -> Key:
        """Return the key of the cell that a target is."""
        if isinstance(target, ast.Name):
            return id(call), target.id
        holder = id(self.value_of(target.value, call))
        if isinstance(target, ast.Attribute):
            return holder, target.attr
        return holder, self.value_of(target.slice, call)

    def value_of(self, node: ast.expr, call: Call) -> Any:
        """Return the value of an expression; raise a LookupError if a look could change something.

        This is so with a call that may do more, and with an iterator, which a look moves on.
        """
        values = {**call.frame.f_locals}
        for part in ast.walk(node):
            if isinstance(part, ast.Call):
                function = self.value_of(part.func, call)
                if not any(function is known for known in self.words.functions):
                    raise LookupError
            elif isinstance(part, ast.Name) and hasattr(values.get(part.id), "__next__"):
                raise LookupError
        code = compile(ast.Expression(node), call.code.co_filename, "eval")
        return eval(code, call.frame.f_globals, values)


class Sides(ast.NodeTransformer):
    """Puts the values of the sides of a condition in place of their code."""

    def __init__(self, trace: Trace, call: Call):
        self.trace = trace
        self.call = call

    def visit(self, node: Any) -> Any:
        is_not = isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not)
        if is_not or isinstance(node, CONDITIONS):
            return self.generic_visit(node)
        with suppress(Exception):  # Python has not looked at it
            value = self.trace.value_of(node, self.call)
            name = self.call.name_of(value, ast.unparse(node))
            return ast.Name(self.trace.words.in_words(value, name))
        return node


def truth_of(statement: ast.If | ast.While, call: Call) -> str:
    """Return the condition of a statement with values, and whether it is true: "2 < 1: False".

    The next line says so, but not if the body stands in the same one.
    """
    first, last = statement.body[0].lineno, statement.body[-1].end_lineno or 0
    is_true = f"{first <= call.frame.f_lineno <= last}"
    if first == statement.lineno:
        return call.condition
    is_said = call.condition in (is_true, ast.unparse(statement.test))
    return is_true if is_said else f"{call.condition}: {is_true}"


def has_changed(before: Cell | None, now: Cell) -> bool:
    """Return whether a cell has got another value or size. Equal numbers are the same."""
    if before is None or before.size != now.size:
        return True
    is_plain = isinstance(now.value, (Real, str)) and type(before.value) is type(now.value)
    is_equal = is_plain and before.value == now.value
    return before.value is not now.value and not is_equal


def quoted(key: Any) -> str:
    """Return a key as code: "mass" in quotes."""
    return f'"{key}"' if isinstance(key, str) else f"{key!r}"


def begin_of(node: Any) -> int:
    """Return the first line of a function, maybe that of a decorator; 0 if it is none."""
    if not isinstance(node, ast.FunctionDef):
        return 0
    parts: list[Any] = [node, *node.decorator_list]
    return min(part.lineno for part in parts)


def lines_of(block: Any) -> dict[int, ast.stmt]:
    """Return the statements of a function or a module by the lines of their heads.

    Of two in a line, it is the outer one.
    """
    found: dict[int, ast.stmt] = {}
    for node in ast.iter_child_nodes(block):
        if isinstance(node, DEFINITIONS):
            continue
        if isinstance(node, ast.stmt) and not is_silent(node):
            for line in range(node.lineno, end_of_head(node) + 1):
                found.setdefault(line, node)
        for line, statement in lines_of(node).items():
            found.setdefault(line, statement)
    return found


def end_of_head(node: Any) -> int:
    """Return the last line of a statement; of a loop, an if or a match, that of its head."""
    inner = [part for part in ast.iter_child_nodes(node) if not isinstance(part, BLOCKS)]
    if len(inner) == len([*ast.iter_child_nodes(node)]):
        return node.end_lineno
    parts = [part for head in inner for part in ast.walk(head)]
    return max(getattr(part, "end_lineno", node.lineno) for part in parts)


def is_silent(node: ast.stmt) -> bool:
    """Return whether a statement is no row: it gives nothing."""
    is_docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    is_start = isinstance(node, ast.If) and "__name__" in ast.unparse(node.test)
    return is_docstring or is_start or isinstance(node, SILENT)
