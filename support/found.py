"""The words about a text that is not allowed."""

LONGEST_FOUND = 300  # letters of a text in a message


def found(value: object, allowed: str) -> str:
    """Return the words of a message: this value was found, and what is allowed."""
    what = in_short(repr(value)) if value not in (None, "") else "nothing"
    return f"found {what}, allowed is {allowed}"


def in_short(text: str) -> str:
    """Return the beginning of a long text: a wrong file may have a line of megabytes."""
    return text if len(text) <= LONGEST_FOUND else f"{text[:LONGEST_FOUND]}..."
