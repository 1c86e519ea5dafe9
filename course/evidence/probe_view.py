"""What a probe of ours found out of the learner's code, as plain data."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from course.evidence.events import Event, Probed


@dataclass(frozen=True)
class Answer:
    """What one question of a probe brought; the question is "" for what ended the probe itself.

    value: plain JSON data; what is none is given as Python shows it (`repr`). type: the name of the
    value's type. error: the exception's own line, when one came; `file` (relative to the course home) and
    `line` are then the learner's line that led to it, None when no line of theirs took part.
    """

    question: str
    value: Any = None
    type: str = ""
    error: str | None = None
    file: str | None = None
    line: int | None = None


@dataclass(frozen=True)
class ProbeView:
    """A probe that the scenario ran. finished: False when it did not come to its end in time."""

    name: str
    ran: bool
    finished: bool
    answers: tuple[Answer, ...]

    @classmethod
    def of(cls, name: str, events: tuple[Event, ...]) -> ProbeView:
        probed = next((e for e in events if isinstance(e, Probed) and e.process == name), None)
        if probed is None:
            return cls(name, False, False, ())
        return cls(name, True, probed.finished, tuple(Answer(**json.loads(text)) for text in probed.answers))

    def answer(self, question: str) -> Answer | None:
        """The answer to this question; None when the probe did not come to ask it."""
        return next((answer for answer in self.answers if answer.question == question), None)

    @property
    def broken(self) -> Answer | None:
        """The exception that ended the probe: mostly that the learner's module cannot be imported."""
        return self.answer("")
