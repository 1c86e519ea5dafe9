"""Expectations of a node that publishes what its parameters say."""

from __future__ import annotations

from collections.abc import Mapping

from course.api import (
    Failure,
    Feedback,
    Location,
    Message,
    OurFault,
    Recording,
    Sources,
    TopicView,
    calls,
    expect_period,
    named,
    read_once,
    seconds,
    text_places,
    timer_places,
)

_DECLARING = ("declare_parameter", "declare_parameters")


def expect_period_kept(
    recording: Recording, topic: TopicView, period: float, *, parameter: str, value: float
) -> None:
    """Expect that messages arrived at the same rate after `parameter` was set to `value`."""
    try:
        expect_period(topic, period, what="messages")
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
    """Expect the texts of the parameters in the message's fields of the same names."""
    for name, text in wanted.items():
        seen = str(getattr(message.data, name))
        if seen != text:
            exchanged = seen in wanted.values()
            raise Failure(
                Feedback(
                    summary=f"A message's `{name}` does not match the parameter `{name}`.",
                    expected=text,
                    seen=seen[:120] or "an empty string",
                    where=_filling(recording, name),
                    advice="The two are swapped: give each field the parameter with the same name."
                    if exchanged
                    else f"Fill it from there: `message.{name} = self.get_parameter('{name}').value`.",
                )
            )


def expect_followed(recording: Recording, node: str, topic: str, name: str) -> None:
    """Expect the new value in the field of the parameter's name, in messages sent after the scenario set it.

    The first message may have been on its way when the node answered, so it may still contain the old value.
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
    """Lines that name this parameter, except those that declare it."""
    declaring = {call.where for maker in _DECLARING for call in calls(sources, maker)}
    return tuple(place for place in named(sources, name) if place not in declaring)


def _filling(recording: Recording, name: str) -> tuple[Location, ...]:
    places = text_places(recording.sources, f".{name} =")
    return places[:2] or tuple(call.where for call in calls(recording.sources, "publish"))[:1]


def _no_more(recording: Recording, name: str, count: int) -> Feedback:
    return Feedback(
        summary=f"After `{name}` was set, no more messages came.",
        expected="a message with the new value",
        seen=f"{count} messages",
        where=timer_places(recording.sources)[:2],
        advice="Does something stop the timer, or the node, when the parameter changes? Remove it.",
    )


def _still_old(recording: Recording, name: str, wanted: str, seen: str) -> Feedback:
    cause = read_once(recording.sources, name)
    return Feedback(
        summary=f"`{name}` was changed while the node ran, but its messages stayed the same.",
        expected=wanted,
        seen=seen[:120] or "an empty string",
        where=(cause.where if cause else ()) or reading(recording.sources, name)[:2],
        advice=cause.text
        if cause
        else f"Read it in the timer's callback, each time: `self.get_parameter('{name}').value`.",
    )
