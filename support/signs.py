"""The words about a text that is not allowed, and about a sign in it that only looks right.

Word processors and other keyboards type such signs: long dashes, curly quotes, wide digits.
"""

import re
from unicodedata import decimal, name

LONGEST_FOUND = 300  # letters of a text in a message
MINUS = "\u2212"
# What to type, and the signs that look like it. Digits are not here: Python knows those of each
# script.
LOOK_ALIKES = {
    "-": f"{MINUS}\u2010\u2011\u2012\u2013\u2014\u2015",
    '"': "\u201c\u201d\u201e\u201f\u00ab\u00bb",
    "'": "\u2018\u2019\u201a\u201b",
    ",": "\u060c\u3001",
    ".": "\u066b",
    # Hard, narrow and wide spaces, and signs that nobody sees
    " ": "\u00a0\u2002\u2003\u2007\u2009\u202f\u3000",
    "": "\u00ad\u200b\u200c\u200d\u200e\u200f\u2060\ufeff",
}
PLAIN = {odd: plain for plain, signs in LOOK_ALIKES.items() for odd in signs}
PLAIN |= {chr(0xFEE0 + ascii): chr(ascii) for ascii in range(33, 127)}  # the wide signs


def plain_sign(sign: str) -> str:
    """Return what to type in place of a sign that only looks right; another one stays."""
    return PLAIN.get(sign, str(decimal(sign, sign)))


def in_plain_signs(text: str) -> str:
    """Return a text as a plain keyboard types it."""
    return "".join(map(plain_sign, text))


def odd_sign(text: str) -> str:
    """Return the end of a message: the first sign of a text that only looks right, or "".

    A comma in a number is one, too.
    """
    for place, sign in enumerate(text, start=1):
        plain = plain_sign(sign)
        if plain != sign:
            advice = f"type {plain}" if plain.strip() else "delete it"
            return f"; sign {place} is {name(sign).lower()} (U+{ord(sign):04X}): {advice}"
    return "; a number has a decimal point" if re.search(r"\d,\d", text) else ""


def found(text: str, allowed: str) -> str:
    """Return the words of a message: this text was found, and what is allowed."""
    what = in_short(repr(text)) if text else "nothing"
    return f"found {what}, allowed is {allowed}{odd_sign(text)}"


def in_short(text: str) -> str:
    """Return the beginning of a long text: a wrong file may have a line of megabytes."""
    return text if len(text) <= LONGEST_FOUND else f"{text[:LONGEST_FOUND]}..."
