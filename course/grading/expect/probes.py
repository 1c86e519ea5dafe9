"""Expectations about Python code that one of our probes called."""

from __future__ import annotations

import re
from typing import Any

import msgspec

from course.errors import OurFault
from course.evidence.process_view import ProbeAnswer
from course.evidence.recording import Recording
from course.explain.engine import Evidence, Symptom, explain
from course.explain.python_errors import EXCEPTIONS, PROVEN, learners_file
from course.model.feedback import Failure, Feedback, Location

_LAST_LINES = 6
_FOLDERS = re.compile(r" \(/[^)]*\)")  # where Python looked for an import: in our copy
_ADVICE = (
    (("SyntaxError",), "Python cannot read the file. Check this line and the end of the line before it."),
    (("IndentationError",), "Check the spaces at the beginning of this line: use four for each level."),
    (("takes", "positional argument"), "Does each method name `self` as its first argument?"),
    (("unexpected keyword argument",), "The names of the arguments must match the task: compare them."),
    (("missing", "argument"), "Give the argument a default value, `name=value`: then a call may omit it."),
    (("module '", "has no attribute"), "Define it there, or import it in the package's `__init__.py`."),
    (("has no attribute",), "Is the name spelled as in the task, and is it set in `__init__` with `self.`?"),
    (("SystemExit",), "An import must not end the program: remove the `exit`, or put it in a function."),
)


def expect_importable(recording: Recording, what: str, name: str = "probe") -> None:
    """Check that the probe could import the learner's code, and that the import ended.

    what: the import as a beginner types it (`from lamps import Lamp`).
    """
    lost = recording.missing_program(name)
    if lost:
        raise Failure(_no_folder(recording, lost.file))
    probe = recording.probe(name)
    if not probe.ran:
        raise OurFault(f"the scenario ran no probe named {name}")
    if probe.broken:
        raise Failure(trouble(recording, probe.broken, f"`{what}` fails"))
    if not probe.finished and not probe.answers:
        raise Failure(_hangs(recording, what, name))


def answered(
    recording: Recording,
    question: str,
    what: str,
    name: str = "probe",
    *,
    where: Location | None = None,
    shape: Any = Any,
) -> ProbeAnswer:
    """Return the answer to a question. Raises Failure if it is an exception.

    what: the call as a beginner types it (`Lamp()`), for the feedback. where: the place to name if the
    exception names none of the learner's lines. shape: the type of the answer's value, such as
    `tuple[float, list[str]]`. The learner's code can send anything, so any other type is a Failure.
    """
    probe = recording.probe(name)
    answer = probe.answer(question)
    if answer is None and probe.broken:
        raise Failure(trouble(recording, probe.broken, f"`{what}` could not be tested"))
    if answer is None:
        raise Failure(_hangs(recording, what, name))
    if answer.error is not None:
        raise Failure(trouble(recording, answer, f"`{what}` fails", where))
    return of_shape(answer, what, shape, where)


def of_shape(answer: ProbeAnswer, what: str, shape: Any, where: Location | None = None) -> ProbeAnswer:
    """Return the answer. Raises Failure if its value is not of the type `shape`; see `answered`."""
    try:
        msgspec.convert(answer.value, Any if answer.error else shape)
    except msgspec.ValidationError:
        raise Failure(
            Feedback(
                summary=f"The program that tests `{what}` sends something unexpected.",
                seen=_shown(answer)[:120],
                where=(where,) if where else (),
                advice="Functions and classes should not change the program that uses them, or its files.",
            )
        ) from None
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
    """Check that the answer is exactly this value (1 and 1.0 are the same, True is neither)."""
    seen = answered(recording, question, what, name, where=where)
    if seen.value == wanted and isinstance(seen.value, bool) == isinstance(wanted, bool):
        return
    raise Failure(
        Feedback(
            summary=f"`{what}` returns {_shown(seen)}, not {wanted!r}.",
            expected=repr(wanted),
            seen=_shown(seen),
            where=(where,) if where else (),
            advice=advice,
        )
    )


def _shown(answer: ProbeAnswer) -> str:
    plain = answer.value is None or isinstance(answer.value, str | int | float | list | dict)
    return repr(answer.value) if plain and answer.type != "object" else str(answer.value)


def trouble(
    recording: Recording, answer: ProbeAnswer, summary: str, where: Location | None = None
) -> Feedback:
    """Feedback on an exception in the learner's code, at their line that led to it, else at `where`."""
    file = answer.file
    if file and file.startswith("/"):
        file = learners_file(file, recording.packages, recording.sources)
    place = Location(file, answer.line) if file else where
    error = answer.error or ""
    advice = next((text for words, text in _ADVICE if all(word in error for word in words)), None)
    evidence = Evidence(sources=recording.sources, packages=recording.packages)
    known = explain(PROVEN if advice else EXCEPTIONS[:-2], [Symptom(error, place)], evidence)
    otherwise = (
        "The error came from this line of your code: check the values that it uses."
        if place
        else "Are all its names spelled as in the task, and is each defined in its file?"
    )
    return Feedback(
        summary=f"{summary}: {_FOLDERS.sub('', error)}",
        where=known.where if known else (place,) if place else (),
        advice=known.remedy if known else advice or otherwise,
    )


def _hangs(recording: Recording, what: str, name: str) -> Feedback:
    return Feedback(
        summary=f"`{what}` never ends.",
        advice=(
            "Look for an endless loop or an `input()`, perhaps outside any function, where it runs "
            "on import. Put it in a function."
        ),
        details=recording.process(name).text[-_LAST_LINES:],
    )


def _no_folder(recording: Recording, folder: str) -> Feedback:
    near = recording.home.near_folder(folder)
    return Feedback(
        summary=f"There is no folder `~/{folder}`" + (f"; there is `~/{near}`." if near else "."),
        where=(Location(near),) if near else (),
        advice=f"`mkdir -p ~/{folder}` creates it, with the folders above it.",
    )
