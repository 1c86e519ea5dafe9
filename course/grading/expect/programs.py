"""What is expected of a program: that it starts, keeps running, and ends on Ctrl+C."""

from __future__ import annotations

import signal
from math import inf

from course.errors import OurFault
from course.evidence.events import ProcessExited
from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.evidence.topic_view import seconds
from course.feedback import Failure, Feedback
from course.grading.expect.files import expect_file
from course.grading.explain.executables import no_executable
from course.grading.explain.languages import language_of

INTERRUPT_GRACE = 3.0
_QUIET_EXITS = (0, 1, 128 + signal.SIGINT)
_LAST_LINES = 6


def expect_executable(recording: Recording, process: str) -> None:
    """The executable that the scenario was to run is installed (a script: is there), and was started.

    Raises OurFault when the scenario never came to it: then nothing can be said of the program.
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
    """The program started and ran until the scenario ended it, or at least to the time `until` (s)."""
    expect_executable(recording, process)
    view = recording.process(process)
    ended = view.ended_by_itself
    if ended is None or ended.t >= until:
        return
    found = language_of(recording.sources).stopped(recording, view)
    if found:
        raise Failure(found)
    early = _ended_early if recording.packages.built else _script_ended
    raise Failure(early(recording, view, ended))


def _script_ended(recording: Recording, view: ProcessView, ended: ProcessExited) -> Feedback:
    return Feedback(
        summary=f"The program ended by itself after {seconds(view.lifetime or 0.0)}; "
        "it should go on forever.",
        expected="it runs until Ctrl+C",
        seen=_how(ended),
        advice="A loop that never ends keeps it running: `while True:`. Is `main()` called at all?",
        details=view.text[-_LAST_LINES:],
    )


def _ended_early(recording: Recording, view: ProcessView, ended: ProcessExited) -> Feedback:
    language = language_of(recording.sources)
    cause = language.to_keep_running(recording.sources)
    return Feedback(
        summary=f"The program ended by itself after {seconds(view.lifetime or 0.0)}; "
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
    names = {number.value: number.name for number in signal.Signals}  # signals from 35 to 63 have none
    return f"ended by the signal {names.get(ended.signal, ended.signal)}"


def expect_clean_end(recording: Recording, process: str) -> None:
    """The program ran and ended by itself with exit code 0."""
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
            summary=f"`{process}` should end by itself with exit code 0.",
            expected="exit code 0",
            seen=_how(ended) if ended else "it still ran",
            advice=language.at_the_end if ended else language.comes_to_an_end,
            details=tuple(line.text for line in view.lines if line.t < asked)[-_LAST_LINES:],
        )
    )


def expect_clean_interrupt(recording: Recording, process: str) -> None:
    """Ctrl+C ended the program within 3 s, with no traceback."""
    expect_executable(recording, process)
    view = recording.process(process)
    asked = view.interrupted_at
    if asked is None:
        raise Failure(
            Feedback(
                summary="The program ended before Ctrl+C could be tried.",
                expected="it runs until Ctrl+C",
                advice="Start it yourself, and read what it says at its end.",
            )
        )
    ended = view.exited
    if ended is None or ended.signal == signal.SIGKILL:
        raise Failure(_deaf(recording))
    language = language_of(recording.sources)
    found = language.unhandled(recording, view, asked)
    if found:
        raise Failure(found)
    if ended.code is not None and ended.code not in _QUIET_EXITS:
        raise Failure(
            Feedback(
                summary=f"After Ctrl+C the program ended with exit code {ended.code}.",
                expected="exit code 0",
                seen=f"exit code {ended.code}",
                advice=language.after_ctrl_c,
                details=view.text[-_LAST_LINES:],
            )
        )


def _deaf(recording: Recording) -> Feedback:
    cause = language_of(recording.sources).deaf(recording.sources)
    return Feedback(
        summary=f"Ctrl+C does not end the program: it still ran {INTERRUPT_GRACE:.0f} s later.",
        expected="it ends soon after Ctrl+C",
        where=cause.where,
        advice=cause.text,
    )
