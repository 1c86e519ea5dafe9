"""Every kind of event goes through JSON and comes back as it was."""

from __future__ import annotations

import json

import pytest

from course.evidence import events as kinds
from course.evidence.event_json import from_dict, to_dict
from course.evidence.events import Event

from .conftest import EVENTS

# Those have a form of their own in the file.
MESSAGES = (kinds.MessageSeen, kinds.MessageSent)
PLAIN = [event for event in EVENTS if not isinstance(event, MESSAGES)]


def is_event(kind: object) -> bool:
    return isinstance(kind, type) and issubclass(kind, Event) and kind is not Event


def test_the_examples_hold_every_kind() -> None:
    every = {kind for kind in vars(kinds).values() if is_event(kind)}
    assert {type(event) for event in EVENTS} == every


@pytest.mark.parametrize("event", PLAIN, ids=lambda event: type(event).__name__)
def test_an_event_comes_back_as_it_was(event: Event) -> None:
    text = json.dumps(to_dict(event), allow_nan=False)  # as strict as other readers are
    back = from_dict(json.loads(text))
    assert back == event
    assert type(back) is type(event)
    assert hash(back) == hash(event)


@pytest.mark.parametrize(
    "data",
    [
        {},
        {"kind": "Unheard", "t": 1.0},
        {"kind": "Event", "t": 1.0},
        {"kind": "Marked"},
        {"kind": "Marked", "t": 1.0, "name": "x", "more": 1},
        {"kind": "GraphSeen", "t": 1.0},
        {"kind": "GraphSeen", "t": 1.0, "graph": {"nodes": []}},
    ],
)
def test_anything_else_is_refused(data: dict[str, object]) -> None:
    with pytest.raises((KeyError, TypeError)):
        from_dict(data)
