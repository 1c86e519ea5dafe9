"""What is expected of Python code that a probe of ours has called."""

from __future__ import annotations

import re
from typing import Any

from course.errors import OurFault
from course.evidence.probe_view import Answer
from course.evidence.recording import Recording
from course.feedback import Failure, Feedback, Location

_LAST_LINES = 6
_FOLDERS = re.compile(r" \(/[^)]*\)")  # where an import was looked for: a copy of ours
_ADVICE = (
    (("SyntaxError",), "Python cannot read the file. Look at this line, and at the end of the one before."),
    (("IndentationError",), "Check the spaces at the beginning of this line: four for each level."),
    (("takes", "positional argument"), "Does each method name `self` as its first argument?"),
    (("unexpected keyword argument",), "The names of the arguments must be those of the task: compare them."),
    (("missing", "argument"), "Give the argument a default value, `name=value`: a call may omit it then."),
    (("has no attribute",), "Is the name spelt as in the task, and is it set in `__init__` with `self.`?"),
    (("SystemExit",), "An import must not end the program: take the `exit` out, or put it into a function."),
)


def expect_importable(recording: Recording, what: str, name: str = "probe") -> None:
    """The probe could import the learner's code, and came to its end.

    what: what it imported, as a beginner types it (`from minimalist_package import MinimalistClass`).
    """
    lost = recording.missing_program(name)
    if lost:
        raise Failure(_no_folder(recording, lost.file))
    probe = recording.probe(name)
    if not probe.ran:
        raise OurFault(f"the scenario ran no probe named {name}")
    if probe.broken:
        raise Failure(trouble(probe.broken, f"`{what}` fails"))
    if not probe.finished and not probe.answers:
        raise Failure(_hangs(recording, what, name))


def answered(
    recording: Recording, question: str, what: str, name: str = "probe", *, where: Location | None = None
) -> Answer:
    """The answer to a question, which must be no exception.

    what: the call as a beginner types it (`MinimalistClass()`), for the words. where: the place to look
    at when the exception names no line of the learner's.
    """
    probe = recording.probe(name)
    answer = probe.answer(question)
    if answer is None and probe.broken:
        raise Failure(trouble(probe.broken, f"`{what}` could not be tried"))
    if answer is None:
        raise Failure(_hangs(recording, what, name))
    if answer.error is not None:
        raise Failure(trouble(answer, f"`{what}` fails", where))
    return answer


def expect_answer(
    recording: Recording,
    question: str,
    wanted: Any,
    what: str,
    *,
    advice: str,
    where: Location | None = None,
    name: str = "probe",
) -> None:
    """The question was answered with just this value (1 and 1.0 are the same, True is neither)."""
    seen = answered(recording, question, what, name, where=where)
    if seen.value == wanted and isinstance(seen.value, bool) == isinstance(wanted, bool):
        return
    raise Failure(
        Feedback(
            summary=f"`{what}` gives {_shown(seen)}, not {wanted!r}.",
            expected=repr(wanted),
            seen=_shown(seen),
            where=(where,) if where else (),
            advice=advice,
        )
    )


def _shown(answer: Answer) -> str:
    plain = answer.value is None or isinstance(answer.value, str | int | float | list | dict)
    return repr(answer.value) if plain and answer.type != "object" else str(answer.value)


def trouble(answer: Answer, summary: str, where: Location | None = None) -> Feedback:
    """An exception of the learner's code, with the line of theirs that led to it, else `where`."""
    place = Location(answer.file, answer.line) if answer.file else where
    error = answer.error or ""
    advice = next((text for words, text in _ADVICE if all(word in error for word in words)), None)
    otherwise = (
        "Look at the line named here: it is the one of yours that led to the error."
        if place
        else "Are all names in it spelt as in the task, and is each defined in its file?"
    )
    return Feedback(
        summary=f"{summary}: {_FOLDERS.sub('', error)}",
        where=(place,) if place else (),
        advice=advice or otherwise,
    )


def _hangs(recording: Recording, what: str, name: str) -> Feedback:
    return Feedback(
        summary=f"`{what}` does not come to an end.",
        advice="Look for a loop without end or an `input()`, perhaps outside of any function: that runs "
        "when the file is imported. Put it into a function.",
        details=recording.process(name).text[-_LAST_LINES:],
    )


def _no_folder(recording: Recording, folder: str) -> Feedback:
    near = recording.home.near_folder(folder)
    return Feedback(
        summary=f"There is no folder `~/{folder}`" + (f"; there is `~/{near}`." if near else "."),
        where=(Location(near),) if near else (),
        advice=f"`mkdir -p ~/{folder}` makes it, with the folders above it.",
    )
