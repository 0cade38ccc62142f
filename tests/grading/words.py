"""The words for the values of a cradle."""

from typing import Any

from pandas import DataFrame
from vpython import box, cylinder, mag, sphere, vector

from line_by_line.words import Noun, Words
from line_by_line.words import plural as plural


def vector_text(value: vector) -> str:
    return f"vector({', '.join(WORDS.number_text(number) for number in value.value)})"


def shape_text(value: Any) -> str:
    return f"{SHAPES[type(value)]} at {vector_text(value.pos)}"


SHAPES: dict[type, str] = {box: "an axle", sphere: "a bob", cylinder: "a cord"}
WORDS = Words(
    forms=SHAPES,
    texts={
        vector: vector_text,
        DataFrame: lambda table: f"a table of {len(table)} rows",
        **dict.fromkeys(SHAPES, shape_text),
    },
    nouns=[Noun("mass", "pendulum", "pendula")],
    attributes={
        vector: ("x", "y", "z"),
        box: ("pos",),
        sphere: ("pos", "radius", "color", "texture", "visible"),
        cylinder: ("pos", "axis"),
    },
    functions=[mag, vector],
)
text_of = WORDS.text_of
in_words = WORDS.in_words
form_of = WORDS.form_of
