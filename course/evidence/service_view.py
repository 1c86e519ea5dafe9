"""Calls of one service as checks see them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from course.evidence.messages import Decoder, decoded
from course.model.events import Event, ServiceAnswered, ServiceCalled, Side


@dataclass(frozen=True)
class ServiceCall:
    """One call: its times (s), and request and response with their fields as attributes.

    asked: when it was sent. response, answered: None if no answer came. client: which of the arena's
    clients asked, or the learner's node; "" if that is uncertain.
    """

    asked: float
    request: Any
    answered: float | None
    response: Any
    client: str

    @property
    def duration(self) -> float | None:
        """Seconds from request to answer; None if there was no answer."""
        return None if self.answered is None else self.answered - self.asked


@dataclass(frozen=True)
class ServiceView:
    """What happened on one service.

    calls: the arena's calls of the learner's server. requests: those that reached the arena's own server.
    Both are in the order in which they were sent.
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
        """The arena's calls that were answered."""
        return tuple(call for call in self.calls if call.answered is not None)


def _call(asked: ServiceCalled, answer: ServiceAnswered | None, decoder: Decoder) -> ServiceCall:
    request = decoded(asked.service, f"{asked.type}_Request", asked.data, decoder)
    response = decoded(asked.service, f"{asked.type}_Response", answer.data, decoder) if answer else None
    return ServiceCall(asked.t, request, answer.t if answer else None, response, asked.client)
