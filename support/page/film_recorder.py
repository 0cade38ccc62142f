"""Write films to HTML files, without a tab: --html FILE, and --html-all FOLDER."""

import sys
from collections.abc import Sequence
from html import escape
from math import inf
from pathlib import Path
from urllib.parse import quote

from support.cradle.cradle import Cradle
from support.cradle.player import Player, PLAYER_FILE, run_for_each_cradle
from support.cradle.real_time import RealTime
from support.files.data_file import whole_file
from support.files.experiments import Experiment, EXPERIMENTS
from support.page.lesson import EXPLAINED, FREE
from support.page.server.film import Film
from support.page.server.film_file import film_as_html
from support.page.server.tabs import Tabs
from support.page.viewer import FirstCradle, Viewer
from support.start.end import SignalError
from support.start.mistake import report_endless_loop, report_mistake
from support.start.output import complain, in_one_line, Progress, progress_bar, refuse
from support.start.preview import UnwrittenError

INDEX = """\
<!doctype html>
<html lang="en"><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
:root {{ font: 1.1rem/1.5 system-ui, sans-serif }}
body {{ max-width: 40rem; margin: 2rem auto; padding: 0 1rem }}
li {{ margin: 1rem 0 }}
</style>
<h1>{title}</h1>
<p>Open an experiment, predict, and see. Nothing is sent anywhere.</p>
<ol>
{links}
</ol>
"""


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


class FilmRecorder(Viewer):
    """Plays the first seconds of one cradle after another, as fast as the machine can."""

    def __init__(self, cradle: Cradle, first: FirstCradle, seconds: float) -> None:
        """Play `seconds` (s) of the cradle that first says."""
        tabs = NoTabs()
        super().__init__(cradle, first, tabs, RealTime(cradle.dt, tabs.time, tabs.sleep))
        self.last = max(1, round(seconds / cradle.dt))  # tick
        self.next_names: list[str] = []  # of experiments to play
        self.count = 1  # of all cradles to play
        self.films: list[bytes] = []  # as HTML
        self.report_progress: Progress = lambda done: None
        self.marks.has_arrows = True
        self.bars.is_on = True

    def play_experiments(self, names: Sequence[str]) -> None:
        """Play the experiments with these names, one after the other."""
        first, *self.next_names = names
        self.count = len(names)
        self.lesson.choose(first)

    def frame(self) -> None:
        """Show the last ticks, with all numbers, and plan the next ones; at the end, keep the film.

        Then go on to the next cradle. Where the lesson waits for an answer, go on at once: the file
        asks the person who opens it.
        """
        self.next_refresh = 0.0
        super().frame()
        self.lesson.skip_question()
        if self.lesson.state not in (FREE, EXPLAINED):
            return  # the first swing of a lesson: the run follows
        left = self.last - self.motion.ticks
        self.planned = min(self.planned, left)
        self.report_progress((len(self.films) + 1 - left / self.last) / self.count)
        if not left:
            self.films.append(film_as_html(self.tabs.pictures()))
            if self.next_names:
                self.lesson.choose(self.next_names.pop(0))
            else:
                self.is_over = True

    def show_new_cradle(self) -> None:
        """Show a new cradle; if it has a hidden value, show all that you need to find it."""
        self.lesson.run()
        self.marks.measures = bool(self.cradle.hidden)
        super().show_new_cradle()

    def go_on_after(self, error: BaseException | None) -> None:
        Player.go_on_after(self, error)  # nobody mends it here


def write_all_films(file: Path, recorder: FilmRecorder, folder: str) -> None:
    """Write the film of each experiment to an HTML file in this folder.

    index.html has links to them. The rest is as in write_films.
    """
    cradle = recorder.cradle
    experiments = recorder.chooser.experiments
    files = [str(Path(folder, f"{known.stem}.html")) for known in experiments.values()]
    index = str(Path(folder, "index.html"))
    if index in files:
        refuse("--html-all: allowed is another name than index for an experiment")
    for mistake in recorder.chooser.mistakes:
        complain(mistake)
    if not experiments:
        refuse(f"--html-all: there is no experiment in {EXPERIMENTS / cradle.kind}")
    Path(folder).mkdir(exist_ok=True)
    recorder.play_experiments([*experiments])
    write_films(file, recorder, files, folder)
    with whole_file(index) as page:
        page.write(index_of(cradle.title, [*experiments.values()]))


def write_films(file: Path, recorder: FilmRecorder, files: Sequence[str], place: str) -> None:
    """Write the films of a program to these HTML files; place names them all in a message.

    If a function makes a mistake, or after a signal, none is written, and the exit status is 1.
    Raises an OSError if a file cannot be written.
    """
    try:
        with progress_bar() as recorder.report_progress:
            run_for_each_cradle(file, recorder)
    except UnwrittenError as error:
        refuse(error)
    except (Exception, SystemExit) as error:
        if isinstance(error, SignalError):
            report_endless_loop(error, PLAYER_FILE)
        else:
            report_mistake(error, PLAYER_FILE)
        complain(f"{place} is not written.")
        sys.exit(1)
    for name, html in zip(files, recorder.films, strict=True):
        with whole_file(name) as film:
            film.write(html.decode())
    for remark in recorder.remarks:
        print(remark)
    seconds = f"{recorder.motion.time():.15g} s"
    of_each = f" of each of {len(files)} experiments" if len(files) > 1 else ""
    print(in_one_line(f"{seconds}{of_each} are in {place}"))


def index_of(title: str, experiments: Sequence[Experiment]) -> str:
    """Return a plain page with a link to the film of each experiment."""
    links = []
    for known in experiments:
        link = f'<a href="{quote(known.stem)}.html">{escape(known.name)}</a>'
        links.append(f"<li>{link}<br>{escape(known.question)}</li>")
    return INDEX.format(title=escape(title), links="\n".join(links))
