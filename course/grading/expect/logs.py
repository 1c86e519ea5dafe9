"""What is expected of a node's log."""

from __future__ import annotations

from math import inf

from course.evidence.recording import Recording
from course.evidence.topic_view import LogLine
from course.feedback import Failure, Feedback
from course.grading.explain.languages import language_of
from course.grading.explain.python_code import text_places

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
    language = language_of(recording.sources)
    return Feedback(
        summary=f"The message is logged at level {line.level}, not INFO.",
        expected=f"[INFO] {example}",
        seen=f"[{line.level}] {line.text}",
        where=language.logged_at(recording.sources, line.level)[:2],
        advice=f"Log it with `{language.log_info}`.",
    )


def _other_words(recording: Recording, line: LogLine, example: str) -> Feedback:
    advice = language_of(recording.sources).other_words(line.text)
    return Feedback(
        summary=f"The node logs other words: `{line.text[:120]}`.",
        expected=example,
        seen=line.text[:200],
        where=text_places(recording.sources, line.text[:20])[:1] if line.text.strip() else (),
        advice=advice or "Log exactly the words of the task, with its capitals and its full stop.",
    )


def _printed(recording: Recording, text: str) -> Feedback:
    language = language_of(recording.sources)
    name, places = language.printed(recording.sources)
    return Feedback(
        summary=f"The text comes from `{name}`: it is on the terminal, but not in the node's log.",
        expected="a message in the node's log",
        seen=f"on the terminal only: {text[:120]}",
        where=places[:_SHOWN],
        advice=f"Use the node's logger in place of `{name}`: `{language.log_info}`.",
    )


def _silent(recording: Recording, example: str) -> Feedback:
    language = language_of(recording.sources)
    debug = language.logged_at(recording.sources, "DEBUG")
    if debug:
        return Feedback(
            summary="The message is logged at level DEBUG, which ROS does not show.",
            expected=f"[INFO] {example}",
            where=debug[:1],
            advice=f"Log it at level INFO: `{language.log_info}`.",
        )
    cause = language.silent(recording.sources)
    return Feedback(
        summary="The node runs, but it logs nothing.",
        expected=example,
        seen="no message",
        where=cause.where if cause else (),
        advice=cause.text
        if cause
        else f"Check that something calls the callback, and that it comes to `{language.log_info}`.",
    )
