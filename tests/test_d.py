"""D checks: a CSV becomes a pend_list, and its pendula get VPython objects."""

if __name__ == "__main__":
    from grading.begin import refuse_to_run

    refuse_to_run()

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import cycle, islice
from operator import itemgetter
from pathlib import Path
from tempfile import TemporaryDirectory

from vpython import box, color, cylinder, sphere, textures, vector

from grading.cradles import csv_of, LEFT_OVER, left_over, MIXED, MIXED_CSV, R, shapes
from grading.grader import check, expect, steps, WrongError
from grading.messages import Wanted
from grading.students_code import working_in
from support.constants import COLOR_MAP, TEXTURE_MAP
from support.pendulum import arm, make_pendulum

LOOP = "for book in books:  # the indented lines below run once for each book"
STORE = "book['pages'] = 160  # stores a value in a key; == only compares"
CALL = "return prices(path, 20)  # returns the result of a call"

steps(
    "extract_and_convert",
    "read_csv gives df, to_dict gives bad_rep, and pend_list gets each value of bad_rep. Return pend_list.",
    "books.append(book)  # puts one more element at the end of the list",
    "shelf.values()  # all values of a dictionary, without its keys",
)
for key in ("mass", "e"):
    words = f"pend_list comes from extract_and_convert; each pendulum gets the new {key}; pend_list is returned."
    steps(f"uniform_{key}_newton_cradle", words, LOOP, STORE)
for kind in ("elastic", "inelastic"):
    words = f"uniform_e_newton_cradle makes the pend_list, with the e of an {kind} collision; pend_list is returned."
    steps(f"{kind}_newton_cradle", words, CALL)
steps(
    "make_newton_cradle",
    "for each pendulum: theta, omega, axle_pos, color, texture, and objects (from make_pendulum).",
    "for i in range(len(books)):  # i is 0, then 1, ...; books[i] is a book",
    STORE,
)

# Equal rows, also the first and the last one, zeros, e = 0 and e = 1, many digits, and more rows
# than columns.
SEVEN = [
    {"mass": 12.625, "e": 1.0, "theta": 0.4375, "omega": 0.0, "color": "white", "texture": "none"},
    {"mass": 0.25, "e": 0.0, "theta": 0.0, "omega": 0.0, "color": "red", "texture": "rug"},
    {"mass": 0.25, "e": 0.0, "theta": 0.0, "omega": 0.0, "color": "red", "texture": "rug"},
    {"mass": 2.0, "e": 0.5, "theta": -0.125, "omega": 3.5, "color": "green", "texture": "none"},
    {"mass": 7.0, "e": 0.0625, "theta": 0.0, "omega": 0.0, "color": "blue", "texture": "stucco"},
    {"mass": 1.0, "e": 1.0, "theta": 0.0, "omega": -0.5, "color": "purple", "texture": "wood_old"},
    {"mass": 12.625, "e": 1.0, "theta": 0.4375, "omega": 0.0, "color": "white", "texture": "none"},
]
ONE = {"mass": 3.0, "e": 0.5, "theta": 0.1, "omega": 0.2, "color": "green", "texture": "rug"}
ASSISTANTS = [
    {"name": "Ada", "year": 2, "house": "Page"},
    {"name": "Grace", "year": 4, "house": "Lloyd"},
]
# All names and values of COLOR_MAP and TEXTURE_MAP, and the rows of many.csv, whose columns are in
# another order.
LOOKS = list(islice(zip(cycle(COLOR_MAP.items()), cycle(TEXTURE_MAP.items())), 40))
MANY = [
    {"e": 0.5, "color": name, "omega": 0.0, "mass": 0.5 + i, "texture": image, "theta": 0.0}
    for i, ((name, _), (image, _)) in enumerate(LOOKS)
]
FILES = {
    "mixed.csv": MIXED_CSV,
    "seven.csv": csv_of(SEVEN),  # no line break at the end
    "one.csv": csv_of([ONE]),
    "none.csv": f"{','.join(ONE)}\n",
    "assistants.csv": csv_of(ASSISTANTS),
    "many.csv": csv_of(MANY),
}


@contextmanager
def files(*names) -> Iterator[Path]:
    """Yield a folder with these FILES. On Windows, it is not deleted if a solution left a file
    open.
    """
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        for name in names:
            (Path(folder) / name).write_text(FILES[name], encoding="utf-8")
        yield Path(folder)


def are_three(found):
    return (
        isinstance(found, list)
        and len(found) == 3
        and all(isinstance(pend, dict) for pend in found)
    )


THREE = Wanted("a list with 3 dictionaries", are_three, like=[{}] * 3)


def values_of(first, key):
    """Return a function that returns the values of key in the pend_list first, and in its own
    argument.
    """
    return lambda last: ([pend[key] for pend in first], [pend[key] for pend in last])


def converts_assistants() -> bool:
    """Return whether extract_and_convert takes the names of the columns from the file."""
    with files("assistants.csv") as folder:
        try:
            expect("extract_and_convert", str(folder / "assistants.csv"), wanted=ASSISTANTS)
        except WrongError:
            return False
    return True


@check("extract_and_convert")
def test_pend_list_is_a_list_of_dictionaries():
    """Each pendulum is represented by a dictionary in a list called pend_list."""
    whole = "A value of bad_rep is a whole pendulum already: append that one."
    results = [
        ([0, 1, 2], "These are the keys of bad_rep. The pendula are its values."),
        (
            [value for row in MIXED for value in row.values()],
            f"These are the single values of the file. {whole}",
        ),
        (
            [{key: value} for row in MIXED for key, value in row.items()],
            f"This is a dictionary for each value of the file. {whole}",
        ),
    ]
    with files("mixed.csv") as folder:
        expect("extract_and_convert", str(folder / "mixed.csv"), wanted=THREE, results=results)


@check("extract_and_convert")
def test_a_row_is_a_pendulum():
    """The value of a key is the value associated with that attribute."""
    with files("mixed.csv", "seven.csv", "many.csv", "none.csv") as folder:
        for name, rows in (("mixed", MIXED), ("seven", SEVEN), ("many", MANY), ("none", [])):
            expect("extract_and_convert", str(folder / f"{name}.csv"), wanted=rows)


@check("extract_and_convert")
def test_the_file_given_is_read():
    """Creates and returns pend_list with the provided relative_filepath."""
    with files("one.csv") as folder, working_in(folder):
        first = expect("extract_and_convert", "one.csv", wanted=[ONE])
        (folder / "one.csv").write_text(csv_of([ONE, {**ONE, "mass": 4.0}]))
        what = "each mass from the first call, each mass from this call with the same path and a changed file"
        both = {"see": values_of(first, "mass"), "what": what}
        words = "Your extract_and_convert does not convert a CSV with other columns. With the file's own names, it would."
        notes = [(lambda _: not converts_assistants(), words)]
        expect("extract_and_convert", "one.csv", wanted=([3.0], [3.0, 4.0]), notes=notes, **both)


def check_uniform(function, *arguments, **changed):
    """Check that all pendula of the files get the changed value and keep the others."""
    ((key, value),) = changed.items()
    with files(*FILES) as folder, working_in(folder):
        results = []
        for name, rows in (("mixed", MIXED), ("seven", SEVEN), ("many", MANY), ("none", [])):
            wanted = [{**row, **changed} for row in rows]
            results.append(expect(function, f"{name}.csv", *arguments, wanted=wanted))
        what = f"each {key} from the first call, each {key} from this call"
        both = {"see": values_of(results[0], key), "what": what, "wanted": ([value] * 3, [value])}
        expect(function, "one.csv", *arguments, **both)


@check("uniform_mass_newton_cradle")
def test_uniform_mass():
    """All the pendulum's mass values are assigned the value mass."""
    check_uniform("uniform_mass_newton_cradle", 12.125, mass=12.125)
    check_uniform("uniform_mass_newton_cradle", 0.5, mass=0.5)


@check("uniform_e_newton_cradle")
def test_uniform_e():
    """All the pendulum's coefficients of restitution are assigned the e value."""
    check_uniform("uniform_e_newton_cradle", 0.0625, e=0.0625)
    check_uniform("uniform_e_newton_cradle", 0, e=0)
    check_uniform("uniform_e_newton_cradle", 1, e=1)


@check("elastic_newton_cradle")
def test_elastic():
    """Returns a pend_list such that each pendulum has a perfectly elastic restitution coefficient
    value.
    """
    check_uniform("elastic_newton_cradle", e=1)


@check("inelastic_newton_cradle")
def test_inelastic():
    """Returns a pend_list such that each pendulum has a perfectly inelastic restitution coefficient
    value.
    """
    check_uniform("inelastic_newton_cradle", e=0)


def expect_cradle(see, what, wanted, file="mixed.csv", r_param=R, theta_init=0.6, **words):
    """Check what see(pend) returns for each pendulum of the cradle from file. words are options of
    expect.
    """
    options = {
        "wanted": wanted,
        "what": what,
        "see": lambda pend_list: [*map(see, pend_list)],
        **words,
    }
    with files(file) as folder, working_in(folder):
        expect("make_newton_cradle", file, r_param, theta_init, **options)


@check("make_newton_cradle")
def test_a_cradle_keeps_the_files_values():
    """Creates the list of pendulum dictionaries from relative_filepath."""

    def kept(pend):
        return {key: pend[key] for key in ("mass", "e", "color", "texture")}

    for file, rows in (
        ("mixed.csv", MIXED),
        ("one.csv", [ONE]),
        ("seven.csv", SEVEN),
        ("many.csv", MANY),
    ):
        expect_cradle(kept, "each pendulum", [*map(kept, rows)], file=file)


@check("make_newton_cradle")
def test_the_first_pendulum_is_lifted():
    """theta should be theta_init for the first pendulum, 0 for all the others."""
    theta = itemgetter("theta")
    expect_cradle(theta, "theta of each pendulum", [0.6, 0, 0])
    cases = [
        (-0.3, "one", 1),
        (2.0, "mixed", 3),
        (-2.0, "seven", 7),
        (0, "seven", 7),
        (8.0, "many", 40),
    ]
    for theta_init, name, count in [*cases, (4e-8, "mixed", 3)]:
        wanted = [theta_init, *[0] * (count - 1)]
        expect_cradle(
            theta, "theta of each pendulum", wanted, file=f"{name}.csv", theta_init=theta_init
        )


@check("make_newton_cradle")
def test_all_pendula_start_at_rest():
    """omega: the angular velocity, which should be 0 for all the pendula."""
    expect_cradle(lambda pend: pend["omega"], "omega of each pendulum", [0, 0, 0])


@check("make_newton_cradle")
def test_objects_are_axle_bob_and_cord():
    """objects: a tuple of (axle, bob, and cord) VPython object that are the parts of the pendulum."""

    def is_one(objects):
        are_three = isinstance(objects, tuple) and len(objects) == 3
        kinds = box, sphere, cylinder
        return (
            are_three
            and all(map(isinstance, objects, kinds))
            and all(part.visible for part in objects)
        )

    def are_own(found):
        return len({id(bob) for _, bob, _ in found}) == len(found)

    wanted = Wanted(
        "an axle, a bob and a cord for each",
        lambda found: all(map(is_one, found)) and are_own(found),
    )

    def is_shared(found):
        return is_one(found[0]) and found[0][1] is found[-1][1]

    results = [(is_shared, "All pendula have the same objects. Make them inside the loop.")]
    expect_cradle(
        lambda pend: pend["objects"],
        "the value of objects in each pendulum",
        wanted,
        results=results,
    )

    def strays(pend_list):
        return left_over(old, [part for pend in pend_list for part in pend["objects"]])

    old = shapes()
    with files("mixed.csv") as folder, working_in(folder):
        expect("make_newton_cradle", "mixed.csv", R, 0.6, see=strays, **LEFT_OVER)


@check("make_newton_cradle")
def test_axle_positions():
    """The axle position of the ith pendulum can be defined as axle_pos = vector((-0.1+r_param/4 *
    i), r_param/5, 0).
    """
    # The file, the number of its rows, r_param, and by hand the distance and the height of the
    # axles (m).
    for file, count, r_param, apart, height in (
        ("mixed.csv", 3, 0.3, 0.075, 0.06),
        ("mixed.csv", 3, 1.0, 0.25, 0.2),
        ("seven.csv", 7, R, 0.1, 0.08),
    ):
        wanted = [vector(-0.1 + apart * i, height, 0) for i in range(count)]
        words = (
            f"Here, the axles are r_param/4 = {apart:g} m apart, and r_param/5 = {height:g} m high."
        )
        expect_cradle(
            lambda pend: pend["objects"][0].pos,
            "position of each axle",
            wanted,
            file,
            r_param,
            help=words,
        )


@check("make_newton_cradle")
def test_bobs_hang_from_their_axles():
    """Use one relevant helper function to create the tuple of objects."""

    def place(pend):
        axle, bob, _ = pend["objects"]
        return bob.pos - axle.pos

    what = "position from the axle (m) of each bob"
    bobs = [arm(theta, R) for theta in (0.6, 0, 0)]

    def are_lifted(found):
        return (
            len({(round(one.x, 6), round(one.y, 6)) for one in found}) == 1 and 0.2 < found[1].x < R
        )

    lifted = "All bobs are lifted. make_pendulum must get the theta of each pendulum, and not theta_init each time."
    words = "make_pendulum hangs the bob at the angle theta that it gets."
    expect_cradle(place, what, bobs, results=[(are_lifted, lifted)], help=words)
    expect_cradle(
        place, what, [arm(theta, 1.0) for theta in (-0.3, 0, 0)], r_param=1.0, theta_init=-0.3
    )

    def ends(pend):  # from the axle, the upper one first
        axle, _, cord = pend["objects"]
        return sorted(
            [cord.pos - axle.pos, cord.pos + cord.axis - axle.pos], key=lambda end: -end.y
        )

    expect_cradle(
        ends, "ends of the cord of each pendulum", [[vector(0, 0, 0), bob] for bob in bobs]
    )
    radius = make_pendulum(vector(0, 0, 0), R, 0, vector(1, 1, 1), None)[1].radius
    expect_cradle(lambda pend: pend["objects"][1].radius, "radius (m) of each bob", [radius] * 3)


@check("make_newton_cradle")
def test_bobs_have_the_color_and_texture_of_their_row():
    """Use COLOR_MAP and TEXTURE_MAP to find the VPython analog color and texture objects."""
    mixed = [(color.red, textures.metal), (color.blue, None), (color.yellow, textures.wood)]
    white, red = (color.white, None), (color.red, textures.rug)
    others = [(color.green, None), (color.blue, textures.stucco), (color.purple, textures.wood_old)]
    seven = [white, red, red, *others, white]
    many = [(value, image) for (_, value), (_, image) in LOOKS]
    for file, wanted in (("mixed.csv", mixed), ("seven.csv", seven), ("many.csv", many)):
        looks = {"what": "color and texture of each bob", "wanted": wanted, "file": file}
        expect_cradle(lambda pend: (pend["objects"][1].color, pend["objects"][1].texture), **looks)


@check("make_newton_cradle")
def test_the_pend_list_is_returned():
    """Return the updated pend_list."""
    with files("mixed.csv") as folder, working_in(folder):
        first = expect("make_newton_cradle", "mixed.csv", R, 0.6, wanted=THREE)
        what = "first theta from the first call, first theta from this call"
        thetas = {
            "see": lambda second: (first[0]["theta"], second[0]["theta"]),
            "what": what,
            "wanted": (0.6, -0.3),
        }
        expect("make_newton_cradle", "mixed.csv", R, -0.3, **thetas)
