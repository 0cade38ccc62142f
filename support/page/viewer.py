"""The viewer: plays a cradle in step with the clock, and carries out your commands on the page."""

import time
from collections.abc import Callable
from math import inf
from queue import SimpleQueue

from vpython import baseObj, scene

from support.cradle.cradle import Cradle
from support.cradle.dragging import bob_at, point_in_plane
from support.cradle.player import Player
from support.cradle.real_time import FRAME
from support.files.data_file import EVERY
from support.page.marks import Marks
from support.page.motion_graph import MotionGraph
from support.page.panel import change, Panel, TRAINS
from support.page.questions import LETTERS
from support.page.scenery import Scenery
from support.page.slow_hits import SlowHits
from support.page.source import Source

REFRESH = 0.1  # s between two changes of the numbers and the graph
QUIET = 0.01  # m/s: a hit makes no sound up to this speed; bobs that rest on each other meet again in each tick
SLOWLY = 0.1  # times real time: the speed of an experiment that is repeated slowly
HIT_LINES = 5  # of text, above the cradle
REST = 3.0  # s that the picture rests when an experiment has been measured
GOODBYE = 10.0  # s that the page has to fetch the last message

# The commands of the keys, with their values; the names of the keys are VPython's.
COMMANDS_OF_KEYS = {
    " ": ("pause", None),
    "right": ("step", None),
    "r": ("restart", None),
    "v": ("view", None),
    "n": ("next", None),
    "h": ("slow hits", None),
    **{letter.lower(): ("say", number) for number, letter in enumerate(LETTERS)},
    **{str(count): ("lift", count) for count in range(1, 10)},
}


class Viewer(Player):
    """The page with a cradle, its panel and its graph: the argument page of main."""

    def __init__(self, cradle: Cradle, file, angles, lifted, remark=""):
        """Build the page for the cradle of this file (a LiveFile), with the remark, if there is one.

        angles (rad) are the release angles, lifted is the number of bobs to lift. None keeps the value with which main
        makes the cradle.
        """
        super().__init__(cradle, file.current, angles, lifted, TRAINS, EVERY)
        self.commands: SimpleQueue = SimpleQueue()
        self.running = True
        self.is_new_page = True  # whether the page has nothing of the cradle yet
        self.next_refresh = -inf
        self.sound = False
        self.speed = 1.0  # that you have set, times real time
        self.rest_end = -inf  # the time on the pace's clock until which the picture rests
        self.one_tick: dict[str, float] | None = None  # the coordinates before it, while One tick is carried out

        self.source = Source(self, file)
        self.table, self.questions = self.source.table, self.source.questions
        self.actions = self.make_actions()
        self.scenery, self.marks, self.slow_hits = Scenery(), Marks(), SlowHits(cradle)
        self.panel = Panel(self.give, cradle, self.questions, self.table, remark)
        self.panel.separating.checked = self.separating
        self.graph = MotionGraph(cradle.angle_keys, cradle.rate_keys)
        self.listen_to_you()

    # --- frames ------------------------------------------------------------------------------------------------------

    def frame(self) -> None:
        """Do the work of one frame: show the last ticks, rest, carry out commands, and plan the next ticks."""
        self.show_frame()
        self.pace.rest()
        while not (self.commands.empty() or self.is_wanted or self.planned):
            action, value = self.commands.get()
            action(value)
            if not self.is_wanted:
                self.show_settings()
        if not self.is_wanted and self.source.file.changed():
            self.source.reload()
        if self.hold_if_due() or not self.running:
            self.pace.restart()
        elif not (self.is_wanted or self.planned):
            self.keep_time()

    def hold_if_due(self) -> bool:
        """Go on with slow hits and slow runs; return whether the time holds, also after an experiment is measured."""
        now = self.pace.clock()
        if self.questions.slowly and -inf < self.rest_end <= now:
            self.questions.slowly, self.pace.speed = False, self.speed
            self.show_settings()
        return now < self.rest_end or self.slow_hits.go_on(now if self.running else -inf)

    def show_frame(self) -> None:
        """Show the result of the last ticks: view, marks, sound, numbers and graph."""
        if self.cradle.hand.held is not None:
            self.motion.set_start()
        self.scenery.keep_in_view(self.cradle.bobs())
        change(self.panel.view, disabled=not self.scenery.bring_camera_back())  # panel.css hides it then
        shown = self.slow_hits.shown
        self.marks.show_arrows(shown.pendula if shown else self.cradle.pend_list)
        self.marks.show_halos((shown.hit.left, shown.hit.right) if shown else ())
        self.marks.show_ghosts(self.questions.predicted(self.motion.time()))
        change(self.panel.hit_words, text=self.slow_hits.words())
        fastest = self.motion.pop_fastest()
        if self.sound and fastest > QUIET:
            self.panel.hit.text = f'<i class="hit" data-speed="{fastest:.4f}"></i>'
        if self.pace.clock() >= self.next_refresh:
            self.next_refresh = self.pace.clock() + REFRESH
            self.show_motion()

    def show_new_cradle(self) -> None:
        """Show a new cradle. On a new page, it starts when the page has it, so that you see the release."""
        self.rest_end = -inf
        self.source.pose()
        self.slow_hits.clear()
        self.pace.speed = SLOWLY if self.questions.slowly else self.speed
        masses = self.cradle.values("mass")
        self.scenery.surround(self.cradle.axles(), self.cradle.bobs(), self.cradle.reach, masses)
        self.marks.surround(self.cradle, self.scenery.bottom())
        self.graph.begin([pend["objects"][1].color for pend in self.cradle.pend_list])
        self.note()
        change(self.table.before_and_after, text="")
        self.source.show_rows()
        self.show_settings()
        if self.is_new_page:
            self.is_new_page = False
            self.wait_for_page()
            self.pace.restart()

    def note(self) -> None:
        """Add this moment to the graph, and to the measurement of an experiment."""
        sample = self.motion.sample()
        self.graph.add(sample)
        if self.questions.note(sample, self.motion.has_hit()):
            self.rest_end, self.planned = self.pace.clock() + REST, 0

    def end_part(self) -> None:
        """Look at the result of a part; show One tick, or its hits."""
        super().end_part()
        if self.looks_at_hits:
            self.slow_hits.add(self.cradle.hits.kept, self.motion.time())
            self.planned *= not self.slow_hits.waiting
        if self.one_tick is not None:
            calls = self.cradle.hits.calls or [f"{self.cradle.names.shown} was not called."]
            self.table.show_tick(self.cradle.dt, self.one_tick, self.cradle.coordinates(), calls)
            self.one_tick = None

    def wait_for_page(self, patience=inf) -> None:
        """Wait until the page has all changes (VPython empties its list, then sends), but at most patience (s)."""
        begin = time.monotonic()
        while not (baseObj.empty() and baseObj.sent) and time.monotonic() - begin < patience:
            time.sleep(FRAME)

    def end(self, words) -> None:
        """Show on the page that the program has ended, and why; wait a moment until the page has the message."""
        self.panel.show_end(words)
        self.wait_for_page(GOODBYE)

    # --- commands ----------------------------------------------------------------------------------------------------

    # VPython calls the function of a widget, a key or the mouse in a thread of its own, in the middle of a tick.

    def give(self, command, value=None) -> None:
        """Put a command, one of make_actions, into the queue for the next frame; any thread can call this."""
        self.commands.put((self.actions[command], value))

    def listen_to_you(self) -> None:
        """Turn the keys and the mouse into commands."""

        def press(event):
            if event.key.lower() in COMMANDS_OF_KEYS and not (event.ctrl or event.alt):
                self.give(*COMMANDS_OF_KEYS[event.key.lower()])

        def ray(event):  # of the mouse: a point on it, and its direction
            return event.pos, scene.mouse.ray

        scene.bind("keydown", press)
        scene.bind("mousedown", lambda event: self.give("grab", ray(event)))
        scene.bind("mousemove", lambda event: self.give("drag", ray(event)))
        scene.bind("mouseup", lambda: self.give("let go"))
        scene.bind("resize", lambda: self.give("resize"))

    def make_actions(self) -> dict[str, Callable]:
        """Return all commands: for each one, the function that carries it out with the command's value."""
        return {
            "pause": self.pause,
            "step": self.do_step,
            "tick": self.do_one_tick,
            "restart": lambda _: self.want_cradle(),
            "speed": self.set_speed,
            "arrows": self.show_arrows,
            "slow hits": self.slow_down_hits,
            "sound": lambda sound: setattr(self, "sound", sound),
            "graph": lambda choice: self.graph.show(choice),
            "span": lambda span: setattr(self.graph, "span", span),
            "resize": lambda _: self.scenery.point_camera(),
            "view": lambda _: self.scenery.reset_view(),
            "show again": self.show_again,
            "grab": self.grab,
            "drag": self.drag,
            "let go": self.let_go,
            "angle": self.source.set_angle,
            "lift": self.source.set_lifted,
            "collisions": self.source.set_collision,
            "separating": self.source.set_separating,
            "experiment": self.source.choose,
            "ask first": self.source.ask_first,
            "answer": self.source.answer,
            "say": lambda number: self.source.answer((self.questions.key(), number)),
            "vote": lambda vote: self.questions.vote(*vote),
            "again": self.source.repeat,
            "next": lambda _: self.source.choose_next(),
            "table": self.source.open_table,
            "edit": self.source.edit,
        }

    def pause(self, _) -> None:
        """Stop the time, or let it go on; an open question then has no answer."""
        self.running, self.rest_end = not self.running, -inf
        self.questions.skip()

    def do_step(self, _) -> None:
        """Do the ticks of one frame, while paused, or show the next one of slow hits."""
        if not self.running and (self.slow_hits.shown or self.slow_hits.waiting):
            self.slow_hits.until = -inf
            self.slow_hits.go_on(self.pace.clock())
        elif not self.running:
            self.questions.skip()
            self.plan(round(FRAME * self.pace.speed / self.cradle.dt))

    def set_speed(self, speed) -> None:
        """Let the time go on at this speed, times real time."""
        self.speed = self.pace.speed = speed

    def show_arrows(self, shown) -> None:
        """Show arrows and bars, or not."""
        self.marks.has_arrows = shown
        self.marks.place_arrows()
        self.leave_space()

    def leave_space(self) -> None:
        """Let the view leave space for the bars, and for the words about a hit."""
        self.scenery.leave_space(self.marks.depth(), HIT_LINES * self.looks_at_hits)

    def slow_down_hits(self, slow) -> None:
        """Show the hits slowly, or not; None stands for the other way than now."""
        self.looks_at_hits = not self.looks_at_hits if slow is None else slow
        self.panel.slow_hits.checked = self.looks_at_hits
        self.slow_hits.clear()
        self.leave_space()

    def do_one_tick(self, _) -> None:
        """Do one tick, while paused, and show its effect on each pendulum, and the collisions in it."""
        if not self.running:
            self.questions.skip()
            self.one_tick = self.cradle.coordinates()
            self.plan(1, with_calls=True)

    def show_again(self, _) -> None:
        """Send a page that was loaded again all that it needs, and restart the cradle."""
        self.panel.send_again()
        self.table.open(False)
        self.scenery.reset_view()
        self.is_new_page = True
        self.want_cradle()

    def grab(self, ray) -> None:
        """Hold the bob under the mouse, if there is one; ray is the mouse's: a point on it, and its direction."""
        bob = bob_at(self.cradle.bobs(), *ray)
        if bob is not None:
            self.cradle.hand.hold(bob)
            self.source.leave_experiment()

    def drag(self, ray) -> None:
        """Drag the held bob, if there is one, to the mouse's ray."""
        point = point_in_plane(*ray)
        if self.cradle.hand.held is not None and point is not None:
            self.cradle.hand.drag(point.x, point.y)

    def let_go(self, _) -> None:
        """Let the held bob, if there is one, swing on."""
        if self.cradle.hand.held is not None:
            self.cradle.hand.held = None
            self.motion.set_start()
            self.marks.surround(self.cradle, self.scenery.bottom())
            self.slow_hits.clear()

    # --- texts and numbers -------------------------------------------------------------------------------------------

    def show_settings(self) -> None:
        """Show the present settings."""
        made_angles, made_lifted = self.cradle.as_made
        angles = [made if angle is None else angle for angle, made in zip(self.angles, made_angles, strict=True)]
        count = len(self.cradle.pend_list)
        lifted = made_lifted if self.lifted is None else min(self.lifted, count)
        self.panel.show_settings(self.running, self.pace.speed, angles, lifted, count, self.cradle.collision)
        self.panel.show_graphs(self.graph.choices, self.graph.choice)

    def show_motion(self) -> None:
        """Show time, energy, momentum, impacts and graph."""
        energy = self.motion.percents()["energy"]
        self.panel.show_motion(self.motion.time(), energy, self.cradle.momentum(), self.pace.remark())
        self.panel.show_impacts(self.motion.trains.lines())
        self.graph.draw(self.motion.start_energy)
        if self.table.is_open:
            self.table.show_now(self.cradle.coordinates())
