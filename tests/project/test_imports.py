"""What a module may import: the contracts in pyproject.toml hold, and look at every folder."""

from importlinter.api import read_configuration
from programs import python, ROOT

LINT = """
import sys
from importlinter.cli import lint_imports
sys.path.insert(0, "tests")
sys.exit(lint_imports(no_cache=True))
"""


def test_the_contracts_of_imports_in_pyproject_hold():
    done = python("-c", LINT)
    assert done.returncode == 0, done.stdout


def test_the_contracts_look_at_each_folder_of_modules():
    """A folder without __init__.py is looked at only if it is named."""
    files = [*(ROOT / "src").rglob("*.py"), *(ROOT / "support").rglob("*.py")]
    folders = {file.parent.relative_to(ROOT) for file in files}
    options = read_configuration(str(ROOT / "pyproject.toml"))["session_options"]
    packages = {".".join(folder.parts) for folder in folders} | {"grading", "line_by_line"}
    assert packages == {*options["root_packages"]}
