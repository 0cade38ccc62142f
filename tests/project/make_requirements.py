"""Make support/requirements.txt: `python tests/project/make_requirements.py PYTHON ...`.

The file lists the packages that the programs import, with the bounds of pyproject.toml. A new major version may need
a package that `pip install --no-deps` does not install, so each bound ends below it. Each PYTHON must be able to start
the programs; several Pythons together need more packages than one. Some packages import others only if they are
installed. To leave those out, use Pythons with only the packages of the present list.
"""

import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
REQUIREMENTS = ROOT / "support" / "requirements.txt"
SECONDS = 60  # after which an import counts as never coming
HEAD = """\
# What the programs import, and no more, for pip install --no-deps -r support/requirements.txt
# VPython also asks for Jupyter, which a program that is started as a file does without: a hundred more packages.
# Made by tests/project/make_requirements.py.
"""
# Prints the package of each module: {module: (name, version)}.
PACKAGES = """
import json
from importlib import metadata
packages = [(package, file) for package in metadata.distributions() for file in package.files or ()]
print(json.dumps({file.parts[0].partition(".")[0]: (package.name, package.version) for package, file in packages}))
"""


def bounds() -> dict[str, str]:
    """Return the bounds of the packages that pyproject.toml names, as {"setuptools": "<80.9", ...}."""
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    return dict(re.findall(r'^    "([\w-]+)([<>=][^"]+)",', text, re.MULTILINE))


def imported(python) -> dict[str, str]:
    """Return the packages that the page imports with this Python while it waits for a browser, as {name: version}."""
    program = [python, "-X", "importtime", ROOT / "src" / "visualize_cradle_run.py", "--no-browser"]
    with tempfile.TemporaryDirectory() as folder:
        told = Path(folder, "imports")
        with told.open("w") as file, subprocess.Popen(program, stdout=subprocess.PIPE, stderr=file) as process:
            if not process.stdout.readline():
                sys.exit(f"{python}: the program does not start")
            deadline = time.monotonic() + SECONDS
            while "pandas" not in imports_in(told) and time.monotonic() < deadline:  # a thread imports it last
                time.sleep(0.1)
            process.kill()
        modules = {module.partition(".")[0] for module in imports_in(told)}
    done = subprocess.run([python, "-c", PACKAGES], stdout=subprocess.PIPE, check=True)
    packages = json.loads(done.stdout)
    return dict(packages[module] for module in modules & packages.keys())


def imports_in(told) -> set[str]:
    """Return the modules whose import has ended, from what -X importtime wrote to this file."""
    lines = told.read_text().splitlines()
    return {line.rpartition("|")[2].strip() for line in lines if line.startswith("import time:")}


def lines(found) -> list[str]:
    """Return the requirements for these packages, [(name, version), ...]; a name may have several versions."""
    majors: dict[str, int] = {}
    for name, version in found:
        majors[name] = max(majors.get(name, 0), int(version.partition(".")[0]))
    given = bounds()
    return [requirement(name, given.get(name, ""), major) for name, major in sorted(majors.items())]


def requirement(name, bound, major) -> str:
    """Return a package with its bound. Without an upper end, the bound ends below the next major version."""
    parts = [bound] if "<" in bound else [*filter(None, [bound]), f"<{major + 1}"]
    return name + ",".join(parts)


def main() -> None:
    """Write the file for the Pythons on the command line."""
    found = [package for python in sys.argv[1:] or [sys.executable] for package in imported(python).items()]
    text = HEAD + "".join(f"{line}\n" for line in lines(found))
    REQUIREMENTS.write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
