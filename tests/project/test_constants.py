"""The constants: all names for a CSV are there, and NC_FP finds the CSV."""

import os

from vpython import color, textures, vector

from support import constants


def names(namespace):
    """Return the public names in a class, without functions."""
    return {name for name, value in vars(namespace).items() if name[0] != "_" and isinstance(value, (str, vector))}


def test_every_color_of_vpython_has_its_name():
    """test_headless_vpython.py compares the colors of the stand-in with those of VPython."""
    assert {name: getattr(color, name) for name in names(color)} == constants.COLOR_MAP


def test_every_texture_of_vpython_has_its_name_and_so_has_none():
    expected = {name: getattr(textures, name) for name in names(textures)}
    assert {**expected, "none": None} == constants.TEXTURE_MAP


def test_the_csv_is_found_from_any_folder():
    assert os.path.isabs(constants.NC_FP)
    assert os.path.isfile(constants.NC_FP)
