"""Expectations about C++ files that the scenario compiled, and about the resulting programs."""

from __future__ import annotations

import signal
from typing import Any

from course.arena.cpp_programs import compiling
from course.errors import OurFault
from course.evidence.process_view import ProbeAnswer, ProcessView
from course.evidence.recording import Recording
from course.explain.cpp_crashes import Trouble, cpp_crash, trouble
from course.explain.cpp_errors import not_made, warned
from course.grading.expect.probes import of_shape
from course.grading.expect.text_files import expect_file
from course.model import replace
from course.model.feedback import Failure, Feedback, Location

_LAST_LINES = 6
_NO_END = "Look for a loop that never ends, or for code that waits for input."


def expect_compiled(recording: Recording, program: str) -> None:
    """Check that the files of `program` (its name in `arena.cpp.compile`) compile and link."""
    lost = recording.missing_program(compiling(program))
    if lost:
        expect_file(recording, lost.file)
    view = recording.process(compiling(program))
    if view.started is None:
        raise OurFault(f"the scenario did not compile {program}")
    if view.exited is None or view.exited.signal == signal.SIGKILL:
        raise Failure(
            Feedback(
                summary="The compiler never finishes with your files.",
                advice="Look for a template or a macro that never ends, and remove it.",
            )
        )
    if view.exited.code != 0:
        raise Failure(not_made(recording, compiling(program)))


def expect_no_warnings(recording: Recording, program: str) -> None:
    """Check that the compiler, with all the usual warnings on, reports none in the learner's files."""
    found = warned(recording, compiling(program))
    if found:
        raise Failure(found)


def expect_sound(recording: Recording, process: str) -> ProcessView:
    """Check that the program ended by itself with exit code 0 and no sanitizer error. Returns its view."""
    view = recording.process(process)
    if view.started is None:
        raise OurFault(f"the scenario did not run {process}")
    found = trouble(view.text, recording.sources)
    if found:
        raise Failure(_troubled(found))
    ended = view.ended_by_itself
    if ended is None:
        raise Failure(_endless(view))
    if ended.code != 0:
        raise Failure(_other_end(view, ended.code))
    return view


def native_answer(
    recording: Recording,
    question: str,
    what: str,
    process: str,
    *,
    where: Location | None = None,
    shape: Any = Any,
) -> ProbeAnswer:
    """Return a program's answer to a question from `ask.hpp`; the answer may be an exception.

    what: the call as a beginner types it, for the feedback. where: the place to name if nothing points to a
    better one. shape: see `answered`.
    """
    answer = recording.probe(process).answer(question)
    if answer is not None:
        return of_shape(answer, what, shape, where)
    view = recording.process(process)
    found = trouble(view.text, recording.sources)
    if found:
        raise Failure(_troubled(found, what, where))
    places = (where,) if where else ()
    if view.ended_by_itself is None:
        raise Failure(Feedback(summary=f"`{what}` never ends.", where=places, advice=_NO_END))
    if crashed := cpp_crash(view.exited, view.text, recording.sources, f"With `{what}` the program stops"):
        raise Failure(replace(crashed, where=crashed.where or places))
    raise Failure(
        Feedback(
            summary=f"`{what}` ends the whole program.",
            where=places,
            advice="Remove `std::exit` and similar calls: a function should return or throw.",
            details=view.text[-_LAST_LINES:],
        )
    )


def _troubled(found: Trouble, what: str = "", where: Location | None = None) -> Feedback:
    place = found.where or where
    summary = f"With `{what}`: {found.summary[0].lower()}{found.summary[1:]}" if what else found.summary
    return Feedback(
        summary=summary, where=(place,) if place else (), advice=found.advice, details=found.details
    )


def _endless(view: ProcessView) -> Feedback:
    return Feedback(summary="The program never ends.", advice=_NO_END, details=view.text[-_LAST_LINES:])


def _other_end(view: ProcessView, code: int | None) -> Feedback:
    return Feedback(
        summary="The program should end with exit code 0.",
        expected="exit code 0",
        seen="it was killed" if code is None else f"exit code {code}",
        advice="The value that `main` returns is the exit code: 0 means success.",
        details=view.text[-_LAST_LINES:],
    )
