"""The experiments on the page: their menu, the question before the release, and what happened after it."""

import json
from html import escape
from math import pi, radians, sin

from vpython import checkbox, menu, wtext

from support.cradle.prediction import Measurement
from support.files.experiments import Experiment, read_experiments, YOUR_CSV
from support.page.panel import add_label, change

LETTERS = "ABCDE"  # of the answers
NUMBERS = {"before": "largest speed before the first hit (m/s)", "speed": "largest speed after it (m/s)"}


class Questions:
    """The menu of experiments, and the present experiment with its question, if Predict first is ticked.

    From the release to the measurement, note takes the data of the run. Nothing is stored, and nobody gets a score.
    """

    def __init__(self, folder, cords):
        """Begin with your CSV; the folder has the experiments, cords is the number of cords of a pendulum."""
        self.experiments, self.mistakes = read_experiments(folder, cords)
        self.experiment: Experiment | None = None  # None stands for your CSV
        self.is_changed = False  # whether the cradle is no longer that of the experiment
        self.ask_first = False
        self.is_asking = False  # whether the cradle waits for an answer
        self.said: int | None = None  # the index of the answer
        self.votes: list[int] = []  # for each answer
        self.slowly = False  # whether this run is in slow motion, until its measurement is over
        self.again: tuple | None = None  # what was said, the votes, and slowly, for a run that repeats the last one
        self.measurement: Measurement | None = None

    def add_area(self) -> None:
        """Add the place of the question to the panel."""
        self.area = wtext()

    def add_menu(self, give) -> None:
        """Add the menu, the tick box, and a line for each mistake in a file of an experiment."""
        add_label("Experiment")
        choices = [YOUR_CSV, *(experiment.name for experiment in self.experiments)]
        self.menu = menu(choices=choices, selected=choices[0], bind=lambda menu: give("experiment", menu.index))
        self.box = checkbox(text="Predict first", bind=lambda box: give("ask first", box.checked))
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
        """Begin the present experiment, whose bobs are lifted now: ask, if Predict first is ticked."""
        again = self.again
        self.drop()
        if self.experiment and self.ask_first and not self.is_changed:
            self.is_asking, self.measurement = again is None, Measurement(self.experiment)
            self.said, self.votes, self.slowly = again or (None, [0] * len(self.experiment.answers), False)
            self.show()

    def repeat(self, slowly) -> None:
        """Let the next run be as this one, with the same answer, maybe in slow motion."""
        self.again = self.said, self.votes, slowly

    def drop(self) -> None:
        """Ask nothing, and measure nothing: the cradle is no longer that of an experiment."""
        self.is_asking, self.said, self.measurement = False, None, None
        self.slowly, self.again = False, None
        self.show()

    def leave(self) -> None:
        """Ask nothing, and show no name in the menu, so that you can choose the experiment again."""
        if self.experiment and not self.is_changed:
            self.is_changed = True
            self.menu.selected = None
        self.drop()

    def answer(self, question, number) -> bool:
        """Take this answer (its index, or None) to the question of this experiment (its key); False if it is over."""
        if not (number is None and self.is_asked(question, 0) or self.is_asked(question, number)):
            return False
        self.is_asking, self.said = False, number
        self.show()
        return True

    def is_asked(self, question, number) -> bool:
        """Return whether this question (a key) is asked now, and has this answer (an index)."""
        asked = self.experiment if self.is_asking else None
        return asked is not None and asked.key == question and number in range(len(asked.answers))

    def vote(self, question, number) -> None:
        """Count one more hand for this answer (its index) to the question of this experiment (its key)."""
        if self.is_asked(question, number):
            self.votes[number] += 1
            self.show()

    def skip(self) -> None:
        """Go on without an answer, if a question is asked."""
        self.answer(self.key(), None)

    def key(self) -> str:
        """Return the key of the present experiment; nothing for your CSV."""
        return self.experiment.key if self.experiment else ""

    def note(self, sample, has_hit) -> bool:
        """Measure a sample of Motion (has_hit: two bobs have hit by then); return whether the measurement ends now."""
        if not self.measurement or self.measurement.is_over:
            return False
        self.measurement.note(sample, has_hit)
        if self.measurement.is_over:
            self.show()
        return self.measurement.is_over

    def predicted(self, time) -> list[float]:
        """Return the angles (rad) that the answer predicts for this time (s): from the first hit on, along a sine."""
        measured = self.measurement
        if not (measured and self.experiment and self.said is not None and measured.hit_time < time <= measured.end):
            return []
        part = (time - measured.hit_time) / (measured.end - measured.hit_time)
        return [radians(swing) * sin(pi / 2 * part) for swing in self.experiment.answers[self.said].swings]

    def show(self) -> None:
        """Show the question with its answers, what was said, or what happened; and the sheet to print, hidden."""
        text = ""
        if self.measurement and self.experiment:
            sheet = sheet_text(self.experiment, self.measurement, self.said)
            text = question_text(self.experiment, self.measurement, self.is_asking, self.said, self.votes)
            text = f'<div class="question" role="status">{text}</div><div class="sheet">{sheet}</div>'
        change(self.area, text=text)


# --- texts, as HTML ---------------------------------------------------------------------------------------------------


def question_text(experiment, measured, is_asking, said, votes) -> str:
    """Return the question of an experiment and its answers, or what was said, and what happened."""
    lines = [f"<p><strong>{escape(experiment.question)}</strong></p>"]
    if is_asking:
        lines.append('<div class="answers">')
        for number, answer in enumerate(experiment.answers):
            words, value = f"{LETTERS[number]}&ensp;{escape(answer.text)}", [experiment.key, number]
            lines += [command_button(words, "answer", value), command_button(votes[number], "vote", value, "hands")]
        lines += ["</div>", command_button("Run it without an answer", "answer", [experiment.key, None], "plain")]
    else:
        hands = ", ".join(f"{letter} {count}" for letter, count in zip(LETTERS, votes, strict=False))
        said_text = "" if said is None else f"You said: {LETTERS[said]}, {escape(experiment.answers[said].text)}. "
        said_text += f"Hands: {hands}." if any(votes) else ""
        lines += [f"<p>{said_text.strip()}</p>"] if said_text else []
    if measured.is_over:
        lines.append(f"<p>{what_happened(experiment, measured, said)}</p>")
        lines += [command_button("Again", "again", False), command_button("Again slowly", "again", True)]
        lines.append(command_button("Next experiment", "next", None))
    lines.append('<button class="plain" onclick="print()">Print a sheet</button>')
    return "".join(lines)


def what_happened(experiment, measured, said) -> str:
    """Return what happened in an experiment, and why."""
    outcome = measured.outcome()
    if outcome is None:
        words = "What happened: none of these answers"
    else:
        words = f"What happened: {LETTERS[outcome]}, {escape(experiment.answers[outcome].text)}"
    words = "That is what happened" if said == outcome is not None else words
    return f"<strong>{words}.</strong> {escape(measured.explanation())}"


def sheet_text(experiment, measured, said) -> str:
    """Return a page to fill in (panel.js puts the picture into it), and after the measurement one with its figures."""
    name = escape(experiment.name)
    answers = "".join(f"<li>{escape(answer.text)}</li>" for answer in experiment.answers)
    pages = [
        f'<h1>{name}</h1><img alt="The cradle before its release"><p>{escape(experiment.question)}</p>'
        f'<ol type="A">{answers}</ol><p>My answer: ______ because</p><div>My sketch of the first swing:</div>'
        "<p>I measured: speed ____________ m/s, angle ____________ degrees</p>"
    ]
    if measured.is_over:
        numbers, bobs = measured.numbers(), range(1, len(measured.swings) + 1)
        rows = [["bob" if len(experiment.angles[0]) == 1 else "upper bob", *bobs]]
        rows += [[words, *(numbers[f"{kind}_{bob}"] for bob in bobs)] for kind, words in NUMBERS.items()]
        rows.append(["swung to (degrees)", *(f"{round(swing)}" for swing in measured.swings)])
        table = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
        pages.append(
            f"<h1>{name}: measured</h1><p>{what_happened(experiment, measured, said)}</p><table>{table}</table>"
        )
    return "".join(f"<article>{page}</article>" for page in pages)


def command_button(words, command, value, kind="") -> str:
    """Return a button, of this kind, that gives a command with this value."""
    call = escape(f"tell('{command}', {json.dumps(value)})")
    return f'<button class="{kind}" onclick="{call}">{words}</button>'
