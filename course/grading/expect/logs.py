"""What is expected of a node's log."""

from __future__ import annotations

from math import inf

from course.evidence.recording import Recording
from course.evidence.topic_view import LogLine
from course.feedback import Failure, Feedback
from course.grading.explain.python_code import calls, text_places
from course.grading.explain.spinning import never_spun
from course.grading.explain.timers import timer_cause

_SHOWN = 3


def expect_logged(
    recording: Recording, process: str, lines: tuple[LogLine, ...], example: str, mark: str
) -> None:
    """The node logs lines like `example` at level INFO; `lines` are those that were found.

    mark: a text that every such line holds, to recognise it where it went astray.
    """
    wrong_level = [line for line in lines if line.level != "INFO"]
    if wrong_level:
        raise Failure(_level(recording, wrong_level[0], example))
    if lines:
        return
    view = recording.process(process)
    before_the_end = (line.text for line in view.lines if line.t < (view.interrupted_at or inf))
    printed = [text for text in before_the_end if mark in text]
    if recording.log:
        raise Failure(_other_words(recording, recording.log[0], example))
    if printed:
        raise Failure(_printed(recording, printed[0]))
    raise Failure(_silent(recording, example))


def _level(recording: Recording, line: LogLine, example: str) -> Feedback:
    return Feedback(
        summary=f"The message is logged at level {line.level}, not INFO.",
        expected=f"[INFO] {example}",
        seen=f"[{line.level}] {line.text}",
        where=tuple(call.where for name in _methods(line.level) for call in calls(recording.sources, name))[
            :2
        ],
        advice="Log it with `self.get_logger().info(...)`.",
    )


def _methods(level: str) -> tuple[str, ...]:
    return ("warn", "warning") if level == "WARN" else (level.lower(),)


def _other_words(recording: Recording, line: LogLine, example: str) -> Feedback:
    braces = "{" in line.text
    advice = (
        "The braces were logged as they are: put an `f` before the string, `f'...'`, and "
        "Python fills them in."
        if braces
        else "Log exactly the words of the task, with its capitals and its full stop."
    )
    return Feedback(
        summary=f"The node logs other words: `{line.text[:120]}`.",
        expected=example,
        seen=line.text[:200],
        where=text_places(recording.sources, line.text[:20])[:1] if line.text.strip() else (),
        advice=advice,
    )


def _printed(recording: Recording, text: str) -> Feedback:
    return Feedback(
        summary="The text comes from `print`: it is on the terminal, but not in the node's log.",
        expected="a message in the node's log",
        seen=f"on the terminal only: {text[:120]}",
        where=tuple(call.where for call in calls(recording.sources, "print"))[:_SHOWN],
        advice="Use the node's logger in place of `print`: `self.get_logger().info(...)`.",
    )


def _silent(recording: Recording, example: str) -> Feedback:
    debug = calls(recording.sources, "debug")
    if debug:
        return Feedback(
            summary="The message is logged at level DEBUG, which ROS does not show.",
            expected=f"[INFO] {example}",
            where=(debug[0].where,),
            advice="Log it at level INFO: `self.get_logger().info(...)`.",
        )
    cause = timer_cause(recording.sources) or never_spun(recording.sources)
    return Feedback(
        summary="The node runs, but it logs nothing.",
        expected=example,
        seen="no message",
        where=cause.where if cause else (),
        advice=cause.text
        if cause
        else "Check that something calls the callback, and that it comes to `self.get_logger().info(...)`.",
    )
