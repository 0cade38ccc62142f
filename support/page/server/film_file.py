"""A film as one HTML file: the page with its scripts, its textures, and the pictures of the film.

Any browser opens it, without Python and without a network; film.js plays it. What needs a program
has the attribute data-served in page.html, and is not shown.
"""

import base64
import gzip
import re
from collections.abc import Sequence
from importlib.metadata import files
from math import inf
from typing import Any

from support.files.experiments import YOUR_CSV
from support.page.server.changes import as_json
from support.page.server.film import FilmPicture
from support.page.server.web_files import filled_page, public_files, script, SCRIPTS

# Of the state; the rest is for controls, and for the words of a program.
STATE_OF_FILM = (
    "title", "stopped", "summary",
    "question", "unknown", "hits", "motion", "bars", "curves", "view",
)  # fmt: skip
CURVES = 0.4  # s from one state of the graph to the next: it is most of the film
# A number that is more exact than can be seen; no text for a reader has one after such a sign.
LONG_NUMBER = re.compile(r"(?<=[,:[A-Za-z])-?\d+\.\d{5,}(?:e-?\d+)?")
TEXTURE = re.compile(r'":(\w+\.jpg)"')  # a texture's name, as VPython has it


def film_as_html(pictures: Sequence[FilmPicture]) -> bytes:
    """Return a film as an HTML file, from its pictures."""
    film = as_json(pictures_for_player(pictures))
    film = LONG_NUMBER.sub(lambda number: f"{float(number[0]):.5g}", film)
    web = public_files()
    textures = {name: in_letters(web[name]) for name in {*TEXTURE.findall(film)}}
    head = [
        f"<!--\n{licence()}\n-->",
        script("document.documentElement.className = 'playing-film';"),
        f"<style>{web['style.css'].decode()}</style>",
    ]
    scripts = [
        *(script(web[name].decode()) for name in SCRIPTS),
        script(as_json(textures), ' type="application/json" class="textures"'),
        script(
            in_letters(gzip.compress(film.encode(), mtime=0)), ' type="text/plain" class="film"'
        ),
    ]

    def address(name: str) -> str:
        return f"data:text/javascript;base64,{in_letters(web[f'{name}.js'])}"

    return filled_page("\n".join(head), scripts, "film", address).encode()


def in_letters(content: bytes) -> str:
    return base64.b64encode(content).decode()


def pictures_for_player(pictures: Sequence[FilmPicture]) -> list[dict[str, Any]]:
    """Return pictures as film.js has them, with times (s) and the state of a film."""
    last_curves = -inf  # s
    for_player: list[dict[str, Any]] = []
    for time, changes in pictures:
        state = {name: value for name, value in changes["state"].items() if name in STATE_OF_FILM}
        # A new run begins with a new graph
        if "question" in state or time - last_curves >= CURVES:
            last_curves = time
        else:
            state.pop("curves", None)
        drawing = changes["drawing"]
        for_player.append({"time": time - pictures[0].time, "drawing": drawing, "state": state})
    for_player[0]["state"].setdefault("stopped", "")  # or it would stay when the film goes back
    name = pictures[0].changes["state"]["controls"]["experiment"]["value"]
    if name != YOUR_CSV:
        for_player[0]["state"]["title"] += f": {name}"
    return for_player


def licence() -> str:
    """Return VPython's licence, which says that it stays with each copy."""
    found = [file for file in files("vpython") or [] if file.name.startswith("LICENSE")]
    return "\n".join(file.read_text(encoding="utf-8") for file in found)
