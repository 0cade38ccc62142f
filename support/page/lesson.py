"""The experiments as a class goes through them: choose one, predict, see, and see it again."""

from support.cradle.motion import Motion
from support.cradle.settings import NextCradle
from support.page.chooser import Chooser
from support.page.playback import Playback
from support.page.questions import Questions


class Lesson:
    """Chooses experiments, and asks their questions."""

    def __init__(
        self,
        chooser: Chooser,
        next_cradle: NextCradle,
        questions: Questions,
        playback: Playback,
    ):
        self.chooser = chooser
        self.next_cradle = next_cradle
        self.questions = questions
        self.playback = playback

    def choose(self, name: str) -> None:
        """Let the program make the cradle with this name; an experiment runs at once.

        One with a hidden value waits: its first hit is the clearest.
        """
        self.chooser.choose(name)
        self.questions.word = ""
        if self.chooser.experiment:
            self.playback.is_paused = self.chooser.experiment.hidden is not None

    def choose_next(self) -> None:
        """Choose the next experiment, after the last one the first."""
        self.choose(self.chooser.next_name())

    def choose_previous(self) -> None:
        """Choose the experiment before this one, before the first one the last."""
        self.choose(self.chooser.previous_name())

    def set_ask_first(self, asks: bool) -> None:
        """Ask for a prediction before the release, or not; restart an experiment."""
        self.questions.ask_first = asks
        self.questions.word = ""
        if self.chooser.whole_experiment():
            self.run_again()

    def set_ask_seen(self, asks: bool) -> None:
        """Ask what you have seen, or not, also in this run."""
        self.questions.ask_seen = asks
        if not asks:
            self.questions.leave_seen()

    def repeat(self, slowly: bool) -> None:
        """Run the experiment again with the same answer, maybe slowly."""
        measurement = self.questions.measurement
        if measurement and measurement.is_over:
            self.questions.repeat(slowly)
            self.run_again()

    def run_again(self) -> None:
        self.playback.is_paused = False
        self.next_cradle.want()

    def begin(self, motion: Motion) -> None:
        """Begin with a new cradle of this Motion: ask the question of its experiment, if you want.

        The program may have read another file, with another number of pendula.
        """
        experiment = self.chooser.whole_experiment()
        if experiment and len(experiment.poses) != len(motion.cradle.pend_list):
            experiment = None
        self.questions.begin(experiment, motion)
        if self.questions.asking:
            self.playback.is_paused = False  # so the cradle runs when the question is over
