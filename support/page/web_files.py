"""The files of the page: its own, and those of VPython that it uses."""

import json
from collections.abc import Mapping
from html import escape
from importlib.util import find_spec
from pathlib import Path

from support.page.names import names_as_module

# Where glowcomm.html has its fonts and its own websocket behind it.
VPYTHON_SCRIPT = "window.__GSlang ="
WEB = Path(__file__).with_name("web")
PAGE = WEB / "page.html"
# In page.html
NO_MAP = '<script type="importmap"></script>'
LIVE = '<script type="module" src="line.js" data-served></script>'


def keyless_files() -> dict[str, bytes | Path]:
    """Return the files that need no key, by name: the content or the path."""
    [vpython] = find_spec("vpython").submodule_search_locations  # type: ignore[union-attr, misc]
    libraries = Path(vpython, "vpython_libraries")
    files: dict[str, bytes | Path] = {}
    for folder in (libraries, Path(vpython, "vpython_data"), WEB):
        for path in folder.iterdir():
            if path.suffix in (".js", ".css", ".jpg"):
                files[path.name] = path
    page = (libraries / "glowcomm.html").read_text(encoding="utf-8")
    _, start, script = page.partition(VPYTHON_SCRIPT)
    files["names.js"] = names_as_module().encode()
    files["vpython.js"] = (start + script).partition("</script>")[0].encode()
    # A call without a use, which some sites forbid.
    files["glow.min.js"] = content_of(files["glow.min.js"]).replace(b'eval("0");', b"")
    return files


def page_with(texts: Mapping[str, str]) -> bytes:
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
        page = page.replace(place, place + escape(text))
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
