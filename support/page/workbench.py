"""The part of the viewer that decides what the cradle is made from: your CSV, an experiment, or the edited table."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from support.files.atomic_write import whole_file
from support.files.cradle_csv import check_cradle, clean_copy, MOST_PENDULA, Snapshot, WHY_NOT_MORE
from support.files.edited_csv import cells_of, have_same_pendula, with_cell, with_numbers, with_row, without_row
from support.files.experiments import EXPERIMENTS
from support.page.commands import Command
from support.page.panel import Panel
from support.page.questions import Questions
from support.page.table import Table
from support.playback.player import Player

# The commands that the workbench carries out.
OF_BENCH = (
    *(Command.ANGLE, Command.LIFT, Command.COLLISIONS, Command.EXPERIMENT, Command.ASK_FIRST),
    *(Command.TABLE, Command.EDIT, Command.ADD, Command.DELETE, Command.WRITE),
)


class Settings(NamedTuple):
    """What a cradle is made from: its CSV, and the settings that replace parts of it. None is as main makes it."""

    csv: Snapshot
    angles: list[float | None]  # rad
    lifted: int | None
    collision: str  # a key of the cradle's collisions
    mass: float | None  # kg


class Workbench(Player):
    """Plays the cradle of your CSV, of an experiment, or of the table; your file changes only if you write it."""

    panel: Panel  # a subclass makes it
    running: bool

    def __init__(self, cradle, file, angles, lifted, impacts):
        """Begin with the cradle of this file (a LiveFile); the other parameters are those of Player."""
        super().__init__(cradle, file.current, angles, lifted, impacts)
        self.file = file
        self.poses: list | None = None  # the angles of each pendulum at the release, if an experiment sets them
        self.own = self.settings()  # of your CSV, while an experiment is shown
        self.questions = Questions(EXPERIMENTS / cradle.kind, len(cradle.angle_keys))
        self.table = Table([*cradle.angle_keys, *cradle.rate_keys], file.filepath)

    def work(self, command, value):
        """Carry out one of the commands in OF_BENCH."""
        match command:
            case Command.ANGLE:
                self.leave_poses()
                number, angle = value
                self.angles[number] = angle
                yield from self.make()
            case Command.LIFT:
                self.leave_poses()
                self.lifted = value
                yield from self.make()
            case Command.EXPERIMENT:
                yield from self.choose(value)
            case Command.ASK_FIRST:
                self.questions.ask_first = value
                if self.poses and not self.questions.is_changed:
                    self.running = True
                    yield from self.make()
            case Command.COLLISIONS:
                self.leave_experiment()
                self.collide(value)
                self.show_rows()
            case Command.TABLE:
                self.table.open(value)
                self.show_rows()
            case Command.WRITE:
                yield from self.write()
            case _:
                yield from self.edit(command, value)

    def take(self, csv):
        """Let main make the cradle of this CSV (a Snapshot)."""
        self.snapshot = csv
        self.table.mistakes.clear()
        self.try_single_ticks()
        yield from self.make()

    def try_single_ticks(self) -> None:
        """Measure again whether the machine is fast enough for single ticks."""
        self.at_once = False
        self.pace.forget_costs()

    # --- experiments -------------------------------------------------------------------------------------------------

    def begin_with(self, key) -> None:
        """Take the experiment with this key at the start; release angles of the command replace those it has."""
        keys = [experiment.key for experiment in self.questions.experiments]
        experiment = self.questions.experiments[keys.index(key)]
        self.questions.choose(keys.index(key))
        self.snapshot = experiment.csv
        if self.lifted is None and all(angle is None for angle in self.angles):
            self.poses = experiment.angles

    def settings(self) -> Settings:
        """Return the present settings of the cradle."""
        return Settings(self.snapshot, list(self.angles), self.lifted, self.cradle.collision, self.cradle.mass)

    def choose(self, number):
        """Let main make the cradle of this experiment (its index), or (None) that of your CSV, with its settings."""
        if not self.questions.experiment:
            self.own = self.settings()
        self.running = self.running or self.questions.is_asking or number is not None
        experiment = self.questions.choose(number)
        if experiment:
            as_in_csv = next(iter(self.cradle.collisions))
            chosen = Settings(experiment.csv, [None] * len(self.angles), None, as_in_csv, None)
        else:
            chosen = self.own
        csv, self.angles, self.lifted, self.cradle.collision, self.cradle.mass = chosen
        self.poses = experiment.angles if experiment else None
        self.panel.show_collision(self.cradle.collision)
        yield from self.take(csv)

    def pose(self) -> None:
        """Lift the bobs as the present experiment says, and ask its question, if it is to be asked first."""
        if not self.poses or len(self.poses) != len(self.cradle.masses()):  # main may read another file
            return
        self.cradle.pose(self.poses)
        self.motion.set_start()
        self.questions.begin()
        self.running = self.running and not self.questions.is_asking

    def leave_poses(self) -> None:
        """Lift the bobs as the sliders say, no more as an experiment says."""
        if self.poses:
            angles, self.lifted = self.cradle.as_made()
            self.angles, self.poses = list(angles), None
        self.leave_experiment()

    def leave_experiment(self) -> None:
        """Measure nothing any more: the cradle is no longer that of the experiment. If it was waiting, it runs."""
        self.running = self.running or self.questions.is_asking
        self.questions.leave()

    # --- the table ---------------------------------------------------------------------------------------------------

    def present_csv(self):
        """Return the CSV (a Snapshot) of the present pendula: with the masses and e that they have now."""
        csv = with_numbers(self.snapshot, "mass", self.cradle.masses())
        return with_numbers(csv, "e", self.cradle.restitutions())

    def edit(self, command, value):
        """Change the CSV in memory, and let main make its cradle; or show why a cell cannot have this text.

        The last pendulum stays, there are at most MOST_PENDULA, and nothing happens to a row that is no longer there:
        you may click faster than the page shows the new table.
        """
        csv = self.present_csv()
        rows = range(len(cells_of(csv)[1]))
        self.leave_experiment()
        match command:
            case Command.ADD if len(rows) < MOST_PENDULA:
                csv = with_row(csv)
            case Command.DELETE if value in rows and len(rows) > 1:
                csv = without_row(csv, value)
            case Command.EDIT if value[0] in rows and self.table.allows(csv, *value):
                csv = with_cell(csv, *value)
            case _:
                if command is Command.ADD:
                    self.table.show_written(f"Add a pendulum: {WHY_NOT_MORE}", failed=True)
                self.show_rows()
                return
        if command is not Command.EDIT:
            self.leave_poses()
            self.table.mistakes.clear()
        self.cradle.mass, self.cradle.collision = None, next(iter(self.cradle.collisions))  # the CSV now has them
        self.panel.show_collision(self.cradle.collision)
        self.snapshot = csv
        yield from self.make()

    def write(self):
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
            with whole_file(self.file.filepath) as file:
                file.write(written.data.decode("utf-8-sig"))
        except OSError as error:
            self.table.show_written(f"{error.filename or self.file.filepath}: {error.strerror}", failed=True)
        except Exception as error:  # of a student's function
            self.table.show_written(f"{type(error).__name__}: {' '.join(str(error).split())}", failed=True)
        else:
            self.file.look_now()
            self.own = self.own._replace(collision=next(iter(self.cradle.collisions)), mass=None)  # the CSV has them
            yield from self.reload()
            self.table.show_written(f"{self.file.filepath} has these pendula now.")

    def reload(self):
        """Let main make the cradle of the new file, or show the mistake in the file; the old cradle then swings on."""
        try:
            check_cradle(self.file.current, len(self.cradle.angle_keys))
        except ValueError as error:
            self.panel.show_error(str(error))
            return
        self.panel.show_error("")
        if self.questions.experiment:
            self.own = self.own._replace(csv=self.file.current)
            yield from self.choose(None)
        else:
            yield from self.take(self.file.current)

    def show_one_tick(self):
        """Do one tick, and show what it did to each pendulum, and the collisions in it."""
        before = self.cradle.coordinates()
        with self.cradle.noting_calls() as calls:
            yield from self.advance(1)
        calls = calls or [f"{self.cradle.collider} was not called."]
        self.table.show_tick(self.cradle.dt, before, self.cradle.coordinates(), calls)

    def show_rows(self) -> None:
        """Show the pendula in the table, if it is open."""
        if self.table.is_open:
            self.table.show_rows(*cells_of(self.present_csv()))
