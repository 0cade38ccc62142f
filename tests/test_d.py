"""D tests: from the CSV to a pend_list, and from there to pendula that can be seen."""

import pytest
from cradles import components, MIXED, MIXED_CSV, R
from vpython import box, cylinder, sphere, vector

from src import pds_helper, special_cradles
from support.constants import COLOR_MAP, TEXTURE_MAP
from support.pendulum import make_pendulum


@pytest.fixture
def mixed_csv(tmp_path):
    file = tmp_path / "mixed.csv"
    file.write_text(MIXED_CSV)
    return str(file)


# --- extract_and_convert ---------------------------------------------------------------------------------------------


def test_pend_list_is_a_list_of_dictionaries(mixed_csv):
    """extract_and_convert creates and returns the list of pendulum dictionaries pend_list."""
    pend_list = pds_helper.extract_and_convert(mixed_csv)
    assert isinstance(pend_list, list)
    assert [type(pend_dict) for pend_dict in pend_list] == [dict] * 3


def test_a_row_is_a_pendulum(mixed_csv):
    """Each key is the name of a pendulum attribute and the value of a key is the value of that attribute."""
    assert pds_helper.extract_and_convert(mixed_csv) == MIXED


def test_the_file_given_is_read(mixed_csv, tmp_path, monkeypatch):
    """extract_and_convert takes the relative_filepath to a CSV file."""
    (tmp_path / "one.csv").write_text("mass,e,theta,omega,color,texture\n3.0,0.5,0.1,0.2,green,rug\n")
    monkeypatch.chdir(tmp_path)
    one = {"mass": 3.0, "e": 0.5, "theta": 0.1, "omega": 0.2, "color": "green", "texture": "rug"}
    assert pds_helper.extract_and_convert("one.csv") == [one]


def test_any_csv_is_converted(tmp_path):
    """The very first line in a CSV file contains the names of each attribute; each other line is a data point."""
    file = tmp_path / "tas.csv"
    file.write_text("name,year,house\nAda,2,Page\nGrace,4,Lloyd\n")
    assert pds_helper.extract_and_convert(str(file)) == [
        {"name": "Ada", "year": 2, "house": "Page"},
        {"name": "Grace", "year": 4, "house": "Lloyd"},
    ]


# --- uniform_mass, uniform_e, elastic and inelastic ------------------------------------------------------------------

UNIFORM = [
    ("uniform_mass_newton_cradle", (7.5,), {"mass": 7.5}),
    ("uniform_mass_newton_cradle", (2,), {"mass": 2}),
    ("uniform_e_newton_cradle", (0.25,), {"e": 0.25}),
    ("uniform_e_newton_cradle", (0,), {"e": 0}),
    ("elastic_newton_cradle", (), {"e": 1}),
    ("inelastic_newton_cradle", (), {"e": 0}),
]


@pytest.mark.parametrize(("name", "arguments", "changed"), UNIFORM)
def test_uniform_cradles(name, arguments, changed, mixed_csv):
    """All the pendula of the CSV file at relative_filepath get the value; their other values are the file's."""
    pend_list = getattr(special_cradles, name)(mixed_csv, *arguments)
    assert pend_list == [{**pend_dict, **changed} for pend_dict in MIXED]


@pytest.mark.parametrize(("name", "arguments", "changed"), UNIFORM)
def test_uniform_cradles_leave_the_file(name, arguments, changed, mixed_csv):
    """Functions that make a cradle read the file, they do not write it."""
    getattr(special_cradles, name)(mixed_csv, *arguments)
    with open(mixed_csv) as file:
        assert file.read() == MIXED_CSV


# --- make_newton_cradle ----------------------------------------------------------------------------------------------


@pytest.fixture
def cradle(mixed_csv):
    return special_cradles.make_newton_cradle(mixed_csv, R, 0.6)


def test_cradle_keeps_the_files_values(cradle):
    """make_newton_cradle creates pend_list with the unique relative_filepath; what it does not set is the file's."""
    kept = ("mass", "e", "color", "texture")
    assert [{name: pend_dict[name] for name in kept} for pend_dict in cradle] == [
        {name: pend_dict[name] for name in kept} for pend_dict in MIXED
    ]


def test_theta_is_theta_init_for_the_first_pendulum_and_0_for_the_others(cradle):
    """theta should be theta_init for the first pendulum, and 0 for all the others."""
    assert [pend_dict["theta"] for pend_dict in cradle] == pytest.approx([0.6, 0, 0])


def test_omega_is_0_for_all_pendula(cradle):
    """omega: the angular velocity, which should be 0 for all the pendula."""
    assert [pend_dict["omega"] for pend_dict in cradle] == [0, 0, 0]


def test_objects_is_a_tuple_of_axle_bob_and_cord(cradle):
    """objects: a tuple of (axle, bob, and cord) VPython objects that are the parts of the pendulum."""
    assert [type(pend_dict["objects"]) for pend_dict in cradle] == [tuple] * 3
    assert [tuple(map(type, pend_dict["objects"])) for pend_dict in cradle] == [(box, sphere, cylinder)] * 3


@pytest.mark.parametrize("r_param", [0.1, 0.2, 0.4])
def test_axle_positions(r_param, mixed_csv):
    """The axle position of the ith pendulum is vector((-0.1+r_param/4 * i), r_param/5, 0)."""
    cradle = special_cradles.make_newton_cradle(mixed_csv, r_param, 0.6)
    for i, pend_dict in enumerate(cradle):
        assert components(pend_dict["objects"][0].pos) == pytest.approx((-0.1 + r_param / 4 * i, r_param / 5, 0))


def test_objects_are_those_of_the_helper_in_pendulum_py(cradle):
    """Use one relevant helper function from pendulum.py, with the cradle's r_param and the pendulum's theta."""
    for pend_dict, theta in zip(cradle, (0.6, 0, 0), strict=True):
        axle, bob, cord = pend_dict["objects"]
        expected = make_pendulum(axle.pos, R, theta, vector(1, 1, 1), None)
        assert components(bob.pos) == pytest.approx(components(expected[1].pos))
        assert components(cord.axis) == pytest.approx(components(expected[2].axis))
        assert bob.radius == pytest.approx(expected[1].radius)


def test_bobs_have_the_color_and_texture_of_their_row(cradle):
    """Use COLOR_MAP and TEXTURE_MAP to find the VPython analog color and texture objects."""
    for pend_dict, values in zip(cradle, MIXED, strict=True):
        bob = pend_dict["objects"][1]
        assert components(bob.color) == components(COLOR_MAP[values["color"]])
        assert bob.texture == TEXTURE_MAP[values["texture"]]


def test_each_call_makes_a_cradle_of_its_own(mixed_csv):
    """make_newton_cradle creates the list; a cradle made before stays as it was."""
    first = special_cradles.make_newton_cradle(mixed_csv, R, 0.6)
    second = special_cradles.make_newton_cradle(mixed_csv, R, -0.3)
    assert [pend_dict["theta"] for pend_dict in first] == pytest.approx([0.6, 0, 0])
    assert [pend_dict["theta"] for pend_dict in second] == pytest.approx([-0.3, 0, 0])
    assert first[0]["objects"][1] is not second[0]["objects"][1]
