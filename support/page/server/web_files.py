"""The page and its files: its own, and those of VPython that it uses.

page.html has two holes, for a head and for scripts. The server's page asks for both, by links; a
film has them in itself (film_file.py).
"""

import json
from collections.abc import Callable, Sequence
from html import escape
from pathlib import Path

from support.page.names import Texts
from support.page.vpython_inside import files_for_a_browser

WEB = Path(__file__).parents[1] / "web"
PAGE = WEB / "page.html"
LIVE_HEAD = WEB / "live.html"
# VPython's; the last one is the script of its own page, without its websocket.
SCRIPTS = "jquery.min.js", "glow.min.js", "vpython.js"


def public_files() -> dict[str, bytes]:
    """Return the content of the files that need no key, by their names."""
    files = files_for_a_browser()
    for path in WEB.iterdir():
        if path.suffix in (".js", ".css", ".jpg"):
            files[path.name] = path.read_bytes()
    return files


def page_with(texts: Texts) -> bytes:
    """Return the page with these texts, by their names in data-text.

    So the page has them even if the program never answers.
    """
    head = LIVE_HEAD.read_text(encoding="utf-8")
    scripts = [f'<script src="{name}"></script>' for name in SCRIPTS]
    page = filled_page(head, scripts, "connection", "./{}.js".format)
    for name, text in texts.items():
        place = f'data-text="{name}">'
        page = page.replace(place, place + escape(str(text)))
    return page.encode()


def filled_page(
    head: str, scripts: Sequence[str], source: str, address: Callable[[str], str]
) -> str:
    """Return the page with a head and with scripts.

    Its modules import each other by their bare names; address(name) says where one is. They run
    after the scripts. The module that brings the state comes last: "connection" or "film".
    """
    others = {path.stem for path in WEB.glob("*.js")} - {"connection", "film"}
    names = [*sorted(others), source]
    addresses = json.dumps({"imports": {name: address(name) for name in names}})
    imports = "".join(f'import "{name}";' for name in names)
    modules = [script(addresses, ' type="importmap"'), script(imports, ' type="module"')]
    page = PAGE.read_text(encoding="utf-8")
    page = page.replace("<!-- head -->", "\n".join([head, *modules]))
    return page.replace("<!-- scripts -->", "\n".join(scripts))


def script(text: str, attributes: str = "") -> str:
    """Return a script with its text inside."""
    safe = text.replace("</script", "<\\/script")
    return f"<script{attributes}>{safe}</script>"
