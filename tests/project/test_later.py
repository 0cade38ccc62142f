"""Slow modules are imported later."""

import subprocess
import sys

import pytest
from programs import ROOT

from support.start.later import import_later, import_now

MODULE = "slow_module"


@pytest.fixture(autouse=True)
def imports(tmp_path, monkeypatch):
    """A module that counts its imports."""
    (tmp_path / f"{MODULE}.py").write_text("import sys\nsys.slow_imports.append(1)\nvalue = 7\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "slow_imports", [], raising=False)
    monkeypatch.delitem(sys.modules, MODULE, raising=False)
    return sys.slow_imports


@pytest.mark.parametrize("now", [True, False])
def test_a_module_is_imported_once_when_it_is_used_or_wanted(imports, now):
    import_later(MODULE)
    import slow_module as early

    assert imports == []
    if now:
        import_now(MODULE)
        assert imports == [1]
    assert (early.value, early.value) == (7, 7)
    import slow_module

    assert (slow_module.value, imports) == (7, [1])
    import_now(MODULE)
    assert imports == [1]


def test_a_module_that_is_there_is_left_alone(imports):
    import slow_module

    import_later(MODULE)
    assert sys.modules[MODULE] is slow_module


def test_a_module_that_is_not_installed_raises_its_usual_error():
    import_later("no_such_module")
    with pytest.raises(ModuleNotFoundError, match="No module named 'no_such_module'"):
        import no_such_module  # noqa: F401


PROGRAMS_IMPORTS = """
import runpy, sys
from support import headless_vpython
headless_vpython.install()
from support.page import page
page.show_page = lambda *given: print("pandas.core" in sys.modules)
sys.argv = [sys.argv[1]]
runpy.run_path(sys.argv[0], run_name="__main__")
"""


@pytest.mark.parametrize("name", ["visualize_cradle_run", "visualize_double_cradle_run"])
def test_a_program_has_not_imported_pandas_when_it_opens_the_page(name):
    """Otherwise, the first picture would come later."""
    command = [sys.executable, "-c", PROGRAMS_IMPORTS, str(ROOT / "src" / f"{name}.py")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("False\n", "")
