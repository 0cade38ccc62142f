"""The files of the page: its own, and those of VPython that it uses."""

import json
from collections.abc import Mapping
from html import escape
from pathlib import Path

from support.page.names import names_as_module, Texts
from support.page.vpython_inside import files_for_a_browser

WEB = Path(__file__).parents[1] / "web"
PAGE = WEB / "page.html"
# In page.html
NO_MAP = '<script type="importmap"></script>'
LIVE = '<script type="module" src="line.js" data-served></script>'


def keyless_files() -> dict[str, bytes | Path]:
    """Return the files that need no key, by name: the content or the path."""
    files = files_for_a_browser()
    for path in WEB.iterdir():
        if path.suffix in (".js", ".css", ".jpg"):
            files[path.name] = path
    files["names.js"] = names_as_module().encode()
    return files


def page_with(texts: Texts) -> bytes:
    """Return the page with these texts, by their names in data-text.

    So the page has them also if it never hears from the program.
    """
    addresses = {name: f"./{name}.js" for name in module_names()}
    page = page_with_modules(addresses)
    # All at once: else, a module comes only when another one asks for it.
    links = [f'<link rel="modulepreload" href="{address}">' for address in addresses.values()]
    page = page.replace(LIVE, "\n".join([*links, LIVE]))
    for name, text in texts.items():
        place = f'data-text="{name}">'
        page = page.replace(place, place + escape(str(text)))
    return page.encode()


def module_names() -> list[str]:
    """Return the bare names by which the modules import each other."""
    return ["names", *(path.stem for path in WEB.glob("*.js"))]


def page_with_modules(addresses: Mapping[str, str]) -> str:
    """Return the page with the addresses of its modules, by their bare names."""
    page = PAGE.read_text(encoding="utf-8")
    return page.replace(NO_MAP, NO_MAP.replace("><", f">{json.dumps({'imports': addresses})}<"))


def content_of(file: bytes | Path) -> bytes:
    """Return the content of one of these files."""
    return file.read_bytes() if isinstance(file, Path) else file
