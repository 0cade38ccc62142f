"""How the time goes on: pause, Step, and the speed."""

from collections.abc import Callable

from support.cradle.cradle import Cradle
from support.cradle.real_time import FRAME, RealTime
from support.page.names import State
from support.page.questions import Questions, WAITS
from support.page.scene.slow_hits import SlowHits

SLOWLY = 0.1  # times real time: the speed of slow motion


class Playback:
    """Whether the time goes on, and how fast."""

    def __init__(
        self,
        cradle: Cradle,
        pace: RealTime,
        questions: Questions,
        slow_hits: SlowHits,
        plan: Callable[..., None],
    ):
        """Let the time go on; plan(ticks) plans the ticks of a frame, as that of a Player."""
        self.cradle = cradle
        self.pace = pace
        self.questions = questions
        self.slow_hits = slow_hits
        self.plan = plan
        self.is_paused = False
        self.speed = 1.0  # that you have set, times real time

    def is_running(self) -> bool:
        """Return whether the cradle is not paused, and waits for no answer."""
        return not (self.is_paused or self.questions.asking)

    def is_resting(self) -> bool:
        """Return whether the time rests, so that you can look at something longer."""
        return self.questions.rest_end is not None or self.slow_hits.current is not None

    def look_longer(self) -> None:
        """Go on with what the time rests for: a measured experiment, then one slow hit by one."""
        self.questions.end_rest_in_time()
        if self.questions.rest_end is None:
            self.slow_hits.go_on(self.pace.clock(), self.is_running())

    def speed_now(self) -> float:
        """Return the speed of the present run, times real time."""
        return SLOWLY if self.questions.slowly else self.speed

    def state(self) -> State:
        """Return what the page must know of the time."""
        return {"paused": self.is_paused, "running": self.is_running()}

    # --- commands ------------------------------------------------------------------------------

    def pause(self) -> None:
        """Stop the time, or let it go on; while a question is open, it stands."""
        if self.can_go_on():
            self.is_paused = not self.is_paused
            self.questions.end_rest()

    def can_go_on(self) -> bool:
        """Return whether no question is open; an open one waits for its answer, and says so."""
        if self.questions.asking:
            self.questions.word = WAITS
        return not self.questions.asking

    def do_step(self) -> None:
        """While paused, show the next one of slow hits; without one, do the ticks of a frame."""
        if not self.can_go_on() or self.is_running():
            return
        self.slow_hits.show_next(self.pace.clock())
        if not self.slow_hits.current:
            self.plan(round(FRAME * self.speed_now() / self.cradle.dt))

    def set_speed(self, speed: float) -> None:
        """Let the time go on at this speed, times real time, also if a run is in slow motion."""
        self.speed = speed
        self.questions.slowly = False
