"""The files of the page: its own, and those of VPython that it uses."""

from html import escape
from pathlib import Path

from support.page.names import Texts
from support.page.vpython_inside import files_for_a_browser

WEB = Path(__file__).with_name("web")
PAGE = WEB / "page.html"


def keyless_files() -> dict[str, bytes | Path]:
    """Return the files that need no key, by name: the content or the path."""
    files = files_for_a_browser()
    for path in WEB.iterdir():
        if path.suffix in (".js", ".css"):
            files[path.name] = path
    return files


def page_with(texts: Texts) -> bytes:
    """Return the page with these texts, by their names in data-text.

    So the page has them also if it never hears from the program.
    """
    page = PAGE.read_text(encoding="utf-8")
    for name, text in texts.items():
        place = f'data-text="{name}">'
        page = page.replace(place, place + escape(str(text)))
    return page.encode()


def content_of(file: bytes | Path) -> bytes:
    """Return the content of one of these files."""
    return file.read_bytes() if isinstance(file, Path) else file
