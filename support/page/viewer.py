"""The viewer: plays a cradle in step with the clock, carries out the commands of the page, and says
what it shows.
"""

from collections.abc import Callable
from functools import partial
from math import inf
from queue import SimpleQueue

from vpython import vector

from support.cradle.cradle import Cradle
from support.cradle.dragging import bob_at, point_in_plane
from support.cradle.player import Player
from support.cradle.real_time import FRAME
from support.files.data_file import EVERY
from support.page.chooser import Chooser, Settings
from support.page.endless import Watch
from support.page.graph import Graph, SPANS
from support.page.questions import Questions
from support.page.scene.marks import Marks
from support.page.scene.scenery import Scenery
from support.page.scene.slow_hits import SlowHits
from support.pendulum import angle_to_outwards, outwards_to_angle

REFRESH = 0.1  # s between two changes of the state
# m/s: a hit makes no sound up to this speed; bobs that rest on each other meet again in each tick
QUIET = 0.01
# Times real time: the ends of the slider, and of an experiment repeated slowly
SPEEDS = (0.1, 2.0)
SLOWLY = 0.1
TRAINS = 5  # of impacts, a line for each
HIT_LINES = 5  # of text, above the cradle
LOOKS_A_SWING = 1000  # of a measurement, in the time of a small swing
REST = 3.0  # s that the picture rests when an experiment has been measured


class Viewer(Player):
    """The page with a cradle, its panel and its graph: the argument page of main."""

    def __init__(self, cradle: Cradle, file, angles, lifted, tabs, remark="", **texts):
        """Play the cradle of this file (a LiveFile) as a Player does; tabs (a Tabs) show it, and
        texts in the state.
        """
        super().__init__(cradle, file.current, angles, lifted, TRAINS, EVERY)
        self.file, self.tabs, self.remark, self.texts = file, tabs, remark, texts
        # Of tabs, for the next frame; any thread can put one into it
        self.commands: SimpleQueue = SimpleQueue()
        self.running = True
        self.speed = 1.0  # that you have set, times real time
        # On the pace's clock; until rest_end, the picture rests
        self.next_refresh = self.rest_end = -inf
        # The coordinates before One tick, while it is carried out
        self.before: dict[str, float] | None = None
        self.tick_lines: list[str] = []  # what One tick has done
        # The number of pictures with a hit to hear, and the speed (m/s) of the last one's fastest
        self.sounds = 0, 0.0
        self.error = ""  # the mistake in your CSV

        settings = Settings(file.current, list(angles), lifted, cradle.collision, cradle.mass)
        self.chooser, self.questions = Chooser(settings, cradle), Questions()
        self.scenery, self.marks, self.slow_hits = Scenery(), Marks(), SlowHits(cradle)
        self.graph = Graph(cradle.angle_keys, cradle.rate_keys)
        self.kinds, self.actions = self.make_kinds(), self.make_actions()
        tabs.give = lambda command, *values: self.commands.put((command, values))
        tabs.endless = Watch(self).look

    def frame(self) -> None:
        """Do the work of one frame: show the last ticks, rest, carry out commands, and plan the
        next ticks.
        """
        self.show_frame()
        self.pace.rest()
        while not (self.commands.empty() or self.is_wanted or self.planned):
            self.carry_out(*self.commands.get())
        if not self.is_wanted and self.file.changed():
            self.reload()
        if self.tabs.are_gone:
            self.is_over, self.planned = True, 0
        elif self.hold_if_due() or not self.running:
            self.pace.restart()
        elif not (self.is_wanted or self.planned):
            self.keep_time()

    def hold_if_due(self) -> bool:
        """Go on with slow hits and slow runs; return whether the time holds, also after an
        experiment is measured.
        """
        now = self.pace.clock()
        if self.questions.slowly and -inf < self.rest_end <= now:
            self.questions.slowly, self.pace.speed = False, self.speed
        return now < self.rest_end or self.slow_hits.go_on(now if self.running else -inf)

    def show_frame(self) -> None:
        """Show the result of the last ticks: ten times a second all of it, else what must be in
        step with the bobs.
        """
        if self.cradle.hand.held is not None:
            self.motion.set_start()
            if not self.running:
                self.note()  # one scale: the graph ends at the 100 % of this moment, too
        self.scenery.keep_in_view(self.cradle.bobs())
        if self.motion.fastest > QUIET:
            self.sounds = self.sounds[0] + 1, round(self.motion.fastest, 4)
        self.motion.fastest = 0.0
        if not self.tabs.have_room():
            return
        hit, _, pendula = self.slow_hits.shown or (None, 0, self.cradle.pend_list)
        self.marks.show_arrows(pendula)
        self.marks.show_halos((hit.left, hit.right) if hit else ())
        self.marks.show_ghosts(self.questions.predicted(self.motion.time()))
        state = {"sound": self.sounds, "view": {**self.scenery.view(), "labels": self.marks.labels}}
        if self.pace.clock() >= self.next_refresh:
            self.next_refresh = self.pace.clock() + REFRESH
            state |= self.state()
        self.tabs.show(state)

    def show_new_cradle(self) -> None:
        """Show a new cradle.

        The first one starts when a tab has drawn it, so that you see the release.
        """
        self.rest_end = -inf
        self.pose()
        self.slow_hits.clear()
        self.pace.speed = SLOWLY if self.questions.slowly else self.speed
        self.scenery.surround(
            self.cradle.axles(), self.cradle.bobs(), self.cradle.reach, self.cradle.values("mass")
        )
        self.marks.surround(self.cradle, self.scenery.bottom)
        self.graph.begin(self.cradle.colors())
        self.note()
        self.tick_lines, self.next_refresh = [], -inf
        while not (self.tabs.is_seen.is_set() or self.tabs.are_gone):
            self.show_frame()
            self.tabs.is_seen.wait(FRAME)
            self.next_refresh = -inf
            self.pace.restart()

    def note(self) -> None:
        """Add this moment to the graph."""
        self.graph.add(self.motion.sample())

    def longest_part(self) -> int:
        """Return after how many ticks, at most, to look at the cradle: a measurement looks a
        thousand times a swing.
        """
        longest = super().longest_part()
        if self.questions.is_measuring():
            longest = min(
                longest, max(1, round(self.cradle.period / LOOKS_A_SWING / self.cradle.dt))
            )
        return longest

    def end_part(self) -> None:
        """Look at the result of a part: measure an experiment; show One tick, or its hits."""
        super().end_part()
        if self.questions.is_measured_now():
            self.rest_end, self.planned = self.pace.clock() + REST, 0
        if self.looks_at_hits:
            self.slow_hits.add(self.cradle.hits.kept, self.motion.time(), self.motion.least)
            if self.slow_hits.waiting:
                self.planned = 0
        if self.before is not None:
            calls = self.cradle.hits.calls or [f"No call of {self.cradle.shown_name} was seen."]
            self.tick_lines = [*self.changes(self.before, self.cradle.coordinates()), *calls]
            self.before = None

    def state(self) -> dict:
        """Return what the page shows beside VPython's canvas, by name, all texts plain; page.html
        has the controls.
        """
        cradle, chooser, count = self.cradle, self.chooser, len(self.cradle.pend_list)
        made_angles, made_lifted = cradle.as_made
        angles = [
            made if angle is None else angle
            for angle, made in zip(self.angles, made_angles, strict=True)
        ]
        lifted = made_lifted if self.lifted is None else min(self.lifted, count)
        return {
            "title": cradle.title,
            "constants": cradle.constants(),
            **self.texts,
            "remark": " ".join(filter(None, [self.remark, cradle.remark()])),
            "error": self.error,
            "mistakes": chooser.mistakes,
            "ended": None,
            "running": self.running,
            "speed": round(self.pace.speed, 2),
            "lifted": [lifted, count],
            "angles": [(name, *ends) for name, ends in cradle.angles.items()],
            "lifts": [angle_to_outwards(angle) for angle in angles],  # degrees
            "collisions": self.collision_names(),
            "collision": self.collision_names()[[*cradle.collisions].index(cradle.collision)],
            "has rule": cradle.takes_rule,
            "separating": self.separating,
            "experiments": chooser.menu(),
            "experiment": chooser.name(),
            "ask first": self.questions.ask_first,
            "question": self.questions.state(),
            "arrows": self.marks.has_arrows,
            "slow hits": self.looks_at_hits,
            "hit": self.slow_hits.words(),
            "motion": self.readout(),
            "impacts": self.motion.trains.lines(),
            "graphs": [*self.graph.choices],
            "graph": self.graph.choice,
            "spans": [*SPANS],
            "span": self.graph.span,
            "curves": self.graph.state(self.motion.start_energy),
            "keys": [*cradle.angle_keys, *cradle.rate_keys],
            "refused": dict(chooser.refused),
            "mass": cradle.values("mass"),
            "e": cradle.values("e"),
            "tick": self.tick_lines,
            "now": {name: f"{number:.6f}" for name, number in cradle.coordinates().items()},
        }

    def readout(self) -> dict[str, str]:
        """Return the time, the energy and the momentum in words."""
        energy, momentum = self.motion.percents()["energy"], self.cradle.momentum()
        moving = f"{round(momentum, 3) + 0.0:+.3f}" if abs(momentum) < 1e4 else f"{momentum:+.2e}"
        arrow = "" if abs(momentum) < 0.0005 else " →" if momentum > 0 else " ←"
        return {
            "t": f"{self.motion.time():.2f} s {self.pace.remark()}".strip(),
            "energy": "> 999 %" if energy >= 1000 else f"{energy:.2f} %",
            "momentum": f"{moving} kg m/s{arrow}",
        }

    def changes(self, before, after) -> list[str]:
        """Return what one tick has done with the coordinates, in a line for each pendulum."""
        lines = [f"One tick, {self.cradle.dt:g} s: before -> after"]
        for i in range(len(self.cradle.pend_list)):
            names = [
                (key, f"{key}_{i + 1}") for key in (*self.cradle.angle_keys, *self.cradle.rate_keys)
            ]
            parts = [
                f"{key} {before[name]:.6g} -> {after[name]:.6g}".ljust(29) for key, name in names
            ]
            lines.append(f"[{i}] {' '.join(parts)}".rstrip())
        return lines

    def carry_out(self, command, values) -> None:
        """Do what a command says; do nothing if no action has its name, or if it does not take
        these values.
        """
        do, *kinds = self.actions.get(command if isinstance(command, str) else "", (None,))
        if (
            do
            and len(values) == len(kinds)
            and all(map(lambda kind, value: self.kinds[kind](value), kinds, values))
        ):
            do(*values)
            self.next_refresh = -inf

    def make_kinds(self) -> dict[str, Callable]:
        """Return a test for each kind of value: the page sends JSON."""
        kinds: dict[str, Callable] = {
            "switch": lambda value: type(value) is bool,
            "text": lambda value: type(value) is str and len(value) < 1000,
            "count": lambda value: type(value) is int and value >= 0,
            "number": lambda value: type(value) in (int, float) and abs(value) < 1e9,
            "point": lambda value: (
                type(value) is list and len(value) == 3 and all(map(kinds["number"], value))
            ),
            "direction": lambda value: kinds["point"](value) and max(map(abs, value)) > 1e-3,
            "degrees": lambda value: kinds["number"](value) and abs(value) <= 180,
            "speed": lambda value: kinds["number"](value) and SPEEDS[0] <= value <= SPEEDS[1],
            "bobs": lambda value: kinds["count"](value) and value <= len(self.cradle.pend_list),
            "cord": lambda value: kinds["count"](value) and value < len(self.angles),
            "answer": lambda value: value is None or kinds["count"](value),
            "collision": lambda value: value in self.collision_names(),
            "graph": lambda value: value in [*self.graph.choices],
            "span": lambda value: value in [*SPANS],
            "experiment": lambda value: value in self.chooser.names(),
            "column": lambda value: value in ("mass", "e"),
        }
        return kinds

    def make_actions(self) -> dict[str, tuple]:
        """Return, for the name of each command, what it does, and the kinds of its values."""
        return {
            "pause": (self.pause,),
            "step": (self.do_step,),
            "tick": (self.do_one_tick,),
            "speed": (self.set_speed, "speed"),
            "lifted": (self.set_lifted, "bobs"),
            "lift": (self.set_lift, "cord", "degrees"),
            "collision": (self.set_collision, "collision"),
            "separating": (self.set_separating, "switch"),
            "arrows": (self.show_arrows, "switch"),
            "slow hits": (self.slow_down_hits, "switch"),
            "graph": (self.graph.show, "graph"),
            "span": (partial(setattr, self.graph, "span"), "span"),
            "experiment": (self.choose, "experiment"),
            "restart": (self.restart,),
            "next": (lambda: self.choose(self.chooser.next_name()),),
            "ask first": (self.ask_first, "switch"),
            "again": (self.repeat, "switch"),
            "answer": (self.answer, "text", "answer"),
            "vote": (self.questions.vote, "text", "count"),
            "edit": (self.edit, "count", "column", "text"),
            "grab": (self.grab, "point", "direction"),
            "drag": (self.drag, "point", "direction"),
            "let go": (self.let_go,),
        }

    def pause(self) -> None:
        """Stop the time, or let it go on; an open question then has no answer."""
        self.running, self.rest_end = not self.running, -inf
        self.questions.is_asking = False

    def do_step(self) -> None:
        """Do the ticks of one frame, while paused, or show the next one of slow hits."""
        if not self.running and (self.slow_hits.shown or self.slow_hits.waiting):
            self.slow_hits.until = -inf
            self.slow_hits.go_on(self.pace.clock())
        elif not self.running:
            self.questions.is_asking = False
            self.plan(round(FRAME * self.pace.speed / self.cradle.dt))

    def do_one_tick(self) -> None:
        """Do one tick, while paused, and show its effect on each pendulum, and the collisions in
        it.
        """
        if not self.running:
            self.questions.is_asking = False
            self.before = self.cradle.coordinates()
            self.plan(1, with_calls=True)

    def set_speed(self, speed) -> None:
        """Let the time go on at this speed, times real time."""
        self.speed = self.pace.speed = speed

    def show_arrows(self, shown) -> None:
        """Show arrows and bars, or not."""
        self.marks.has_arrows = shown
        self.marks.place_arrows()
        self.scenery.below = self.marks.depth

    def slow_down_hits(self, slow) -> None:
        """Show the hits slowly, or not."""
        self.looks_at_hits = slow
        self.slow_hits.clear()
        self.scenery.lines = HIT_LINES * slow

    # --- which cradle ------------------------------------------------------------------------------------------------

    def restart(self) -> None:
        """Let main make the cradle that is chosen."""
        now = self.chooser.now
        self.snapshot, self.angles, self.lifted, self.cradle.collision, self.cradle.mass = now
        self.want_cradle()

    def set_lift(self, number, lift) -> None:
        """Release the bobs with this lift (degrees); number is the index of the slider."""
        self.leave_poses()
        angles = self.chooser.now.angles
        self.chooser.set(angles=[*angles[:number], outwards_to_angle(lift), *angles[number + 1 :]])
        self.restart()

    def set_lifted(self, lifted) -> None:
        """Lift this number of bobs."""
        self.leave_poses()
        self.chooser.set(lifted=lifted)
        self.restart()

    def collision_names(self) -> list[str]:
        """Return the names of the cradle's collisions on the page."""
        names = [*self.cradle.collisions]
        if self.chooser.experiment:
            names[0] = "as in the experiment"
        return names

    def set_collision(self, name) -> None:
        """Let bobs collide in this way (one of collision_names) from now on."""
        collision = [*self.cradle.collisions][self.collision_names().index(name)]
        self.leave_experiment()
        self.chooser.set(collision=collision)
        self.collide(collision)

    def set_separating(self, separating) -> None:
        """Let separating bobs collide, too, or not; only if the functions take this rule."""
        self.leave_experiment()
        self.separating = separating or not self.cradle.takes_rule

    def edit(self, row, column, text) -> None:
        """Let main make the cradle with this number in a row and a column of the table, or show why
        it is refused.
        """
        if self.chooser.edit(
            row, column, text, {name: self.cradle.values(name) for name in ("mass", "e")}
        ):
            self.leave_experiment()
            self.restart()

    def reload(self) -> None:
        """Let main make the cradle of the saved CSV, or show the mistake in it; the old cradle then
        swings on.
        """
        self.error, self.next_refresh = "", -inf
        try:
            self.chooser.take(self.file.current)
        except ValueError as error:
            self.error = str(error)
        else:
            self.running = self.running or self.questions.is_asking
            self.restart()

    def choose(self, name) -> None:
        """Let main make the cradle with this name in the menu: an experiment, or your CSV with its
        settings.
        """
        self.chooser.choose(name)
        self.running = (
            self.running or self.questions.is_asking or self.chooser.experiment is not None
        )
        self.restart()

    def ask_first(self, asks) -> None:
        """Ask the question of an experiment before its release, or not; restart an experiment."""
        self.questions.ask_first = asks
        if self.chooser.poses and not self.chooser.is_changed:
            self.running = True
            self.restart()

    def answer(self, key, number) -> None:
        """Take an answer (its index, or None) to the question with this key; the cradle then runs."""
        self.running = self.questions.answer(key, number) or self.running

    def repeat(self, slowly) -> None:
        """Run the experiment again with the same answer, maybe slowly."""
        if self.questions.measurement and self.questions.measurement.is_over:
            self.questions.repeat(slowly)
            self.running = True
            self.restart()

    def pose(self) -> None:
        """Lift the bobs as the present experiment says, and ask its question, if Predict first is
        ticked.
        """
        chooser, poses = self.chooser, self.chooser.poses
        # Main may read another file
        is_posed = poses is not None and len(poses) == len(self.cradle.pend_list)
        if is_posed:
            self.cradle.pose(poses)
            self.motion.set_start()
        experiment = chooser.experiment if is_posed and not chooser.is_changed else None
        self.questions.begin(experiment, self.motion)
        self.running = self.running and not self.questions.is_asking

    def leave_poses(self) -> None:
        """Lift the bobs as the sliders say, no more as an experiment says."""
        if self.chooser.poses:
            angles, lifted = self.cradle.as_made
            self.chooser.poses = None
            self.chooser.set(angles=list(angles), lifted=lifted)
        self.leave_experiment()

    def leave_experiment(self) -> None:
        """Measure nothing any more: the cradle is no longer that of the experiment.

        If it was waiting, it runs.
        """
        self.running, self.rest_end = self.running or self.questions.is_asking, -inf
        self.slow_hits.clear()
        self.set_speed(self.speed)  # also if an experiment was repeated slowly
        self.chooser.is_changed = self.chooser.experiment is not None
        self.questions.drop()

    # --- the mouse: a ray is a point on it, and its direction ---------------------------------------------------------

    def grab(self, place, direction) -> None:
        """Hold the bob under the mouse, if there is one."""
        bob = bob_at(self.cradle.bobs(), vector(*place), vector(*direction))
        if bob is not None:
            self.cradle.hand.hold(bob)
            self.leave_experiment()

    def drag(self, place, direction) -> None:
        """Drag the held bob, if there is one, to the mouse's ray."""
        point = point_in_plane(vector(*place), vector(*direction))
        if self.cradle.hand.held is not None and point is not None:
            self.cradle.hand.drag(point.x, point.y)

    def let_go(self) -> None:
        """Let the held bob, if there is one, swing on."""
        if self.cradle.hand.held is not None:
            self.cradle.hand.held = None
            self.motion.set_start()
            self.note()
            self.marks.surround(self.cradle, self.scenery.bottom)
            self.slow_hits.clear()
