"""Signs that only look right, in a text that is not allowed."""

import pytest

from support.signs import found


@pytest.mark.parametrize(
    ("text", "ending"),
    [
        ("", ""),
        ("30°, m²é", ""),
        ("\u221230\u2013", "; sign 1 is minus sign (U+2212): type -"),
        ("- 30\u2011", "; sign 5 is non-breaking hyphen (U+2011): type -"),
        ("\u201c30\u201d", '; sign 1 is left double quotation mark (U+201C): type "'),
        ("1\u00a0000", "; sign 2 is no-break space (U+00A0): delete it"),
        ("3\u200b", "; sign 2 is zero width space (U+200B): delete it"),
        ("\uff11", "; sign 1 is fullwidth digit one (U+FF11): type 1"),
        ("\u0663", "; sign 1 is arabic-indic digit three (U+0663): type 3"),
        ("0,5 1", "; a number has a decimal point"),
    ],
)
def test_the_first_sign_that_only_looks_right_is_named(text, ending):
    words = found(text, "a number")
    assert words == f"found {repr(text) if text else 'nothing'}, allowed is a number{ending}"
