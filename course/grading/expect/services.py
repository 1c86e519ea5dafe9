"""Expectations about services: that they are offered or used, have the right type, and answer calls."""

from __future__ import annotations

from course.errors import OurFault
from course.evidence.recording import Recording
from course.evidence.service_view import ServiceCall
from course.evidence.topic_view import seconds
from course.explain.callbacks import called_callback
from course.explain.languages import language_of
from course.explain.observed import unproven
from course.explain.parameter_causes import named
from course.explain.python_code import calls
from course.explain.service_causes import no_response, sleeping, spin_in_callback
from course.model.events import Side
from course.model.feedback import Failure, Feedback, Location
from course.model.graph import Service
from course.spelling import listed, nearest

_VERBS = {"server": "offers", "client": "calls"}
_MAKERS = {"server": "create_service", "client": "create_client"}


def expect_service(recording: Recording, side: Side, name: str, *, remedy: str) -> None:
    """Check that one of the learner's nodes offers (`server`) or uses (`client`) this service (full name)."""
    every = _of_side(recording, side)
    if any(service.name == name for service in every):
        return
    names = sorted({service.name for service in every})
    close = nearest(name, names)
    makers = _makers(recording, side)
    if close:
        raise Failure(
            Feedback(
                summary=f"The node {_VERBS[side]} the service `{close}`, not `{name}`.",
                expected=name,
                seen=close,
                where=_name_places(recording, close) or makers,
                advice=f"Spell the service's name exactly like this: `{name.lstrip('/')}`.",
            )
        )
    raise Failure(
        Feedback(
            summary=f"No node {_VERBS[side]} the service `{name}`.",
            expected=f"a {side} of {name}",
            seen=f"the node {_VERBS[side]} {listed(names, 'no service')}",
            where=makers or language_of(recording.sources).constructor(recording.sources),
            advice=remedy,
        )
    )


def expect_service_type(recording: Recording, side: Side, name: str, type_name: str) -> None:
    """Check that every server (or client) of the service has this type."""
    wrong = [s for s in _of_side(recording, side) if s.name == name and s.type != type_name]
    if not wrong:
        return
    package, _, short = type_name.split("/")
    raise Failure(
        Feedback(
            summary=f"The {side} of `{name}` has the type `{wrong[0].type}`, not `{type_name}`.",
            expected=type_name,
            seen=wrong[0].type,
            where=_makers(recording, side),
            advice=(
                f"Import it with `from {package}.srv import {short}`, and pass it first to `{_MAKERS[side]}`."
            ),
        )
    )


def expect_answers(recording: Recording, name: str, *, within: float = 1.0) -> tuple[ServiceCall, ...]:
    """Check that each of the arena's calls was answered within `within` seconds, and return the calls.

    Raises OurFault if the arena made no call, because then the server cannot be judged.
    """
    made = recording.service(name).calls
    if not made:
        raise OurFault(f"the scenario did not call {name}")
    silent = [call for call in made if call.answered is None]
    late = [call for call in made if call.duration is not None and call.duration > within]
    if silent:
        raise Failure(_silent(recording, name, made, len(silent)))
    if late:
        raise Failure(_late(recording, max(call.duration or 0.0 for call in late), within))
    return made


def _silent(recording: Recording, name: str, made: tuple[ServiceCall, ...], silent: int) -> Feedback:
    sources = recording.sources
    cause = (
        called_callback(sources) or no_response(sources) or sleeping(sources) or spin_in_callback(sources)
    ) or unproven(
        recording,
        "does `main()` reach `rclpy.spin(node)`, and does the callback reach `return response`?",
        _makers(recording, "server"),
    )
    count = "The call" if len(made) == 1 else f"{silent} of {len(made)} calls"
    return Feedback(
        summary=f"{count} to `{name}` got no answer.",
        expected="an answer to each call",
        seen=f"{len(made) - silent} answers",
        where=cause.where,
        advice=cause.text,
    )


def _late(recording: Recording, slowest: float, within: float) -> Feedback:
    cause = sleeping(recording.sources)
    return Feedback(
        summary=f"An answer took {seconds(slowest)}; a client must wait that long.",
        expected=f"an answer within {seconds(within)}",
        seen=seconds(slowest),
        where=cause.where if cause else (),
        advice=cause.text if cause else "Let the callback return immediately. Is there a long loop in it?",
    )


def _of_side(recording: Recording, side: Side) -> list[Service]:
    """The services that the learner's nodes offer (or use)."""
    services = recording.seen_graph().services
    if side == "client":
        return [service for service in services if service.clients]
    return [service for service in services if service.servers or service.request_hash]


def _makers(recording: Recording, side: Side) -> tuple[Location, ...]:
    return tuple(call.where for call in calls(recording.sources, _MAKERS[side]))[:2]


def _name_places(recording: Recording, name: str) -> tuple[Location, ...]:
    plain = name.lstrip("/")
    return (*named(recording.sources, plain), *named(recording.sources, f"/{plain}"))[:3]
