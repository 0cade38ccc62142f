"""What the program makes the cradle from: your CSV with your settings, or an experiment."""

from collections.abc import Callable

from support.cradle.cradle import Cradle
from support.cradle.settings import NextCradle, Settings, settings_of
from support.files.cradle_csv import LiveFile
from support.files.data_file import has_written
from support.files.experiments import Experiment, EXPERIMENTS, read_experiments, YOUR_CSV
from support.files.valid_cradle import CradleCsv, read_cradle
from support.page.gallery import gallery_picture
from support.page.names import State

# After a mistake in your CSV, for instance "... allowed is a number from 0 to 1, such as 0.9"
STILL_THERE = "The page still shows the cradle as it was before. Mend the file, and save it."


class Chooser:
    """Chooses the next cradle, and keeps the settings of your CSV during an experiment.

    It writes no file.
    """

    def __init__(
        self,
        cradle: Cradle,
        next_cradle: NextCradle,
        file: LiveFile,
        prepare: Callable[[CradleCsv], CradleCsv],
        experiment: Experiment | None = None,
    ):
        """Begin with your CSV, which is in this file, or with an experiment of your own.

        prepare(csv) returns a CSV with what the options say.
        """
        self.next_cradle = next_cradle
        self.file = file
        self.prepare = prepare
        self.cords = cradle.cord_count
        self.first = next_cradle.settings  # of your CSV as it is in the file, with the options
        self.yours = self.first  # with your changes on the page
        self.error = ""  # the mistake in it
        folder = EXPERIMENTS / cradle.kind
        self.experiments, self.mistakes = read_experiments(folder, self.cords)
        self.experiment: Experiment | None = None  # None stands for your CSV
        self.is_changed = False  # whether the cradle is no longer that of the experiment
        if experiment:  # maybe in place of one with its name
            self.experiments[experiment.name] = experiment
            self.choose(experiment.name)
        self.pictures = {}
        self.sheets = []
        for name, known in self.experiments.items():
            self.pictures[name] = gallery_picture(known.csv, known.poses, known.hidden)
            if known.question:
                self.sheets.append((name, known.question, [text for text, _ in known.answers]))

    def names(self) -> list[str]:
        return [YOUR_CSV, *self.experiments]

    def name(self) -> str:
        return self.experiment.name if self.experiment else YOUR_CSV

    def leave_experiment(self) -> None:
        """Note that the cradle is no longer that of the experiment, if there is one."""
        self.is_changed = self.experiment is not None

    def choose(self, name: str) -> None:
        """Let the program make an experiment with this name, or your CSV with its settings.

        If your CSV is chosen already, it is as at the start.
        """
        is_again = name == self.name()
        if not self.experiment:
            self.yours = self.next_cradle.settings
        self.experiment = self.experiments.get(name)
        self.is_changed = False
        is_as_you_left_it = not (self.experiment or is_again)
        self.next_cradle.settings = self.yours if is_as_you_left_it else self.unchanged()
        self.next_cradle.want()

    def look_at_file(self) -> None:
        """Choose your CSV again if you have saved it.

        If it has a mistake, keep the message, and let the old cradle swing on. The old cradle also
        swings on if the program itself has written the file.
        """
        if not self.file.changed():
            return
        self.error = ""
        try:
            csv = self.prepare(read_cradle(self.file.current))
        except ValueError as error:
            self.error = f"{error}. {STILL_THERE}"
            return
        is_shown = self.next_cradle.settings.csv == self.first.csv
        self.first = self.first._replace(csv=csv)
        if not has_written(self.file.filepath):
            if self.experiment:
                self.choose(YOUR_CSV)
            self.next_cradle.want(csv=csv)
        elif is_shown:
            self.next_cradle.settings = self.next_cradle.settings._replace(csv=csv)

    def unchanged(self) -> Settings:
        """Return the settings of your choice, without your changes on the page."""
        return settings_of(self.experiment) if self.experiment else self.first

    def state(self) -> State:
        csv = self.first.csv
        at_rest = [[0.0] * self.cords] * len(csv.pendula)
        return {
            "error": self.error,
            "mistakes": self.mistakes,
            "pictures": {YOUR_CSV: gallery_picture(csv, at_rest)} | self.pictures,
            "changed": self.is_changed or self.next_cradle.settings != self.unchanged(),
            "sheets": self.sheets,
        }
