"""What the controls and commands of the page do."""

from typing import TYPE_CHECKING

from vpython import vector

from support.columns import SETTABLE
from support.cradle.collision import AS_MADE, Collision
from support.cradle.dragging import bob_at, point_in_plane
from support.cradle.real_time import FRAME
from support.files.cradle_csv import Snapshot
from support.files.ghosts import Ghosts, read_ghosts
from support.page.graph import ENERGY
from support.page.questions import WAITS
from support.pendulum import angle_to_outwards, outwards_to_angle

if TYPE_CHECKING:
    from support.page.viewer import Viewer

HIT_LINES = 5  # of text, above the cradle
SLOWLY = 0.1  # times real time: the speed of slow motion
# After a mistake in your CSV, for instance "... allowed is a number from 0 to 1, such as 0.9"
STILL_THERE = "The page still shows the cradle as it was before. Mend the file, and save it."


class Actions:
    """Changes what a viewer plays and shows, while it plays."""

    def __init__(self, viewer: "Viewer"):
        self.viewer = viewer
        self.cradle = viewer.cradle
        self.chooser = viewer.chooser
        self.questions = viewer.questions
        self.is_dragging = False  # whether you have moved or stopped the held bob

    # --- time ----------------------------------------------------------------------------------

    def pause(self) -> None:
        """Stop the time, or let it go on; an open question waits for an answer."""
        if self.can_go_on():
            self.viewer.is_paused = not self.viewer.is_paused
            self.questions.rest_end = None

    def can_go_on(self) -> bool:
        """Return whether no question is open; an open one waits for its answer, and says so."""
        if self.questions.is_asking:
            self.questions.word = WAITS
        return not self.questions.is_asking

    def do_step(self) -> None:
        """Do the ticks of one frame, while paused, or show the next one of slow hits."""
        viewer = self.viewer
        if not self.can_go_on() or viewer.is_time_running():
            return
        if viewer.slow_hits.current or viewer.slow_hits.waiting:
            viewer.slow_hits.show_next(viewer.pace.clock())
        else:
            viewer.plan(round(FRAME * viewer.speed_now() / self.cradle.dt))

    def do_one_tick(self) -> None:
        """Do one tick, while paused, and show what it changes, and the collisions in it."""
        if self.can_go_on() and not self.viewer.is_time_running():
            self.viewer.before = self.cradle.coordinates()
            self.viewer.plan(1, with_calls=True)

    def slow_down(self, is_slow: bool) -> None:
        """Let the time go on slowly, or at its usual speed."""
        self.set_speed(SLOWLY if is_slow else 1.0)

    def set_speed(self, speed: float) -> None:
        """Let the time go on at this speed, times real time, also if a run is in slow motion."""
        self.viewer.speed = speed
        self.questions.slowly = False

    # --- what is shown -------------------------------------------------------------------------

    def show_arrows(self, is_shown: bool) -> None:
        """Show arrows and momenta, or not."""
        self.viewer.marks.has_arrows = is_shown

    def measure(self, is_shown: bool) -> None:
        """Show the dial, angles, speeds and the half swings, or not."""
        self.viewer.marks.measures = is_shown
        self.viewer.marks.place_dial()

    def slow_down_hits(self, is_slow: bool) -> None:
        """Show the hits slowly, or not."""
        self.viewer.looks_at_hits = is_slow
        self.viewer.slow_hits.clear()
        self.viewer.scenery.lines = HIT_LINES if is_slow else 0

    def set_span(self, span: str) -> None:
        """Show this time in the graph (a key of SPANS)."""
        self.viewer.graph.span = span

    def show_ghosts(self, name: str, text: str) -> None:
        """Release the cradle with the ghosts of a file with this name and this text.

        It is released from their angle, if the file has one. Or show the mistake in the file.
        """
        try:
            ghosts = read_ghosts(Snapshot(name, text.encode()), self.cradle.angle_keys)
        except ValueError as error:
            self.viewer.ghosts.mistake = str(error)
        else:
            self.take_ghosts(ghosts)

    def take_ghosts(self, ghosts: Ghosts, with_angle: bool = True) -> None:
        """Release the cradle with these ghosts, from their angle if they have one."""
        self.viewer.ghosts = ghosts
        self.viewer.want_cradle()
        if with_angle and ghosts.angle is not None:
            self.set_release_angle(0, angle_to_outwards(ghosts.angle))

    def remove_ghosts(self) -> None:
        """Remove the ghosts of a file."""
        self.viewer.ghosts = Ghosts()

    # --- which cradle --------------------------------------------------------------------------

    def set_release_angle(self, cord: int, degrees: float) -> None:
        """Release the bobs with this angle of this cord, outwards."""
        self.leave_poses()
        angles = list(self.viewer.settings.angles)
        angles[cord] = outwards_to_angle(degrees)
        self.viewer.change(angles=angles)
        self.viewer.want_cradle()

    def set_count(self, count: int) -> None:
        """Let main make the cradle with this number of pendula."""
        self.leave_poses()
        self.chooser.set_count(count)
        self.viewer.want_cradle()

    def lifted_now(self) -> int:
        """Return the number of lifted bobs."""
        settings = self.viewer.settings
        return self.cradle.lifted_count(settings.angles, settings.lifted)

    def set_lifted(self, lifted: int) -> None:
        """Lift this number of bobs."""
        self.leave_poses()
        self.viewer.change(lifted=lifted)
        self.viewer.want_cradle()

    def collisions(self) -> dict[str, Collision]:
        """Return the ways to collide in the menu by name; the present one is always there."""
        named = {}
        for collision in [*self.cradle.collisions, self.cradle.collision]:
            named[self.name_on_page(collision)] = collision
        return named

    def name_on_page(self, collision: Collision) -> str:
        """Return the name of a way to collide on the page."""
        if collision == AS_MADE and self.chooser.is_edited():
            return "as changed"
        if collision == AS_MADE and self.chooser.experiment:
            return "as in the experiment"
        return collision.name

    def set_collision(self, collision: Collision) -> None:
        """Release the bobs again, and let them collide in this way."""
        self.leave_experiment()
        self.viewer.change(collision=collision)
        self.viewer.want_cradle()

    def set_separating(self, separating: bool) -> None:
        """Release the bobs again, and let separating ones collide, too, or not."""
        self.leave_experiment()
        self.viewer.separating = separating
        self.viewer.want_cradle()

    def reset(self) -> None:
        """Begin again with your CSV, as the program has started."""
        for show in (self.set_ask_first, self.show_arrows, self.measure, self.slow_down_hits):
            show(False)
        self.set_speed(1.0)
        self.remove_ghosts()
        self.viewer.separating = not self.cradle.takes_rule
        self.viewer.is_paused = False
        self.viewer.graph.show(ENERGY)
        self.chooser.choose_first()
        self.viewer.want_cradle()

    def edit(self, row: int, column: str, text: str) -> None:
        """Let main make the cradle with this number in the table, or show why it is refused."""
        numbers = {name: self.cradle.values(name) for name in SETTABLE}
        if self.chooser.edit(row, column, text, numbers):
            self.leave_experiment()
            self.viewer.want_cradle()

    def reload(self) -> None:
        """Let main make the cradle of the saved CSV.

        Or show the mistake in it; the old cradle then swings on.
        """
        self.viewer.error = ""
        self.viewer.next_refresh = 0.0
        try:
            self.chooser.choose_saved(self.viewer.file.current)
        except ValueError as error:
            self.viewer.error = f"{error}. {STILL_THERE}"
        else:
            self.viewer.want_cradle()

    # --- experiments ---------------------------------------------------------------------------

    def choose(self, name: str) -> None:
        """Let main make the cradle with this name: an experiment, or your CSV with its settings."""
        self.chooser.choose(name)
        self.questions.word = ""
        if self.chooser.experiment:
            self.viewer.is_paused = False
        self.viewer.want_cradle()

    def choose_next(self) -> None:
        """Choose the next experiment."""
        self.choose(self.chooser.next_name())

    def set_ask_first(self, asks: bool) -> None:
        """Ask the question of an experiment before its release, or not; restart an experiment."""
        self.questions.ask_first = asks
        self.questions.word = ""
        if self.chooser.whole_experiment():
            self.viewer.is_paused = False
            self.viewer.want_cradle()

    def answer(self, key: str, number: int | None) -> None:
        """Take an answer (its index, or None) to the question with this key; the cradle runs."""
        self.questions.answer(key, number)

    def repeat(self, slowly: bool) -> None:
        """Run the experiment again with the same answer, maybe slowly."""
        measurement = self.questions.measurement
        if measurement and measurement.is_over:
            self.questions.repeat(slowly)
            self.viewer.is_paused = False
            self.viewer.want_cradle()

    def pose(self) -> None:
        """Lift the bobs as the present experiment says, and ask its question if you want it."""
        experiment = self.chooser.whole_experiment()
        poses = self.chooser.poses or []
        if len(poses) == len(self.cradle.pend_list):
            self.cradle.pose(poses)
            self.viewer.motion.set_start()
        else:
            experiment = None  # main may read another file
        self.questions.begin(experiment, self.viewer.motion)
        if self.questions.is_asking:
            self.viewer.is_paused = False  # so the cradle runs when the question is over

    def leave_poses(self) -> None:
        """Lift the bobs as the sliders say, no more as an experiment says."""
        if self.chooser.poses:
            self.chooser.poses = None
            self.viewer.change(angles=list(self.cradle.made_angles), lifted=self.cradle.made_lifted)
        self.leave_experiment()

    def leave_experiment(self) -> None:
        """Ask and measure nothing any more: the cradle is no longer that of the experiment."""
        self.viewer.slow_hits.clear()
        self.chooser.is_changed = self.chooser.experiment is not None
        self.questions.end()

    # --- the mouse: a ray is a point on it, and its direction ----------------------------------

    def grab(self, place: list[float], direction: list[float]) -> None:
        """Hold the bob under the mouse, if there is one.

        This changes nothing while the time stands still.
        """
        index = bob_at(self.cradle.bobs(), vector(*place), vector(*direction))
        if index is not None:
            self.is_dragging = False
            self.cradle.held_bob.index = index
            if self.viewer.is_time_running():
                self.cradle.held_bob.hold(index)

    def drag(self, place: list[float], direction: list[float]) -> None:
        """Drag the held bob, if there is one, to the mouse's ray."""
        point = point_in_plane(vector(*place), vector(*direction))
        if point is not None and self.cradle.held_bob.drag(point.x, point.y):
            self.begin_drag()

    def begin_drag(self) -> None:
        """Note that you have moved or stopped the held bob: the cradle moves in another way now."""
        if not self.is_dragging:
            self.is_dragging = True
            self.viewer.is_dragged = True
            self.leave_experiment()

    def let_go(self) -> None:
        """Let the held bob, if there is one, swing on."""
        if self.cradle.held_bob.index is not None and self.is_dragging:
            self.viewer.motion.set_start()
            self.viewer.begin_swing()
        self.cradle.held_bob.index = None
