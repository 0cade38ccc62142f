"""Check what arrives at the page's websocket: VPython prints a traceback for what it does not expect.

A message of VPython's page is the text "trigger", or a list of events (glowcomm.html):

    {"widget": kind, "idx": number, "value": value}    you have used the widget with this number
    {"event": kind, "canvas": number, ...}             a key, the mouse, a new size, or a camera that you have moved
"""

import json

TRIGGER = b"trigger"  # asks for the changes, and has no events
SMALLEST, LARGEST = 1e-6, 1e9  # with numbers of these sizes, nothing divides by 0 or grows to infinity

KEY = ("key", "which", "alt", "ctrl", "shift")
MOUSE = ("pos", "ray", "press", "release", "which", "alt", "ctrl", "shift")
# The kinds of events of the canvas, with the names that each one needs.
NEEDED = {
    **{"update_canvas": (), "keydown": KEY, "resize": ("width", "height")},
    **dict.fromkeys(("mousedown", "mousemove", "mouseup"), MOUSE),
}


def known_events(data, objects) -> bytes:
    """Return this message with those of its events that the page sends; objects has VPython's objects by number."""
    if data == TRIGGER:
        return data
    events = read_json(data)
    if type(events) is not list:
        return TRIGGER
    return json.dumps([event for event in events if is_known(event, objects)]).encode()


def read_json(text):
    """Return the value that is written in text or bytes, or None if they are no JSON."""
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return None


def is_known(event, objects) -> bool:
    """Return whether the page sends such an event."""
    match event:
        case {"widget": str(kind), "idx": int(number), **rest}:
            widget = objects.get(number)
            return getattr(widget, "objName", None) == kind and has_value(kind, widget, rest)
        case {"event": str(kind), "canvas": int(number), **rest}:
            is_canvas = hasattr(objects.get(number), "handle_event")
            return is_canvas and kind in NEEDED and rest.keys() >= {*NEEDED[kind]} and has_numbers(rest)
    return False


def has_value(kind, widget, event) -> bool:
    """Return whether an event of this kind has a value that this widget can have."""
    match kind, event:
        case "slider", {"value": int(value) | float(value)}:
            return widget.min <= value <= widget.max
        case "menu", {"value": int(value)}:
            return 0 <= value < len(widget.choices)
        case ("checkbox", {"value": bool()}) | ("winput", {"text": str(), "value": None}):
            return True
    return kind == "button"


def has_numbers(event) -> bool:
    """Return whether all numbers, places, directions and names in this event of the canvas are such."""
    checks = {
        **dict.fromkeys(("pos", "center"), is_place),
        **dict.fromkeys(("ray", "forward", "up"), is_direction),
        **dict.fromkeys(("range", "width", "height"), is_size),
        **{"autoscale": lambda value: type(value) is bool, "key": lambda value: type(value) is str},
    }
    return all(check(event[name]) for name, check in checks.items() if name in event)


def is_number(value) -> bool:
    return type(value) in (int, float) and abs(value) < LARGEST


def is_size(value) -> bool:
    return is_number(value) and value > SMALLEST


def is_place(value) -> bool:
    return type(value) is list and len(value) == 3 and all(map(is_number, value))


def is_direction(value) -> bool:
    return is_place(value) and max(map(abs, value)) > SMALLEST
