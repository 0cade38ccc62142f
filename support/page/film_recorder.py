"""Write a run to an HTML file, without a tab: --html FILE."""

import sys
from math import inf

from support.cradle.cradle import Cradle
from support.cradle.player import run
from support.cradle.real_time import RealTime
from support.files.data_file import whole_file
from support.main_page import Loop
from support.page.server.film import Film
from support.page.server.run_file import run_as_html
from support.page.server.tabs import Tabs
from support.page.viewer import Start, Viewer
from support.start.early import stop_on_signals
from support.start.mistake import report_endless_loop, report_mistake
from support.start.output import complain, in_one_line, Progress, progress_bar, say


class NoTabs(Tabs):
    """No tab, but a film of all that is shown.

    Its time goes on only while the program rests: so each picture comes when it is due.
    """

    def __init__(self) -> None:
        self.now = 0.0  # s
        super().__init__(
            in_server=lambda function, *arguments: function(*arguments),
            film=Film(self.time, kept=inf),
        )
        self.is_seen.set()

    def time(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds

    def have_room(self) -> bool:
        return True


class FilmRecorder(Viewer):
    """Plays the first seconds of a cradle, as fast as the machine can."""

    def __init__(self, cradle: Cradle, start: Start, seconds: float, progress: Progress) -> None:
        """Play `seconds` (s), and call progress(done), 0 to 1, again and again."""
        tabs = NoTabs()
        super().__init__(cradle, start, tabs, RealTime(cradle.dt, tabs.time, tabs.sleep))
        self.last = max(1, round(seconds / cradle.dt))  # tick
        self.report_progress = progress
        self.questions.ask_first = True
        self.marks.has_arrows = True

    def frame(self) -> None:
        """Show the last ticks, with all numbers, and plan the next ones; nobody answers."""
        self.next_refresh = 0.0
        super().frame()
        if self.questions.measurement:
            self.questions.answer(self.questions.measurement.experiment.key, None)
        done = self.motion.ticks / self.last
        self.is_over = done == 1
        if done:
            self.report_progress(done)

    def keep_time(self, most: float = inf) -> None:
        super().keep_time(min(most, self.last - self.motion.ticks))


def write_run(loop: Loop, cradle: Cradle, start: Start, seconds: float, filepath: str) -> None:
    """Write the first seconds (s) of a loop to this HTML file.

    If a function makes a mistake, the run ends with it, and the exit status is 1; so it is, without
    a file, after a signal. Raises an OSError if the file cannot be written.
    """
    stop_on_signals()
    status = 0
    try:
        with whole_file(filepath) as html, progress_bar() as progress:
            recorder = FilmRecorder(cradle, start, seconds, progress)
            try:
                run(loop, recorder)
            except (Exception, SystemExit) as error:
                recorder.tabs.show({"ended": report_mistake(error)})
                status = 1
            html.write(run_as_html(recorder.tabs.pictures()).decode())
    except KeyboardInterrupt as stopped:
        report_endless_loop(stopped)
        complain(f"The run ended too early. {filepath} is not written.")
        sys.exit(1)
    if recorder.given_remark:
        say(recorder.given_remark)
    say(in_one_line(f"{recorder.motion.time():.15g} s are in {filepath}"))
    sys.exit(status)
