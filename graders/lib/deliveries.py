"""Expectations of a node that logs the messages that it receives.

The scenario sends one message after the other and waits for each to be logged. So what the
node logs between two messages belongs to the first of them, however many lines it logs.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable
from math import inf

from course.api import (
    Cause,
    Failure,
    Feedback,
    Location,
    Message,
    OurFault,
    Recording,
    calls,
    cause_of_silence,
    slips,
    text_places,
    trees,
)

# The file of rclpy through which every callback is called.
_EXECUTOR = "rclpy/executors.py"
LOGS = ("debug", "info", "warn", "warning", "error", "fatal")


def expect_deliveries(recording: Recording, process: str, topic: str) -> None:
    """Expect that the node logs something after each message on `topic`, before the next one is sent.

    Raises OurFault if nothing was sent, because that says nothing about the node.
    """
    reactions = recording.reactions(topic)
    if not reactions:
        raise OurFault(f"the scenario sent nothing to {process}")
    silent = [one for one in reactions if not one.logged]
    if not silent:
        return
    if recording.log:
        raise Failure(_some_missing(recording, len(reactions), len(silent)))
    printed = [text for one in reactions for text in one.printed(process)]
    raise Failure(_printed(recording, printed) if printed else _silent(recording, process, len(reactions)))


def expect_contents(recording: Recording, topic: str, fields: tuple[str, ...], *, once: str) -> None:
    """Expect these fields of each message in the log after it was sent, and the field `once` exactly once."""
    sent = recording.sent(topic)
    for reaction in recording.reactions(topic):
        for field in fields:
            if str(getattr(reaction.to.data, field)) not in reaction.logged:
                raise Failure(_field_missing(recording, sent, reaction.to, reaction.logged, field))
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
                    advice="Log it once in the callback, and create only one subscription.",
                )
            )


def _some_missing(recording: Recording, sent: int, silent: int) -> Feedback:
    sleeps = calls(recording.sources, "sleep")
    lost = slips.taken_away(recording.sources) or logged_sometimes(recording)
    return Feedback(
        summary=f"The node does not log each message: {silent} of {sent} are not in its log.",
        expected=f"{sent} messages logged",
        seen=f"{sent - silent} logged",
        where=(lost.where if lost else tuple(call.where for call in sleeps)[:1])
        or tuple(call.where for call in calls(recording.sources, "info"))[:1],
        advice=lost.text
        if lost
        else "While a callback sleeps, all others wait: remove the `sleep`."
        if sleeps
        else "Log each time the callback is called: no `if` around it, and no `return` before it.",
    )


def logged_sometimes(recording: Recording) -> Cause | None:
    """An `if` around the line that logs."""
    for file, tree in trees(recording.sources):
        for branch in (node for node in ast.walk(tree) if isinstance(node, ast.If)):
            if any(isinstance(part, ast.Attribute) and part.attr in LOGS for part in ast.walk(branch)):
                text = f"The node only logs if `{ast.unparse(branch.test)}`. Log each message that arrives."
                return Cause(text, (Location(file, branch.lineno),))
    return None


def _printed(recording: Recording, printed: list[str]) -> Feedback:
    return Feedback(
        summary="The messages are shown by `print`: they are in the terminal, but not in the node's log.",
        expected="a message in the node's log",
        seen=f"only in the terminal: {printed[0][:120]}",
        where=tuple(call.where for call in calls(recording.sources, "print"))[:2],
        advice="Use the node's logger instead of `print`: `self.get_logger().info(...)`.",
    )


def _silent(recording: Recording, process: str, count: int) -> Feedback:
    where = tuple(call.where for call in calls(recording.sources, "create_subscription"))[:1]
    if any(calls(recording.sources, name) for name in LOGS):
        look_at = "is this the right topic, and does the callback reach the line that logs?"
        cause = cause_of_silence(recording, process, slips.logged_seldom, look_at=look_at)
    else:
        cause = Cause("Log in the callback of the subscription: `self.get_logger().info(...)`.", where)
    return Feedback(
        summary=f"{count} messages were sent, and the node logged nothing.",
        expected="a log message for each",
        where=cause.where or where,
        advice=cause.text,
    )


def _field_missing(
    recording: Recording, sent: tuple[Message, ...], message: Message, text: str, field: str
) -> Feedback:
    value = getattr(message.data, field)
    shown = text.splitlines()[0][:120] if text else "nothing"
    if "{" in text:
        advice = "The braces were logged as is. Put an `f` before the string: `f'...'`."
    elif message is not sent[0] and str(getattr(sent[0].data, field)) in text:
        advice = "The first message is logged again: use the one that the callback gets this time."
    else:
        advice = f"Log `{field}` of the message that the callback gets: `f'{{message.{field}}}'`."
    return Feedback(
        summary=f"The log does not contain the `{field}` of a message that was sent.",
        expected=_cut(str(value)) if value != "" else "an empty string",
        seen=shown,
        where=text_places(recording.sources, "get_logger().info(")[:2],
        advice=advice,
    )


def _cut(text: str) -> str:
    return text if len(text) <= 80 else f"{text[:60]}... ({len(text)} letters)"


def first_reaction(recording: Recording, process: str, sent: Iterable[float]) -> float:
    """When the first of these was sent, if the program did anything after that; otherwise infinity.

    sent: times (s) of messages or calls. A node that never spins may also end, by itself or by an
    exception, but not because of a message.
    """
    traceback = recording.process(process).traceback()
    if traceback and not any(_EXECUTOR in line for line in traceback):
        return inf
    first = min(sent, default=inf)
    shown = (line.t for line in recording.process(process).lines)
    logged = (line.t for line in recording.log)
    return first if any(t >= first for t in (*shown, *logged)) else inf
