"""Write a run to an HTML file, without a tab: --html FILE."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from math import inf
from typing import Any

from support.cradle.cradle import Cradle
from support.cradle.player import run
from support.cradle.real_time import RealTime
from support.files.cradle_csv import LiveFile
from support.files.data_file import require_replaceable, whole_file
from support.main_page import Loop
from support.page.film import Film
from support.page.run_file import FIRST_LINE, run_as_html
from support.page.tabs import Tabs
from support.page.viewer import Viewer
from support.start.mistake import report_endless_loop, report_mistake
from support.start.output import in_one_line, Progress, progress_bar, say


class FilmClock:
    """A clock that goes on only while the program rests: each picture comes at its time."""

    def __init__(self) -> None:
        self.now = 0.0  # s

    def time(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds


class NoTabs(Tabs):
    """No tab, but a film of all that is shown."""

    def __init__(self, clock: FilmClock) -> None:
        super().__init__()
        self.film = Film(clock.time, kept=inf)
        self.is_seen.set()

    def have_room(self) -> bool:
        return True


class Recorder(Viewer):
    """Plays the first seconds of a cradle, as fast as the machine can."""

    def __init__(
        self,
        clock: FilmClock,
        seconds: float,
        progress: Progress,
        cradle: Cradle,
        *arguments: Any,
    ) -> None:
        """Play `seconds` (s) of a cradle, and call progress(done), 0 to 1, again and again.

        The other arguments are those of a Viewer.
        """
        super().__init__(cradle, *arguments)
        self.pace = RealTime(cradle.dt, clock.time, clock.sleep)
        self.last = round(seconds / cradle.dt)  # tick
        self.progress = progress
        self.questions.ask_first = True
        self.marks.has_arrows = True

    def frame(self) -> None:
        """Show the last ticks, and plan the next ones; nobody answers the question."""
        super().frame()
        if self.questions.measurement:
            self.questions.answer(self.questions.measurement.experiment.key, None)
        done = self.motion.ticks / self.last
        self.is_over = done == 1 and not self.is_resting()
        if done:
            self.progress(done)

    def keep_time(self, most: float = inf) -> None:
        super().keep_time(min(most, self.last - self.motion.ticks))


def require_replaceable_run(filepath: str) -> None:
    """Raise a ValueError with a one-line message if this file is there, and is no saved run."""

    def is_run(line: bytes) -> bool:
        return line == FIRST_LINE.encode()

    require_replaceable("--html", filepath, is_run, "a run of a cradle")


def write_run(
    loop: Loop,
    cradle: Cradle,
    file: LiveFile,
    angles: Sequence[float | None],
    options: Namespace,
    remark: str,
) -> None:
    """Write options.seconds of a loop with this cradle to the file options.html.

    If a function makes a mistake, the run ends with it, and the exit status is 1. Raises an OSError
    if the file cannot be written.
    """
    clock = FilmClock()
    tabs = NoTabs(clock)
    status = 0
    with progress_bar() as progress:
        player = Recorder(
            clock, options.seconds, progress, cradle, file, angles, options.lift, tabs, remark
        )
        try:
            run(loop, player)
        except KeyboardInterrupt as stopped:
            report_endless_loop(stopped)
            return
        except BaseException as error:
            tabs.show({"ended": report_mistake(error)})
            status = 1
    with whole_file(options.html) as html:
        html.write(run_as_html(tabs))
    say(in_one_line(f"{player.motion.time():.15g} s are in {options.html}"))
    sys.exit(status)
