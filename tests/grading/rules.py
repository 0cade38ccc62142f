"""The rules of search.py: code that a student has written, the code that may be meant, and words for the change.

In them, n is a name, s a text, z a number in the code, o an operation. If the value is known, d is a dictionary, x a
number, and l a dictionary, a list or a tuple. v is any value, B and C are lines, and any other small letter is any
expression. The search tries each name of the function for N (for D, E, L and X, those that may have
such a value), each function for F, each name without a value for U, each element that the function names for S, each
key for K, each number for Z, and for Q what a text says without its quotes. The words never show the whole new line.
"""

import ast
from itertools import permutations

KEYS = "theta", "omega", "objects", "mass", "e", "color", "texture"
NUMBERS = 0, 1, 2, 1.05, 0.1, 4, 5
SIGNS, COMPARISONS = ("+", "-", "*", "/", "//", "**", "%"), ("<=", "<", ">=", ">", "==", "!=")
MOVED = "brackets are missing, or stand at the wrong place"

# By rank: the smallest changes come first. A row is a rule:
# fmt: off
_EXPRESSIONS = [
    [
        ("n", "N", "another name belongs in place of {n}"),
        ("a[n]", "a['n']", "{n} needs quotes"),
        ("{n: b}", "{'n': b}", "{n} needs quotes"),
        ("s", "Q", "{s} needs no quotes"),
        ("z", "Z", "another number belongs in place of {z}"),
        ("-a", "a", "-{a} needs another sign"),
        ("s", "K", "another key belongs in place of {s}"),
        *((f"a {sign} z", "a", f"{sign} {{z}} does not belong behind {{a}}") for sign in "+-"),
        *((f"a {old} b", f"a {new} b", f"another sign belongs in place of {old} in front of {{b}}") for old in SIGNS for new in SIGNS[:4] if new != old),
        *((f"a {old} b", f"a {new} b", f"another sign belongs in place of {old}") for some in (COMPARISONS[:4], COMPARISONS[4:]) for old, new in permutations(some, 2)),
        ("a and b", "a, b", "commas belong in place of and"),
        ("{}", "[]", "[ ] belong in place of {{ }}"),
        ("a(b)", "a * b", "a * is missing behind {a}"),
        ("a()", "a", "( ) does not belong behind {a}"),
        ("a(b)", "a[b]", "[ ] belong in place of ( ) behind {a}"),
        ("a[b]", "a(b)", "( ) belong in place of [ ] behind {a}"),
        ("a[b]", "b", "{b} alone belongs in place of {a}[{b}]"),
        ("a[b]", "a", "[{b}] does not belong behind {a}"),
        ("(a,)", "a", "the comma does not belong behind {a}"),
        *((f"(a {one} b) {two} c", f"a {one} (b {two} c)", MOVED) for one in SIGNS[:4] for two in SIGNS[:4]),
        *((f"a {one} (b {two} c)", f"(a {one} b) {two} c", MOVED) for one in SIGNS[:4] for two in SIGNS[:4]),
    ],
    [
        *((f"a {old} b", f"a {new} b", f"another sign belongs in place of {old}") for old, new in permutations(COMPARISONS, 2) if {old, new} & {"==", "!="}),
        ("v", "-v", "{v} needs another sign"),
        *(("z", f"z {sign} 1", "another number belongs in place of {z}") for sign in "+-"),
        ("n", "S", "another value belongs in place of {n}"),
        ("v", "v()", "( ) is missing behind {v}"),
        ("d", "d[K]", "a key in [ ] is missing behind {d}"),
        *(("v", f"v.{name}", f".{name} is missing behind {{v}}") for name in ("pos", "radius", "csv")),
        ("z", "N", "a name belongs in place of {z}"),
        *(("n", f"n {sign} 1", "another index belongs in place of {n}") for sign in "+-"),
        ("n", "F", "another name belongs in place of {n}"),
        ("a.n", "a['n']", "a key in [ ] belongs behind {a}, and no dot"),
        *((f"a {sign} b", "a", f"{sign} {{b}} does not belong") for sign in SIGNS[:4]),
        *((f"a {sign} b", "b", f"{{a}} {sign} does not belong") for sign in SIGNS[:4]),
        *((f"a {sign} b", f"b {sign} a", f"the two sides of {sign} are exchanged") for sign in "-/"),
        *((f"f(a {sign} b)", f"f(a) {sign} b", "the bracket of {f} closes at the wrong place") for sign in (*SIGNS[:4], *COMPARISONS)),
        ("f(a) - f(b)", "f(a - b)", "one {f}( ) belongs around the whole difference"),
        ("f(a)", "a", "{f}( ) does not belong around {a}"),
        ("[a, b]", "(a, b)", "( ) belong in place of [ ] around {a}, {b}"),
    ],
    [
        ("n", "L[n]", "{n} is an index here: the element with this index belongs in its place"),
        ("s", "D[s]", "not {s} itself belongs here, but the value under this key"),
        *(("l", f"l[{one}]", "an index in [ ] is missing behind {l}") for one in "NZ"),
        ("d", "d['objects'][1]", "{d} is no bob: a bob is in the key 'objects'"),
        ("v['bob']", "v['objects'][1]", "{v} has no key 'bob': a bob is in the key 'objects'"),
        ("v", "mag(v)", "{v} must stand in the ( ) of mag"),
        *(("x", f"{name}(x)", f"{{x}} must stand in the ( ) of {name}") for name in ("sin", "range")),
        *(("l", f"{name}(l)", f"{{l}} must stand in the ( ) of {name}") for name in ("len", "list", "enumerate")),
        ("l", "range(len(l))", "{l} must stand in range(len( ))"),
        *(("d", f"d.{name}()", f".{name}() is missing behind {{d}}") for name in ("values", "items")),
        *((f"a {one} b", f"a {one} b {two} X", f"{{b}} needs one more value behind it, with {two}") for one in "+-" for two in "*/"),
        *(("o", f"o {sign} X", f"one more value belongs behind {{o}}, with {sign}") for sign in SIGNS[:4]),
        ("x", "1.05 * x", "{x} must be multiplied by one more value"),
        ("x", "x - 1", "a number must be subtracted from {x}"),
    ],
    [
        ("n", "N.pos", "another value belongs in place of {n}"),
        *(("x", f"x {sign} X", f"{{x}} needs one more value behind it, with {sign}") for sign in "*/-+"),
    ],
]
_LINES = [
    [
        *((one, "", "the line does not belong") for one in ("a", "a = b", "a += b", "return a", "return", "break", "continue", "pass")),
        *((one, "", "the lines of this block do not belong") for one in ("for a in b: B", "while a: B", "if a: B")),
        ("a == b", "a = b", "one = belongs in place of =="),
        ("a: b", "a = b", "= belongs in place of :"),
        *((f"print({one})", f"return {one}", "return belongs in place of print( )") for one in ("a", "a, b")),
        ("a = b", "b", "{a} = does not belong in front"),
        ("a = b", "b = a", "the two sides of = are exchanged"),
        ("a", "return a", "return is missing in front"),
        ("while a: B", "if a: B", "another word belongs in place of while"),
        *((f"a {sign}= b", "a = b", f"another sign belongs in place of {sign}=") for sign in SIGNS[:4]),
        *((f"a {old}= b", f"a {new}= b", f"another sign belongs in place of {old}=") for old in SIGNS[:4] for new in SIGNS[:2] if new != old),
    ],
    [
        *((f"if a: B{other}", f"if N == 0: B{other}", "another condition belongs in place of {a}") for other in ("", "\nelse: C")),
        ("for n in b: f(n, c, h, g)", "f(b, c, h, g)", "{f} handles all of {b} at once: the loop does not belong"),
        ("a = b", "return b", "return belongs in place of {a} ="),
        ("a = b", "a += b", "another sign belongs in place of ="),
        ("a[b] = c", "a.append(c)", "append belongs in place of [{b}] ="),
        ("return a", "a", "return does not belong in front"),
        ("a, b = c", "b, a = c", "{a} and {b} are exchanged"),
        *(("a, b, c = f", f"{order} = f", f"{words} are exchanged") for order, words in (("a, c, b", "{b} and {c}"), ("b, a, c", "{a} and {b}"), ("c, b, a", "{a} and {c}"))),
        ("for a, b in c: B", "for b, a in c: B", "{a} and {b} are exchanged"),
        *((f"{head}: B", "B", f"{head.split()[0]} does not belong, but the lines below it do") for head in ("for a in b", "while a", "if a")),
        ("if a: B\nelse: C", "if a: B", "else and its lines do not belong"),
        ("if a: B\nelse: C", "if a: C\nelse: B", "the lines below if and those below else are exchanged"),
        ("if a: B\nelse: C", "if a: B\nC", "else does not belong, but the lines below it do"),
    ],
    [
        *(("a", f"{one} = a", "a name and = are missing in front of {a}") for one in "UN"),
        ("a", "D[K] = a", "a key and = are missing in front of {a}"),
        *(("a = b", f"{one} = b", "another name belongs in place of {a}") for one in "NU"),
        *(("n = b", f"{one} = b", "{n} is only a name, and the value belongs in a pendulum, under a key in [ ]") for one in ("D[K]", "S")),
        ("n = b", "n.update(b)", "{n} is only a name here, and the dictionary itself must get the new values"),
        ("a[b] = c", "D[K] = c", "another key belongs in [ ] on the left of ="),
        ("a.n = b", "D[K] = b", "the value belongs in a pendulum, under a key in [ ]"),
        ("a, b = c", "D['omega'], E['omega'] = c", "the new values must be stored in the pendula"),
        ("f(a)", "return a", "return belongs in place of {f}"),
        ("return a.append(b)", "a.append(b)\nreturn a", "return needs a line of its own, below append"),
        *(("return a, b", f"return a {sign} X, b {sign} X", f"both values need one more value behind them, with {sign}") for sign in "*/"),
        *(("a = b", f"a = b {sign} X", f"one more value belongs on the right of =, with {sign}") for sign in SIGNS[:4]),
    ],
    [
        ("return a", "D[K] = a", "the value must be stored in a key, not returned"),
        ("for a in b: B", "for each_one in b: B", "the loop needs another name in place of {a}"),
    ],
]


def rule(old, new, words, is_line):
    """Return a rule with trees in place of code, and the large letters of the new code that stand for choices."""
    before, after = ast.parse(old).body[0], ast.parse(new)
    letters = dict.fromkeys(each.id for each in ast.walk(after) if isinstance(each, ast.Name) and each.id in "NDELXFUSKZ")
    return (before, after, [*letters], words) if is_line else (before.value, after.body[0].value, [*letters], words)


EXPRESSIONS = [[rule(*row, False) for row in rows] for rows in _EXPRESSIONS]
LINES = [[rule(*row, True) for row in rows] for rows in _LINES]
