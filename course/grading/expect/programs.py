"""Expectations about a program: that it starts, keeps running, and ends on Ctrl+C."""

from __future__ import annotations

import re
import signal
from collections.abc import Callable
from math import inf

from course.errors import OurFault
from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.evidence.topic_view import seconds
from course.explain.engine import Cause
from course.explain.executables import no_executable
from course.explain.languages import language_of, timer_places
from course.explain.observed import unproven
from course.explain.python_slips import broken_loop, first, wrong_guard
from course.grading.expect.one_program import of_program
from course.grading.expect.text_files import expect_file
from course.model.events import ProcessExited
from course.model.feedback import DoubtfulFailure, Failure, Feedback

INTERRUPT_GRACE = 3.0
_QUIET_EXITS = (0, 1, 128 + signal.SIGINT)
_LAST_LINES = 6
_REPORT = re.compile(r"\[(?:ERROR|FATAL)\]")


def expect_executable(recording: Recording, process: str) -> None:
    """Check that the executable is installed (for a script: that the file exists) and was started.

    Raises OurFault if the scenario never tried to start it, because then it cannot be judged.
    """
    missing = recording.missing_executable(process)
    if missing:
        raise Failure(no_executable(missing, recording.packages, recording.sources))
    lost = recording.missing_program(process)
    if lost:
        expect_file(recording, lost.file)
    if recording.process(process).started is None:
        raise OurFault(f"the scenario did not run {process}")


def expect_running(recording: Recording, process: str, *, until: float = inf) -> None:
    """Check that the program ran until the scenario ended it, or at least until the time `until` (s)."""
    expect_executable(recording, process)
    view = recording.process(process)
    ended = view.ended_by_itself
    if ended is None or ended.t >= until:
        return
    found = language_of(recording.sources).stopped(recording, view)
    if found:
        raise Failure(found)
    early = _ended_early if recording.packages.built else _script_ended
    raise Failure(early(of_program(recording, process), view, ended))


def cause_of_silence(
    recording: Recording, process: str, *others: Callable[[Sources], Cause | None], look_at: str
) -> Cause:
    """Return why a running node does nothing by itself, if its output or its code proves it.

    others: functions that look for more causes in the code; they are tried first. look_at: questions for
    the learner if no cause is proven.
    """
    own = of_program(recording, process)
    found = first(own.sources, *others) or proven_silence(recording, process)
    return found or unproven(own, look_at, timer_places(own.sources))


def proven_silence(recording: Recording, process: str) -> Cause | None:
    own = of_program(recording, process)
    return language_of(own.sources).silent(own.sources)


def _script_ended(recording: Recording, view: ProcessView, ended: ProcessExited) -> Feedback:
    cause = wrong_guard(recording.sources) if not view.text else broken_loop(recording.sources)
    cause = cause or unproven(
        recording, "is `main()` called at all, and does a `while True:` loop keep it running?", ended=True
    )
    return Feedback(
        summary=f"The program ended on its own after {seconds(view.lifetime or 0.0)}; "
        "it should keep running.",
        expected="it runs until Ctrl+C",
        seen=_how(ended),
        where=cause.where,
        advice=cause.text,
        details=view.text[-_LAST_LINES:],
    )


def _ended_early(recording: Recording, view: ProcessView, ended: ProcessExited) -> Feedback:
    language = language_of(recording.sources)
    look_at = f"what did the program print last, and what could end `{language.spin}` after that?"
    reports = [text for text in view.text if _REPORT.search(text)]
    if reports and ended.code:
        look_at = f"what the program reports before it ends ({reports[-1][:160]})."
    cause = None if reports and ended.code else language.to_keep_running(recording)
    cause = cause or unproven(recording, look_at, ended=True)
    return Feedback(
        summary=f"The program ended on its own after {seconds(view.lifetime or 0.0)}; "
        f"`{language.spin}` should keep it running.",
        expected="it runs until Ctrl+C",
        seen=_how(ended),
        where=cause.where,
        advice=cause.text,
        details=view.text[-_LAST_LINES:],
    )


def _how(ended: ProcessExited) -> str:
    if ended.signal is None:
        return f"exit code {ended.code}"
    names = {number.value: number.name for number in signal.Signals}  # signals 35 to 63 have no names
    return f"ended by the signal {names.get(ended.signal, ended.signal)}"


def expect_clean_end(recording: Recording, process: str) -> None:
    """Check that the program ended by itself with exit code 0."""
    expect_executable(recording, process)
    view = recording.process(process)
    ended = view.ended_by_itself
    if ended and ended.code == 0:
        return
    language = language_of(recording.sources)
    found = language.stopped(recording, view) if ended else None
    if found:
        raise Failure(found)
    asked = view.interrupted_at or inf
    raise Failure(
        Feedback(
            summary=f"`{process}` should end on its own with exit code 0.",
            expected="exit code 0",
            seen=_how(ended) if ended else "it was still running",
            where=language.entry(of_program(recording, process).sources),
            advice=language.at_the_end if ended else language.comes_to_an_end,
            details=tuple(line.text for line in view.lines if line.t < asked)[-_LAST_LINES:],
        )
    )


def expect_clean_interrupt(recording: Recording, process: str) -> None:
    """Check that Ctrl+C ended the program within 3 s, without a traceback."""
    expect_executable(recording, process)
    view = recording.process(process)
    asked = view.interrupted_at
    if asked is None:
        raise Failure(
            Feedback(
                summary="The program ended before Ctrl+C could be tested.",
                expected="it runs until Ctrl+C",
                advice="Start it yourself, and read its last lines of output.",
            )
        )
    ended = view.exited
    if ended is None or ended.signal == signal.SIGKILL:
        feedback = _deaf(of_program(recording, process))
        # Once in about 2,500 tries, a correct node kept spinning inside ROS after Ctrl+C. We don't know why.
        raise Failure(feedback) if feedback.where else DoubtfulFailure(feedback)
    language = language_of(recording.sources)
    found = language.unhandled(of_program(recording, process), view, asked)
    if found:
        raise Failure(found)
    if ended.code is not None and ended.code not in _QUIET_EXITS:
        raise Failure(
            Feedback(
                summary=f"After Ctrl+C the program ended with exit code {ended.code}.",
                expected="exit code 0",
                seen=f"exit code {ended.code}",
                where=language.entry(of_program(recording, process).sources),
                advice=language.after_ctrl_c,
                details=view.text[-_LAST_LINES:],
            )
        )


def _deaf(recording: Recording) -> Feedback:
    cause = language_of(recording.sources).deaf(recording.sources)
    return Feedback(
        summary=f"Ctrl+C does not end the program: it was still running {INTERRUPT_GRACE:.0f} s later.",
        expected="it ends soon after Ctrl+C",
        where=cause.where,
        advice=cause.text,
    )
