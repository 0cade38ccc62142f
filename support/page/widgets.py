"""Parts of the panel: sections, rows, labels, hints, and sliders with a name and a value."""

from html import escape

from vpython import slider, wtext


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


def set_text(widget, text) -> None:
    """Set the text of a widget only if it has changed: you may be about to copy it."""
    if widget.text != text:
        widget.text = text


class Setting:
    """A slider, with its name before it, and its value and unit behind it."""

    def __init__(self, name, lowest, highest, step, bind):
        """Make the slider; when you move it, it calls bind(value)."""
        add_label(name)
        self.slider = slider(min=lowest, max=highest, step=step, length=170, bind=lambda slider: bind(slider.value))
        self.text = wtext()

    def show(self, value, text) -> None:
        """Move the slider to value, and show its text."""
        if self.slider.value != value:
            self.slider.value = value
        set_text(self.text, f'<span class="value">{text}</span>')
