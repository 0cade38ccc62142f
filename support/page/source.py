"""The source of the viewer's cradle: your CSV, an experiment, or the table in which you change masses and e."""

from math import inf
from typing import NamedTuple

from support.files.cradle_csv import check_cradle, Snapshot
from support.files.experiments import EXPERIMENTS
from support.page.questions import Questions
from support.page.table import cells_of, Table, with_numbers


class Settings(NamedTuple):
    """The CSV of a cradle, and the settings that replace parts of it. None is as main makes it."""

    csv: Snapshot
    angles: list[float | None]  # rad
    lifted: int | None
    collision: str  # a key of the cradle's collisions
    mass: float | None  # kg


class Source:
    """Chooses the cradle that the viewer lets main make; nothing here writes a file.

    The methods that change the cradle end with viewer.want_cradle().
    """

    def __init__(self, viewer, file):
        """Begin with the CSV in this file (a LiveFile)."""
        self.viewer, self.cradle, self.file = viewer, viewer.cradle, file
        self.poses: list | None = None  # the angles of each pendulum at the release, if an experiment sets them
        self.own = self.settings()  # of your CSV, while an experiment is shown
        self.questions = Questions(EXPERIMENTS / self.cradle.kind, len(self.cradle.angle_keys))
        self.table = Table([*self.cradle.angle_keys, *self.cradle.rate_keys])

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
        """Show the pendula in the table, with the masses and e that they have now, if the table is open."""
        if self.table.is_open:
            self.table.show_rows(*cells_of(with_numbers(self.viewer.snapshot, self.present())))

    def present(self) -> dict[str, list]:
        """Return the masses (kg) and e that the pendula have now."""
        return {column: self.cradle.values(column) for column in ("mass", "e")}

    def edit(self, row_column_text) -> None:
        """Let main make the cradle with this number in a row and a column, or show why it is not allowed there."""
        row, column, text = row_column_text
        numbers = self.present()
        self.leave_experiment()
        if self.table.allows(row, column, text, numbers["mass"]):
            numbers[column][row] = float(text)
            self.viewer.snapshot = with_numbers(self.viewer.snapshot, numbers)
            self.cradle.mass, self.cradle.collision = None, next(iter(self.cradle.collisions))  # the CSV now has them
            self.viewer.want_cradle()
        else:
            self.show_rows()
