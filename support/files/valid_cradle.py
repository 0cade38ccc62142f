"""What the CSV of a cradle must have."""

from collections.abc import Iterable

from support.columns import CHECKED, REQUIRED, to_number
from support.files.cradle_csv import Row, Snapshot

MOST_PENDULA = 1000  # of a cradle
LONGEST_FOUND = 300  # letters of a file in a message
# What to do if this stands between the names, which are then one cell.
HINTS = {
    ";": "separate cells with commas, not semicolons",
    "\t": "separate cells with commas, not tabs",
    ",": "take away the quotes around each line",
}
OTHER_COMMAS = {"\uff0c", "\u3001", "\u060c"}  # full-width, ideographic, and Arabic

# In a double cradle, a light bob between two heavy ones can get so fast that a tick has to be done
# in many small steps (src/double_cradle.py). With these masses, no trial needed more than about two
# hundred.
MOST_TIMES = 1e6
IN_RANGE = "at most 1e6 times the smallest mass, in a double cradle"


def require_cradle(snapshot: Snapshot, cords: int = 1) -> None:
    """Raise a ValueError for the first mistake in the CSV of a cradle.

    It names the file, the line, the column, the value found and the allowed values. cords is the
    number of cords of a pendulum: 1, or 2 for the double cradle, which needs masses in the range of
    MOST_TIMES, too.
    """
    require_columns_and_count(snapshot)
    header, *pendula = snapshot.rows
    if not pendula:
        raise ValueError(
            f"{snapshot}: names columns but has no pendulum, "
            "a cradle needs at least one row below them"
        )
    for row in pendula:
        require_allowed_cells(snapshot, header, row)
    if cords == 2:
        require_masses_in_range(snapshot, header, pendula)


def require_columns_and_count(snapshot: Snapshot) -> None:
    """Raise a ValueError if the CSV lacks a column, or has more than MOST_PENDULA.

    It looks at no later row: the rows of a file of 10 MB would take a gigabyte of memory.
    """
    for number, row in enumerate(snapshot.each_row()):
        place = f"{snapshot}, line {row.line}"
        # Before the rows: a title above the names may have fewer cells than they have
        if number == 0:
            require_columns(place, row.cells)
        if number > MOST_PENDULA:
            raise ValueError(
                f"{place}: found pendulum {number}, allowed are at most {MOST_PENDULA}, "
                "which already move in slow motion on the page"
            )


def require_columns(place: str, names: list[str]) -> None:
    """Raise a ValueError if the names at this place lack a column of a cradle, or repeat one."""
    found_names = in_short(", ".join(repr(name) for name in names if name))
    allowed = f"a cradle needs one column of each of {', '.join(REQUIRED)}{comma_hint(found_names)}"
    if not set(REQUIRED) & set(names):
        for separator, hint in HINTS.items():
            parts = {part.strip(' "').lower() for part in names[0].split(separator)}
            if len(set(REQUIRED) & parts) > 1:
                allowed += f"; {hint}"
        raise ValueError(f"{place} must name the columns: found {found_names}; {allowed}")
    for column in CHECKED:
        count = names.count(column)
        is_missing = count == 0 and column in REQUIRED
        if count > 1 or is_missing:
            found = f"{count} columns" if count else "no column"
            raise ValueError(f"{place}: found {found} {column} in {found_names}; {allowed}")


def require_allowed_cells(snapshot: Snapshot, header: Row, row: Row) -> None:
    """Raise a ValueError if a cell of this row has a value that its column does not allow."""
    # A short row lacks its last cells.
    pendulum = dict(zip(header.cells, row.cells, strict=False))
    for name, column in CHECKED.items():
        text = pendulum.get(name, "")
        if name in header.cells and not column.allows(text):
            message = f"found {in_short(repr(text))}" if text else "found nothing"
            message += f", allowed is {column.allowed()}"
            if len(row.cells) < len(header.cells):
                message += f"; this line has {len(row.cells)} cells, not {len(header.cells)}"
            message += comma_hint(text)
            raise ValueError(f"{snapshot}, line {row.line}, column {name}: {message}")


def require_masses_in_range(snapshot: Snapshot, header: Row, pendula: list[Row]) -> None:
    """Raise a ValueError if these pendula of a double cradle have masses that are too far apart."""
    column = header.cells.index("mass")

    def mass(row: Row) -> float:
        return to_number(row.cells[column])

    lightest = min(pendula, key=mass)
    heaviest = max(pendula, key=mass)
    if not are_in_range([mass(lightest), mass(heaviest)]):
        raise ValueError(
            f"{snapshot}, line {heaviest.line}, column mass: found {heaviest.cells[column]!r}, "
            f"and {lightest.cells[column]!r} in line {lightest.line}, allowed is {IN_RANGE}"
        )


def are_in_range(masses: Iterable[float]) -> bool:
    """Return whether the masses of a double cradle are at most MOST_TIMES the smallest one."""
    return max(masses) <= MOST_TIMES * min(masses)


def comma_hint(text: str) -> str:
    """Return a hint to put behind the allowed values: text may have a comma of another script."""
    if OTHER_COMMAS.intersection(text):
        return "; separate cells with plain commas (,)"
    return ""


def in_short(text: str) -> str:
    """Return the beginning of a long text.

    It is for a message: a file that is no cradle may have a line of megabytes.
    """
    return text if len(text) <= LONGEST_FOUND else f"{text[:LONGEST_FOUND]}..."
