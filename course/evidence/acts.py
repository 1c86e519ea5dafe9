"""What a learner did while a mystery was played, as its nodes saw it."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from course.model.events import Acted, Event, OutputLine

# The name that a mystery's nodes have in the arena, where they print acts as lines of JSON.
MYSTERY = "mystery"


@dataclass(frozen=True)
class Act:
    """Something the learner did. name: chosen by the mystery's author. detail: what was seen of it."""

    name: str
    detail: str = ""


def acts_of(events: Iterable[Event]) -> tuple[Act, ...]:
    """Acts kept in the course home, then those seen in the arena; each once."""
    return tuple(dict.fromkeys(_acts(events)))


def _acts(events: Iterable[Event]) -> Iterator[Act]:
    for event in events:
        if isinstance(event, Acted):
            yield Act(event.name, event.detail)
        elif isinstance(event, OutputLine) and event.process == MYSTERY and event.text.startswith('{"act"'):
            yield Act(**json.loads(event.text)["act"])
