"""A run as one HTML file: the page, VPython's scripts, textures, and the pictures of the film.

Any browser opens it, without Python and without a network; run.js plays it. What the page has only
with a program behind it has the attribute data-served in page.html, and is not in the file, or not
shown.
"""

import base64
import gzip
import json
import re
from collections.abc import Iterable
from importlib.metadata import files
from pathlib import Path
from typing import Any

from support.files.data_file import RUN_LINE
from support.page.film import Picture
from support.page.tabs import Tabs
from support.page.web_files import content_of, keyless_files, PAGE
from support.start.checks_command import ROOT

# Of the state; the rest is for controls, or names files of this machine.
SHOWN = (
    "title", "remark", "question", "hit", "motion", "bars", "impacts", "colors", "curves", "view",
    "summary", "ended",
)  # fmt: skip
LONG_NUMBER = re.compile(r"-?\d+\.\d{5,}(?:e-?\d+)?")
TEXTURE = re.compile(r":(\w+\.jpg)")  # a texture's name, as VPython has it


def run_as_html(tabs: Tabs) -> str:
    """Return the run that these tabs have shown last as the text of an HTML file."""
    tabs.film.take(tabs.all, at_once=True)
    run = as_text(tabs.film.pictures)
    web = keyless_files()

    def text_of(name: str) -> str:
        return content_of(web[name]).decode()

    def script(attributes: str, text: str) -> str:
        safe = text.replace("</script", "<\\/script")
        return f"<script{attributes}>{safe}</script>"

    textures = {}
    for name in sorted({*TEXTURE.findall(run), "wood_texture.jpg"}):
        content = base64.b64encode(content_of(web[name])).decode()
        textures[f":{name}"] = f"data:image/jpeg;base64,{content}"
    packed = base64.b64encode(gzip.compress(run.encode(), mtime=0)).decode()
    player = [
        script(' type="application/json" class="textures"', json.dumps(textures)),
        script(' type="text/plain" class="run"', packed),
        script("", text_of("run.js")),
    ]

    html = PAGE.read_text(encoding="utf-8")
    html = html.replace("<!doctype html>", f"{RUN_LINE}\n<!--\n{licence()}\n-->", 1)
    html = html.replace('<html lang="en">', '<html lang="en" class="recorded">', 1)
    html = html.replace('<script src="line.js" data-served></script>', "\n".join(player), 1)
    html = re.sub(r"(?s)<script[^>]* data-served>.*?</script>\n", "", html)
    html = re.sub(
        r'<link rel="stylesheet" href="(.*?)">',
        lambda found: f"<style>\n{text_of(found[1])}</style>",
        html,
    )
    return re.sub(
        r'<script( type="module")? src="(.*?)"></script>',
        lambda found: script(found[1] or "", text_of(found[2])),
        html,
    )


def as_text(pictures: Iterable[Picture]) -> str:
    """Return pictures as JSON, with numbers as exact as can be seen, and no path of this machine.

    Each is a message to a tab, with its time (s), and whether it is whole.
    """
    first = next(iter(pictures)).time
    shown: list[dict[str, Any]] = []
    for picture in pictures:
        message = json.loads(picture.message)
        state = {name: message["state"][name] for name in SHOWN if name in message["state"]}
        shown.append(
            {
                "time": picture.time - first,
                "whole": picture.is_whole,
                "cmds": message["cmds"],
                "attrs": message["attrs"],
                "state": state,
            }
        )
    text = json.dumps(shown, separators=(",", ":"))
    for folder in (ROOT, Path.home()):  # an error of Python's can name a file
        text = text.replace(json.dumps(str(folder))[1:-1], "...")
    return LONG_NUMBER.sub(lambda number: f"{float(number[0]):.5g}", text)


def licence() -> str:
    """Return VPython's licence, which says that it stays with each copy."""
    texts = []
    for file in files("vpython") or []:
        if file.name.startswith("LICENSE"):
            texts.append(file.read_text(encoding="utf-8"))
    return "\n".join(texts).replace("--", "- -")
