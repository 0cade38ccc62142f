"""The source of the viewer's cradle: your CSV, an experiment, or the table in which you edit the pendula."""

from math import inf
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from support.files.cradle_csv import check_cradle, clean_copy, MOST_PENDULA, Snapshot, WHY_NOT_MORE
from support.files.data_file import whole_file
from support.files.experiments import EXPERIMENTS
from support.page.questions import Questions
from support.page.table import cells_of, have_same_pendula, Table, what_changes, with_cell, with_numbers, with_rows


class Settings(NamedTuple):
    """The CSV of a cradle, and the settings that replace parts of it. None is as main makes it."""

    csv: Snapshot
    angles: list[float | None]  # rad
    lifted: int | None
    collision: str  # a key of the cradle's collisions
    mass: float | None  # kg


class Source:
    """Chooses the cradle that the viewer lets main make; your file changes only if you write it.

    The methods that change the cradle end with viewer.want_cradle().
    """

    def __init__(self, viewer, file):
        """Begin with the CSV in this file (a LiveFile)."""
        self.viewer, self.cradle, self.file = viewer, viewer.cradle, file
        self.poses: list | None = None  # the angles of each pendulum at the release, if an experiment sets them
        self.own = self.settings()  # of your CSV, while an experiment is shown
        self.questions = Questions(EXPERIMENTS / self.cradle.kind, len(self.cradle.angle_keys))
        self.table = Table([*self.cradle.angle_keys, *self.cradle.rate_keys])
        self.undoable: tuple | None = None  # your file before and after the last write, to undo it

    def settings(self) -> Settings:
        """Return the present settings of the cradle."""
        viewer = self.viewer
        return Settings(viewer.snapshot, list(viewer.angles), viewer.lifted, self.cradle.collision, self.cradle.mass)

    # --- the settings ------------------------------------------------------------------------------------------------

    def set_angle(self, number_and_angle) -> None:
        """Release the bobs from this angle (rad); its number is the index of its slider."""
        self.leave_poses()
        number, angle = number_and_angle
        self.viewer.angles[number] = angle
        self.viewer.want_cradle()

    def set_lifted(self, lifted) -> None:
        """Lift this number of bobs."""
        self.leave_poses()
        self.viewer.lifted = lifted
        self.viewer.want_cradle()

    def set_collision(self, collision) -> None:
        """Let bobs collide in this way (a key of the cradle's collisions) from now on."""
        self.leave_experiment()
        self.viewer.collide(collision)
        self.show_rows()

    def set_separating(self, separating) -> None:
        """Let separating bobs collide, too, or not."""
        self.leave_experiment()
        self.viewer.separating = separating

    # --- your file ---------------------------------------------------------------------------------------------------

    def reload(self) -> None:
        """Let main make the cradle of the new file, or show the mistake in the file; the old cradle then swings on."""
        csv = self.file.current
        try:
            check_cradle(csv, len(self.cradle.angle_keys))
        except ValueError as error:
            self.viewer.panel.show_error(str(error))
            self.show_rows()
            return
        self.viewer.panel.show_error("")
        self.own = self.own._replace(csv=csv)
        if not self.questions.experiment:
            self.viewer.snapshot = csv
        self.choose(0)

    # --- experiments -------------------------------------------------------------------------------------------------

    def choose(self, place) -> None:
        """Let main make the cradle in this place of the menu: an experiment, or (0) your CSV with its settings."""
        viewer, cradle = self.viewer, self.cradle
        if not self.questions.experiment:
            self.own = self.settings()
        viewer.running = viewer.running or self.questions.is_asking or place > 0
        experiment = self.questions.choose(place)
        chosen = self.own
        if experiment:
            chosen = Settings(experiment.csv, [None] * len(viewer.angles), None, next(iter(cradle.collisions)), None)
        viewer.snapshot, viewer.angles, viewer.lifted, cradle.collision, cradle.mass = chosen
        self.poses = experiment.angles if experiment else None
        self.table.mistakes.clear()
        viewer.want_cradle()

    def ask_first(self, ask_first) -> None:
        """Ask the question of an experiment before its release, or not; restart an experiment."""
        self.questions.ask_first = ask_first
        if self.poses and not self.questions.is_changed:
            self.viewer.running = True
            self.viewer.want_cradle()

    def answer(self, question_and_answer) -> None:
        """Take an answer: (key of the experiment that asks, index of the answer, or None); the cradle then runs."""
        self.viewer.running = self.questions.answer(*question_and_answer) or self.viewer.running

    def repeat(self, slowly) -> None:
        """Run the experiment again with the same answer, maybe slowly."""
        if self.questions.measurement:
            self.questions.repeat(slowly)
            self.viewer.running = True
            self.viewer.want_cradle()

    def choose_next(self) -> None:
        """Choose the next experiment of the menu, after the last one the first."""
        experiments = self.questions.experiments
        now = self.questions.experiment
        if experiments:
            self.choose(1 + (experiments.index(now) + 1 if now else 0) % len(experiments))

    def pose(self) -> None:
        """Lift the bobs as the present experiment says, and ask its question, if Predict first is ticked."""
        if not self.poses or len(self.poses) != len(self.cradle.pend_list):  # main may read another file
            return
        self.cradle.pose(self.poses)
        self.viewer.motion.set_start()
        self.questions.begin()
        self.viewer.running = self.viewer.running and not self.questions.is_asking

    def leave_poses(self) -> None:
        """Lift the bobs as the sliders say, no more as an experiment says."""
        if self.poses:
            angles, self.viewer.lifted = self.cradle.as_made
            self.viewer.angles, self.poses = list(angles), None
        self.leave_experiment()

    def leave_experiment(self) -> None:
        """Measure nothing any more: the cradle is no longer that of the experiment. If it was waiting, it runs."""
        viewer = self.viewer
        viewer.running, viewer.rest_end = viewer.running or self.questions.is_asking, -inf
        viewer.slow_hits.clear()
        viewer.set_speed(viewer.speed)  # also if an experiment was repeated slowly
        self.questions.leave()

    # --- the table ---------------------------------------------------------------------------------------------------

    def open_table(self, is_open) -> None:
        """Open the table, or fold it away."""
        self.table.open(is_open)
        self.show_rows()

    def show_rows(self) -> None:
        """Show the pendula in the table, and what Write to my CSV would change, if the table is open."""
        if self.table.is_open:
            csv, file = self.present_csv(), self.file.current
            self.table.show_rows(*cells_of(csv))
            can_undo = bool(self.undoable and self.undoable[1] == file)
            self.table.show_written(self.table.news or what_changes(file, csv), can_undo=can_undo)
            self.table.news = ""

    def present_csv(self) -> Snapshot:
        """Return the CSV of the present pendula: with the masses and e that they have now."""
        csv = with_numbers(self.viewer.snapshot, "mass", self.cradle.values("mass"))
        return with_numbers(csv, "e", self.cradle.values("e"))

    def edit(self, row_column_text) -> None:
        """Change a cell of the table to this text, or show why it cannot have it.

        You may click faster than the page shows the new table: nothing happens to a row that is no longer there.
        """
        row, column, text = row_column_text
        csv = self.present_csv()
        is_allowed = self.has_row(row) and self.table.allows(csv, row, column, text)
        self.take_edited(with_cell(csv, row, column, text) if is_allowed else None)

    def add(self, _) -> None:
        """Add a pendulum like the last one; there are at most MOST_PENDULA."""
        csv, has_place = self.present_csv(), len(self.cradle.pend_list) < MOST_PENDULA
        rows = cells_of(csv)[1]
        self.take_edited(with_rows(csv, [*rows, rows[-1]]) if has_place else None, has_new_rows=True)
        if not has_place:
            self.table.show_written(f"Add a pendulum: {WHY_NOT_MORE}", failed=True)

    def delete(self, row) -> None:
        """Delete this row (its index); the last pendulum stays."""
        csv, can_go = self.present_csv(), self.has_row(row) and self.has_row(1)
        rows = [cells for number, cells in enumerate(cells_of(csv)[1]) if number != row]
        self.take_edited(with_rows(csv, rows) if can_go else None, has_new_rows=True)

    def has_row(self, row) -> bool:
        """Return whether the table has this row (its index)."""
        return 0 <= row < len(cells_of(self.viewer.snapshot)[1])

    def take_edited(self, csv, has_new_rows=False) -> None:
        """Let main make the cradle of this CSV, edited in memory; None shows the old table again."""
        self.leave_experiment()
        if csv is None:
            self.show_rows()
            return
        if has_new_rows:
            self.leave_poses()
            self.table.mistakes.clear()
        self.cradle.mass, self.cradle.collision = None, next(iter(self.cradle.collisions))  # the CSV now has them
        self.viewer.snapshot = csv
        self.viewer.want_cradle()

    def write(self, _) -> None:
        """Write the present pendula to your CSV, and let main make its cradle; or say why it failed.

        write_to_csv writes to another file first: if it fails, your CSV stays as it is.
        """
        csv = self.present_csv()
        try:
            with TemporaryDirectory(ignore_cleanup_errors=True) as folder, clean_copy(csv) as path:
                copy = Path(folder, Path(self.file.filepath).name)
                self.cradle.write(path, copy)
                written = Snapshot(copy)
            if not have_same_pendula(written, csv):
                raise ValueError("write_to_csv has written other pendula, so your CSV stays as it is")
        except Exception as error:  # of a student's function
            self.table.show_written(f"{type(error).__name__}: {' '.join(str(error).split())}", failed=True)
            return
        before = Snapshot(self.file.filepath)
        if self.replace_file(written, "has these pendula now") and before != written:  # a second click changes nothing
            first = self.undoable[0] if self.undoable and self.undoable[1] == before else before
            self.undoable = None if first.error else (first, written)

    def undo(self, _) -> None:
        """Put your CSV back as it was before the last write, once; if it has changed since, it stays as it is."""
        if self.undoable and Snapshot(self.file.filepath) != self.undoable[1]:
            self.table.show_written("Your CSV has changed since the write, so Undo leaves it as it is.", failed=True)
        elif self.undoable and self.replace_file(self.undoable[0], "is again as it was before the write"):
            self.undoable = None

    def replace_file(self, csv, news) -> bool:
        """Put the bytes of a Snapshot into your CSV, and let main make its cradle; return whether it worked."""
        try:
            with whole_file(self.file.filepath) as file:
                file.buffer.write(csv.data)
        except OSError as error:
            self.table.show_written(f"{self.file.filepath}: {error.strerror}", failed=True)
            return False
        self.file.look_now()
        self.own = self.own._replace(collision=next(iter(self.cradle.collisions)), mass=None)  # the CSV has them
        self.table.news = f"{Path(self.file.filepath).name} {news}."
        self.reload()
        return True
