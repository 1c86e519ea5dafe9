"""What is expected of a node that logs what it is sent.

The scenario sends one message after the other and waits for each to be logged, so what the
node logs between two sendings belongs to the first of them, however many lines it takes.
"""

from __future__ import annotations

from course.errors import OurFault
from course.evidence.recording import Recording
from course.evidence.topic_view import Message
from course.feedback import Failure, Feedback
from course.grading.explain.python_code import calls, text_places


def expect_deliveries(recording: Recording, process: str, sent: tuple[Message, ...]) -> None:
    """The node logs something for each message, before the next one is sent.

    Raises OurFault when nothing was sent: then nothing can be said of the node.
    """
    if not sent:
        raise OurFault(f"the scenario sent nothing to {process}")
    silent = [message for message, text in _portions(recording, sent) if not text]
    if not silent:
        return
    if recording.log:
        raise Failure(_some_missing(recording, sent, len(silent)))
    printed = [line.text for line in recording.process(process).lines if line.t > sent[0].t]
    raise Failure(_printed(recording, printed) if printed else _silent(recording, len(sent)))


def expect_contents(
    recording: Recording, sent: tuple[Message, ...], fields: tuple[str, ...], *, once: str
) -> None:
    """The log holds these fields of each message after it was sent, and the field `once` just once."""
    for message, text in _portions(recording, sent):
        for field in fields:
            if str(getattr(message.data, field)) not in text:
                raise Failure(_field_missing(recording, sent, message, text, field))
    whole = "\n".join(line.text for line in recording.log)
    for message in sent:
        value = str(getattr(message.data, once))
        if value and whole.count(value) > 1:
            raise Failure(
                Feedback(
                    summary=f"The same {once} is logged {whole.count(value)} times, not once.",
                    expected="one log message for each message received",
                    seen=f"{whole.count(value)} for the message with id {message.data.id}",
                    where=tuple(call.where for call in calls(recording.sources, "info"))[:2],
                    advice="Log it once in the callback, and make only one subscription.",
                )
            )


def _portions(recording: Recording, sent: tuple[Message, ...]) -> list[tuple[Message, str]]:
    """Each message with what was logged from its sending to that of the next."""
    ends = (*(message.t for message in sent[1:]), float("inf"))
    return [
        (message, "\n".join(line.text for line in recording.log if message.t <= line.t < end))
        for message, end in zip(sent, ends, strict=True)
    ]


def _some_missing(recording: Recording, sent: tuple[Message, ...], silent: int) -> Feedback:
    sleeps = calls(recording.sources, "sleep")
    return Feedback(
        summary=f"The node does not log each message: {silent} of {len(sent)} are not in its log.",
        expected=f"{len(sent)} messages logged",
        seen=f"{len(sent) - silent} logged",
        where=tuple(call.where for call in sleeps)[:1]
        or tuple(call.where for call in calls(recording.sources, "info"))[:1],
        advice="While a callback sleeps, all others wait: take the `sleep` out."
        if sleeps
        else "Log each time the callback is called: no `if` around it, and no `return` before it.",
    )


def _printed(recording: Recording, printed: list[str]) -> Feedback:
    return Feedback(
        summary="The messages are shown by `print`: they are on the terminal, but not in the node's log.",
        expected="a message in the node's log",
        seen=f"on the terminal only: {printed[0][:120]}",
        where=tuple(call.where for call in calls(recording.sources, "print"))[:2],
        advice="Use the node's logger in place of `print`: `self.get_logger().info(...)`.",
    )


def _silent(recording: Recording, count: int) -> Feedback:
    return Feedback(
        summary=f"{count} messages were sent, and the node logged nothing.",
        expected="a log message for each",
        where=tuple(call.where for call in calls(recording.sources, "create_subscription"))[:1],
        advice="Log in the callback of the subscription: `self.get_logger().info(...)`.",
    )


def _field_missing(
    recording: Recording, sent: tuple[Message, ...], message: Message, text: str, field: str
) -> Feedback:
    value = getattr(message.data, field)
    shown = text.splitlines()[0][:120] if text else "nothing"
    if "{" in text:
        advice = "The braces were logged as they are: put an `f` before the string, `f'...'`."
    elif message is not sent[0] and str(getattr(sent[0].data, field)) in text:
        advice = "The first message is logged again: use the one that the callback gets this time."
    else:
        advice = f"Log `{field}` of the message that the callback gets: `f'{{message.{field}}}'`."
    return Feedback(
        summary=f"The log does not hold the `{field}` of a message that was sent.",
        expected=_cut(str(value)) if value != "" else "an empty text",
        seen=shown,
        where=text_places(recording.sources, "get_logger().info(")[:2],
        advice=advice,
    )


def _cut(text: str) -> str:
    return text if len(text) <= 80 else f"{text[:60]}... ({len(text)} letters)"
