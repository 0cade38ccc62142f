"""The record of what VPython has sent to the page: one message with the result of all."""

from support.page.replay import Replay


def replay_of(*messages):
    replay = Replay()
    for message in messages:
        replay.add(message)
    return replay.message()


def test_without_messages_it_has_nothing():
    assert replay_of() == replay_of({}) == {"cmds": [], "attrs": []}


def test_objects_are_made_in_their_order():
    box, sphere = {"cmd": "box", "idx": 1, "size": [1, 1, 1]}, {"cmd": "sphere", "idx": 2}
    assert replay_of({"cmds": [box]}, {"cmds": [sphere]})["cmds"] == [box, sphere]


def test_of_an_attribute_only_the_last_value_counts():
    """Object 1 and object 12 have attributes of their own; a1... and b1... are different ones."""
    first = ["a12a1,2,3", "a1a0,0,0", "b12a5", "a12$a12a: text"]
    assert replay_of({"attrs": first}, {"attrs": ["a12a4,5,6"]})["attrs"] == [*first[1:], "a12a4,5,6"]


def test_the_last_value_comes_after_those_that_it_may_change():
    """To set the size of a shape changes its axis, and the other way round."""
    assert replay_of({"attrs": ["a1f1,0,0"]}, {"attrs": ["a1g2,1,1"]}, {"attrs": ["a1f3,0,0"]})["attrs"] == [
        *("a1g2,1,1", "a1f3,0,0"),
    ]


def test_a_method_is_called_once_with_each_value():
    keys, mouse = "m0Gkeydown", "m0Gmousedown"
    assert replay_of({"attrs": [keys, mouse]}, {"attrs": ["a0t1", keys]})["attrs"] == [mouse, "a0t1", keys]


def test_of_a_setting_of_the_canvas_only_the_last_value_counts():
    canvas, width, text = {"cmd": "canvas", "idx": 0}, {"width": 5, "idx": 0}, {"append_to_caption": "a", "idx": 0}
    slider = {"cmd": "slider", "idx": 3}
    messages = [{"cmds": [canvas, width, text]}, {"cmds": [{"range": 1, "idx": 0}, slider]}, {"cmds": [text]}]
    changed = {"cmds": [{"width": 7, "idx": 0}]}
    assert replay_of(*messages, changed)["cmds"] == [
        canvas,
        text,
        {"range": 1, "idx": 0},
        slider,
        text,
        *changed["cmds"],
    ]


def test_it_does_not_grow_with_the_time():
    replay = Replay()
    for number in range(10_000):
        replay.add({"cmds": [{"range": number, "idx": 0}], "attrs": [f"a1a{number},0,0", f"b7g{number},1"]})
    assert replay.message() == {"cmds": [{"range": 9999, "idx": 0}], "attrs": ["a1a9999,0,0", "b7g9999,1"]}
