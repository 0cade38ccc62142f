"""The fast path: many ticks in one call, on plain numbers, while the functions are as shipped.

The result is that of single ticks, to the last bit (tests/project/cradle/test_many_ticks.py).
"""

import linecache
import sys
from functools import cache
from hashlib import sha256
from io import StringIO
from itertools import pairwise
from math import sin
from pathlib import Path
from tokenize import COMMENT, generate_tokens, NL, tok_name
from typing import Any

from support.cradle.cradle import Cradle
from support.cradle.hits import Hits
from support.pendulum import contact_distance, Pendulum, show_pendulum
from support.root import ROOT, SRC

PENDULUM = ROOT / "support" / "pendulum.py"
PROGRAM = SRC / "visualize_cradle_run.py"
# Of the code of the three files of a tick. If you change one of them for good, change many_ticks as
# well, and put the new digest here: a test says it.
DIGEST = "475ec12eebdc6f85"


def is_shipped(names: dict[str, Any]) -> bool:
    """Return whether the program with these names, and all that a tick calls, is as shipped."""
    file = Path(names.get("__file__", ""))
    return file.resolve() == PROGRAM and digest_of(*texts_of(names)) == DIGEST


def texts_of(names: dict[str, Any]) -> list[str]:
    """Return the text of each file of a tick of the program with these names, as it runs.

    Somebody may have saved a file of src/ since.
    """
    texts = [PENDULUM.read_text(encoding="utf-8")]
    swinging = getattr(sys.modules.get("src.swinging"), "__file__", "")  # or nobody imports it
    for file in (swinging, names["__file__"]):
        texts.append("".join(linecache.getlines(file)))
    return texts


@cache
def digest_of(*texts: str) -> str:
    """Return the digest of the code in these texts; comments and line ends do not change it."""
    code = []
    for text in texts:
        for token in generate_tokens(StringIO(text).readline):
            if token.type not in (COMMENT, NL):
                code.append(token.string.strip() or tok_name[token.type])
    return sha256("\n".join(code).encode()).hexdigest()[:16]


def is_watched() -> bool:
    """Return whether a debugger, a tracer or a profiler must meet each call of a function."""
    if sys.gettrace() or sys.getprofile():
        return True
    monitoring = getattr(sys, "monitoring", None)  # from Python 3.12 on; it has the tools 0 to 5
    return bool(monitoring and any(map(monitoring.get_tool, range(6))))


def many_ticks(cradle: Cradle, hits: Hits, ticks: int, names: dict[str, Any]) -> None:
    """Do `ticks` ticks with the constants among these names.

    Where two bobs are so near along x that they may touch, the function that collides gets them, as
    in a single tick.
    """
    r_param, dt, g = names["R_PARAM"], names["DT"], names["G"]
    pend_list = cradle.pend_list
    pairs = []
    for i, (left, right) in enumerate(pairwise(pend_list)):
        axle1, bob1, _ = left["objects"]
        axle2, bob2, _ = right["objects"]
        gap = axle2.pos.x - axle1.pos.x - contact_distance(bob1.radius, bob2.radius)
        # The bobs may touch if their sines differ by this; 1e-6 is more than the rounding errors.
        pairs.append((i, gap / r_param - 1e-6))
    everyone = range(len(pend_list))
    thetas = cradle.values("theta")
    omegas = cradle.values("omega")
    sines = [sin(theta) for theta in thetas]
    hits.was_asked = True  # each tick asks about each pair
    for _ in range(ticks):
        hits.tick += 1
        for i in everyone:
            # The formulas of angle_update; a call would double the time.
            omega = omegas[i] - g * sines[i] / r_param * dt
            theta = thetas[i] + omega * dt
            omegas[i] = omega
            thetas[i] = theta
            sines[i] = sin(theta)
        for i, near in pairs:
            if sines[i] - sines[i + 1] >= near:
                both = slice(i, i + 2)
                left, right = pend_list[both]
                show([left, right], thetas[both], omegas[both], r_param)
                cradle.tick_names[cradle.collide_name](left, right, r_param)
                omegas[i] = left["omega"]
                omegas[i + 1] = right["omega"]
    show(pend_list, thetas, omegas, r_param)


def show(pendula: list[Pendulum], thetas: list[float], omegas: list[float], r_param: float) -> None:
    """Turn pendula to these thetas (rad), with these omegas (rad/s)."""
    for pend, theta, omega in zip(pendula, thetas, omegas, strict=True):
        pend["theta"] = theta
        pend["omega"] = omega
        show_pendulum(pend, r_param)
