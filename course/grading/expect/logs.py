"""Expectations about a node's log."""

from __future__ import annotations

import re
from collections import Counter
from difflib import SequenceMatcher
from math import inf

from course.evidence.recording import Recording
from course.evidence.topic_view import LogLine
from course.explain.callbacks import called_callback
from course.explain.engine import Cause
from course.explain.languages import language_of, timer_places
from course.explain.observed import unproven
from course.explain.python_code import text_places
from course.explain.python_slips import first, taken_away, uncalled
from course.grading.expect.one_program import of_program
from course.grading.expect.programs import cause_of_silence, proven_silence
from course.model.feedback import Failure, Feedback, Location

_SHOWN, _FEW = 3, 2
_EXACTLY = "Log exactly the words of the task, with the same capital letters and period."
# A line that is less similar than this is not just a misspelled version of the expected one.
_ALIKE = 0.6


def expect_logged(
    recording: Recording, process: str, lines: tuple[LogLine, ...], example: str, mark: str
) -> None:
    """Check that the node logs lines like `example` at level INFO; `lines` are those that were found.

    mark: a text in every such line, to recognize it if it was printed, or logged by another logger.
    """
    wrong_level = [line for line in lines if line.level != "INFO"]
    if wrong_level:
        raise Failure(_level(recording, wrong_level[0], example))
    if lines:
        return
    view = recording.process(process)
    before_the_end = (line.text for line in view.lines if line.t < (view.interrupted_at or inf))
    printed = [text for text in before_the_end if mark in text and text not in view.traceback()]
    if recording.log:
        raise Failure(_other_words(recording, process, example))
    if printed:
        raise Failure(_printed(recording, printed[0]))
    raise Failure(_silent(recording, process, example))


def _level(recording: Recording, line: LogLine, example: str) -> Feedback:
    language = language_of(recording.sources)
    return Feedback(
        summary=f"The message is logged at level {line.level}, not INFO.",
        expected=f"[INFO] {example}",
        seen=f"[{line.level}] {line.text}",
        where=language.logged_at(recording.sources, line.level)[:2],
        advice=f"Log it with `{language.log_info}`.",
    )


def _other_words(recording: Recording, process: str, example: str) -> Feedback:
    """Feedback on the line most similar to the expected one: a node may log other things, too."""

    def alike(one: LogLine) -> float:
        return SequenceMatcher(None, one.text[:200], example).ratio()

    line = max(recording.log, key=alike)
    cause = language_of(recording.sources).other_words(line.text, recording.sources)
    shapes = Counter(re.sub(r"\d", "", one.text) for one in recording.log)
    again = max(shapes.values()) > 1  # so a line is logged repeatedly, just in other words
    lost = None if cause or again or alike(line) >= _ALIKE else _lost(recording, process)
    if lost:
        return Feedback(
            summary=f"The node logs other things, but nothing like `{example}`.",
            expected=example,
            seen=line.text[:200],
            where=lost.where,
            advice=lost.text,
        )
    return Feedback(
        summary=f"The node logs different words: `{line.text[:120]}`.",
        expected=example,
        seen=line.text[:200],
        where=(cause.where if cause else ()) or _written(recording, line.text),
        advice=cause.text if cause else _EXACTLY,
    )


def _lost(recording: Recording, process: str) -> Cause:
    """Why the expected line is missing in a node that logs something quite different."""
    own = of_program(recording, process)
    cause = first(own.sources, called_callback, uncalled, taken_away)
    cause = cause or (None if len(recording.log) > _FEW else proven_silence(recording, process))
    look_at = "does the program reach the line that logs this, and does it log the words of the task?"
    return cause or unproven(own, look_at, timer_places(own.sources))


def _written(recording: Recording, text: str) -> tuple[Location, ...]:
    words = max(re.split(r"[-\d.]+", text), key=len).strip()[:20]  # code rarely contains the numbers
    files = recording.sources.files
    places = tuple(
        place
        for place in (text_places(recording.sources, words) if len(words) > _FEW else ())
        if not files[place.file].splitlines()[(place.line or 1) - 1].lstrip().startswith(("#", "//"))
    )
    return places if len(places) == 1 else ()


# How ROS prints a logged message in the terminal.
_BY_A_LOGGER = re.compile(r"\[[A-Z]+\] \[[\d.]+\] \[(?P<logger>[^\]]+)\]: ")


def _printed(recording: Recording, text: str) -> Feedback:
    language = language_of(recording.sources)
    other = _BY_A_LOGGER.match(text)
    if other:
        return Feedback(
            summary=f"The message comes from the logger `{other['logger']}`, which is not the node's own.",
            expected="a message in the node's log",
            seen=f"only in the terminal: {text[:120]}",
            where=_named_logger(recording, other["logger"]),
            advice=f"Only the node's own logger sends messages to `/rosout`. Use it: `{language.log_info}`.",
        )
    name, places = language.printed(recording.sources)
    return Feedback(
        summary=f"The text comes from `{name}`: it is in the terminal, but not in the node's log.",
        expected="a message in the node's log",
        seen=f"only in the terminal: {text[:120]}",
        where=places[:_SHOWN],
        advice=f"Use the node's logger instead of `{name}`: `{language.log_info}`.",
    )


def _named_logger(recording: Recording, name: str) -> tuple[Location, ...]:
    named = text_places(recording.sources, name)
    return tuple(place for place in text_places(recording.sources, "get_logger(") if place in named)[:1]


def _silent(recording: Recording, process: str, example: str) -> Feedback:
    language = language_of(recording.sources)
    debug = language.logged_at(recording.sources, "DEBUG")
    if debug:
        return Feedback(
            summary="The message is logged at level DEBUG, which ROS does not show.",
            expected=f"[INFO] {example}",
            where=debug[:1],
            advice=f"Log it at level INFO: `{language.log_info}`.",
        )
    look_at = f"does something call the callback, and does it reach `{language.log_info}`?"
    cause = cause_of_silence(recording, process, look_at=look_at)
    return Feedback(
        summary="The node runs, but it logs nothing.",
        expected=example,
        seen="no message",
        where=cause.where,
        advice=cause.text,
    )
