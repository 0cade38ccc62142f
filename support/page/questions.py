"""The experiments on the page: their menu, the question before the release, and what happened after it."""

import json
from html import escape

from vpython import checkbox, menu, wtext

from support.cradle.prediction import Measurement
from support.files.experiments import Experiment, read_experiments, YOUR_CSV
from support.page.panel import add_label, change

ASK_FIRST = "Ask first"
NOT_SAID = "Run it without an answer"


class Questions:
    """The menu of experiments, and the present experiment with its question, if Ask first is ticked.

    From the release to the measurement, note takes the data of the run. Nothing is stored, and nobody gets a score.
    """

    def __init__(self, folder, cords):
        """Begin with your CSV; you can choose an experiment in this folder in place of it.

        cords is the number of cords of a pendulum.
        """
        self.experiments, self.mistakes = read_experiments(folder, cords)
        self.experiment: Experiment | None = None  # None stands for your CSV
        self.is_changed = False  # whether the cradle is no longer that of the experiment
        self.ask_first = False
        self.is_asking = False  # whether the cradle waits for an answer
        self.said: int | None = None  # the index of the answer
        self.measurement: Measurement | None = None

    def add_area(self) -> None:
        """Add the place of the question to the panel."""
        self.area = wtext()

    def add_menu(self, give) -> None:
        """Add the menu, the tick box, and a line for each mistake in a file of an experiment."""
        add_label("Experiment")
        choices = [YOUR_CSV, *(experiment.name for experiment in self.experiments)]
        self.menu = menu(choices=choices, selected=choices[0], bind=lambda menu: give("experiment", menu.index))
        self.box = checkbox(text=ASK_FIRST, bind=lambda box: give("ask first", box.checked))
        for mistake in self.mistakes:
            wtext(text=f'<span class="failed">{escape(mistake)}</span>')

    def choose(self, place) -> Experiment | None:
        """Take the experiment in this place of the menu as the present one, and return it; 0 stands for your CSV."""
        self.experiment = self.experiments[place - 1] if place else None
        self.is_changed = False
        change(self.menu, index=place)
        self.drop()
        return self.experiment

    def begin(self) -> None:
        """Begin the present experiment, whose bobs are lifted now: ask, if Ask first is ticked."""
        self.drop()
        if self.experiment and self.ask_first and not self.is_changed:
            self.is_asking, self.measurement = True, Measurement(self.experiment)
            self.show()

    def drop(self) -> None:
        """Ask nothing, and measure nothing: the cradle is no longer that of an experiment."""
        self.is_asking, self.said, self.measurement = False, None, None
        self.show()

    def leave(self) -> None:
        """Ask nothing, and show no name in the menu, so that you can choose the experiment again."""
        if self.experiment and not self.is_changed:
            self.is_changed = True
            self.menu.selected = None
        self.drop()

    def answer(self, question, number) -> bool:
        """Take this answer (its index, or None for no answer) to the question of this experiment (its key).

        Return False, and do nothing, if this is not asked any more.
        """
        if not (self.is_asking and self.experiment and self.experiment.key == question):
            return False
        if number not in (None, *range(len(self.experiment.answers))):
            return False
        self.is_asking, self.said = False, number
        self.show()
        return True

    def skip(self) -> None:
        """Go on without an answer, if a question is asked."""
        if self.experiment:
            self.answer(self.experiment.key, None)

    def note(self, sample, has_hit) -> None:
        """Measure a sample of Motion; has_hit says whether two bobs have hit each other by then."""
        if self.measurement:
            self.measurement.note(sample, has_hit)
            if self.measurement.is_over:
                self.show()

    def show(self) -> None:
        """Show the question with its answers, what was said, or what happened."""
        lines = []
        if self.measurement and self.experiment:
            lines.append(f"<p><strong>{escape(self.experiment.question)}</strong></p>")
            if self.is_asking:
                texts = [answer.text for answer in self.experiment.answers]
                lines += [answer_button(self.experiment.key, number, text) for number, text in enumerate(texts)]
                lines.append(answer_button(self.experiment.key, None, NOT_SAID))
            elif self.said is not None:
                lines.append(f"<p>You said: {escape(self.experiment.answers[self.said].text)}.</p>")
            if self.measurement.is_over:
                outcome = self.measurement.outcome()
                happened = "none of these answers" if outcome is None else self.experiment.answers[outcome].text
                is_right = self.said == outcome is not None
                words = "That is what happened" if is_right else f"What happened: {escape(happened)}"
                lines.append(f"<p><strong>{words}.</strong> {escape(self.measurement.explanation())}</p>")
        text = "".join(lines)
        change(self.area, text=f'<div class="question" role="status">{text}</div>' if text else "")


def answer_button(question, number, text) -> str:
    """Return the HTML of a button that gives this answer (its index, or None) to the question with this key."""
    command = f"tell('answer', {json.dumps([question, number])})"
    kind = ' class="plain"' if number is None else ""
    return f'<button{kind} onclick="{escape(command)}">{escape(text)}</button>'
