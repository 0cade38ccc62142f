"""Each experiment explains what really happens: theory and the measurement agree."""

import re
from itertools import combinations
from math import sqrt
from pathlib import Path

import numpy as np
import pytest
from programs import copy_project, OF_TESTS, python, slow_except
from students import put_files
from whole_cradles import PERIOD, Swing

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.settings import settings_of
from support.files.experiments import EXPERIMENTS, read_experiment, read_experiments
from support.page.prediction import Measurement

KINDS = Cradle, DoubleCradle
TICK = Cradle.dt / PERIOD  # in small swings


def measured(experiment, kind):
    """Measure this experiment."""
    player = Swing(kind(), settings_of(experiment))
    measurement = Measurement(experiment, player.motion)
    while not measurement.is_over:
        player.swing(max(1, round(PERIOD / 1000 / kind.dt)))
        measurement.measure()
    return measurement


def check_theory(found, experiment):
    """Compare a measured experiment of the single cradle with theory.

    A bob at the angle a, at rest, has at the bottom v = sqrt(2 g R (1 - cos(a))), which is 2 sqrt(g
    R) sin(a / 2). Together, the hits keep the momentum.
    """
    fastest = 2 * sqrt(G * R_PARAM)  # m/s
    befores = -fastest * np.sin(np.ravel(experiment.poses) / 2)
    afters = fastest * np.sin(np.radians(found.swings) / 2)
    masses = np.array(found.cradle.values("mass"))
    nearly = (0.008 + 12 * TICK) * max(abs(befores))  # m/s
    assert found.befores == pytest.approx(abs(befores), abs=nearly)
    assert found.speeds == pytest.approx(abs(afters), abs=nearly)
    assert masses @ afters == pytest.approx(masses @ befores, abs=nearly * sum(masses))
    energy = 100 * masses @ afters**2 / (masses @ befores**2)  # %
    assert found.energy == pytest.approx(energy, abs=0.5)


def check_this_world():
    """Check what each shipped experiment explains, at the constants of this process."""
    for kind in KINDS:
        experiments, mistakes = read_experiments(EXPERIMENTS / kind.kind, kind.cord_count)
        assert mistakes == []
        for experiment in experiments.values():
            if experiment.hidden:
                continue
            found = measured(experiment, kind)
            assert found.outcome() == experiment.explained, (experiment.stem, found.swings)
            assert "{" not in found.explanation()
            for answer, other in combinations(experiment.answers, 2):
                assert answer.swings != pytest.approx(other.swings, abs=5), experiment.stem
            right = experiment.answers[experiment.explained]
            assert found.swings == pytest.approx(right.swings, abs=3), experiment.stem
            if kind is Cradle:
                check_theory(found, experiment)


# Changed constants: R_PARAM (m), G (m/s^2), DT (s), DOUBLE_DT (s)
WORLDS = {
    "a short cord, and fast": "0.05 25.0 0.0005 0.0005",
    "the Moon, slow": "0.2 1.62 0.001 0.001",
    "the shipped one": "0.2 9.81 0.0001 0.00025",
}


@pytest.mark.parametrize("world", slow_except(["a short cord, and fast"], WORLDS))
def test_an_experiment_is_right_with_any_cord_gravity_and_tick(world, tmp_path):
    numbers = WORLDS[world].split()
    file = copy_project(tmp_path, "") / "support" / "constants.py"
    text = file.read_text()
    for name, number in zip(("R_PARAM", "G", "DT", "DOUBLE_DT"), numbers, strict=True):
        text = re.sub(rf"(?m)^{name} = .*", f"{name} = {number}", text)
    file.write_text(text)
    (tmp_path / "in_this_world.py").write_text(Path(__file__).read_text())
    check = "import support.headless_vpython, src.double_cradle, in_this_world as it"
    done = python("-c", f"{check}; it.check_this_world()", folder=tmp_path, **OF_TESTS)
    assert done.returncode == 0, done.stderr


SHORT = """\
name = "Short"
theta = {}
e = [0, 0]
question = "What happens?"
right = "{}"
why = "They stop."

[answers]
"All stop" = [0, 0]
"All go on" = [45, 45]
"""


OTHER = (
    r"After the hits, the bobs swung to -?0, -?0 degrees\. The experiment expects: All go on\..*"
)


@pytest.mark.parametrize(
    ("theta", "right", "explanation", "swings"),
    [
        ([-45, 45], "B", OTHER, 0.5),  # nothing moves any more
        ([0, 0], "A", r"In 2\.69 s, no hit was seen\.", 3),
    ],
)
def test_a_measurement_ends_in_any_case_and_says_what_was_not_expected(
    tmp_path, theta, right, explanation, swings
):
    folder = put_files(tmp_path, {"short.toml": SHORT.format(theta, right)})
    found = measured(read_experiment(folder / "short.toml", 1), Cradle)
    assert re.fullmatch(explanation, found.explanation())
    assert found.end / PERIOD < swings + 0.1
