"""Open the page in the usual browser, and let no other user of the machine read its key."""

import platform
import shutil
import tempfile
import threading
import webbrowser
from contextlib import suppress
from pathlib import Path

# Browsers without a canvas.
TEXT_BROWSERS = {"www-browser", "links", "links2", "elinks", "lynx", "w3m"}


class BrowserStart:
    """A start of the browser, and the file that leads it to the page.

    All users of a machine can read the command of a browser. So the browser gets a file that only
    you can read, and that leads on to the address with the key; Jupyter does the same.
    """

    def __init__(self) -> None:
        self.folder: Path | None = None

    def open(self, address: str) -> None:
        """Open the page at this address, if there is a browser with pictures.

        Where the browser cannot see any file of this system, it gets the address itself; such a
        system has one user.
        """
        with suppress(webbrowser.Error, OSError):
            browser = webbrowser.get()
            if Path(getattr(browser, "name", "")).name in TEXT_BROWSERS:
                return
            place = address if browser_is_outside() else self.make_file(address)
            threading.Thread(target=browser.open, args=(place,), daemon=True).start()

    def make_file(self, address: str) -> str:
        """Make the file that leads to this address, and return its own; raises an OSError.

        It is in a folder of its own, which only you can enter: among the temporary files, or in
        your home folder, as a browser from a snap cannot read those.
        """
        place = Path.home() if Path("/snap").exists() else None
        self.folder = Path(tempfile.mkdtemp(prefix="open-cradle-", dir=place))
        file = self.folder / "open.html"
        file.write_text(f'<meta http-equiv="refresh" content="0; url={address}">')
        return file.as_uri()

    def delete_file(self) -> None:
        """Delete the file and its folder; the browser has read it."""
        if self.folder:
            shutil.rmtree(self.folder, ignore_errors=True)


def browser_is_outside() -> bool:
    """Return whether the browser is of another system around this one: Windows, or ChromeOS."""
    return "microsoft" in platform.release().lower() or Path("/dev/.cros_milestone").exists()
