"""What is expected of a node that publishes what its parameters say."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from course.errors import OurFault
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.evidence.topic_view import Message, expect_period, seconds
from course.feedback import Failure, Feedback, Location
from course.grading.explain.parameters import named, read_once
from course.grading.explain.python_code import calls, text_places
from course.grading.explain.timers import timer_places

_DECLARING = ("declare_parameter", "declare_parameters")


def expect_pace(recording: Recording, times: tuple[float, ...], period: float, *, parameter: str) -> None:
    """Messages that came at `times` (s) come as often as the `parameter` says: every `period` seconds."""
    advice = f"Hand `create_timer` what the parameter says: `self.get_parameter('{parameter}').value`."
    try:
        expect_period(times, period, what="messages", advice=advice)
    except Failure as failure:
        where = timer_places(recording.sources)[:2]
        raise Failure(replace(failure.feedback, where=where)) from None


def expect_pace_kept(
    recording: Recording, times: tuple[float, ...], period: float, *, parameter: str, value: float
) -> None:
    """Messages came at `times` (s) as before, though `parameter` was set to `value` meanwhile."""
    try:
        expect_period(times, period, what="messages")
    except Failure as failure:
        said = failure.feedback.summary
        sources = recording.sources
        raise Failure(
            Feedback(
                summary=f"`{parameter}` was set to {value:g} while the node ran. {said}",
                expected=f"still one every {seconds(period)}",
                seen=failure.feedback.seen,
                where=(reading(sources, parameter) or timer_places(sources))[-1:],
                advice=f"Read `{parameter}` once, in `__init__`, for `create_timer`, and nowhere else.",
            )
        ) from None


def expect_texts(recording: Recording, message: Message, wanted: Mapping[str, str]) -> None:
    """The message's fields hold the texts of the parameters that are called as they are."""
    for name, text in wanted.items():
        seen = str(getattr(message.data, name))
        if seen != text:
            exchanged = seen in wanted.values()
            raise Failure(
                Feedback(
                    summary=f"A message's `{name}` is not what the parameter `{name}` says.",
                    expected=text,
                    seen=seen[:120] or "an empty string",
                    where=_filling(recording, name),
                    advice="The two are swapped: give each field the parameter of its own name."
                    if exchanged
                    else f"Fill it from there: `message.{name} = self.get_parameter('{name}').value`.",
                )
            )


def expect_followed(recording: Recording, node: str, topic: str, name: str) -> None:
    """Once the scenario had set the parameter, the field of its name in the messages holds the new value.

    One message may have been under way when the node's answer came, so that may hold the old one.
    """
    found = next((one for one in recording.parameters(node).sets if one.name == name), None)
    if found is None:
        raise OurFault(f"the scenario did not set the parameter {name} of {node}")
    since = found.answered or found.asked
    later = [message for message in recording.messages(topic) if message.t > since]
    old = [message for message in later[1:] if getattr(message.data, name) != found.value]
    if len(later) < 2:
        raise Failure(_no_more(recording, name, len(later)))
    if old:
        raise Failure(_still_old(recording, name, str(found.value), str(getattr(old[0].data, name))))


def reading(sources: Sources, name: str) -> tuple[Location, ...]:
    """Lines that name this parameter, but for those that declare it."""
    declaring = {call.where for maker in _DECLARING for call in calls(sources, maker)}
    return tuple(place for place in named(sources, name) if place not in declaring)


def _filling(recording: Recording, name: str) -> tuple[Location, ...]:
    places = text_places(recording.sources, f".{name} =")
    return places[:2] or tuple(call.where for call in calls(recording.sources, "publish"))[:1]


def _no_more(recording: Recording, name: str, count: int) -> Feedback:
    return Feedback(
        summary=f"Once `{name}` was set, no more messages came.",
        expected="a message with the new value",
        seen=f"{count} messages",
        where=timer_places(recording.sources)[:2],
        advice="Does something stop the timer, or the node, when the parameter changes? Take that out.",
    )


def _still_old(recording: Recording, name: str, wanted: str, seen: str) -> Feedback:
    cause = read_once(recording.sources, name)
    return Feedback(
        summary=f"`{name}` was changed while the node ran, and its messages do not show it.",
        expected=wanted,
        seen=seen[:120] or "an empty string",
        where=(cause.where if cause else ()) or reading(recording.sources, name)[:2],
        advice=cause.text
        if cause
        else f"Read it in the timer's callback, each time: `self.get_parameter('{name}').value`.",
    )
