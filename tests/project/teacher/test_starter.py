"""The folder that students get, made from the whole project, with its page."""

import json
import re

from programs import ROOT
from students import put_files

from grading.assignment import FUNCTIONS, SUITES


def test_vs_code_hides_what_is_there_and_no_file_of_a_student(starter):
    """Also after the programs and pytest have run."""
    others = ".venv/bin/python", "uv.lock", ".pytest_cache/tag", "src/__pycache__/begin.pyc"
    put_files(starter, dict.fromkeys(others, ""))
    settings = json.loads((starter / ".vscode/settings.json").read_text())
    hidden = set()
    for pattern in settings["files.exclude"]:
        found = [*starter.glob(pattern)]
        assert found, pattern
        hidden.update(found)
    suites = {f"tests/{suite}.py" for suite in SUITES.values()}
    handouts = {function.file for function in FUNCTIONS.values()}
    for name in handouts | suites | {"README.md", "ASSIGNMENT.md", "support/constants.py"}:
        path = starter / name
        assert hidden.isdisjoint([path, *path.parents])
        assert "handout" not in path.read_text(encoding="utf-8").lower(), name


def test_a_student_meets_no_reference_to_a_file_or_module_that_is_not_there(made):
    for file in made.rglob("*.*"):
        if file.suffix not in (".py", ".md", ".toml", ".html", ".json"):
            continue
        text = file.read_text(encoding="utf-8")
        assert file.suffix != ".md" or "../" not in text
        for path in re.findall(r"\b(?:src|support|tests)/[\w/]+\.\w+", text):
            assert (made / path).exists() or "make_starter" in path, file
        for module in re.findall(r"\b(?:src|support)(?:\.\w+)+", text):
            path = made.joinpath(*module.split("."))
            # A folder, a file, or a name in a file
            places = (path, path.with_suffix(".py"), path.parent.with_suffix(".py"))
            assert any(place.exists() for place in places), module


def test_the_workflow_for_github_has_the_lines_of_the_readme_and_the_base_of_the_image(made):
    workflow = (made / ".github" / "workflows" / "classroom.yml").read_text()
    lines = workflow.partition("run: |\n")[2].splitlines()
    readme = (made / "README.md").read_text()
    installs = re.findall(r"^    (.*\.venv/bin/pip .*)$", readme, re.MULTILINE)
    assert [line.strip() for line in lines] == [*installs, ".venv/bin/pytest"]
    base = re.search("container: (.+)", workflow)[1]
    assert f"/{base}\n" in (ROOT / "tests" / "teacher" / "Containerfile").read_text()
