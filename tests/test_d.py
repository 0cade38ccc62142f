"""D checks: from the CSV to a pend_list, and from there to pendula that can be seen."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from vpython import box, color, cylinder, sphere, textures, vector

from grading.cradles import MIXED, MIXED_CSV, R
from grading.grader import check, expect, same, working_in
from grading.telling import Wanted
from support.constants import NC_FP
from support.files.cradle_csv import read_cells
from support.pendulum import make_pendulum

# Equal rows, values of 0, e of 0 and 1, many digits, more rows than columns, and no line break at the end.
SEVEN_CSV = """\
mass,e,theta,omega,color,texture
12.625,1.0,0.4375,0.0,white,none
0.25,0.0,0.0,0.0,red,rug
0.25,0.0,0.0,0.0,red,rug
2.0,0.5,-0.125,3.5,green,none
7.0,0.0625,0.0,0.0,blue,stucco
1.0,1.0,0.0,-0.5,purple,wood_old
3.0,0.9375,1.5,0.0,black,metal"""
SEVEN = [
    {"mass": 12.625, "e": 1.0, "theta": 0.4375, "omega": 0.0, "color": "white", "texture": "none"},
    {"mass": 0.25, "e": 0.0, "theta": 0.0, "omega": 0.0, "color": "red", "texture": "rug"},
    {"mass": 0.25, "e": 0.0, "theta": 0.0, "omega": 0.0, "color": "red", "texture": "rug"},
    {"mass": 2.0, "e": 0.5, "theta": -0.125, "omega": 3.5, "color": "green", "texture": "none"},
    {"mass": 7.0, "e": 0.0625, "theta": 0.0, "omega": 0.0, "color": "blue", "texture": "stucco"},
    {"mass": 1.0, "e": 1.0, "theta": 0.0, "omega": -0.5, "color": "purple", "texture": "wood_old"},
    {"mass": 3.0, "e": 0.9375, "theta": 1.5, "omega": 0.0, "color": "black", "texture": "metal"},
]

FILES = {
    "mixed.csv": MIXED_CSV,
    "seven.csv": SEVEN_CSV,
    "one.csv": "mass,e,theta,omega,color,texture\n3.0,0.5,0.1,0.2,green,rug\n",
    "two.csv": "mass,e,theta,omega,color,texture\n3.0,0.5,0.1,0.2,green,rug\n4.0,0.5,0.1,0.2,green,rug\n",
    "assistants.csv": "name,year,house\nAda,2,Page\nGrace,4,Lloyd\n",
}
ONE = {"mass": 3.0, "e": 0.5, "theta": 0.1, "omega": 0.2, "color": "green", "texture": "rug"}
ASSISTANTS = [{"name": "Ada", "year": 2, "house": "Page"}, {"name": "Grace", "year": 4, "house": "Lloyd"}]


@contextmanager
def files() -> Iterator[Path]:
    """Yield a folder with these files. On Windows it stays behind if a solution has left one of them open."""
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        for name, text in FILES.items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        yield Path(folder)


def is_shipped(came):
    """Return whether what came of one of these files has as many pendula as the shipped one."""
    return isinstance(came, list) and len(came) == len(read_cells(NC_FP)) - 1 not in (1, 3)


def values_of(first, key):
    """Return a function that returns the values of this key in a first pend_list, and in the one that it is given."""
    return lambda last: ([pend[key] for pend in first], [pend[key] for pend in last])


OTHER_FILE = (is_shipped, "Do you read the file at relative_filepath, or another one?")


# --- extract_and_convert ---------------------------------------------------------------------------------------------

ROWS = [
    (MIXED[:1], "This is the first pendulum alone: is there a return inside the loop?"),
    (MIXED[:-1], "The last pendulum is missing."),
    (MIXED[1:], "The first pendulum is missing."),
    (MIXED[::-1], "The pendula are in the reverse order."),
    (MIXED[-1:], "This is the last pendulum alone: is the list made inside the loop?"),
    ([MIXED[-1]] * 3, "This is the last pendulum again and again."),
    ([list(pendulum) for pendulum in MIXED], "These are the keys alone, without their values."),
    ([list(pendulum.values()) for pendulum in MIXED], "These are the values alone, without their keys."),
    ([0, 1, 2], "These are the keys of bad_rep; the pendula are its values."),
    (list(enumerate(MIXED)), "These are the keys of bad_rep together with its values; the values alone are needed."),
    ([{i: pendulum} for i, pendulum in enumerate(MIXED)], "Each pendulum still has its number of bad_rep as a key."),
    ([dict(enumerate(MIXED))], "This is bad_rep, in a list; the values of bad_rep are what is needed."),
    ([MIXED], "This is the right list inside another list."),
    (lambda came: len(came) > 3 and came[0] == came[1], "The same pendulum is there more than once."),
    OTHER_FILE,
    ([], "This is an empty list: does the loop append to it, and is the list made before the loop?"),
]


@check("extract_and_convert")
def test_pend_list_is_a_list_of_dictionaries():
    """In the list of dictionaries representation, each pendulum is represented by a dictionary in a list called
    pend_list.
    """
    kind = Wanted(
        "a list with 3 dictionaries",
        lambda came: isinstance(came, list) and len(came) == 3 and all(isinstance(pend, dict) for pend in came),
    )
    hints = [
        (
            dict(enumerate(MIXED)),
            "This is bad_rep itself, whose keys only count the pendula; a list does without them.",
        ),
        (tuple(MIXED), "This is a tuple; a list is needed."),
        (lambda came: type(came).__name__ == "dict_values", "These are the values of bad_rep, but not yet a list."),
        (lambda came: type(came).__name__ == "DataFrame", "This is the dataframe df itself."),
    ]
    with files() as folder:
        expect("extract_and_convert", str(folder / "mixed.csv"), gives=kind, hints=[*hints, *ROWS])


@check("extract_and_convert")
def test_a_row_is_a_pendulum():
    """Each key is the name of a pendulum attribute and the value of a key is the value associated with that
    attribute.
    """
    with files() as folder:
        expect("extract_and_convert", str(folder / "mixed.csv"), gives=MIXED, hints=ROWS)
        expect("extract_and_convert", str(folder / "seven.csv"), gives=SEVEN)


@check("extract_and_convert")
def test_the_file_given_is_read():
    """Creates and returns the list of pendulum dictionaries pend_list with the provided relative_filepath to a CSV file
    representing a Newton's Cradle.
    """
    with files() as folder, working_in(folder):
        first = expect("extract_and_convert", "one.csv", gives=[ONE], hints=[OTHER_FILE])
        (folder / "one.csv").write_text(FILES["two.csv"])
        what = "each mass of the file as it was, and as it is"
        expect("extract_and_convert", "one.csv", gives=([3.0], [3.0, 4.0]), see=values_of(first, "mass"), what=what)


@check("extract_and_convert")
def test_any_csv_is_converted():
    """The very first line in a CSV file contains the names of each attribute."""
    with files() as folder:
        expect("extract_and_convert", str(folder / "assistants.csv"), gives=ASSISTANTS)


# --- uniform_mass, uniform_e, elastic and inelastic ------------------------------------------------------------------


def uniform(rows, **changed):
    """Return these rows, each with the changed value."""
    return [{**row, **changed} for row in rows]


def check_uniform(function, *arguments, also=(), **changed):
    """Check that all pendula of two files get the changed value, and keep their others; also are more hints."""
    ((key, value),) = changed.items()
    right = uniform(MIXED, **changed)
    hints = [
        *also,
        (MIXED, f"These are the file's values: {key} has not changed."),
        ([right[0], *MIXED[1:]], f"Only the first pendulum has got its {key}."),
        ([*MIXED[:-1], right[-1]], f"Only the last pendulum has got its {key}."),
        (right[0], "This is the first pendulum alone; the whole pend_list is needed."),
        (right[-1], "This is the last pendulum alone; the whole pend_list is needed."),
        (right[:1], "This is the first pendulum alone; the whole pend_list is needed."),
        (uniform(MIXED, **{key: str(value)}), f"{key} is text here; a number is needed."),
        OTHER_FILE,
    ]
    with files() as folder, working_in(folder):
        first = expect(function, "mixed.csv", *arguments, gives=right, hints=hints)
        expect(function, "seven.csv", *arguments, gives=uniform(SEVEN, **changed))
        what = f"each {key} of the first call, and of this one"
        both = {"see": values_of(first, key), "what": what, "gives": ([value] * 3, [value])}
        hints = [(lambda came: OTHER_FILE[0](came[1]), OTHER_FILE[1])]
        expect(function, "one.csv", *arguments, **both, hints=hints)


@check("uniform_mass_newton_cradle")
def test_uniform_mass():
    """Returns a pend_list corresponding to the pendulums in a CSV file located at relative_filepath using a helper
    function from pds_helper.py, such that all the pendulum's mass values are assigned the value mass.
    """
    also = [(uniform(MIXED, e=12.125), "It is e that has changed here, not mass.")]
    check_uniform("uniform_mass_newton_cradle", 12.125, mass=12.125, also=also)
    check_uniform("uniform_mass_newton_cradle", 0.5, mass=0.5)


@check("uniform_e_newton_cradle")
def test_uniform_e():
    """Returns a pend_list corresponding to the pendulums in a CSV file located at relative_filepath using a helper
    function from pds_helper.py, such that all the pendulum's coefficients of restitution are assigned a provided e
    value.
    """
    also = [(uniform(MIXED, mass=0.0625), "It is mass that has changed here, not e.")]
    check_uniform("uniform_e_newton_cradle", 0.0625, e=0.0625, also=also)
    check_uniform("uniform_e_newton_cradle", 0, e=0)
    check_uniform("uniform_e_newton_cradle", 1, e=1)


def is_number_for_a_file(came):
    """Return whether this is the error of one who was given a number where the path of a file must be."""
    return isinstance(came, Exception) and re.search(r"\b(int|float)\b", str(came))


NUMBER_FOR_A_FILE = (is_number_for_a_file, "uniform_e_newton_cradle takes relative_filepath first, and then e_val.")


@check("elastic_newton_cradle")
def test_elastic():
    """Returns a pend_list such that each pendulum has a perfectly elastic restitution coefficient value."""
    also = [(uniform(MIXED, e=0), "This is perfectly inelastic."), NUMBER_FOR_A_FILE]
    check_uniform("elastic_newton_cradle", e=1, also=also)


@check("inelastic_newton_cradle")
def test_inelastic():
    """Returns a pend_list such that each pendulum has a perfectly inelastic restitution coefficient value."""
    also = [(uniform(MIXED, e=1), "This is perfectly elastic."), NUMBER_FOR_A_FILE]
    check_uniform("inelastic_newton_cradle", e=0, also=also)


# --- make_newton_cradle ----------------------------------------------------------------------------------------------


def check_cradle(see, what, gives, file="mixed.csv", r_param=R, theta_init=0.6, hints=()):
    """Check what see takes out of each pendulum of the cradle that is made of a file."""
    ready = []

    def see_all(pend_list):
        ready[:] = ["objects" in pend for pend in pend_list]
        return [see(pend) for pend in pend_list]

    def is_first_alone(_):
        return ready[:1] == [True] and len(ready) > 1 and not any(ready[1:])

    hints = [(is_first_alone, "Only the first pendulum is ready: is there a return inside the loop?"), *hints]
    with files() as folder, working_in(folder):
        expect("make_newton_cradle", file, r_param, theta_init, gives=gives, see=see_all, what=what, hints=hints)


@check("make_newton_cradle")
def test_a_cradle_keeps_the_files_values():
    """Creates the list of pendulum dictionaries pend_list, using a helper function from pds_helper.py, with the unique
    relative_filepath.
    """

    def kept(pend):
        return {key: pend[key] for key in ("mass", "e", "color", "texture")}

    what = "mass, e, color and texture of each pendulum"
    check_cradle(kept, what, [kept(row) for row in MIXED])
    check_cradle(kept, what, [kept(ONE)], file="one.csv", hints=[OTHER_FILE])
    check_cradle(kept, what, [kept(row) for row in SEVEN], file="seven.csv")


@check("make_newton_cradle")
def test_the_first_pendulum_is_lifted():
    """theta: the angle of the pendulum with respect to normal (perpendicular to the axle). It should be theta_init for
    the first pendulum, and 0 for all the others.
    """
    hints = [
        ([row["theta"] for row in MIXED], "These are the angles of the file."),
        ([0.6, 0.6, 0.6], "All pendula are lifted; only the first one must be."),
        ([0.6, *(row["theta"] for row in MIXED[1:])], "All but the first one still have the angle of the file."),
        ([0, 0, 0.6], "The last pendulum is lifted; the first one must be."),
        ([0, 0.6, 0.6], "All but the first one are lifted; it is the other way round."),
        ([0, 0.6, 0], "The second pendulum is lifted: a list counts from 0."),
        ([0, 0, 0], "The first pendulum is not lifted."),
    ]
    check_cradle(lambda pend: pend["theta"], "theta of each pendulum", [0.6, 0, 0], hints=hints)
    for file, count, theta_init in [
        ("one.csv", 1, -0.3),
        ("mixed.csv", 3, 2.0),
        ("seven.csv", 7, -2.0),
        ("seven.csv", 7, 0),
    ]:
        gives = [theta_init, *[0] * (count - 1)]
        check_cradle(lambda pend: pend["theta"], "theta of each pendulum", gives, file=file, theta_init=theta_init)


@check("make_newton_cradle")
def test_all_pendula_start_at_rest():
    """omega: the angular velocity, which should be 0 for all the pendula."""
    hints = [
        ([row["omega"] for row in MIXED], "These are the angular velocities of the file."),
        ([0.6, 0, 0], "theta and omega are mixed up."),
    ]
    check_cradle(lambda pend: pend["omega"], "omega of each pendulum", [0, 0, 0], hints=hints)


@check("make_newton_cradle")
def test_objects_are_axle_bob_and_cord():
    """objects: a tuple of (axle, bob, and cord) VPython object that are the parts of the pendulum."""

    def is_one(came):
        return all(
            isinstance(objects, tuple)
            and len(objects) == 3
            and all(map(isinstance, objects, (box, sphere, cylinder)))
            and all(part.visible for part in objects)
            for objects in came
        )

    def are_lists(came):
        return all(isinstance(objects, list) for objects in came)

    hints = [(are_lists, "These are lists; tuples are needed, as the helper function returns them.")]
    what = "objects of each pendulum"
    check_cradle(lambda pend: pend["objects"], what, Wanted("a tuple of axle, bob and cord each", is_one), hints=hints)


@check("make_newton_cradle", watched=True)
def test_axle_positions():
    """The axle position of the ith pendulum can be defined as axle_pos = vector((-0.1+r_param/4 * i), r_param/5, 0)."""
    # r_param, and by hand how far the axles are apart, and how high (m).
    for r_param, apart, height in ((0.3, 0.075, 0.06), (1.0, 0.25, 0.2)):

        def places(left, apart, height):
            return [vector(left + apart * i, height, 0) for i in range(3)]

        right = -0.1, apart, height
        hints = [
            (
                lambda came: same(came, [came[0]] * 3),
                "All axles are in one place: does i count the pendula, and is r_param/4 not rounded?",
            ),
            (places(-0.1 + apart, *right[1:]), "This counts the pendula from 1; i counts from 0."),
            (places(0, *right[1:]), "The -0.1 is missing."),
            (places(0.1, *right[1:]), "The sign of the 0.1 is wrong."),
            (places(0, -0.1 + apart, height), "The brackets are wrong: i multiplies r_param/4 only."),
            (places(-0.1, apart, 0), "The height of the axles, r_param/5, is missing."),
            (places(-0.1, apart, -height), "The axles are below instead of above: y has the wrong sign."),
            (places(-0.1, height, apart), "The r_param/4 and the r_param/5 are mixed up."),
            (places(-0.1, -apart, height), "The pendula go to the left; they must go to the right."),
        ]
        what = "position of each axle"
        check_cradle(lambda pend: pend["objects"][0].pos, what, places(*right), r_param=r_param, hints=hints)
    seven = [vector(x, 0.08, 0) for x in (-0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5)]  # R is 0.4 m
    check_cradle(lambda pend: pend["objects"][0].pos, "position of each axle", seven, file="seven.csv")


@check("make_newton_cradle", watched=True)
def test_bobs_hang_from_their_axles():
    """Use one relevant helper function from pendulum.py in support/ to create the tuple of objects, which will be the
    value of the key objects.
    """

    def bobs(thetas, r_param=R):
        made = [make_pendulum(vector(0, 0, 0), r_param, theta, vector(1, 1, 1), None)[1] for theta in thetas]
        return [(bob.pos, bob.radius) for bob in made]

    def seen(pend):
        axle, bob, _ = pend["objects"]
        return bob.pos - axle.pos, bob.radius

    swapped = [make_pendulum(vector(0, 0, 0), theta, R, vector(1, 1, 1), None)[1] for theta in (0.6, 0, 0)]
    hints = [
        ([(bob.pos, bob.radius) for bob in swapped], "make_pendulum takes r_param first, and then theta."),
        (bobs([0, 0, 0]), "The first bob hangs straight down: the helper function takes the angle, too."),
        (bobs([0.6, 0.6, 0.6]), "All bobs are lifted, whatever the theta of their pendulum is."),
        (bobs([row["theta"] for row in MIXED]), "The bobs are at the angles of the file, not at those of the cradle."),
        (lambda came: came[1][1] != bobs([0])[0][1], "Is r_param handed on to the helper function as it is?"),
    ]
    what = "where each bob is, seen from its axle, and its radius (m)"
    check_cradle(seen, what, bobs([0.6, 0, 0]), hints=hints)
    check_cradle(seen, what, bobs([-0.3, 0, 0], 1.0), r_param=1.0, theta_init=-0.3)


@check("make_newton_cradle")
def test_bobs_have_the_color_and_texture_of_their_row():
    """Use COLOR_MAP and TEXTURE_MAP to find the VPython analog color and texture objects."""

    def seen(pend):
        return pend["objects"][1].color, pend["objects"][1].texture

    first, _, last = mixed = [(color.red, textures.metal), (color.blue, None), (color.yellow, textures.wood)]
    red, black = (color.red, textures.rug), (color.black, textures.metal)
    others = [(color.green, None), (color.blue, textures.stucco), (color.purple, textures.wood_old)]
    hints = [
        ([first] * 3, "All bobs have the looks of the first row."),
        ([last] * 3, "All bobs have the looks of the last row."),
        ([(of, None) for of, _ in mixed], "The textures are missing."),
        (lambda came: came[0][1] == "metal", "These are the textures' names; TEXTURE_MAP has what they stand for."),
    ]
    check_cradle(seen, "color and texture of each bob", mixed, hints=hints)
    seven = [(color.white, None), red, red, *others, black]
    check_cradle(seen, "color and texture of each bob", seven, file="seven.csv")


@check("make_newton_cradle")
def test_the_pend_list_is_returned():
    """Return the updated pend_list."""
    is_list = Wanted("a list with 3 dictionaries", lambda came: isinstance(came, list) and len(came) == 3)
    hints = [(lambda came: isinstance(came, dict), "This is one pendulum; the whole list is needed.")]
    with files() as folder, working_in(folder):
        first = expect("make_newton_cradle", "mixed.csv", R, 0.6, gives=is_list, hints=hints)
        what = "theta of the first pendulum, in the cradle that was made before this one, and in this one"
        thetas = {"see": lambda second: (first[0]["theta"], second[0]["theta"]), "what": what, "gives": (0.6, -0.3)}
        expect("make_newton_cradle", "mixed.csv", R, -0.3, **thetas)
