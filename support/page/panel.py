"""The control panel under the canvas: what a person can set there, and what the cradle does in numbers."""

from html import escape
from pathlib import Path

from vpython import button, checkbox, menu, scene, slider, wtext

from support.page.commands import Command
from support.pendulum import from_lift, to_lift

# How the page looks, and what its keys and its mouse do beyond what VPython does.
PAGE = Path(__file__).with_name("panel.html")

KEYS_HINT = "Space pauses, &rarr; steps, R restarts, 1 to 9 lift that many bobs. Drag a bob with the mouse."
SEPARATING = "Separating bobs collide too"
SEPARATING_HINT = "as in the handout: with e below 1 they then stick together"
FIXED_HINT = "fixed: the functions take no approaching_only"
SAVING = "a CSV of what has been seen since the last restart, ten minutes at most"
TRAINS = 7  # of impacts, a line for each


class Panel:
    """The widgets and texts. What is done to the widgets is given on as a command; show_... change what is to be seen.

    The texts change only where something has changed, so that nothing flickers, and are as wide as before.
    """

    def __init__(self, give, cradle, remark=""):
        """Make the panel for this cradle, below a remark, if there is one.

        give(command, value) takes the commands; another thread calls it.
        """
        scene.append_to_caption(PAGE.read_text(encoding="utf-8"))
        self.error = wtext()
        if remark:
            wtext(text=f'<div class="remark" role="note">{escape(remark)}</div>')

        self.add_buttons(give)
        self.add_settings(give, cradle)
        self.add_collisions(give, cradle)
        self.readout, self.impacts = wtext(), wtext()
        end_row()
        self.graph = checkbox(text="Energy graph", checked=True, bind=lambda box: give(Command.GRAPH, box.checked))
        self.save = button(text="Save data", bind=lambda: give(Command.SAVE))
        self.saved = wtext()
        self.show_saved(SAVING)

    def add_buttons(self, give) -> None:
        """Add the buttons that have keys."""
        self.pause = button(text="Pause", bind=lambda: give(Command.PAUSE))
        self.step = button(text="Step", bind=lambda: give(Command.STEP))
        self.restart = button(text="Restart", bind=lambda: give(Command.RESTART))
        add_hint(KEYS_HINT)

    def add_settings(self, give, cradle) -> None:
        """Add the sliders."""
        self.speed = Setting("Speed", 0.1, 2, 0.1, lambda speed: give(Command.SPEED, speed))
        # The range of a VPython slider is fixed and the number of pendula is not, so this one goes from none to all.
        self.count = 1
        self.lifted = Setting("Bobs lifted", 0, 1, 0.001, lambda part: give(Command.LIFT, round(part * self.count)))
        self.angles = [
            Setting(name, least, largest, 1, lambda lift, number=number: give(Command.ANGLE, (number, from_lift(lift))))
            for number, (name, (least, largest)) in enumerate(cradle.angles.items())
        ]

    def add_collisions(self, give, cradle) -> None:
        """Add the menu of collisions and their rule, which is fixed if the cradle takes none."""
        add_label("Collisions")
        self.collisions = menu(
            choices=list(cradle.collisions),
            selected=cradle.collision,
            bind=lambda menu: give(Command.COLLISIONS, menu.selected),
        )
        end_row()
        self.separating = checkbox(text=SEPARATING, bind=lambda box: give(Command.SEPARATING, box.checked))
        if cradle.takes_rule:
            add_hint(SEPARATING_HINT)
        else:
            self.separating.checked = self.separating.disabled = True
            add_hint(FIXED_HINT)

    def show_error(self, message) -> None:
        """Show this message above everything else, until it is shown an empty one."""
        set_text(self.error, f'<div class="error" role="alert">{escape(message)}</div>' if message else "")

    def show_end(self, words) -> None:
        """Show that the program has ended, and why; what stands there no longer moves."""
        text = f"<strong>The program has ended.</strong> {escape(words)}"
        set_text(self.error, f'<div class="error ended" role="alert">{text}</div>')

    def show_settings(self, running, speed, angles, lifted, count) -> None:
        """Show whether the cradle runs, its speed (times real time), its release angles (rad), and how many bobs
        out of count are lifted.
        """
        self.count = count
        set_text(self.pause, "Pause" if running else "Run")
        if self.step.disabled != running:
            self.step.disabled = running
        self.speed.show(speed, f"{speed:.1f}x")
        for setting, angle in zip(self.angles, angles, strict=True):
            lift = to_lift(angle)
            setting.show(lift, f"{lift:.4g}&deg;")
        self.lifted.show(lifted / count, f"{lifted} of {count}")

    def show_motion(self, reading, momentum, remark) -> None:
        """Show the time and the energy, as Motion reads them, the momentum (kg m/s), and a remark about the speed."""
        moving = f"{momentum:+9.3f}" if abs(momentum) < 1e4 else f"{momentum:+9.2e}"
        text = f"{reading}   momentum {moving} kg m/s   {remark}".rstrip()
        set_text(self.readout, f'<pre class="readout">{text}</pre>')

    def show_saved(self, message, failed=False) -> None:
        """Show what has been saved, and where, or why it failed."""
        set_text(self.saved, f'<span class="{"failed" if failed else "hint"} saved">{escape(message)}</span>')

    def show_impacts(self, lines) -> None:
        """Show the last trains of impacts, a line for each."""
        set_text(self.impacts, '<pre class="impacts">' + "\n".join(["Impacts", *lines]) + "</pre>")


class Setting:
    """A slider with its name before it and its value, with the unit, behind it."""

    def __init__(self, name, lowest, highest, step, bind):
        """Make the slider; bind(value) is called when it is moved."""
        add_label(name)
        self.slider = slider(min=lowest, max=highest, step=step, length=170, bind=lambda slider: bind(slider.value))
        self.text = wtext()

    def show(self, value, text) -> None:
        """Move the slider to value, and show its text."""
        if self.slider.value != value:
            self.slider.value = value
        set_text(self.text, f'<span class="value">{text}</span>')


def add_label(text) -> None:
    """Add the name of the widget that comes next."""
    wtext(text=f'<span class="label">{text}</span>')


def add_hint(text) -> None:
    """Add a small explanation, which ends a row."""
    wtext(text=f'<span class="hint">{text}</span>')
    end_row()


def end_row() -> None:
    """Begin a new row of widgets."""
    wtext(text='<i class="row"></i>')


def set_text(widget, text) -> None:
    """Change the text of something on the page, if it is another: a person may be about to copy it."""
    if widget.text != text:
        widget.text = text
