"""What students are handed: made, and graded as it is and with solutions."""

import ast
import re

from make_starter import is_left_out
from programs import python, ROOT
from students import COUNTS, graded_in, write

from grading.assignment import FUNCTIONS, IMPORTS, PROGRAM
from grading.given import definitions

HANDOUTS = {function.file for function in FUNCTIONS.values()}


def test_a_starter_is_made_all_waits_and_with_the_solutions_all_is_green(tmp_path):
    folder = tmp_path / "starter"
    program = ROOT / "tests" / "make_starter.py"
    done = python(program, folder, folder=tmp_path, PYTHONSAFEPATH="1", PYTHONWARNINGS="error")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"{folder} is ready")

    tiers = graded_in(folder)["tiers"]
    assert {tier: counts["waiting"] for tier, counts in tiers.items()} == COUNTS

    write(folder, *FUNCTIONS)
    assert graded_in(folder)["grade"] == "Honor roll"


def test_each_function_has_the_handouts_signature_a_docstring_and_its_place(made):
    for name in FUNCTIONS.keys() - {PROGRAM}:
        function = FUNCTIONS[name]
        (node,) = definitions(made / function.file, name)
        assert ", ".join(arg.arg for arg in node.args.args) == function.parameters
        assert ast.get_docstring(node)


def test_the_lines_of_the_handout_are_there_as_it_has_them(made):
    read = "    df = pd.read_csv(relative_filepath)\n    bad_rep = df.to_dict(orient='index')\n"
    begin = "if __name__ == '__main__':\n    import begin_page\n\nfrom"
    for name, lines in {"pds_helper": read, "visualize_cradle_run": begin}.items():
        assert lines in (made / "src" / f"{name}.py").read_text().replace('"', "'")


def test_the_triangle_on_the_constants_makes_no_error(made):
    assert python("support/constants.py", folder=made, PYTHONPATH="").stderr == ""


def test_the_page_and_the_grader_are_whole(made):
    """Without the fast path, which has answers."""
    assert not [*made.rglob("many_ticks.py")]
    for file in [*made.glob("support/**/*.py"), *made.glob("tests/grading/*.py")]:
        assert file.read_bytes() == (ROOT / file.relative_to(made)).read_bytes()


def test_the_imports_of_the_handout_stay_and_those_of_our_own_helpers_fall(made):
    helpers = {"pairwise", "Sequence", "State", "rates", "moved", "collide_pairs", "keep_apart"}
    for file in HANDOUTS:
        names = {*compile((made / file).read_bytes(), file, "exec").co_names}
        assert names >= {*IMPORTS[file].split()}
        assert not names & helpers


def test_a_student_meets_no_name_that_is_not_there(made):
    """Only pend_list, which the student makes."""
    options = ["--isolated", "--no-cache", "--select", "F", "--ignore", "F401,F841"]
    options += ["--config", "builtins = ['pend_list']"]
    done = python("-m", "ruff", "check", *options, "src", folder=made)
    assert done.returncode == 0, done.stdout


def test_a_file_or_a_folder_whose_name_begins_with_a_dot_is_left_out():
    """On a disk of another system, a Mac adds such a file to each file.

    Jupyter keeps whole solutions in such a folder.
    """
    assert all(map(is_left_out, ("._swinging.py", ".ipynb_checkpoints")))


# A student's functions that a file may call: the programs need it, or the handout itself does it.
CALLED = {
    "swinging.py": ["angle_update"],  # by swing_update, which the handout provides
    "double_cradle.py": ["make_newton_cradle", "make_double_pendulum", "double_angle_update"],
    "cradle.py": ["extract_and_convert", "uniform_mass_newton_cradle"],
    "pds_tester.py": ["extract_and_convert"],
}
ANSWERS = {  # patterns of code
    "the places of the axles": r"-?0\.1 \+ .*/ 4|/ 4 \* i\b",
    "the looks of a row": r"(COLOR|TEXTURE)_MAP\[.*(color|texture)",
    "whether bobs touch": r"[<>].* (1\.05|BUFFER) \* \(\w+\.radius \+ \w+\.radius\)",
    "the formula of a collision": r"\be \* \((v|omega)1 - (v|omega)2\)|\* e \* \(",
    "the formula of gravity": r"\bg \* sin\(theta\)",
    "the formula of the swing": r"theta \+ omega\w* \* dt",
    "the lower cord": r"\barm\(theta \+ phi\)|, theta \+ phi,",
    "a loop that swings": r"\bfor \w+ in .*\n?.*\b(swing|angle)_update\(",
}


def answers_below(folder) -> set[str]:
    """Return what a student could write off from the Python files below a folder."""
    answers = set()
    for file in folder.rglob("*.py"):
        code = ast.unparse(ast.parse(file.read_text(encoding="utf-8")))  # each statement in a line
        called = re.findall(r"(?<!def )\b(\w+)\((?!\))", code)
        for function in FUNCTIONS.keys() & {*called} - {*CALLED.get(file.name, [])}:
            answers.add(f"a call of {function}")
        for answer, pattern in ANSWERS.items():
            if re.search(pattern, code):
                answers.add(answer)
    return answers


def test_the_folder_has_no_answers(made):
    """The project itself has answers of each kind: the patterns fit its lines."""
    assert answers_below(made) == set()
    calls = {"a call of handle_two_bobs", "a call of newton_cradle_tick"}
    assert calls | ANSWERS.keys() <= answers_below(ROOT / "src")
