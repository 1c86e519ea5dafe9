"""Calls of one service as checks see them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from course.evidence.events import Event, ServiceAnswered, ServiceCalled, Side
from course.evidence.messages import Decoder
from course.evidence.unreadable import decoded


@dataclass(frozen=True)
class ServiceCall:
    """One call: when it was asked and answered (s), and the fields of both halves as attributes.

    response, answered: None when no answer came.
    client: which of the arena's clients asked, or the learner's node; "" when that is not certain.
    """

    asked: float
    request: Any
    answered: float | None
    response: Any
    client: str

    @property
    def duration(self) -> float | None:
        """Seconds from the request to its answer; None without one."""
        return None if self.answered is None else self.answered - self.asked


@dataclass(frozen=True)
class ServiceView:
    """What happened on one service.

    calls: those that the arena made, to the learner's server. requests: those that reached the
    arena's own server. Both in the order in which they were asked.
    """

    name: str
    calls: tuple[ServiceCall, ...]
    requests: tuple[ServiceCall, ...]

    @classmethod
    def of(cls, name: str, events: tuple[Event, ...], decoder: Decoder) -> ServiceView:
        asked = [e for e in events if isinstance(e, ServiceCalled) and e.service == name]
        answers = {e.call: e for e in events if isinstance(e, ServiceAnswered) and e.service == name}

        def side(wanted: Side) -> tuple[ServiceCall, ...]:
            return tuple(_call(e, answers.get(e.call), decoder) for e in asked if e.side == wanted)

        return cls(name, side("client"), side("server"))

    @property
    def answered(self) -> tuple[ServiceCall, ...]:
        """The arena's calls that got an answer."""
        return tuple(call for call in self.calls if call.answered is not None)

    @property
    def unanswered(self) -> tuple[ServiceCall, ...]:
        """The arena's calls that got none."""
        return tuple(call for call in self.calls if call.answered is None)


def _call(asked: ServiceCalled, answer: ServiceAnswered | None, decoder: Decoder) -> ServiceCall:
    request = decoded(asked.service, f"{asked.type}_Request", asked.data, decoder)
    response = decoded(asked.service, f"{asked.type}_Response", answer.data, decoder) if answer else None
    return ServiceCall(asked.t, request, answer.t if answer else None, response, asked.client)
