"""The control panel beside the canvas: the settings, the motion of the cradle in numbers, and the parts of both."""

from html import escape
from pathlib import Path

from vpython import button, checkbox, menu, scene, slider, wtext

from support.page.motion_graph import SPANS
from support.pendulum import from_lift, to_lift

FOLDER = Path(__file__).parent  # its .css and .js files are the style of the page, and additions to VPython's page

PRESENT = """\
<button onclick="present()" title="Show the cradle in full screen, for a class (F)">Present</button>
<button class="keys" popovertarget="keys" aria-label="Keys" title="Keys">?</button>
<div id="keys" popover><h2>Keys</h2><dl>KEYS</dl><p>Drag a bob with the mouse or a finger.</p></div>"""
LEAVE = '<button class="leave" onclick="present()" aria-label="End the presentation">&times;</button>'
WORDS_OF_KEYS = {  # what you press, and what it does; panel.js shows the first four as hints of their buttons
    "Space": "pause, run",
    "&rarr;": "one step, while paused",
    "R": "restart",
    "V": "reset the view",
    "F": "present; F or Escape ends it",
    "1 to 9": "lift that many bobs",
    "A to E": "answer a question",
    "N": "next experiment",
    "H": "slow hits",
}
SEPARATING_HINT = (
    "The handout lets two bobs collide in each tick in which they touch, also when they already move apart. A second "
    "hit then undoes a part of the first one: bobs with e below 1 stick together."
)
TRAINS = 5  # of impacts, a line for each


class Panel:
    """The widgets and texts. A text is sent only if it has changed, and keeps its width: nothing flickers or moves."""

    def __init__(self, give, cradle, questions, table, remark=""):
        """Make the panel for this cradle, with the experiments' questions and the table of the pendula.

        The widgets call give(command, value), in a thread of VPython. The remark, if there is one, stands above them.
        """
        self.questions, self.table = questions, table
        for file in sorted(FOLDER.glob("*.css")):
            scene.append_to_caption(f"<style>{file.read_text(encoding='utf-8')}</style>")
        for file in sorted(FOLDER.glob("*.js")):  # the page runs each script twice, so each is one block, after an if
            once = f"if (!window['{file.name}'] && (window['{file.name}'] = true))"
            scene.append_to_caption(f"<script>{once}\n{file.read_text(encoding='utf-8')}</script>")
        begin_part("messages")
        self.error = wtext()
        if remark:
            wtext(text=f'<div class="remark" role="note">{escape(remark)}</div>')
        begin_part("asked")
        self.questions.add_area()
        begin_part("hit-part")
        self.hit_words = wtext()
        begin_part("controls")
        self.pause = button(text="Pause", bind=lambda: give("pause"))
        self.step = button(text="Step", bind=lambda: give("step"))
        self.restart = button(text="Restart", bind=lambda: give("restart"))
        self.view = button(text="Reset view", disabled=True, bind=lambda: give("view"))
        keys = "".join(f"<dt>{key}</dt><dd>{does}</dd>" for key, does in WORDS_OF_KEYS.items())
        scene.append_to_caption(PRESENT.replace("KEYS", keys))
        begin_part("numbers")
        self.readout, self.impacts = wtext(), wtext()
        scene.append_to_caption(LEAVE)
        begin_part("experiment")
        self.questions.add_menu(give)
        begin_part("settings")
        self.add_settings(give, cradle)
        begin_part("shows")
        self.arrows = checkbox(text="Arrows", bind=lambda box: give("arrows", box.checked))
        self.slow_hits = checkbox(text="Slow hits", bind=lambda box: give("slow hits", box.checked))
        self.sound = checkbox(text="Sound", bind=lambda box: give("sound", box.checked))
        self.hit = wtext(text='<i class="hit"></i>')  # sound.js knows it, and the checkbox before it
        begin_part("graph")
        add_label("Graph")
        self.graph = menu(choices=[""], bind=lambda menu: give("graph", menu.selected))
        add_label("Time of the graph")
        spans = [*SPANS]
        self.span = menu(choices=spans, selected=spans[0], bind=lambda menu: give("span", menu.selected))
        self.chosen = wtext()
        begin_part("pendula-part", fold="For programmers")
        self.table.add(give)
        self.separating = checkbox(text="Separating bobs collide too", bind=lambda box: give("separating", box.checked))
        end_row()
        add_hint(SEPARATING_HINT)
        if not cradle.takes_rule:
            self.separating.disabled = True
            add_hint("Your functions have no parameter approaching_only, so this rule is fixed.")
        add_hint(escape(cradle.constants()))
        scene.append_to_caption("<script>arrange()</script>")

    def add_settings(self, give, cradle) -> None:
        """Add the sliders and the menu of collisions."""
        self.speed = Setting("Speed", 0.1, 2, 0.1, lambda speed: give("speed", speed))
        # A VPython slider has a fixed range, but the number of pendula changes: this one has the lifted part, 0 to 1.
        self.count = 1
        self.lifted = Setting("Bobs lifted", 0, 1, 0.001, lambda part: give("lift", round(part * self.count)))
        self.angles = [
            Setting(name, least, largest, 1, lambda lift, number=number: give("angle", (number, from_lift(lift))))
            for number, (name, (least, largest)) in enumerate(cradle.angles.items())
        ]
        add_label("Collisions")
        self.collisions = menu(choices=list(cradle.collisions), bind=lambda menu: give("collisions", menu.selected))

    def send_again(self) -> None:
        """Send what you have set to a page that was loaded again: VPython has only received it, and never sent it."""
        boxes = self.arrows, self.slow_hits, self.sound, self.separating, self.questions.box
        sent = [(setting.slider, "value") for setting in (self.speed, self.lifted, *self.angles)]
        sent += [(menu, "selected") for menu in (self.collisions, self.span, self.questions.menu)]
        for widget, name in [*sent, *((box, "checked") for box in boxes)]:
            setattr(widget, name, getattr(widget, name))

    def show_error(self, message) -> None:
        """Show this message above everything else; an empty message removes it."""
        change(self.error, text=f'<div class="error" role="alert">{escape(message)}</div>' if message else "")

    def show_end(self, words) -> None:
        """Show that the program has ended, and why; nothing on the page moves any more."""
        text = f"<strong>The program has ended.</strong> {escape(words)}"
        change(self.error, text=f'<div class="error ended" role="alert">{text}</div>')

    def show_settings(self, running, speed, angles, lifted, count, collision) -> None:
        """Show whether the cradle runs, its speed (times real time), its release angles (rad), the number of lifted
        bobs out of count, and the kind of its collisions.
        """
        self.count = count
        change(self.pause, text="Pause" if running else "Run")
        for widget in (self.step, self.table.tick):
            change(widget, disabled=running)
        self.speed.show(speed, f"{speed:.1f}x")
        for setting, angle in zip(self.angles, angles, strict=True):
            lift = to_lift(angle)
            setting.show(lift, f"{lift:.4g}&deg;")
        bobs = f'<span data-lifted="{lifted}" data-count="{count}">{lifted} of {count}</span>'
        self.lifted.show(lifted / count, bobs)
        change(self.collisions, selected=collision)

    def show_motion(self, time, energy, momentum, remark) -> None:
        """Show the time (s), the energy (%), the momentum (kg m/s), and a remark about the speed."""
        percent = "&gt; 999 %" if energy >= 1000 else f"{energy:.2f} %"
        rows = {"t": f"{time:.2f} s {remark}", "energy": percent, "momentum": momentum_cell(momentum)}
        lines = [f'<tr><th scope="row">{name}</th><td>{cell}</td></tr>' for name, cell in rows.items()]
        change(self.readout, text=f'<table class="readout">{"".join(lines)}</table>')

    def show_graphs(self, choices, choice) -> None:
        """Show these choices of graphs (by their names) in the menu, and the present one with the names of its axes."""
        change(self.graph, choices=list(choices), selected=choice)
        # The page gets new choices after what is selected, and then selects the first one. panel.js mends this.
        axes = "".join(f'<span class="axis">{name}</span>' for name in choices[choice][:2])
        change(self.chosen, text=f'<i class="chosen" data-name="{choice}"></i>{axes}')

    def show_impacts(self, lines) -> None:
        """Show the last trains of impacts, a line for each."""
        change(self.impacts, text='<pre class="impacts">' + "\n".join(["Impacts", *lines]) + "</pre>")


def momentum_cell(momentum) -> str:
    """Return the momentum (kg m/s) as text, with an arrow in its direction."""
    moving = f"{round(momentum, 3) + 0.0:+.3f}" if abs(momentum) < 1e4 else f"{momentum:+.2e}"
    arrow = "" if abs(momentum) < 0.0005 else " &rarr;" if momentum > 0 else " &larr;"
    return f"{moving} kg m/s{arrow}"


# --- parts of the panel: sections, rows, labels, hints, and sliders with a name and a value ---------------------------


def begin_part(name, fold="") -> None:
    """Begin a new part of the panel; panel.js and panel.css know its name. With the title fold, it is folded away."""
    wtext(text=f'<i class="part" data-name="{name}" data-fold="{escape(fold)}"></i>')


def add_label(text) -> None:
    """Add the name of the next widget."""
    wtext(text=f'<span class="label">{text}</span>')


def add_hint(text) -> None:
    """Add a short explanation, and end the row."""
    wtext(text=f'<span class="hint">{text}</span>')
    end_row()


def end_row() -> None:
    """Begin a new row of widgets."""
    wtext(text='<i class="row"></i>')


def change(widget, **attributes) -> None:
    """Set those attributes of a widget that differ: you may be about to copy its text, and all is sent to the page."""
    for name, value in attributes.items():
        if getattr(widget, name) != value:
            setattr(widget, name, value)


class Setting:
    """A slider, with its name before it, and its value and unit behind it."""

    def __init__(self, name, lowest, highest, step, bind):
        """Make the slider; when you move it, it calls bind(value)."""
        add_label(name)
        self.slider = slider(min=lowest, max=highest, step=step, length=170, bind=lambda slider: bind(slider.value))
        self.text = wtext()

    def show(self, value, text) -> None:
        """Move the slider to value, and show its text."""
        change(self.slider, value=value)
        change(self.text, text=f'<span class="value">{text}</span>')
