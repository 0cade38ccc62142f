"""A run as one HTML file: the page, VPython's scripts, textures, and the pictures of the film.

Any browser opens it, without Python and without a network; run.js plays it. What the page has only
with a program behind it has the attribute data-served in page.html, and is not in the file, or not
shown.
"""

import base64
import gzip
import json
import re
from collections.abc import Sequence
from importlib.metadata import files
from math import inf
from typing import Any

from support.files.experiments import YOUR_CSV
from support.page.server.changes import as_json
from support.page.server.film import FilmPicture
from support.page.server.web_files import (
    content_of,
    keyless_files,
    LIVE,
    module_names,
    page_with_modules,
)

# Of the state; the rest is for controls, or names files of this machine.
STATE_OF_RUN = (
    "title", "question", "unknown", "hits", "motion", "bars", "curves", "view", "summary", "ended",
)  # fmt: skip
CURVES = 0.4  # s from one state of the graph to the next: it is most of the film
LONG_NUMBER = re.compile(r"-?\d+\.\d{5,}(?:e-?\d+)?")
TEXTURE = re.compile(r'":(\w+\.jpg)"')  # a texture's name, as VPython has it
QUOTED_PATH = re.compile(r"'[^']*[/\\]([^'/\\]+)'")  # in a message of Python's


def run_as_html(pictures: Sequence[FilmPicture]) -> bytes:
    """Return a run as an HTML file, from the pictures of its film."""
    run = json.dumps(pictures_for_player(pictures), separators=(",", ":"))
    web = keyless_files()

    def text_of(name: str) -> str:
        return content_of(web[name]).decode()

    textures = {}
    for name in set(TEXTURE.findall(run)):
        textures[name] = in_letters(content_of(web[name]))
    player = [
        script(' type="application/json" class="textures"', json.dumps(textures)),
        script(' type="text/plain" class="run"', in_letters(gzip.compress(run.encode(), mtime=0))),
        script(' type="module"', 'import "run";'),
    ]

    modules = {}
    for name in module_names():
        modules[name] = f"data:text/javascript;base64,{in_letters(content_of(web[f'{name}.js']))}"
    html = page_with_modules(modules)
    html = html.replace("<!doctype html>", f"<!doctype html>\n<!--\n{licence()}\n-->", 1)
    html = html.replace('<html lang="en">', '<html lang="en" class="recorded">', 1)
    html = html.replace(LIVE, "\n".join(player), 1)
    html = re.sub(r"(?s)<script[^>]* data-served>.*?</script>\n", "", html)
    html = re.sub(
        r'<link rel="stylesheet" href="(.*?)">',
        lambda found: f"<style>\n{text_of(found[1])}</style>",
        html,
    )
    html = re.sub(
        r'<script src="(.*?)"></script>',
        lambda found: script("", text_of(found[1])),
        html,
    )
    return html.encode()


def script(attributes: str, text: str) -> str:
    """Return a script with its text inside."""
    safe = text.replace("</script", "<\\/script")
    return f"<script{attributes}>{safe}</script>"


def in_letters(content: bytes) -> str:
    return base64.b64encode(content).decode()


def pictures_for_player(pictures: Sequence[FilmPicture]) -> list[dict[str, Any]]:
    """Return pictures as run.js has them: with times (s), and numbers as exact as can be seen."""
    last_curves = -inf  # s
    for_player = []
    for time, changes in pictures:
        picture = json.loads(as_json(changes), parse_float=rounded)
        state = {name: value for name, value in picture["state"].items() if name in STATE_OF_RUN}
        if time - last_curves >= CURVES:
            last_curves = time
        else:
            state.pop("curves", None)
        if "title" in state:
            name = picture["state"]["controls"]["experiment"]["value"]
            if name != YOUR_CSV:
                state["title"] += f": {name}"
        if state.get("ended"):
            state["ended"] = QUOTED_PATH.sub(r"'\1'", state["ended"])
        drawing = {key: shortened(change) for key, change in picture["drawing"].items()}
        for_player.append({"time": time - pictures[0].time, "drawing": drawing, "state": state})
    return for_player


def shortened(change: Any) -> Any:
    """Return a change of the drawing with shorter numbers in its text."""
    if isinstance(change, dict):
        return change
    return LONG_NUMBER.sub(lambda number: str(rounded(number[0])), change)


def rounded(number: str) -> float:
    return float(f"{float(number):.5g}")


def licence() -> str:
    """Return VPython's licence, which says that it stays with each copy."""
    texts = []
    for file in files("vpython") or []:
        if file.name.startswith("LICENSE"):
            texts.append(file.read_text(encoding="utf-8"))
    return "\n".join(texts)
