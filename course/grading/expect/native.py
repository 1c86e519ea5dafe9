"""What is expected of C++ files that the scenario compiled, and of the programs that came of them."""

from __future__ import annotations

import signal
from dataclasses import replace

from course.arena.native_programs import compiling
from course.errors import OurFault
from course.evidence.probe_view import Answer
from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.feedback import Failure, Feedback, Location
from course.grading.expect.files import expect_file
from course.grading.explain.cpp_crashes import cpp_crash
from course.grading.explain.native import not_compiled, warned
from course.grading.explain.sanitizers import Trouble, trouble

_LAST_LINES = 6
_NO_END = "Look for a loop that never ends, or for something that waits to be typed."


def expect_compiled(recording: Recording, program: str) -> None:
    """The files of `program` (its name in `arena.compile`) could be compiled and linked."""
    lost = recording.missing_program(compiling(program))
    if lost:
        expect_file(recording, lost.file)
    view = recording.process(compiling(program))
    if view.started is None:
        raise OurFault(f"the scenario did not compile {program}")
    if view.exited is None or view.exited.signal == signal.SIGKILL:
        raise Failure(
            Feedback(
                summary="The compiler does not come to an end with your files.",
                advice="Look for a template or a macro that goes on without end, and take it out.",
            )
        )
    if view.exited.code != 0:
        raise Failure(not_compiled(recording, program))


def expect_no_warnings(recording: Recording, program: str) -> None:
    """The compiler had nothing to say of the learner's files, with all usual warnings."""
    found = warned(recording, program)
    if found:
        raise Failure(found)


def expect_sound(recording: Recording, process: str, *, code: int = 0) -> ProcessView:
    """The program ended by itself with this exit code, and no sanitizer complained. Returns its view."""
    view = recording.process(process)
    if view.started is None:
        raise OurFault(f"the scenario did not run {process}")
    found = trouble(view.text, recording.sources)
    if found:
        raise Failure(_troubled(found))
    ended = view.ended_by_itself
    if ended is None:
        raise Failure(_endless(view))
    if ended.code != code:
        raise Failure(_other_end(view, ended.code, code))
    return view


def native_answer(
    recording: Recording, question: str, what: str, process: str, *, where: Location | None = None
) -> Answer:
    """What a program answered to a question of `ask.hpp`; it may be an exception of the learner's.

    what: the call as a beginner types it, for the words. where: the place to look at when nothing names a
    better one.
    """
    answer = recording.probe(process).answer(question)
    if answer is not None:
        return answer
    view = recording.process(process)
    found = trouble(view.text, recording.sources)
    if found:
        raise Failure(_troubled(found, what, where))
    places = (where,) if where else ()
    if view.ended_by_itself is None:
        raise Failure(Feedback(summary=f"`{what}` does not come to an end.", where=places, advice=_NO_END))
    if crashed := cpp_crash(view.exited, view.text, recording.sources, f"With `{what}` the program stops"):
        raise Failure(replace(crashed, where=crashed.where or places))
    raise Failure(
        Feedback(
            summary=f"`{what}` ends the whole program.",
            where=places,
            advice="Take out `std::exit` and the like: a function returns, or throws.",
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
    return Feedback(
        summary="The program does not come to an end.", advice=_NO_END, details=view.text[-_LAST_LINES:]
    )


def _other_end(view: ProcessView, code: int | None, wanted: int) -> Feedback:
    return Feedback(
        summary=f"The program should end with exit code {wanted}.",
        expected=f"exit code {wanted}",
        seen="it was killed" if code is None else f"exit code {code}",
        advice="What `main` returns is the exit code: 0 says that all went well.",
        details=view.text[-_LAST_LINES:],
    )
