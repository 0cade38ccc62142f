"""D checks: a CSV becomes a pend_list, and its pendula get VPython objects."""

from pathlib import Path

import grading.begin

from vpython import box, color, cylinder, sphere, textures, vector

from grading.checks import check
from grading.cradles import csv_of, ends_like, LEFT_OVER, left_over, MIXED, R, shapes
from grading.csv_files import COLORS_AND_TEXTURES, FILES, files, FIVE, MANY, ONE
from grading.grader import expect
from grading.messages import Expected
from grading.subject import Each, Several, Subject
from support.pendulum import arm, make_pendulum

STEPS = {
    "extract_and_convert": "read_csv gives df, to_dict gives bad_rep, and pend_list gets each "
    "value of bad_rep. Return pend_list.",
    "uniform_mass_newton_cradle": "pend_list comes from extract_and_convert; each pendulum gets "
    "the new mass; pend_list is returned.",
    "uniform_e_newton_cradle": "pend_list comes from extract_and_convert; each pendulum gets the "
    "new e; pend_list is returned.",
    "elastic_newton_cradle": "uniform_e_newton_cradle makes the pend_list, with the e of an "
    "elastic collision; pend_list is returned.",
    "inelastic_newton_cradle": "uniform_e_newton_cradle makes the pend_list, with the e of an "
    "inelastic collision; pend_list is returned.",
    "make_newton_cradle": "for each pendulum: theta, omega, axle_pos, color, texture, and objects "
    "(from make_pendulum).",
}


THREE = [Expected("a dictionary", lambda pend: isinstance(pend, dict), like={})] * 3
ROWS = {"mixed": MIXED, "five": FIVE, "many": MANY, "one": [ONE], "none": []}


def rows_of(relative_filepath):
    """Stand in for extract_and_convert: return the rows of a file of these checks."""
    return [dict(row) for row in ROWS.get(Path(relative_filepath).stem, [])]


def rows_with_e(relative_filepath, e_val):
    """Stand in for uniform_e_newton_cradle: return the rows of a file of these checks, with e."""
    return [{**row, "e": e_val} for row in rows_of(relative_filepath)]


def values_of(first, key):
    """Return a function that returns the values of key in first, and in its own argument.

    Both are lists of pendula.
    """
    return lambda last: ([pend[key] for pend in first], [pend[key] for pend in last])


def first_and_this(name):
    """Return what two calls give for a name: the first one, and this one."""
    return Several((Subject(f"{name} from the first call"), Subject(f"{name} from this call")))


@check("extract_and_convert")
def test_pend_list_is_a_list_of_dictionaries():
    """The result is a list with one dictionary for each row."""
    single_values = []
    single_dictionaries = []
    for row in MIXED:
        single_values += row.values()
        single_dictionaries += [{key: value} for key, value in row.items()]
    whole = "A value of bad_rep is a whole pendulum already: append that one."
    results = [
        ([0, 1, 2], "These are the keys of bad_rep. The pendula are its values."),
        (single_values, f"These are the single values of the file. {whole}"),
        (single_dictionaries, f"This is a dictionary for each value of the file. {whole}"),
    ]
    with files("mixed.csv"):
        expect("extract_and_convert", "mixed.csv", expected=THREE, results=results)


@check("extract_and_convert")
def test_a_row_is_a_pendulum():
    """The dictionaries have the values of the rows, in the same order."""
    with files(*FILES) as folder:
        for name, rows in ROWS.items():
            expect("extract_and_convert", str(folder / f"{name}.csv"), expected=rows)


@check("extract_and_convert")
def test_the_file_given_is_read():
    """Each call reads the CSV again, and returns a new pend_list."""
    with files("one.csv") as folder:
        first = expect("extract_and_convert", "one.csv", expected=[ONE])
        (folder / "one.csv").write_text(csv_of([ONE, {**ONE, "mass": 4.0}]))
        expect(
            "extract_and_convert",
            "one.csv",
            expected=([3.0], [3.0, 4.0]),
            see=values_of(first, "mass"),
            what=Several(
                (
                    Subject("each mass from the first call"),
                    Subject("each mass from this call with the same path and a changed file"),
                )
            ),
        )


def check_uniform(function, *arguments, key, value):
    """Check that all pendula of the files get the value of a key and keep the others."""
    with files(*FILES):
        found = []
        for name, rows in ROWS.items():
            expected = [{**row, key: value} for row in rows]
            found.append(expect(function, f"{name}.csv", *arguments, expected=expected))
        expect(
            function,
            "one.csv",
            *arguments,
            expected=([value] * 3, [value]),
            see=values_of(found[0], key),
            what=first_and_this(f"each {key}"),
        )


@check("uniform_mass_newton_cradle", extract_and_convert=rows_of)
@check("uniform_mass_newton_cradle")
def test_uniform_mass():
    """Each pendulum gets the given mass; all its other values stay."""
    for mass in (12.125, 0.5):
        check_uniform("uniform_mass_newton_cradle", mass, key="mass", value=mass)


@check("uniform_e_newton_cradle", extract_and_convert=rows_of)
@check("uniform_e_newton_cradle")
def test_uniform_e():
    """Each pendulum gets e_val as its e; all its other values stay."""
    for e in (0.0625, 0, 1):
        check_uniform("uniform_e_newton_cradle", e, key="e", value=e)


@check("elastic_newton_cradle", uniform_e_newton_cradle=rows_with_e)
@check("elastic_newton_cradle")
def test_elastic():
    """Each e is 1 (perfectly elastic); all other values stay."""
    check_uniform("elastic_newton_cradle", key="e", value=1)


@check("inelastic_newton_cradle", uniform_e_newton_cradle=rows_with_e)
@check("inelastic_newton_cradle")
def test_inelastic():
    """Each e is 0 (perfectly inelastic); all other values stay."""
    check_uniform("inelastic_newton_cradle", key="e", value=0)


def expect_cradle(see, what, expected, file="mixed.csv", r_param=R, theta_init=0.6, **options):
    """Check what see(pend) returns for each pendulum of the cradle from file.

    options are those of expect.
    """
    with files(file):
        expect(
            "make_newton_cradle",
            file,
            r_param,
            theta_init,
            expected=expected,
            what=what,
            see=lambda pend_list: [*map(see, pend_list)],
            **options,
        )


@check("make_newton_cradle")
def test_a_cradle_keeps_the_files_values():
    """Each pendulum keeps the mass, e, color and texture of its row."""

    def kept(pend):
        return {key: pend[key] for key in ("mass", "e", "color", "texture")}

    for name in ("mixed", "five", "many", "one"):
        expect_cradle(kept, Each(()), [*map(kept, ROWS[name])], file=f"{name}.csv")


@check("make_newton_cradle")
def test_the_first_pendulum_is_lifted():
    """The first pendulum starts at theta_init, all others at 0."""
    for theta_init, name in (
        (0.6, "mixed"),
        (-0.3, "one"),
        (-2.0, "five"),
        (0, "five"),
        (8.0, "many"),
        (4e-8, "mixed"),
    ):
        expect_cradle(
            lambda pend: pend["theta"],
            Each(("theta",)),
            [theta_init, *[0 for _ in ROWS[name][1:]]],
            file=f"{name}.csv",
            theta_init=theta_init,
        )


@check("make_newton_cradle")
def test_all_pendula_start_at_rest():
    """Each pendulum starts at rest: its omega is 0."""
    expect_cradle(lambda pend: pend["omega"], Each(("omega",)), [0, 0, 0])


@check("make_newton_cradle")
def test_objects_are_axle_bob_and_cord():
    """Each pendulum has its own tuple of axle, bob and cord, made once."""

    def are_parts(objects):
        if not isinstance(objects, tuple) or len(objects) != 3:
            return False
        are_right = all(map(isinstance, objects, (box, sphere, cylinder)))
        return are_right and all(part.visible for part in objects)

    def are_right(found):
        bobs = {id(bob) for _, bob, _ in found}
        return all(map(are_parts, found)) and len(bobs) == len(found)

    def are_shared(found):
        return are_parts(found[0]) and found.count(found[0]) == len(found)

    expect_cradle(
        lambda pend: pend["objects"],
        Each(("objects",)),
        Expected("a tuple of its own axle, bob and cord", are_right),
        results=[(are_shared, "All pendula have the same objects. Make new ones for each.")],
    )

    def strays(pend_list):
        parts = []
        for pend in pend_list:
            parts += pend["objects"]
        return left_over(old, parts)

    old = shapes()
    with files("mixed.csv"):
        expect("make_newton_cradle", "mixed.csv", R, 0.6, see=strays, **LEFT_OVER)


@check("make_newton_cradle")
def test_axle_positions():
    """The axles are r_param/4 apart, from x = -0.1 on, and r_param/5 high."""
    # r_param, and by hand the distance and the height of the axles (m)
    for r_param, apart, height in ((0.3, 0.075, 0.06), (1.0, 0.25, 0.2), (R, 0.1, 0.08)):
        expect_cradle(
            lambda pend: pend["objects"][0].pos,
            Each(("position",), "axle"),
            [vector(-0.1 + apart * i, height, 0) for i in range(5)],
            "five.csv",
            r_param,
            help=f"The axles are r_param/4 = {apart:g} m apart, and r_param/5 = {height:g} m high.",
        )


@check("make_newton_cradle")
def test_bobs_hang_from_their_axles():
    """Each bob and cord hangs at its own theta, as make_pendulum makes it."""

    def place(pend):
        axle, bob, _ = pend["objects"]
        return bob.pos - axle.pos

    what = Each(("position from the axle (m)",), "bob")
    bobs = [arm(theta, R) for theta in (0.6, 0, 0)]
    lifted = (
        "All bobs are lifted. make_pendulum must get the theta of each pendulum, which is "
        "theta_init only for the first one."
    )
    hangs = "make_pendulum hangs the bob at the angle theta that it gets."
    expect_cradle(place, what, bobs, results=[(bobs[:1] * 3, lifted)], help=hangs)

    def ends(pend):
        axle, bob, cord = pend["objects"]
        upper, lower = ends_like(cord, axle.pos, bob.pos)
        return upper - axle.pos, lower - axle.pos

    of_cord = Each(
        ("end at the axle (m from it)", "end at the bob (m from the axle)"),
        "cord",
        "ends of each cord (m from its axle)",
    )
    expect_cradle(ends, of_cord, [(vector(0, 0, 0), bob) for bob in bobs])
    radius = make_pendulum(vector(0, 0, 0), R, 0, vector(1, 1, 1), None)[1].radius
    expect_cradle(
        lambda pend: pend["objects"][1].radius, Each(("radius (m)",), "bob"), [radius] * 3
    )


@check("make_newton_cradle")
def test_bobs_have_the_color_and_texture_of_their_row():
    """Each bob has VPython's color and texture for the names in its row."""

    def looks(pend):
        bob = pend["objects"][1]
        return bob.color, bob.texture

    mixed = [(color.red, textures.metal), (color.blue, None), (color.yellow, textures.wood)]
    many = [(value, image) for (_, value), (_, image) in COLORS_AND_TEXTURES]
    for file, expected in (("mixed.csv", mixed), ("many.csv", many)):
        expect_cradle(looks, Each(("color", "texture"), "bob"), expected, file)


@check("make_newton_cradle")
def test_the_pend_list_is_returned():
    """Each call makes and returns a pend_list of its own."""
    with files("mixed.csv"):
        first = expect("make_newton_cradle", "mixed.csv", R, 0.6, expected=THREE)
        expect(
            "make_newton_cradle",
            "mixed.csv",
            R,
            -0.3,
            expected=(0.6, -0.3),
            see=lambda second: (first[0]["theta"], second[0]["theta"]),
            what=first_and_this("first theta"),
        )


@check("make_newton_cradle", extract_and_convert=rows_of)
def make_newton_cradle_alone():
    """Each row of the CSV gets its theta, omega and objects."""
    test_a_cradle_keeps_the_files_values()
    test_the_first_pendulum_is_lifted()
    test_all_pendula_start_at_rest()
    test_objects_are_axle_bob_and_cord()
    test_axle_positions()
    test_bobs_hang_from_their_axles()
    test_bobs_have_the_color_and_texture_of_their_row()
    test_the_pend_list_is_returned()
