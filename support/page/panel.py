"""The control panel beside the canvas: the settings, and the motion of the cradle in numbers."""

from html import escape
from pathlib import Path

from vpython import button, checkbox, menu, scene, wtext

from support.page.commands import Command
from support.page.widgets import add_hint, add_label, begin_part, end_row, set_text, Setting
from support.pendulum import from_lift, to_lift

FOLDER = Path(__file__).parent  # its .css and .js files are the style of the page, and additions to VPython's page

KEYS_HINT = (
    "Space pauses, &rarr; steps, R restarts, 1 to 9 lift that many bobs, V resets the view, F presents. Drag a bob."
)
LEAVE = '<button class="leave" onclick="present()" aria-label="End the presentation">&times;</button>'
PRESENT = (
    '<button onclick="present()" title="Show only the cradle and its numbers, in full screen (F)">Present</button>'
)
SEPARATING = "Separating bobs collide too"
SEPARATING_HINT = (
    "The handout lets two bobs collide in each tick in which they touch, also when they already move apart. A second "
    "hit then undoes a part of the first one: bobs with e below 1 stick together."
)
FIXED_HINT = "Your functions have no parameter approaching_only, so this rule is fixed."
TAKE_AWAY = """\
<button onclick="takePicture()" title="Download a PNG of the cradle">Picture</button>
<button onclick="takeFilm()" class="film" title="Record the cradle until you press it again">Film</button>
<button onclick="takeData()" title="Download the data since the last restart">Data (CSV)</button>"""
COPY = '<button onclick="takeCommand()" title="Copy the command that starts this cradle again">Copy command</button>'
COPIED = '<span class="copied hint" role="status"></span>'
SAVING = (
    "Data (CSV) downloads the data since the last restart, at most ten minutes. Save data writes them to a file on the "
    "computer of the program."
)
UNWRITTEN = "No file has this cradle. Write to my CSV (below Pendula) puts it in your file; then copy the command."
SWUNG_THROUGH = "As in the handout, only neighbours collide: a bob swings through others."
TRAINS = 7  # of impacts, a line for each


class Panel:
    """The widgets and texts. Each use of a widget gives a command; the methods show_... change the page.

    A text is sent only if it has changed, and keeps its width, so that nothing flickers or moves.
    """

    def __init__(self, give, cradle, questions, table, remark=""):
        """Make the panel for this cradle, with the experiments' questions and the table of the pendula.

        The widgets call give(command, value), in a thread of VPython. The remark, if there is one, stands above them.
        """
        self.questions, self.table = questions, table
        for kind, tag in (("css", "style"), ("js", "script")):
            for file in sorted(FOLDER.glob(f"*.{kind}")):
                scene.append_to_caption(f"<{tag}>{file.read_text(encoding='utf-8')}</{tag}>")
        begin_part("messages")
        self.error = wtext()
        if remark:
            wtext(text=f'<div class="remark" role="note">{escape(remark)}</div>')
        begin_part("asked")
        self.questions.add_area()
        begin_part("controls")
        self.add_buttons(give)
        begin_part("numbers")
        self.readout, self.impacts = wtext(), wtext()
        scene.append_to_caption(LEAVE)
        begin_part("experiment")
        self.questions.add_menu(give)
        begin_part("settings")
        self.add_settings(give, cradle)
        self.add_collisions(give, cradle)
        begin_part("graph")
        add_label("Graph")
        self.graph = menu(choices=[""], bind=lambda menu: give(Command.GRAPH, menu.selected))
        self.chosen = wtext()
        begin_part("pendula-part", fold="Pendula")
        self.table.add(give)
        begin_part("data", fold="Take away")
        scene.append_to_caption(TAKE_AWAY)
        self.save = button(text="Save data", bind=lambda: give(Command.SAVE))
        self.saved = wtext()
        scene.append_to_caption(COPY)
        self.command = wtext()
        scene.append_to_caption(COPIED)
        self.show_saved(SAVING)
        begin_part("advanced", fold="Advanced")
        self.sound = checkbox(text="Sound", bind=lambda box: give(Command.SOUND, box.checked))
        self.hit = wtext(text='<i class="hit"></i>')  # sound.js knows it, and the checkbox before it
        add_hint("a click for each hit, the louder the faster the bobs meet")
        self.add_rule(give, cradle.takes_rule)
        add_hint(escape(cradle.constants()))
        scene.append_to_caption("<script>arrange()</script>")

    def add_buttons(self, give) -> None:
        """Add the buttons that have keys."""
        self.pause = button(text="Pause", bind=lambda: give(Command.PAUSE))
        self.step = button(text="Step", bind=lambda: give(Command.STEP))
        self.restart = button(text="Restart", bind=lambda: give(Command.RESTART))
        self.view = button(text="Reset view", bind=lambda: give(Command.VIEW))
        scene.append_to_caption(PRESENT)
        end_row()
        add_hint(KEYS_HINT)

    def add_settings(self, give, cradle) -> None:
        """Add the sliders."""
        self.speed = Setting("Speed", 0.1, 2, 0.1, lambda speed: give(Command.SPEED, speed))
        # A VPython slider has a fixed range, but the number of pendula changes: this one has the lifted part, 0 to 1.
        self.count = 1
        self.lifted = Setting("Bobs lifted", 0, 1, 0.001, lambda part: give(Command.LIFT, round(part * self.count)))
        self.angles = [
            Setting(name, least, largest, 1, lambda lift, number=number: give(Command.ANGLE, (number, from_lift(lift))))
            for number, (name, (least, largest)) in enumerate(cradle.angles.items())
        ]

    def add_collisions(self, give, cradle) -> None:
        """Add the menu of collisions."""
        add_label("Collisions")
        self.collisions = menu(
            choices=list(cradle.collisions),
            selected=cradle.collision,
            bind=lambda menu: give(Command.COLLISIONS, menu.selected),
        )

    def add_rule(self, give, takes_rule) -> None:
        """Add the checkbox of the collisions' rule, which is fixed if the cradle takes no rule."""
        self.separating = checkbox(text=SEPARATING, bind=lambda box: give(Command.SEPARATING, box.checked))
        end_row()
        add_hint(SEPARATING_HINT)
        if not takes_rule:
            self.separating.checked = self.separating.disabled = True
            add_hint(FIXED_HINT)

    def send_again(self) -> None:
        """Send what you have set to a page that was loaded again: VPython has only received it, and never sent it."""
        for setting in (self.speed, self.lifted, *self.angles):
            setting.slider.value = setting.slider.value
        self.collisions.selected = self.collisions.selected
        for box in (self.sound, self.separating):
            box.checked = box.checked
        self.questions.send_again()

    def show_error(self, message) -> None:
        """Show this message above everything else; an empty message removes it."""
        set_text(self.error, f'<div class="error" role="alert">{escape(message)}</div>' if message else "")

    def show_end(self, words) -> None:
        """Show that the program has ended, and why; nothing on the page moves any more."""
        text = f"<strong>The program has ended.</strong> {escape(words)}"
        set_text(self.error, f'<div class="error ended" role="alert">{text}</div>')

    def click(self, speed) -> None:
        """Let the page click for a hit of this speed (m/s)."""
        self.hit.text = f'<i class="hit" data-speed="{speed:.4f}"></i>'

    def show_settings(self, running, speed, angles, lifted, count) -> None:
        """Show whether the cradle runs, its speed (times real time), its release angles (rad), and the number of
        lifted bobs out of count.
        """
        self.count = count
        set_text(self.pause, "Pause" if running else "Run")
        for widget in (self.step, self.table.tick):
            if widget.disabled != running:
                widget.disabled = running
        self.speed.show(speed, f"{speed:.1f}x")
        for setting, angle in zip(self.angles, angles, strict=True):
            lift = to_lift(angle)
            setting.show(lift, f"{lift:.4g}&deg;")
        self.lifted.show(lifted / count, f"{lifted} of {count}")

    def show_motion(self, time, percents, momentum, remark) -> None:
        """Show the time (s), the energies (% by name), the momentum (kg m/s), and a remark about the speed."""
        rows = {"t": f"{time:.2f} s {remark}"}
        rows |= {name: percent_cell(percent) for name, percent in percents.items()}
        rows["momentum"] = momentum_cell(momentum)
        lines = [f'<tr><th scope="row">{name}</th><td>{cell}</td></tr>' for name, cell in rows.items()]
        set_text(self.readout, f'<table class="readout">{"".join(lines)}</table>')

    def show_collision(self, collision) -> None:
        """Show this kind of collisions in the menu."""
        if self.collisions.selected != collision:
            self.collisions.selected = collision

    def show_graphs(self, choices, choice) -> None:
        """Show these choices of graphs in the menu, and the present choice."""
        if self.graph.choices != choices:
            self.graph.choices = choices
        if self.graph.selected != choice:
            self.graph.selected = choice
        # The page gets new choices after what is selected, and then selects the first one. panel.js mends this.
        set_text(self.chosen, f'<i class="chosen" data-name="{escape(choice)}"></i>')

    def show_saved(self, message, failed=False) -> None:
        """Show a message about saved data: the file, or, if failed, the reason."""
        set_text(self.saved, f'<span class="{"failed" if failed else "hint"} saved">{escape(message)}</span>')

    def show_command(self, command) -> None:
        """Show the command that starts the program with the present settings; an empty one if there is none."""
        code = f'<code class="command">{escape(command)}</code>'
        set_text(self.command, code if command else f'<span class="hint">{UNWRITTEN}</span>')

    def show_impacts(self, lines, swung_through=False) -> None:
        """Show the last trains of impacts, a line for each, and a note if a bob has swung through others."""
        note = f'\n<span class="hint">{SWUNG_THROUGH}</span>' if swung_through else ""
        set_text(self.impacts, '<pre class="impacts">' + "\n".join(["Impacts", *lines]) + note + "</pre>")


def percent_cell(percent) -> str:
    """Return a percentage with one decimal, and with four while the mouse is over it."""
    if percent >= 1000:
        return "&gt; 999 %"
    return f'<span class="short">{percent:.1f} %</span><span class="exact">{percent:.4f} %</span>'


def momentum_cell(momentum) -> str:
    """Return the momentum (kg m/s) as text, with an arrow in its direction."""
    moving = f"{momentum:+.3f}" if abs(momentum) < 1e4 else f"{momentum:+.2e}"
    arrow = "" if abs(momentum) < 0.0005 else " &rarr;" if momentum > 0 else " &larr;"
    return f"{moving} kg m/s{arrow}"
